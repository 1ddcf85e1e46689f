/* Goldman's fur as a widely copied listing has it: the effect `goldman` on the terms of `kajiya-printed`, and with Lambert's term
 * unclamped,
 *
 *     f_surf = 2 (l.n) + 1
 *
 * from -1 (fur takes light away) to 3 (it is three times as bright as it would be). Everything else is as in goldman.c, also where n is
 * parallel to l or e, which the listing leaves to 0/0. */
#include "effects/fur.h"

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    struct rl_fur_terms t = rl_fur_terms(s->N, L, s->V);
    double f_dir = rl_goldman_direction(&t, s, L, params);
    double f_surf = rl_goldman_surface(&t);
    rl_fur_sum(rgb, params, f_dir * f_surf, t.s_l.high, rl_fur_cone_printed(&t));
}

const struct rl_effect rl_effect_goldman_printed = {
    .name = "goldman-printed",
    .summary = "fur as a listing has Goldman, on kajiya-printed and with Lambert's term unclamped",
    .sees = RL_SEES_SOURCES | RL_SEES_CENTROIDS,
    .roles = RL_ROLE_DIFFUSE | RL_ROLE_SPECULAR | RL_ROLE_HIGHLIGHT,
    .below = true,
    .param = rl_goldman_param,
    .negative = true,
    .modules = {"common/lobe", "common/fur", "common/fur_cone_printed", "common/fur_kappa",
                "common/positive_zero"},
    .check = rl_goldman_check,
    .n_params = 3,
    .pack = rl_goldman_pack,
    .reflect = reflect,
    .absolute = 1e-6,
    .relative = 1e-5,
};
