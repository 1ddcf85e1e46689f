/* The half vector of light and eye, H = (L + V)/|L + V|, the normal of the facets that mirror one to the other; beta is the angle between
 * it and either.
 *
 * L + V is all rounding where L is nearly -V, and most of that lies along V - L: it is what the lengths of L and V are off by 1. So V is made
 * as long as L, by |L|/|V| = 1 + (|L|^2 - |V|^2)/2 but for the square of what that differs from 1; and sum and difference are in pairs of
 * numbers (model/pair.h), so that angles to H are those of the directions L and V, as rounded as these are and no more, also where both graze
 * a horizon. */
#ifndef RL_MODEL_HALF_H
#define RL_MODEL_HALF_H

#include "model/pair.h"

/* For lengths to 1e-300, whose squares are no numbers. */
#define RL_HALF_WIDE 0x1p500

struct rl_half {
    struct rl_pair_vec3 H;          /* RL_HALF_WIDE (L + V), with V as long as L */
    struct rl_pair cosine, sin_sin; /* of beta */
};

/* Of vectors whose lengths are 1 but for rounding. Where they are opposite there is no H, and the cosine is 0. */
static inline struct rl_half rl_half_make(rl_vec3 L, rl_vec3 V)
{
    struct rl_pair_vec3 l = rl_pair_vec3_of(L), v = rl_pair_vec3_of(V);
    struct rl_pair ll = rl_pair_dot(l, l), wide = {RL_HALF_WIDE, 0.0};
    double longer = 0.5 * rl_pair_add(ll, rl_pair_minus(rl_pair_dot(v, v))).high;
    v = rl_pair_vec3_scale(rl_pair_sum(1.0, longer), v);
    struct rl_pair_vec3 sum = rl_pair_vec3_scale(wide, rl_pair_vec3_add(l, v));
    struct rl_pair_vec3 apart = rl_pair_vec3_add(v, rl_pair_vec3_minus(l));
    struct rl_pair size = rl_pair_root(rl_pair_divide(rl_pair_dot(sum, sum), ll));
    return (struct rl_half){sum, rl_pair_scale(0.5 / RL_HALF_WIDE, size),
                            rl_pair_scale(0.25, rl_pair_divide(rl_pair_dot(apart, apart), ll))};
}

#endif
