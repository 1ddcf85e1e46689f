/* `cubature-uv`: hcubature over the unit square of (U, theta/pi), straight from the definition.
 *
 * It is here to show why that is no ground truth. The integrand jumps at every edge of a light, and the rule of 17 points that
 * hcubature (Genz and Malik 1980; Berntsen, Espelid and Genz 1991) starts from may miss a small light altogether: it then reports the
 * value 0 with the error 0. The error is hcubature's own, passed on as it is.
 */
#include <cubature.h>
#include <string.h>

#include "reference/integrators.h"
#include "reference/square.h"

#define EVALUATIONS_MOST ((size_t)5000000)
/* Points of hcubature's rule in two dimensions. It takes two more rules at a time until it is past its limit. */
#define RULE ((size_t)17)

struct count {
    const struct rl_square *square;
    size_t evaluations;
};

static int integrand_at(unsigned dimension, const double *x, void *user, unsigned n_values, double *value)
{
    (void)dimension;
    struct count *count = user;
    size_t radiance;
    count->evaluations++;
    double G = rl_square_sample(&radiance, count->square, x[0], x[1]);
    for (unsigned c = 0; c < n_values; c++)
        value[c] = radiance == RL_CAST_MISS ? 0.0 : G * count->square->set->radiance[radiance][c];
    return 0;
}

static int integrate(struct rl_estimate *estimate, const struct rl_surface *surface,
                     const struct rl_ellipsoid *e, const struct rl_light_set *set,
                     const struct rl_integrate_options *options, struct rl_error *error)
{
    memset(estimate, 0, sizeof *estimate);
    estimate->converged = true;
    if (rl_cast_needless(surface, set))
        return RL_OK;
    size_t most = options->max_evaluations ? options->max_evaluations : EVALUATIONS_MOST;
    if (most < RULE) {
        rl_cast_unknown(estimate, set);
        return RL_OK;
    }
    struct rl_square square;
    int status = rl_square_make(&square, surface, e, set, options, error);
    if (status != RL_OK)
        return status;
    struct count count = {.square = &square};
    const double low[2] = {0.0, 0.0}, high[2] = {1.0, 1.0};
    double tolerance = options->tolerance * set->brightest;
    if (hcubature(3, integrand_at, &count, 2, low, high, most > 2 * RULE ? most - 2 * RULE : 1, tolerance,
                  0.0, ERROR_LINF, estimate->value, estimate->error) != 0)
        status = rl_fail_memory(error, "hcubature");
    estimate->evaluations = count.evaluations;
    for (int c = 0; c < 3; c++)
        estimate->converged = estimate->converged && estimate->error[c] <= tolerance;
    rl_square_free(&square);
    return status;
}

const struct rl_integrator rl_integrator_cubature_uv = {
    .name = "cubature-uv",
    .summary = "hcubature over the unit square: no ground truth, shown as such",
    .evaluation = "points",
    .error = "hcubature's own, and may be false",
    .uses = RL_USES_TOLERANCE | RL_USES_MAX_EVALUATIONS,
    .default_tolerance = 1e-4,
    .default_evaluations = EVALUATIONS_MOST,
    .integrate = integrate,
};
