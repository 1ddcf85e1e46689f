/* Fur after Kajiya and Kay (1989): fibres along n = N that scatter light as thin cylinders do,
 *
 *     k_d |n x l| + k_s max(0, (l.n)(-n.e) + |n x l||n x e|)^p
 *
 * times the irradiance perpendicular to l; e = V, l = L. The cosine is that of the angle between the eye and the cone of mirrored light
 * (src/model/fur.h). Fibres have no back: light from below the surface counts as any other. All round, a light of radiance 1 gives
 * k_d pi^2 + k_s times the lobe's integral: k_d = 1/pi^2 is white. `kajiya-printed` is what a listing made of it. */
#include "effects/fur.h"

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    struct rl_fur_terms t = rl_fur_terms(s->N, L, s->V);
    rl_fur_sum(rgb, params, 1.0, t.s_l.high, rl_fur_cone(&t));
}

const struct rl_effect rl_effect_kajiya = {
    .name = "kajiya",
    .summary = "fur: Kajiya and Kay, fibres along the normal",
    .sees = RL_SEES_SOURCES | RL_SEES_CENTROIDS,
    .roles = RL_ROLE_DIFFUSE | RL_ROLE_SPECULAR | RL_ROLE_HIGHLIGHT,
    .below = true,
    .param = rl_fur_param,
    .modules = {"common/lobe", "common/fur", "common/fur_cone"},
    .n_params = 2,
    .pack = rl_fur_pack,
    .reflect = reflect,
    .absolute = 1e-6,
    .relative = 1e-5,
};
