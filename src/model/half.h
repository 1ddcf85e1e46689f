/* The half vector of light and eye, H = (L + V)/|L + V|, the normal of the facets that mirror one to the other; beta is the angle between
 * it and either.
 *
 * L + V is all rounding where L is nearly -V, and most of that lies along V - L: it is what the lengths of L and V are off by 1, for of unit
 * vectors (L + V).(V - L) = |V|^2 - |L|^2 = 0. Its part along V - L is taken away as (V - L)((L + V).(V - L))/4, |V - L|^2 being 4 where that
 * matters: what is left of the error is |L + V|^2/4 of it. So H has the directions' relative error also where both graze a horizon. */
#ifndef RL_MODEL_HALF_H
#define RL_MODEL_HALF_H

#include "model/vec3.h"

struct rl_half {
    rl_vec3 H;
    double cosine, sin_sin; /* of beta */
};

/* Of unit vectors. Where they are opposite there is no H, and the cosine is 0. */
static inline struct rl_half rl_half_make(rl_vec3 L, rl_vec3 V)
{
    /* Lengths to 1e-300, whose squares are none: both sides of the division by |L + V| have the power of two. */
    static const double wide = 0x1p500;
    rl_vec3 sum = v3_add(L, V), apart = v3_sub(V, L);
    sum = v3_scale(wide, v3_madd(sum, -0.25 * v3_dot(sum, apart), apart));
    double length = v3_length(sum);
    if (!(length > 0.0))
        return (struct rl_half){.sin_sin = 1.0};
    double cosine = fmin(0.5 / wide * length, 1.0), c_c = cosine * cosine;
    /* Where L and V are nearly one, |L x V| = 2 sin(beta) cos(beta); elsewhere the cosine knows it. */
    double sin_sin =
        cosine > 0.7 ? 0.25 * v3_dot(v3_cross(L, V), v3_cross(L, V)) / c_c : (1.0 - cosine) * (1.0 + cosine);
    return (struct rl_half){v3_scale(1.0 / length, sum), cosine, sin_sin};
}

#endif
