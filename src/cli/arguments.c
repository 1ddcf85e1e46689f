/* Splits a subcommand's words into options and positionals, and prints its help (see command.h). */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"

static const struct rl_option *find(const struct rl_command *command, const char *name, size_t length,
                                    char letter)
{
    for (const struct rl_option *const *list = command->options; list && *list; list++)
        for (const struct rl_option *o = *list; o->name; o++)
            if (letter ? o->letter == letter
                       : strlen(o->name) == length && strncmp(o->name, name, length) == 0)
                return o;
    return NULL;
}

/* How many single-letter edits lead from a to b (Levenshtein), for "did you mean". Both are short. */
static size_t edit_distance(const char *a, size_t n, const char *b)
{
    size_t row[64];
    size_t m = strlen(b);
    if (n >= 64 || m >= 64)
        return 64;
    for (size_t j = 0; j <= m; j++)
        row[j] = j;
    for (size_t i = 1; i <= n; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= m; j++) {
            size_t change = diagonal + (a[i - 1] != b[j - 1]);
            size_t least = row[j] < row[j - 1] ? row[j] + 1 : row[j - 1] + 1;
            diagonal = row[j];
            row[j] = change < least ? change : least;
        }
    }
    return row[m];
}

static int unknown_option(const struct rl_command *command, const char *word, struct rl_error *error)
{
    const char *name = word[1] == '-' ? word + 2 : word + 1;
    size_t length = strcspn(name, "=");
    const char *nearest = NULL;
    size_t best = 3;
    for (const struct rl_option *const *list = command->options; list && *list; list++)
        for (const struct rl_option *o = *list; o->name; o++) {
            size_t distance = edit_distance(name, length, o->name);
            if (distance < best) {
                best = distance;
                nearest = o->name;
            }
        }
    if (nearest)
        return rl_fail(error, RL_ERR_INPUT, "unknown option '%s'; did you mean '--%s'?", word, nearest);
    return rl_fail(error, RL_ERR_INPUT, "unknown option '%s'; 'roughlight %s --help' lists them", word,
                   command->name);
}

/* Takes one option word, and the next word if it needs an argument; returns how many words, or a negative status. */
static int take_option(struct rl_arguments *a, const struct rl_command *command, int left, char **word,
                       struct rl_error *error)
{
    bool is_long = word[0][1] == '-';
    const char *name = is_long ? word[0] + 2 : word[0] + 1;
    size_t length = is_long ? strcspn(name, "=") : 1;
    const struct rl_option *option = find(command, name, length, (char)(is_long ? 0 : name[0]));
    if (!option)
        return unknown_option(command, word[0], error);
    const char *attached = name[length] == '\0' ? NULL : name + length + (name[length] == '=');
    if (a->n_given == RL_CLI_GIVEN_MAX)
        return rl_fail(error, RL_ERR_INPUT, "more than %d options", RL_CLI_GIVEN_MAX);
    if (!option->argument && attached)
        return rl_fail(error, RL_ERR_INPUT, "--%s takes no argument, found '%s'", option->name, attached);
    if (option->argument && !attached && left < 2)
        return rl_fail(error, RL_ERR_INPUT, "--%s: an argument is missing, expected %s", option->name,
                       option->argument);
    bool takes_next = option->argument && !attached;
    a->given[a->n_given].option = option;
    a->given[a->n_given].value = takes_next ? word[1] : attached;
    a->n_given++;
    return takes_next ? 2 : 1;
}

int rl_arguments_parse(struct rl_arguments *a, const struct rl_command *command, int argc, char **argv,
                       struct rl_error *error)
{
    *a = (struct rl_arguments){0};
    bool options_end = false;
    for (int i = 0; i < argc;) {
        if (!options_end && strcmp(argv[i], "--") == 0) {
            options_end = true;
            i++;
        } else if (!options_end && argv[i][0] == '-' && argv[i][1] != '\0') {
            int words = take_option(a, command, argc - i, argv + i, error);
            if (words < 0)
                return words;
            i += words;
        } else if (a->n_positionals == command->max_positionals ||
                   a->n_positionals == RL_CLI_POSITIONALS_MAX) {
            return rl_fail(error, RL_ERR_INPUT, "unexpected argument '%s'; usage: roughlight %s %s", argv[i],
                           command->name, command->arguments);
        } else {
            a->positional[a->n_positionals++] = argv[i++];
        }
    }
    if (a->n_positionals < command->min_positionals)
        return rl_fail(error, RL_ERR_INPUT, "an argument is missing; usage: roughlight %s %s", command->name,
                       command->arguments);
    return RL_OK;
}

const char *rl_argument_nth(const struct rl_arguments *a, const char *name, size_t n)
{
    for (size_t i = 0; i < a->n_given; i++)
        if (strcmp(a->given[i].option->name, name) == 0 && n-- == 0)
            return a->given[i].value;
    return NULL;
}

const char *rl_argument(const struct rl_arguments *a, const char *name)
{
    const char *value = NULL;
    for (size_t i = 0; i < a->n_given; i++)
        if (strcmp(a->given[i].option->name, name) == 0)
            value = a->given[i].value;
    return value;
}

bool rl_argument_flag(const struct rl_arguments *a, const char *name)
{
    for (size_t i = 0; i < a->n_given; i++)
        if (strcmp(a->given[i].option->name, name) == 0)
            return true;
    return false;
}

bool rl_text_number(const char *text, double *value)
{
    char *end = NULL;
    if (*text == '\0' || isspace((unsigned char)*text))
        return false;
    double x = strtod(text, &end);
    if (*end != '\0' || !isfinite(x))
        return false;
    *value = x;
    return true;
}

int rl_argument_integer(const struct rl_arguments *a, const char *name, long long low, long long high,
                        long long *value, struct rl_error *error)
{
    const char *text = rl_argument(a, name);
    if (!text)
        return RL_OK;
    char *end = NULL;
    errno = 0;
    long long x = strtoll(text, &end, 10);
    if (end == text || *end != '\0' || errno != 0 || x < low || x > high)
        return rl_fail(error, RL_ERR_INPUT, "--%s: found '%s', expected a whole number from %lld to %lld",
                       name, text, low, high);
    *value = x;
    return RL_OK;
}

int rl_argument_number(const struct rl_arguments *a, const char *name, double low, double high, double *value,
                       struct rl_error *error)
{
    const char *text = rl_argument(a, name);
    if (!text)
        return RL_OK;
    double x;
    if (!rl_text_number(text, &x) || x < low || x > high)
        return rl_fail(error, RL_ERR_INPUT, "--%s: found '%s', expected a number from %g to %g", name, text,
                       low, high);
    *value = x;
    return RL_OK;
}

void rl_command_help(const struct rl_command *command)
{
    printf("usage: roughlight %s %s\n\n%s\n", command->name, command->arguments, command->description);
    if (command->options && *command->options)
        printf("\noptions:\n");
    for (const struct rl_option *const *list = command->options; list && *list; list++)
        for (const struct rl_option *o = *list; o->name; o++) {
            char left[64];
            char letter[] = {'-', o->letter, ',', ' ', '\0'};
            snprintf(left, sizeof left, "%s--%s%s%s", o->letter ? letter : "", o->name,
                     o->argument ? " " : "", o->argument ? o->argument : "");
            printf("  %-24s %s\n", left, o->help);
        }
    if (command->more_help)
        command->more_help();
}

int rl_exit_of(int status)
{
    switch (status) {
    case RL_OK:
        return RL_EXIT_OK;
    case RL_ERR_CHECK:
        return RL_EXIT_CHECK;
    case RL_ERR_CANCELLED:
        return RL_EXIT_INTERRUPTED;
    default:
        return RL_EXIT_USAGE;
    }
}
