/* `margin auto` (see margin.h for the derivation; its names are used here). */
#include "scene/margin.h"

#include <math.h>

#include "model/ellipsoid.h"

/* f: a direction reads the texel it falls into, whose middle saw the light. The cube's face is at distance 1 and 2 wide. */
static double map_reach(const struct rl_plan_material *m, const struct rl_settings *s)
{
    return m->method->needs_environment ? sqrt(2.0) / s->env_size : 0.0;
}

/* e: components of H are stored as (H + 1)/2, so that H has twice the rounding. */
static double normal_turn(const struct rl_plan_material *m, const struct rl_settings *s)
{
    if (!m->method->needs_normal_map)
        return 0.0;
    double rounding = s->normal_bits == RL_NORMAL_BITS_FLOAT  ? ldexp(1.0, -24)
                      : s->normal_bits == RL_NORMAL_BITS_HALF ? ldexp(1.0, -11)
                                                              : 1.0 / (ldexp(1.0, s->normal_bits) - 1.0);
    /* Bits that OpenGL has no format for are kept in 16 (gpu/textures.c), rounded once more. */
    if (s->normal_bits > 0 && s->normal_bits != 8 && s->normal_bits != 10 && s->normal_bits != 16)
        rounding += 1.0 / 65535.0;
    return asin(fmin(1.0, sqrt(3.0) * rounding));
}

/* b, the angle beside a light of angular radius a. */
static double blur(const struct rl_ellipsoid *e, double a, double loss, bool one_light)
{
    double both = 2.0 * rl_ellipsoid_inverse(e, 1.0 - 0.5 * loss).delta;
    double turn = cos(a) - sin(a) * sin(a);
    if (!one_light || !(a < 0.5 * RL_PI))
        return both;
    return fmin(both, fmax(2.0 * rl_ellipsoid_inverse(e, 1.0 - loss).delta, acos(turn) - a));
}

double rl_margin_auto(const struct rl_scene *scene, const struct rl_plan_material *m,
                      const struct rl_settings *settings, double loss)
{
    struct rl_ellipsoid e = rl_ellipsoid_make(m->rr);
    bool from_centre = m->method->needs_environment;
    double wider = map_reach(m, settings) + 2.0 * normal_turn(m, settings), margin = 0.0;
    for (size_t i = 0; i < scene->n_objects; i++) {
        const struct rl_object *object = &scene->object[i];
        if (object->material != m->material)
            continue;
        for (size_t j = 0; j < scene->n_lights; j++) {
            double r = scene->light[j].radius;
            double d = v3_length(v3_sub(scene->light[j].centre, object->centre)) +
                       (from_centre ? 0.0 : object->radius);
            double a = asin(fmin(1.0, r / d)) + wider;
            double angle = a + blur(&e, a, loss, from_centre && scene->n_lights == 1);
            if (!(angle < 0.5 * RL_PI))
                return INFINITY;
            margin = fmax(margin, d * sin(angle) / r - 1.0);
        }
    }
    return margin;
}
