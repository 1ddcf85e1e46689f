/* Blinn's highlight (Blinn 1977), Phong's lobe on microfacets: about the half vector H = (L + V)/|L + V|, the normal of those facets that
 * mirror the light to the eye.
 *
 *     W(beta) cos^n(delta),   cos(delta) = N.H,   N.L > 0 and N.V > 0
 *     W(beta) = k_s + g (1 - k_s) (1 - cos beta)^5,       cos(beta) = L.H = |L + V|/2
 *
 * times the irradiance perpendicular to L; W as in phong.c, but of the angle at which the facet is hit. The radiance is the same with
 * light and eye exchanged. With 4n it is about as narrow as Phong's with n, for delta is half of gamma near the mirror direction. */
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
    rl_vec3 sum = v3_add(L, s->V);
    double length = v3_length(sum), n_l = v3_dot(s->N, L), n_v = v3_dot(s->N, s->V);
    if (!(n_l > 0.0) || !(n_v > 0.0) || !(length > 0.0))
        return;
    double lobe = pow(fmin((n_l + n_v) / length, 1.0), params[0][3]);
    double grazing = params[1][0] * pow(fmax(0.0, 1.0 - 0.5 * length), 5.0);
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
    {.key = "exponent", .help = "n of cos^n(delta)", .low = 1.0, .high = 1000.0, .required = true},
    {0},
};

const struct rl_effect rl_effect_blinn = {
    .name = "blinn",
    .summary = "W(beta) cos^n(delta): Blinn's half-vector highlight of point and parallel lights",
    .sees = RL_SEES_SOURCES,
    .roles = RL_ROLE_SPECULAR,
    .param = param,
    .n_params = 2,
    .pack = pack,
    .reflect = reflect,
    .absolute = 1e-6,
    .relative = 1e-3,
};
