/* `exhaustive` against the reference: whether its stated errors hold, and its poles. test_texel_map.c has the order at which it converges. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>

#include "reference/fixture.h"
#include "reference/integrators.h"
#include "reference/texel_fixture.h"
#include "support/check.h"

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* |value - truth| <= stated error, and the stated error says something: at most one in a thousand may miss. */
static void test_stated_errors_hold(void **state)
{
    (void)state;
    static const struct {
        int size, lights, cases;
        double most_typical; /* median of stated over true error */
    } rows[] = {{64, 1, 1000, 20.0}, {256, 1, 200, 20.0}, {64, 3, 300, 100.0}};
    static double ratio[1000];
    const struct rl_integrator *it = rl_integrator_find("exhaustive");
    struct dice d = dice_make(82);
    for (size_t row = 0; row < LENGTH(rows); row++) {
        int missed = 0;
        for (int i = 0; i < rows[row].cases; i++) {
            struct rl_surface s = surface_point(&d, 0.05);
            struct shape shapes[3];
            static const double radiance[3] = {1.0, 0.25, 1.0};
            for (int k = 0; k < rows[row].lights; k++)
                shapes[k] = random_light(&d, &s);
            struct rl_light_set *set = lights_of(shapes, radiance, (size_t)rows[row].lights);
            double rr = pow(10.0, uniform(&d, 0.0, log10(300.0)));
            bool attenuation = i % 3;
            struct rl_ellipsoid e = rl_ellipsoid_make(rr);
            struct rl_estimate truth = integrate(&s, rr, set, attenuation, 1e-10), r;
            struct rl_error error;
            check_ok(it->integrate(&r, &s, &e, set,
                                   &(struct rl_integrate_options){.attenuation = attenuation,
                                                                  .env_size = rows[row].size},
                                   &error),
                     &error);
            rl_light_set_free(set);
            double off = fabs(r.value[0] - truth.value[0]);
            missed += off > r.error[0] + truth.error[0];
            ratio[i] = r.error[0] / fmax(off, 1e-300);
            assert_true(r.error[1] == r.error[0] && r.evaluations > 0);
        }
        qsort(ratio, (size_t)rows[row].cases, sizeof ratio[0], by_size);
        double typical = ratio[rows[row].cases / 2];
        print_message("%d texels, %d lights: %d of %d missed, stated over true error typically %.1f\n",
                      rows[row].size, rows[row].lights, missed, rows[row].cases, typical);
        assert_true(missed <= rows[row].cases / 1000);
        assert_true(typical <= rows[row].most_typical);
    }
}

/* Radiance 1 all round and no attenuation: 1, for every R_r and V, resolved by the map's texels or not. */
static void test_furnace(void **state)
{
    (void)state;
    const struct rl_integrator *it = rl_integrator_find("exhaustive");
    struct dice d = dice_make(83);
    struct rl_light_set *set = furnace();
    double worst = 0.0;
    for (int i = 0; i < 40; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        double rr = pow(10.0, uniform(&d, 0.0, i % 4 ? 2.5 : 9.0));
        s.P = v3(0.0, 0.0, 0.0);
        struct rl_ellipsoid e = rl_ellipsoid_make(rr);
        struct rl_estimate r;
        struct rl_error error;
        check_ok(it->integrate(&r, &s, &e, set, &(struct rl_integrate_options){.env_size = 96}, &error),
                 &error);
        check_near(r.value[0], 1.0, r.error[0]);
        worst = fmax(worst, fabs(r.value[0] - 1.0));
    }
    rl_light_set_free(set);
    print_message("furnace: off by %.1e at most\n", worst);
    check_near(worst, 0.0, 2e-3);
}

/* The poles on a texel's centre, on an edge and in a corner; R_r beyond all resolution is a mirror. */
static void test_poles(void **state)
{
    (void)state;
    static const rl_vec3 directions[] = {{0, 0, 1}, {1, 0, 1}, {0, 1, 3}, {1, 1, 1}, {-1, 2, 3}};
    static const double ratios[] = {1.0, 10.0, 1e3, 1e6, 1e12};
    struct rl_light_set *set = furnace();
    for (size_t i = 0; i < LENGTH(directions); i++)
        for (size_t k = 0; k < LENGTH(ratios); k++)
            for (int size = 8; size <= 9; size++) {
                const struct rl_surface s = {.N = v3(0, 0, 1), .V = v3_normalize(directions[i])};
                check_near(map_value(&s, ratios[k], set, false, size), 1.0, 4e-3);
                if (k >= 3)
                    check_near(map_value(&s, ratios[k], set, true, size), 1.0, 4e-3);
            }
    /* On a line between texels, or as good as. */
    struct dice d = dice_make(84);
    for (int i = 0; i < 400; i++) {
        static const double beside[] = {0.0, 1e-300, 1e-100, 1e-40, 1e-20, 1e-18, 1e-17, 1e-16, 1e-13, 1e-10};
        double tiny = beside[(size_t)i % LENGTH(beside)];
        const struct rl_surface s = {.N = v3(0, 0, 1),
                                     .V = v3_normalize(v3(tiny, uniform(&d, -2.0, 2.0), 1.0))};
        check_near(map_value(&s, pow(10.0, uniform(&d, 0.0, 4.0)), set, false, 8), 1.0, 4e-3);
    }
    rl_light_set_free(set);
    /* Beside the mirror direction there is nothing to see. */
    const struct shape aside = {4, {{1, -1, 1}, {2, -1, 1}, {2, 1, 1}, {1, 1, 1}}};
    set = set_of(&aside, 1);
    const struct rl_surface s = {.N = v3(0, 0, 1), .V = v3(0, 0, 1)};
    check_near(map_value(&s, 1e12, set, true, 64), 0.0, 1e-9);
    rl_light_set_free(set);
}

static void test_nothing_to_see(void **state)
{
    (void)state;
    const struct rl_integrator *it = rl_integrator_find("exhaustive");
    const struct shape quad = {4, {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
    struct rl_surface s = {.N = v3(0, 0, 1), .V = v3_normalize(v3(1, 0, -0.1))};
    struct rl_ellipsoid e = rl_ellipsoid_make(10.0);
    struct rl_light_set *set = set_of(&quad, 1), *empty = set_of(&quad, 0);
    struct rl_estimate r;
    struct rl_error error;
    const struct rl_integrate_options options = {.attenuation = true, .env_size = 16};
    check_ok(it->integrate(&r, &s, &e, set, &options, &error), &error); /* seen from behind */
    assert_true(r.value[0] == 0.0 && r.error[0] == 0.0);
    s.V = v3(0, 0, 1);
    check_ok(it->integrate(&r, &s, &e, empty, &options, &error), &error);
    assert_true(r.value[0] == 0.0 && r.error[0] == 0.0 && r.evaluations == 0);
    s.P = v3(0, 0, 3); /* the light is below the horizon */
    check_ok(it->integrate(&r, &s, &e, set, &options, &error), &error);
    assert_true(r.value[0] == 0.0);
    s.P = v3(3, 0, 2); /* in the light's plane */
    check_ok(it->integrate(&r, &s, &e, set, &options, &error), &error);
    assert_true(r.value[0] == 0.0);
    rl_light_set_free(set);
    rl_light_set_free(empty);
}

static void test_options(void **state)
{
    (void)state;
    const struct rl_integrator *it = rl_integrator_find("exhaustive");
    const struct shape quad = {4, {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
    const struct rl_surface s = {.N = v3(0, 0, 1), .V = v3(0, 0, 1)};
    struct rl_ellipsoid e = rl_ellipsoid_make(10.0);
    struct rl_light_set *set = set_of(&quad, 1);
    struct rl_estimate r, by_default;
    struct rl_error error;
    check_fails(it->integrate(&r, &s, &e, set, &(struct rl_integrate_options){.env_size = 7}, &error), &error,
                RL_ERR_INPUT, "found an environment map of 7 texels, expected 8 to 4096");
    check_fails(it->integrate(&r, &s, &e, set, &(struct rl_integrate_options){.env_size = 4097}, &error),
                &error, RL_ERR_INPUT, "4097");
    check_fails(
        it->integrate(&r, &s, &e, set, &(struct rl_integrate_options){.frame = RL_FRAME_PRINTED}, &error),
        &error, RL_ERR_INPUT, "found the frame printed, expected orthonormal");
    check_ok(
        it->integrate(&by_default, &s, &e, set, &(struct rl_integrate_options){.tolerance = 0.1}, &error),
        &error);
    check_ok(it->integrate(&r, &s, &e, set,
                           &(struct rl_integrate_options){.tolerance = 1e-9, .env_size = 512}, &error),
             &error);
    assert_true(r.value[0] == by_default.value[0]);
    assert_true(by_default.converged && !r.converged);
    rl_light_set_free(set);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_stated_errors_hold),
        cmocka_unit_test(test_furnace),
        cmocka_unit_test(test_poles),
        cmocka_unit_test(test_options),
        cmocka_unit_test(test_nothing_to_see),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
