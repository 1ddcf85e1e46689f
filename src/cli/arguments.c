/* Splits a subcommand's words into options and positionals, and prints its help (see command.h). */
#include <stdio.h>
#include <string.h>

#include "cli/command.h"

/* The i-th option of all that a command has, or NULL; and which verbs take it. */
static const struct rl_option *option_at(const struct rl_command *command, size_t i, unsigned *verbs)
{
    *verbs = ~0U;
    for (const struct rl_option *const *list = command->options; list && *list; list++)
        for (const struct rl_option *o = *list; o->name; o++)
            if (i-- == 0)
                return o;
    for (const struct rl_verb_option *v = command->verb_options; v && v->option.name; v++)
        if (i-- == 0) {
            *verbs = v->verbs;
            return &v->option;
        }
    return NULL;
}

/* The bit of a verb; all bits if there is none. */
static unsigned bit_of(const struct rl_command *command, const struct rl_verb *verb)
{
    return verb ? 1U << (verb - command->verbs) : ~0U;
}

/* An option as it was written: --name, --name=value or -n. */
struct word {
    const char *name;
    size_t length;
    const char *attached; /* value, or NULL */
    char letter;          /* 0: a long one */
};

static bool is_option(const char *text)
{
    return text[0] == '-' && text[1] != '\0';
}

static struct word take_apart(const char *text)
{
    bool is_long = text[1] == '-';
    struct word w = {.name = is_long ? text + 2 : text + 1, .letter = (char)(is_long ? 0 : text[1])};
    w.length = is_long ? strcspn(w.name, "=") : 1;
    w.attached = w.name[w.length] == '\0' ? NULL : w.name + w.length + (w.name[w.length] == '=');
    return w;
}

/* The option of that name that any of these verbs takes. */
static const struct rl_option *find(const struct rl_command *command, unsigned verbs, const struct word *w)
{
    const struct rl_option *o;
    unsigned takers;
    for (size_t i = 0; (o = option_at(command, i, &takers)); i++)
        if ((takers & verbs) &&
            (w->letter ? o->letter == w->letter
                       : strlen(o->name) == w->length && strncmp(o->name, w->name, w->length) == 0))
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

/* "--shard belongs to study run": an option that other verbs take. */
static int foreign_option(const struct rl_command *command, const struct rl_option *option,
                          struct rl_error *error)
{
    char names[256] = "";
    unsigned takers = 0, verbs;
    const struct rl_option *o;
    for (size_t i = 0; (o = option_at(command, i, &verbs)); i++)
        takers |= strcmp(o->name, option->name) == 0 ? verbs : 0U;
    for (const struct rl_verb *v = command->verbs; v->name; v++) {
        size_t used = strlen(names);
        if (takers & bit_of(command, v))
            snprintf(names + used, sizeof names - used, "%s%s", used ? ", " : "", v->name);
    }
    return rl_fail(error, RL_ERR_INPUT, "--%s belongs to %s %s", option->name, command->name, names);
}

static int unknown_option(const struct rl_arguments *a, const struct rl_command *command, const char *text,
                          const struct word *w, struct rl_error *error)
{
    const struct rl_option *o = find(command, ~0U, w);
    const char *nearest = NULL;
    size_t best = 3;
    unsigned verbs;
    if (o)
        return foreign_option(command, o, error);
    for (size_t i = 0; (o = option_at(command, i, &verbs)); i++) {
        /* Of -nosuch, the whole word is compared. */
        size_t distance = edit_distance(w->name, strcspn(w->name, "="), o->name);
        if ((verbs & bit_of(command, a->verb)) && distance < best) {
            best = distance;
            nearest = o->name;
        }
    }
    if (nearest)
        return rl_fail(error, RL_ERR_INPUT, "unknown option '%s'; did you mean '--%s'?", text, nearest);
    return rl_fail(error, RL_ERR_INPUT, "unknown option '%s'; 'roughlight %s%s%s --help' lists them", text,
                   command->name, a->verb ? " " : "", a->verb ? a->verb->name : "");
}

/* An empty name would end up in a message in which nobody sees it. Others say themselves what they expect. */
static int check_name(const struct rl_option *option, const char *value, struct rl_error *error)
{
    static const char *const kinds[] = {"FILE", "DIR"};
    for (size_t i = 0; value && *value == '\0' && i < sizeof kinds / sizeof kinds[0]; i++)
        if (strcmp(option->argument, kinds[i]) == 0)
            return rl_fail(error, RL_ERR_INPUT, "--%s: found an empty name, which is none, expected %s",
                           option->name, option->argument);
    return RL_OK;
}

/* Takes one option word, and the next word if it needs an argument; returns how many words, or a negative status. */
static int take_option(struct rl_arguments *a, const struct rl_command *command, int left, char **word,
                       struct rl_error *error)
{
    struct word w = take_apart(word[0]);
    const struct rl_option *option = find(command, bit_of(command, a->verb), &w);
    if (!option)
        return unknown_option(a, command, word[0], &w, error);
    if (a->n_given == RL_CLI_GIVEN_MAX)
        return rl_fail(error, RL_ERR_INPUT, "more than %d options", RL_CLI_GIVEN_MAX);
    if (!option->argument && w.attached)
        return rl_fail(error, RL_ERR_INPUT, "--%s takes no argument, found '%s'", option->name, w.attached);
    if (option->argument && !w.attached && left < 2)
        return rl_fail(error, RL_ERR_INPUT, "--%s: an argument is missing, expected %s", option->name,
                       option->argument);
    bool takes_next = option->argument && !w.attached;
    const char *value = takes_next ? word[1] : w.attached;
    int status = check_name(option, value, error);
    if (status != RL_OK)
        return status;
    a->given[a->n_given].option = option;
    a->given[a->n_given].value = value;
    a->n_given++;
    return takes_next ? 2 : 1;
}

static const struct rl_verb *verb_called(const struct rl_command *command, const char *name)
{
    for (const struct rl_verb *v = command->verbs; v && v->name; v++)
        if (strcmp(v->name, name) == 0)
            return v;
    return NULL;
}

static int no_verb(const struct rl_command *command, const char *found, struct rl_error *error)
{
    char names[256] = "";
    for (const struct rl_verb *v = command->verbs; v->name; v++) {
        size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, "%s%s", used ? v[1].name ? ", " : " or " : "", v->name);
    }
    return rl_fail(error, RL_ERR_INPUT, "found %s%s%s, expected %s", found ? "'" : "nothing",
                   found ? found : "", found ? "'" : "", names);
}

/* The verb is the first word that is neither an option nor an option's argument; it lies at *at. */
static int take_verb(struct rl_arguments *a, const struct rl_command *command, int argc, char **argv, int *at,
                     struct rl_error *error)
{
    int i = 0;
    while (i < argc && is_option(argv[i])) {
        struct word w = take_apart(argv[i]);
        const struct rl_option *option = find(command, ~0U, &w);
        i += option && option->argument && !w.attached ? 2 : 1;
    }
    a->verb = i < argc ? verb_called(command, argv[i]) : NULL;
    *at = i;
    return a->verb ? RL_OK : no_verb(command, i < argc ? argv[i] : NULL, error);
}

/* The command's own line of usage, or its verb's. */
static const char *usage(char text[256], const struct rl_command *command, const struct rl_verb *verb)
{
    snprintf(text, 256, "roughlight %s %s%s%s", command->name, verb ? verb->name : "",
             verb && *verb->arguments ? " " : "", verb ? verb->arguments : command->arguments);
    return text;
}

static int take_positional(struct rl_arguments *a, const struct rl_command *command, const char *text,
                           struct rl_error *error)
{
    char line[256];
    size_t most = a->verb ? a->verb->max_positionals : command->max_positionals;
    if (a->n_positionals == most || a->n_positionals == RL_CLI_POSITIONALS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "unexpected argument '%s'; usage: %s", text,
                       usage(line, command, a->verb));
    if (*text == '\0')
        return rl_fail(error, RL_ERR_INPUT, "found an empty argument, expected a name; usage: %s",
                       usage(line, command, a->verb));
    a->positional[a->n_positionals++] = text;
    return RL_OK;
}

int rl_arguments_parse(struct rl_arguments *a, const struct rl_command *command, int argc, char **argv,
                       struct rl_error *error)
{
    *a = (struct rl_arguments){0};
    bool options_end = false;
    int verb_at = -1;
    int status = command->verbs ? take_verb(a, command, argc, argv, &verb_at, error) : RL_OK;
    for (int i = 0; i < argc && status >= 0;) {
        if (i == verb_at) {
            i++;
        } else if (!options_end && strcmp(argv[i], "--") == 0) {
            options_end = true;
            i++;
        } else if (!options_end && is_option(argv[i])) {
            status = take_option(a, command, argc - i, argv + i, error);
            i += status;
        } else {
            status = take_positional(a, command, argv[i++], error);
        }
    }
    if (status < 0)
        return status;
    char line[256];
    if (a->n_positionals < (a->verb ? a->verb->min_positionals : command->min_positionals))
        return rl_fail(error, RL_ERR_INPUT, "an argument is missing; usage: %s",
                       usage(line, command, a->verb));
    return RL_OK;
}

/* The options that the command takes, or its verb. */
static void print_options(const struct rl_command *command, const struct rl_verb *verb)
{
    const struct rl_option *o;
    unsigned verbs;
    for (size_t i = 0, n = 0; (o = option_at(command, i, &verbs)); i++) {
        if (!(verbs & bit_of(command, verb)))
            continue;
        char left[64];
        char letter[] = {'-', o->letter, ',', ' ', '\0'};
        snprintf(left, sizeof left, "%s--%s%s%s", o->letter ? letter : "", o->name, o->argument ? " " : "",
                 o->argument ? o->argument : "");
        printf("%s  %-24s %s\n", n++ ? "" : "\noptions:\n", left, o->help);
    }
}

int rl_command_help(const struct rl_command *command, int argc, char **argv, struct rl_error *error)
{
    const struct rl_verb *verb = NULL;
    char line[256];
    for (int i = 0; i < argc && !verb; i++)
        verb = verb_called(command, argv[i]);
    if (command->verbs && !verb && argc > 0 && !is_option(argv[0]))
        return no_verb(command, argv[0], error);
    printf("usage: %s\n\n%s\n", usage(line, command, verb), verb ? verb->description : command->description);
    if (command->verbs && !verb) {
        printf("\nverbs:\n");
        for (const struct rl_verb *v = command->verbs; v->name; v++)
            printf("  %-10s %s\n", v->name, v->summary);
        printf("\n'roughlight %s VERB --help' explains each, with examples.\n", command->name);
    } else {
        print_options(command, verb);
    }
    void (*more_help)(void) = verb ? verb->more_help : command->more_help;
    if (more_help)
        more_help();
    return RL_OK;
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
