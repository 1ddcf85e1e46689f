/* The claims that the study `distribution` judges. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "measure/goodness.h"
#include "studies/distribution.h"
#include "studies/judging.h"

static const double cdf_bound = 0.01;

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

/* The inverse cdf: no test of any float map fails, and no cdf is far. The number is the farthest of the largest maps. */
static int claim_inverse(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(
        j, "paper: normals by the inverse cdf follow D at every R_r (float maps: chi-square of "
           "delta and theta pass; the cdf is within 0.01)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "fit";
    double smallest = 1.0, n_tests = number_of_tests(j->run);
    for (const struct rl_record *r = NULL;
         (r = rl_run_next(j->run, r, RL_NO_SCENE, "series=map normal_bits=float"));)
        smallest = fmin(smallest, smaller_p(r));
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = largest_map(j, "float", rr[i]);
        const struct rl_metric *k = r ? rl_record_metric(r, "kolmogorov") : NULL;
        if (k && !(k->high <= c->high))
            rl_claim_value(c, k->value, k->low, k->high, "of U");
    }
    snprintf(c->note, sizeof c->note, "smallest p %.2g, %.2g by Sidak over the run's %g tests", smallest,
             rl_sidak_p(smallest, n_tests), n_tests);
    c->verdict = rl_verdict_at_most(c->low, c->high, cdf_bound);
    if (smallest < rl_sidak_level(RL_DISTRIBUTION_LEVEL, n_tests)) {
        double corrected = rl_sidak_p(smallest, n_tests);
        c->verdict = RL_VERDICT_FAILS;
        rl_claim_value(c, corrected, corrected, corrected, "p, Sidak");
    }
    return RL_OK;
}

/* The chance that a mean without any lean of its own is as long: its two components are normal, of one standard error at most, which
 * the interval's half width holds 2.448 times. */
static double lean_p(const struct rl_metric *mean_tilt)
{
    double errors = 2.448 * mean_tilt->value / (mean_tilt->high - mean_tilt->value);
    return exp(-0.5 * errors * errors);
}

/* The mean direction of what was drawn, before storing turns it. */
static int claim_lean(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c =
        rl_judging_claim(j, "ours: the normals drawn do not lean: their mean direction is that of D, N, "
                            "at every R_r (float maps, at 1 % over all R_r)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "tilt";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    double largest = NAN;
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = largest_map(j, "float", rr[i]);
        const struct rl_metric *m = r ? rl_record_metric(r, "mean_tilt") : NULL;
        if (!m)
            continue;
        double p = rl_sidak_p(lean_p(m), (double)n);
        step[i] = (struct rl_step){rr[i], p, p, p,
                                   p >= RL_DISTRIBUTION_LEVEL ? RL_VERDICT_HOLDS : RL_VERDICT_FAILS};
        largest = fmax(largest, m->value);
        if (!(p >= c->value))
            rl_claim_value(c, p, p, p, "p, Sidak");
    }
    if (!isnan(largest))
        snprintf(c->note, sizeof c->note, "largest %.2g rad", largest);
    rl_judging_conclude(c, step, n, "p, Sidak");
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
        step[i] = (struct rl_step){rr[i], k->value, k->low, k->high,
                                   rl_verdict_at_most(k->low, k->high, cdf_bound)};
        if (!(k->value <= c->value))
            rl_claim_value(c, k->value, k->low, k->high, "of U");
    }
    rl_judging_conclude(c, step, n, "of U");
    return RL_OK;
}

/* By chi-square, which sees levels however fine if there are texels enough. Where all pass the smallest p is its number. */
static int claim_chi_square(const struct rl_judging *j, const double *rr, size_t n, const char *bits,
                            const char *text)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "histogram";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    double n_tests = number_of_tests(j->run), level = rl_sidak_level(RL_DISTRIBUTION_LEVEL, n_tests);
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = largest_map(j, bits, rr[i]);
        if (!r)
            continue;
        double p = smaller_p(r), corrected = rl_sidak_p(p, n_tests);
        step[i] = (struct rl_step){rr[i], corrected, corrected, corrected,
                                   p >= level ? RL_VERDICT_HOLDS : RL_VERDICT_FAILS};
        if (!(corrected >= c->value))
            rl_claim_value(c, corrected, corrected, corrected, "p, Sidak");
    }
    rl_judging_conclude(c, step, n, "p, Sidak");
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
        const struct rl_metric *t = r ? rl_record_metric(r, "tilt") : NULL;
        if (!t)
            continue;
        struct rl_ellipsoid e = rl_ellipsoid_make(rr[i]);
        double width = rl_ellipsoid_inverse(&e, 0.75).delta;
        step[i] = (struct rl_step){rr[i], t->value / width, t->low / width, t->high / width,
                                   rl_verdict_at_most(t->low / width, t->high / width, 0.01)};
        if (!(t->value / width <= c->value))
            rl_claim_value(c, t->value / width, t->low / width, t->high / width, "of the median");
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

static int claim_baked(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "paper: random numbers baked into a map serve: no bias (mean error of 4 normals to "
           "within 1/255, float map)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "generators";
    const struct rl_metric *b = at_point(j, "baked", "float", "bias"),
                           *eight = at_point(j, "baked", "8", "bias");
    if (!b || !eight)
        return RL_OK;
    rl_claim_value(c, b->value, b->low, b->high, "1");
    snprintf(c->note, sizeof c->note, "from an 8-bit map %.2g, %.2g to %.2g", eight->value, eight->low,
             eight->high);
    c->verdict = rl_verdict_equals(c->low, c->high, 0.0, RL_STEP_OF_8_BITS);
    return RL_OK;
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
    const struct rl_judging j = {run, RL_NO_SCENE, claims, error};
    double rr[RL_AXIS_MAX];
    size_t n = rl_judging_axis(&j, "series=map", "rr", rr);
    int status = claim_inverse(&j, rr, n);
    if (status == RL_OK)
        status = claim_lean(&j, rr, n);
    if (status == RL_OK)
        status =
            claim_cdf(&j, rr, n, "8",
                      "paper: 8 bits make almost no difference: the cdf of an 8-bit map's normals is within "
                      "0.01 of D's");
    if (status == RL_OK)
        status = claim_cdf(&j, rr, n, "16",
                           "ours: 16 bits do: the cdf of a 16-bit map's normals is within 0.01 of D's");
    if (status == RL_OK)
        status = claim_chi_square(
            &j, rr, n, "8",
            "ours: an 8-bit map's normals pass chi-square of delta and theta, at 1 % over all tests");
    if (status == RL_OK)
        status = claim_chi_square(
            &j, rr, n, "16",
            "ours: a 16-bit map's normals pass chi-square of delta and theta, at 1 % over all tests");
    if (status == RL_OK)
        status = claim_tilt_8(&j, rr, n);
    if (status == RL_OK)
        status = claim_tilt_half(&j, rr, n);
    if (status == RL_OK)
        status = claim_width(&j, rr, n);
    int (*const claim[])(const struct rl_judging *) = {claim_restarted, claim_baked, claim_hash};
    for (size_t k = 0; k < sizeof claim / sizeof claim[0] && status == RL_OK; k++)
        status = claim[k](&j);
    return status;
}
