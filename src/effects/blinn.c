/* Blinn's highlight (Blinn 1977), Phong's lobe on microfacets: about the half vector H = (L + V)/|L + V|, the normal of those facets that
 * mirror the light to the eye.
 *
 *     W(beta) cos^n(delta),   cos(delta) = N.H,   N.L > 0 and N.V > 0
 *     W(beta) = k_s + g (1 - k_s) (1 - cos beta)^5,       cos(beta) = L.H = |L + V|/2
 *
 * times the irradiance perpendicular to L; W as in phong.c, but of the angle at which the facet is hit. The radiance is the same with
 * light and eye exchanged. With 4n it is about as narrow as Phong's with n, for delta is half of gamma near the mirror direction.
 *
 * It jumps at both horizons. As N.V falls to 0 it goes to W(beta) (N.L/(2 L.H))^n, which is not 0; at N.V = 0 and below, where an
 * interpolated normal may be though the surface is seen, it is 0: nothing of such a surface is seen. The same of N.L,
 * for the lobe is a radiance and does not fade at the terminator. */
#include "effects/highlight.h"
#include "model/half.h"

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    rgb[0] = rgb[1] = rgb[2] = 0.0;
    double n_l = v3_dot(s->N, L), n_v = v3_dot(s->N, s->V);
    if (!(n_l > 0.0) || !(n_v > 0.0))
        return;
    struct rl_half h = rl_half_make(L, s->V);
    double lobe =
        h.cosine.high > 0.0 ? rl_power(rl_pair_cosine(rl_pair_vec3_of(s->N), h.H), params[0][3]) : 0.0;
    rl_lobe_sum(rgb, params, lobe, rl_one_less_cosine(h.cosine, h.sin_sin));
}

static const struct rl_effect_param param[] = {RL_LOBE_KEYS("n of cos^n(delta)"), {0}};

const struct rl_effect rl_effect_blinn = {
    .name = "blinn",
    .summary = "W(beta) cos^n(delta): Blinn's half-vector highlight of point and parallel lights",
    .sees = RL_SEES_SOURCES,
    .roles = RL_ROLE_SPECULAR,
    .param = param,
    .modules = {"common/half", "common/lobe"},
    .n_params = 2,
    .pack = rl_lobe_pack,
    .reflect = reflect,
    .absolute = 1e-6,
    .relative = 1e-5,
};
