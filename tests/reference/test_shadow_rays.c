/* What a shadow ray says, to the last digit. */
#include "reference/shadow_world.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_border),
        cmocka_unit_test(test_no_gap),
        cmocka_unit_test(test_ball),
        cmocka_unit_test(test_touching),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
