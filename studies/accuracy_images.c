/* Measures the images of the study `accuracy` (see accuracy.h). */
#include <time.h>

#include "base/machine.h"
#include "measure/timing.h"
#include "reference/renderer.h"
#include "studies/accuracy.h"

enum { ROUNDS_MAX = 64 };

struct arm {
    const struct rl_scene *scene;
    struct rl_bench *bench;
    struct rl_plan plan;
    int threads;
    struct rl_render_stats stats; /* of the last image */
    size_t rounds;                /* drawn so far */
    double others[ROUNDS_MAX];    /* cores that other programs took meanwhile */
};

/* Seconds on the cores of this process that were not its own. */
static double seconds_of_others(void)
{
    struct timespec own;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
    return rl_machine_busy_seconds() - ((double)own.tv_sec + 1e-9 * (double)own.tv_nsec);
}

static int draw(void *user, double *seconds, struct rl_error *error)
{
    struct arm *arm = user;
    struct rl_image image;
    double before = seconds_of_others();
    int status = rl_reference_render(&image, &arm->stats, arm->scene, &arm->plan, arm->threads,
                                     &arm->bench->quiet, error);
    if (status != RL_OK)
        return status;
    rl_image_clear(&image);
    *seconds = arm->stats.seconds;
    arm->others[arm->rounds++] = (seconds_of_others() - before) / *seconds;
    return RL_OK;
}

static int store(struct rl_record *r, const struct arm *arm, double *ms, size_t n, struct rl_error *error)
{
    for (size_t i = 0; i < n; i++)
        ms[i] /= 1000.0;
    struct rl_interval seconds = rl_interval_from_0(rl_median_interval(ms, n, 0.95));
    const struct rl_render_stats *s = &arm->stats;
    int status = rl_record_series_add(r, "seconds", ms, n, error);
    if (status == RL_OK)
        status = rl_record_series_add(r, "others", arm->others, n, error);
    if (status == RL_OK)
        status = rl_record_add(r, "seconds", seconds, "s", error);
    if (status == RL_OK && s->texels > 0) {
        double texels = (double)s->texels;
        struct rl_interval rate = {texels / seconds.value, texels / seconds.high, texels / seconds.low};
        return rl_record_add(r, "texel_normals", rate, "1/s", error);
    }
    const struct {
        const char *name, *unit;
        double x;
    } metric[] = {{"worst_error", "1", s->worst_error},
                  {"unconverged", "px", (double)s->unconverged},
                  {"lines", "1", (double)s->evaluations}};
    for (size_t i = 0; i < sizeof metric / sizeof metric[0] && status == RL_OK; i++)
        status = rl_record_add_exact(r, metric[i].name, metric[i].x, metric[i].unit, error);
    return status;
}

static int time_images(struct rl_record *records, struct arm *arm, size_t n, struct rl_error *error)
{
    struct rl_timing_arm timed[RL_TIMING_ARMS_MAX];
    for (size_t i = 0; i < n; i++)
        timed[i] = (struct rl_timing_arm){records[i].parameters, draw, &arm[i]};
    struct rl_timing_options options = RL_TIMING_DEFAULT;
    options.warm_up = 0; /* nothing is compiled, and an image takes long enough to warm up by itself */
    double rounds = rl_parameter_number(records[0].parameters, "rounds");
    if (!(rounds >= 1.0 && rounds <= ROUNDS_MAX))
        return rl_fail(error, RL_ERR_INPUT, "rounds=%g: expected 1 to %d", rounds, ROUNDS_MAX);
    options.min_rounds = options.max_rounds = (int)rounds;
    struct rl_timing timing;
    enum rl_spent_kind outer = rl_spent_on(&arm[0].bench->spent, RL_SPENT_MEASURED);
    int status = rl_timing_run(&timing, timed, n, &options, &arm[0].bench->quiet, error);
    rl_spent_on(&arm[0].bench->spent, outer);
    if (status != RL_OK)
        return status;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = store(&records[i], &arm[i], timing.ms[i], timing.n_rounds, error);
    rl_timing_clear(&timing);
    return status;
}

static int arm_make(struct arm *arm, const struct rl_record *r, struct rl_bench *bench,
                    const struct rl_scene *scene, struct rl_error *error)
{
    struct rl_settings settings;
    *arm = (struct arm){
        .scene = scene, .bench = bench, .threads = (int)rl_parameter_number(r->parameters, "threads")};
    int status = rl_bench_settings(&settings, r->parameters, error);
    return status == RL_OK ? rl_plan_make(&arm->plan, scene, &settings, error) : status;
}

int rl_accuracy_measure_images(struct rl_record *records, size_t n, struct rl_bench *bench,
                               const struct rl_scene *scene, struct rl_error *error)
{
    struct arm arm[RL_TIMING_ARMS_MAX];
    if (n > RL_TIMING_ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, at most %d are timed together", n,
                       RL_TIMING_ARMS_MAX);
    size_t made = 0;
    int status = RL_OK;
    while (made < n && status == RL_OK) {
        status = arm_make(&arm[made], &records[made], bench, scene, error);
        made += status == RL_OK;
    }
    if (status == RL_OK)
        status = time_images(records, arm, n, error);
    for (size_t i = 0; i < made; i++)
        rl_plan_clear(&arm[i].plan);
    return status;
}
