/* Frames of a group's cases timed against each other, the same way in every study: arms take turns in random order within rounds, at least
 * `frames` rounds and until every arm's median has a 95 % interval within +-2 %, or until a cap, which the figures then say.
 *
 *     struct rl_timing_arm arm[] = {{records[0].parameters, rl_arms_frame, set[0]}, ...};
 *     rl_arms_time(records, arm, n, bench, &(struct rl_arms_options){.frames = 30, ...}, &error);
 *
 * One arm should draw without a highlight (the baseline) and one be a second one of the same work (A/A): what these two differ
 * by is chance, and so is any smaller difference.
 */
#ifndef RL_STUDIES_TIMING_ARMS_H
#define RL_STUDIES_TIMING_ARMS_H

#include "measure/statistics.h"
#include "measure/timing.h"
#include "results/claims.h"
#include "results/record.h"
#include "studies/bench.h"

struct rl_arms_options {
    int frames, most_frames; /* of each arm; the second one is a cap */
    double most_seconds;     /* a cap on all arms together, which does not count before there are `frames` */
    const char *baseline;    /* parameters of the arm that is subtracted; NULL: none is */
    const char *against;     /* parameters of the arm that times are relative to; NULL: to none */
    const char *ratio;       /* with `against`: the metric's name, "time_to_..." */
    const char *against2, *ratio2; /* the same of another arm */
    const char *difference;        /* as `ratio`, "above_..._ms"; NULL: not wanted */
};

/* For rl_timing_arm.frame: a frame of the struct rl_bench_scene that is its `user`. */
int rl_arms_frame(void *user, double *seconds, struct rl_error *error);

/* Adds to each record the series frame_ms and the metrics frame_ms; frames; time_precision, the wider half of its interval over the median;
 * time_capped, 1 where that is above 2 % since a cap was reached; and, paired by round, above_baseline_ms, `ratio` and `difference` as the options say. All of it
 * is on the clock of what is measured. */
int rl_arms_time(struct rl_record *records, const struct rl_timing_arm *arm, size_t n, struct rl_bench *bench,
                 const struct rl_arms_options *options, struct rl_error *error);

/* The largest relative difference between two arms of the same work that is still chance, from the interval of their ratio. NaN for
 * NULL. */
double rl_arms_noise(const struct rl_metric *ratio);

/* Whether a ratio of times is at most `bound`, give or take the noise; inconclusive if either was not measured. */
enum rl_verdict rl_arms_at_most(const struct rl_metric *ratio, double noise, double bound);

#endif
