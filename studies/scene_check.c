/* See scene_check.h. */
#include "studies/scene_check.h"

#include <stdbool.h>

static bool has_highlight(const struct rl_scene *scene, const struct rl_object *o)
{
    return scene->material[o->material].method != NULL;
}

/* Whether a ray from the camera meets the object's bounding sphere. */
static bool meets(const struct rl_camera *camera, rl_vec3 direction, const struct rl_object *o)
{
    rl_vec3 to = v3_sub(o->centre, camera->position);
    double along = v3_dot(to, direction), square = v3_dot(to, to), radius = o->radius * o->radius;
    if (square <= radius)
        return true;
    return along > 0.0 && square - along * along <= radius;
}

static bool is_seen(const struct rl_scene *scene, const struct rl_object *o)
{
    for (int y = 0; y < scene->height; y++)
        for (int x = 0; x < scene->width; x++)
            if (meets(&scene->camera, rl_camera_ray(&scene->camera, scene->width, scene->height, x, y), o))
                return true;
    return false;
}

int rl_scene_check(const struct rl_scene *scene, struct rl_error *error)
{
    if (scene->n_lights == 0)
        return rl_fail(
            error, RL_ERR_INPUT,
            "%s: found no shaped light (and %zu without a shape), expected a polygon or mesh light "
            "to study",
            scene->path, scene->n_sources);
    size_t n = 0;
    for (size_t i = 0; i < scene->n_objects; i++) {
        const struct rl_object *o = &scene->object[i];
        if (!has_highlight(scene, o))
            continue;
        n++;
        if (is_seen(scene, o))
            return RL_OK;
    }
    if (n == 0)
        return rl_fail(error, RL_ERR_INPUT,
                       "%s: found no object with a highlight, expected one whose material has rr",
                       scene->path);
    return rl_fail(error, RL_ERR_INPUT,
                   "%s: found no object with a highlight at any pixel of %dx%d, expected one in view",
                   scene->path, scene->width, scene->height);
}

int rl_foreground_check(const struct rl_image *picture, struct rl_error *error)
{
    size_t n = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < n; i++)
        if (picture->data[4 * i + 3] > 0.0f)
            return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "found no object at any pixel of %dx%d, expected some foreground",
                   picture->width, picture->height);
}
