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

/* Squared error and bias of every seed; those without chance have the same for all. */
struct errors {
    size_t n;
    double mse[RL_SEEDS_MAX], bias[RL_SEEDS_MAX];
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
    e->n = truth->base.n;
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
    struct rl_interval mse = rl_mean_interval(e->mse, e->n, 0.95),
                       bias = rl_mean_interval(e->bias, e->n, 0.95);
    mse.low = fmax(mse.low, 0.0);
    int status = rl_record_add(r, "mse", mse, "1", error);
    if (status == RL_OK)
        status = rl_record_add(r, "rmse",
                               (struct rl_interval){rl_root(mse.value), rl_root(mse.low), rl_root(mse.high)},
                               "1", error);
    return status == RL_OK ? rl_record_add(r, "bias", bias, "1", error) : status;
}

/* Of each seed's own sum, so that what seeds have in common drops out. */
static int add_shares(struct rl_record *records, const struct errors *e, size_t n, struct rl_error *error)
{
    double sum[RL_SEEDS_MAX] = {0.0};
    int status = RL_OK;
    size_t all = n;
    for (size_t i = 0; i < n; i++) {
        bool single = !is_arm(&records[i], "all") && !is_arm(&records[i], "base");
        all = is_arm(&records[i], "all") ? i : all;
        for (size_t k = 0; single && k < e[i].n; k++)
            sum[k] += e[i].mse[k];
    }
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        double share[RL_SEEDS_MAX];
        if (i == all || is_arm(&records[i], "base"))
            continue;
        for (size_t k = 0; k < e[i].n; k++)
            share[k] = sum[k] > 0.0 ? e[i].mse[k] / sum[k] : NAN; /* of no error no share */
        status = rl_record_add(&records[i], "share", rl_mean_interval(share, e[i].n, 0.95), "1", error);
    }
    if (status != RL_OK || all == n)
        return status;
    double left[RL_SEEDS_MAX], part[RL_SEEDS_MAX];
    for (size_t k = 0; k < e[all].n; k++) {
        left[k] = e[all].mse[k] - sum[k];
        part[k] = e[all].mse[k] > 0.0 ? left[k] / e[all].mse[k] : NAN;
    }
    status = rl_record_add(&records[all], "interaction", rl_mean_interval(left, e[all].n, 0.95), "1", error);
    if (status == RL_OK)
        status = rl_record_add(&records[all], "interaction_share", rl_mean_interval(part, e[all].n, 0.95),
                               "1", error);
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
