/* What Lambert's two effects share, diffuse and diffuse-area: k_d, and what comes back of light from one direction. */
#ifndef RL_EFFECTS_LAMBERT_H
#define RL_EFFECTS_LAMBERT_H

#include "effects/effect.h"

static const struct rl_effect_param rl_lambert_param[] = {
    {.help = "k_d, the reflectance", .kind = RL_EFFECT_COLOUR, .high = 1.0, .coefficient = true},
    {0},
};

/* k_d / pi as params[0]. */
static inline void rl_lambert_pack(const double *value, double params[][4])
{
    for (int i = 0; i < 3; i++)
        params[0][i] = value[i] / RL_PI;
    params[0][3] = 0.0;
}

/* (k_d / pi) max(0, N.L) */
static inline void rl_lambert_reflect(const struct rl_surface *s, rl_vec3 L, double params[][4],
                                      double rgb[3])
{
    double n_l = fmax(0.0, v3_dot(s->N, L));
    for (int c = 0; c < 3; c++)
        rgb[c] = params[0][c] * n_l;
}

#endif
