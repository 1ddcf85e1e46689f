/* Phong's highlight (Phong 1975): a lobe about the mirror direction R = 2(N.V)N - V of the eye.
 *
 *     W(alpha) cos^n(gamma),   cos(gamma) = max(0, R.L),   N.L > 0
 *     W(alpha) = k_s + g (1 - k_s) (1 - cos alpha)^5,      cos(alpha) = N.L
 *
 * times the irradiance perpendicular to L. Phong's W is any function of the angle of incidence alpha; here it is k_s, and with g > 0 it
 * rises towards 1 at grazing incidence as Fresnel's reflectance does (Schlick 1994). n is the exponent.
 *
 * The lobe is a radiance, not divided by N.L: it ends at the terminator without fading there, is not reciprocal as a reflectance and
 * bounded by no energy. Light along the normal leaves with W 2 pi/(n + 2) of its irradiance: more than came, below n = 4.3. */
#include "effects/highlight.h"

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    rgb[0] = rgb[1] = rgb[2] = 0.0;
    double n_l = v3_dot(s->N, L);
    if (!(n_l > 0.0))
        return;
    /* |N|^2 R, whatever N's length. */
    struct rl_pair_vec3 N = rl_pair_vec3_of(s->N), V = rl_pair_vec3_of(s->V), l = rl_pair_vec3_of(L);
    struct rl_pair n_v = rl_pair_dot(N, V);
    struct rl_pair_vec3 along = rl_pair_vec3_scale(rl_pair_add(n_v, n_v), N),
                        back = rl_pair_vec3_scale(rl_pair_dot(N, N), V),
                        R = rl_pair_vec3_add(along, rl_pair_vec3_minus(back));
    double lobe = rl_power(rl_pair_cosine(R, l), params[0][3]);
    rl_lobe_sum(rgb, params, lobe, rl_one_less_cosine(rl_pair_cosine(N, l), rl_pair_sin_sin(N, l)));
}

static const struct rl_effect_param param[] = {RL_LOBE_KEYS("n of cos^n(gamma)"), {0}};

const struct rl_effect rl_effect_phong = {
    .name = "phong",
    .summary = "W(alpha) cos^n(gamma): Phong's highlight of point and parallel lights",
    .sees = RL_SEES_SOURCES,
    .roles = RL_ROLE_SPECULAR,
    .param = param,
    .modules = {"common/lobe"},
    .n_params = 2,
    .pack = rl_lobe_pack,
    .reflect = reflect,
    .absolute = 1e-6,
    .relative = 1e-5,
};
