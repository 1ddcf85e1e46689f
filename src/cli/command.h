/* Subcommands: one descriptor each (NAME.c), one row of the table in main.c. The parser and --help work from it.
 *
 *     static const struct rl_option options[] = {
 *         {'o', "output", "FILE", "where to write; .exr or .png"},
 *         {0, "verbose", NULL, "say more"},
 *         {0}};
 *     const struct rl_command rl_command_render = {"render", "SCENE -o FILE", 1, 1, "render a scene", ..., options, run};
 *
 * An option with an argument takes the next word whatever it is, so that negative numbers need no quoting; --name=value works too.
 *
 * A command may have verbs (`roughlight study run`): then the first word that is no option is one of them, options are rows of one table
 * that says which verbs take them, and each verb has a --help of its own, made from its row and that table.
 */
#ifndef RL_CLI_COMMAND_H
#define RL_CLI_COMMAND_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "model/vec3.h"

enum { RL_CLI_POSITIONALS_MAX = 64, RL_CLI_GIVEN_MAX = 256 };

/* Exit codes: a contract with scripts. */
enum rl_exit {
    RL_EXIT_OK = 0,
    RL_EXIT_CHECK = 1,
    RL_EXIT_USAGE = 2,
    RL_EXIT_PARTIAL = 3,
    RL_EXIT_INTERRUPTED = 130
};

struct rl_option {
    char letter;          /* 0: none */
    const char *name;     /* without the dashes; NULL ends the list */
    const char *argument; /* what --help calls it; NULL: a flag */
    const char *help;
};

/* An option of some verbs: bit i stands for verb i. Rows of the same name may differ in what they tell, not in whether they take an
 * argument. */
struct rl_verb_option {
    unsigned verbs;
    struct rl_option option;
};

struct rl_verb;

struct rl_arguments {
    const struct rl_verb *verb; /* NULL: the command has none */
    size_t n_positionals;       /* without the verb */
    const char *positional[RL_CLI_POSITIONALS_MAX];
    size_t n_given;
    struct {
        const struct rl_option *option;
        const char *value;
    } given[RL_CLI_GIVEN_MAX];
};

struct rl_verb {
    const char *name;
    const char *arguments; /* the usage line after the name */
    size_t min_positionals, max_positionals;
    const char *summary;
    const char *description; /* paragraphs for --help, with examples */
    void (*more_help)(void); /* prints what --help ends with; NULL: nothing */
    int (*run)(const struct rl_arguments *arguments, struct rl_error *error); /* as rl_command.run */
};

struct rl_command {
    const char *name;
    const char *arguments; /* the usage line after the name */
    size_t min_positionals, max_positionals;
    const char *summary;
    const char *description;                /* paragraphs for --help, with examples */
    const struct rl_option *const *options; /* lists of options, NULL at the end */
    void (*more_help)(void);                /* prints what --help ends with; NULL: nothing */
    const struct rl_verb *verbs;            /* one without a name ends them; NULL: none */
    const struct rl_verb_option *verb_options;
    /* Returns an rl_exit; on RL_EXIT_USAGE or RL_EXIT_CHECK with a message in `error`, main prints it. NULL: each
     * verb has its own. */
    int (*run)(const struct rl_arguments *arguments, struct rl_error *error);
};

/* Splits the words after the subcommand's name. RL_ERR_INPUT says what is wrong with them. */
int rl_arguments_parse(struct rl_arguments *arguments, const struct rl_command *command, int argc,
                       char **argv, struct rl_error *error);

bool rl_argument_flag(const struct rl_arguments *arguments, const char *name);
/* The last value given, or NULL. */
const char *rl_argument(const struct rl_arguments *arguments, const char *name);
/* The i-th value given, or NULL when there are no more. */
const char *rl_argument_nth(const struct rl_arguments *arguments, const char *name, size_t i);

/* Numbers with a range; an absent option leaves *value alone. Messages name the option, what was found and expected. */
int rl_argument_integer(const struct rl_arguments *arguments, const char *name, long long low, long long high,
                        long long *value, struct rl_error *error);
int rl_argument_number(const struct rl_arguments *arguments, const char *name, double low, double high,
                       double *value, struct rl_error *error);

/* "x,y,z"; a direction may have any length above 0 and becomes unit. */
int rl_argument_vector(const struct rl_arguments *arguments, const char *name, bool direction, rl_vec3 *v,
                       struct rl_error *error);

/* A finite number that is all of `text`; false if it is not. */
bool rl_text_number(const char *text, double *value);
/* Three finite numbers "x,y,z" at *text, which moves behind them; false unless a blank or the end follows there. */
bool rl_text_vector(const char **text, rl_vec3 *v);

/* Prints the help that these words ask for: the command's, or that of the verb among them. RL_ERR_INPUT: a word where a verb should
 * be is none. */
int rl_command_help(const struct rl_command *command, int argc, char **argv, struct rl_error *error);

/* The exit code that stands for an rl_status. */
int rl_exit_of(int status);

#endif
