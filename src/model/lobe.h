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

/* x^n for n > 0; 0 where x <= 0. */
static inline double rl_power(struct rl_pair x, double n)
{
    if (!(x.high > 0.0))
        return 0.0;
    return pow(x.high, n) * (1.0 + n * (x.low / x.high));
}

/* 1 - cos = sin^2/(1 + cos), of angles up to 90 degrees. */
static inline struct rl_pair rl_one_less_cosine(struct rl_pair cosine, struct rl_pair sin_sin)
{
    return rl_pair_divide(sin_sin, rl_pair_add((struct rl_pair){1.0, 0.0}, cosine));
}

#endif
