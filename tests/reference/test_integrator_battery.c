/* L_o against independent witnesses, and whether its stated errors hold. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "reference/fixture.h"
#include "reference/witness.h"
#include "support/check.h"

/* P at the origin, N = z; V is given before normalisation. The values come from a program that evaluates the definition: for each
 * theta, delta where the ray passes the light's outline and where G has kinks, found numerically; 24 Gauss-Legendre points in delta between
 * them, the ray traced and G evaluated at each; Gauss-Kronrod halving over theta. Good to 3e-14. A second opinion is witness_area. */
static const struct {
    double rr;
    bool attenuation;
    rl_vec3 V;
    struct shape light;
    double value;
} table[] = {
    {1.0, true, {-1, 0, 1}, {4, {{0, -1, 1}, {2, -1, 1}, {2, 1, 1}, {0, 1, 1}}}, 0.344440032852787},
    {1.0, false, {-1, 0, 0.2}, {3, {{1, -1, 0.5}, {2, 0, 1.5}, {1, 1, 0.5}}}, 0.044453056148134},
    {2.0, true, {-1, 0.5, 0.3}, {4, {{2, -2, 0}, {2, 2, 0}, {2, 2, 2}, {2, -2, 2}}}, 0.447242781800719},
    {5.0, true, {-3, 0, 1}, {4, {{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}}}, 0.525116277809260},
    {10.0,
     true,
     {0.2, -0.4, 1},
     {5, {{-1, 0, 2}, {0, -0.5, 2}, {1, 0.5, 2}, {0.5, 1.5, 2}, {-0.5, 1, 2}}},
     0.578994228800013},
    {10.0,
     false,
     {-1, 0, 1},
     {6, {{0, 0, 1}, {3, -1, 1}, {1, 0, 1}, {3, 1, 1}, {0.5, 0.5, 1}, {0, 2, 1}}},
     0.594496899073656},
    {30.0,
     true,
     {-1, 0, 1},
     {4, {{0.9, -0.1, 1}, {1.3, -0.1, 1.1}, {1.3, 0.2, 1.1}, {0.9, 0.2, 1}}},
     0.617372234380683},
    {100.0, true, {-1, -1, 1}, {3, {{1, 1, 1.2}, {2, 1, 1.2}, {1, 2, 1.2}}}, 0.901750843124401},
    {300.0, true, {0, 0, 1}, {4, {{-1, -1, 3}, {0.01, -1, 3}, {0.01, 1, 3}, {-1, 1, 3}}}, 0.732561361036269},
    {300.0,
     false,
     {-20, 0, 1},
     {4, {{1, -0.02, 0}, {1, 0.02, 0}, {1, 0.02, 0.2}, {1, -0.02, 0.2}}},
     0.964108479710780},
};

static void test_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(table); i++) {
        const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3_normalize(table[i].V)};
        const struct shape *light = &table[i].light;
        check_near(value_of(&s, table[i].rr, light, 1, table[i].attenuation, 1e-13), table[i].value, 2e-13);
        check_near(witness_area(&s, table[i].rr, light->vertex, light->n, table[i].attenuation, 1e-12),
                   table[i].value, 2e-12);
    }
}

/* Whether no vertex comes near to -V or lies far below the horizon, where the integrand over the area has another pole. */
static bool witness_can_see(const struct rl_surface *s, const struct shape *light)
{
    for (size_t i = 0; i < light->n; i++) {
        rl_vec3 L = v3_normalize(v3_sub(light->vertex[i], s->P));
        if (v3_dot(s->N, L) + v3_dot(s->N, s->V) < 0.05)
            return false;
    }
    return true;
}

static void test_random_lights(void **state)
{
    (void)state;
    struct dice d = dice_make(41);
    double worst = 0.0;
    for (int i = 0; i < 60; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        struct shape light = random_light(&d, &s);
        double rr = pow(10.0, uniform(&d, -0.3, 2.4));
        bool attenuation = i % 3;
        if (!witness_can_see(&s, &light))
            continue;
        double value = value_of(&s, rr, &light, 1, attenuation, 1e-10);
        double off = fabs(value - witness_area(&s, rr, light.vertex, light.n, attenuation, 1e-10));
        worst = fmax(worst, off);
        check_near(off, 0.0, 1e-9);
    }
    print_message("worst disagreement with the area integral %.1e\n", worst);
}

/* Several lights that hide and pierce one another, either frame: against the definition, as well as a midpoint rule can. */
static void test_definition(void **state)
{
    (void)state;
    enum { LIGHTS = 3, CASES = 20, POINTS = 700 };
    static const double radiance[LIGHTS] = {1.0, 0.3, 0.6};
    struct dice d = dice_make(42);
    for (int i = 0; i < CASES; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        rl_vec3 centre = near_mirror(&d, &s, 0.4);
        struct shape shapes[LIGHTS];
        const rl_vec3 *vertices[LIGHTS];
        size_t n_vertices[LIGHTS];
        for (size_t j = 0; j < LIGHTS; j++) {
            shapes[j] = polygon_about(&d, v3_madd(centre, 0.5, unit_vector(&d)), 3 + j, 0.8, 0.8, 0.3);
            vertices[j] = shapes[j].vertex;
            n_vertices[j] = shapes[j].n;
        }
        enum rl_frame_kind frame = i % 2 ? RL_FRAME_PRINTED : RL_FRAME_ORTHONORMAL;
        double rr = pow(10.0, uniform(&d, -0.3, 2.0));
        struct rl_ellipsoid e = rl_ellipsoid_make(rr);
        struct rl_light_set *set = lights_of(shapes, radiance, LIGHTS);
        struct rl_estimate r;
        rl_integrate_lines(
            &r, &s, &e, set,
            &(struct rl_integrate_options){.attenuation = i % 3, .frame = frame, .tolerance = 1e-8});
        rl_light_set_free(set);
        assert_true(r.converged);
        check_near(r.value[0],
                   witness_dense(&s, rr, frame, vertices, n_vertices, radiance, LIGHTS, i % 3, POINTS), 3e-4);
    }
}

/* |value - truth| <= stated error, and within the tolerance, against a far finer run of the same code, whose own truth the tests above
 * are about. Every fourth case has two lights, of which one may hide a part of the other. None has missed since every break is known,
 * and none may. */
static void test_stated_errors_hold(void **state)
{
    (void)state;
    enum { CASES = 10000 };
    static const double tolerances[] = {1e-3, 1e-6, 1e-8, 1e-10, 1e-12}, radiance[] = {1.0, 0.3};
    struct dice d = dice_make(43);
    size_t missed[LENGTH(tolerances)] = {0}, lines[LENGTH(tolerances)] = {0};
    for (int i = 0; i < CASES; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        struct shape light[2] = {random_light(&d, &s), random_light(&d, &s)};
        struct rl_light_set *set = lights_of(light, radiance, i % 4 ? 1 : 2);
        double rr = pow(10.0, uniform(&d, 0.0, 2.5));
        bool attenuation = i % 3;
        struct rl_estimate truth = integrate(&s, rr, set, attenuation, 3e-14);
        for (size_t j = 0; j < LENGTH(tolerances); j++) {
            struct rl_estimate r = integrate(&s, rr, set, attenuation, tolerances[j]);
            double off = fabs(r.value[0] - truth.value[0]);
            assert_true(r.converged && r.error[0] <= tolerances[j]);
            assert_true(off <= tolerances[j] + truth.error[0]);
            missed[j] += off > r.error[0] + truth.error[0];
            lines[j] += r.evaluations;
        }
        rl_light_set_free(set);
    }
    for (size_t j = 0; j < LENGTH(tolerances); j++) {
        print_message("tolerance %.0e: %zu of %d missed, %.0f lines a point\n", tolerances[j], missed[j],
                      CASES, (double)lines[j] / CASES);
        assert_int_equal(missed[j], 0);
    }
}

/* Colour channels are one integral each, and the tolerance is that of the brightest. */
static void test_colours(void **state)
{
    (void)state;
    const struct shape quad = {4, {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
    const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 1)};
    struct rl_polygon polygon = {.n = 4, .vertex = (rl_vec3 *)quad.vertex};
    struct rl_light light = {.n_polygons = 1, .polygon = &polygon, .radiance = {200.0, 0.0, 50.0}};
    struct rl_light_set *set;
    struct rl_error error;
    check_ok(rl_light_set_make(&set, &light, 1, &error), &error);
    struct rl_estimate r = integrate(&s, 4.0, set, true, 1e-6);
    rl_light_set_free(set);
    double grey = value_of(&s, 4.0, &quad, 1, true, 1e-10);
    assert_true(r.converged && r.error[0] <= 200.0 * 1e-6 && r.error[0] > 0.0);
    check_near(r.value[0], 200.0 * grey, r.error[0]);
    check_near(r.value[2], 50.0 * grey, r.error[2]);
    assert_true(r.value[1] == 0.0);
}

/* The tolerance is relative to the brightest light: 1024 times the radiance is the same work, and 1024 times value and error. */
static void test_tolerance_is_relative(void **state)
{
    (void)state;
    const struct shape quad = {4, {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
    const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3_normalize(v3(0.9, 0.2, 0.5))};
    struct rl_polygon polygon = {.n = 4, .vertex = (rl_vec3 *)quad.vertex};
    struct rl_estimate r[2];
    for (int k = 0; k < 2; k++) {
        double radiance = k ? 1024.0 : 1.0;
        struct rl_light light = {
            .n_polygons = 1, .polygon = &polygon, .radiance = {radiance, radiance, radiance}};
        struct rl_light_set *set;
        struct rl_error error;
        check_ok(rl_light_set_make(&set, &light, 1, &error), &error);
        r[k] = integrate(&s, 30.0, set, true, 1e-9);
        rl_light_set_free(set);
        assert_true(r[k].converged);
    }
    assert_int_equal(r[0].evaluations, r[1].evaluations);
    check_relative(r[1].value[0], 1024.0 * r[0].value[0], 1e-14);
    check_relative(r[1].error[0], 1024.0 * r[0].error[0], 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_table),      cmocka_unit_test(test_random_lights),
        cmocka_unit_test(test_definition), cmocka_unit_test(test_stated_errors_hold),
        cmocka_unit_test(test_colours),    cmocka_unit_test(test_tolerance_is_relative),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
