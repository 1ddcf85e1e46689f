/* Fur after Lengyel (2000), whose highlight asks how far the half vector is from the fibre:
 *
 *     k_d |n x l| + k_s |n x h|^p,   h = (l + e)/2,   n = N
 *
 * times the irradiance perpendicular to l; e = V, l = L. h is half of the sum and no unit vector: |h| is the cosine of half the angle
 * between light and eye, so that the highlight fades as they part and is 0, without a 0/0, where they are opposite. It is the same with
 * light and eye exchanged. */
#include "effects/fur.h"

static void pack(const double *value, double params[][4])
{
    rl_fur_pack(value, value[7] != 0.0, params);
}

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    rl_vec3 h = v3_scale(0.5, v3_add(L, s->V));
    rl_fur_sum(rgb, params, 1.0, rl_fur_sine(s->N, L), fmin(rl_fur_sine(s->N, h), 1.0));
}

static const struct rl_effect_param param[] = {
    {.key = "diffuse",
     .help = "k_d, the fur's colour",
     .kind = RL_EFFECT_COLOUR,
     .high = 1.0,
     .required = true,
     .coefficient = true},
    {.key = "specular",
     .help = "k_s, its highlight's colour",
     .kind = RL_EFFECT_COLOUR,
     .high = 1.0,
     .required = true,
     .coefficient = true},
    {.key = "exponent", .help = "p (8)", .low = 1.0, .high = 1000.0, .absent = {8.0}},
    {.key = "monochrome",
     .help = "on: both colours as their luminance, shades of grey",
     .kind = RL_EFFECT_CHOICE,
     .choice = rl_fur_monochrome},
    {0},
};

const struct rl_effect rl_effect_lengyel = {
    .name = "lengyel",
    .summary = "fur: Lengyel, a highlight by the half vector",
    .sees = RL_SEES_SOURCES | RL_SEES_CENTROIDS,
    .roles = RL_ROLE_DIFFUSE | RL_ROLE_SPECULAR | RL_ROLE_HIGHLIGHT,
    .below = true,
    .param = param,
    .modules = {"common/fur"},
    .n_params = 2,
    .pack = pack,
    .reflect = reflect,
    .absolute = 2e-6,
    .relative = 1e-3,
};
