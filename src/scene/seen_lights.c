/* The lights of a scene as effects see them (struct rl_lights). */
#include <stdlib.h>

#include "scene/scene.h"

struct rl_point_light rl_light_as_point(const struct rl_light *light)
{
    return (struct rl_point_light){
        .position = light->centroid,
        .normal = light->n_polygons == 1 ? light->polygon[0].normal : v3(0.0, 0.0, 0.0),
        .area = light->area,
        .radiance = {light->radiance[0], light->radiance[1], light->radiance[2]},
    };
}

int rl_scene_lights_make(struct rl_lights *lights, const struct rl_scene *scene, struct rl_error *error)
{
    *lights = (struct rl_lights){
        .n_points = scene->n_lights, .n_sources = scene->n_sources, .source = scene->source};
    lights->point = calloc(scene->n_lights + 1, sizeof *lights->point);
    if (!lights->point)
        return rl_fail_memory(error, "the lights");
    for (size_t i = 0; i < scene->n_lights; i++)
        lights->point[i] = rl_light_as_point(&scene->light[i]);
    return RL_OK;
}

void rl_scene_lights_clear(struct rl_lights *lights)
{
    free(lights->point);
    *lights = (struct rl_lights){0};
}
