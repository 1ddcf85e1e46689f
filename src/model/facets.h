/* Distributions of microfacet normals over solid angle: area of facets whose normal lies delta from N, per area of the surface and
 * steradian of normals, so that the integral of D cos(delta) over the hemisphere is 1.
 *
 *     Beckmann (1963)                        D = exp(-tan^2(delta)/m^2) / (pi m^2 cos^4(delta)),   m: rms slope
 *     ellipsoid (Trowbridge, Reitz 1975)     D = R^2 / (pi (cos^2(delta) + R^2 sin^2(delta))^2),   R = R_r = 1/m
 *
 * The ellipsoid is that of model/ellipsoid.h, squared: there D(delta) is a density per radian along a line through N. Known also as GGX
 * of alpha = 1/R (Walter et al. 2007), and as Blinn's third (1977). Both take the sine squared, since a narrow lobe is one in the sine,
 * which the cosine does not resolve. */
#ifndef RL_MODEL_FACETS_H
#define RL_MODEL_FACETS_H

#include "model/vec3.h"

/* cos(delta) > 0; 1/sr. */
static inline double rl_facets_beckmann(double cos_delta, double sin_sin, double m)
{
    double cc = cos_delta * cos_delta, mm = m * m;
    /* Far below anything else in the sum, and past this the quotient of 0 by 0 is near. */
    if (!(sin_sin < 700.0 * mm * cc))
        return 0.0;
    return exp(-sin_sin / (cc * mm)) / (RL_PI * mm * cc * cc);
}

static inline double rl_facets_ellipsoid(double cos_delta, double sin_sin, double m)
{
    /* R^2/(cos^2 + R^2 sin^2)^2 with R = 1/m, times m^4 above and below. */
    double q = m * m * cos_delta * cos_delta + sin_sin;
    return m * m / (RL_PI * q * q);
}

#endif
