/* Scenes of many objects and materials, made from one (see fps.h). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "studies/environment.h"
#include "studies/fps.h"

/* Where the i-th of n objects goes, in radii of the original: rows of ceil(sqrt(n)). */
static void place_of(double at[2], int i, int n)
{
    int across = (int)ceil(sqrt(n) - 1e-9), rows = (n + across - 1) / across, row = i / across;
    double pitch = 2.0 / sqrt(n);
    at[0] = pitch * (i % across - 0.5 * (across - 1));
    at[1] = pitch * (0.5 * (rows - 1) - row);
}

static int copy_object(struct rl_object *object, const struct rl_object *from, rl_vec3 centre, double scale,
                       struct rl_error *error)
{
    *object = *from;
    object->centre = centre;
    object->radius = from->radius * scale;
    object->mesh.position = malloc((from->mesh.n_vertices + 1) * sizeof *object->mesh.position);
    if (!object->mesh.position)
        return rl_fail_memory(error, "an object's copy");
    for (size_t i = 0; i < from->mesh.n_vertices; i++) {
        const float *p = from->mesh.position[i];
        rl_vec3 moved = v3_madd(centre, scale, v3_sub(v3(p[0], p[1], p[2]), from->centre));
        object->mesh.position[i][0] = (float)moved.x;
        object->mesh.position[i][1] = (float)moved.y;
        object->mesh.position[i][2] = (float)moved.z;
    }
    return RL_OK;
}

int rl_fps_scene_make(struct rl_scene *copy, const struct rl_scene *scene, int objects, int roughnesses,
                      struct rl_error *error)
{
    *copy = *scene;
    copy->n_objects = 0;
    copy->object = calloc((size_t)objects, sizeof *copy->object);
    copy->material = calloc((size_t)roughnesses, sizeof *copy->material);
    copy->n_materials = (size_t)roughnesses;
    int status = RL_OK;
    if (!copy->object || !copy->material)
        status = rl_fail_memory(error, "a scene of many objects");
    else if (scene->n_objects == 0)
        status = rl_fail(error, RL_ERR_INPUT, "%s: found no object, expected one or more", scene->path);
    if (status != RL_OK) {
        rl_fps_scene_free(copy);
        return status;
    }
    const struct rl_object *from = &scene->object[rl_environment_object(scene)];
    for (int i = 0; i < roughnesses; i++) {
        copy->material[i] = scene->material[from->material];
        copy->material[i].rr *= 1.0 + 0.001 * i;
    }
    double scale = 1.0 / sqrt(objects), at[2];
    for (int i = 0; i < objects && status == RL_OK; i++) {
        place_of(at, i, objects);
        rl_vec3 centre = v3_madd(from->centre, at[0] * from->radius, scene->camera.right);
        centre = v3_madd(centre, at[1] * from->radius, scene->camera.up);
        status = copy_object(&copy->object[copy->n_objects++], from, centre, scale, error);
        copy->object[i].material = i % roughnesses;
    }
    if (status != RL_OK)
        rl_fps_scene_free(copy);
    return status;
}

void rl_fps_scene_free(struct rl_scene *copy)
{
    for (size_t i = 0; copy->object && i < copy->n_objects; i++)
        free(copy->object[i].mesh.position);
    free(copy->object);
    free(copy->material);
    *copy = (struct rl_scene){0};
}
