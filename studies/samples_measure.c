/* Measures the cases of the study `samples`: pictures of every seed against the reference, then frame times. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "measure/metrics.h"
#include "measure/statistics.h"
#include "measure/timing.h"
#include "studies/samples.h"

enum { SEEDS_MAX = 64, ARMS_MAX = 2 };

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

/* Noise and floor: what more seeds would average out and what they would not. One picture of a fixed pattern has no noise. */
static int add_split(struct adder *a, const struct rl_image *image, size_t n,
                     const struct rl_image *reference)
{
    struct rl_bias_variance s = {0};
    if (n == 1) {
        const struct rl_metric *rmse = rl_record_metric(a->record, "rmse");
        s.mse = s.bias2 = s.bias2_low = s.bias2_high = rmse->value * rmse->value;
    } else {
        const struct rl_image *pointer[SEEDS_MAX];
        for (size_t k = 0; k < n; k++)
            pointer[k] = &image[k];
        int status = rl_bias_variance_compute(&s, pointer, n, reference, a->error);
        if (status != RL_OK)
            return status;
    }
    add(a, "bias2", s.bias2, s.bias2_low, s.bias2_high, "1");
    add(a, "variance", s.variance, s.variance_low, s.variance_high, "1");
    add(a, "floor", root(s.bias2), root(s.bias2_low), root(s.bias2_high), "1");
    add(a, "noise", root(s.variance), root(s.variance_low), root(s.variance_high), "1");
    return a->status;
}

/* One case's pictures, a seed each. */
struct pictures {
    size_t n;
    struct rl_image image[SEEDS_MAX];
};

static void clear_pictures(struct pictures *p)
{
    for (size_t k = 0; k < p->n; k++)
        rl_image_clear(&p->image[k]);
    p->n = 0;
}

/* Draws the pictures of all seeds; the scene of the last one is handed on to be timed. */
static int draw(struct pictures *p, struct rl_bench_scene **last, struct rl_bench *bench,
                const struct rl_scene *scene, const struct rl_record *r, struct rl_error *error)
{
    double seeds = rl_parameter_number(r->parameters, "seeds");
    *p = (struct pictures){0};
    if (!(seeds >= 1.0 && seeds <= SEEDS_MAX))
        return rl_fail(error, RL_ERR_INPUT, "seeds=%g: expected 1 to %d", seeds, SEEDS_MAX);
    int status = RL_OK;
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

/* Draws a case and holds it against the reference. The pictures are the caller's to clear, whatever is returned. */
static int measure_error(struct pictures *p, struct rl_record *r, struct rl_bench_scene **last,
                         struct rl_bench *bench, const struct rl_scene *scene, struct rl_error *error)
{
    int status = draw(p, last, bench, scene, r, error);
    const struct rl_image *reference = NULL;
    if (status == RL_OK)
        status = rl_bench_reference(&reference, bench, scene, r->parameters, error);
    struct adder a = {r, error, RL_OK};
    if (status == RL_OK)
        status = add_metrics(&a, p->image, p->n, reference);
    return status == RL_OK ? add_split(&a, p->image, p->n, reference) : status;
}

/* Turns the pictures into their differences to `best`, seed by seed, and `best`'s first into black: what the differences are
 * to be held against. */
static void subtract(struct pictures *p, const struct pictures *best, struct rl_image *black)
{
    size_t n = (size_t)black->width * (size_t)black->height;
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < p->n; k++)
            for (int c = 0; c < 3; c++)
                p->image[k].data[4 * i + (size_t)c] -= best->image[k].data[4 * i + (size_t)c];
        for (int c = 0; c < 3; c++)
            black->data[4 * i + (size_t)c] = 0.0f;
        black->data[4 * i + 3] = best->image[0].data[4 * i + 3];
    }
}

/* What the map's size alone does: bias of the difference to the same normals' picture with the largest map. */
static int add_texel_error(struct rl_record *r, struct pictures *p, const struct pictures *best,
                           struct rl_error *error)
{
    struct rl_image black = {0};
    int status = rl_image_allocate(&black, best->image[0].width, best->image[0].height, 4, error);
    if (status != RL_OK)
        return status;
    subtract(p, best, &black);
    const struct rl_image *pointer[SEEDS_MAX];
    for (size_t k = 0; k < p->n; k++)
        pointer[k] = &p->image[k];
    struct rl_bias_variance s;
    status = rl_bias_variance_compute(&s, pointer, p->n, &black, error);
    rl_image_clear(&black);
    if (status != RL_OK)
        return status;
    return rl_record_metric_add(r, "texel_error", root(s.bias2), root(s.bias2_low), root(s.bias2_high), "1",
                                error);
}

/* A group of map sizes, the largest last: it is drawn first, and the others are compared with it. */
static int measure_floor(struct rl_record *records, size_t n, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error)
{
    struct pictures *best = calloc(2, sizeof *best);
    if (!best)
        return rl_fail_memory(error, "pictures");
    struct pictures *other = best + 1;
    struct rl_bench_scene *set = NULL;
    int status = measure_error(best, &records[n - 1], &set, bench, scene, error);
    for (size_t i = 0; i + 1 < n && status == RL_OK; i++) {
        status = measure_error(other, &records[i], &set, bench, scene, error);
        if (status == RL_OK)
            status = add_texel_error(&records[i], other, best, error);
        clear_pictures(other);
    }
    clear_pictures(best);
    rl_bench_scene_free(set);
    free(best);
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
    options.max_seconds = 0.05 * rounds;
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

/* The methods at one N. */
static int measure_methods(struct rl_record *records, size_t n, struct rl_bench *bench,
                           const struct rl_scene *scene, struct rl_error *error)
{
    struct pictures *pictures = calloc(1, sizeof *pictures);
    if (!pictures)
        return rl_fail_memory(error, "pictures");
    struct rl_bench_scene *set[ARMS_MAX] = {NULL};
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        status = measure_error(pictures, &records[i], &set[i], bench, scene, error);
        clear_pictures(pictures);
    }
    if (status == RL_OK)
        status = measure_time(records, set, n, bench, error);
    for (size_t i = 0; i < n; i++)
        rl_bench_scene_free(set[i]);
    free(pictures);
    return status;
}

int rl_samples_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                       const struct rl_scene *scene, struct rl_error *error)
{
    if (rl_parameters_match(records[0].parameters, "series=floor"))
        return measure_floor(records, n, bench, scene, error);
    if (n > ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, at most %d are timed together", n,
                       ARMS_MAX);
    return measure_methods(records, n, bench, scene, error);
}
