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

size_t rl_scene_polygons(const struct rl_scene *scene)
{
    size_t n = 0;
    for (size_t i = 0; i < scene->n_lights; i++)
        n += scene->light[i].n_polygons;
    return n;
}

static void add_areas(struct rl_lights *lights, const struct rl_light *light)
{
    double share = light->n_polygons == 1 ? 1.0 : 0.5;
    for (size_t i = 0; i < light->n_polygons; i++) {
        struct rl_area_light *area = &lights->area[lights->n_areas++];
        area->vertex = light->polygon[i].vertex;
        area->n = light->polygon[i].n;
        for (int c = 0; c < 3; c++)
            area->radiance[c] = share * light->radiance[c];
    }
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
    lights->area = calloc(rl_scene_polygons(scene) + 1, sizeof *lights->area);
    if (!lights->area)
        return rl_fail_memory(error, "the lights");
    for (size_t i = 0; i < scene->n_lights; i++)
        add_areas(lights, &scene->light[i]);
    return RL_OK;
}

void rl_scene_lights_clear(struct rl_lights *lights)
{
    free(lights->point);
    free(lights->area);
    *lights = (struct rl_lights){0};
}
