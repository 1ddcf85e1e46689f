/* The same comparison over and over, with nothing changed but the seeds: how often does it raise an alarm, and are its p values what they
 * claim to be? If they are, those of one metric are uniform on [0, 1] from run to run.
 *
 *     struct rl_reruns reruns = {0};
 *     for (...) rl_reruns_add(&reruns, &comparison, &error);
 *     rl_reruns_judge(&reruns);                        reruns.row[i].fit_p, reruns.smallest_fit_p
 *     rl_reruns_clear(&reruns);
 */
#ifndef RL_RESULTS_RERUNS_H
#define RL_RESULTS_RERUNS_H

#include "results/baseline.h"

struct rl_rerun_row {
    const struct rl_baseline_row *before; /* the metric */
    size_t n, alarms;                     /* comparisons; those that found it worse or better */
    double smallest_p;
    double distance; /* Kolmogorov's, of its p values from uniform ones */
    double fit_p;    /* that chance alone brings such a distance */
    double *p;
};

struct rl_reruns {
    size_t runs, n;
    struct rl_rerun_row *row; /* the n random metrics that were compared */
    size_t alarmed_runs;
    double smallest_p, smallest_fit_p; /* over all, as Sidak has it for so many */
};

/* Adds the random metrics of one comparison; what it compared must outlive the reruns. */
int rl_reruns_add(struct rl_reruns *reruns, const struct rl_comparison *comparison, struct rl_error *error);
void rl_reruns_judge(struct rl_reruns *reruns);
void rl_reruns_clear(struct rl_reruns *reruns);

#endif
