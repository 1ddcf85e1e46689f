/* `vegas`: Monte Carlo over the unit square with adaptive importance sampling (Lepage 1978, as in GSL).
 *
 * A few iterations on a grid that learns where the integrand is large, then runs of ITERATIONS on the grid learnt, each run larger
 * than the last and taken by itself, until one is within the tolerance. Its error is the standard error times the quantile of
 * options->confidence, times sqrt(chi^2/dof) where the iterations scatter by more than they claim, and z^2 B/n on top: where all of n
 * points miss (or all hit) VEGAS claims 0. Points that the grid has learnt to avoid are still believed to be dark, so that a small
 * light that the first iterations missed may be missed for good within the stated error: one reason why this is a subject of the
 * benchmark and no ground truth.
 */
#include <gsl/gsl_monte_vegas.h>
#include <string.h>

#include "reference/integrators.h"
#include "reference/square.h"

/* CALLS_LEAST: points an iteration below which its variance says nothing; LEAST: what a channel needs then. */
enum {
    ITERATIONS = 5,
    LEARNING_CALLS = 10000,
    CALLS_AT_FIRST = 20000,
    CALLS_LEAST = 200,
    LEAST = 5 * ITERATIONS * CALLS_LEAST,
    CALLS_MOST = 20000000
};

struct channel {
    const struct rl_square *square;
    int c;
    size_t evaluations;
};

static double integrand_at(double *x, size_t dimension, void *user)
{
    (void)dimension;
    struct channel *channel = user;
    size_t radiance;
    channel->evaluations++;
    double G = rl_square_sample(&radiance, channel->square, x[0], x[1]);
    return radiance == RL_CAST_MISS ? 0.0 : G * channel->square->set->radiance[radiance][channel->c];
}

struct machine {
    gsl_monte_vegas_state *state;
    gsl_rng *rng;
};

/* One stage: ITERATIONS of `calls` points or a few fewer. */
static void iterate(double *value, double *error, struct channel *channel, struct machine *machine, int stage,
                    double calls)
{
    gsl_monte_function f = {integrand_at, 2, channel};
    double low[2] = {0.0, 0.0}, high[2] = {1.0, 1.0};
    machine->state->stage = stage;
    gsl_monte_vegas_integrate(&f, low, high, 2, (size_t)calls, machine->rng, machine->state, value, error);
}

/* Returns whether the tolerance was reached within `most` points, of which a quarter at most goes into learning. */
static bool integrate_channel(double *value, double *error, struct channel *channel, struct machine *machine,
                              const struct rl_integrate_options *options, double most)
{
    double z = rl_square_quantile(options), brightest = channel->square->set->brightest;
    double tolerance = options->tolerance * brightest, calls = CALLS_AT_FIRST;
    gsl_monte_vegas_init(machine->state);
    iterate(value, error, channel, machine, 0, fmin(LEARNING_CALLS, 0.25 * most / ITERATIONS));
    for (;;) {
        double spent = (double)channel->evaluations;
        calls = fmin(calls, (most - spent) / ITERATIONS);
        if (calls < CALLS_LEAST)
            return false;
        iterate(value, error, channel, machine, 1, calls); /* 1: keeps the grid, forgets the result */
        double points = (double)channel->evaluations - spent;
        double scatter = gsl_monte_vegas_chisq(machine->state);
        *error = z * *error * sqrt(fmax(1.0, scatter)) + z * z * brightest / points;
        if (*error <= tolerance)
            return true;
        double ratio = tolerance > 0.0 ? *error / tolerance : INFINITY;
        calls *= fmin(16.0, fmax(2.0, 1.1 * ratio * ratio));
    }
}

/* The first channel in which all radiances are what they are in channel c. */
static int same_as(const struct rl_light_set *set, int c)
{
    for (int as = 0; as < c; as++) {
        bool same = true;
        for (size_t i = 0; i < set->n_radiances; i++)
            same = same && set->radiance[i][as] == set->radiance[i][c];
        if (same)
            return as;
    }
    return c;
}

static void integrate_channels(struct rl_estimate *estimate, const struct rl_square *square,
                               struct machine *machine, const struct rl_integrate_options *options,
                               double most)
{
    for (int c = 0; c < 3; c++) {
        int as = same_as(square->set, c);
        if (as < c) {
            estimate->value[c] = estimate->value[as];
            estimate->error[c] = estimate->error[as];
            continue;
        }
        struct channel channel = {.square = square, .c = c};
        bool reached =
            integrate_channel(&estimate->value[c], &estimate->error[c], &channel, machine, options, most);
        estimate->converged = estimate->converged && reached;
        estimate->evaluations += channel.evaluations;
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
    int channels = 1 + (same_as(set, 1) == 1) + (same_as(set, 2) == 2);
    double most = (double)(options->max_evaluations ? options->max_evaluations : CALLS_MOST) / channels;
    if (most < LEAST) {
        rl_cast_unknown(estimate, set);
        return RL_OK;
    }
    struct rl_square square;
    int status = rl_square_make(&square, surface, e, set, options, error);
    if (status != RL_OK)
        return status;
    struct machine machine = {gsl_monte_vegas_alloc(2), gsl_rng_alloc(gsl_rng_mt19937)};
    if (machine.state && machine.rng) {
        gsl_rng_set(machine.rng, rl_square_seed(options->seed));
        integrate_channels(estimate, &square, &machine, options, most);
    } else {
        status = rl_fail_memory(error, "VEGAS");
    }
    if (machine.state)
        gsl_monte_vegas_free(machine.state);
    if (machine.rng)
        gsl_rng_free(machine.rng);
    rl_square_free(&square);
    return status;
}

const struct rl_integrator rl_integrator_vegas = {
    .name = "vegas",
    .summary = "GSL's VEGAS over the unit square of (U, theta/pi)",
    .evaluation = "samples",
    .error = "half width of a confidence interval, if VEGAS found the light",
    .uses = RL_USES_TOLERANCE | RL_USES_MAX_EVALUATIONS | RL_USES_SEED | RL_USES_CONFIDENCE,
    .default_tolerance = 1e-3,
    .default_evaluations = CALLS_MOST,
    .integrate = integrate,
};
