/* Small scenes in memory for the tests of the GPU pipeline: built-in shapes, polygon lights, a camera. */
#ifndef RL_TESTS_GPU_FIXTURE_H
#define RL_TESTS_GPU_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gpu/gpu.h"
#include "scene/plan.h"
#include "scene/scene.h"
#include "scene/shapes.h"
#include "support/check.h"

enum { FIXTURE_MAX = 8 };

/* An empty scene that owns room for FIXTURE_MAX of each kind. */
static inline void fixture_begin(struct rl_scene *scene, int width, int height)
{
    memset(scene, 0, sizeof *scene);
    scene->width = width;
    scene->height = height;
    scene->material = calloc(FIXTURE_MAX, sizeof *scene->material);
    scene->object = calloc(FIXTURE_MAX, sizeof *scene->object);
    scene->light = calloc(FIXTURE_MAX, sizeof *scene->light);
    scene->source = calloc(FIXTURE_MAX, sizeof *scene->source);
    scene->settings = RL_SETTINGS_DEFAULT;
    assert_true(scene->material && scene->object && scene->light && scene->source);
}

static inline void fixture_end(struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++)
        rl_mesh_clear(&scene->object[i].mesh);
    for (size_t i = 0; i < scene->n_lights; i++) {
        for (size_t j = 0; j < scene->light[i].n_polygons; j++)
            rl_polygon_clear(&scene->light[i].polygon[j]);
        free(scene->light[i].polygon);
    }
    free(scene->material);
    free(scene->object);
    free(scene->light);
    free(scene->source);
    memset(scene, 0, sizeof *scene);
}

/* A camera at `position` that looks at `target`, y up. */
static inline void fixture_camera(struct rl_scene *scene, rl_vec3 position, rl_vec3 target,
                                  double fov_y_degrees)
{
    struct rl_camera *c = &scene->camera;
    c->position = position;
    c->forward = v3_normalize(v3_sub(target, position));
    c->right = v3_normalize(v3_cross(c->forward, v3(0.0, 1.0, 0.0)));
    c->up = v3_cross(c->right, c->forward);
    c->fov_y = fov_y_degrees * RL_PI / 180.0;
    c->near_plane = 0.1;
    c->far_plane = 100.0;
}

static inline int fixture_material(struct rl_scene *scene, double rr, double ambient, double diffuse,
                                   double specular, const char *method)
{
    struct rl_material *m = &scene->material[scene->n_materials];
    m->rr = rr;
    m->method = method;
    rl_effect_give_colour(m, "ambient", ambient, 0.8 * ambient, 0.6 * ambient);
    rl_effect_give_colour(m, "diffuse", 0.6 * diffuse, 0.8 * diffuse, diffuse);
    for (int c = 0; c < 3; c++)
        m->specular[c] = specular;
    return (int)scene->n_materials++;
}

/* A built-in shape, scaled and moved. */
static inline void fixture_object(struct rl_scene *scene, enum rl_shape shape, int tessellation, double scale,
                                  rl_vec3 centre, int material)
{
    struct rl_error error;
    struct rl_object *o = &scene->object[scene->n_objects++];
    rl_vec3 low;
    rl_vec3 high;
    check_ok(rl_shape_build(&o->mesh, shape, tessellation, 0.3, &error), &error);
    for (size_t i = 0; i < o->mesh.n_vertices; i++) {
        float *p = o->mesh.position[i];
        p[0] = (float)(scale * p[0] + centre.x);
        p[1] = (float)(scale * p[1] + centre.y);
        p[2] = (float)(scale * p[2] + centre.z);
    }
    rl_mesh_bounds(&o->mesh, &low, &high, &o->centre, &o->radius);
    o->material = material;
}

/* A light of one polygon; its sphere is about the vertices' mean. */
static inline void fixture_light(struct rl_scene *scene, const rl_vec3 *vertex, int n, double r, double g,
                                 double b)
{
    struct rl_error error;
    struct rl_light *l = &scene->light[scene->n_lights++];
    l->polygon = calloc(1, sizeof *l->polygon);
    l->n_polygons = 1;
    assert_non_null(l->polygon);
    check_ok(rl_polygon_make(l->polygon, vertex, n, &error), &error);
    l->radiance[0] = r;
    l->radiance[1] = g;
    l->radiance[2] = b;
    l->area = l->polygon->area;
    for (int i = 0; i < n; i++)
        l->centre = v3_madd(l->centre, 1.0 / n, vertex[i]);
    for (int i = 0; i < n; i++)
        l->radius = fmax(l->radius, v3_length(v3_sub(vertex[i], l->centre)));
    l->centroid = l->centre;
}

/* A point light of this intensity at `at`, or a parallel one of this irradiance from there. */
static inline void fixture_source(struct rl_scene *scene, bool parallel, rl_vec3 at, double r, double g,
                                  double b)
{
    scene->source[scene->n_sources++] = (struct rl_source){
        .parallel = parallel, .at = parallel ? v3_normalize(at) : at, .strength = {r, g, b}};
}

/* A parallelogram centre +- u +- v. */
static inline void fixture_quad(struct rl_scene *scene, rl_vec3 centre, rl_vec3 u, rl_vec3 v, double r,
                                double g, double b)
{
    rl_vec3 vertex[4];
    for (int i = 0; i < 4; i++)
        vertex[i] = v3_madd(v3_madd(centre, i == 0 || i == 3 ? -1.0 : 1.0, u), i < 2 ? -1.0 : 1.0, v);
    fixture_light(scene, vertex, 4, r, g, b);
}

/* A lit sphere that nearly fills the picture: one quad light above and to the left, behind the camera's
 * shoulder. */
static inline void fixture_sphere(struct rl_scene *scene, int width, int height, const char *method,
                                  double rr)
{
    fixture_begin(scene, width, height);
    fixture_camera(scene, v3(0.0, 0.0, 4.0), v3(0.0, 0.0, 0.0), 32.0);
    int material = fixture_material(scene, rr, 0.02, 0.3, 1.0, method);
    fixture_object(scene, RL_SHAPE_SPHERE, 32, 1.0, v3(0.0, 0.0, 0.0), material);
    fixture_quad(scene, v3(-2.0, 2.0, 3.0), v3(0.8, 0.8, 0.0), v3(0.5, -0.5, 0.5), 2.0, 1.5, 1.0);
}

/* A closed box of light about the object: L_e = 1 in every direction. */
static inline void fixture_furnace(struct rl_scene *scene, const char *method, double rr)
{
    fixture_begin(scene, 48, 36);
    fixture_camera(scene, v3(0.0, 0.0, 4.0), v3(0.0, 0.0, 0.0), 32.0);
    fixture_object(scene, RL_SHAPE_SPHERE, 24, 1.0, v3(0.0, 0.0, 0.0),
                   fixture_material(scene, rr, 0.0, 0.0, 1.0, method));
    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2) {
            double c[3] = {0.0, 0.0, 0.0};
            double u[3] = {0.0, 0.0, 0.0};
            double v[3] = {0.0, 0.0, 0.0};
            c[axis] = 9.0 * sign;
            u[(axis + 1) % 3] = 9.001;
            v[(axis + 2) % 3] = 9.001;
            fixture_quad(scene, v3(c[0], c[1], c[2]), v3(u[0], u[1], u[2]), v3(v[0], v[1], v[2]), 1.0, 1.0,
                         1.0);
        }
}

/* Plan, preparation, one frame and the picture, in one. */
static inline void fixture_render(struct rl_image *image, struct rl_gpu *gpu, const struct rl_scene *scene,
                                  const struct rl_settings *settings)
{
    struct rl_error error;
    struct rl_plan plan;
    struct rl_gpu_scene *gs;
    double seconds;
    check_ok(rl_plan_make(&plan, scene, settings, &error), &error);
    check_ok(rl_gpu_scene_make(&gs, gpu, scene, &plan, &error), &error);
    check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
    check_ok(rl_gpu_scene_read(gs, image, &error), &error);
    rl_gpu_scene_free(gs);
    rl_plan_clear(&plan);
}

/* What the plan drops changes no bit. */
static inline void fixture_check_drop(struct rl_gpu *gpu, const struct rl_scene *scene,
                                      struct rl_settings settings)
{
    struct rl_image with, without;
    settings.drop = true;
    fixture_render(&with, gpu, scene, &settings);
    settings.drop = false;
    fixture_render(&without, gpu, scene, &settings);
    for (size_t i = 0; i < 4 * (size_t)with.width * (size_t)with.height; i++)
        if (memcmp(&with.data[i], &without.data[i], sizeof with.data[i]) != 0)
            fail_msg("pixel %zu: %.9g with dropping, %.9g without", i / 4, (double)with.data[i],
                     (double)without.data[i]);
    rl_image_clear(&with);
    rl_image_clear(&without);
}

#endif
