/* Fresnel's reflectance of unpolarised light at a smooth surface between air and a medium of complex index n - i k (Born and Wolf,
 * Principles of Optics, 7th ed., sections 1.5.2 and 14.2). With c the cosine of the angle of incidence and s^2 = 1 - c^2:
 *
 *     a + i b = sqrt((n - i k)^2 - s^2):   a^2 + b^2 = sqrt(x^2 + 4 n^2 k^2),  a^2 - b^2 = x = n^2 - k^2 - s^2
 *     R_s = ((a - c)^2 + b^2) / ((a + c)^2 + b^2)
 *     R_p = R_s ((a c - s^2)^2 + b^2 c^2) / ((a c + s^2)^2 + b^2 c^2)
 *     F = (R_s + R_p)/2
 *
 * Near n = 1 a - c is all rounding: there it is (a^2 - c^2)/(a + c), a^2 - c^2 = (n^2 - 1) - k^2 + b^2. c, s and n^2 - 1 are
 * given by whoever knows each without a difference of rounded numbers: s is the length of a cross product near normal incidence.
 *
 * At c = 1 it is ((n - 1)^2 + k^2)/((n + 1)^2 + k^2), at c = 0 it is 1. k = 0 is a dielectric; n < 1 with total reflection beyond
 * s = n. n = 1 and k = 0 is no surface: 0, also at c = 0, where the formula is 0/0.
 */
#ifndef RL_MODEL_FRESNEL_H
#define RL_MODEL_FRESNEL_H

#include <math.h>

/* A medium: n from 0.01 to 1e8, k from 0 to 100. */
struct rl_fresnel_index {
    double n, k, n_n_1; /* n_n_1 = n^2 - 1 */
};

/* c from 0 to 1 and ss = s^2. */
static inline double rl_fresnel_of(struct rl_fresnel_index index, double c, double ss)
{
    double n = index.n, k = index.k;
    /* n^2 - s^2 by what cancels less. */
    double x = (n > 0.7 ? index.n_n_1 + c * c : n * n - ss) - k * k;
    /* hypot: n = 1, c = 0 and a k whose square is no number any more reflect all. */
    double nk = n * k, m = hypot(x, 2.0 * nk);
    /* The smaller of a^2 and b^2 as a quotient, for their product is (n k)^2 and their difference would cancel. */
    double larger = 0.5 * (m + fabs(x)), smaller = larger > 0.0 ? nk * (nk / larger) : 0.0;
    double a = sqrt(x >= 0.0 ? larger : smaller), bb = x >= 0.0 ? smaller : larger;
    double below = (a + c) * (a + c) + bb;
    if (!(below > 0.0))
        return 0.0;
    /* a^2 - c^2 = n^2 - 1 - k^2 + b^2: near n = 1 the difference of a and c, which is all that is reflected, cancels. */
    double a_c = x >= 0.0 && a < 2.0 * c && c < 2.0 * a ? (index.n_n_1 - k * k + bb) / (a + c) : a - c;
    double r_s = (a_c * a_c + bb) / below;
    double p_below = (a * c + ss) * (a * c + ss) + bb * c * c;
    double p = p_below > 0.0 ? ((a * c - ss) * (a * c - ss) + bb * c * c) / p_below : 1.0;
    return 0.5 * r_s * (1.0 + p);
}

static inline double rl_fresnel(double n, double k, double c)
{
    return rl_fresnel_of((struct rl_fresnel_index){n, k, (n - 1.0) * (n + 1.0)}, c, (1.0 - c) * (1.0 + c));
}

/* The dielectric that reflects this part (0 to 1) at normal incidence (Cook and Torrance 1982): with r = sqrt(part),
 *
 *     n = (1 + r)/(1 - r),   n^2 - 1 = 4 r/(1 - r)^2
 *
 * A perfect mirror has none; it gets one that reflects all but 4e-8. */
static inline struct rl_fresnel_index rl_fresnel_index(double reflectance)
{
    double root = sqrt(reflectance), less = 1.0 - root;
    double n = less > 0.0 ? (1.0 + root) / less : 1e8;
    if (n < 1e8)
        return (struct rl_fresnel_index){n, 0.0, 4.0 * root / (less * less)};
    return (struct rl_fresnel_index){1e8, 0.0, 1e16};
}

#endif
