/* The reference and its two independent witnesses on random configurations: all agree within their stated errors.
 *
 * cubature must agree every time. montecarlo's errors are half widths of intervals that fail with a known probability: that none of
 * them fails is asked for at the level that Sidak's correction gives (1 - FALSE_ALARM for all together), and at 99 % the number that
 * fail must be one that a binomial law allows.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <gsl/gsl_cdf.h>
#include <cmocka.h>

#include "reference/fixture.h"
#include "reference/integrators.h"
#include "support/check.h"

enum { CASES = 240, LIGHTS_MOST = 2 };
#define FALSE_ALARM 1e-6

/* One question. Of every eight: four of a single light, one each of two lights that overlap, a light on the horizon, P in the light's
 * plane, the printed frame. One in four is unattenuated. */
struct question {
    struct rl_surface surface;
    struct rl_ellipsoid e;
    struct rl_light_set *set;
    struct rl_integrate_options options;
};

static struct shape any_light(struct dice *d, rl_vec3 centre)
{
    size_t n = 3 + (size_t)uniform(d, 0.0, 8.0);
    double radius = uniform(d, 0.1, 1.1);
    return polygon_about(d, centre, n, n % 2 ? radius : radius * uniform(d, 0.3, 1.0), radius,
                         n < 5 ? 0.4 : 0.2);
}

/* Moves the polygon along its normal until P lies in its plane. */
static void level_with(struct shape *shape, rl_vec3 P)
{
    rl_vec3 normal = v3_normalize(
        v3_cross(v3_sub(shape->vertex[1], shape->vertex[0]), v3_sub(shape->vertex[2], shape->vertex[0])));
    double off = v3_dot(normal, v3_sub(P, shape->vertex[0]));
    for (size_t i = 0; i < shape->n; i++)
        shape->vertex[i] = v3_madd(shape->vertex[i], off, normal);
}

static struct rl_light_set *coloured(struct shape *shapes, size_t n)
{
    static const double radiance[LIGHTS_MOST][3] = {{1.0, 0.5, 0.0}, {0.2, 0.5, 3.0}};
    struct rl_light light[LIGHTS_MOST] = {{0}};
    struct rl_polygon polygon[LIGHTS_MOST] = {{0}};
    for (size_t i = 0; i < n; i++) {
        polygon[i] = (struct rl_polygon){.n = (int)shapes[i].n, .vertex = shapes[i].vertex};
        light[i].n_polygons = 1;
        light[i].polygon = &polygon[i];
        memcpy(light[i].radiance, radiance[i], sizeof radiance[i]);
    }
    struct rl_light_set *set = NULL;
    rl_light_set_make(&set, light, n, NULL);
    return set;
}

static struct question ask(struct dice *d, int i)
{
    enum { TWO = 4, HORIZON, IN_PLANE, PRINTED };
    int kind = i % 8;
    struct question q = {.surface = surface_point(d, 0.05), .options = {.attenuation = i / 8 % 4 != 0}};
    q.e = rl_ellipsoid_make(pow(300.0, uniform(d, 0.0, 1.0)));
    struct shape shapes[LIGHTS_MOST];
    rl_vec3 centre = near_mirror(d, &q.surface, kind == TWO ? 0.4 : 0.8);
    if (kind == HORIZON) {
        rl_vec3 N = q.surface.N, out = v3_sub(centre, q.surface.P);
        centre = v3_madd(centre, uniform(d, -0.3, 0.3) - v3_dot(N, out), N);
    }
    shapes[0] = any_light(d, centre);
    shapes[1] = any_light(d, v3_madd(centre, 0.4, unit_vector(d)));
    if (kind == IN_PLANE)
        level_with(&shapes[0], q.surface.P);
    if (kind == PRINTED)
        q.options.frame = RL_FRAME_PRINTED;
    q.set = kind == TWO ? coloured(shapes, 2) : set_of(shapes, 1);
    return q;
}

static struct rl_estimate answer(const char *name, const struct question *q, double tolerance,
                                 size_t max_evaluations, double confidence, uint64_t seed)
{
    struct rl_integrate_options options = q->options;
    options.tolerance = tolerance;
    options.max_evaluations = max_evaluations;
    options.confidence = confidence;
    options.seed = seed;
    struct rl_estimate estimate;
    struct rl_error error;
    check_ok(rl_integrator_find(name)->integrate(&estimate, &q->surface, &q->e, q->set, &options, &error),
             &error);
    return estimate;
}

static void check_agreement(const char *name, int i, const struct rl_estimate *a, const struct rl_estimate *b)
{
    for (int c = 0; c < 3; c++) {
        double off = fabs(a->value[c] - b->value[c]);
        if (off <= a->error[c] + b->error[c])
            continue;
        print_error("configuration %d, channel %d: reference %.13g +- %.1e, %s %.13g +- %.1e\n", i, c,
                    a->value[c], a->error[c], name, b->value[c], b->error[c]);
        fail();
    }
}

static void test_cubature_agrees(void **state)
{
    (void)state;
    struct dice d = dice_make(2101);
    int dark = 0;
    for (int i = 0; i < CASES; i++) {
        struct question q = ask(&d, i);
        struct rl_estimate truth = answer("reference", &q, 1e-10, 0, 0.0, 0);
        struct rl_estimate r = answer("cubature", &q, 1e-8, 0, 0.0, 0);
        assert_true(truth.converged && r.converged);
        check_agreement("cubature", i, &truth, &r);
        r = answer("cubature", &q, 1e-3, 0, 0.0, 0);
        check_agreement("cubature at 1e-3", i, &truth, &r);
        dark += truth.value[0] == 0.0;
        rl_light_set_free(q.set);
    }
    /* P in the light's plane sees nothing, and few others do. */
    assert_in_range(dark, CASES / 8, CASES / 4);
}

static void test_montecarlo_agrees(void **state)
{
    (void)state;
    struct dice d = dice_make(2102);
    /* Three channels of every configuration; those of a grey light are the same event, which errs on the safe side. */
    double confidence = pow(1.0 - FALSE_ALARM, 1.0 / (3.0 * CASES));
    for (int i = 0; i < CASES; i++) {
        struct question q = ask(&d, i);
        struct rl_estimate truth = answer("reference", &q, 1e-10, 0, 0.0, 0);
        struct rl_estimate r = answer("montecarlo", &q, 0.02, 0, confidence, (uint64_t)i);
        assert_true(r.converged);
        check_agreement("montecarlo", i, &truth, &r);
        rl_light_set_free(q.set);
    }
}

/* Several seeds of each configuration with something to see, at two levels. */
static void test_montecarlo_covers(void **state)
{
    (void)state;
    enum { SEEDS = 5 };
    static const double levels[] = {0.99, 0.9};
    struct dice d = dice_make(2103);
    unsigned missed[LENGTH(levels)] = {0}, n = 0;
    for (int i = 0; i < CASES; i++) {
        struct question q = ask(&d, i);
        struct rl_estimate truth = answer("reference", &q, 1e-10, 0, 0.0, 0);
        for (uint64_t seed = 0; seed < SEEDS && truth.value[0] > 1e-3; seed++, n++)
            for (size_t j = 0; j < LENGTH(levels); j++) {
                struct rl_estimate r =
                    answer("montecarlo", &q, j ? 0.006 : 0.01, 0, levels[j], 1000 * seed + (uint64_t)i);
                missed[j] += fabs(r.value[0] - truth.value[0]) > r.error[0] + truth.error[0];
            }
        rl_light_set_free(q.set);
    }
    for (size_t j = 0; j < LENGTH(levels); j++) {
        double low = gsl_cdf_binomial_P(missed[j], 1.0 - levels[j], n);
        double high = missed[j] ? gsl_cdf_binomial_Q(missed[j] - 1, 1.0 - levels[j], n) : 1.0;
        print_message("level %g: %u of %u missed, %.1f expected; tails %.2g and %.2g\n", levels[j], missed[j],
                      n, (1.0 - levels[j]) * n, low, high);
        assert_true(n > 500 && low > 0.0005 && high > 0.0005);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cubature_agrees),
        cmocka_unit_test(test_montecarlo_agrees),
        cmocka_unit_test(test_montecarlo_covers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
