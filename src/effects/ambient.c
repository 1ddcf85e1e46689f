/* Ambient light: k_a I_a with I_a = 1, the same from everywhere. */
#include "effects/effect.h"

static void pack(const double *value, double params[][4])
{
    for (int i = 0; i < 3; i++)
        params[0][i] = value[i];
    params[0][3] = 0.0;
}

static void constant(double params[][4], double rgb[3])
{
    for (int i = 0; i < 3; i++)
        rgb[i] = params[0][i];
}

static const struct rl_effect_param param[] = {
    {.help = "k_a, times the surface's colour",
     .kind = RL_EFFECT_COLOUR,
     .high = 1e9,
     .coefficient = true,
     .radiance = true},
    {0},
};

const struct rl_effect rl_effect_ambient = {
    .name = "ambient",
    .summary = "k_a: constant light from all round",
    .param = param,
    .n_params = 1,
    .pack = pack,
    .constant = constant,
    .relative = 1e-7,
};
