/* See timing_arms.h. */
#include "studies/timing_arms.h"

#include <math.h>

int rl_arms_frame(void *user, double *seconds, struct rl_error *error)
{
    const struct rl_bench_scene *set = user;
    return rl_gpu_scene_frame(set->gpu_scene, seconds, error);
}

/* The first record that has these parameters; n if there is none, or none is wanted. */
static size_t find(const struct rl_record *records, size_t n, const char *pattern)
{
    size_t i = 0;
    while (pattern && i < n && !rl_parameters_match(records[i].parameters, pattern))
        i++;
    return pattern ? i : n;
}

/* One arm's own figures. How precise the median is depends on the clock, as it does: time_precision, time_capped. */
static int add_own(struct rl_record *r, const struct rl_timing *t, size_t i, double precision,
                   struct rl_error *error)
{
    struct rl_interval ms = rl_interval_from_0(rl_median_interval(t->ms[i], t->n_rounds, 0.95));
    /* Relative to 0 nothing is precise. */
    double reached = ms.value > 0.0 ? fmax(ms.high - ms.value, ms.value - ms.low) / ms.value : INFINITY;
    int status = rl_record_add(r, "frame_ms", ms, "ms", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "frames", (double)t->n_rounds, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "time_precision", reached, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "time_capped", reached > precision, "1", error);
    return status == RL_OK ? rl_record_series_add(r, "frame_ms", t->ms[i], t->n_rounds, error) : status;
}

static struct rl_interval ratio(const struct rl_timing *t, size_t a, size_t b)
{
    return rl_interval_from_0(rl_ratio_interval(t->ms[a], t->ms[b], t->n_rounds, 0.95));
}

static int add_figures(struct rl_record *records, size_t n, const struct rl_timing *t,
                       const struct rl_arms_options *options, double precision, struct rl_error *error)
{
    size_t baseline = find(records, n, options->baseline), against = find(records, n, options->against),
           against2 = find(records, n, options->against2);
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        status = add_own(&records[i], t, i, precision, error);
        if (status == RL_OK && baseline < n)
            status = rl_record_add(&records[i], "above_baseline_ms",
                                   rl_difference_interval(t->ms[i], t->ms[baseline], t->n_rounds, 0.95), "ms",
                                   error);
        if (status == RL_OK && against < n)
            status = rl_record_add(&records[i], options->ratio, ratio(t, i, against), "1", error);
        if (status == RL_OK && against2 < n)
            status = rl_record_add(&records[i], options->ratio2, ratio(t, i, against2), "1", error);
        if (status == RL_OK && against < n && options->difference)
            status = rl_record_add(&records[i], options->difference,
                                   rl_difference_interval(t->ms[i], t->ms[against], t->n_rounds, 0.95), "ms",
                                   error);
    }
    return status;
}

int rl_arms_time(struct rl_record *records, const struct rl_timing_arm *arm, size_t n, struct rl_bench *bench,
                 const struct rl_arms_options *options, struct rl_error *error)
{
    struct rl_timing_options timing_options = RL_TIMING_DEFAULT;
    timing_options.min_rounds = options->frames;
    timing_options.max_rounds = options->most_frames;
    timing_options.max_seconds = options->most_seconds;
    struct rl_timing timing;
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    int status = rl_timing_run(&timing, arm, n, &timing_options, &bench->quiet, error);
    rl_spent_on(&bench->spent, outer);
    if (status != RL_OK)
        return status;
    status = add_figures(records, n, &timing, options, timing_options.precision, error);
    rl_timing_clear(&timing);
    return status;
}

double rl_arms_noise(const struct rl_metric *ratio)
{
    return ratio ? fmax(ratio->high - 1.0, 1.0 - ratio->low) : NAN;
}

enum rl_verdict rl_arms_at_most(const struct rl_metric *ratio, double noise, double bound)
{
    return ratio && !isnan(noise) ? rl_verdict_at_most(ratio->low - noise, ratio->high + noise, bound)
                                  : RL_VERDICT_INCONCLUSIVE;
}
