/* Draws, subtracts and splits pictures of several seeds (see seeds.h). */
#include "studies/seeds.h"

#include <math.h>

#include "measure/statistics.h"

double rl_root(double x)
{
    return isnan(x) ? x : sqrt(fmax(x, 0.0)); /* fmax would make 0 of NaN */
}

static int check_number(double n, struct rl_error *error)
{
    if (n >= 1.0 && n <= RL_SEEDS_MAX && n == floor(n))
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "found %g seeds, expected a whole number from 1 to %d", n,
                   RL_SEEDS_MAX);
}

int rl_seeds_check(const char *parameters, struct rl_error *error)
{
    return check_number(rl_parameter_number(parameters, "seeds"), error);
}

int rl_seeds_draw(struct rl_seeds *s, struct rl_bench *bench, struct rl_bench_scene *set, double n,
                  struct rl_error *error)
{
    int status = check_number(n, error);
    while (s->n < (size_t)n && status == RL_OK) {
        if (rl_progress_cancelled(&bench->quiet))
            return rl_fail(error, RL_ERR_CANCELLED, "interrupted; what was finished is kept");
        enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_SETUP);
        status = rl_gpu_scene_reseed(set->gpu_scene, s->n + 1, error);
        rl_spent_on(&bench->spent, outer);
        if (status == RL_OK)
            status = rl_bench_draw(&s->image[s->n++], bench, set, error);
    }
    return status;
}

int rl_seeds_draw_case(struct rl_seeds *s, struct rl_bench *bench, const struct rl_scene *scene,
                       const char *parameters, struct rl_error *error)
{
    struct rl_bench_scene *set = NULL;
    int status = rl_bench_scene_make(&set, bench, scene, parameters, 1, error);
    if (status == RL_OK)
        status = rl_seeds_draw(s, bench, set, rl_parameter_number(parameters, "seeds"), error);
    rl_bench_scene_free(set);
    return status;
}

void rl_seeds_clear(struct rl_seeds *s)
{
    for (size_t k = 0; k < s->n; k++)
        rl_image_clear(&s->image[k]);
    s->n = 0;
}

static int subtract(struct rl_image *out, const struct rl_image *a, const struct rl_image *b,
                    struct rl_error *error)
{
    if (a->width != b->width || a->height != b->height || a->channels != 4 || b->channels != 4)
        return rl_fail(error, RL_ERR_INPUT,
                       "a difference of %d x %d pixels and %d x %d: expected R, G, B, A of the same size",
                       a->width, a->height, b->width, b->height);
    int status = rl_image_allocate(out, a->width, a->height, 4, error);
    if (status != RL_OK)
        return status;
    size_t n = (size_t)a->width * (size_t)a->height * 4;
    for (size_t i = 0; i < n; i++)
        out->data[i] = i % 4 == 3 ? fminf(a->data[i], b->data[i]) : a->data[i] - b->data[i];
    return RL_OK;
}

int rl_seeds_difference(struct rl_seeds *difference, const struct rl_seeds *a, const struct rl_seeds *b,
                        struct rl_error *error)
{
    int status = RL_OK;
    while (difference->n < a->n && difference->n < b->n && status == RL_OK) {
        size_t k = difference->n++;
        status = subtract(&difference->image[k], &a->image[k], &b->image[k], error);
    }
    return status;
}

/* Black and covered everywhere. */
static int make_zero(struct rl_image *zero, const struct rl_image *like, struct rl_error *error)
{
    int status = rl_image_allocate(zero, like->width, like->height, 4, error);
    size_t n = status == RL_OK ? (size_t)like->width * (size_t)like->height : 0;
    for (size_t i = 0; i < n; i++)
        zero->data[4 * i + 3] = 1.0f;
    return status;
}

int rl_seeds_split(struct rl_bias_variance *split, const struct rl_seeds *s, const struct rl_image *reference,
                   struct rl_error *error)
{
    struct rl_image zero = {0};
    const struct rl_image *pointer[RL_SEEDS_MAX];
    for (size_t k = 0; k < s->n; k++)
        pointer[k] = &s->image[k];
    int status = reference ? RL_OK : make_zero(&zero, &s->image[0], error);
    if (!reference)
        reference = &zero;
    if (status == RL_OK && s->n > 1) {
        status = rl_bias_variance_compute(split, pointer, s->n, reference, error);
    } else if (status == RL_OK) {
        struct rl_metrics m;
        status = rl_metrics_compute(&m, &s->image[0], reference, error);
        if (status == RL_OK && m.nonfinite > 0)
            status = rl_fail(error, RL_ERR_CHECK, "%zu values are not finite", m.nonfinite);
        double mse = m.rmse * m.rmse;
        *split = (struct rl_bias_variance){.bias2 = mse, .bias2_low = mse, .bias2_high = mse, .mse = mse};
    }
    rl_image_clear(&zero);
    return status;
}

/* Adds metrics until one fails; later calls do nothing. */
struct adder {
    struct rl_record *record;
    struct rl_error *error;
    int status;
    double tolerance; /* of a reference's pixels, and so of every mean over them */
};

static void add(struct adder *a, const char *name, double value, double low, double high, const char *unit)
{
    if (a->status == RL_OK)
        a->status = rl_record_metric_add(a->record, name, value, low, high, unit, a->error);
}

/* The mean over seeds, with its interval where there are several; one picture alone is as sure as the reference. */
static struct rl_interval over_seeds(const double *value, size_t n, double tolerance)
{
    if (n == 1)
        return (struct rl_interval){value[0], value[0] - tolerance, value[0] + tolerance};
    return rl_mean_interval(value, n, 0.95);
}

/* The square of a root mean square that is known to the tolerance. */
static struct rl_interval widened(double square, double tolerance)
{
    double root = rl_root(square), low = fmax(root - tolerance, 0.0), high = root + tolerance;
    return (struct rl_interval){square, low * low, high * high};
}

static struct rl_interval squares_over_seeds(const double *square, size_t n, double tolerance)
{
    return n == 1 ? widened(square[0], tolerance) : rl_mean_interval(square, n, 0.95);
}

static void add_root(struct adder *a, const char *name, struct rl_interval square)
{
    add(a, name, rl_root(square.value), rl_root(square.low), rl_root(square.high), "1");
}

/* RMSE, bias and so on of each seed's picture, and their mean. */
static int add_metrics(struct adder *a, const struct rl_seeds *s, const struct rl_image *truth)
{
    double mse[RL_SEEDS_MAX], mae[RL_SEEDS_MAX], bias[RL_SEEDS_MAX], relmse[RL_SEEDS_MAX], largest = 0.0;
    struct rl_metrics m = {0};
    for (size_t k = 0; k < s->n; k++) {
        int status = rl_metrics_compute(&m, &s->image[k], truth, a->error);
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
    add_root(a, "rmse", squares_over_seeds(mse, s->n, a->tolerance));
    struct rl_interval i = over_seeds(mae, s->n, a->tolerance);
    add(a, "mae", i.value, i.low, i.high, "1");
    i = over_seeds(bias, s->n, a->tolerance);
    add(a, "bias", i.value, i.low, i.high, "1");
    i = over_seeds(relmse, s->n, 0.0);
    add(a, "relmse", i.value, i.low, i.high, "1");
    add(a, "max", largest, largest, largest, "1");
    add(a, "pixels", (double)m.pixels, (double)m.pixels, (double)m.pixels, "px");
    add(a, "mismatched", (double)m.mismatched, (double)m.mismatched, (double)m.mismatched, "px");
    return a->status;
}

static int add_centre(struct adder *a, const struct rl_seeds *s, const struct rl_image *centre)
{
    double mse[RL_SEEDS_MAX];
    for (size_t k = 0; k < s->n; k++) {
        struct rl_metrics m;
        int status = rl_metrics_compute(&m, &s->image[k], centre, a->error);
        if (status != RL_OK)
            return status;
        mse[k] = m.rmse * m.rmse;
    }
    add_root(a, "rmse_centre", squares_over_seeds(mse, s->n, a->tolerance));
    return a->status;
}

/* Noise and floor: what more samples would average out and what they would not; and the floor that is left when the reference
 * too sees the lights from the object's centre, which takes the map's parallax out of it. */
static int add_split(struct adder *a, const struct rl_seeds *s, const struct rl_image *truth,
                     const struct rl_image *centre)
{
    struct rl_bias_variance t, c;
    struct rl_metrics parallax;
    int status = rl_seeds_split(&t, s, truth, a->error);
    if (status == RL_OK)
        status = rl_seeds_split(&c, s, centre, a->error);
    if (status == RL_OK)
        status = rl_metrics_compute(&parallax, centre, truth, a->error);
    if (status != RL_OK)
        return status;
    struct rl_interval bias2 = {t.bias2, t.bias2_low, t.bias2_high},
                       centre2 = {c.bias2, c.bias2_low, c.bias2_high};
    if (s->n == 1) {
        bias2 = widened(t.bias2, a->tolerance);
        centre2 = widened(c.bias2, a->tolerance);
    }
    add(a, "bias2", bias2.value, bias2.low, bias2.high, "1");
    add(a, "variance", t.variance, t.variance_low, t.variance_high, "1");
    add_root(a, "floor", bias2);
    add_root(a, "noise", (struct rl_interval){t.variance, t.variance_low, t.variance_high});
    add_root(a, "floor_centre", centre2);
    /* Either reference may be off by the tolerance. */
    add_root(a, "parallax", widened(parallax.rmse * parallax.rmse, 2.0 * a->tolerance));
    return a->status;
}

int rl_seeds_add_error(struct rl_record *record, const struct rl_seeds *s, const struct rl_image *truth,
                       const struct rl_image *centre, struct rl_error *error)
{
    double tolerance = rl_parameter_number(record->parameters, "tolerance");
    struct adder a = {record, error, RL_OK, isnan(tolerance) ? 0.0 : tolerance};
    int status = add_metrics(&a, s, truth);
    if (status == RL_OK)
        status = add_centre(&a, s, centre);
    return status == RL_OK ? add_split(&a, s, truth, centre) : status;
}
