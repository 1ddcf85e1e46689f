/* The sums over lights that turn effects into a colour (see effect.h). */
#include "effects/effect.h"

/* Light from one direction: irradiance on a plane perpendicular to L. */
struct incident {
    rl_vec3 L;
    double irradiance[3];
};

/* False for a light at P itself, which has no direction. */
static bool from_centroid(struct incident *incident, const struct rl_point_light *light, rl_vec3 P)
{
    rl_vec3 d = v3_sub(light->position, P);
    double r_r = v3_dot(d, d);
    if (!(r_r > 0.0))
        return false;
    incident->L = v3_scale(1.0 / sqrt(r_r), d);
    bool flat = v3_dot(light->normal, light->normal) > 0.0;
    double facing = flat ? fabs(v3_dot(light->normal, incident->L)) : 1.0;
    for (int c = 0; c < 3; c++)
        incident->irradiance[c] = light->radiance[c] * (light->area * facing / r_r);
    return true;
}

struct sum {
    const struct rl_effect *const *effects;
    size_t n;
    double (*params)[RL_EFFECT_PARAMS][4];
    const struct rl_surface *s;
    double *rgb;
};

static void add_incident(const struct sum *sum, const struct incident *incident, unsigned sees)
{
    double all[3] = {0.0, 0.0, 0.0}, part[3];
    for (size_t i = 0; i < sum->n; i++) {
        if (!sum->effects[i]->reflect || !(sum->effects[i]->sees & sees))
            continue;
        sum->effects[i]->reflect(sum->s, incident->L, sum->params[i], part);
        for (int c = 0; c < 3; c++)
            all[c] += part[c];
    }
    for (int c = 0; c < 3; c++)
        sum->rgb[c] += incident->irradiance[c] * all[c];
}

void rl_effects_shade(const struct rl_effect *const *effects, size_t n, double params[][RL_EFFECT_PARAMS][4],
                      const struct rl_surface *s, const struct rl_lights *lights, double rgb[3])
{
    const struct sum sum = {effects, n, params, s, rgb};
    struct incident incident;
    double part[3];
    rgb[0] = rgb[1] = rgb[2] = 0.0;
    for (size_t i = 0; i < n; i++) {
        if (!effects[i]->constant)
            continue;
        effects[i]->constant(s, params[i], part);
        for (int c = 0; c < 3; c++)
            rgb[c] += part[c];
    }
    for (size_t i = 0; i < lights->n_points; i++)
        if (from_centroid(&incident, &lights->point[i], s->P))
            add_incident(&sum, &incident, RL_SEES_CENTROIDS);
}
