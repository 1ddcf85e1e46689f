/* Polygons: what is refused and why, and that the triangles tile what is accepted. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "model/random.h"
#include "scene/scene.h"
#include "support/check.h"

static struct rl_error error;

/* Outlines in the plane, as x, y pairs. */
struct outline {
    const char *name;
    int n;
    double xy[2 * RL_POLYGON_VERTICES_MAX];
    double area;
};

static struct outline outlines[] = {
    {"triangle", 3, {0, 0, 2, 0, 0, 2}, 2.0},
    {"square", 4, {0, 0, 1, 0, 1, 1, 0, 1}, 1.0},
    {"square with points on its edges", 8, {0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1}, 4.0},
    {"L", 6, {0, 0, 3, 0, 3, 1, 1, 1, 1, 3, 0, 3}, 5.0},
    {"arrow head", 4, {0, 0, 2, -1, 0, 3, -2, -1}, 6.0},
    {"comb", 12, {0, 0, 5, 0, 5, 3, 4, 3, 4, 1, 3, 1, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3}, 11.0},
    {"spiral",
     16,
     {0, 0, 7, 0, 7, 7, 0, 7, 0, 2, 5, 2, 5, 5, 2, 5, 2, 4, 4, 4, 4, 3, 1, 3, 1, 6, 6, 6, 6, 1, 0, 1},
     0.0},
    {"needle", 3, {0, 0, 1, 0, 1, 1e-6}, 0.5e-6},
};

static const double *point(const double *xy, int i)
{
    return xy + (size_t)i * 2;
}

/* The shoelace formula, independent of the triangles. */
static double shoelace(const double *xy, int n)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        const double *a = point(xy, i), *b = point(xy, (i + 1) % n);
        sum += a[0] * b[1] - b[0] * a[1];
    }
    return 0.5 * sum;
}

/* Lays an outline into space: a turned plane at some distance, scaled; reversed where asked. */
static void place(rl_vec3 vertex[], const double *xy, int n, double scale, bool reversed)
{
    rl_vec3 a = v3_normalize(v3(0.6, 0.3, -0.2)), b = v3_normalize(v3_cross(a, v3(0.1, 1.0, 0.4)));
    for (int i = 0; i < n; i++) {
        const double *p = point(xy, reversed ? n - 1 - i : i);
        vertex[i] = v3_scale(scale, v3_madd(v3_madd(v3(3.0, -4.0, 5.0), p[0], a), p[1], b));
    }
}

static double triangle_area(const struct rl_polygon *p, int t, double *signed_area)
{
    rl_vec3 a = p->vertex[p->triangle[t][0]], b = p->vertex[p->triangle[t][1]],
            c = p->vertex[p->triangle[t][2]];
    rl_vec3 cross = v3_cross(v3_sub(b, a), v3_sub(c, a));
    *signed_area += 0.5 * v3_dot(cross, p->normal);
    return 0.5 * v3_length(cross);
}

/* n - 2 triangles, each turning with the polygon, whose areas sum to the polygon's: with the sum of signed
 * areas alone, overlaps and gaps could cancel. */
static void check_tiles(const struct rl_polygon *p, double area, const char *name)
{
    double sum = 0.0, signed_sum = 0.0;
    for (int t = 0; t < p->n - 2; t++) {
        for (int i = 0; i < 3; i++)
            assert_in_range(p->triangle[t][i], 0, p->n - 1);
        sum += triangle_area(p, t, &signed_sum);
    }
    if (fabs(sum - area) > 1e-9 * area || fabs(signed_sum - area) > 1e-9 * area)
        print_error("%s: triangles %.15g, signed %.15g\n", name, sum, signed_sum);
    check_relative(sum, area, 1e-9);
    check_relative(signed_sum, area, 1e-9);
    check_relative(p->area, area, 1e-9);
    check_near(v3_length(p->normal), 1.0, 1e-12);
}

static void test_tiles(void **state)
{
    (void)state;
    static const double scales[] = {1.0, 1e-6, 1e6};
    for (size_t i = 0; i < sizeof outlines / sizeof outlines[0]; i++) {
        const struct outline *o = &outlines[i];
        double area = fabs(shoelace(o->xy, o->n));
        if (o->area > 0.0)
            check_relative(area, o->area, 1e-12);
        for (int k = 0; k < 6; k++) {
            double scale = scales[k / 2];
            rl_vec3 vertex[RL_POLYGON_VERTICES_MAX];
            place(vertex, o->xy, o->n, scale, k % 2);
            struct rl_polygon p;
            check_ok(rl_polygon_make(&p, vertex, o->n, &error), &error);
            check_tiles(&p, area * scale * scale, o->name);
            rl_polygon_clear(&p);
        }
    }
}

/* Star-shaped outlines of every size with random radii: always simple. */
static void test_random_stars(void **state)
{
    (void)state;
    const uint64_t seed = 7;
    print_message("seed %llu\n", (unsigned long long)seed);
    uint64_t next = 0;
    for (int n = 3; n <= RL_POLYGON_VERTICES_MAX; n++)
        for (int repeat = 0; repeat < 20; repeat++) {
            double xy[2 * RL_POLYGON_VERTICES_MAX], *next_xy = xy;
            for (int i = 0; i < n; i++) {
                double angle = 2.0 * RL_PI * (i + 0.8 * rl_random_uniform(seed, next++)) / n;
                double radius = 0.05 + rl_random_uniform(seed, next++);
                *next_xy++ = radius * cos(angle);
                *next_xy++ = radius * sin(angle);
            }
            rl_vec3 vertex[RL_POLYGON_VERTICES_MAX];
            place(vertex, xy, n, 1.0, repeat % 2);
            double area = shoelace(xy, n);
            if (area < 1e-3) /* three points of a triangle may lie on one side of the centre */
                continue;
            struct rl_polygon p;
            check_ok(rl_polygon_make(&p, vertex, n, &error), &error);
            check_tiles(&p, area, "random star");
            rl_polygon_clear(&p);
        }
}

static void test_refused(void **state)
{
    (void)state;
    static const struct {
        const char *words;
        int n;
        double xyz[5][3];
    } cases[] = {
        {"found 2 vertices, expected 3 to 64", 2, {{0, 0, 0}, {1, 0, 0}}},
        {"found 0 vertices", 0, {{0}}},
        {"found vertex 1 (nan, 0, 0), expected finite", 3, {{0, 0, 0}, {NAN, 0, 0}, {0, 1, 0}}},
        {"expected finite", 3, {{0, 0, 0}, {1, 0, INFINITY}, {0, 1, 0}}},
        {"zero area", 3, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}},
        {"zero area", 3, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}},
        {"crossing itself", 4, {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}},
        {"zero area", 4, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}}},
        {"off the polygon's plane by 0.204, expected a planar",
         4,
         {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}},
        {"edges 0 and 2", 4, {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 3, 0}}},
        {"vertex 1 at the same place as vertex 0", 4, {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
        {"edges at vertex 1 on top of each other", 4, {{0, 0, 0}, {3, 0, 0}, {2, 0, 0}, {0, 1, 0}}},
        {"meeting", 5, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0, 0}, {0, 2, 0}}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        rl_vec3 vertex[5];
        for (int k = 0; k < 5; k++)
            vertex[k] = v3(cases[i].xyz[k][0], cases[i].xyz[k][1], cases[i].xyz[k][2]);
        struct rl_polygon p;
        int status = rl_polygon_make(&p, vertex, cases[i].n, &error);
        check_fails(status, &error, RL_ERR_INPUT, cases[i].words);
        assert_null(p.vertex);
        assert_null(p.triangle);
    }
}

/* A vertex 1e-7 of the size off the plane is rounding, 1e-5 is not. */
static void test_planarity_bound(void **state)
{
    (void)state;
    static const struct {
        double off;
        bool planar;
    } cases[] = {{1e-7, true}, {1e-5, false}};
    static const double scales[] = {1.0, 1e-4, 1e5};
    for (size_t i = 0; i < 2; i++)
        for (size_t k = 0; k < 3; k++) {
            double s = scales[k];
            const rl_vec3 vertex[4] = {v3(0, 0, 0), v3(s, 0, 0), v3(s, s, cases[i].off * s), v3(0, s, 0)};
            struct rl_polygon p;
            int status = rl_polygon_make(&p, vertex, 4, &error);
            assert_int_equal(status == RL_OK, cases[i].planar);
            rl_polygon_clear(&p);
        }
}

static void test_counts(void **state)
{
    (void)state;
    rl_vec3 vertex[RL_POLYGON_VERTICES_MAX + 1];
    for (int n = RL_POLYGON_VERTICES_MAX; n <= RL_POLYGON_VERTICES_MAX + 1; n++) {
        for (int i = 0; i < n; i++)
            vertex[i] = v3(cos(2.0 * RL_PI * i / n), sin(2.0 * RL_PI * i / n), 0.0);
        struct rl_polygon p;
        int status = rl_polygon_make(&p, vertex, n, &error);
        if (n <= RL_POLYGON_VERTICES_MAX) {
            check_ok(status, &error);
            check_near(p.normal.z, 1.0, 1e-12);
        } else {
            check_fails(status, &error, RL_ERR_INPUT, "found 65 vertices");
        }
        rl_polygon_clear(&p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tiles),   cmocka_unit_test(test_random_stars),
        cmocka_unit_test(test_refused), cmocka_unit_test(test_planarity_bound),
        cmocka_unit_test(test_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
