/* `roughlight study merge`: the results of several databases in one. */
#include <stdio.h>
#include <string.h>

#include "cli/study.h"
#include "results/database.h"
#include "results/merge.h"

/* Those given with --study. */
static int take_studies(const struct rl_study *study[], size_t *n, const struct rl_arguments *a,
                        struct rl_error *error)
{
    const char *name;
    for (*n = 0; (name = rl_argument_nth(a, "study", *n)); ++*n) {
        study[*n] = rl_study_find(name);
        if (!study[*n])
            return rl_fail(error, RL_ERR_INPUT,
                           "--study: there is no study '%s'; 'roughlight study list' lists them", name);
    }
    return RL_OK;
}

static void print_lines(const char *lines)
{
    for (const char *line = lines; line && *line;) {
        int length = (int)strcspn(line, "\n");
        fprintf(stderr, "roughlight: %.*s\n", length, line);
        line += length + 1;
    }
}

static void print_outcome(const struct rl_merge_outcome *o, const char *into)
{
    fprintf(stderr, "%s: %zu cases copied, %zu there already, %zu measured twice with different results\n",
            into, o->copied, o->known, o->differing);
    print_lines(o->notes.data);
    print_lines(o->agreements.data);
    if (o->agreeing > RL_MERGE_NAMED)
        fprintf(stderr, "roughlight: %zu more were there already, with the same results\n",
                o->agreeing - RL_MERGE_NAMED);
}

int rl_study_merge_command(const struct rl_arguments *a, struct rl_error *error)
{
    const struct rl_study *study[RL_CLI_GIVEN_MAX];
    size_t n = 0, named = 0;
    struct rl_merge_options options = {.into = a->positional[0],
                                       .from = a->positional + 1,
                                       .n_from = a->n_positionals - 1,
                                       .allow_mixed = rl_argument_flag(a, "allow-mixed")};
    int status = take_studies(study, &n, a, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    struct rl_merge_outcome outcome;
    char folder[PATH_MAX];
    rl_database_missing_folder(folder, options.into);
    status = rl_database_merge(&outcome, &options, error);
    if (status == RL_OK && folder[0])
        fprintf(stderr, "created the folder %s\n", folder);
    if (status == RL_OK) {
        print_outcome(&outcome, options.into);
        named = n ? rl_study_name_failures(study, n, options.into, true)
                  : rl_study_name_failures(rl_studies, rl_n_studies, options.into, false);
        named += outcome.differing;
    }
    rl_merge_outcome_clear(&outcome);
    return status == RL_OK && named > 0 ? RL_EXIT_PARTIAL : rl_exit_of(status);
}
