/* What effects of highlights share: keys, how they are packed, and sums. phong and blinn are lobes with a reflectance W at their height;
 * cook-torrance and fresnel know Fresnel's reflectance by n and k, or by what it is at normal incidence. */
#ifndef RL_EFFECTS_HIGHLIGHT_H
#define RL_EFFECTS_HIGHLIGHT_H

#include "effects/effect.h"
#include "model/fresnel.h"
#include "model/lobe.h"

/* ---- Lobes: phong, blinn ---- */

static const struct rl_effect_choice rl_lobe_grazing[] = {
    {"constant", "common/constant_reflectance"}, {"grazing", "common/grazing_reflectance"}, {0}};

/* `exponent_help`: of which cosine it is the exponent. */
/* clang-format off */
#define RL_LOBE_KEYS(exponent_help) \
    {.key = "specular", .help = "k_s, W at normal incidence", .kind = RL_EFFECT_COLOUR, .high = 1.0, \
     .required = true, .coefficient = true}, \
    {.key = "grazing", .help = "g, how much of the way W rises to 1 at grazing incidence (0)", .high = 1.0, .coefficient = true, \
     .choice = rl_lobe_grazing}, \
    {.key = "exponent", .help = (exponent_help), .low = 1.0, .high = 1000.0, .required = true}
/* clang-format on */

/* k_s and the exponent as params[0], g as the x of params[1]. */
static inline void rl_lobe_pack(const double *value, double params[][4])
{
    for (int i = 0; i < 3; i++)
        params[0][i] = value[i];
    params[0][3] = value[4];
    params[1][0] = value[3];
    params[1][1] = params[1][2] = params[1][3] = 0.0;
}

/* W lobe, W = k_s + g (1 - k_s) (1 - cos)^5, of 1 - cos: the difference itself would cancel near normal incidence. */
static inline void rl_lobe_sum(double rgb[3], double params[][4], double lobe, struct rl_pair one_less_cosine)
{
    double grazing = params[1][0] * rl_power(one_less_cosine, 5.0);
    for (int c = 0; c < 3; c++)
        rgb[c] = lobe * (params[0][c] + grazing * (1.0 - params[0][c]));
}

/* ---- Fresnel's reflectance: cook-torrance, fresnel ---- */

/* The first nine values. */
enum rl_reflectance_value { RL_REFLECTANCE = 0, RL_REFLECTANCE_N = 3, RL_REFLECTANCE_K = 6 };

/* clang-format off */
#define RL_REFLECTANCE_KEYS \
    {.key = "reflectance", .help = "at normal incidence; or n and k", .kind = RL_EFFECT_COLOUR, .high = 1.0, \
     .absent = {NAN, NAN, NAN}, .coefficient = true}, \
    {.key = "n", .help = "real part of the index of refraction", .kind = RL_EFFECT_COLOUR, .low = 0.01, .high = 100.0, \
     .absent = {NAN, NAN, NAN}, .coefficient = true}, \
    {.key = "k", .help = "imaginary part of the index of refraction, 0 for dielectrics", \
     .kind = RL_EFFECT_COLOUR, .high = 100.0, .absent = {NAN, NAN, NAN}}
/* clang-format on */

/* Either the reflectance or both n and k. */
static inline const char *rl_reflectance_check(const double *value, const char **key)
{
    bool reflectance = !isnan(value[RL_REFLECTANCE]), n = !isnan(value[RL_REFLECTANCE_N]),
         k = !isnan(value[RL_REFLECTANCE_K]);
    *key = "reflectance";
    if (reflectance && (n || k))
        return "either the reflectance at normal incidence, or n and k";
    if (!reflectance && !n && !k)
        return "the reflectance at normal incidence, or n and k";
    *key = n ? "k" : "n";
    return reflectance || (n && k) ? NULL : "both n and k, of the complex index of refraction";
}

enum { RL_REFLECTANCE_PARAMS = 3 };

/* n as params[0], k as params[1], n^2 - 1 as params[2], whose w are free (0). */
static inline void rl_reflectance_pack(const double *value, double params[][4])
{
    bool reflectance = !isnan(value[RL_REFLECTANCE]);
    for (int c = 0; c < 3; c++) {
        double n = value[RL_REFLECTANCE_N + c];
        struct rl_fresnel_index index = {n, value[RL_REFLECTANCE_K + c], (n - 1.0) * (n + 1.0)};
        if (reflectance)
            index = rl_fresnel_index(value[RL_REFLECTANCE + c]);
        params[0][c] = index.n;
        params[1][c] = index.k;
        params[2][c] = index.n_n_1;
    }
    params[0][3] = params[1][3] = params[2][3] = 0.0;
}

/* F of channel c at an angle by its cosine and its sine squared. */
static inline double rl_reflectance_at(double params[][4], int c, double cosine, double sin_sin)
{
    return rl_fresnel_of((struct rl_fresnel_index){params[0][c], params[1][c], params[2][c]}, cosine,
                         sin_sin);
}

#endif
