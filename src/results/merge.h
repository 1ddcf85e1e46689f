/* Puts the results of several databases into one, e.g. of the shares of a grid that several machines measured.
 *
 *     const char *from[] = {"1.db", "2.db"};
 *     struct rl_merge_options options = {.into = "all.db", .from = from, .n_from = 2};
 *     struct rl_merge_outcome outcome;
 *     rl_database_merge(&outcome, &options, &error);
 *     rl_merge_outcome_clear(&outcome);
 *
 * Of every study the latest run counts, in each file: the cases it planned become one plan, and what any file has of them is copied,
 * with its own provenance. A measured case replaces a failed one, nothing replaces a measured one. Merging the same files
 * once more changes nothing. A study of a file is taken in wholly or not at all. The files merged from are not changed.
 */
#ifndef RL_RESULTS_MERGE_H
#define RL_RESULTS_MERGE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "results/buffer.h"

struct rl_merge_options {
    const char *into; /* made if it does not exist */
    const char *const *from;
    size_t n_from;
    /* Take together what was measured by different versions, sources or renderers, or on different scenes of one name; else
     * that is RL_ERR_INPUT, and nothing is changed. */
    bool allow_mixed;
};

/* A file merged once more has all its cases twice, which nobody wants to read one by one. */
enum { RL_MERGE_NAMED = 20 };

struct rl_merge_outcome {
    size_t copied; /* cases */
    size_t known;  /* cases that were there already, as good or better */
    /* Cases that both have measured, times aside. The first is kept. */
    size_t differing, agreeing;
    struct rl_buffer notes;      /* a line each differing one */
    struct rl_buffer agreements; /* a line each agreeing one, but for those beyond RL_MERGE_NAMED */
};

int rl_database_merge(struct rl_merge_outcome *outcome, const struct rl_merge_options *options,
                      struct rl_error *error);
void rl_merge_outcome_clear(struct rl_merge_outcome *outcome);

#endif
