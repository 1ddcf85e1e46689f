/* Measures the arms of the study `budget` (see budget.h).
 *
 *     sampling, normals, map, format, sphere, frame    against the base, seed by seed
 *     base                                             against the reference that sees the lights from the object's centre
 *     parallax                                         that reference against the one that sees them from each point
 *     bits                                             the latter rounded to steps of 1/255 against itself
 *     all                                              pictures rounded so against the latter
 */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "measure/metrics.h"
#include "measure/statistics.h"
#include "studies/budget.h"
#include "studies/seeds.h"

enum { ARMS_MAX = 16 };

struct truth {
    struct rl_seeds base;
    const struct rl_image *point, *centre; /* references */
};

/* Squared error and bias of every seed; those without chance have the same for all. What is held against references is as sure as
 * they are: each value, and so the RMSE, may be off by `slack`. */
struct errors {
    size_t n;
    double mse[RL_SEEDS_MAX], bias[RL_SEEDS_MAX];
    double slack;
};

static bool is_arm(const struct rl_record *r, const char *arm)
{
    char name[RL_NAME_MAX];
    rl_parameter(r->parameters, "arm", name, sizeof name);
    return strcmp(name, arm) == 0;
}

static int take(struct errors *e, size_t k, const struct rl_image *image, const struct rl_image *against,
                struct rl_error *error)
{
    struct rl_metrics m;
    int status = rl_metrics_compute(&m, image, against, error);
    if (status == RL_OK && m.nonfinite > 0)
        status = rl_fail(error, RL_ERR_CHECK, "%zu values are not finite", m.nonfinite);
    e->mse[k] = m.rmse * m.rmse;
    e->bias[k] = m.bias;
    return status;
}

/* A seed's squared error at least (way -1) and at most (way 1); 0: as it was found. */
static double mse_at(const struct errors *e, size_t k, int way)
{
    double rmse = fmax(0.0, rl_root(e->mse[k]) + way * e->slack);
    return way == 0 ? e->mse[k] : rmse * rmse;
}

/* From the least to the most: over seeds, and by what references leave open. */
static struct rl_interval hull(const double least[], const double value[], const double most[], size_t n)
{
    struct rl_interval middle = rl_mean_interval(value, n, 0.95);
    return (struct rl_interval){middle.value, rl_mean_interval(least, n, 0.95).low,
                                rl_mean_interval(most, n, 0.95).high};
}

/* As a frame buffer of 8 bits stores it, without gamma. Alpha stays. */
static void round_to_bits(struct rl_image *image)
{
    size_t n = 4 * (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < n; i++)
        if (i % 4 != 3)
            image->data[i] = (float)(round(255.0 * fmin(fmax((double)image->data[i], 0.0), 1.0)) / 255.0);
}

static int take_bits(struct errors *e, const struct rl_image *reference, struct rl_error *error)
{
    struct rl_image rounded;
    int status = rl_image_allocate(&rounded, reference->width, reference->height, 4, error);
    if (status != RL_OK)
        return status;
    memcpy(rounded.data, reference->data,
           4 * sizeof *rounded.data * (size_t)rounded.width * (size_t)rounded.height);
    round_to_bits(&rounded);
    status = take(e, 0, &rounded, reference, error);
    rl_image_clear(&rounded);
    return status;
}

static int take_pictures(struct errors *e, const struct rl_record *r, struct rl_bench *bench,
                         const struct rl_scene *scene, const struct truth *truth, struct rl_error *error)
{
    struct rl_seeds s = {0};
    int status = rl_seeds_draw_case(&s, bench, scene, r->parameters, error);
    for (size_t k = 0; k < e->n && status == RL_OK; k++) {
        bool all = is_arm(r, "all");
        if (all)
            round_to_bits(&s.image[k]);
        status = take(e, k, &s.image[k], all ? truth->point : &truth->base.image[k], error);
    }
    rl_seeds_clear(&s);
    return status;
}

static int measure_arm(struct errors *e, const struct rl_record *r, struct rl_bench *bench,
                       const struct rl_scene *scene, const struct truth *truth, struct rl_error *error)
{
    int status = RL_OK;
    bool parallax = is_arm(r, "parallax"), base = is_arm(r, "base"), bits = is_arm(r, "bits");
    double tolerance = rl_parameter_number(r->parameters, "tolerance");
    e->n = truth->base.n;
    /* Of two references each may be off. What rounding does to a value changes by no more than the value. */
    e->slack = parallax ? 2.0 * tolerance : base || bits || is_arm(r, "all") ? tolerance : 0.0;
    if (!parallax && !base && !bits)
        return take_pictures(e, r, bench, scene, truth, error);
    for (size_t k = 0; base && k < e->n && status == RL_OK; k++)
        status = take(e, k, &truth->base.image[k], truth->centre, error);
    if (base)
        return status;
    status = parallax ? take(e, 0, truth->centre, truth->point, error) : take_bits(e, truth->point, error);
    for (size_t k = 1; k < e->n; k++) {
        e->mse[k] = e->mse[0];
        e->bias[k] = e->bias[0];
    }
    return status;
}

static int add_errors(struct rl_record *r, const struct errors *e, struct rl_error *error)
{
    double least[RL_SEEDS_MAX], most[RL_SEEDS_MAX];
    for (size_t k = 0; k < e->n; k++) {
        least[k] = mse_at(e, k, -1);
        most[k] = mse_at(e, k, 1);
    }
    struct rl_interval mse = hull(least, e->mse, most, e->n), bias = rl_mean_interval(e->bias, e->n, 0.95);
    mse.low = fmax(mse.low, 0.0);
    bias.low -= e->slack;
    bias.high += e->slack;
    int status = rl_record_add(r, "mse", mse, "1", error);
    if (status == RL_OK)
        status = rl_record_add(r, "rmse",
                               (struct rl_interval){rl_root(mse.value), rl_root(mse.low), rl_root(mse.high)},
                               "1", error);
    return status == RL_OK ? rl_record_add(r, "bias", bias, "1", error) : status;
}

static bool is_single(const struct rl_record *r)
{
    return !is_arm(r, "all") && !is_arm(r, "base");
}

/* The sum of the single arms' squared errors in one seed, but for the arm `but` (n: of all). */
static double sum_at(const struct rl_record *records, const struct errors *e, size_t n, size_t but, size_t k,
                     int way)
{
    double sum = 0.0;
    for (size_t i = 0; i < n; i++)
        sum += i != but && is_single(&records[i]) ? mse_at(&e[i], k, way) : 0.0;
    return sum;
}

/* Of no error no share. */
static double share_of(double part, double rest)
{
    return part + rest > 0.0 ? part / (part + rest) : NAN;
}

static int add_interaction(struct rl_record *records, const struct errors *e, size_t n, size_t all,
                           struct rl_error *error)
{
    double left[3][RL_SEEDS_MAX], part[3][RL_SEEDS_MAX];
    for (size_t k = 0; k < e[all].n; k++)
        for (int way = -1; way <= 1; way++) {
            double whole = mse_at(&e[all], k, way);
            left[way + 1][k] = whole - sum_at(records, e, n, n, k, -way);
            part[way + 1][k] = whole > 0.0 ? left[way + 1][k] / whole : NAN;
        }
    int status =
        rl_record_add(&records[all], "interaction", hull(left[0], left[1], left[2], e[all].n), "1", error);
    return status == RL_OK ? rl_record_add(&records[all], "interaction_share",
                                           hull(part[0], part[1], part[2], e[all].n), "1", error)
                           : status;
}

/* Of each seed's own sum, so that what seeds have in common drops out. */
static int add_shares(struct rl_record *records, const struct errors *e, size_t n, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        double share[3][RL_SEEDS_MAX];
        if (is_arm(&records[i], "all"))
            status = add_interaction(records, e, n, i, error);
        if (!is_single(&records[i]))
            continue;
        for (size_t k = 0; k < e[i].n; k++)
            for (int way = -1; way <= 1; way++)
                share[way + 1][k] = share_of(mse_at(&e[i], k, way), sum_at(records, e, n, i, k, -way));
        status = rl_record_add(&records[i], "share", hull(share[0], share[1], share[2], e[i].n), "1", error);
    }
    return status;
}

int rl_budget_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                      const struct rl_scene *scene, struct rl_error *error)
{
    if (n > ARMS_MAX || !is_arm(&records[0], "base"))
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, expected at most %d, the base first", n,
                       ARMS_MAX);
    struct truth truth = {0};
    struct errors e[ARMS_MAX] = {{0}};
    const char *p = records[0].parameters;
    int status = rl_bench_reference(&truth.point, bench, scene, p, RL_LIGHT_FROM_POINT, error);
    if (status == RL_OK)
        status = rl_bench_reference(&truth.centre, bench, scene, p, RL_LIGHT_FROM_OBJECT, error);
    if (status == RL_OK)
        status = rl_seeds_draw_case(&truth.base, bench, scene, records[0].parameters, error);
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        status = measure_arm(&e[i], &records[i], bench, scene, &truth, error);
        if (status == RL_OK)
            status = add_errors(&records[i], &e[i], error);
    }
    if (status == RL_OK)
        status = add_shares(records, e, n, error);
    rl_seeds_clear(&truth.base);
    return status;
}
