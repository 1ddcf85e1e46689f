/* The integrators of L_o at one point, one row each: the reference and its independent witnesses.
 *
 * All answer the same question (integrator.h) and say how far off they may be. `reference`, `montecarlo` and `cubature` share no
 * formula beyond D and G; those over the unit square (montecarlo, vegas, cubature-uv) share its definition, square.h. A row is one
 * file, src/reference/NAME.c, and its line in integrators.c.
 *
 *     const struct rl_integrator *it = rl_integrator_find("reference");
 *     status = it->integrate(&estimate, &surface, &ellipsoid, set, &options, &error);
 */
#ifndef RL_REFERENCE_INTEGRATORS_H
#define RL_REFERENCE_INTEGRATORS_H

#include "reference/integrator.h"

/* The options that make a difference to an integrator; attenuation and frame do to all. */
enum rl_integrator_uses {
    RL_USES_TOLERANCE = 1,
    RL_USES_MAX_EVALUATIONS = 2,
    RL_USES_SEED = 4,
    RL_USES_CONFIDENCE = 8,
    RL_USES_ENV_SIZE = 16
};

struct rl_integrator {
    const char *name;
    const char *summary;
    const char *evaluation;     /* what it counts: "lines", "samples", ... */
    const char *error;          /* what its error means, in words */
    unsigned uses;              /* enum rl_integrator_uses, or-ed */
    double default_tolerance;   /* what a user gets who asks for none */
    size_t default_evaluations; /* what max_evaluations = 0 stands for; 0: unlimited, or none to limit */
    /* Thread-safe. RL_ERR_INPUT if it cannot take these options or lights; not converging is no failure. */
    int (*integrate)(struct rl_estimate *estimate, const struct rl_surface *surface,
                     const struct rl_ellipsoid *e, const struct rl_light_set *set,
                     const struct rl_integrate_options *options, struct rl_error *error);
};

extern const struct rl_integrator *const rl_integrators[];
extern const size_t rl_n_integrators;

/* NULL if there is none of that name. */
const struct rl_integrator *rl_integrator_find(const char *name);

#endif
