/* One effect in light from one direction, and sums over directions, for tests of effects. */
#ifndef RL_TESTS_EFFECTS_LAMP_H
#define RL_TESTS_EFFECTS_LAMP_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "effects/effect.h"
#include "support/check.h"

struct lamp {
    const struct rl_effect *effect;
    double params[RL_EFFECT_PARAMS][4];
};

/* The effect with every parameter as if left out; change what value() returns, then pack. */
static struct rl_material lamp_material;

static inline double *lamp_values(struct lamp *lamp, const char *name)
{
    lamp->effect = rl_effect_find(name);
    assert_non_null(lamp->effect);
    return rl_effect_give(&lamp_material, lamp->effect);
}

static inline void lamp_pack(struct lamp *lamp)
{
    lamp->effect->pack(rl_effect_given(&lamp_material, lamp->effect), lamp->params);
}

/* The red value for N, V and L of any length. */
static inline double lamp_red(struct lamp *lamp, rl_vec3 N, rl_vec3 V, rl_vec3 L)
{
    const struct rl_surface s = {.N = v3_normalize(N), .V = v3_normalize(V)};
    double rgb[3] = {NAN, NAN, NAN};
    lamp->effect->reflect(&s, v3_normalize(L), lamp->params, rgb);
    return rgb[0];
}

static inline rl_vec3 lamp_direction(double cosine, double azimuth)
{
    double r = sqrt(fmax(0.0, 1.0 - cosine * cosine));
    return v3(r * cos(azimuth), r * sin(azimuth), cosine);
}

/* The integral over directions of cosines [low, 1] about z, by midpoints: of light (or, over_view, of the eye, weighted by its cosine),
 * N = z, the other direction fixed. */
static inline double lamp_integral(struct lamp *lamp, rl_vec3 fixed, bool over_view, double low)
{
    enum { RINGS = 1600, SPOKES = 40 };
    const rl_vec3 N = {0.0, 0.0, 1.0};
    double sum = 0.0;
    for (int i = 0; i < RINGS; i++)
        for (int j = 0; j < SPOKES; j++) {
            double c = low + (1.0 - low) * (i + 0.5) / RINGS;
            rl_vec3 d = lamp_direction(c, 2.0 * RL_PI * (j + 0.5) / SPOKES);
            sum += over_view ? c * lamp_red(lamp, N, d, fixed) : lamp_red(lamp, N, fixed, d);
        }
    return sum * (1.0 - low) * 2.0 * RL_PI / (RINGS * (double)SPOKES);
}

#endif
