/* Fair timing: several arms measured against each other, a frame of each in every round, in random order within the round, so
 * that whatever slows the machine for a while slows all of them. Every raw time is kept; comparisons are paired by round.
 *
 *     struct rl_timing_arm arm[] = {{"plain", frame, scene_a}, {"random 4", frame, scene_b}};
 *     struct rl_timing timing;
 *     rl_timing_run(&timing, arm, 2, &RL_TIMING_DEFAULT, progress, &error);
 *     struct rl_interval plain = rl_median_interval(timing.ms[0], timing.n_rounds, 0.95);
 *     struct rl_interval ratio = rl_ratio_interval(timing.ms[1], timing.ms[0], timing.n_rounds, 0.95);
 *     rl_timing_clear(&timing);
 */
#ifndef RL_MEASURE_TIMING_H
#define RL_MEASURE_TIMING_H

#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "base/progress.h"

enum { RL_TIMING_ARMS_MAX = 64 };

/* `frame` does the work once, waits until it is finished, and gives its wall time in seconds. */
struct rl_timing_arm {
    const char *name;
    int (*frame)(void *user, double *seconds, struct rl_error *error);
    void *user;
};

/* Rounds go on until there are `min_rounds`, and then until the median of every arm has a 95 % interval within +-`precision` of
 * itself, or there are `max_rounds`, or `max_seconds` have passed. */
struct rl_timing_options {
    int warm_up; /* rounds before, thrown away: the first frame compiles */
    int min_rounds, max_rounds;
    double precision; /* relative */
    double max_seconds;
    uint64_t seed; /* of the order within rounds */
};

#define RL_TIMING_DEFAULT                                                                                    \
    ((struct rl_timing_options){.warm_up = 2,                                                                \
                                .min_rounds = 30,                                                            \
                                .max_rounds = 100,                                                           \
                                .precision = 0.02,                                                           \
                                .max_seconds = 20.0,                                                         \
                                .seed = 1})

struct rl_timing {
    size_t n_arms, n_rounds;
    double **ms; /* [n_arms][n_rounds], milliseconds */
};

/* A frame may take 0 s, where the clock's tick is longer; then no median is precise, and a ratio to it is unknown (statistics.h). Fewer
 * than six rounds are never precise: their intervals are infinite. RL_ERR_SYSTEM: a frame of less than 0 s, or of no number.
 * RL_ERR_CANCELLED and an arm's own errors leave nothing to clear. `progress` is asked only whether to stop. */
int rl_timing_run(struct rl_timing *timing, const struct rl_timing_arm *arm, size_t n_arms,
                  const struct rl_timing_options *options, const struct rl_progress *progress,
                  struct rl_error *error);

void rl_timing_clear(struct rl_timing *timing);

#endif
