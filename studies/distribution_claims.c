/* The claims that the study `distribution` judges. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "measure/goodness.h"
#include "studies/distribution.h"
#include "studies/judging.h"

/* Of U; and of a bin's share, root mean square over the bins: then the total variation distance over the bins is 0.01 at most, which
 * an R_r that is 3 % off has. */
static const double cdf_bound = 0.01, misfit_bound = 0.02;

/* Of D's root mean square sin(delta): the share of it that the mean normal may be off. */
static const double lean_bound = 0.01;

/* Chi-square tests of the run: each map's, of delta and of theta. */
static double number_of_tests(const struct rl_run *run)
{
    double n = 0.0;
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, RL_NO_SCENE, "series=map"));)
        n += 2.0;
    return n;
}

/* The largest map of a format at one R_r; NULL if none was measured. */
static const struct rl_record *largest_map(const struct rl_judging *j, const char *bits, double rr)
{
    char pattern[96];
    const struct rl_record *best = NULL;
    snprintf(pattern, sizeof pattern, "series=map normal_bits=%s rr=%g", bits, rr);
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, RL_NO_SCENE, pattern));)
        if (!best || rl_parameter_number(r->parameters, "normal_size") >
                         rl_parameter_number(best->parameters, "normal_size"))
            best = r;
    return best;
}

/* The smaller p of a map's two tests, 1 if there is none. */
static double smaller_p(const struct rl_record *r)
{
    const struct rl_metric *delta = rl_record_metric(r, "p_delta"), *theta = rl_record_metric(r, "p_theta");
    return delta && theta ? fmin(delta->value, theta->value) : 1.0;
}

/* A metric in terms of what it is compared with, at most a share of it. */
static struct rl_step share_of(const struct rl_metric *m, double whole, double rr, double bound)
{
    return (struct rl_step){rr, m->value / whole, m->low / whole, m->high / whole,
                            rl_verdict_at_most(m->low / whole, m->high / whole, bound)};
}

/* Where a claim holds at every R_r, the largest step is its number. */
static void show_largest(struct rl_claim *c, const struct rl_step *s, const char *unit)
{
    if (!(s->value <= c->value))
        rl_claim_value(c, s->value, s->low, s->high, unit);
}

/* The chance that a mean without any lean of its own is as long: its two components are normal, of one standard error at most, which
 * the interval's half width holds 2.448 times. */
static double lean_p(const struct rl_metric *mean_tilt)
{
    double errors = 2.448 * mean_tilt->value / (mean_tilt->high - mean_tilt->value);
    return exp(-0.5 * errors * errors);
}

/* The mean direction of what was drawn, before storing turns it: its angle, in terms of the lobe. Where it holds at every R_r, the
 * largest is its number. */
static int claim_lean(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: the normals drawn do not lean: their mean direction is off N by less than 1 % of D's root "
           "mean square sin(delta), at every R_r (float maps)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "tilt";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    double largest = NAN, smallest_p = 1.0;
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = largest_map(j, "float", rr[i]);
        const struct rl_metric *m = r ? rl_record_metric(r, "mean_tilt") : NULL,
                               *rms = r ? rl_record_metric(r, "d_rms_sine") : NULL;
        if (!m || !rms)
            continue;
        step[i] = share_of(m, rms->value, rr[i], lean_bound);
        largest = fmax(largest, m->value);
        smallest_p = fmin(smallest_p, lean_p(m));
        show_largest(c, &step[i], "of the root mean square");
    }
    if (!isnan(largest))
        snprintf(c->note, sizeof c->note, "largest %.2g rad; smallest p %.2g, %.2g by Sidak over %zu R_r",
                 largest, smallest_p, rl_sidak_p(smallest_p, (double)n), n);
    rl_judging_conclude(c, step, n, "of the root mean square");
    return RL_OK;
}

/* How far stored normals still follow D: by the cdf's distance. Where it holds at every R_r, the farthest is its number. */
static int claim_cdf(const struct rl_judging *j, const double *rr, size_t n, const char *bits,
                     const char *text)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "fit";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = largest_map(j, bits, rr[i]);
        const struct rl_metric *k = r ? rl_record_metric(r, "kolmogorov") : NULL;
        if (!k)
            continue;
        step[i] = share_of(k, 1.0, rr[i], cdf_bound);
        show_largest(c, &step[i], "of U");
    }
    rl_judging_conclude(c, step, n, "of U");
    return RL_OK;
}

/* Of delta's misfit and theta's the one that decides. */
static const struct rl_metric *worse_misfit(const struct rl_record *r)
{
    const struct rl_metric *delta = rl_record_metric(r, "misfit_delta"),
                           *theta = rl_record_metric(r, "misfit_theta");
    if (!delta || !theta)
        return NULL;
    if (fmax(delta->low, theta->low) > misfit_bound)
        return delta->low > theta->low ? delta : theta;
    return delta->high > theta->high ? delta : theta;
}

/* By the bins of chi-square, which sees levels however fine if there are texels enough, and nothing if there are few: so that its p is
 * for the note, and the misfit's size decides. */
static int claim_bins(const struct rl_judging *j, const double *rr, size_t n, const char *bits,
                      const char *text)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "misfit";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    double smallest = NAN, n_tests = number_of_tests(j->run);
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = largest_map(j, bits, rr[i]);
        const struct rl_metric *m = r ? worse_misfit(r) : NULL;
        if (!m)
            continue;
        smallest = fmin(smallest, smaller_p(r));
        step[i] = share_of(m, 1.0, rr[i], misfit_bound);
        show_largest(c, &step[i], "of a bin's share");
    }
    if (!isnan(smallest))
        snprintf(c->note, sizeof c->note,
                 "chi-square: smallest p %.2g, %.2g by Sidak over the run's %g tests", smallest,
                 rl_sidak_p(smallest, n_tests), n_tests);
    rl_judging_conclude(c, step, n, "of a bin's share");
    return RL_OK;
}

/* How far the mean normal is turned by storing: of an 8-bit map in its own steps, of half floats in widths of the lobe, which is
 * where it shows. */
static int claim_tilt_8(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: 8 bits do not tilt the mean normal: at every R_r by less than a tenth of a "
           "step of 2/255, zero having no level of its own");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "tilt";
    size_t with_zero = 0;
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = largest_map(j, "8", rr[i]);
        const struct rl_metric *t = r ? rl_record_metric(r, "tilt") : NULL;
        if (!t)
            continue;
        with_zero += t->low <= 0.0;
        if (!(t->high <= c->high))
            rl_claim_value(c, t->value, t->low, t->high, "rad");
    }
    snprintf(c->note, sizeof c->note, "the largest of %zu R_r, of which %zu have zero in the interval", n,
             with_zero);
    c->verdict = rl_verdict_at_most(c->low, c->high, 0.1 * 2.0 * RL_STEP_OF_8_BITS);
    return RL_OK;
}

static int claim_tilt_half(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: half floats, whose steps are finer on one side of N than on the other, tilt "
           "the mean normal by less than 1 % of the lobe's median delta");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "tilt";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = largest_map(j, "half", rr[i]);
        const struct rl_metric *t = r ? rl_record_metric(r, "tilt") : NULL,
                               *median = r ? rl_record_metric(r, "d_median") : NULL;
        if (!t || !median)
            continue;
        step[i] = share_of(t, median->value, rr[i], 0.01);
        show_largest(c, &step[i], "of the median");
    }
    rl_judging_conclude(c, step, n, "of the median");
    return RL_OK;
}

static int claim_width(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: the lobe that an 8-bit map holds is as wide as D's (median delta, to within "
           "10 %)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "width";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = largest_map(j, "8", rr[i]);
        const struct rl_metric *w = r ? rl_record_metric(r, "width") : NULL;
        if (!w)
            continue;
        step[i] =
            (struct rl_step){rr[i], w->value, w->low, w->high, rl_verdict_equals(w->low, w->high, 1.0, 0.1)};
        if (!(fabs(w->value - 1.0) <= fabs(c->value - 1.0)))
            rl_claim_value(c, w->value, w->low, w->high, "times");
    }
    rl_judging_conclude(c, step, n, "times");
    return RL_OK;
}

/* At the paper's N = 4. */
static const struct rl_record *point(const struct rl_judging *j, const char *generator, const char *bits)
{
    char pattern[96];
    snprintf(pattern, sizeof pattern, "series=point generator=%s normal_bits=%s samples=4", generator, bits);
    return rl_run_find(j->run, RL_NO_SCENE, pattern);
}

static const struct rl_metric *at_point(const struct rl_judging *j, const char *generator, const char *bits,
                                        const char *metric)
{
    const struct rl_record *r = point(j, generator, bits);
    return r ? rl_record_metric(r, metric) : NULL;
}

/* All pixels have the same error, so that its share of bias is 1 by construction. How much there is of it, is not: whatever the numbers,
 * the mean of N has the same variance, and all of a hash's is noise. */
static int claim_restarted(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "paper: a linear congruential generator restarted at every pixel has bias in place of noise: "
           "at least half as much as a hash of each pixel has noise (ratio, N = 4)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "generators";
    const struct rl_metric *bias = at_point(j, "lcg", "float", "floor"),
                           *noise = at_point(j, "lcg", "float", "noise"),
                           *hash = at_point(j, "hash", "float", "noise"),
                           *hash_bias = at_point(j, "hash", "float", "floor");
    if (!bias || !noise || !hash || !hash_bias)
        return RL_OK;
    rl_judging_ratio(c, bias, hash, "times");
    snprintf(c->note, sizeof c->note,
             "bias %.3g (root mean square over seeds), noise %.3g; a hash of each pixel: %.2g, %.3g",
             bias->value, noise->value, hash_bias->value, hash->value);
    c->verdict = rl_verdict_at_least(c->low, c->high, 0.5);
    return RL_OK;
}

/* The paper's map has 8 bits, so that its rounding is part of what is claimed; a float map shows what the numbers alone do. */
static int claim_baked(const struct rl_judging *j, const char *bits, const char *other, const char *text)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "generators";
    const struct rl_metric *b = at_point(j, "baked", bits, "bias"),
                           *beside = at_point(j, "baked", other, "bias");
    if (!b)
        return RL_OK;
    rl_claim_value(c, b->value, b->low, b->high, "1");
    if (beside)
        snprintf(c->note, sizeof c->note, "%s map: %.2g [%.2g, %.2g]",
                 strcmp(other, "8") == 0 ? "8-bit" : other, beside->value, beside->low, beside->high);
    c->verdict = rl_verdict_equals(c->low, c->high, 0.0, RL_STEP_OF_8_BITS);
    return RL_OK;
}

static int claim_baked_8(const struct rl_judging *j)
{
    return claim_baked(j, "8", "float",
                       "paper: random numbers baked into a map serve: no bias (mean error of 4 normals to "
                       "within 1/255, from an 8-bit map as the paper's is)");
}

static int claim_baked_float(const struct rl_judging *j)
{
    return claim_baked(j, "float", "8",
                       "ours: random numbers baked into a float map have no bias (mean error of 4 normals to "
                       "within 1/255)");
}

static int claim_hash(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: normals from a map are as noisy as those of a hash of each pixel (ratio of "
           "noise, to within 5 %, N = 4)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "generators";
    const struct rl_metric *a = at_point(j, "baked", "float", "noise"),
                           *b = at_point(j, "hash", "float", "noise");
    if (!a || !b || !(b->low > 0.0))
        return RL_OK;
    rl_claim_value(c, a->value / b->value, a->low / b->high, a->high / b->low, "times");
    c->verdict = rl_verdict_equals(c->low, c->high, 1.0, 0.05);
    return RL_OK;
}

int rl_distribution_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    static const struct {
        int (*claim)(const struct rl_judging *j, const double *rr, size_t n, const char *bits,
                     const char *text);
        const char *bits, *text;
    } of_bits[] = {
        {claim_cdf, "float",
         "paper: normals by the inverse cdf follow D at every R_r: the cdf of a float map's normals is "
         "within "
         "0.01 of D's"},
        {claim_bins, "float",
         "ours: a float map's normals fill 64 bins of delta and 64 of theta as D does, to within 2 % of a "
         "bin (root mean square)"},
        {claim_cdf, "8",
         "paper: 8 bits make almost no difference: the cdf of an 8-bit map's normals is within 0.01 of D's"},
        {claim_cdf, "16", "ours: 16 bits do: the cdf of a 16-bit map's normals is within 0.01 of D's"},
        {claim_bins, "8",
         "ours: an 8-bit map's normals fill 64 bins of delta and 64 of theta as D does, to within 2 % of a "
         "bin (root mean square)"},
        {claim_bins, "16",
         "ours: a 16-bit map's normals fill 64 bins of delta and 64 of theta as D does, to within 2 % of a "
         "bin (root mean square)"},
    };
    int (*const of_maps[])(const struct rl_judging *, const double *,
                           size_t) = {claim_lean, claim_tilt_8, claim_tilt_half, claim_width};
    int (*const of_points[])(const struct rl_judging *) = {claim_restarted, claim_baked_8, claim_baked_float,
                                                           claim_hash};
    const struct rl_judging j = {run, RL_NO_SCENE, claims, error};
    double rr[RL_AXIS_MAX];
    size_t n = rl_judging_axis(&j, "series=map", "rr", rr);
    int status = RL_OK;
    for (size_t k = 0; k < sizeof of_bits / sizeof of_bits[0] && status == RL_OK; k++)
        status = of_bits[k].claim(&j, rr, n, of_bits[k].bits, of_bits[k].text);
    for (size_t k = 0; k < sizeof of_maps / sizeof of_maps[0] && status == RL_OK; k++)
        status = of_maps[k](&j, rr, n);
    for (size_t k = 0; k < sizeof of_points / sizeof of_points[0] && status == RL_OK; k++)
        status = of_points[k](&j);
    return status;
}
