/* What the fur effects share: how their colours are packed, and their sum. */
#ifndef RL_EFFECTS_FUR_H
#define RL_EFFECTS_FUR_H

#include "effects/effect.h"
#include "model/fur.h"

/* off or on; made when colours are packed, so no module belongs to it. */
static const struct rl_effect_choice rl_fur_monochrome[] = {{"off", NULL}, {"on", NULL}, {0}};

/* Diffuse and specular colour and the exponent, the first seven values, as params[0] (diffuse, exponent) and params[1] (specular);
 * monochrome: each colour as its luminance (Rec. 709), which makes the effect's own value that. */
static inline void rl_fur_pack(const double *value, bool monochrome, double params[][4])
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

/* factor (k_d diffuse + k_s specular^p) */
static inline void rl_fur_sum(double rgb[3], double params[][4], double factor, double diffuse,
                              double specular)
{
    double lobe = pow(specular, params[0][3]);
    for (int c = 0; c < 3; c++)
        rgb[c] = factor * (params[0][c] * diffuse + params[1][c] * lobe);
}

#endif
