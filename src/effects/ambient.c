/* Ambient light: k_a I_a with I_a = 1, the same from everywhere. */
#include "effects/effect.h"

static bool wanted(const struct rl_material *m)
{
    return m->ambient[0] > 0.0 || m->ambient[1] > 0.0 || m->ambient[2] > 0.0;
}

static void pack(const struct rl_material *m, double params[][4])
{
    for (int i = 0; i < 3; i++)
        params[0][i] = m->ambient[i];
    params[0][3] = 0.0;
}

static void shade(const struct rl_surface *s, const struct rl_point_light *lights, size_t n_lights,
                  double params[][4], double rgb[3])
{
    (void)s, (void)lights, (void)n_lights;
    for (int i = 0; i < 3; i++)
        rgb[i] = params[0][i];
}

const struct rl_effect rl_effect_ambient = {
    .name = "ambient",
    .summary = "k_a: constant light from all round",
    .n_params = 1,
    .wanted = wanted,
    .pack = pack,
    .shade = shade,
};
