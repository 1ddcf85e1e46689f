/* Powers of cosines, the lobes of highlights.
 *
 *     cos^n(gamma) = (1 + tan^2(gamma))^(-n/2) = exp(-(n/2) log1p(tan^2(gamma)))
 *
 * Near gamma = 0 a cosine is 1 but for gamma^2/2: rounded to 53 bits, or to 24, its n-th power is off by n/2 units in the last place, or by
 * more where it comes from vectors whose lengths are 1 but for rounding. The tangent is small with gamma, comes from sine and cosine by
 * their ratio alone, so that lengths cancel out, and log1p keeps it. Sines are lengths of cross products or differences of products. */
#ifndef RL_MODEL_LOBE_H
#define RL_MODEL_LOBE_H

#include <math.h>

/* cos^n for n > 0 of the angle whose sine and cosine these are but for a common factor > 0; 0 where cosine <= 0. */
static inline double rl_power_of_cosine(double sine, double cosine, double n)
{
    if (!(cosine > 0.0))
        return 0.0;
    double tangent = fabs(sine / cosine), square = tangent * tangent;
    if (tangent < 1.0)
        return exp(-0.5 * n * log1p(square));
    /* A logarithm of size would add its rounding n times: pow carries its own in more digits. Past 1e8 the 1 is nothing, and squares may
     * overflow. */
    return tangent < 1e8 ? pow(1.0 + square, -0.5 * n) : pow(cosine / fabs(sine), n);
}

/* 1 - cos, which is sin^2/(1 + cos) near 0. */
static inline double rl_one_less_cosine(double cosine, double sin_sin)
{
    return cosine > 0.7 ? sin_sin / (1.0 + cosine) : 1.0 - cosine;
}

#endif
