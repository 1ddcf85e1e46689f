/* The sums over lights that turn effects into a colour (see effect.h). */
#include "effects/effect.h"

#include "model/plane.h"

/* d/2^e and 4^e, e chosen so that the square of d is a number: below 1e-140 units and above 1e140 it would be 0, rough or infinite. */
static double bring_near(rl_vec3 *d)
{
    double most = fmax(fabs(d->x), fmax(fabs(d->y), fabs(d->z)));
    if (!(most > 0.0) || (most > 1e-140 && most < 1e140))
        return 1.0;
    int e = ilogb(most);
    *d = v3(ldexp(d->x, -e), ldexp(d->y, -e), ldexp(d->z, -e));
    return ldexp(1.0, e) * ldexp(1.0, e);
}

/* L from P to the light at Q, and x/r^2 for each x of `strength`. False where there is no direction, or one of the x/r^2 is beyond the range
 * of numbers: so near a light is where P is. */
static bool arrive(struct rl_incident *incident, rl_vec3 Q, rl_vec3 P, const double strength[3])
{
    rl_vec3 d = v3_sub(Q, P);
    double half = 1.0;
    if (!isfinite(d.x) || !isfinite(d.y) || !isfinite(d.z)) {
        half = 0.5;
        d = v3_sub(v3_scale(half, Q), v3_scale(half, P));
    }
    double unit = bring_near(&d), r_r = v3_dot(d, d);
    if (!(r_r > 0.0))
        return false;
    incident->L = v3_normalize(d);
    incident->distance = sqrt(r_r) * sqrt(unit) / half;
    bool finite = true;
    for (int c = 0; c < 3; c++) {
        incident->irradiance[c] = strength[c] > 0.0 ? strength[c] / r_r / unit * half * half : 0.0;
        finite = finite && isfinite(incident->irradiance[c]);
    }
    return finite;
}

bool rl_incident_from_source(struct rl_incident *incident, const struct rl_source *source, rl_vec3 P)
{
    if (!source->parallel)
        return arrive(incident, source->at, P, source->strength);
    incident->L = source->at;
    incident->distance = INFINITY;
    for (int c = 0; c < 3; c++)
        incident->irradiance[c] = source->strength[c];
    return true;
}

bool rl_incident_from_centroid(struct rl_incident *incident, const struct rl_point_light *light, rl_vec3 P,
                               double unit)
{
    rl_vec3 Q = light->position, d = v3_sub(v3_scale(0.5, Q), v3_scale(0.5, P));
    double facing = 1.0, strength[3];
    if (v3_dot(light->normal, light->normal) > 0.0) {
        facing = fabs(v3_dot(light->normal, v3_normalize(d)));
        if (fabs(v3_dot(light->normal, d)) <=
            0.5 * rl_plane_rounding(light->normal, rl_plane_most(&Q, 1), P, unit))
            return false;
    }
    for (int c = 0; c < 3; c++)
        strength[c] = light->radiance[c] * (light->area * facing);
    return arrive(incident, Q, P, strength);
}

struct sum {
    const struct rl_effect *const *effects;
    size_t n;
    double (*params)[RL_EFFECT_PARAMS][4];
    const struct rl_surface *s;
    const struct rl_visibility *visibility; /* NULL: nothing hides the lights */
    double *rgb, *error;
    double unit; /* of rounding, of s->P */
};

static void add_incident(const struct sum *sum, const struct rl_incident *incident, unsigned sees)
{
    double all[3] = {0.0, 0.0, 0.0}, part[3];
    for (size_t i = 0; i < sum->n; i++) {
        if (!sum->effects[i]->reflect || !(sum->effects[i]->sees & sees))
            continue;
        sum->effects[i]->reflect(sum->s, incident->L, sum->params[i], part);
        for (int c = 0; c < 3; c++)
            all[c] += part[c];
    }
    const struct rl_visibility *v = sum->visibility;
    /* Most lights that do not arrive are behind the surface: nothing is asked about them. */
    bool dark = !(all[0] > 0.0) && !(all[1] > 0.0) && !(all[2] > 0.0);
    if (v && (dark || v->hidden(v->user, sum->s, incident->L, incident->distance)))
        return;
    for (int c = 0; c < 3; c++)
        sum->rgb[c] += incident->irradiance[c] * all[c];
}

static void add_area(const struct sum *sum, const struct rl_area_light *light, size_t index)
{
    double part[3], share = 1.0, error = 0.0;
    if (sum->unit > RL_UNIT_DOUBLE &&
        rl_plane_distance(light->vertex, (size_t)light->n, sum->s->P, sum->unit) == 0.0)
        return;
    bool asked = !sum->visibility;
    for (size_t i = 0; i < sum->n; i++) {
        if (!sum->effects[i]->area)
            continue;
        if (!asked)
            share = sum->visibility->share(sum->visibility->user, sum->s, index, &error);
        asked = true;
        sum->effects[i]->area(sum->s, light->vertex, light->n, sum->params[i], part);
        for (int c = 0; c < 3; c++) {
            sum->rgb[c] += light->radiance[c] * part[c] * share;
            sum->error[c] += light->radiance[c] * part[c] * error;
        }
    }
}

enum rl_effect_gives rl_effect_gives(const struct rl_effect *effect)
{
    if (effect->constant)
        return RL_GIVES_CONSTANT;
    return effect->factor ? RL_GIVES_FACTOR : RL_GIVES_REFLECTED;
}

void rl_effects_shade_within(const struct rl_effect *const *effects, size_t n,
                             double params[][RL_EFFECT_PARAMS][4], const struct rl_surface *s,
                             const struct rl_lights *lights, double rgb[3], double error[3])
{
    const struct sum sum = {effects, n, params, s, lights->visibility, rgb, error, lights->unit};
    struct rl_incident incident;
    double part[3];
    rgb[0] = rgb[1] = rgb[2] = 0.0;
    error[0] = error[1] = error[2] = 0.0;
    for (size_t i = 0; i < n; i++) {
        if (!effects[i]->constant)
            continue;
        effects[i]->constant(params[i], part);
        for (int c = 0; c < 3; c++)
            rgb[c] += part[c];
    }
    for (size_t i = 0; i < lights->n_sources; i++)
        if (rl_incident_from_source(&incident, &lights->source[i], s->P))
            add_incident(&sum, &incident, RL_SEES_SOURCES);
    for (size_t i = 0; i < lights->n_points; i++)
        if (rl_incident_from_centroid(&incident, &lights->point[i], s->P, lights->unit))
            add_incident(&sum, &incident, RL_SEES_CENTROIDS);
    for (size_t i = 0; i < lights->n_areas; i++)
        add_area(&sum, &lights->area[i], i);
}

void rl_effects_shade(const struct rl_effect *const *effects, size_t n, double params[][RL_EFFECT_PARAMS][4],
                      const struct rl_surface *s, const struct rl_lights *lights, double rgb[3])
{
    double error[3];
    rl_effects_shade_within(effects, n, params, s, lights, rgb, error);
}

void rl_effects_factor(const struct rl_effect *const *effects, size_t n, double params[][RL_EFFECT_PARAMS][4],
                       const struct rl_surface *s, double rgb[3])
{
    double one[3];
    rgb[0] = rgb[1] = rgb[2] = 1.0;
    for (size_t i = 0; i < n; i++) {
        if (!effects[i]->factor)
            continue;
        effects[i]->factor(s, params[i], one);
        for (int c = 0; c < 3; c++)
            rgb[c] *= one[c];
    }
}
