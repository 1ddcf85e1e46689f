/* Measures the cases of the study `samples`: pictures of every seed against the reference, then frame times. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "measure/metrics.h"
#include "measure/statistics.h"
#include "measure/timing.h"
#include "studies/samples.h"

enum { SEEDS_MAX = 64, ARMS_MAX = RL_TIMING_ARMS_MAX };

/* Adds metrics until one fails; later calls do nothing. */
struct adder {
    struct rl_record *record;
    struct rl_error *error;
    int status;
};

static void add(struct adder *a, const char *name, double value, double low, double high, const char *unit)
{
    if (a->status == RL_OK)
        a->status = rl_record_metric_add(a->record, name, value, low, high, unit, a->error);
}

/* The mean over seeds, with its interval where there are several. */
static struct rl_interval over_seeds(const double *value, size_t n)
{
    if (n == 1)
        return (struct rl_interval){value[0], value[0], value[0]};
    return rl_mean_interval(value, n, 0.95);
}

static double root(double x)
{
    return sqrt(fmax(x, 0.0));
}

/* RMSE, bias and so on of each seed's picture, and their mean. */
static int add_metrics(struct adder *a, const struct rl_image *image, size_t n,
                       const struct rl_image *reference)
{
    double mse[SEEDS_MAX], mae[SEEDS_MAX], bias[SEEDS_MAX], relmse[SEEDS_MAX], largest = 0.0;
    struct rl_metrics m = {0};
    for (size_t k = 0; k < n; k++) {
        int status = rl_metrics_compute(&m, &image[k], reference, a->error);
        if (status != RL_OK)
            return status;
        if (m.nonfinite > 0)
            return rl_fail(a->error, RL_ERR_CHECK, "%zu values are not finite", m.nonfinite);
        mse[k] = m.rmse * m.rmse;
        mae[k] = m.mae;
        bias[k] = m.bias;
        relmse[k] = m.relmse;
        largest = fmax(largest, m.max);
    }
    struct rl_interval i = over_seeds(mse, n);
    add(a, "rmse", root(i.value), root(i.low), root(i.high), "1");
    i = over_seeds(mae, n);
    add(a, "mae", i.value, i.low, i.high, "1");
    i = over_seeds(bias, n);
    add(a, "bias", i.value, i.low, i.high, "1");
    i = over_seeds(relmse, n);
    add(a, "relmse", i.value, i.low, i.high, "1");
    add(a, "max", largest, largest, largest, "1");
    add(a, "pixels", (double)m.pixels, (double)m.pixels, (double)m.pixels, "px");
    add(a, "mismatched", (double)m.mismatched, (double)m.mismatched, (double)m.mismatched, "px");
    return a->status;
}

/* Squared error over seeds, split. One picture of a fixed pattern has no noise: all its error is bias. */
static int split(struct rl_bias_variance *s, const struct rl_image *image, size_t n,
                 const struct rl_image *reference, struct rl_error *error)
{
    const struct rl_image *pointer[SEEDS_MAX];
    for (size_t k = 0; k < n; k++)
        pointer[k] = &image[k];
    if (n > 1)
        return rl_bias_variance_compute(s, pointer, n, reference, error);
    struct rl_metrics m;
    int status = rl_metrics_compute(&m, image, reference, error);
    double mse = m.rmse * m.rmse;
    *s = (struct rl_bias_variance){.bias2 = mse, .bias2_low = mse, .bias2_high = mse, .mse = mse};
    return status;
}

/* Noise and floor: what more samples would average out and what they would not; and the floor that is left when the reference
 * too sees the lights from the object's centre, which takes the map's parallax out of it. */
static int add_split(struct adder *a, const struct rl_image *image, size_t n, const struct rl_image *truth,
                     const struct rl_image *centre)
{
    struct rl_bias_variance s, c;
    struct rl_metrics parallax;
    int status = split(&s, image, n, truth, a->error);
    if (status == RL_OK)
        status = split(&c, image, n, centre, a->error);
    if (status == RL_OK)
        status = rl_metrics_compute(&parallax, centre, truth, a->error);
    if (status != RL_OK)
        return status;
    add(a, "bias2", s.bias2, s.bias2_low, s.bias2_high, "1");
    add(a, "variance", s.variance, s.variance_low, s.variance_high, "1");
    add(a, "floor", root(s.bias2), root(s.bias2_low), root(s.bias2_high), "1");
    add(a, "noise", root(s.variance), root(s.variance_low), root(s.variance_high), "1");
    add(a, "floor_centre", root(c.bias2), root(c.bias2_low), root(c.bias2_high), "1");
    add(a, "parallax", parallax.rmse, parallax.rmse, parallax.rmse, "1");
    return a->status;
}

/* One case's pictures, a seed each. */
struct pictures {
    size_t n;
    struct rl_image image[SEEDS_MAX];
};

int rl_samples_check(const char *parameters, struct rl_error *error)
{
    double seeds = rl_parameter_number(parameters, "seeds");
    if (seeds >= 1.0 && seeds <= SEEDS_MAX)
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "found %g seeds, expected 1 to %d", seeds, SEEDS_MAX);
}

/* Draws the pictures of all seeds; the scene of the last one is handed on to be timed. */
static int draw(struct pictures *p, struct rl_bench_scene **last, struct rl_bench *bench,
                const struct rl_scene *scene, const struct rl_record *r, struct rl_error *error)
{
    double seeds = rl_parameter_number(r->parameters, "seeds");
    p->n = 0;
    memset(p->image, 0, sizeof p->image);
    int status = rl_samples_check(r->parameters, error);
    while (p->n < (size_t)seeds && status == RL_OK) {
        if (rl_progress_cancelled(&bench->quiet))
            return rl_fail(error, RL_ERR_CANCELLED, "interrupted; what was finished is kept");
        rl_bench_scene_free(*last);
        double seconds = 0.0;
        status = rl_bench_scene_make(last, bench, scene, r->parameters, p->n + 1, error);
        if (status == RL_OK)
            status = rl_gpu_scene_frame((*last)->gpu_scene, &seconds, error);
        if (status == RL_OK)
            status = rl_gpu_scene_read((*last)->gpu_scene, &p->image[p->n++], error);
    }
    return status;
}

/* Draws a case and holds it against the references. */
static int measure_error(struct rl_record *r, struct rl_bench_scene **last, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error)
{
    struct pictures p;
    const struct rl_image *truth = NULL, *centre = NULL;
    int status = draw(&p, last, bench, scene, r, error);
    if (status == RL_OK)
        status = rl_bench_reference(&truth, bench, scene, r->parameters, RL_LIGHT_FROM_POINT, error);
    if (status == RL_OK)
        status = rl_bench_reference(&centre, bench, scene, r->parameters, RL_LIGHT_FROM_OBJECT, error);
    struct adder a = {r, error, RL_OK};
    if (status == RL_OK)
        status = add_metrics(&a, p.image, p.n, truth);
    if (status == RL_OK)
        status = add_split(&a, p.image, p.n, truth, centre);
    for (size_t k = 0; k < p.n; k++)
        rl_image_clear(&p.image[k]);
    return status;
}

static int frame(void *user, double *seconds, struct rl_error *error)
{
    const struct rl_bench_scene *set = user;
    return rl_gpu_scene_frame(set->gpu_scene, seconds, error);
}

/* The arms of a group against each other. The first frame of each has been drawn already. */
static int measure_time(struct rl_record *records, struct rl_bench_scene **set, size_t n,
                        struct rl_bench *bench, struct rl_error *error)
{
    int rounds = (int)rl_parameter_number(records[0].parameters, "rounds");
    if (rounds < 1)
        return RL_OK;
    struct rl_timing_options options = RL_TIMING_DEFAULT;
    options.warm_up = 1;
    options.min_rounds = rounds;
    options.max_rounds = 4 * rounds;
    options.max_seconds = 0.4 * rounds;
    struct rl_timing_arm arm[ARMS_MAX];
    for (size_t i = 0; i < n; i++)
        arm[i] = (struct rl_timing_arm){records[i].parameters, frame, set[i]};
    struct rl_timing timing;
    int status = rl_timing_run(&timing, arm, n, &options, &bench->quiet, error);
    if (status != RL_OK)
        return status;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        struct rl_interval ms = rl_median_interval(timing.ms[i], timing.n_rounds, 0.95);
        status = rl_record_metric_add(&records[i], "frame_ms", ms.value, ms.low, ms.high, "ms", error);
        if (status == RL_OK)
            status = rl_record_series_add(&records[i], "frame_ms", timing.ms[i], timing.n_rounds, error);
    }
    rl_timing_clear(&timing);
    return status;
}

int rl_samples_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                       const struct rl_scene *scene, struct rl_error *error)
{
    if (n > ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, at most %d are timed together", n,
                       ARMS_MAX);
    struct rl_bench_scene *set[ARMS_MAX] = {NULL};
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = measure_error(&records[i], &set[i], bench, scene, error);
    if (status == RL_OK)
        status = measure_time(records, set, n, bench, error);
    for (size_t i = 0; i < n; i++)
        rl_bench_scene_free(set[i]);
    return status;
}
