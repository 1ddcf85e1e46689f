/* The integrators of L_o at one point, one row each: the reference and its independent witnesses.
 *
 * All answer the same question (integrator.h) and say how far off they may be; no two share a formula beyond D and G. A row is
 * one file, src/reference/NAME.c, and its line in integrators.c.
 *
 *     const struct rl_integrator *it = rl_integrator_find("reference");
 *     status = it->integrate(&estimate, &surface, &ellipsoid, set, &options, &error);
 */
#ifndef RL_REFERENCE_INTEGRATORS_H
#define RL_REFERENCE_INTEGRATORS_H

#include "reference/integrator.h"

struct rl_integrator {
    const char *name;
    const char *summary;
    const char *evaluation; /* what it counts: "lines", "samples", ... */
    const char *error;      /* what its error means, in words */
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
