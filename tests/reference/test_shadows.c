/* Shadows of effects: the visible part of a polygon's irradiance, and lights that are there or not, against closed forms. */
#include "reference/shadow_world.h"

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
        cmocka_unit_test(test_edge_penumbra),     cmocka_unit_test(test_square_before_light),
        cmocka_unit_test(test_ball_before_light), cmocka_unit_test(test_out_of_the_way),
        cmocka_unit_test(test_centroid),          cmocka_unit_test(test_vertices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
