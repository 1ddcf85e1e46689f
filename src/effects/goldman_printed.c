/* Goldman's fur as a widely copied listing has it: the effect `goldman` on the terms of `kajiya-printed`, and with Lambert's term
 * unclamped,
 *
 *     f_surf = 2 (l.n) + 1
 *
 * from -1 (fur takes light away) to 3 (it is three times as bright as it would be). Everything else is as in goldman.c, also where n is
 * parallel to l or e, which the listing leaves to 0/0. */
#include "effects/fur.h"

enum { C = 7, RHO_REFLECT = 8, RHO_TRANSMIT = 9, MONOCHROME = 10 };

static const char *check(const double *value, const char **key)
{
    bool c = !isnan(value[C]), reflect = !isnan(value[RHO_REFLECT]), transmit = !isnan(value[RHO_TRANSMIT]);
    *key = "c";
    if (c ? reflect || transmit : !reflect && !transmit)
        return c ? "either c, or rho-reflect and rho-transmit" : "c, or rho-reflect and rho-transmit";
    *key = reflect ? "rho-transmit" : "rho-reflect";
    return c || (reflect && transmit) ? NULL : "both rho-reflect and rho-transmit";
}

static void pack(const double *value, double params[][4])
{
    bool c = !isnan(value[C]);
    rl_fur_pack(value, value[MONOCHROME] != 0.0, params);
    params[1][3] = c ? 0.5 * (1.0 + value[C]) : value[RHO_REFLECT];
    params[2][0] = c ? 0.5 * (1.0 - value[C]) : value[RHO_TRANSMIT];
    params[2][1] = params[2][2] = params[2][3] = 0.0;
}

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    double kappa = rl_fur_kappa(s->N, L, s->V);
    double f_dir = 0.5 * ((1.0 + kappa) * params[1][3] + (1.0 - kappa) * params[2][0]);
    double f_surf = 2.0 * v3_dot(s->N, L) + 1.0;
    rl_fur_sum(rgb, params, f_dir * f_surf, rl_fur_sine(s->N, L), rl_fur_cone_printed(s->N, L, s->V));
}

static const struct rl_effect_param param[] = {
    {.key = "diffuse",
     .help = "k_d, the fur's colour",
     .kind = RL_EFFECT_COLOUR,
     .high = 1.0,
     .required = true,
     .coefficient = true},
    {.key = "specular",
     .help = "k_s, its highlight's colour",
     .kind = RL_EFFECT_COLOUR,
     .high = 1.0,
     .required = true,
     .coefficient = true},
    {.key = "exponent", .help = "p (8)", .low = 1.0, .high = 1000.0, .absent = {8.0}},
    {.key = "c",
     .help = "from -1, all transmitted, to 1, all reflected; or both rho",
     .low = -1.0,
     .high = 1.0,
     .absent = {NAN}},
    {.key = "rho-reflect", .help = "f_dir seen from the light's side", .high = 1.0, .absent = {NAN}},
    {.key = "rho-transmit", .help = "f_dir seen from the other side", .high = 1.0, .absent = {NAN}},
    {.key = "monochrome",
     .help = "on: both colours as their luminance, shades of grey",
     .kind = RL_EFFECT_CHOICE,
     .choice = rl_fur_monochrome},
    {0},
};

const struct rl_effect rl_effect_goldman_printed = {
    .name = "goldman-printed",
    .summary = "fur as a listing has Goldman, on kajiya-printed and with Lambert's term unclamped",
    .sees = RL_SEES_SOURCES | RL_SEES_CENTROIDS,
    .roles = RL_ROLE_DIFFUSE | RL_ROLE_SPECULAR | RL_ROLE_HIGHLIGHT,
    .below = true,
    .param = param,
    .modules = {"common/fur", "common/fur_cone_printed", "common/fur_kappa"},
    .check = check,
    .n_params = 3,
    .pack = pack,
    .reflect = reflect,
    .absolute = 2e-6,
    .relative = 1e-3,
};
