/* A floor, something above it and a square light, for the tests of shadows. */
#ifndef TESTS_REFERENCE_SHADOW_WORLD_H
#define TESTS_REFERENCE_SHADOW_WORLD_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "reference/fixture.h"
#include "reference/interpolated.h"
#include "reference/shadows.h"
#include "scene/plan.h"
#include "scene/shapes.h"
#include "support/check.h"

enum { FLOOR, OCCLUDER };

static struct rl_error error;

struct world {
    struct rl_scene scene;
    struct rl_object object[2];
    struct rl_light light;
    struct rl_polygon polygon;
    struct rl_lights lights;
    struct rl_shadow_rays *rays;
    struct rl_occluders *occluders;
    struct rl_shadows *shadows;
    struct rl_shadows_view view;
};

static inline void take_mesh(struct rl_object *object, struct rl_mesh mesh)
{
    rl_vec3 low, high;
    object->mesh = mesh;
    rl_mesh_bounds(&object->mesh, &low, &high, &object->centre, &object->radius);
}

/* The rectangle [x0, x1] x [y0, y1] at height z, of two triangles. */
static inline struct rl_mesh rectangle(double x0, double x1, double y0, double y1, double z)
{
    struct rl_mesh mesh;
    const double x[4] = {x0, x1, x1, x0}, y[4] = {y0, y0, y1, y1};
    static const uint32_t triangle[2][3] = {{0, 1, 2}, {0, 2, 3}};
    check_ok(rl_mesh_allocate(&mesh, 4, 2, &error), &error);
    for (int i = 0; i < 4; i++) {
        mesh.position[i][0] = (float)x[i];
        mesh.position[i][1] = (float)y[i];
        mesh.position[i][2] = (float)z;
        mesh.normal[i][2] = 1.0f;
    }
    memcpy(mesh.triangle, triangle, sizeof triangle);
    return mesh;
}

static inline void set_light(struct world *w, double half, double height)
{
    const rl_vec3 v[4] = {
        {-half, -half, height}, {half, -half, height}, {half, half, height}, {-half, half, height}};
    check_ok(rl_polygon_make(&w->polygon, v, 4, &error), &error);
    w->light = (struct rl_light){.n_polygons = 1,
                                 .polygon = &w->polygon,
                                 .radiance = {1.0, 2.0, 3.0},
                                 .centre = v3(0.0, 0.0, height),
                                 .centroid = v3(0.0, 0.0, height),
                                 .radius = 1.5 * half,
                                 .area = w->polygon.area};
}

/* A floor at z = 0, an occluder, and a square light [-half, half]^2 at a height. */
static inline void world_make(struct world *w, struct rl_mesh occluder, double half, double height)
{
    memset(w, 0, sizeof *w);
    take_mesh(&w->object[FLOOR], rectangle(-9, 9, -9, 9, 0));
    take_mesh(&w->object[OCCLUDER], occluder);
    set_light(w, half, height);
    w->scene = (struct rl_scene){.n_objects = 2, .object = w->object, .n_lights = 1, .light = &w->light};
    check_ok(rl_scene_lights_make(&w->lights, &w->scene, &error), &error);
    check_ok(rl_shadow_rays_make(&w->rays, &w->scene, &error), &error);
    check_ok(rl_occluders_make(&w->occluders, &w->scene, w->rays, &error), &error);
    check_ok(rl_shadows_make(&w->shadows, &w->scene, w->rays, w->occluders, &w->lights, NULL, 1e-9, &error),
             &error);
}

static inline void world_clear(struct world *w)
{
    rl_shadows_view_clear(&w->view);
    rl_shadows_free(w->shadows);
    rl_occluders_free(w->occluders);
    rl_shadow_rays_free(w->rays);
    rl_scene_lights_clear(&w->lights);
    rl_polygon_clear(&w->polygon);
    for (int i = 0; i < 2; i++)
        rl_mesh_clear(&w->object[i].mesh);
}

static inline bool hidden(const struct world *w, size_t own, rl_vec3 P, rl_vec3 light)
{
    rl_vec3 d = v3_sub(light, P);
    return rl_shadow_rays_hidden(w->rays, own, P, v3_normalize(d), v3_length(d));
}

/* What effect `name` with one colour, white, gives on an upright surface at P of object `own`. */
static inline void shade(double rgb[3], double off[3], struct world *w, const char *name, size_t own,
                         rl_vec3 P, bool shadows)
{
    const struct rl_effect *effect = rl_effect_find(name);
    double params[1][RL_EFFECT_PARAMS][4], white[3] = {1.0, 1.0, 1.0};
    const struct rl_surface s = {P, v3(0, 0, 1), v3_normalize(v3(0.3, 0.2, 1.0))};
    struct rl_lights lights = w->lights;
    effect->pack(white, params[0]);
    lights.visibility = shadows ? rl_shadows_see(&w->view, w->shadows, own) : NULL;
    rl_effects_shade_within(&effect, 1, params, &s, &lights, rgb, off);
}

/* E/pi of a rectangle of radiance 1, by Lambert's edge sum. */
static inline double lambert(double x0, double x1, double y0, double y1, double z, rl_vec3 P)
{
    const rl_vec3 v[4] = {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
    const struct rl_surface s = {P, v3(0, 0, 1), v3(0, 0, 1)};
    double params[1][4] = {{1.0 / RL_PI, 0.0, 0.0, 0.0}}, rgb[3];
    rl_effect_find("diffuse-area")->area(&s, v, 4, params, rgb);
    return rgb[0];
}

#endif
