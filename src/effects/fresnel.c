/* Fresnel's reflectance as a factor on the highlight of shaped lights, which by itself mirrors all that it receives:
 *
 *     F(angle between N and V)
 *
 * (src/model/fresnel.h), from n and k for each of R, G and B or from the reflectance at normal incidence. Every facet has an angle of its
 * own, and their F belongs into the integral over facets; the factor is that of the facet with the surface's own normal. The smoother the
 * surface and the farther from grazing, the nearer are the two; in return each method draws the same factor, and the highlight's error
 * grows by no more than it. */
#include "effects/highlight.h"
#include "model/pair.h"

static void factor(const struct rl_surface *s, double params[][4], double rgb[3])
{
    struct rl_pair_vec3 N = rl_pair_vec3_of(s->N), V = rl_pair_vec3_of(s->V);
    double n_v = rl_pair_cosine(N, V).high, sin_sin = rl_pair_sin_sin(N, V).high;
    /* From behind as at 90 degrees. */
    if (n_v < 0.0)
        n_v = 0.0, sin_sin = 1.0;
    for (int c = 0; c < 3; c++)
        rgb[c] = rl_reflectance_at(params, c, n_v, sin_sin);
}

static const struct rl_effect_param param[] = {RL_REFLECTANCE_KEYS, {0}};

const struct rl_effect rl_effect_fresnel = {
    .name = "fresnel",
    .summary = "F(N.V): Fresnel's reflectance as a factor on the highlight of shaped lights",
    .param = param,
    .modules = {"common/fresnel"},
    .check = rl_reflectance_check,
    .n_params = RL_REFLECTANCE_PARAMS,
    .pack = rl_reflectance_pack,
    .factor = factor,
    .absolute = 1e-6,
    .relative = 1e-5,
};
