/* `montecarlo`: the mean of G L_e over microfacet normals drawn from D, with a confidence interval.
 *
 * A sample lies in [0, B], B the brightest radiance of its channel, and for small or large lights nearly all samples are equal: their
 * variance is then 0 although the mean is not known. So the interval is that of Agresti and Coull (1998), z^2/2 samples of 0 and as
 * many of B added to those drawn, for values between 0 and B as well as at the ends:
 *
 *     n~ = n + z^2,  mean~ and var~ over all of them,  |mean~ - L_o| <= z sqrt(var~/n~) at the level of z
 *
 * The value is the plain mean, which has no bias; the error is that half width and the distance from mean~. With n samples that all
 * miss it is 1.2 z^2 B/n, 8 B/n at 99 % (the rule of three would say 4.6 B/n).
 *
 * How many are drawn is decided from the error of those drawn so far, twice or three times in all: too seldom for the interval to
 * suffer from being looked at (tests/reference/test_witnesses.c measures its coverage).
 */
#include <gsl/gsl_rng.h>
#include <string.h>

#include "reference/integrators.h"
#include "reference/square.h"

enum { SAMPLES_AT_FIRST = 4096, SAMPLES_MOST = 20000000 };

struct tally {
    size_t n;
    double sum[3], squares[3];
};

static void draw(struct tally *tally, const struct rl_square *square, gsl_rng *rng, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        size_t radiance;
        double u = gsl_rng_uniform_pos(rng), w = gsl_rng_uniform(rng);
        double G = rl_square_sample(&radiance, square, u, w);
        for (int c = 0; c < 3 && radiance != RL_CAST_MISS; c++) {
            double x = G * square->set->radiance[radiance][c];
            tally->sum[c] += x;
            tally->squares[c] += x * x;
        }
    }
    tally->n += n;
}

/* Mean and interval so far; returns the largest channel's error. */
static double conclude(struct rl_estimate *estimate, const struct tally *tally,
                       const struct rl_light_set *set, double z)
{
    double n = (double)tally->n, half = 0.5 * z * z, n_all = n + z * z, largest = 0.0;
    for (int c = 0; c < 3; c++) {
        double brightest = rl_cast_brightest(set, c);
        double mean = (tally->sum[c] + half * brightest) / n_all;
        double variance = (tally->squares[c] + half * brightest * brightest) / n_all - mean * mean;
        estimate->value[c] = tally->sum[c] / n;
        estimate->error[c] = fabs(mean - estimate->value[c]) + z * sqrt(fmax(0.0, variance) / n_all);
        largest = fmax(largest, estimate->error[c]);
    }
    estimate->evaluations = tally->n;
    return largest;
}

static void sample(struct rl_estimate *estimate, const struct rl_square *square, gsl_rng *rng,
                   const struct rl_integrate_options *options)
{
    size_t most = options->max_evaluations ? options->max_evaluations : SAMPLES_MOST;
    double z = rl_square_quantile(options), tolerance = options->tolerance * square->set->brightest;
    struct tally tally = {0};
    size_t more = most < SAMPLES_AT_FIRST ? most : SAMPLES_AT_FIRST;
    while (more > 0) {
        draw(&tally, square, rng, more);
        double error = conclude(estimate, &tally, square->set, z);
        estimate->converged = error <= tolerance;
        if (estimate->converged)
            return;
        /* The error goes down as 1/sqrt(n), or as 1/n where nearly all samples are equal: asking for the former, a little more than
         * enough, and at most 64 times as many at once, since the first variances are rough. */
        double ratio = tolerance > 0.0 ? error / tolerance : INFINITY;
        double wanted = (double)tally.n * fmin(64.0, 1.02 * ratio * ratio);
        more = wanted < (double)most ? (size_t)wanted + 1 - tally.n : most - tally.n;
    }
}

static int integrate(struct rl_estimate *estimate, const struct rl_surface *surface,
                     const struct rl_ellipsoid *e, const struct rl_light_set *set,
                     const struct rl_integrate_options *options, struct rl_error *error)
{
    memset(estimate, 0, sizeof *estimate);
    estimate->converged = true;
    if (rl_cast_needless(surface, set))
        return RL_OK;
    struct rl_square square;
    int status = rl_square_make(&square, surface, e, set, options, error);
    if (status != RL_OK)
        return status;
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    if (rng) {
        gsl_rng_set(rng, rl_square_seed(options->seed));
        sample(estimate, &square, rng, options);
        gsl_rng_free(rng);
    } else {
        status = rl_fail_memory(error, "the random numbers");
    }
    rl_square_free(&square);
    return status;
}

const struct rl_integrator rl_integrator_montecarlo = {
    .name = "montecarlo",
    .summary = "random microfacet normals drawn from D, a ray for each",
    .evaluation = "samples",
    .error = "half width of a confidence interval",
    .uses = RL_USES_TOLERANCE | RL_USES_MAX_EVALUATIONS | RL_USES_SEED | RL_USES_CONFIDENCE,
    .default_tolerance = 1e-3,
    .default_evaluations = SAMPLES_MOST,
    .integrate = integrate,
};
