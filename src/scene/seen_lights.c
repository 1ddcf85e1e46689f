/* The lights of a scene as effects see them (struct rl_lights). */
#include <stdlib.h>

#include "model/plane.h"
#include "scene/plan.h"

struct rl_point_light rl_light_as_point(const struct rl_light *light)
{
    return (struct rl_point_light){
        .position = light->centroid,
        .normal = light->n_polygons == 1 ? light->polygon[0].normal : light->normal,
        .area = light->area,
        .radiance = {light->radiance[0], light->radiance[1], light->radiance[2]},
    };
}

/* A ray into a closed, convex body meets two of its faces, one into a sheet that hides nothing of itself one. */
static void add_areas(struct rl_lights *lights, const struct rl_light *light)
{
    double share = light->closed ? 0.5 : 1.0;
    for (size_t i = 0; i < light->n_polygons; i++) {
        struct rl_area_light *area = &lights->area[lights->n_areas++];
        area->vertex = light->polygon[i].vertex;
        area->n = light->polygon[i].n;
        for (int c = 0; c < 3; c++)
            area->radiance[c] = share * light->radiance[c];
    }
}

/* With the lights of these indices; NULL: all. */
static int make(struct rl_lights *lights, const struct rl_scene *scene, const size_t *index, size_t n,
                struct rl_error *error)
{
    size_t n_areas = 0;
    for (size_t i = 0; i < n; i++)
        n_areas += scene->light[index ? index[i] : i].n_polygons;
    lights->point = calloc(n + 1, sizeof *lights->point);
    lights->area = calloc(n_areas + 1, sizeof *lights->area);
    if (!lights->point || !lights->area)
        return rl_fail_memory(error, "the lights");
    lights->n_points = n;
    lights->unit = RL_UNIT_SINGLE;
    for (size_t i = 0; i < n; i++) {
        const struct rl_light *light = &scene->light[index ? index[i] : i];
        lights->point[i] = rl_light_as_point(light);
        add_areas(lights, light);
    }
    return RL_OK;
}

int rl_scene_lights_make(struct rl_lights *lights, const struct rl_scene *scene, struct rl_error *error)
{
    *lights = (struct rl_lights){.n_sources = scene->n_sources, .source = scene->source};
    return make(lights, scene, NULL, scene->n_lights, error);
}

int rl_plan_lights_make(struct rl_lights *lights, const struct rl_plan *plan, const struct rl_scene *scene,
                        struct rl_error *error)
{
    *lights = (struct rl_lights){0};
    return make(lights, scene, plan->light, plan->n_lights, error);
}

size_t rl_plan_polygons(const struct rl_plan *plan, const struct rl_scene *scene)
{
    size_t n = 0;
    for (size_t i = 0; i < plan->n_lights; i++)
        n += scene->light[plan->light[i]].n_polygons;
    return n;
}

void rl_scene_lights_clear(struct rl_lights *lights)
{
    free(lights->point);
    free(lights->area);
    *lights = (struct rl_lights){0};
}
