/* Texels near a pole of the weight, in double precision (see texel_map.h for the idea).
 *
 * With M = V + L, y its part in the tangent plane and n = M.N, the weight w (texel_sum.h) is F/|y|, where
 *
 *     F = norm/(2 pi R) |n| min(g, Q) / (p sqrt(Q)),  p = n^2/R + R |y|^2
 *
 * is smooth over a texel that is small against the lobe, |y| = |n|/R, or against |y| itself. Over the texel's image, a polygon in the
 * plane of y, 1/|y| integrates in closed form: the triangle from the origin over an edge that lies at distance d from it, from e_0 to
 * e_1 along it, gives d (asinh(e_1/d) - asinh(e_0/d)), signed.
 */
#ifndef RL_REFERENCE_TEXEL_POLE_H
#define RL_REFERENCE_TEXEL_POLE_H

#include <stdbool.h>

#include "effects/effect.h"
#include "model/ellipsoid.h"
#include "model/frame.h"
#include "reference/cube_map.h"

struct rl_texel_pole {
    struct rl_frame frame;
    rl_vec3 v;        /* V in it */
    double rr, scale; /* norm/(2 pi R) */
    double reach;     /* |y| below this is near */
    bool attenuation;
};

struct rl_texel_pole rl_texel_pole_make(const struct rl_surface *surface, const struct rl_ellipsoid *e,
                                        bool attenuation, double reach);

/* Directions are places (s, t) on a face of a cube map. */

/* w, |y| held at the reach or more. */
double rl_texel_weight(const struct rl_texel_pole *pole, int face, double s, double t);

double rl_texel_distance(const struct rl_texel_pole *pole, int face, double s, double t); /* |y| */

/* The solid angle of the square s +- half, t +- half by its Taylor series at the centre, good to half^4: quicker than
 * rl_cube_solid_angle. */
double rl_texel_solid_angle(double s, double t, double half);

/* Of the half edge of a square, times R_r: below this N.V, what weight there is above the horizon is too low for rl_texel_integral. */
#define RL_TEXEL_GRAZING 0x1p-12

/* The integral of w over the square s +- half, t +- half of a face; *evaluations grows by the squares looked at. */
double rl_texel_integral(const struct rl_texel_pole *pole, int face, double s, double t, double half,
                         size_t *evaluations);

#endif
