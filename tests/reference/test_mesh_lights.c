/* Meshes as lights: the visible surface counts once, however it folds, and only its outline is looked at. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "reference/rule.h"
#include "reference/view.h"
#include "reference/witness.h"
#include "support/check.h"

enum { ROWS = 8, TRIANGLES = 2 * ROWS * 2 * (ROWS - 1) };

struct mesh {
    rl_vec3 corner[TRIANGLES][3];
};

static rl_vec3 on_blob(rl_vec3 centre, double size, double bumps, int row, int column)
{
    double polar = RL_PI * row / ROWS, azimuth = RL_PI * (column % (2 * ROWS)) / ROWS;
    double s = row == 0 || row == ROWS ? 0.0 : sin(polar);
    double r = size * (1.0 + bumps * sin(3.0 * azimuth) * s);
    return v3_add(centre, v3(r * s * cos(azimuth), r * s * sin(azimuth), r * cos(polar)));
}

/* A sphere of triangles, closed, with three bumps round it: folds over itself from most sides. */
static void make_blob(struct mesh *mesh, rl_vec3 centre, double size, double bumps)
{
    size_t n = 0;
    for (int i = 0; i < ROWS; i++)
        for (int j = 0; j < 2 * ROWS; j++) {
            rl_vec3 a = on_blob(centre, size, bumps, i, j), b = on_blob(centre, size, bumps, i, j + 1);
            rl_vec3 c = on_blob(centre, size, bumps, i + 1, j + 1),
                    d = on_blob(centre, size, bumps, i + 1, j);
            if (i > 0) {
                mesh->corner[n][0] = a;
                mesh->corner[n][1] = b;
                mesh->corner[n++][2] = c;
            }
            if (i < ROWS - 1) {
                mesh->corner[n][0] = a;
                mesh->corner[n][1] = c;
                mesh->corner[n++][2] = d;
            }
        }
    assert_int_equal(n, TRIANGLES);
}

/* As one light; and, if `apart`, beside one of another radiance far below, so that nothing can be merged. */
static struct rl_light_set *set_of_mesh(struct mesh *mesh, bool apart)
{
    static struct rl_polygon polygon[TRIANGLES];
    static rl_vec3 below[3];
    struct rl_polygon far = {.n = 3, .vertex = below};
    for (size_t i = 0; i < TRIANGLES; i++)
        polygon[i] = (struct rl_polygon){.n = 3, .vertex = mesh->corner[i]};
    for (int i = 0; i < 3; i++)
        below[i] = v3(i == 1, i == 2, -100.0);
    const struct rl_light light[2] = {
        {.n_polygons = TRIANGLES, .polygon = polygon, .radiance = {1.0, 1.0, 1.0}},
        {.n_polygons = 1, .polygon = &far, .radiance = {0.5, 0.5, 0.5}},
    };
    struct rl_light_set *set = NULL;
    struct rl_error error;
    check_ok(rl_light_set_make(&set, light, apart ? 2 : 1, &error), &error);
    assert_true((set->twin != NULL) == !apart);
    return set;
}

/* The outline gives what all triangles one by one give, and what a dense sum says. */
static void test_outline(void **state)
{
    (void)state;
    static const double bumps[] = {0.0, 0.3, 0.6};
    struct dice d = dice_make(71);
    for (int i = 0; i < 30; i++) {
        static struct mesh mesh;
        struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 0)};
        s.V = v3_normalize(v3(uniform(&d, -1, 1), uniform(&d, -1, 1), uniform(&d, 0.1, 1)));
        rl_vec3 mirror = v3_reflect(s.V, s.N);
        make_blob(&mesh, v3_madd(v3_scale(2.0, mirror), 0.5, unit_vector(&d)), 0.5, bumps[i % 3]);
        struct rl_light_set *merged = set_of_mesh(&mesh, false), *apart = set_of_mesh(&mesh, true);
        double rr = pow(10.0, uniform(&d, 0.0, 2.0));
        bool attenuation = i % 4;
        struct rl_estimate a = integrate(&s, rr, merged, attenuation, 1e-10);
        assert_true(a.converged);
        if (attenuation) { /* else the far light counts */
            struct rl_estimate b = integrate(&s, rr, apart, true, 1e-10);
            check_near(a.value[0], b.value[0], a.error[0] + b.error[0]);
            assert_true(2 * a.evaluations < b.evaluations);
        }
        if (i < 4) {
            const rl_vec3 *vertices[TRIANGLES];
            size_t n_vertices[TRIANGLES];
            double radiance[TRIANGLES];
            for (size_t k = 0; k < TRIANGLES; k++) {
                vertices[k] = mesh.corner[k];
                n_vertices[k] = 3;
                radiance[k] = 1.0;
            }
            check_near(a.value[0],
                       witness_dense(&s, rr, RL_FRAME_ORTHONORMAL, vertices, n_vertices, radiance, TRIANGLES,
                                     attenuation, 100),
                       4e-3);
        }
        rl_light_set_free(merged);
        rl_light_set_free(apart);
    }
}

/* Two meshes of one radiance, one behind the other: what they cover together. */
static void test_one_behind_the_other(void **state)
{
    (void)state;
    static struct mesh near, both[2];
    struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3_normalize(v3(0.2, 0.1, 1.0))};
    make_blob(&near, v3(0.1, 0.0, 2.0), 0.5, 0.0);
    both[0] = near;
    make_blob(&both[1], v3(0.2, 0.0, 40.0), 0.5, 0.0);
    struct rl_polygon polygon[2 * TRIANGLES];
    for (size_t i = 0; i < LENGTH(polygon); i++)
        polygon[i] = (struct rl_polygon){.n = 3, .vertex = both[i / TRIANGLES].corner[i % TRIANGLES]};
    const struct rl_light light = {
        .n_polygons = LENGTH(polygon), .polygon = polygon, .radiance = {1.0, 1.0, 1.0}};
    struct rl_light_set *set = NULL, *alone = set_of_mesh(&near, false);
    struct rl_error error;
    check_ok(rl_light_set_make(&set, &light, 1, &error), &error);
    struct rl_estimate r = integrate(&s, 10.0, set, true, 1e-11), a = integrate(&s, 10.0, alone, true, 1e-11);
    check_near(r.value[0], a.value[0], 1e-11);
    rl_light_set_free(set);
    rl_light_set_free(alone);
}

/* Inside a closed mesh there is no outline at all: a furnace. */
static void test_inside(void **state)
{
    (void)state;
    static struct mesh mesh;
    struct dice d = dice_make(72);
    make_blob(&mesh, v3(0.05, 0.0, 0.1), 1.0, 0.2);
    struct rl_light_set *set = set_of_mesh(&mesh, false);
    for (int i = 0; i < 20; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        s.P = v3(0, 0, 0);
        struct rl_estimate r = integrate(&s, pow(10.0, uniform(&d, 0.0, 2.0)), set, false, 1e-10);
        check_near(r.value[0], 1.0, 1e-14);
        assert_true(r.evaluations <= RL_RULE_NODES);
    }
    rl_light_set_free(set);
}

/* What the cost follows: the outline, not the triangles, nor 1/tolerance^2. */
static void test_cost(void **state)
{
    (void)state;
    struct dice d = dice_make(73);
    double lines[3] = {0.0};
    static const size_t edges[] = {4, 8, 16};
    for (int i = 0; i < 60; i++) {
        struct rl_surface s = surface_point(&d, 0.3);
        rl_vec3 centre = near_mirror(&d, &s, 0.5);
        for (size_t j = 0; j < LENGTH(edges); j++) {
            struct shape shape = polygon_about(&d, centre, edges[j], 0.6, 0.6, 0.0);
            struct rl_light_set *set = set_of(&shape, 1);
            struct rl_estimate loose = integrate(&s, 30.0, set, true, 1e-4),
                               tight = integrate(&s, 30.0, set, true, 1e-10);
            assert_true(tight.evaluations < 20 * loose.evaluations);
            lines[j] += (double)tight.evaluations / 60.0;
            rl_light_set_free(set);
        }
    }
    print_message("lines at 1e-10: %.0f for 4 edges, %.0f for 8, %.0f for 16\n", lines[0], lines[1],
                  lines[2]);
    assert_true(lines[1] < 2.4 * lines[0] && lines[2] < 2.4 * lines[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_outline),
        cmocka_unit_test(test_one_behind_the_other),
        cmocka_unit_test(test_inside),
        cmocka_unit_test(test_cost),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
