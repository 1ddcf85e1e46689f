/* Irradiance at a point (see irradiance.h): the effect diffuse-area of a surface that sends k_d E/pi back, with k_d = pi. */
#include "scene/irradiance.h"

static void shade(double rgb[3], const struct rl_lights *lights, const struct rl_surface *s, double unit)
{
    const struct rl_effect *effect = rl_effect_find("diffuse-area");
    double params[1][RL_EFFECT_PARAMS][4] = {{{1.0, 1.0, 1.0, 0.0}}};
    rl_effects_shade(&effect, 1, params, s, lights, rgb);
    for (int c = 0; c < 3; c++)
        rgb[c] *= unit;
}

int rl_scene_irradiance(double rgb[][3], const struct rl_scene *scene, rl_vec3 P, rl_vec3 N,
                        struct rl_error *error)
{
    const struct rl_surface s = {.P = P, .N = N, .V = N};
    double unit = scene->white > 0.0 ? scene->white : 1.0;
    for (size_t i = 0; i < scene->n_sources; i++) {
        struct rl_incident incident;
        if (!rl_incident_from_source(&incident, &scene->source[i], P))
            return rl_fail(error, RL_ERR_INPUT,
                           "found the place of the light %.64s, expected a point away from it",
                           scene->source[i].name);
    }
    struct rl_lights all;
    int status = rl_scene_lights_make(&all, scene, error);
    for (size_t i = 0, first = 0; i < scene->n_lights && status == RL_OK; i++) {
        const struct rl_lights one = {.n_areas = scene->light[i].n_polygons, .area = all.area + first};
        shade(rgb[i], &one, &s, unit);
        first += one.n_areas;
    }
    for (size_t i = 0; i < scene->n_sources && status == RL_OK; i++) {
        const struct rl_lights one = {.n_sources = 1, .source = &scene->source[i]};
        shade(rgb[scene->n_lights + i], &one, &s, unit);
    }
    rl_scene_lights_clear(&all);
    return status;
}
