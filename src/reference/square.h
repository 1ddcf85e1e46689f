/* The definition of L_o as an integral over the unit square, for the integrators that sample it:
 *
 *     L_o = integral over U in [0,1], W in [0,1) of G L_e(P, L) dU dW,    delta = delta(U), theta = pi W
 *
 * U is the distribution's own cdf, so that uniform points are microfacet normals drawn from D.
 */
#ifndef RL_REFERENCE_SQUARE_H
#define RL_REFERENCE_SQUARE_H

#include "model/frame.h"
#include "reference/cast.h"
#include "reference/integrator.h"

struct rl_square {
    const struct rl_ellipsoid *e;
    const struct rl_light_set *set;
    rl_vec3 V;
    bool attenuation;
    struct rl_frame frame;
    struct rl_cast cast;
};

/* Keeps `e` and `set`. */
int rl_square_make(struct rl_square *square, const struct rl_surface *surface, const struct rl_ellipsoid *e,
                   const struct rl_light_set *set, const struct rl_integrate_options *options,
                   struct rl_error *error);
void rl_square_free(struct rl_square *square);

/* The integrand. Returns G and the index of the radiance that L meets; RL_CAST_MISS and 0 for none. */
double rl_square_sample(size_t *radiance, const struct rl_square *square, double u, double w);

/* How many standard errors make the interval of options->confidence. */
double rl_square_quantile(const struct rl_integrate_options *options);

/* A 64-bit seed for GSL's generators, which take 32 bits and make 0 their own default (4357): two seeds below 2^32 - 1 never come
 * out the same. */
unsigned long rl_square_seed(uint64_t seed);

#endif
