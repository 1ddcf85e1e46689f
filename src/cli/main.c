/* roughlight: finds the subcommand, parses its words, runs it, and turns its error into one line and an exit code. */
#include <stdio.h>
#include <string.h>

#include "base/simd.h"
#include "base/version.h"
#include "cli/command.h"
#include "cli/output.h"

extern const struct rl_command rl_command_info;
extern const struct rl_command rl_command_plan;
extern const struct rl_command rl_command_render;
extern const struct rl_command rl_command_integrate;
extern const struct rl_command rl_command_probe;
extern const struct rl_command rl_command_hard;
extern const struct rl_command rl_command_compare;
extern const struct rl_command rl_command_illuminance;
extern const struct rl_command rl_command_study;

static const struct rl_command *const commands[] = {
    &rl_command_info, &rl_command_plan,    &rl_command_render,      &rl_command_integrate, &rl_command_probe,
    &rl_command_hard, &rl_command_compare, &rl_command_illuminance, &rl_command_study,
};

enum { N_COMMANDS = sizeof commands / sizeof commands[0] };

static void print_help(void)
{
    printf("roughlight: what does an accurate highlight cost, and what can one afford to leave out?\n\n"
           "usage: roughlight COMMAND [ARGUMENTS]\n\ncommands:\n");
    for (size_t i = 0; i < N_COMMANDS; i++)
        printf("  %-11s %s\n", commands[i]->name, commands[i]->summary);
    printf("\n'roughlight COMMAND --help' explains a command, with examples.\n"
           "stdout is data, stderr is talk. Exit: 0 done, 1 a check failed, 2 bad usage or input, 3 some "
           "cases failed,\n"
           "130 interrupted.\n"
           "ROUGHLIGHT_BACKEND and ROUGHLIGHT_THREADS set the defaults of --backend and --threads;\n"
           "ROUGHLIGHT_SIMD=plain|avx2|avx512 lowers the instruction set of the CPU's inner loops;\n"
           "ROUGHLIGHT_DATA names the folder that holds shaders/ and plots/ where they are not found by "
           "themselves.\n");
}

static const struct rl_command *find(const char *name)
{
    for (size_t i = 0; i < N_COMMANDS; i++)
        if (strcmp(commands[i]->name, name) == 0)
            return commands[i];
    return NULL;
}

/* What was found may be anything, and is quoted in the message: one line stays one, and no terminal obeys it. */
static void make_printable(char *text)
{
    for (; *text; text++)
        if ((unsigned char)*text < 0x20 || *text == 0x7f)
            *text = '?';
}

/* Prints the message, if there is one, with the command that it comes from. */
static int conclude(const struct rl_command *command, const struct rl_verb *verb, int code,
                    struct rl_error *error)
{
    if (code == RL_EXIT_OK && rl_output_check(error) != RL_OK)
        code = RL_EXIT_USAGE;
    make_printable(error->message);
    if (code != RL_EXIT_OK && error->message[0] != '\0')
        fprintf(stderr, "roughlight %s%s%s: %s\n", command->name, verb ? " " : "", verb ? verb->name : "",
                error->message);
    return code;
}

static int run(const struct rl_command *command, int argc, char **argv)
{
    struct rl_error error = {0};
    struct rl_arguments arguments = {0};
    int code = RL_EXIT_USAGE;
    if (rl_simd_check(&error) == RL_OK &&
        rl_arguments_parse(&arguments, command, argc, argv, &error) == RL_OK)
        code = (arguments.verb ? arguments.verb->run : command->run)(&arguments, &error);
    return conclude(command, arguments.verb, code, &error);
}

static int help(const struct rl_command *command, int argc, char **argv)
{
    struct rl_error error = {0};
    return conclude(command, NULL, rl_exit_of(rl_command_help(command, argc, argv, &error)), &error);
}

/* Of what stands before any command. */
static int output_written(void)
{
    struct rl_error error = {0};
    if (rl_output_check(&error) == RL_OK)
        return RL_EXIT_OK;
    fprintf(stderr, "roughlight: %s\n", error.message);
    return RL_EXIT_USAGE;
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        fprintf(stderr, "roughlight: a command is missing; 'roughlight --help' lists them\n");
        return RL_EXIT_USAGE;
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "help") == 0) {
        print_help();
        return output_written();
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("roughlight %s (%s%s)\n", rl_version.version, rl_version.commit,
               rl_version.dirty ? ", modified" : "");
        return output_written();
    }
    const struct rl_command *command = find(argv[1]);
    if (!command) {
        fprintf(stderr, "roughlight: unknown command '%s'; 'roughlight --help' lists them\n", argv[1]);
        return RL_EXIT_USAGE;
    }
    for (int i = 2; i < argc && strcmp(argv[i], "--") != 0; i++)
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0)
            return help(command, argc - 2, argv + 2);
    return run(command, argc - 2, argv + 2);
}
