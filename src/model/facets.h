/* Distributions of microfacet normals over solid angle: area of facets whose normal lies delta from N, per area of the surface and
 * steradian of normals, so that the integral of D cos(delta) over the hemisphere is 1.
 *
 *     Beckmann (1963)                        D = exp(-tan^2(delta)/m^2) / (pi m^2 cos^4(delta)),   m: rms slope
 *     ellipsoid (Trowbridge, Reitz 1975)     D = R^2 / (pi (cos^2(delta) + R^2 sin^2(delta))^2),   R = R_r = 1/m
 *
 * The ellipsoid is that of model/ellipsoid.h, squared: there D(delta) is a density per radian along a line through N. Known also as GGX
 * of alpha = 1/R (Walter et al. 2007), and as Blinn's third (1977). Both take the sine squared, since a narrow lobe is one in the sine,
 * which the cosine does not resolve; and 1 - sin^2 is the more accurate square of a cosine near 1, whose error counts four times. */
#ifndef RL_MODEL_FACETS_H
#define RL_MODEL_FACETS_H

#include "model/vec3.h"

static inline double rl_facets_cos_cos(double cos_delta, double sin_sin)
{
    return sin_sin < 0.25 ? 1.0 - sin_sin : cos_delta * cos_delta;
}

/* cos(delta) > 0; 1/sr. */
static inline double rl_facets_beckmann(double cos_delta, double sin_sin, double m)
{
    double cc = rl_facets_cos_cos(cos_delta, sin_sin);
    double x = sin_sin / (cc * m * m);
    /* Past this D is 0 in double precision for any m >= 1e-12, and the quotient of 0 by 0 is near. */
    if (!(x < 810.0))
        return 0.0;
    /* The square of exp(-x/2)/(m cos^2): neither the exponential nor the powers leave the range of numbers before D does. */
    double root = exp(-0.5 * x) / (m * cc);
    return root * root / RL_PI;
}

static inline double rl_facets_ellipsoid(double cos_delta, double sin_sin, double m)
{
    /* R^2/(cos^2 + R^2 sin^2)^2 with R = 1/m, times m^4 above and below, and as a square: m^4 alone may underflow in single precision. */
    double q = m / (m * m * rl_facets_cos_cos(cos_delta, sin_sin) + sin_sin);
    return q * q / RL_PI;
}

#endif
