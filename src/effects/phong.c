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
#include "effects/effect.h"

static void pack(const double *value, double params[][4])
{
    for (int i = 0; i < 3; i++)
        params[0][i] = value[i];
    params[0][3] = value[4];
    params[1][0] = value[3];
    params[1][1] = params[1][2] = params[1][3] = 0.0;
}

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    rgb[0] = rgb[1] = rgb[2] = 0.0;
    double n_l = v3_dot(s->N, L);
    double r_l = v3_dot(v3_reflect(s->V, s->N), L);
    if (!(n_l > 0.0) || !(r_l > 0.0))
        return;
    /* Rounded a little above 1, a cosine to a large power is large. */
    double lobe = pow(fmin(r_l, 1.0), params[0][3]);
    double grazing = params[1][0] * pow(fmax(0.0, 1.0 - n_l), 5.0);
    for (int c = 0; c < 3; c++)
        rgb[c] = lobe * (params[0][c] + grazing * (1.0 - params[0][c]));
}

static const struct rl_effect_choice grazing[] = {
    {"constant", "common/constant_reflectance"}, {"grazing", "common/grazing_reflectance"}, {0}};

static const struct rl_effect_param param[] = {
    {.key = "specular",
     .help = "k_s, W at normal incidence",
     .kind = RL_EFFECT_COLOUR,
     .high = 1.0,
     .required = true,
     .coefficient = true},
    {.key = "grazing",
     .help = "g, how much of the way W rises to 1 at grazing incidence (0)",
     .high = 1.0,
     .choice = grazing},
    {.key = "exponent", .help = "n of cos^n(gamma)", .low = 1.0, .high = 1000.0, .required = true},
    {0},
};

const struct rl_effect rl_effect_phong = {
    .name = "phong",
    .summary = "W(alpha) cos^n(gamma): Phong's highlight of point and parallel lights",
    .sees = RL_SEES_SOURCES,
    .roles = RL_ROLE_SPECULAR,
    .param = param,
    .n_params = 2,
    .pack = pack,
    .reflect = reflect,
    .absolute = 1e-6,
    .relative = 1e-3,
};
