/* The half vector of light and eye, H = (L + V)/|L + V|, the normal of the facets that mirror one to the other; beta is the angle between
 * it and either.
 *
 * L + V is all rounding where L is nearly -V, and most of that lies along V - L: it is what the lengths of L and V are off by 1, for of unit
 * vectors (L + V).(V - L) = |V|^2 - |L|^2 = 0. As long as each other they are L (1 + d) and V (1 - d), d = (|V|^2 - |L|^2)/4, but for the square
 * of d; so H is along L + V - d (V - L), the same with L and V exchanged. All in pairs of numbers (model/pair.h): angles to H are those of the
 * directions L and V, as rounded as these are and no more, also where both graze a horizon. */
#ifndef RL_MODEL_HALF_H
#define RL_MODEL_HALF_H

#include "model/pair.h"

/* For lengths to 1e-300, whose squares are no numbers. */
#define RL_HALF_WIDE 0x1p500

struct rl_half {
    struct rl_pair_vec3 H;          /* RL_HALF_WIDE (L + V) */
    struct rl_pair cosine, sin_sin; /* of beta */
};

/* Of vectors whose lengths are 1 but for rounding. Where they are opposite there is no H, and the cosine is 0. */
static inline struct rl_half rl_half_make(rl_vec3 L, rl_vec3 V)
{
    struct rl_pair_vec3 l = rl_pair_vec3_of(L), v = rl_pair_vec3_of(V);
    struct rl_pair wide = {RL_HALF_WIDE, 0.0}, one = {1.0, 0.0};
    struct rl_pair_vec3 sum = rl_pair_vec3_add(l, v), apart = rl_pair_vec3_add(v, rl_pair_vec3_minus(l));
    struct rl_pair d = rl_pair_scale(-0.25, rl_pair_dot(sum, apart));
    struct rl_pair_vec3 H = rl_pair_vec3_scale(wide, rl_pair_vec3_add(sum, rl_pair_vec3_scale(d, apart)));
    /* |H|^2 = 4 cos^2(beta) times the square of the lengths, the mean of both. */
    struct rl_pair lengths = rl_pair_add(rl_pair_dot(l, l), rl_pair_dot(v, v));
    struct rl_pair cosine = rl_pair_root(rl_pair_divide(rl_pair_scale(0.5, rl_pair_dot(H, H)), lengths));
    cosine = rl_pair_scale(1.0 / RL_HALF_WIDE, cosine);
    struct rl_pair c_c = rl_pair_multiply(cosine, cosine);
    /* Where L and V are nearly one, by sin(2 beta) = 2 sin(beta) cos(beta). */
    struct rl_pair sin_sin = cosine.high > 0.7
                                 ? rl_pair_scale(0.25, rl_pair_divide(rl_pair_sin_sin(l, v), c_c))
                                 : rl_pair_add(one, rl_pair_minus(c_c));
    return (struct rl_half){H, cosine, sin_sin};
}

#endif
