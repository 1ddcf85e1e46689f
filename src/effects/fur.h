/* What the fur effects share: keys, how they are packed, and sums. kajiya, kajiya-printed and lengyel differ in their highlight alone;
 * goldman and goldman-printed add a direction to it.
 *
 *     .param = rl_fur_param, .n_params = 2, .pack = rl_fur_pack                                         kajiya, lengyel
 *     .param = rl_goldman_param, .check = rl_goldman_check, .n_params = 3, .pack = rl_goldman_pack      goldman */
#ifndef RL_EFFECTS_FUR_H
#define RL_EFFECTS_FUR_H

#include "effects/effect.h"
#include "model/fur.h"
#include "model/lobe.h"

/* ---- All fur ---- */

/* off or on; made when colours are packed, so no module belongs to it. */
static const struct rl_effect_choice rl_fur_monochrome[] = {{"off", NULL}, {"on", NULL}, {0}};

/* The first seven values. */
/* clang-format off */
#define RL_FUR_KEYS \
    {.key = "diffuse", .help = "k_d, the fur's colour", .kind = RL_EFFECT_COLOUR, .high = 1.0, \
     .required = true, .coefficient = true}, \
    {.key = "specular", .help = "k_s, its highlight's colour", .kind = RL_EFFECT_COLOUR, .high = 1.0, \
     .required = true, .coefficient = true}, \
    {.key = "exponent", .help = "p (8)", .low = 1.0, .high = 1000.0, .absent = {8.0}}

/* The last value. */
#define RL_FUR_MONOCHROME_KEY \
    {.key = "monochrome", .help = "on: both colours as their luminance, shades of grey", \
     .kind = RL_EFFECT_CHOICE, .choice = rl_fur_monochrome}
/* clang-format on */

/* Diffuse and specular colour and the exponent as params[0] (diffuse, exponent) and params[1] (specular); monochrome: each colour as
 * its luminance (Rec. 709), which makes the effect's own value that. */
static inline void rl_fur_pack_colours(const double *value, bool monochrome, double params[][4])
{
    for (size_t k = 0; k < 2; k++) {
        const double *rgb = value + 3 * k;
        double luminance = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        for (int c = 0; c < 3; c++)
            params[k][c] = monochrome ? luminance : rgb[c];
    }
    params[0][3] = value[6];
    params[1][3] = 0.0;
}

/* factor (k_d diffuse + k_s lobe^p) */
static inline void rl_fur_sum(double rgb[3], double params[][4], double factor, double diffuse,
                              struct rl_pair lobe)
{
    double specular = rl_power(lobe, params[0][3]);
    for (int c = 0; c < 3; c++)
        rgb[c] = factor * (params[0][c] * diffuse + params[1][c] * specular);
}

/* ---- Fur of no direction: kajiya, kajiya-printed, lengyel ---- */

static const struct rl_effect_param rl_fur_param[] = {RL_FUR_KEYS, RL_FUR_MONOCHROME_KEY, {0}};

static inline void rl_fur_pack(const double *value, double params[][4])
{
    rl_fur_pack_colours(value, value[7] != 0.0, params);
}

/* ---- Goldman's, printed or not: f_dir = ((1 + kappa)/2) rho_reflect + ((1 - kappa)/2) rho_transmit, see goldman.c ---- */

enum rl_goldman_value { RL_GOLDMAN_C = 7, RL_GOLDMAN_REFLECT, RL_GOLDMAN_TRANSMIT, RL_GOLDMAN_MONOCHROME };

static const struct rl_effect_param rl_goldman_param[] = {
    RL_FUR_KEYS,
    {.key = "c",
     .help = "from -1, all transmitted, to 1, all reflected; or both rho",
     .low = -1.0,
     .high = 1.0,
     .absent = {NAN}},
    {.key = "rho-reflect", .help = "f_dir seen from the light's side", .high = 1.0, .absent = {NAN}},
    {.key = "rho-transmit", .help = "f_dir seen from the other side", .high = 1.0, .absent = {NAN}},
    RL_FUR_MONOCHROME_KEY,
    {0},
};

/* Either c or both rho. */
static inline const char *rl_goldman_check(const double *value, const char **key)
{
    bool c = !isnan(value[RL_GOLDMAN_C]), reflect = !isnan(value[RL_GOLDMAN_REFLECT]),
         transmit = !isnan(value[RL_GOLDMAN_TRANSMIT]);
    *key = "c";
    if (c ? reflect || transmit : !reflect && !transmit)
        return c ? "either c, or rho-reflect and rho-transmit" : "c, or rho-reflect and rho-transmit";
    *key = reflect ? "rho-transmit" : "rho-reflect";
    return c || (reflect && transmit) ? NULL : "both rho-reflect and rho-transmit";
}

/* Beside the colours: rho_reflect as the w of params[1], rho_transmit as the x of params[2]. */
static inline void rl_goldman_pack(const double *value, double params[][4])
{
    double c = value[RL_GOLDMAN_C];
    rl_fur_pack_colours(value, value[RL_GOLDMAN_MONOCHROME] != 0.0, params);
    params[1][3] = isnan(c) ? value[RL_GOLDMAN_REFLECT] : 0.5 * (1.0 + c);
    params[2][0] = isnan(c) ? value[RL_GOLDMAN_TRANSMIT] : 0.5 * (1.0 - c);
    params[2][1] = params[2][2] = params[2][3] = 0.0;
}

/* f_dir of light from L, seen from V. */
static inline double rl_goldman_direction(const struct rl_fur_terms *t, const struct rl_surface *s, rl_vec3 L,
                                          double params[][4])
{
    struct rl_fur_sides sides = rl_fur_sides(t, s->N, L, s->V);
    return sides.near * params[1][3] + sides.far * params[2][0];
}

/* 2 (l.n) + 1, which cancels 120 degrees from n. */
static inline double rl_goldman_surface(const struct rl_fur_terms *t)
{
    return rl_pair_add(rl_pair_add(t->c_l, t->c_l), (struct rl_pair){1.0, 0.0}).high;
}

#endif
