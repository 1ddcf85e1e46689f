/* One line: its integral over delta against a dense sum, for every kind of light; and that lines break only where it is said. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "reference/breaks.h"
#include "reference/view.h"
#include "reference/witness.h"
#include "support/check.h"

/* Midpoints in U along the line, a ray for each. */
static double dense_line(const struct view *v, double theta, const struct shape *shapes,
                         const double *radiance, size_t n_shapes)
{
    enum { STEPS = 4000 };
    struct rl_frame frame = rl_frame_make(RL_FRAME_ORTHONORMAL, v->s.N);
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++) {
        struct rl_delta d = rl_ellipsoid_inverse(&v->e, (i + 0.5) / STEPS);
        rl_vec3 H = rl_frame_microfacet_normal(&frame, d.sin_delta, d.cos_delta, theta);
        double v_h = v3_dot(v->s.V, H);
        rl_vec3 L = v3_sub(v3_scale(2.0 * v_h, H), v->s.V);
        double nearest = INFINITY, seen = 0.0;
        for (size_t j = 0; j < n_shapes; j++) {
            double t = witness_hit(v->s.P, L, shapes[j].vertex, shapes[j].n);
            if (t > 0.0 && t < nearest) {
                nearest = t;
                seen = radiance ? radiance[j] : 1.0;
            }
        }
        double n_v = v3_dot(v->s.N, v->s.V);
        sum +=
            seen * (v->options.attenuation ? rl_attenuation(d.cos_delta, n_v, v3_dot(v->s.N, L), v_h) : 1.0);
    }
    return sum / STEPS;
}

/* Every jump of the summand costs at most half a step. */
static void check_lines(const struct view *v, const struct shape *shapes, const double *radiance, size_t n)
{
    for (int i = 0; i < 11; i++) {
        double theta = 0.1 + 0.3 * i;
        double value[4];
        bool some = rl_lines_integrate(value, &v->lines, theta);
        double dense = dense_line(v, theta, shapes, radiance, n);
        check_near(value[0], dense, 2e-3);
        assert_true(some || value[0] == 0.0);
        assert_true(value[3] >= 0.0 && value[3] < 1e-12);
    }
}

static void test_single_lights(void **state)
{
    (void)state;
    struct dice d = dice_make(21);
    for (int i = 0; i < 60; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        struct shape shape = random_light(&d, &s);
        struct view v;
        view_make(&v, s, pow(10.0, uniform(&d, -0.3, 2.0)), &shape, NULL, 1, i % 2);
        check_lines(&v, &shape, NULL, 1);
        view_clear(&v);
    }
}

/* Two to four lights of different radiance, many of which hide or pierce one another. */
static void test_overlapping_lights(void **state)
{
    (void)state;
    static const double radiance[] = {1.0, 0.25, 0.6, 0.1};
    struct dice d = dice_make(22);
    for (int i = 0; i < 60; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        rl_vec3 centre = near_mirror(&d, &s, 0.4);
        struct shape shapes[4];
        size_t n = 2 + (size_t)i % 3;
        for (size_t j = 0; j < n; j++)
            shapes[j] = polygon_about(&d, v3_madd(centre, 0.4, unit_vector(&d)), 3 + j, 0.9, 0.9, 0.3);
        struct view v;
        view_make(&v, s, pow(10.0, uniform(&d, -0.3, 1.5)), shapes, radiance, n, i % 2);
        check_lines(&v, shapes, radiance, n);
        view_clear(&v);
    }
}

/* Two quads crossing in the middle of the view, each nearer on one side. */
static void test_piercing_lights(void **state)
{
    (void)state;
    static const double radiance[] = {1.0, 0.5};
    const struct shape shapes[2] = {
        {4, {{-1, -1, 1.5}, {1, -1, 2.5}, {1, 1, 2.5}, {-1, 1, 1.5}}},
        {4, {{-1, -1, 2.5}, {1, -1, 1.5}, {1, 1, 1.5}, {-1, 1, 2.5}}},
    };
    struct view v;
    view_make(&v, (struct rl_surface){v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 1)}, 5.0, shapes, radiance, 2,
              false);
    double value[4];
    rl_lines_integrate(value, &v.lines, 0.0);
    /* On this line the edges are seen at tan(2 delta) = +-1/1.5, and halfway, at delta = 0, they swap. */
    double half = rl_ellipsoid_cdf(&v.e, 0.5 * atan(1.0 / 1.5)) - 0.5;
    check_near(value[0], half * (1.0 + 0.5), 1e-14);
    check_lines(&v, shapes, radiance, 2);
    view_clear(&v);
}

/* What needs no dense sum to be known. */
static void test_degenerate(void **state)
{
    (void)state;
    const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 1)};
    static const struct {
        const char *name;
        struct shape shape;
        double expected; /* at theta = 0, R = 1, attenuation off: U = (1 + sin delta)/2 */
    } table[] = {
        {"in the light's plane", {3, {{1, -1, 0}, {2, -1, 0}, {2, 1, 0}}}, 0.0},
        {"on the light", {4, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}, 0.0},
        {"seen edge-on", {4, {{1, -1, 1}, {1, 1, 1}, {2, 2, 2}, {2, -2, 2}}}, 0.0},
        {"overhead",
         {4, {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}},
         0.38268343236508977}, /* sin(pi/8) */
        {"below", {4, {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}}}, 1.0 - 0.92387953251128674},
        {"half overhead, an edge through the mirror direction",
         {4, {{0, -1, 1}, {1, -1, 1}, {1, 1, 1}, {0, 1, 1}}},
         0.19134171618254489},
        {"a vertex in the mirror direction", {3, {{0, 0, 1}, {1, -1, 1}, {1, 1, 1}}}, 0.19134171618254489},
        {"a repeated vertex",
         {5, {{-1, -1, 1}, {1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}},
         0.38268343236508977},
    };
    for (size_t i = 0; i < LENGTH(table); i++) {
        struct view v;
        view_make(&v, s, 1.0, &table[i].shape, NULL, 1, false);
        double value[4];
        rl_lines_integrate(value, &v.lines, 0.0);
        print_message("%s\n", table[i].name);
        check_near(value[0], table[i].expected, 1e-14);
        view_clear(&v);
    }
}

/* The light cut at the horizon by hand gives the same lines, whether it sticks out below in one part or in two. */
static void test_horizon(void **state)
{
    (void)state;
    const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3(-0.6, 0, 0.8)};
    const struct shape whole[2] = {
        {4, {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}}},
        {7, {{1, -1, -1}, {1, -0.5, -1}, {1, 0, 0.5}, {1, 0.5, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}}},
    };
    const struct shape cut[2] = {
        {4, {{1, -1, 0}, {1, 1, 0}, {1, 1, 1}, {1, -1, 1}}},
        {7, {{1, -1, 0}, {1, -1.0 / 6, 0}, {1, 0, 0.5}, {1, 1.0 / 6, 0}, {1, 1, 0}, {1, 1, 1}, {1, -1, 1}}},
    };
    for (int i = 0; i < 2; i++) {
        struct view a, b;
        view_make(&a, s, 4.0, &whole[i], NULL, 1, true);
        view_make(&b, s, 4.0, &cut[i], NULL, 1, true);
        for (int j = 0; j < 300; j++) {
            double theta = 0.01 * j;
            double x[4], y[4];
            rl_lines_integrate(x, &a.lines, theta);
            rl_lines_integrate(y, &b.lines, theta);
            check_near(x[0], y[0], 1e-14);
        }
        check_lines(&a, &whole[i], NULL, 1);
        view_clear(&a);
        view_clear(&b);
    }
}

static int ascending(const void *a, const void *b)
{
    double x = ((const struct rl_break *)a)->theta, y = ((const struct rl_break *)b)->theta;
    return (x > y) - (x < y);
}

/* Between two breaks the integral is smooth: a polynomial through Chebyshev points predicts it in between. An end where the circle
 * touches an edge is a square root, so its panel is mapped. */
static void test_breaks(void **state)
{
    (void)state;
    enum { POINTS = 30 };
    struct dice d = dice_make(23);
    size_t smooth = 0, all = 0;
    for (int i = 0; i < 100; i++) {
        struct rl_surface s = surface_point(&d, 0.1);
        struct shape shape[2] = {random_light(&d, &s), random_light(&d, &s)};
        static const double radiance[] = {1.0, 0.4};
        struct view v;
        view_make(&v, s, pow(10.0, uniform(&d, 0.0, 0.7)), shape, radiance, i < 70 ? 1 : 2, i % 2);
        struct rl_break *breaks = malloc((rl_breaks_most(v.set) + 1) * sizeof *breaks);
        bool complete;
        size_t n = rl_breaks_find(breaks, &complete, &v.lines);
        assert_true(complete);
        assert_true(n <= rl_breaks_most(v.set));
        qsort(breaks, n, sizeof *breaks, ascending);
        for (size_t j = 0; j + 1 < n; j++) {
            double a = breaks[j].theta, w = breaks[j + 1].theta - a, f[POINTS][4], between[4];
            if (w < 1e-3 || breaks[j].kind != RL_BREAK_KINK || breaks[j + 1].kind != RL_BREAK_KINK)
                continue;
            /* Barycentric interpolation at x = 0.37 (Berrut and Trefethen 2004). */
            double top = 0.0, bottom = 0.0;
            for (int k = 0; k < POINTS; k++) {
                double angle = RL_PI * (k + 0.5) / POINTS, x = 0.5 - 0.5 * cos(angle);
                rl_lines_integrate(f[k], &v.lines, a + w * x);
                double weight = (k % 2 ? -1.0 : 1.0) * sin(angle) / (0.37 - x);
                top += weight * f[k][0];
                bottom += weight;
            }
            rl_lines_integrate(between, &v.lines, a + 0.37 * w);
            all++;
            smooth += fabs(top / bottom - between[0]) < 1e-6;
        }
        free(breaks);
        view_clear(&v);
    }
    print_message("%zu of %zu panels are smooth\n", smooth, all);
    assert_true(all > 300 && smooth >= all * 99 / 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_single_lights),   cmocka_unit_test(test_overlapping_lights),
        cmocka_unit_test(test_piercing_lights), cmocka_unit_test(test_degenerate),
        cmocka_unit_test(test_horizon),         cmocka_unit_test(test_breaks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
