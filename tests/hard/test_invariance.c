/* What must not change the integral at a point, by every integrator: the unit of length (no bit, for nothing is absolute), the direction of the
 * axes, the order of the lights, and where a light is cut in two. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include <float.h>
#include <string.h>

#include "model/frame.h"
#include "reference/fixture.h"
#include "reference/integrators.h"
#include "support/check.h"

enum { POINTS = 300, LIGHTS = 4 };

struct question {
    struct rl_surface s;
    double rr;
    bool attenuation;
    size_t n;
    struct shape light[2 * LIGHTS];
};

/* Lights between 1e-2 and 1e2 units away, of sizes to match, some of them through the surface's plane. */
static struct question ask(struct dice *d)
{
    struct question q = {.s = surface_point(d, 0.02), .n = LIGHTS};
    q.rr = exp(uniform(d, log(0.5), log(300.0)));
    q.attenuation = uniform(d, 0.0, 1.0) < 0.7;
    for (size_t i = 0; i < q.n; i++) {
        double distance = exp(uniform(d, log(0.01), log(100.0))), size = distance * uniform(d, 0.05, 0.8);
        rl_vec3 towards = i == 0 ? v3_reflect(q.s.V, q.s.N) : unit_vector(d);
        size_t n = 3 + (size_t)uniform(d, 0.0, 4.0);
        q.light[i] = polygon_about(d, v3_madd(q.s.P, distance, towards), n, size, size, 0.0);
    }
    return q;
}

static struct rl_estimate answer(const struct question *q, const struct rl_integrator *it, double tolerance)
{
    struct rl_error error;
    struct rl_light_set *set;
    struct rl_estimate estimate;
    const rl_vec3 *vertices[2 * LIGHTS];
    size_t n_vertices[2 * LIGHTS];
    for (size_t i = 0; i < q->n; i++) {
        vertices[i] = q->light[i].vertex;
        n_vertices[i] = q->light[i].n;
    }
    const struct rl_ellipsoid e = rl_ellipsoid_make(q->rr);
    const struct rl_integrate_options options = {.attenuation = q->attenuation,
                                                 .tolerance = tolerance,
                                                 .max_evaluations = 20000,
                                                 .simd = rl_simd_best(),
                                                 .seed = 1,
                                                 .env_size = 32};
    check_ok(rl_light_set_from_polygons(&set, vertices, n_vertices, q->n, &error), &error);
    check_ok(it->integrate(&estimate, &q->s, &e, set, &options, &error), &error);
    rl_light_set_free(set);
    return estimate;
}

static struct question scaled(const struct question *q, int power)
{
    struct question to = *q;
    double unit = ldexp(1.0, power);
    to.s.P = v3_scale(unit, q->s.P);
    for (size_t i = 0; i < q->n; i++)
        for (size_t k = 0; k < q->light[i].n; k++)
            to.light[i].vertex[k] = v3_scale(unit, q->light[i].vertex[k]);
    return to;
}

static void test_unit(void **state)
{
    (void)state;
    static const int power[] = {1, -1, 10, -20, 20, -60, 60};
    struct dice d = dice_make(20261130);
    for (size_t k = 0; k < rl_n_integrators; k++) {
        const struct rl_integrator *it = rl_integrators[k];
        int points = it == rl_integrator_find("reference") ? POINTS : 10;
        for (int i = 0; i < points; i++) {
            struct question q = ask(&d);
            struct rl_estimate here = answer(&q, it, 1e-6);
            assert_true(isfinite(here.value[0]) && isfinite(here.error[0]));
            for (size_t p = 0; p < LENGTH(power); p++) {
                struct question other = scaled(&q, power[p]);
                struct rl_estimate there = answer(&other, it, 1e-6);
                if (there.value[0] != here.value[0] || there.error[0] != here.error[0])
                    fail_msg("%s, point %d, lengths times 2^%d: %.17g +- %.3g, expected %.17g +- %.3g",
                             it->name, i, power[p], there.value[0], there.error[0], here.value[0],
                             here.error[0]);
            }
        }
        print_message("%-12s %d points, %zu scales: the same bits\n", it->name, points, LENGTH(power));
    }
}

static rl_vec3 turned(const struct rl_frame *f, rl_vec3 a)
{
    return rl_frame_components(f, a);
}

/* Rounding turns every direction by some ulps, P's and the vertices' by as many of their distance from the origin over the light's from P; the
 * lobe is 1/R wide. */
static void test_rotation(void **state)
{
    (void)state;
    const struct rl_integrator *it = rl_integrator_find("reference");
    struct dice d = dice_make(20261131);
    double worst = 0.0;
    for (int i = 0; i < POINTS; i++) {
        struct question q = ask(&d), other = q;
        struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, unit_vector(&d));
        double nearest = INFINITY, farthest = v3_length(q.s.P);
        other.s = (struct rl_surface){turned(&f, q.s.P), turned(&f, q.s.N), turned(&f, q.s.V)};
        for (size_t l = 0; l < q.n; l++)
            for (size_t k = 0; k < q.light[l].n; k++) {
                other.light[l].vertex[k] = turned(&f, q.light[l].vertex[k]);
                nearest = fmin(nearest, v3_length(v3_sub(q.light[l].vertex[k], q.s.P)));
            }
        struct rl_estimate here = answer(&q, it, 1e-12), there = answer(&other, it, 1e-12);
        double angle = 16.0 * DBL_EPSILON * (1.0 + farthest / nearest);
        double off = fabs(here.value[0] - there.value[0]);
        double allowed = here.error[0] + there.error[0] + fmax(1.0, q.rr) * angle;
        worst = fmax(worst, off / allowed);
        if (!(off <= allowed))
            fail_msg("point %d: turned by %.3g, expected at most %.3g", i, off, allowed);
    }
    print_message("farthest: %.2g of what is allowed\n", worst);
}

/* In the order of the last first. */
static void test_order(void **state)
{
    (void)state;
    const struct rl_integrator *it = rl_integrator_find("reference");
    struct dice d = dice_make(20261132);
    size_t same = 0;
    double worst = 0.0;
    for (int i = 0; i < POINTS; i++) {
        struct question q = ask(&d), other = q;
        for (size_t l = 0; l < q.n; l++)
            other.light[l] = q.light[q.n - 1 - l];
        struct rl_estimate here = answer(&q, it, 1e-12), there = answer(&other, it, 1e-12);
        double off = fabs(here.value[0] - there.value[0]);
        same += off == 0.0;
        worst = fmax(worst, off);
        assert_true(off <= here.error[0] + there.error[0] + 16.0 * DBL_EPSILON);
    }
    print_message("%zu of %d the same bits, farthest %.2g\n", same, POINTS, worst);
}

/* Each light cut from one vertex to the middle of an edge, or a triangle's. */
static struct question cut(const struct question *q)
{
    struct question to = *q;
    to.n = 2 * q->n;
    for (size_t i = 0; i < q->n; i++) {
        const struct shape *whole = &q->light[i];
        size_t n = whole->n, last = n / 2;
        rl_vec3 middle = v3_scale(0.5, v3_add(whole->vertex[last], whole->vertex[last + 1]));
        struct shape *a = &to.light[2 * i], *b = &to.light[2 * i + 1];
        *a = (struct shape){.n = last + 2};
        memcpy(a->vertex, whole->vertex, (last + 1) * sizeof *a->vertex);
        a->vertex[last + 1] = middle;
        *b = (struct shape){.n = n - last + 1};
        b->vertex[0] = whole->vertex[0];
        b->vertex[1] = middle;
        memcpy(b->vertex + 2, whole->vertex + last + 1, (n - last - 1) * sizeof *b->vertex);
    }
    return to;
}

/* Both at the tolerance: what a cut moves is the vertex at its end, by rounding. */
static void test_halves(void **state)
{
    (void)state;
    static const double tolerance[] = {1e-4, 1e-8, 1e-11};
    const struct rl_integrator *it = rl_integrator_find("reference");
    struct dice d = dice_make(20261133);
    for (size_t k = 0; k < LENGTH(tolerance); k++) {
        double worst = 0.0;
        for (int i = 0; i < POINTS; i++) {
            struct question q = ask(&d), halves = cut(&q);
            struct rl_estimate here = answer(&q, it, tolerance[k]), there = answer(&halves, it, tolerance[k]);
            double off = fabs(here.value[0] - there.value[0]);
            worst = fmax(worst, off);
            if (!(off <= here.error[0] + there.error[0] + 1e-12))
                fail_msg("point %d at %g: %.17g +- %.2g, in halves %.17g +- %.2g", i, tolerance[k],
                         here.value[0], here.error[0], there.value[0], there.error[0]);
            assert_true(off <= 2.0 * tolerance[k]);
        }
        print_message("tolerance %g: farthest %.2g\n", tolerance[k], worst);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_unit),
        cmocka_unit_test(test_rotation),
        cmocka_unit_test(test_order),
        cmocka_unit_test(test_halves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
