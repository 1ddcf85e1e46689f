/* Shading at vertices and of triangles on the CPU: values, weights, threads; and where a triangle is shaded as a whole. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "reference/interpolated.h"
#include "scene/shapes.h"
#include "support/check.h"

/* Light from right above: k_d/pi N.y for N, times 3. */
static const struct rl_effect *effects[1];
static double params[1][RL_EFFECT_PARAMS][4];
static const struct rl_source sun = {.parallel = true, .at = {0.0, 1.0, 0.0}, .strength = {3.0, 3.0, 3.0}};
static const struct rl_lights lights = {.n_sources = 1, .source = &sun};

static int set_up(void **state)
{
    (void)state;
    effects[0] = rl_effect_find("diffuse");
    const double k_d[3] = {RL_PI, 0.5 * RL_PI, 0.0};
    effects[0]->pack(k_d, params[0]);
    return 0;
}

static struct rl_interpolated_shading shading(void)
{
    return (struct rl_interpolated_shading){.effect = effects,
                                            .n_effects = 1,
                                            .params = params,
                                            .lights = &lights,
                                            .eye = v3(0.0, 0.0, 5.0),
                                            .both_sides = true};
}

static void make_sphere(struct rl_mesh *mesh)
{
    struct rl_error error;
    check_ok(rl_shape_build(mesh, RL_SHAPE_SPHERE, 3, 0.0, &error), &error);
}

static void test_facet(void **state)
{
    (void)state;
    float position[4][3] = {{0, 0, 0}, {3, 0, 0}, {0, 0, 6}, {9, 0, 0}};
    uint32_t triangle[3][3] = {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}};
    const struct rl_mesh mesh = {
        .n_vertices = 4, .n_triangles = 3, .position = position, .triangle = triangle};
    static const double expected[3] = {-1.0, 1.0, 0.0}; /* the last has no area */
    for (size_t t = 0; t < 3; t++) {
        rl_vec3 centroid, normal;
        rl_mesh_facet(&mesh, t, &centroid, &normal);
        check_near(normal.y, expected[t], 1e-15);
        check_near(v3_length(normal), fabs(expected[t]), 1e-15);
        check_near(centroid.x, t == 2 ? 4.0 : 1.0, 1e-15);
        check_near(centroid.z, t == 2 ? 0.0 : 2.0, 1e-15);
    }
}

static void test_gouraud(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_mesh mesh;
    struct rl_interpolated found;
    const struct rl_interpolated_shading shades = shading();
    make_sphere(&mesh);
    check_ok(rl_interpolated_make(&found, &mesh, RL_INTERPOLATION_GOURAUD, &shades, 2, &error), &error);
    for (size_t t = 0; t < mesh.n_triangles; t++) {
        static const double weights[][3] = {
            {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {0.5, 0.3, 0.2}};
        for (size_t i = 0; i < sizeof weights / sizeof weights[0]; i++) {
            double rgb[3], expected = 0.0, rest = 0.0;
            for (int k = 0; k < 3; k++)
                expected += weights[i][k] * 3.0 * fmax(0.0, mesh.normal[mesh.triangle[t][k]][1]);
            rl_interpolated_at(rgb, &found, t, weights[i], false);
            check_near(rgb[0], expected, 1e-6);
            check_near(rgb[1], 0.5 * expected, 1e-6);
            check_near(rgb[2], 0.0, 0.0);
            /* From behind every normal is turned round. */
            for (int k = 0; k < 3; k++)
                rest += weights[i][k] * 3.0 * fmax(0.0, -mesh.normal[mesh.triangle[t][k]][1]);
            rl_interpolated_at(rgb, &found, t, weights[i], true);
            check_near(rgb[0], rest, 1e-6);
        }
    }
    rl_interpolated_clear(&found);
    rl_mesh_clear(&mesh);
}

static void test_constant(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_mesh mesh;
    struct rl_interpolated found;
    const struct rl_interpolated_shading shades = shading();
    make_sphere(&mesh);
    check_ok(rl_interpolated_make(&found, &mesh, RL_INTERPOLATION_CONSTANT, &shades, 2, &error), &error);
    for (size_t t = 0; t < mesh.n_triangles; t++) {
        static const double corner[3] = {1.0, 0.0, 0.0}, inside[3] = {0.2, 0.3, 0.5};
        double a[3], b[3];
        rl_vec3 centroid, normal;
        rl_mesh_facet(&mesh, t, &centroid, &normal);
        rl_interpolated_at(a, &found, t, corner, false);
        rl_interpolated_at(b, &found, t, inside, false);
        assert_memory_equal(a, b, sizeof a);
        check_near(a[0], 3.0 * fmax(0.0, normal.y), 1e-12);
        rl_interpolated_at(a, &found, t, corner, true);
        check_near(a[0], 3.0 * fmax(0.0, -normal.y), 1e-12);
    }
    rl_interpolated_clear(&found);
    rl_mesh_clear(&mesh);
}

/* The same bits whatever the number of threads; of phong there is nothing to keep. */
static void test_threads(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_mesh mesh;
    const struct rl_interpolated_shading shades = shading();
    make_sphere(&mesh);
    for (int i = 0; i < RL_INTERPOLATIONS; i++) {
        struct rl_interpolated one, three;
        enum rl_interpolation interpolation = (enum rl_interpolation)i;
        check_ok(rl_interpolated_make(&one, &mesh, interpolation, &shades, 1, &error), &error);
        check_ok(rl_interpolated_make(&three, &mesh, interpolation, &shades, 3, &error), &error);
        if (interpolation == RL_INTERPOLATION_PHONG) {
            assert_null(one.radiance);
        } else {
            size_t n = interpolation == RL_INTERPOLATION_CONSTANT ? mesh.n_triangles : mesh.n_vertices;
            assert_memory_equal(one.radiance, three.radiance, n * sizeof *one.radiance);
        }
        rl_interpolated_clear(&one);
        rl_interpolated_clear(&three);
    }
    rl_mesh_clear(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_facet),
        cmocka_unit_test(test_gouraud),
        cmocka_unit_test(test_constant),
        cmocka_unit_test(test_threads),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
