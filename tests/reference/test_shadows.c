/* Shadows of effects: what a ray says, and the visible part of a polygon's irradiance, against closed forms. */
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

static void take_mesh(struct rl_object *object, struct rl_mesh mesh)
{
    rl_vec3 low, high;
    object->mesh = mesh;
    rl_mesh_bounds(&object->mesh, &low, &high, &object->centre, &object->radius);
}

/* The rectangle [x0, x1] x [y0, y1] at height z, of two triangles. */
static struct rl_mesh rectangle(double x0, double x1, double y0, double y1, double z)
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

static void set_light(struct world *w, double half, double height)
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
static void world_make(struct world *w, struct rl_mesh occluder, double half, double height)
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

static void world_clear(struct world *w)
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

static bool hidden(const struct world *w, size_t own, rl_vec3 P, rl_vec3 light)
{
    rl_vec3 d = v3_sub(light, P);
    return rl_shadow_rays_hidden(w->rays, own, P, v3_normalize(d), v3_length(d));
}

/* What effect `name` with one colour, white, gives on an upright surface at P of object `own`. */
static void shade(double rgb[3], double off[3], struct world *w, const char *name, size_t own, rl_vec3 P,
                  bool shadows)
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
static double lambert(double x0, double x1, double y0, double y1, double z, rl_vec3 P)
{
    const rl_vec3 v[4] = {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
    const struct rl_surface s = {P, v3(0, 0, 1), v3(0, 0, 1)};
    double params[1][4] = {{1.0 / RL_PI, 0.0, 0.0, 0.0}}, rgb[3];
    rl_effect_find("diffuse-area")->area(&s, v, 4, params, rgb);
    return rgb[0];
}

/* ---- Rays ---- */

/* The shadow of a square is a square: at its border a part in 10^12 decides. */
static void test_border(void **state)
{
    (void)state;
    struct world w;
    struct dice d = dice_make(20261125);
    world_make(&w, rectangle(-0.5, 0.5, -0.5, 0.5, 1.0), 0.1, 3.0);
    for (int i = 0; i < 2000; i++) {
        rl_vec3 light = {uniform(&d, -0.5, 0.5), uniform(&d, -0.5, 0.5), uniform(&d, 1.5, 4.0)};
        /* x = 0.5 in the occluder's plane, seen from the light, comes down at `edge`. */
        double edge = light.x + (0.5 - light.x) * light.z / (light.z - 1.0);
        double y = light.y + uniform(&d, -0.4, 0.4);
        double at = light.y + (y - light.y) * light.z / (light.z - 1.0);
        if (fabs(y) > 0.49)
            continue;
        assert_true(hidden(&w, FLOOR, v3(edge - 1e-12, at, 0.0), light));
        assert_false(hidden(&w, FLOOR, v3(edge + 1e-12, at, 0.0), light));
    }
    world_clear(&w);
}

/* Along the diagonal that its two triangles share no ray slips through, nor round a box's edges and corners. */
static void test_no_gap(void **state)
{
    (void)state;
    struct world w;
    struct dice d = dice_make(20261126);
    struct rl_mesh ball;
    check_ok(rl_shape_build(&ball, RL_SHAPE_SPHERE, 4, 0.3, &error), &error);
    world_make(&w, rectangle(-0.5, 0.5, -0.5, 0.5, 1.0), 0.1, 3.0);
    for (int i = 0; i < 20000; i++) {
        double s = uniform(&d, -0.49, 0.49);
        rl_vec3 P = {uniform(&d, -2.0, 2.0), uniform(&d, -2.0, 2.0), 0.0};
        rl_vec3 through = {s, s, 1.0};
        assert_true(hidden(&w, FLOOR, P, v3_madd(P, 2.0, v3_sub(through, P))));
    }
    world_clear(&w);
    /* Through vertices and along edges of a closed mesh towards its middle. */
    world_make(&w, ball, 0.1, 3.0);
    const struct rl_mesh *mesh = &w.object[OCCLUDER].mesh;
    for (size_t i = 0; i < mesh->n_triangles; i++)
        for (int j = 0; j < 3; j++) {
            const float *a = mesh->position[mesh->triangle[i][j]],
                        *b = mesh->position[mesh->triangle[i][(j + 1) % 3]];
            for (int k = 0; k <= 4; k++) {
                double s = 0.25 * k;
                rl_vec3 on = {(1 - s) * a[0] + s * b[0], (1 - s) * a[1] + s * b[1],
                              (1 - s) * a[2] + s * b[2]};
                assert_true(hidden(&w, FLOOR, v3_scale(3.0, on), v3_scale(0.01, on)));
            }
        }
    world_clear(&w);
}

/* A ball's shadow of a point light is a disc, of a parallel one from above its own outline; the mesh is inside of the ball by 1 - cos of half
 * a segment. */
static void test_ball(void **state)
{
    (void)state;
    enum { SEGMENTS = 64 };
    struct world w;
    struct rl_mesh ball;
    check_ok(rl_shape_build(&ball, RL_SHAPE_SPHERE, SEGMENTS, 0.3, &error), &error);
    for (size_t i = 0; i < ball.n_vertices; i++)
        ball.position[i][2] += 2.0f;
    world_make(&w, ball, 0.1, 5.0);
    double slack = 2.0 * (1.0 - cos(0.25 * RL_PI / SEGMENTS));
    /* The tangent cone from height 5 touches the ball of radius 1 about 2: sin = 1/3. */
    double radius = 5.0 * tan(asin(1.0 / 3.0));
    for (int i = 0; i < 1000; i++) {
        double angle = 2.0 * RL_PI * i / 1000.0, c = cos(angle), s = sin(angle);
        double in = 1.0 - 3.0 * slack, out = 1.0 + 1e-6;
        assert_true(hidden(&w, FLOOR, v3(in * radius * c, in * radius * s, 0), v3(0, 0, 5)));
        assert_false(hidden(&w, FLOOR, v3(out * radius * c, out * radius * s, 0), v3(0, 0, 5)));
        assert_true(rl_shadow_rays_hidden(w.rays, FLOOR, v3(in * c, in * s, 0), v3(0, 0, 1), INFINITY));
        assert_false(rl_shadow_rays_hidden(w.rays, FLOOR, v3(out * c, out * s, 0), v3(0, 0, 1), INFINITY));
        /* Nor is it in its own shadow, front or back. */
        assert_false(hidden(&w, OCCLUDER, v3(c, 0, 2.0 + s), v3(0, 0, 5)));
    }
    world_clear(&w);
}

/* What is met at either end of the ray, and what only touches it. */
static void test_touching(void **state)
{
    (void)state;
    struct world w;
    const float third = 1.0f / 3.0f;
    world_make(&w, rectangle(-1, 1, -1, 1, third), 0.1, 3.0);
    /* A lamp that touches the sheet, seen from below and from above, up to what rounding made of its height. */
    assert_false(hidden(&w, FLOOR, v3(0.2, 0.1, 0.0), v3(0.0, 0.0, 1.0 / 3.0)));
    assert_false(hidden(&w, FLOOR, v3(0.2, 0.1, 1.0), v3(0.0, 0.0, 1.0 / 3.0)));
    /* Above it: hidden. */
    assert_true(hidden(&w, FLOOR, v3(0.2, 0.1, 0.0), v3(0.0, 0.0, 0.334)));
    /* From the sheet's own height nothing is behind it, and along it nothing is in it. */
    assert_false(hidden(&w, FLOOR, v3(0.2, 0.1, 1.0 / 3.0), v3(0.0, 0.0, 3.0)));
    assert_false(hidden(&w, FLOOR, v3(-2.0, 0.1, 1.0 / 3.0), v3(2.0, 0.0, 1.0 / 3.0)));
    assert_true(hidden(&w, FLOOR, v3(0.2, 0.1, 0.33), v3(0.0, 0.0, 3.0)));
    /* Its own points it leaves alone. */
    assert_false(hidden(&w, OCCLUDER, v3(0.2, 0.1, 0.2), v3(0.0, 0.0, 3.0)));
    world_clear(&w);
}

/* ---- Irradiance ---- */

/* Half the plane is covered: what is left of the light is a rectangle. */
static void test_edge_penumbra(void **state)
{
    (void)state;
    struct world w;
    struct dice d = dice_make(20261127);
    double worst = 0.0, stated = 0.0;
    world_make(&w, rectangle(-64, 0, -64, 64, 1.0), 1.0, 2.0);
    for (int i = 0; i < 200; i++) {
        rl_vec3 P = {uniform(&d, -1.5, 1.5), uniform(&d, -1.5, 1.5), 0.0};
        P.x = i == 0 ? 0.0 : P.x;
        /* The edge x = 0 at height 1, seen from P, is at -P.x at height 2. */
        double from = fmax(-1.0, fmin(1.0, -P.x)), exact = lambert(from, 1, -1, 1, 2, P), rgb[3], off[3];
        shade(rgb, off, &w, "diffuse-area", FLOOR, P, true);
        for (int c = 0; c < 3; c++) {
            worst = fmax(worst, fabs(rgb[c] - (c + 1) * exact));
            stated = fmax(stated, off[c]);
            assert_true(fabs(rgb[c] - (c + 1) * exact) <= off[c] + 1e-14);
        }
    }
    print_message("penumbra: off by %.2g at most, stated %.2g\n", worst, stated);
    assert_true(stated > 0.0 && stated < 1e-8);
    /* Right below the edge: half of the light. */
    double half[3], all[3], off[3];
    shade(half, off, &w, "diffuse-area", FLOOR, v3(0, 0, 0), true);
    shade(all, off, &w, "diffuse-area", FLOOR, v3(0, 0, 0), false);
    check_near(half[0], 0.5 * all[0], 1e-9);
    world_clear(&w);
}

/* Seen inside of the light's outline, a square takes away what it would give if it shone. */
static void test_square_before_light(void **state)
{
    (void)state;
    struct world w;
    struct dice d = dice_make(20261128);
    double worst = 0.0, stated = 0.0;
    world_make(&w, rectangle(-0.125, 0.25, -0.25, 0.125, 1.0), 2.0, 2.0);
    for (int i = 0; i < 200; i++) {
        rl_vec3 P = {uniform(&d, -1.0, 1.0), uniform(&d, -1.0, 1.0), 0.0};
        double exact = lambert(-2, 2, -2, 2, 2, P) - lambert(-0.125, 0.25, -0.25, 0.125, 1, P), rgb[3],
               off[3];
        shade(rgb, off, &w, "diffuse-area", FLOOR, P, true);
        worst = fmax(worst, fabs(rgb[0] - exact));
        stated = fmax(stated, off[0]);
        assert_true(fabs(rgb[0] - exact) <= off[0] + 1e-14);
    }
    print_message("square: off by %.2g at most, stated %.2g\n", worst, stated);
    assert_true(stated < 1e-8);
    world_clear(&w);
}

/* A ball of radius r at distance l covers pi (r/l)^2 cos(alpha), of E, where all of it is above the horizon. */
static void test_ball_before_light(void **state)
{
    (void)state;
    struct world w;
    struct rl_mesh ball;
    struct dice d = dice_make(20261129);
    double worst = 0.0;
    check_ok(rl_shape_build(&ball, RL_SHAPE_SPHERE, 16, 0.3, &error), &error);
    for (size_t i = 0; i < ball.n_vertices; i++)
        for (int j = 0; j < 3; j++)
            ball.position[i][j] = 0.25f * ball.position[i][j] + (j == 2 ? 1.0f : 0.0f);
    world_make(&w, ball, 3.0, 2.0);
    for (int i = 0; i < 30; i++) {
        rl_vec3 P = {uniform(&d, -1.0, 1.0), uniform(&d, -1.0, 1.0), 0.0};
        double l_l = v3_dot(P, P) + 1.0;
        double covered = 0.0625 / l_l / sqrt(l_l), rgb[3], off[3];
        shade(rgb, off, &w, "diffuse-area", FLOOR, P, true);
        double found = lambert(-3, 3, -3, 3, 2, P) - rgb[0];
        worst = fmax(worst, fabs(found / covered - 1.0));
        assert_true(off[0] < 1e-4);
    }
    /* The mesh is a little smaller than the ball: about (1 - cos(pi/64)) at the vertices' mean. */
    print_message("ball: its share off by %.2g at most\n", worst);
    assert_true(worst < 4e-3);
    world_clear(&w);
}

/* Behind the light, beside it or the surface's own: not a bit changes. */
static void test_out_of_the_way(void **state)
{
    (void)state;
    static const double height[] = {2.5, -1.0, 1.0}, aside[] = {0.0, 0.0, 40.0};
    static const char *const names[] = {"diffuse", "diffuse-area"};
    struct dice d = dice_make(20261130);
    for (size_t k = 0; k < LENGTH(height); k++) {
        struct world w;
        world_make(&w, rectangle(aside[k] - 1, aside[k] + 1, -1, 1, height[k]), 1.0, 2.0);
        for (int i = 0; i < 50; i++) {
            rl_vec3 P = {uniform(&d, -1.5, 1.5), uniform(&d, -1.5, 1.5), 0.0};
            for (size_t n = 0; n < LENGTH(names); n++) {
                double with[3], without[3], off[3], none[3];
                shade(with, off, &w, names[n], FLOOR, P, true);
                shade(without, none, &w, names[n], FLOOR, P, false);
                assert_memory_equal(with, without, sizeof with);
                assert_true(without[0] > 0.0 && off[0] < 1e-8);
                if (height[k] != 1.0)
                    continue;
                P.z = 1.0; /* on the sheet itself */
                shade(with, off, &w, names[n], OCCLUDER, P, true);
                shade(without, none, &w, names[n], OCCLUDER, P, false);
                assert_memory_equal(with, without, sizeof with);
                P.z = 0.0;
            }
        }
        world_clear(&w);
    }
}

/* A light shrunk to its centroid is there or not, as its centroid is. */
static void test_centroid(void **state)
{
    (void)state;
    struct world w;
    double rgb[3], open[3], off[3];
    world_make(&w, rectangle(-64, 0, -64, 64, 1.0), 1.0, 2.0);
    for (int i = -10; i <= 10; i++) {
        rl_vec3 P = {0.1 * i + 1e-9, 0.2, 0.0};
        shade(rgb, off, &w, "diffuse", FLOOR, P, true);
        shade(open, off, &w, "diffuse", FLOOR, P, false);
        assert_true(open[0] > 0.0 && rgb[0] == (P.x > 0.0 ? open[0] : 0.0));
        /* Ambient light has no shadow. */
        shade(rgb, off, &w, "ambient", FLOOR, P, true);
        assert_true(rgb[0] == 1.0);
    }
    /* In the light's plane there is nothing to be hidden. */
    shade(rgb, off, &w, "diffuse-area", FLOOR, v3(3.0, 0.0, 2.0), true);
    assert_true(rgb[0] == 0.0 && off[0] == 0.0);
    world_clear(&w);
}

/* Shaded at its vertices, a floor has shadows there. */
static void test_vertices(void **state)
{
    (void)state;
    struct world w;
    const struct rl_effect *effect = rl_effect_find("diffuse-area");
    double params[1][RL_EFFECT_PARAMS][4], white[3] = {1.0, 1.0, 1.0}, open[3], none[3];
    world_make(&w, rectangle(-64, 0, -64, 64, 1.0), 1.0, 2.0);
    effect->pack(white, params[0]);
    for (int shadows = 0; shadows < 2; shadows++) {
        struct rl_interpolated vertices;
        const struct rl_interpolated_shading shading = {.effect = &effect,
                                                        .n_effects = 1,
                                                        .params = params,
                                                        .lights = &w.lights,
                                                        .eye = v3(0, 0, 5),
                                                        .shadows = shadows ? w.shadows : NULL,
                                                        .view = &w.view,
                                                        .object = FLOOR};
        check_ok(rl_interpolated_make(&vertices, &w.object[FLOOR].mesh, RL_INTERPOLATION_GOURAUD, &shading, 1,
                                      &error),
                 &error);
        for (int i = 0; i < 4; i++) {
            const float *p = w.object[FLOOR].mesh.position[i];
            shade(open, none, &w, "diffuse-area", FLOOR, v3(p[0], p[1], p[2]), false);
            check_near(vertices.radiance[i][0], shadows && p[0] < 0.0f ? 0.0 : open[0], 1e-9);
        }
        assert_true((vertices.error[0] > 0.0) == (shadows == 1) && vertices.error[0] < 1e-8);
        rl_interpolated_clear(&vertices);
    }
    world_clear(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_border),
        cmocka_unit_test(test_no_gap),
        cmocka_unit_test(test_ball),
        cmocka_unit_test(test_touching),
        cmocka_unit_test(test_edge_penumbra),
        cmocka_unit_test(test_square_before_light),
        cmocka_unit_test(test_ball_before_light),
        cmocka_unit_test(test_out_of_the_way),
        cmocka_unit_test(test_centroid),
        cmocka_unit_test(test_vertices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
