/* Fur after Lengyel (2000), whose highlight asks how far the half vector is from the fibre:
 *
 *     k_d |n x l| + k_s |n x h|^p,   h = (l + e)/2,   n = N
 *
 * times the irradiance perpendicular to l; e = V, l = L. h is half of the sum and no unit vector: |h| is the cosine of half the angle
 * between light and eye, so that the highlight fades as they part and is 0, without a 0/0, where they are opposite. It is the same with
 * light and eye exchanged. */
#include "effects/fur.h"

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    rl_fur_sum(rgb, params, 1.0, rl_fur_sine(s->N, L), rl_fur_half(s->N, L, s->V));
}

const struct rl_effect rl_effect_lengyel = {
    .name = "lengyel",
    .summary = "fur: Lengyel, a highlight by the half vector",
    .sees = RL_SEES_SOURCES | RL_SEES_CENTROIDS,
    .roles = RL_ROLE_DIFFUSE | RL_ROLE_SPECULAR | RL_ROLE_HIGHLIGHT,
    .below = true,
    .param = rl_fur_param,
    .modules = {"common/lobe", "common/fur"},
    .n_params = 2,
    .pack = rl_fur_pack,
    .reflect = reflect,
    .absolute = 1e-6,
    .relative = 1e-5,
};
