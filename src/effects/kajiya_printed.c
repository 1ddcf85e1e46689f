/* Kajiya and Kay's fur as a widely copied vertex shader prints it: the effect `kajiya` with two faults.
 *
 *     k_d |n x l| + k_s ((l.n)(-n.e) - |n x l||n x e|)^p,   n = N, p = 8 there
 *
 * The identity is cos(psi - theta) = cos cos + sin sin: with the minus the highlight lies on the mirror image of the cone. And the power
 * is three squarings, which lose the sign: where the cosine is near -1 the fur lights up as where it is near 1. That is what makes the
 * middle of a ball glow that is lit from the eye (n = l = e: the cosine is -1 by either formula), not the sign of the sines, which are 0
 * there. The absolute value is taken here, so that other exponents than 8 do the same. */
#include "effects/fur.h"

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    struct rl_fur_terms t = rl_fur_terms(s->N, L, s->V);
    rl_fur_sum(rgb, params, 1.0, t.s_l.high, rl_fur_cone_printed(&t));
}

const struct rl_effect rl_effect_kajiya_printed = {
    .name = "kajiya-printed",
    .summary = "fur as a listing has Kajiya and Kay, with a wrong sign and a lost one",
    .sees = RL_SEES_SOURCES | RL_SEES_CENTROIDS,
    .roles = RL_ROLE_DIFFUSE | RL_ROLE_SPECULAR | RL_ROLE_HIGHLIGHT,
    .below = true,
    .param = rl_fur_param,
    .modules = {"common/lobe", "common/fur", "common/fur_cone_printed"},
    .n_params = 2,
    .pack = rl_fur_pack,
    .reflect = reflect,
    .absolute = 1e-6,
    .relative = 1e-5,
};
