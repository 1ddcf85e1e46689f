/* How fast errors fall with tessellation, and how many triangles a step of 8 bits takes: the derived table of the study `interpolation`. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "studies/interpolation.h"
#include "studies/judging.h"

/* The measured errors of one interpolation, by tessellation, ascending. */
struct fall {
    size_t n;
    double tessellation[RL_AXIS_MAX], rmse[RL_AXIS_MAX], triangles[RL_AXIS_MAX];
};

static void collect(struct fall *fall, const struct rl_run *run, const char *object, const char *light,
                    const char *interpolation)
{
    char pattern[256];
    fall->n = 0;
    snprintf(pattern, sizeof pattern, "series=error object=%.60s light=%.60s interpolation=%.60s", object,
             light, interpolation);
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, RL_NO_SCENE, pattern));) {
        const struct rl_metric *rmse = rl_record_metric(r, "rmse");
        const struct rl_metric *triangles = rl_record_metric(r, "triangles");
        double t = rl_parameter_number(r->parameters, "tessellation");
        if (!rmse || !triangles || isnan(t) || fall->n == RL_AXIS_MAX)
            continue;
        size_t at = fall->n++;
        for (; at > 0 && fall->tessellation[at - 1] > t; at--) {
            fall->tessellation[at] = fall->tessellation[at - 1];
            fall->rmse[at] = fall->rmse[at - 1];
            fall->triangles[at] = fall->triangles[at - 1];
        }
        fall->tessellation[at] = t;
        fall->rmse[at] = rmse->value;
        fall->triangles[at] = triangles->value;
    }
}

/* Between the last tessellation whose error is above a step and the next, as a power law has it; the interval is these two. Where
 * the first meets the bound already there is only the interval, from 0 on, and no value. */
static struct rl_interval triangles_for_step(const struct fall *f)
{
    size_t i = f->n;
    while (i > 0 && f->rmse[i - 1] <= RL_STEP_OF_8_BITS)
        i--;
    if (f->n == 0)
        return (struct rl_interval){NAN, NAN, NAN};
    if (i == f->n) /* not even the finest */
        return (struct rl_interval){INFINITY, f->triangles[i - 1], INFINITY};
    if (i == 0)
        return (struct rl_interval){NAN, 0.0, f->triangles[0]};
    double part = log(f->rmse[i - 1] / RL_STEP_OF_8_BITS) / log(f->rmse[i - 1] / f->rmse[i]);
    return (struct rl_interval){f->triangles[i - 1] * pow(f->triangles[i] / f->triangles[i - 1], part),
                                f->triangles[i - 1], f->triangles[i]};
}

struct rl_interpolation_rates rl_interpolation_rates(const struct rl_run *run, const char *object,
                                                     const char *light, const char *interpolation)
{
    struct fall f;
    collect(&f, run, object, light, interpolation);
    size_t fitted = f.n < RL_INTERPOLATION_FITTED ? f.n : RL_INTERPOLATION_FITTED, first = f.n - fitted;
    double h[RL_INTERPOLATION_FITTED];
    for (size_t i = 0; i < fitted; i++)
        h[i] = 1.0 / f.tessellation[first + i];
    return (struct rl_interpolation_rates){
        .rate = rl_loglog_slope(h, f.rmse + first, fitted, 0.95),
        .triangles = triangles_for_step(&f),
        .from_tessellation = fitted > 0 ? f.tessellation[first] : NAN,
        .points = fitted,
    };
}

static int add(struct rl_record *r, const char *name, struct rl_interval x, struct rl_error *error)
{
    return isnan(x.value) && isnan(x.low) ? RL_OK : rl_record_add(r, name, x, "1", error);
}

static int add_rates(struct rl_run *derived, const struct rl_run *run, const char *object, const char *light,
                     const char *interpolation, struct rl_error *error)
{
    const struct rl_interpolation_rates found = rl_interpolation_rates(run, object, light, interpolation);
    if (found.points == 0)
        return RL_OK;
    const struct rl_place place = {run->study, RL_NO_SCENE, "", 0};
    struct rl_record *r = rl_run_add(derived, &place, 0, error, "object=%s light=%s interpolation=%s", object,
                                     light, interpolation);
    if (!r)
        return RL_ERR_SYSTEM;
    r->status = RL_RECORD_OK;
    const double from = found.from_tessellation, points = (double)found.points;
    int status = add(r, "rate", found.rate, error);
    if (status == RL_OK)
        status = add(r, "triangles_for_step", found.triangles, error);
    if (status == RL_OK)
        status = add(r, "from_tessellation", (struct rl_interval){from, from, from}, error);
    return status == RL_OK ? add(r, "fitted", (struct rl_interval){points, points, points}, error) : status;
}

int rl_interpolation_derive(struct rl_run *derived, const struct rl_run *run, struct rl_error *error)
{
    static const char *const object[] = {"sphere", "teapot"}, *const light[] = {"eye", "side"};
    *derived = (struct rl_run){.provenance = run->provenance};
    memcpy(derived->study, run->study, sizeof derived->study);
    memcpy(derived->grid, run->grid, sizeof derived->grid);
    int status = RL_OK;
    for (int o = 0; o < 2; o++)
        for (int l = 0; l < 2; l++)
            for (int i = 0; i < RL_INTERPOLATIONS && status == RL_OK; i++)
                status = add_rates(derived, run, object[o], light[l],
                                   rl_interpolation_name((enum rl_interpolation)i), error);
    if (status != RL_OK)
        rl_run_clear(derived);
    return status;
}
