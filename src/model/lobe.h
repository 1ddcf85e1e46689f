/* Powers of cosines, the lobes of highlights.
 *
 * A cosine rounded to 53 bits is off by half a unit in the last place, and its n-th power by n times that, where the exponent's own rounding
 * may do next to nothing. So it comes in a pair (model/pair.h) h + l of numbers, of vectors whose lengths cancel out, and
 *
 *     (h + l)^n = h^n (1 + n l/h)
 *
 * but for (n l/h)^2/2, which is nothing for n up to 1e7. */
#ifndef RL_MODEL_LOBE_H
#define RL_MODEL_LOBE_H

#include <math.h>

#include "model/pair.h"

/* cos^n for n > 0; 0 where cosine <= 0. */
static inline double rl_power_of_cosine(struct rl_pair cosine, double n)
{
    if (!(cosine.high > 0.0))
        return 0.0;
    return pow(cosine.high, n) * (1.0 + n * (cosine.low / cosine.high));
}

/* 1 - cos, which is sin^2/(1 + cos) near 0. */
static inline double rl_one_less_cosine(double cosine, double sin_sin)
{
    return cosine > 0.7 ? sin_sin / (1.0 + cosine) : 1.0 - cosine;
}

#endif
