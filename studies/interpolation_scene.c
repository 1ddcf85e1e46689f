/* The scenes of the study `interpolation` (see interpolation.h). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene/shapes.h"
#include "studies/interpolation.h"

/* Where the eye is, and what it looks at. */
static const struct {
    const char *object;
    enum rl_shape shape;
    rl_vec3 eye, target;
    double fov_degrees;
} views[] = {
    {"sphere", RL_SHAPE_SPHERE, {0.0, 0.0, 4.0}, {0.0, 0.0, 0.0}, 32.0},
    {"teapot", RL_SHAPE_TEAPOT, {0.5, 1.1, 2.6}, {0.1, 0.4, 0.0}, 32.0},
};

/* Its planes are about the object, a little apart from it. */
static void set_camera(struct rl_camera *c, rl_vec3 eye, rl_vec3 target, double fov_degrees,
                       const struct rl_object *object)
{
    c->position = eye;
    c->forward = v3_normalize(v3_sub(target, eye));
    c->right = v3_normalize(v3_cross(c->forward, v3(0.0, 1.0, 0.0)));
    c->up = v3_cross(c->right, c->forward);
    c->fov_y = fov_degrees * RL_PI / 180.0;
    double depth = v3_dot(v3_sub(object->centre, eye), c->forward);
    c->near_plane = 0.999 * (depth - object->radius);
    c->far_plane = 1.001 * (depth + object->radius);
}

/* An irradiance of pi, at most: of `eye` at the nearest point of the object's sphere. */
static void set_light(struct rl_source *source, const struct rl_scene *scene, bool side)
{
    const struct rl_camera *c = &scene->camera;
    const struct rl_object *o = &scene->object[0];
    double nearest = v3_length(v3_sub(c->position, o->centre)) - o->radius;
    *source = (struct rl_source){.parallel = side, .at = c->position};
    if (side)
        source->at = v3_normalize(v3_madd(v3_madd(v3_scale(-0.5, c->forward), 1.0, c->right), 0.6, c->up));
    for (int k = 0; k < 3; k++)
        source->strength[k] = side ? RL_PI : RL_PI * nearest * nearest;
}

/* Of the effect's values: after three of `specular` and that of `grazing`. */
enum { PHONG_EXPONENT = 4 };

/* Bright to 1 where light, normal and eye are in line. */
static void set_material(struct rl_material *material, double exponent)
{
    static const double k_d = 0.6;
    rl_effect_give_colour(material, "diffuse", k_d, k_d, k_d);
    double *phong = rl_effect_give(material, rl_effect_find("phong"));
    for (int k = 0; k < 3; k++)
        phong[k] = (1.0 - k_d) / RL_PI;
    phong[PHONG_EXPONENT] = exponent;
}

int rl_interpolation_scene_make(struct rl_scene *scene, const char *object, int tessellation,
                                const char *light, double exponent, struct rl_error *error)
{
    const size_t n = sizeof views / sizeof views[0];
    size_t v = 0;
    while (v < n && strcmp(views[v].object, object) != 0)
        v++;
    bool side = strcmp(light, "side") == 0;
    *scene = (struct rl_scene){.settings = RL_SETTINGS_DEFAULT};
    if (v == n || (!side && strcmp(light, "eye") != 0))
        return rl_fail(error, RL_ERR_INPUT,
                       "object=%s light=%s: expected sphere or teapot, in light from eye or side", object,
                       light);
    scene->material = calloc(1, sizeof *scene->material);
    scene->object = calloc(1, sizeof *scene->object);
    scene->source = calloc(1, sizeof *scene->source);
    if (!scene->material || !scene->object || !scene->source) {
        rl_interpolation_scene_free(scene);
        return rl_fail_memory(error, "a scene");
    }
    scene->n_materials = scene->n_objects = scene->n_sources = 1;
    struct rl_object *o = &scene->object[0];
    int status = rl_shape_build(&o->mesh, views[v].shape, tessellation, 0.0, error);
    if (status != RL_OK) {
        rl_interpolation_scene_free(scene);
        return status;
    }
    rl_vec3 low, high;
    rl_mesh_bounds(&o->mesh, &low, &high, &o->centre, &o->radius);
    set_camera(&scene->camera, views[v].eye, views[v].target, views[v].fov_degrees, o);
    set_light(&scene->source[0], scene, side);
    set_material(&scene->material[0], exponent);
    return RL_OK;
}

void rl_interpolation_scene_free(struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++)
        rl_mesh_clear(&scene->object[i].mesh);
    free(scene->material);
    free(scene->object);
    free(scene->source);
    *scene = (struct rl_scene){0};
}
