/* Fake fur after Goldman (1997): the fur of `kajiya`, times how a coat of it transmits and hides.
 *
 *     (k_d |n x l| + k_s max(0, (l.n)(-n.e) + |n x l||n x e|)^p) f_dir f_surf
 *     f_dir  = ((1 + kappa)/2) rho_reflect + ((1 - kappa)/2) rho_transmit      kappa: cosine of n x l and n x e
 *     f_surf = clamp(2 (l.n) + 1, 0, 1)                                        the skin below hides light from beneath it
 *
 * times the irradiance perpendicular to l. c stands for rho_reflect = (1 + c)/2, rho_transmit = (1 - c)/2: f_dir = (1 + c kappa)/2. With
 * kappa = 1 the eye is on the light's side of the fibre. Where n is parallel to l or e kappa is 0 (src/model/fur.h). */
#include "effects/fur.h"

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    struct rl_fur_terms t = rl_fur_terms(s->N, L, s->V);
    double f_dir = rl_goldman_direction(&t, s, L, params);
    double f_surf = fmin(fmax(rl_goldman_surface(&t), 0.0), 1.0);
    rl_fur_sum(rgb, params, f_dir * f_surf, t.s_l.high, rl_fur_cone(&t));
}

const struct rl_effect rl_effect_goldman = {
    .name = "goldman",
    .summary = "fur: Goldman, Kajiya's with transmission through the coat",
    .sees = RL_SEES_SOURCES | RL_SEES_CENTROIDS,
    .roles = RL_ROLE_DIFFUSE | RL_ROLE_SPECULAR | RL_ROLE_HIGHLIGHT,
    .below = true,
    .param = rl_goldman_param,
    .modules = {"common/lobe", "common/fur", "common/fur_cone", "common/fur_kappa"},
    .check = rl_goldman_check,
    .n_params = 3,
    .pack = rl_goldman_pack,
    .reflect = reflect,
    .absolute = 1e-6,
    .relative = 1e-5,
};
