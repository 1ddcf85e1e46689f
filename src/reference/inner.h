/* The inner integral: D(delta) G over a stretch of one line, exactly.
 *
 * On a line of fixed theta let t be the tangent direction of that azimuth, v_t = V.t, v_N = V.N, and phi the angle from N of V's
 * part in the plane of t and N: tan(phi) = v_t/v_N. Then V.H = rho cos(delta - phi) and N.L = rho cos(2 delta - phi), so that
 *
 *     masking     2 cos(phi) cos(delta) / cos(delta - phi)          less than 1 where |phi| > pi/4, between pi/2 - |phi| and |phi|
 *     shadowing   4 cos^2(delta) - masking                          less than 1 outside (phi -+ pi/2)/3
 *     horizon     N.L = 0 at delta = phi/2 -+ pi/4
 *
 * on the side of V for masking; the two swap at delta = phi. That makes five zones along the line,
 *
 *     horizon | shadowing | masking | G = 1 | masking | shadowing | horizon
 *
 * at most one of the two masking zones being there. With x = tan(delta), D d delta = norm dx / (sqrt(1 + x^2) (1 + R^2 x^2)), and
 * partial fractions give every antiderivative in arctangents and logarithms (inner.c): nothing is sampled.
 *
 * Frames: `stretch` l is 1 for an orthonormal frame. The paper's printed frame has tangents of length l < 1: the density
 * stays that of delta but the normal stands at delta' with tan(delta') = l tan(delta), and delta' takes delta's place in G.
 */
#ifndef RL_REFERENCE_INNER_H
#define RL_REFERENCE_INNER_H

#include <stdbool.h>

#include "model/ellipsoid.h"

/* An angle in [-pi/2, pi/2] by its sine and cosine. */
struct rl_angle {
    double s, c;
};

enum { RL_ZONES = 5 };

/* What one line's closed forms share. */
struct rl_inner_line {
    struct rl_angle bound[RL_ZONES + 1]; /* of the zones, as angles delta of the density, ascending */
    double sin_phi, cos_phi;
    double q, root; /* sin^2 l^2 + R^2 cos^2, and sqrt(cos^2 + l^2 sin^2), of phi */
};

/* From delta' (where the normal stands) to delta (where the density takes it). stretch in [0, 1]. */
struct rl_angle rl_inner_unstretch(struct rl_angle normal, double stretch);

/* U(b) - U(a), a <= b: the integral of D alone, as one arctangent. */
double rl_inner_mass(const struct rl_ellipsoid *e, struct rl_angle a, struct rl_angle b);

/* The zones of a line; v_n > 0. */
void rl_inner_line_make(struct rl_inner_line *line, const struct rl_ellipsoid *e, double stretch, double v_t,
                        double v_n);

/* The integral of D G from a to b, a <= b, as angles of the density. 0 beyond the horizon. Absolute error about 1e-15. */
double rl_inner_attenuated(const struct rl_inner_line *line, const struct rl_ellipsoid *e, double stretch,
                           struct rl_angle a, struct rl_angle b);

#endif
