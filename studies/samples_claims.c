/* The claims that the study `samples` judges. What the paper says or implies about the number of samples, and what follows from
 * the method: each from figures in the database, never from memory. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "measure/statistics.h"
#include "studies/judging.h"
#include "studies/samples.h"
#include "studies/timing_arms.h"

static const struct rl_metric *find(const struct rl_judging *v, const char *method, double samples, double rr,
                                    const char *metric)
{
    char pattern[160];
    snprintf(pattern, sizeof pattern, "series=methods setting=paper method=%s samples=%g rr=%g", method,
             samples, rr);
    return rl_judging_metric(v, pattern, metric);
}

static size_t rr_axis(const struct rl_judging *v, double rr[RL_AXIS_MAX])
{
    return rl_judging_axis(v, "series=methods setting=paper", "rr", rr);
}

/* Four samples: below one step of an 8-bit frame buffer? */
static int claim_four(const struct rl_judging *v, const double *rr, size_t n)
{
    struct rl_claim *c =
        rl_judging_claim(v, "paper: 4 random normals a pixel suffice: RMSE at most 1/255 of full scale");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "error";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *m = find(v, "random", 4, rr[i], "rmse");
        if (!m)
            continue;
        step[i] = (struct rl_step){rr[i], m->value, m->low, m->high,
                                   rl_verdict_at_most(m->low, m->high, RL_STEP_OF_8_BITS)};
    }
    rl_judging_conclude(c, step, n, "RMSE");
    return RL_OK;
}

/* Where the curve RMSE(N) first comes down to the bound, by straight lines in log-log; infinite if it does not within the grid.
 * `end` -1, 0, 1: of the interval's lower end, the value, the upper end. */
static double samples_needed(const struct rl_judging *v, double rr, int end)
{
    double N[RL_AXIS_MAX], before = NAN, before_n = NAN;
    size_t n = rl_judging_axis(v, "series=methods setting=paper method=random", "samples", N);
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *m = find(v, "random", N[i], rr, "rmse");
        if (!m)
            continue;
        double e = end < 0 ? m->low : end > 0 ? m->high : m->value;
        if (e <= RL_STEP_OF_8_BITS) {
            if (isnan(before) || !(e > 0.0))
                return N[i];
            double t = log(before / RL_STEP_OF_8_BITS) / log(before / e);
            return before_n * pow(N[i] / before_n, t);
        }
        before = e;
        before_n = N[i];
    }
    return isnan(before) ? NAN : INFINITY;
}

static int claim_enough(const struct rl_judging *v, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(
        v, "ours: some number of random normals up to the grid's largest brings RMSE to 1/255");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "error";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    for (size_t i = 0; i < n; i++) {
        double low = samples_needed(v, rr[i], -1), needed = samples_needed(v, rr[i], 0),
               high = samples_needed(v, rr[i], 1);
        step[i] = (struct rl_step){rr[i], needed, low, high,
                                   isnan(needed)    ? RL_VERDICT_INCONCLUSIVE
                                   : isfinite(high) ? RL_VERDICT_HOLDS
                                   : isinf(low)     ? RL_VERDICT_FAILS
                                                    : RL_VERDICT_INCONCLUSIVE};
    }
    rl_judging_conclude(c, step, n, "normals a pixel");
    double N[RL_AXIS_MAX];
    size_t n_samples = rl_judging_axis(v, "series=methods setting=paper method=random", "samples", N);
    for (size_t i = 0; i < n && isinf(c->value); i++) {
        const struct rl_metric *m = find(v, "random", N[n_samples - 1], rr[i], "rmse");
        rl_judging_instead(&step[i], m);
    }
    if (isinf(c->value))
        rl_judging_conclude_again(c, step, n, "RMSE at the largest N");
    return RL_OK;
}

static struct rl_interval noise_slope(const struct rl_judging *v, double rr)
{
    double N[RL_AXIS_MAX], noise[RL_AXIS_MAX];
    size_t n = rl_judging_axis(v, "series=methods setting=paper method=random", "samples", N), kept = 0;
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *m = find(v, "random", N[i], rr, "noise");
        if (!m)
            continue;
        N[kept] = N[i];
        noise[kept++] = m->value;
    }
    return rl_loglog_slope(N, noise, kept, 0.95);
}

/* Of the R_r that carry the verdict the one whose slope is farthest from -1/2 speaks for all. */
static int claim_slope(const struct rl_judging *v, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(
        v, "ours: the noise of random normals falls as N^(-1/2) (slope -0.5 to within 0.01, at every R_r)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "split";
    double worst = NAN;
    for (size_t i = 0; i < n; i++) {
        struct rl_interval s = noise_slope(v, rr[i]);
        rl_judging_note(c, rr[i], s.value);
        if (rl_judging_worse(c, rl_verdict_equals(s.low, s.high, -0.5, 0.01), fabs(s.value + 0.5), &worst))
            rl_claim_value(c, s.value, s.low, s.high, "slope");
    }
    return RL_OK;
}

/* Of the squared error at the largest N, how much is bias: what no further sample removes. */
static int claim_bias_share(const struct rl_judging *v, const double *rr, size_t n)
{
    struct rl_claim *c =
        rl_judging_claim(v, "ours: with the paper's settings more samples stop helping: at the largest "
                            "N most of the squared error is bias, at every R_r");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "split";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    for (size_t i = 0; i < n; i++) {
        char pattern[96];
        snprintf(pattern, sizeof pattern, "series=methods setting=paper method=random rr=%g", rr[i]);
        double N[RL_AXIS_MAX];
        size_t n_samples = rl_judging_axis(v, pattern, "samples", N);
        if (n_samples == 0)
            continue;
        const struct rl_metric *b = find(v, "random", N[n_samples - 1], rr[i], "bias2");
        const struct rl_metric *s = find(v, "random", N[n_samples - 1], rr[i], "variance");
        if (!b || !s)
            continue;
        double bias_low = fmax(b->low, 0.0);
        double low = bias_low / (bias_low + s->high), high = b->high / (b->high + s->low);
        step[i] = (struct rl_step){rr[i], b->value / (b->value + s->value), low, high,
                                   rl_verdict_at_least(low, high, 0.5)};
    }
    rl_judging_conclude(c, step, n, "share of MSE");
    return RL_OK;
}

/* Of the R_r that the series has: the central one. */
static double floor_rr(const struct rl_judging *v)
{
    double rr[RL_AXIS_MAX];
    return rl_central_rr(rr, rl_judging_axis(v, "series=floor", "rr", rr));
}

static const struct rl_metric *find_floor(const struct rl_judging *v, double env_size, const char *metric)
{
    char pattern[96];
    snprintf(pattern, sizeof pattern, "series=floor env_size=%g rr=%g", env_size, floor_rr(v));
    return rl_judging_metric(v, pattern, metric);
}

/* What is left at the largest map, and whether the map's position explains it. */
static int claim_floor(const struct rl_judging *v)
{
    double size[RL_AXIS_MAX];
    size_t n = rl_judging_axis(v, "series=floor", "env_size", size);
    static const struct {
        const char *text, *metric;
        bool at_least;
    } row[] = {
        {"ours: neither samples nor texels bring the error to 1/255: a floor remains at the largest map",
         "floor", true},
        {"ours: that floor is the map's single position: seen from the object's centre, the error is below "
         "1/255",
         "floor_centre", false},
    };
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        struct rl_claim *c = rl_judging_claim(v, row[k].text);
        if (!c)
            return RL_ERR_SYSTEM;
        c->figure = "floor";
        const struct rl_metric *best = n ? find_floor(v, size[n - 1], row[k].metric) : NULL;
        if (!best)
            continue;
        rl_claim_value(c, best->value, best->low, best->high, "RMSE");
        snprintf(c->note, sizeof c->note, "at R_r %g, float normals, a map of %g texels a face edge",
                 floor_rr(v), size[n - 1]);
        c->verdict = row[k].at_least ? rl_verdict_at_least(best->low, best->high, RL_STEP_OF_8_BITS)
                                     : rl_verdict_at_most(best->low, best->high, RL_STEP_OF_8_BITS);
    }
    return RL_OK;
}

/* Resolution against position. */
static int claim_texels(const struct rl_judging *v)
{
    struct rl_claim *c = rl_judging_claim(
        v, "ours: 256 texels are enough: their error is less than that of the map's single position (ratio)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "floor";
    const struct rl_metric *texels = find_floor(v, 256, "floor_centre"),
                           *position = find_floor(v, 256, "parallax");
    if (texels && position) {
        rl_judging_ratio(c, texels, position, "1");
        snprintf(c->note, sizeof c->note, "at R_r %g: texels %.3g, position %.3g", floor_rr(v), texels->value,
                 position->value);
        c->verdict = rl_verdict_at_most(c->low, c->high, 1.0);
    }
    return RL_OK;
}

static int claim_against_regular(const struct rl_judging *v, const double *rr, size_t n)
{
    static const struct {
        const char *text, *metric;
    } row[] = {
        {"paper: 4 random normals give no more error than 13 regular ones (ratio of RMSE)", "rmse"},
        {"ours: averaged over seeds, 4 random normals are nearer to the truth than 13 regular ones (ratio of "
         "floors)",
         "floor"},
    };
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        struct rl_claim *c = rl_judging_claim(v, row[k].text);
        if (!c)
            return RL_ERR_SYSTEM;
        c->figure = row[k].metric[0] == 'f' ? "split" : "error";
        struct rl_step step[RL_AXIS_MAX];
        rl_judging_steps(step, rr, n);
        for (size_t i = 0; i < n; i++) {
            const struct rl_metric *random = find(v, "random", 4, rr[i], row[k].metric);
            const struct rl_metric *regular = find(v, "regular", 13, rr[i], row[k].metric);
            if (!random || !regular)
                continue;
            struct rl_claim ratio = {0};
            rl_judging_ratio(&ratio, random, regular, "1");
            step[i] = (struct rl_step){rr[i], ratio.value, ratio.low, ratio.high,
                                       rl_verdict_at_most(ratio.low, ratio.high, 1.0)};
        }
        rl_judging_conclude(c, step, n, "1");
    }
    return RL_OK;
}

/* a/b, the logarithms of independent figures: their relative errors add up as squares do. */
static struct rl_interval log_ratio(const struct rl_metric *a, const struct rl_metric *b)
{
    double room = hypot(log(a->high / a->low), log(b->high / b->low)) / 2.0,
           middle = log(a->value / b->value);
    return (struct rl_interval){middle, middle - room, middle + room};
}

/* log (MSE x frame time) of 4 normals over that of `other`; the clock's noise is one more error. NaN: not measured. */
static struct rl_interval four_against(const struct rl_judging *v, double other, double rr, double noise)
{
    const struct rl_metric *a = find(v, "random", 4, rr, "rmse"), *b = find(v, "random", other, rr, "rmse");
    const struct rl_metric *time = find(v, "random", other, rr, "time_to_random4");
    if (!a || !b || !time || isnan(noise))
        return (struct rl_interval){NAN, NAN, NAN};
    struct rl_interval rmse = log_ratio(a, b);
    double middle = 2.0 * rmse.value - log(time->value);
    double room = hypot(rmse.high - rmse.low, log(time->high / time->low) / 2.0 + noise);
    return (struct rl_interval){middle, middle - room, middle + room};
}

static double time_noise(const struct rl_judging *v)
{
    return rl_arms_noise(rl_judging_metric(v, "series=time setting=again", "time_to_random4"));
}

/* The better of 3 and 5 speaks against 4. */
static int claim_four_best(const struct rl_judging *v, const double *rr, size_t n)
{
    struct rl_claim *c =
        rl_judging_claim(v, "paper: 4 normals, which its 4x4 matrices ask for, are no worse a "
                            "choice than 3 or 5 (MSE x frame time over the lesser of theirs)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "time";
    static const double other[] = {3, 5};
    double central = rl_central_rr(rr, n), noise = time_noise(v);
    const struct rl_metric *four = find(v, "random", 4, central, "rmse");
    if (four)
        snprintf(c->note, sizeof c->note, "at R_r %g; RMSE and time over 4's: 4 %.3g", central, four->value);
    double worst = NAN;
    for (size_t i = 0; i < sizeof other / sizeof other[0]; i++) {
        struct rl_interval x = four_against(v, other[i], central, noise);
        if (isnan(x.value))
            continue;
        size_t used = strlen(c->note);
        snprintf(c->note + used, sizeof c->note - used, "; %g: %.3g, %.3g", other[i],
                 find(v, "random", other[i], central, "rmse")->value,
                 find(v, "random", other[i], central, "time_to_random4")->value);
        if (rl_judging_worse(c, rl_verdict_at_most(exp(x.low), exp(x.high), 1.0), x.value, &worst))
            rl_claim_value(c, exp(x.value), exp(x.low), exp(x.high), "times");
    }
    return RL_OK;
}

/* What a normal more or less costs: the one of 3 and 5 that is farther from 4. */
static int claim_four_time(const struct rl_judging *v, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(v, "ours: a normal more or less hardly costs time: frames of 3 and "
                                             "of 5 take what those of 4 do (to within "
                                             "a tenth, noise included)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "time";
    static const double other[] = {3, 5};
    double noise = time_noise(v), worst = NAN;
    for (size_t i = 0; i < sizeof other / sizeof other[0]; i++) {
        const struct rl_metric *time = find(v, "random", other[i], rl_central_rr(rr, n), "time_to_random4");
        if (!time || !rl_judging_worse(c, rl_verdict_equals(time->low - noise, time->high + noise, 1.0, 0.1),
                                       fabs(time->value - 1.0), &worst))
            continue;
        rl_claim_value(c, time->value, time->low, time->high, "times");
        snprintf(c->note, sizeof c->note, "%g normals, paired by round; noise floor of the A/A arms %.2g",
                 other[i], noise);
    }
    return RL_OK;
}

int rl_samples_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        struct rl_judging v = {run, scene, claims, error};
        double rr[RL_AXIS_MAX];
        size_t n = rr_axis(&v, rr);
        int (*const claim[])(const struct rl_judging *, const double *, size_t) = {
            claim_four,      claim_enough,    claim_slope, claim_bias_share, claim_against_regular,
            claim_four_best, claim_four_time,
        };
        for (size_t k = 0; k < sizeof claim / sizeof claim[0] && status == RL_OK; k++)
            status = claim[k](&v, rr, n);
        if (status == RL_OK)
            status = claim_floor(&v);
        if (status == RL_OK)
            status = claim_texels(&v);
    }
    return status;
}
