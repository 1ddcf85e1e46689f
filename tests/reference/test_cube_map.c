/* Cube maps drawn on the CPU: solid angles, and what each texel sees. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "measure/sum.h"
#include "reference/cube_map.h"
#include "reference/fixture.h"
#include "reference/texel_edges.h"
#include "reference/texel_pole.h"
#include "reference/witness.h"
#include "support/check.h"

static void test_solid_angles(void **state)
{
    (void)state;
    static const int sizes[] = {1, 2, 3, 8, 37, 256, 512};
    for (size_t i = 0; i < LENGTH(sizes); i++) {
        int size = sizes[i];
        struct rl_sum sum = {0.0, 0.0};
        for (int y = 0; y < size; y++)
            for (int x = 0; x < size; x++)
                rl_sum_add(&sum, rl_cube_solid_angle((2 * x + 1.0) / size - 1.0, (2 * y + 1.0) / size - 1.0,
                                                     1.0 / size));
        check_relative(6.0 * rl_sum_value(&sum), 4.0 * RL_PI, 1e-14);
    }
    /* One texel against the difference of atan(s t/sqrt(1 + s^2 + t^2)) at its corners, where that is accurate; and the series. */
    for (int k = 0; k < 4; k++) {
        double s = 0.1 + 0.2 * k, t = -0.3 + 0.3 * k, half = 0.125, exact = 0.0;
        for (int c = 0; c < 4; c++) {
            double a = s + (c & 1 ? half : -half), b = t + (c & 2 ? half : -half);
            exact += (c == 0 || c == 3 ? 1.0 : -1.0) * atan(a * b / sqrt(1.0 + a * a + b * b));
        }
        check_relative(rl_cube_solid_angle(s, t, half), exact, 1e-14);
        check_relative(rl_texel_solid_angle(s, t, half), exact, 1e-3);
        check_relative(rl_texel_solid_angle(s, t, 1e-3), rl_cube_solid_angle(s, t, 1e-3), 1e-11);
    }
    /* No cancellation in the smallest. */
    double half = 0.5 / 4096;
    check_relative(rl_cube_solid_angle(0.25, -0.75, half),
                   4.0 * half * half * pow(1.0 + 0.0625 + 0.5625, -1.5), 1e-7);
}

static void test_faces(void **state)
{
    (void)state;
    struct dice d = dice_make(71);
    for (int i = 0; i < 200; i++) {
        int face = i % 6;
        double s = uniform(&d, -1.0, 1.0), t = uniform(&d, -1.0, 1.0);
        rl_vec3 v = rl_cube_on_face(face, v3_scale(3.0, rl_cube_direction(face, s, t)));
        check_near(v.x, 3.0 * s, 1e-15);
        check_near(v.y, 3.0 * t, 1e-15);
        check_near(v.z, 3.0, 1e-15);
    }
}

/* Every texel sees what a ray through its centre meets first, however the polygons lie: convex or not, behind, through the planes of the
 * faces, piercing one another. Ties within rounding may go either way. */
static void test_against_rays(void **state)
{
    (void)state;
    enum { LIGHTS = 3, SIZE = 20, CASES = 60 };
    static const double radiance[LIGHTS] = {1.0, 0.3, 0.6};
    struct dice d = dice_make(72);
    size_t wrong = 0, lit = 0;
    for (int i = 0; i < CASES; i++) {
        struct shape shapes[LIGHTS];
        rl_vec3 from = v3(uniform(&d, -1, 1), uniform(&d, -1, 1), uniform(&d, -1, 1));
        for (int k = 0; k < LIGHTS; k++) {
            rl_vec3 centre = v3_madd(from, uniform(&d, 0.2, 1.5), unit_vector(&d));
            size_t n = 3 + (size_t)uniform(&d, 0.0, 6.0);
            shapes[k] = polygon_about(&d, centre, n, 1.0, n % 2 ? 1.0 : 0.4, 0.4);
        }
        struct rl_light_set *set = lights_of(shapes, radiance, LIGHTS);
        struct rl_cube_map map;
        struct rl_error error;
        check_ok(rl_cube_map_make(&map, set, from, SIZE, &error), &error);
        for (int index = 0; index < 6 * SIZE * SIZE; index++) {
            double s = (2 * (index % SIZE) + 1.0) / SIZE - 1.0,
                   t = (2 * (index / SIZE % SIZE) + 1.0) / SIZE - 1.0;
            rl_vec3 L = rl_cube_direction(index / (SIZE * SIZE), s, t);
            double nearest = INFINITY;
            int first = 0;
            for (int k = 0; k < LIGHTS; k++) {
                double at = witness_hit(from, L, shapes[k].vertex, shapes[k].n);
                if (at > 0.0 && at < nearest) {
                    nearest = at;
                    first = k + 1;
                }
            }
            lit += first > 0;
            wrong += map.seen[index] != first;
        }
        rl_cube_map_clear(&map);
        rl_light_set_free(set);
    }
    print_message("%zu of %zu lit texels wrong\n", wrong, lit);
    assert_true(lit > 10000);
    assert_int_equal(wrong, 0);
}

/* Coverages and whole texels together have the polygon's solid angle, to the difference between a texel's area and its solid angle. */
static void test_coverage(void **state)
{
    (void)state;
    struct dice d = dice_make(73);
    for (int i = 0; i < 60; i++) {
        enum { SIZE = 64 };
        struct shape shape = polygon_about(&d, v3_scale(uniform(&d, 0.5, 1.5), unit_vector(&d)),
                                           3 + (size_t)i % 6, 0.9, i % 2 ? 0.9 : 0.5, 0.4);
        struct rl_light_set *set = set_of(&shape, 1);
        struct rl_cube_map map;
        struct rl_texel_edges edges;
        struct rl_error error;
        check_ok(rl_cube_map_make(&map, set, v3(0, 0, 0), SIZE, &error), &error);
        check_ok(rl_texel_edges_find(&edges, set, v3(0, 0, 0), SIZE, &error), &error);
        double covered = 0.0, exact = 0.0;
        for (int index = 0; index < 6 * SIZE * SIZE; index++)
            if (map.seen[index])
                covered += rl_cube_solid_angle((2 * (index % SIZE) + 1.0) / SIZE - 1.0,
                                               (2 * (index / SIZE % SIZE) + 1.0) / SIZE - 1.0, 1.0 / SIZE);
        for (size_t k = 0; k < edges.n; k++) {
            int index = (int)edges.edge[k].texel;
            assert_in_range(1e6 * edges.edge[k].coverage, 0, 1e6);
            covered += (edges.edge[k].coverage - map.seen[index]) *
                       rl_cube_solid_angle((2 * (index % SIZE) + 1.0) / SIZE - 1.0,
                                           (2 * (index / SIZE % SIZE) + 1.0) / SIZE - 1.0, 1.0 / SIZE);
        }
        /* The polygon's solid angle by triangles from its first vertex, signed (Van Oosterom and Strackee 1983). */
        for (size_t k = 1; k + 1 < shape.n; k++) {
            rl_vec3 a = v3_normalize(shape.vertex[0]), b = v3_normalize(shape.vertex[k]),
                    c = v3_normalize(shape.vertex[k + 1]);
            exact += 2.0 * atan2(v3_dot(a, v3_cross(b, c)), 1.0 + v3_dot(a, b) + v3_dot(b, c) + v3_dot(c, a));
        }
        check_near(covered, fabs(exact), 3e-4);
        rl_texel_edges_clear(&edges);
        rl_cube_map_clear(&map);
        rl_light_set_free(set);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_solid_angles),
        cmocka_unit_test(test_faces),
        cmocka_unit_test(test_against_rays),
        cmocka_unit_test(test_coverage),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
