/* The teapot's normals: against finite differences, at the lid's tip, outwards on every patch, and the
 * same on both sides of the seams where the pot is smooth. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene/teapot.h"
#include "support/check.h"

static struct rl_error error;

static rl_vec3 point(int patch, double u, double v)
{
    rl_vec3 position, normal;
    rl_teapot_evaluate(patch, u, v, &position, &normal);
    return position;
}

static rl_vec3 normal_at(int patch, double u, double v)
{
    rl_vec3 position, normal;
    rl_teapot_evaluate(patch, u, v, &position, &normal);
    return normal;
}

/* Central differences of step h are off by h^2 of the third derivative; cubics of this size leave 1e-8. */
static void test_finite_differences(void **state)
{
    (void)state;
    const double h = 1e-4;
    for (int patch = 0; patch < RL_TEAPOT_PATCHES; patch++)
        for (int i = 0; i <= 10; i++)
            for (int j = 0; j <= 10; j++) {
                double u = 0.01 + 0.098 * j, v = 0.01 + 0.098 * i;
                rl_vec3 along_u = v3_sub(point(patch, u + h, v), point(patch, u - h, v));
                rl_vec3 along_v = v3_sub(point(patch, u, v + h), point(patch, u, v - h));
                rl_vec3 expected = v3_normalize(v3_cross(along_v, along_u));
                check_near(v3_length(v3_sub(normal_at(patch, u, v), expected)), 0.0, 1e-5);
            }
}

static void test_unit_everywhere(void **state)
{
    (void)state;
    for (int patch = 0; patch < RL_TEAPOT_PATCHES; patch++)
        for (int i = 0; i <= 64; i++)
            for (int j = 0; j <= 64; j++)
                check_near(v3_length(normal_at(patch, j / 64.0, i / 64.0)), 1.0, 1e-12);
}

/* The tip is the highest point, and smooth: its normal is +y, and so is nearly that of any point close by. */
static void test_tip(void **state)
{
    (void)state;
    int at_tip = 0;
    for (int patch = 0; patch < RL_TEAPOT_PATCHES; patch++)
        for (int j = 0; j <= 8; j++) {
            rl_vec3 p = point(patch, j / 8.0, 0.0);
            if (hypot(p.x, p.z) > 1e-6 || p.y < 0.85)
                continue;
            at_tip++;
            check_near(normal_at(patch, j / 8.0, 0.0).y, 1.0, 1e-12);
            check_near(normal_at(patch, j / 8.0, 1e-4).y, 1.0, 1e-3);
        }
    assert_int_equal(at_tip, 4 * 9);
}

/* Outwards means away from the axis of the part: the pot's own is y; those of handle and spout run in the
 * plane z = 0, so that at least z tells. */
static void test_outwards(void **state)
{
    (void)state;
    for (int patch = 0; patch < RL_TEAPOT_PATCHES; patch++)
        for (int i = 1; i < 8; i++)
            for (int j = 1; j < 8; j++) {
                rl_vec3 p = point(patch, j / 8.0, i / 8.0), n = normal_at(patch, j / 8.0, i / 8.0);
                bool handle_or_spout = patch >= 12 && patch < 20, rim = patch < 4;
                bool lip = patch == 18 || patch == 19; /* the spout's end, where the surface turns inwards */
                if (rim)
                    assert_true(n.y > 0.0 || p.y < 0.674);
                else if (handle_or_spout && !lip)
                    assert_true(n.z * p.z > 0.0);
                else if (patch >= 4 && patch < 12)
                    assert_true(n.x * p.x + n.z * p.z > 0.0 || n.y < -0.99);
                else if (patch >= 24)
                    assert_true(n.y > 0.0);
            }
}

/* Two rows of patches meet smoothly: the body's two (4..7 above 8..11) and all round the pot. */
static void test_seams(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++)
        for (int j = 0; j <= 16; j++) {
            double t = j / 16.0;
            check_near(v3_length(v3_sub(point(4 + k, t, 1.0), point(8 + k, t, 0.0))), 0.0, 1e-12);
            check_near(v3_dot(normal_at(4 + k, t, 1.0), normal_at(8 + k, t, 0.0)), 1.0, 1e-6);
            int next = (k + 1) % 4;
            check_near(v3_length(v3_sub(point(4 + k, 1.0, t), point(4 + next, 0.0, t))), 0.0, 1e-12);
            check_near(v3_dot(normal_at(4 + k, 1.0, t), normal_at(4 + next, 0.0, t)), 1.0, 1e-6);
        }
}

/* Triangles turn the way their normals point, and the one with the tip twice is left out. */
static void test_triangles(void **state)
{
    (void)state;
    static const int levels[] = {1, 2, 16, 33};
    for (size_t k = 0; k < sizeof levels / sizeof levels[0]; k++) {
        size_t n = (size_t)levels[k];
        struct rl_mesh mesh;
        check_ok(rl_teapot_build(&mesh, levels[k], &error), &error);
        assert_int_equal(mesh.n_vertices, 28 * (n + 1) * (n + 1));
        assert_int_equal(mesh.n_triangles, (56 * n - 4) * n);
        for (size_t t = 0; t < mesh.n_triangles; t++) {
            rl_vec3 p[3], sum = v3(0.0, 0.0, 0.0);
            for (int i = 0; i < 3; i++) {
                const float *a = mesh.position[mesh.triangle[t][i]], *b = mesh.normal[mesh.triangle[t][i]];
                p[i] = v3(a[0], a[1], a[2]);
                sum = v3_add(sum, v3(b[0], b[1], b[2]));
            }
            rl_vec3 cross = v3_cross(v3_sub(p[1], p[0]), v3_sub(p[2], p[0]));
            /* At level 1 the corners of the spout's lip are in line. */
            assert_true(n == 1 || v3_length(cross) > 0.0);
            if (n >= 16)
                assert_true(v3_dot(v3_normalize(cross), v3_normalize(sum)) > 0.8);
        }
        rl_mesh_clear(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_finite_differences),
        cmocka_unit_test(test_unit_everywhere),
        cmocka_unit_test(test_tip),
        cmocka_unit_test(test_outwards),
        cmocka_unit_test(test_seams),
        cmocka_unit_test(test_triangles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
