/* Lights that random ones never are: a vertex or an edge exactly in the mirror direction or in that of V, coordinates on a grid, lights
 * through one another. Against `cubature`, which knows nothing of lines. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "reference/fixture.h"
#include "reference/integrators.h"
#include "support/check.h"

enum { LIGHTS_MOST = 5 };

static double whole_number(struct dice *d, int low, int high)
{
    return floor(uniform(d, low, high + 1));
}

struct question {
    struct rl_surface s;
    struct shape light[LIGHTS_MOST];
    double radiance[LIGHTS_MOST];
    size_t n;
};

static void shift(struct shape *shape, rl_vec3 by)
{
    for (size_t i = 0; i < shape->n; i++)
        shape->vertex[i] = v3_add(shape->vertex[i], by);
}

/* One vertex, or the middle of one edge, in this direction. */
static void put(struct shape *shape, struct dice *d, rl_vec3 direction, bool edge)
{
    size_t i = (size_t)whole_number(d, 0, (int)shape->n - 1), j = edge ? (i + 1) % shape->n : i;
    rl_vec3 at = v3_scale(0.5, v3_add(shape->vertex[i], shape->vertex[j]));
    shift(shape, v3_sub(v3_scale(uniform(d, 1.0, 2.0), direction), at));
}

static void ask_direction(struct question *q, struct dice *d, bool mirror, bool edge)
{
    q->s = surface_point(d, 0.05);
    q->s.P = v3(0, 0, 0);
    q->n = 1;
    rl_vec3 direction = mirror ? v3_reflect(q->s.V, q->s.N) : v3_scale(-1.0, q->s.V);
    q->light[0] = polygon_about(d, direction, 3 + (size_t)uniform(d, 0, 4), uniform(d, 0.2, 1.0),
                                uniform(d, 0.2, 1.0), 0.3);
    put(&q->light[0], d, direction, edge);
}

static void ask_mirror_vertex(struct question *q, struct dice *d)
{
    ask_direction(q, d, true, false);
}
static void ask_mirror_edge(struct question *q, struct dice *d)
{
    ask_direction(q, d, true, true);
}
static void ask_eye_vertex(struct question *q, struct dice *d)
{
    ask_direction(q, d, false, false);
}
static void ask_eye_edge(struct question *q, struct dice *d)
{
    ask_direction(q, d, false, true);
}

/* Rectangles along the axes and a view whose components are whole numbers. */
static void ask_grid(struct question *q, struct dice *d)
{
    q->s = (struct rl_surface){v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 0)};
    q->s.V = v3_normalize(v3(whole_number(d, -2, 2), whole_number(d, -2, 2), whole_number(d, 1, 2)));
    q->n = (size_t)whole_number(d, 1, 3);
    for (size_t k = 0; k < q->n; k++) {
        double x = whole_number(d, -3, 2), y = whole_number(d, -3, 2), z = whole_number(d, k ? 1 : -1, 3);
        double w = whole_number(d, 1, 3), h = whole_number(d, 1, 3);
        int axis = (int)whole_number(d, 0, 2);
        q->light[k].n = 4;
        for (int i = 0; i < 4; i++) {
            double a = i == 1 || i == 2 ? w : 0.0, b = i >= 2 ? h : 0.0;
            q->light[k].vertex[i] = axis == 0   ? v3(x + a, y + b, z)
                                    : axis == 1 ? v3(x + a, z, y + b)
                                                : v3(z, x + a, y + b);
        }
    }
}

/* Three to five lights about one place, each through the others. */
static void ask_piercing(struct question *q, struct dice *d)
{
    q->s = surface_point(d, 0.05);
    q->n = 3 + (size_t)uniform(d, 0, 3);
    rl_vec3 centre = near_mirror(d, &q->s, 0.4);
    for (size_t k = 0; k < q->n; k++)
        q->light[k] = polygon_about(d, v3_madd(centre, 0.1, unit_vector(d)), 3 + (size_t)uniform(d, 0, 4),
                                    0.7, 0.7, 0.2);
}

static const struct {
    const char *name;
    void (*ask)(struct question *q, struct dice *d);
    int cases;
} kinds[] = {
    {"a vertex in the mirror direction", ask_mirror_vertex, 150},
    {"an edge through it", ask_mirror_edge, 150},
    {"a vertex in the direction away from the eye", ask_eye_vertex, 60},
    {"an edge through that", ask_eye_edge, 60},
    {"whole numbers", ask_grid, 300},
    {"lights through one another", ask_piercing, 40},
};

static const double ratios[] = {1.0, 1.0 + 1e-9, 1.5, 3.0, 10.0, 30.0, 100.0, 300.0};

static void check_question(const struct question *q, double rr, bool attenuation, size_t *confirmed)
{
    struct rl_light_set *set = lights_of(q->light, q->radiance, q->n);
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    struct rl_integrate_options options = {
        .attenuation = attenuation, .tolerance = 1e-6, .max_evaluations = 400000};
    struct rl_estimate witness;
    struct rl_error error;
    check_ok(rl_integrator_find("cubature")->integrate(&witness, &q->s, &e, set, &options, &error), &error);
    static const enum rl_simd sets[] = {RL_SIMD_PLAIN, RL_SIMD_AVX512};
    options.tolerance = 1e-9;
    options.max_evaluations = 0;
    for (size_t i = 0; i < LENGTH(sets); i++) {
        struct rl_estimate r;
        options.simd = sets[i] < rl_simd_best() ? sets[i] : rl_simd_best();
        rl_integrate_lines(&r, &q->s, &e, set, &options);
        check_near(r.value[0], witness.value[0], r.error[0] + witness.error[0]);
        assert_true(r.converged);
    }
    *confirmed += witness.error[0] < 1e-5;
    rl_light_set_free(set);
}

static void test_against_cubature(void **state)
{
    (void)state;
    struct dice d = dice_make(91);
    for (size_t k = 0; k < LENGTH(kinds); k++) {
        size_t confirmed = 0;
        for (int i = 0; i < kinds[k].cases; i++) {
            struct question q = {.radiance = {1.0, 0.6, 0.3, 0.8, 0.1}};
            kinds[k].ask(&q, &d);
            check_question(&q, ratios[(size_t)i % LENGTH(ratios)], i / 8 % 2, &confirmed);
        }
        print_message("%s: %zu of %d confirmed to 1e-5\n", kinds[k].name, confirmed, kinds[k].cases);
        assert_true(2 * confirmed > (size_t)kinds[k].cases);
    }
}

/* Bars that all cross one another, more than there is room for in the list of breaks: every instruction set says the same, and the
 * stated errors hold between tolerances. */
static void test_many_bars(void **state)
{
    (void)state;
    enum { BARS = 48 };
    struct rl_light light = {.n_polygons = BARS, .radiance = {1.0, 1.0, 1.0}};
    static struct rl_polygon polygon[BARS];
    static rl_vec3 vertex[BARS][4];
    for (int k = 0; k < BARS; k++) {
        double a = RL_PI * k / BARS, u = 1.6, w = 0.03;
        rl_vec3 c = v3(-0.5 + 0.06 * sin(7 * k), 0.06 * cos(5 * k), 1 + 0.02 * k);
        rl_vec3 along = v3(u * cos(a), u * sin(a), 0), across = v3(-w * sin(a), w * cos(a), 0);
        for (int i = 0; i < 4; i++)
            vertex[k][i] = v3_add(v3_madd(c, i == 1 || i == 2 ? 1.0 : -1.0, along),
                                  v3_scale(i < 2 ? -1.0 : 1.0, across));
        polygon[k] = (struct rl_polygon){.n = 4, .vertex = vertex[k]};
    }
    light.polygon = polygon;
    struct rl_light_set *set = NULL;
    struct rl_error error;
    check_ok(rl_light_set_make(&set, &light, 1, &error), &error);
    const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3_normalize(v3(1, 0, 2))};
    struct rl_estimate r[3];
    for (int i = 0; i < 3; i++) {
        struct rl_integrate_options options = {.attenuation = true, .tolerance = i == 2 ? 1e-5 : 1e-6};
        struct rl_ellipsoid e = rl_ellipsoid_make(5.0);
        options.simd = i == 0 ? RL_SIMD_PLAIN : rl_simd_best();
        rl_integrate_lines(&r[i], &s, &e, set, &options);
        assert_true(r[i].converged);
        check_near(r[i].value[0], r[0].value[0], r[i].error[0] + r[0].error[0]);
    }
    rl_light_set_free(set);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_cubature),
        cmocka_unit_test(test_many_bars),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
