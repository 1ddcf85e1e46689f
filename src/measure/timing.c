/* Interleaved rounds of timed frames (see timing.h). */
#include "measure/timing.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/clock.h"
#include "measure/statistics.h"
#include "model/random.h"

void rl_timing_clear(struct rl_timing *timing)
{
    for (size_t i = 0; timing->ms && i < timing->n_arms; i++)
        free(timing->ms[i]);
    free(timing->ms);
    *timing = (struct rl_timing){0};
}

/* What was allocated when memory ran out is left for rl_timing_clear. */
static int allocate(struct rl_timing *timing, size_t n_arms, size_t rounds, struct rl_error *error)
{
    *timing = (struct rl_timing){.n_arms = n_arms, .ms = calloc(n_arms, sizeof *timing->ms)};
    bool ok = timing->ms != NULL;
    for (size_t i = 0; ok && i < n_arms; i++)
        ok = (timing->ms[i] = malloc(rounds * sizeof **timing->ms)) != NULL;
    if (ok)
        return RL_OK;
    rl_error_set(error, RL_ERR_SYSTEM, "out of memory for frame times");
    return RL_ERR_SYSTEM;
}

/* A random order of 0 ... n - 1 that depends on the seed and the round (Fisher and Yates). */
static void shuffle(size_t order[], size_t n, uint64_t seed, uint64_t round)
{
    for (size_t i = 0; i < n; i++)
        order[i] = i;
    for (size_t i = n; i > 1; i--) {
        size_t j = (size_t)(rl_random_uniform(seed, round * RL_TIMING_ARMS_MAX + i) * (double)i);
        size_t kept = order[i - 1];
        order[i - 1] = order[j];
        order[j] = kept;
    }
}

/* One frame of every arm, into seconds[]. */
static int one_round(double seconds[], const struct rl_timing_arm *arm, size_t n_arms, uint64_t seed,
                     uint64_t round, const struct rl_progress *progress, struct rl_error *error)
{
    size_t order[RL_TIMING_ARMS_MAX];
    shuffle(order, n_arms, seed, round);
    for (size_t i = 0; i < n_arms; i++) {
        const struct rl_timing_arm *a = &arm[order[i]];
        int status = a->frame(a->user, &seconds[order[i]], error);
        if (status != RL_OK) {
            rl_fail_prefix(error, "%s", a->name);
            return status;
        }
        /* CLOCK_MONOTONIC is not set back, but a machine that is moved while it runs may have one that is. */
        if (!(seconds[order[i]] >= 0.0 && seconds[order[i]] < INFINITY))
            return rl_fail(error, RL_ERR_SYSTEM,
                           "%s: found a frame of %g s, expected 0 or more: the clock went back", a->name,
                           seconds[order[i]]);
        if (rl_progress_cancelled(progress)) {
            rl_error_set(error, RL_ERR_CANCELLED, "interrupted while timing");
            return RL_ERR_CANCELLED;
        }
    }
    return RL_OK;
}

/* Of fewer than six rounds the interval is infinite (statistics.h), and of frames that take no time by the clock, whose tick is then
 * longer than they are, nothing is known relative to it: neither is precise. */
static bool precise(const struct rl_timing *timing, double precision)
{
    for (size_t i = 0; i < timing->n_arms; i++) {
        struct rl_interval m = rl_median_interval(timing->ms[i], timing->n_rounds, 0.95);
        if (!(m.value > 0.0 && fmax(m.high - m.value, m.value - m.low) <= precision * m.value))
            return false;
    }
    return true;
}

int rl_timing_run(struct rl_timing *timing, const struct rl_timing_arm *arm, size_t n_arms,
                  const struct rl_timing_options *options, const struct rl_progress *progress,
                  struct rl_error *error)
{
    *timing = (struct rl_timing){0};
    if (n_arms < 1 || n_arms > RL_TIMING_ARMS_MAX || options->min_rounds < 1 ||
        options->max_rounds < options->min_rounds)
        return rl_fail(error, RL_ERR_INPUT,
                       "timing: %zu arms and %d to %d rounds, expected 1 to %d arms, 1 round or more", n_arms,
                       options->min_rounds, options->max_rounds, RL_TIMING_ARMS_MAX);
    int status = allocate(timing, n_arms, (size_t)options->max_rounds, error);
    double start = rl_clock_seconds();
    uint64_t turn = 0;
    for (int round = -options->warm_up; status == RL_OK && round < options->max_rounds; round++) {
        double seconds[RL_TIMING_ARMS_MAX] = {0.0};
        status = one_round(seconds, arm, n_arms, options->seed, turn++, progress, error);
        if (status != RL_OK || round < 0)
            continue;
        for (size_t i = 0; i < n_arms; i++)
            timing->ms[i][timing->n_rounds] = 1000.0 * seconds[i];
        timing->n_rounds++;
        if (timing->n_rounds >= (size_t)options->min_rounds &&
            (rl_clock_seconds() - start > options->max_seconds || precise(timing, options->precision)))
            break;
    }
    if (status != RL_OK)
        rl_timing_clear(timing);
    return status;
}
