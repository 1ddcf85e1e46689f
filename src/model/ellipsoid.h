/* The ellipsoid distribution of microfacet normals (Trowbridge and Reitz 1975, as Blinn 1977 and Kimura and Tokoi use it).
 *
 * delta in [-pi/2, pi/2] is the signed angle between the surface normal N and the microfacet normal H; R = R_r > 0 is the
 * ellipsoid's ratio: 1 is the roughest the paper allows, large is smooth, below 1 the family goes on. With k = sqrt(R^2 - 1):
 *
 *     D(delta)     = k cos(delta) / (2 atan(k) (1 + k^2 sin^2 delta))     density per radian of delta, integral 1
 *     U(delta)     = 1/2 + atan(k sin delta) / (2 atan k)                 its cdf
 *     sin delta(U) = tan((2U - 1) atan k) / k                             its inverse
 *
 * The azimuth theta is uniform on [0, pi). Users who think in GGX: R = 1/alpha, but the ellipsoid term stands to the
 * first power here and to the second there.
 *
 * How it stays accurate: 1 + k^2 s^2 = cos^2 + R^2 sin^2 has no cancellation for any R; R^2 - 1 is (R - 1)(R + 1);
 * k/atan(k) has its limit 1 at R = 1 and becomes h/atanh(h), h = sqrt(1 - R^2), below. The cdf fuses its difference of
 * arctangents near U = 0 and 1, where 1 - sin is carried as cos^2/(1 + sin); the inverse has sin and 1 - sin as quotients
 * of terms that do not cancel. All are within 8 units in the last place (tests/model/test_ellipsoid.c).
 *
 *     struct rl_ellipsoid e = rl_ellipsoid_make(30.0);
 *     struct rl_delta d = rl_ellipsoid_inverse(&e, 0.75);     d.sin_delta is tan(atan(k)/2)/k
 */
#ifndef RL_MODEL_ELLIPSOID_H
#define RL_MODEL_ELLIPSOID_H

#include <stdbool.h>

#define RL_RR_MIN 1e-6
#define RL_RR_MAX 1e12

struct rl_ellipsoid {
    double rr;         /* R_r */
    double k;          /* sqrt(|R^2 - 1|) */
    double half_range; /* atan(k), or atanh(k) for R < 1: half the range of the cdf's arctangent */
    double norm;       /* k / (2 half_range): D at delta = 0; 1/2 at R = 1 */
};

struct rl_delta {
    double delta, sin_delta, cos_delta; /* radians; cos_delta >= 0 */
};

/* Whether R_r is finite and in [RL_RR_MIN, RL_RR_MAX]; what the functions below require. */
bool rl_ellipsoid_valid(double rr);

struct rl_ellipsoid rl_ellipsoid_make(double rr);

/* D in 1/radian for delta in [-pi/2, pi/2]. */
double rl_ellipsoid_pdf(const struct rl_ellipsoid *e, double delta);
/* The same from sin(delta) and cos(delta), which a caller mostly has at hand. */
double rl_ellipsoid_pdf_sincos(const struct rl_ellipsoid *e, double sin_delta, double cos_delta);

/* U in [0, 1], accurate relative to itself near 0 (the lower tail); 1 - U(delta) = U(-delta). */
double rl_ellipsoid_cdf(const struct rl_ellipsoid *e, double delta);
double rl_ellipsoid_cdf_sincos(const struct rl_ellipsoid *e, double sin_delta, double cos_delta);

/* delta for U in [0, 1]; values outside are taken as the nearer end. */
struct rl_delta rl_ellipsoid_inverse(const struct rl_ellipsoid *e, double u);

#endif
