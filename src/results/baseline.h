/* Baselines: figures of a known good program, one row each, in a text file that is kept with the sources; and today's figures against
 * them.
 *
 *     struct rl_baseline before = {0}, now = {0};
 *     rl_baseline_read(&before, "tests/baseline.tsv", &error);
 *     ... rl_baseline_add(&now, ...) ...
 *     rl_baseline_compare(&comparison, &before, &now, 1e-4, &error);
 *
 * The file is TSV: lines that begin with # are comments, the first other line names the columns, in this order:
 *
 *     scene             a shipped scene, or none
 *     parameters        of the case: method=random samples=4 rr=30
 *     metric            rmse, bias, ...; the three together name the row
 *     kind              random: differs by seed; fixed: does not
 *     best              lower, zero or same: which change is an improvement (measure/regression.h)
 *     unit              1: a pure number
 *     value             random: the mean over seeds
 *     deviation         random: standard deviation of the n values; fixed: 0
 *     n                 random: how many independent values; fixed: 1
 *     tolerance         fixed: by how much rounding may move the value; random: 0
 *     relevant          random: a change this large must not go unseen, else the verdict is inconclusive; fixed: 0
 *     tolerance_from    fixed: how the tolerance follows from rounding; random: -
 *     scene_hash        of the scene's file, or -
 *     commit, renderer  where the row comes from
 */
#ifndef RL_RESULTS_BASELINE_H
#define RL_RESULTS_BASELINE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "measure/regression.h"
#include "results/record.h"

enum rl_metric_kind { RL_METRIC_RANDOM, RL_METRIC_FIXED };

struct rl_baseline_row {
    char scene[RL_NAME_MAX], parameters[RL_PARAMETERS_MAX], metric[RL_NAME_MAX], unit[RL_NAME_MAX];
    enum rl_metric_kind kind;
    enum rl_best best;
    struct rl_mean mean;
    double tolerance, relevant;
    char tolerance_from[128];
    char scene_hash[RL_HASH_TEXT], commit[48], renderer[128];
    bool
        drawn; /* not in the file: the GPU has had a part in a fixed figure, so that another one may round otherwise */
    double seconds; /* not in the file: that its case took */
};

struct rl_baseline {
    size_t n, capacity;
    struct rl_baseline_row *row;
};

/* Copies a row to the end. */
int rl_baseline_add(struct rl_baseline *baseline, const struct rl_baseline_row *row, struct rl_error *error);
/* NULL if there is none. */
const struct rl_baseline_row *rl_baseline_find(const struct rl_baseline *baseline,
                                               const struct rl_baseline_row *like);
void rl_baseline_clear(struct rl_baseline *baseline);

/* RL_ERR_INPUT names file, line and column, what was found and what was expected; a row that is there twice is an error too.
 * `baseline` must be empty. */
int rl_baseline_read(struct rl_baseline *baseline, const char *path, struct rl_error *error);
/* Replaces the file whole. `comment`: lines without their #, or NULL. RL_ERR_CHECK: a value is not finite. */
int rl_baseline_write(const struct rl_baseline *baseline, const char *path, const char *comment,
                      struct rl_error *error);

/* One figure, then and now; one of them is NULL where a figure is new or gone. */
struct rl_compared {
    const struct rl_baseline_row *before, *now;
    struct rl_regression result;
};

struct rl_comparison {
    size_t n;
    struct rl_compared *row; /* those measured now in their order, then those that are gone */
    size_t count[RL_CHANGES];
    size_t n_tests;  /* random figures that were compared */
    double level;    /* of each: Sidak's, for n_tests */
    double p_family; /* the probability that chance alone brings a p as small as the smallest */
};

/* `level` is the probability of any false alarm among all the random figures. Incomparable are figures that one side lacks, those of a
 * scene that has changed, and those whose kind, unit or meaning of better has. A fixed figure that the GPU has a part in and that
 * differs on another family of renderers is incomparable, not worse. `before` and `now` must outlive the comparison. */
int rl_baseline_compare(struct rl_comparison *comparison, const struct rl_baseline *before,
                        const struct rl_baseline *now, double level, struct rl_error *error);
void rl_comparison_clear(struct rl_comparison *comparison);

#endif
