/* The same comparison over and over, with nothing changed but the seeds: how often does it raise an alarm, and are its p values what they
 * claim to be? If they are, those of one metric are uniform on [0, 1] from run to run. They are for this taken against all other runs, not
 * against the baseline: where that is off by chance, all runs are on the same side of it.
 *
 *     struct rl_reruns reruns = {0};
 *     for (...) rl_reruns_add(&reruns, &comparison, &error);
 *     rl_reruns_judge(&reruns, &error);                reruns.row[i].fit_p, reruns.smallest_fit_p
 *     rl_reruns_clear(&reruns);
 */
#ifndef RL_RESULTS_RERUNS_H
#define RL_RESULTS_RERUNS_H

#include "results/baseline.h"

struct rl_rerun_row {
    const struct rl_baseline_row *before; /* the metric */
    size_t n, alarms;                     /* comparisons; those that found it worse or better */
    double smallest_p;                    /* against the baseline */
    double offset; /* of the baseline from the mean of all runs, in standard errors of their difference */
    double
        distance; /* Kolmogorov's, of the p values of each run against the others from uniform ones; NaN for one run */
    double fit_p; /* that chance alone brings such a distance */
    struct rl_mean *run;
};

struct rl_reruns {
    size_t runs, n;
    struct rl_rerun_row *row; /* the n random metrics that were compared */
    size_t alarmed_runs;
    double smallest_p, smallest_fit_p; /* over all, as Sidak has it for so many */
};

/* Adds the random metrics of one comparison; what it compared must outlive the reruns. */
int rl_reruns_add(struct rl_reruns *reruns, const struct rl_comparison *comparison, struct rl_error *error);
int rl_reruns_judge(struct rl_reruns *reruns, struct rl_error *error);
void rl_reruns_clear(struct rl_reruns *reruns);

#endif
