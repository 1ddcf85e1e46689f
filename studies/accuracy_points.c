/* Measures the points of the study `accuracy`: every integrator at every tolerance, point by point (see accuracy.h). */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "reference/integrators.h"
#include "studies/accuracy.h"
#include "studies/points.h"

enum { ARMS_MAX = 64, REPEATS = 7 };

/* Below SLOW one evaluation says little; several are timed together until they take BATCH. Seconds. */
#define SLOW 2e-3
#define BATCH 1e-4
#define TRUTH_TOLERANCE 1e-13

enum quantity { TIME_US, TRUE_ERROR, STATED_ERROR, CONVERGED, BOUNDED, EVALUATIONS, QUANTITIES };

/* One case: an integrator and its options; what it did at each point. */
struct arm {
    const struct rl_integrator *integrator;
    struct rl_integrate_options options;
    size_t points;
    double *at[QUANTITIES]; /* [points] */
};

/* A point with its light and the truth. */
struct place {
    struct rl_point point;
    struct rl_light_set *set;
    struct rl_estimate truth;
};

static double thread_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int place_make(struct place *place, enum rl_point_light_kind kind, size_t index,
                      struct rl_error *error)
{
    rl_point_make(&place->point, kind, index);
    const rl_vec3 *vertices = place->point.vertex;
    int status = rl_light_set_from_polygons(&place->set, &vertices, &place->point.n_vertices, 1, error);
    if (status != RL_OK)
        return rl_fail_prefix(error, "point %zu", index);
    const struct rl_integrate_options options = {
        .attenuation = true, .tolerance = TRUTH_TOLERANCE, .simd = rl_simd_best()};
    rl_integrate_lines(&place->truth, &place->point.surface, &place->point.e, place->set, &options);
    return RL_OK;
}

static int evaluate(struct rl_estimate *estimate, const struct arm *arm, const struct place *place, int times,
                    double *seconds, struct rl_error *error)
{
    int status = RL_OK;
    double start = thread_seconds();
    for (int i = 0; i < times && status == RL_OK; i++)
        status = arm->integrator->integrate(estimate, &place->point.surface, &place->point.e, place->set,
                                            &arm->options, error);
    *seconds = (thread_seconds() - start) / times;
    return status;
}

static int time_point(struct rl_estimate *estimate, const struct arm *arm, const struct place *place,
                      double *seconds, struct rl_error *error)
{
    double once, repeat[REPEATS];
    int status = evaluate(estimate, arm, place, 1, &once, error);
    *seconds = once;
    if (status != RL_OK || once >= SLOW)
        return status;
    int times = (int)fmax(1.0, fmin(64.0, BATCH / once));
    for (int i = 0; i < REPEATS && status == RL_OK; i++)
        status = evaluate(estimate, arm, place, times, &repeat[i], error);
    *seconds = rl_median_interval(repeat, REPEATS, 0.95).value;
    return status;
}

/* The worst of the channels: the lights are grey, so that they differ by rounding at most. */
static void compare(struct arm *arm, size_t i, const struct rl_estimate *estimate,
                    const struct rl_estimate *truth)
{
    arm->at[BOUNDED][i] = 1.0;
    for (int c = 0; c < 3; c++) {
        double off = fabs(estimate->value[c] - truth->value[c]);
        arm->at[TRUE_ERROR][i] = fmax(arm->at[TRUE_ERROR][i], off);
        arm->at[STATED_ERROR][i] = fmax(arm->at[STATED_ERROR][i], estimate->error[c]);
        if (!(off <= estimate->error[c] + truth->error[c])) /* the truth has an error of its own */
            arm->at[BOUNDED][i] = 0.0;
    }
    arm->at[CONVERGED][i] = estimate->converged;
    arm->at[EVALUATIONS][i] = (double)estimate->evaluations;
}

/* All arms at one point; who begins changes from point to point. */
static int take_turns(struct arm *arm, size_t n, const struct place *place, size_t i, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t k = 0; k < n && status == RL_OK; k++) {
        size_t which = (k + i) % n;
        struct arm *a = &arm[which];
        if (i >= a->points)
            continue;
        struct rl_estimate estimate;
        double seconds;
        a->options.seed = 1 + i + 100000 * which; /* no two evaluations draw the same numbers */
        status = time_point(&estimate, a, place, &seconds, error);
        a->at[TIME_US][i] = 1e6 * seconds;
        compare(a, i, &estimate, &place->truth);
    }
    return status;
}

static int arm_make(struct arm *arm, const struct rl_record *r, struct rl_error *error)
{
    char name[RL_NAME_MAX];
    rl_parameter(r->parameters, "integrator", name, sizeof name);
    double points = rl_parameter_number(r->parameters, "points");
    double most = rl_parameter_number(r->parameters, "max_evaluations");
    *arm = (struct arm){.integrator = rl_integrator_find(name)};
    if (!arm->integrator || !(points >= 1.0 && points <= 1e5) || !(most >= 0.0 && most <= 1e9))
        return rl_fail(error, RL_ERR_INPUT,
                       "%s: expected an integrator, 1 to 100000 points and 0 to 1e9 evaluations",
                       r->parameters);
    arm->points = (size_t)points;
    arm->options = (struct rl_integrate_options){.attenuation = true,
                                                 .tolerance = rl_parameter_number(r->parameters, "tolerance"),
                                                 .max_evaluations = (size_t)most,
                                                 .simd = rl_simd_best()};
    double *memory = calloc(QUANTITIES * arm->points, sizeof *memory);
    if (!memory)
        return rl_fail_memory(error, "what was measured at the points");
    for (int q = 0; q < QUANTITIES; q++)
        arm->at[q] = memory + (size_t)q * arm->points;
    return RL_OK;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The smallest value that at least the share of all values do not exceed. Sorts. */
static struct rl_interval quantile(double *value, size_t n, double share)
{
    qsort(value, n, sizeof *value, ascending);
    double x = value[(size_t)fmax(0.0, ceil(share * (double)n) - 1.0)];
    return rl_exact_interval(x);
}

static struct rl_interval share_of(const double *yes, size_t n)
{
    double sum = 0.0;
    for (size_t i = 0; i < n; i++)
        sum += yes[i];
    return rl_exact_interval(sum / (double)n);
}

static int store_series(struct rl_record *r, const struct arm *arm, struct rl_error *error)
{
    static const struct {
        const char *name;
        enum quantity quantity;
    } series[] = {{"time_us", TIME_US},
                  {"true_error", TRUE_ERROR},
                  {"stated_error", STATED_ERROR},
                  {"converged", CONVERGED}};
    int status = RL_OK;
    for (size_t i = 0; i < sizeof series / sizeof series[0] && status == RL_OK; i++)
        status = rl_record_series_add(r, series[i].name, arm->at[series[i].quantity], arm->points, error);
    return status;
}

static int store(struct rl_record *r, struct arm *arm, struct rl_error *error)
{
    size_t n = arm->points;
    int status = store_series(r, arm, error);
    double within = 0.0;
    for (size_t i = 0; i < n; i++)
        within += arm->at[TRUE_ERROR][i] <= arm->options.tolerance;
    within /= (double)n;
    const struct {
        const char *name, *unit;
        struct rl_interval x;
    } metric[] = {
        {"time_us", "us", rl_median_interval(arm->at[TIME_US], n, 0.95)},
        {"true_error", "1", rl_median_interval(arm->at[TRUE_ERROR], n, 0.95)},
        {"error_p90", "1", quantile(arm->at[TRUE_ERROR], n, 0.9)},
        {"error_max", "1", quantile(arm->at[TRUE_ERROR], n, 1.0)},
        {"bounded", "1", share_of(arm->at[BOUNDED], n)},
        {"within", "1", {within, within, within}},
        {"converged", "1", share_of(arm->at[CONVERGED], n)},
        {"evaluations", "1", rl_median_interval(arm->at[EVALUATIONS], n, 0.95)},
    };
    for (size_t i = 0; i < sizeof metric / sizeof metric[0] && status == RL_OK; i++)
        status = rl_record_add(r, metric[i].name, metric[i].x, metric[i].unit, error);
    return status;
}

static int visit_points(struct arm *arm, size_t n, enum rl_point_light_kind kind, struct rl_bench *bench,
                        struct rl_error *error)
{
    size_t points = 0;
    for (size_t k = 0; k < n; k++)
        points = arm[k].points > points ? arm[k].points : points;
    int status = RL_OK;
    for (size_t i = 0; i < points && status == RL_OK; i++) {
        struct place place;
        if (rl_progress_cancelled(&bench->quiet))
            return rl_fail(error, RL_ERR_CANCELLED, "interrupted; what was finished is kept");
        rl_spent_on(&bench->spent, RL_SPENT_REFERENCE);
        status = place_make(&place, kind, i, error);
        if (status != RL_OK)
            break;
        rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
        status = take_turns(arm, n, &place, i, error);
        rl_spent_on(&bench->spent, RL_SPENT_EVALUATION);
        rl_light_set_free(place.set);
    }
    return status;
}

int rl_accuracy_measure_points(struct rl_record *records, size_t n, struct rl_bench *bench,
                               struct rl_error *error)
{
    struct arm arm[ARMS_MAX] = {{0}};
    if (n > ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, expected at most %d", n, ARMS_MAX);
    enum rl_point_light_kind kind =
        rl_parameters_match(records[0].parameters, "light=star") ? RL_POINT_STAR : RL_POINT_QUAD;
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = arm_make(&arm[i], &records[i], error);
    if (status == RL_OK)
        status = visit_points(arm, n, kind, bench, error);
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = store(&records[i], &arm[i], error);
    for (size_t i = 0; i < n; i++)
        free(arm[i].at[0]);
    return status;
}
