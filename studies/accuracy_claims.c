/* The claims that the study `accuracy` judges about points and the kernel, from figures by point and by round. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_cdf.h>

#include "studies/accuracy.h"

/* What the witnesses that draw random numbers state is an interval of this level; held true to within so much. */
static const double coverage = 0.99, coverage_margin = 0.02;

static const struct rl_record *find_points(const struct rl_judging *j, const char *integrator,
                                           const char *light, double tolerance)
{
    char pattern[160];
    snprintf(pattern, sizeof pattern, "part=points integrator=%s light=%s tolerance=%g", integrator, light,
             tolerance);
    return rl_run_find(j->run, j->scene, pattern);
}

static int claim_cost(const struct rl_judging *j, double tolerance, double bar_us)
{
    char text[200];
    snprintf(text, sizeof text,
             "ours: the reference takes at most %g us a point to %g, one quad light, one core, median of the "
             "points",
             bar_us, tolerance);
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "quad";
    const struct rl_record *r = find_points(j, "reference", "quad", tolerance);
    const struct rl_metric *m = r ? rl_record_metric(r, "time_us") : NULL;
    if (!m)
        return RL_OK;
    rl_claim_value(c, m->value, m->low, m->high, "us");
    c->verdict = rl_verdict_at_most(m->low, m->high, bar_us);
    snprintf(c->note, sizeof c->note, "%.0f points, on %.100s", rl_parameter_number(r->parameters, "points"),
             j->run->provenance.cpu);
    return RL_OK;
}

/* By point, where cubature-uv says that it converged and is right: its time over the reference's. Returns how many points. */
static size_t uv_ratios(double *ratio, const struct rl_record *uv, const struct rl_record *reference)
{
    double tolerance = rl_parameter_number(uv->parameters, "tolerance");
    const struct rl_series *time = rl_record_series(uv, "time_us"), *off = rl_record_series(uv, "true_error"),
                           *converged = rl_record_series(uv, "converged"),
                           *less = rl_record_series(reference, "time_us");
    size_t n = 0;
    for (size_t i = 0; i < time->n && i < less->n; i++)
        if (converged->value[i] > 0.0 && off->value[i] <= tolerance)
            ratio[n++] = time->value[i] / less->value[i];
    return n;
}

static int claim_ratio(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: the reference to 1e-5 is at least 10,000 times as fast "
                                             "as hcubature over (U, V) to 1e-5, where "
                                             "that says it converged and is right, one quad light");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "quad";
    const struct rl_record *uv = find_points(j, "cubature-uv", "quad", 1e-5),
                           *reference = find_points(j, "reference", "quad", 1e-5);
    if (!uv || !reference)
        return RL_OK;
    size_t points = rl_record_series(uv, "time_us")->n;
    double *ratio = calloc(points + 1, sizeof *ratio);
    if (!ratio)
        return rl_fail_memory(j->error, "ratios of times");
    size_t n = uv_ratios(ratio, uv, reference);
    struct rl_interval times = rl_interval_from_0(rl_median_interval(ratio, n, 0.95));
    free(ratio);
    snprintf(c->note, sizeof c->note, "paired by point at the %zu of %zu points where it is right; on %.100s",
             n, points, j->run->provenance.cpu);
    if (n == 0)
        return RL_OK;
    rl_claim_value(c, times.value, times.low, times.high, "times");
    c->verdict = rl_verdict_at_least(times.low, times.high, 1e4);
    return RL_OK;
}

/* A share k of n with the interval of Clopper and Pearson (1934). */
static struct rl_interval share_interval(double k, double n)
{
    return (struct rl_interval){.value = k / n,
                                .low = k > 0.0 ? gsl_cdf_beta_Pinv(0.025, k, n - k + 1.0) : 0.0,
                                .high = k < n ? gsl_cdf_beta_Pinv(0.975, k + 1.0, n - k) : 1.0};
}

/* Sums up a share over an integrator's cases; false if there are none. */
static bool share_over_cases(struct rl_interval *share, double *n, const struct rl_judging *j,
                             const char *integrator, const char *metric)
{
    char pattern[160];
    double k = 0.0;
    *n = 0.0;
    snprintf(pattern, sizeof pattern, "part=points integrator=%s", integrator);
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, pattern));) {
        double points = rl_parameter_number(r->parameters, "points");
        k += round(points * rl_record_metric(r, metric)->value);
        *n += points;
    }
    if (*n > 0.0)
        *share = share_interval(k, *n);
    return *n > 0.0;
}

/* Always, it says; or as often as an interval of 99 % is to. */
static int claim_share(const struct rl_judging *j, const char *integrator, const char *metric, bool always,
                       const char *text)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    struct rl_interval share = {NAN, NAN, NAN};
    double n = 0.0;
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "bounded";
    if (!share_over_cases(&share, &n, j, integrator, metric))
        return RL_OK;
    rl_claim_value(c, share.value, share.low, share.high, "of all cases");
    snprintf(c->note, sizeof c->note, "%.0f cases: points, lights and tolerances; truth: reference at 1e-13",
             n);
    if (always)
        c->verdict = share.value == 1.0 ? RL_VERDICT_HOLDS : RL_VERDICT_FAILS;
    else
        c->verdict = rl_verdict_equals(share.low, share.high, coverage, coverage_margin);
    return RL_OK;
}

static int claim_no_truth(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: hcubature over (U, V) is no ground truth: at fewer than "
                                             "9 in 10 points its own error bounds the "
                                             "true one");
    struct rl_interval share = {NAN, NAN, NAN};
    double n = 0.0;
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "bounded";
    if (!share_over_cases(&share, &n, j, "cubature-uv", "bounded"))
        return RL_OK;
    rl_claim_value(c, share.value, share.low, share.high, "of all cases");
    snprintf(c->note, sizeof c->note,
             "%.0f cases; a light that its first 17 points miss is an error of 0 to it", n);
    c->verdict = rl_verdict_at_most(share.low, share.high, 0.9);
    return RL_OK;
}

/* a where time grows as (1/tolerance)^a between the two tolerances, quads: by point, the median. */
static bool growth(struct rl_interval *exponent, const struct rl_judging *j, const char *integrator,
                   double coarse, double fine)
{
    const struct rl_record *a = find_points(j, integrator, "quad", coarse),
                           *b = find_points(j, integrator, "quad", fine);
    if (!a || !b)
        return false;
    const struct rl_series *x = rl_record_series(a, "time_us"), *y = rl_record_series(b, "time_us");
    size_t n = x->n < y->n ? x->n : y->n;
    struct rl_interval times = rl_interval_from_0(rl_ratio_interval(y->value, x->value, n, 0.95));
    double scale = 1.0 / log(coarse / fine); /* the median is that of the logarithms too */
    *exponent =
        (struct rl_interval){log(times.value) * scale, log(times.low) * scale, log(times.high) * scale};
    return true;
}

static int claim_growth_of_reference(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: the reference's time does not grow as 1/tolerance^2: as "
                                             "(1/tolerance)^a, a at most 0.1, from 1e-2 to 1e-12");
    struct rl_interval a = {NAN, NAN, NAN};
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "quad";
    if (!growth(&a, j, "reference", 1e-2, 1e-12))
        return RL_OK;
    rl_claim_value(c, a.value, a.low, a.high, "exponent");
    snprintf(c->note, sizeof c->note, "by point, one quad light: log of the ratio of times over ten decades");
    c->verdict = rl_verdict_at_most(a.low, a.high, 0.1);
    return RL_OK;
}

static int claim_growth_of_montecarlo(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: Monte Carlo's time grows as (1/tolerance)^a, a = 2 to within a quarter, from 3e-3 to 1e-3");
    struct rl_interval a = {NAN, NAN, NAN};
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "quad";
    if (!growth(&a, j, "montecarlo", 3e-3, 1e-3))
        return RL_OK;
    rl_claim_value(c, a.value, a.low, a.high, "exponent");
    snprintf(c->note, sizeof c->note,
             "by point, one quad light; where its 4096 first samples suffice at 3e-3, it is less");
    c->verdict = rl_verdict_equals(a.low, a.high, 2.0, 0.25);
    return RL_OK;
}

static int claim_kernel(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: exhaustive's inner loop takes at least 1e9 texel-normals per second on two threads");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "kernel";
    const struct rl_record *best = NULL; /* the last is that of the best instruction set */
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, "part=kernel threads=2"));)
        best = r;
    if (!best)
        return RL_OK;
    const struct rl_metric *m = rl_record_metric(best, "texel_normals");
    char simd[RL_NAME_MAX];
    rl_parameter(best->parameters, "simd", simd, sizeof simd);
    rl_claim_value(c, m->value, m->low, m->high, "texel-normals/s");
    snprintf(c->note, sizeof c->note, "%.20s, on %.100s", simd, j->run->provenance.cpu);
    c->verdict = rl_verdict_at_least(m->low, m->high, 1e9);
    return RL_OK;
}

static int judge_points(const struct rl_judging *j)
{
    static const struct {
        const char *integrator, *metric;
        bool always;
        const char *text;
    } shares[] = {
        {"reference", "within", true,
         "ours: the reference's true error is within the tolerance asked for at every point, from 1e-2 to "
         "1e-12"},
        {"reference", "bounded", true,
         "ours: the reference's stated error bounds its true error at every point"},
        {"cubature", "bounded", true,
         "ours: the error that cubature over the lights' area states bounds its true error at every point"},
        {"montecarlo", "bounded", false,
         "ours: Monte Carlo's stated error, an interval of 99 %, bounds the true error so often (to within 2 "
         "%)"},
        {"vegas", "bounded", false,
         "ours: VEGAS's stated error, an interval of 99 %, bounds the true error so often (to within 2 %)"},
    };
    int status = claim_cost(j, 1e-6, 20.0);
    if (status == RL_OK)
        status = claim_cost(j, 1e-10, 100.0);
    if (status == RL_OK)
        status = claim_ratio(j);
    for (size_t i = 0; i < sizeof shares / sizeof shares[0] && status == RL_OK; i++)
        status = claim_share(j, shares[i].integrator, shares[i].metric, shares[i].always, shares[i].text);
    if (status == RL_OK)
        status = claim_no_truth(j);
    if (status == RL_OK)
        status = claim_growth_of_reference(j);
    if (status == RL_OK)
        status = claim_growth_of_montecarlo(j);
    return status == RL_OK ? claim_kernel(j) : status;
}

int rl_accuracy_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        const struct rl_judging j = {run, scene, claims, error};
        status = strcmp(scene, RL_NO_SCENE) == 0 ? judge_points(&j) : rl_accuracy_judge_images(&j);
    }
    return status;
}
