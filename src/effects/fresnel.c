/* Fresnel's reflectance as a factor on the highlight of shaped lights, which by itself mirrors all that it receives:
 *
 *     F(angle between N and V)
 *
 * (src/model/fresnel.h), from n and k for each of R, G and B or from the reflectance at normal incidence. Every facet has an angle of its
 * own, and their F belongs into the integral over facets; the factor is that of the facet with the surface's own normal. The smoother the
 * surface and the farther from grazing, the nearer are the two; in return each method draws the same factor, and the highlight's error
 * grows by no more than it. */
#include "effects/highlight.h"

static void factor(const struct rl_surface *s, double params[][4], double rgb[3])
{
    double n_v = fmin(fmax(v3_dot(s->N, s->V), 0.0), 1.0);
    for (int c = 0; c < 3; c++)
        rgb[c] = rl_fresnel(params[0][c], params[1][c], n_v);
}

static const struct rl_effect_param param[] = {RL_REFLECTANCE_KEYS, {0}};

const struct rl_effect rl_effect_fresnel = {
    .name = "fresnel",
    .summary = "F(N.V): Fresnel's reflectance as a factor on the highlight of shaped lights",
    .param = param,
    .modules = {"common/fresnel"},
    .check = rl_reflectance_check,
    .n_params = 2,
    .pack = rl_reflectance_pack,
    .factor = factor,
    /* At n = 0.01 total reflection begins half a degree from the normal, where single precision knows N.V to 6e-8 and F rises by 400 for each
     * unit of 1 - (N.V)^2. */
    .absolute = 1e-4,
};
