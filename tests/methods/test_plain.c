/* `plain`: the lobe's width, its peak and where it is dark. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "methods/method.h"
#include "support/check.h"

static double exponent(double rr)
{
    double params[1][4];
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    rl_method_find("plain")->pack(&e, params);
    for (int i = 1; i < 4; i++)
        check_near(params[0][i], 0.0, 0.0);
    return params[0][0];
}

/* Half the peak at the mirror's gamma = 2 delta where D has half of its own, k sin(delta) = 1. */
static void test_exponent(void **state)
{
    (void)state;
    static const double ratios[] = {3.0, 30.0, 300.0, 1e4};
    for (size_t i = 0; i < sizeof ratios / sizeof ratios[0]; i++) {
        double delta = asin(1.0 / sqrt(ratios[i] * ratios[i] - 1.0));
        check_near(pow(cos(2.0 * delta), exponent(ratios[i])), 0.5, 1e-8);
    }
    /* ln(2) k^2/2 for large k */
    check_relative(exponent(1e12), 0.34657359027997264e24, 1e-12);
    /* n = 1 where 1 - 2/k^2 = 1/2, R = sqrt(5), and for every rougher one. */
    check_near(exponent(sqrt(5.0)), 1.0, 1e-14);
    static const double rough[] = {2.0, 1.7320508075688774, 1.5, 1.0, 0.5, 1e-6};
    for (size_t i = 0; i < sizeof rough / sizeof rough[0]; i++)
        check_near(exponent(rough[i]), 1.0, 0.0);
}

static void shade(const struct rl_surface *s, const struct rl_point_light *lights, size_t n, double rr,
                  double rgb[3])
{
    double params[1][4];
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    const struct rl_method *plain = rl_method_find("plain");
    plain->pack(&e, params);
    plain->shade(s, lights, n, params, rgb);
}

static void test_shade(void **state)
{
    (void)state;
    /* The mirror direction is (-0.6, 0, 0.8); the second light is 60 degrees from it, the third below the
     * surface. */
    const struct rl_surface s = {v3(1.0, 2.0, 3.0), v3(0.0, 0.0, 1.0), v3(0.6, 0.0, 0.8)};
    const rl_vec3 mirror = v3(-0.6, 0.0, 0.8);
    const rl_vec3 aside = v3_add(v3_scale(0.5, mirror), v3(0.0, sqrt(0.75), 0.0));
    const struct rl_point_light lights[3] = {
        {.position = v3_madd(s.P, 2.0, mirror), .radiance = {1.0, 2.0, 3.0}},
        {.position = v3_madd(s.P, 7.0, aside), .radiance = {8.0, 0.0, 16.0}},
        {.position = v3(-4.0, 2.0, 2.9), .radiance = {100.0, 100.0, 100.0}},
    };
    double rgb[3];
    shade(&s, lights, 3, 2.0, rgb); /* n = 1 */
    check_near(rgb[0], 1.0 + 0.5 * 8.0, 1e-14);
    check_near(rgb[1], 2.0, 1e-14);
    check_near(rgb[2], 3.0 + 0.5 * 16.0, 1e-14);
    shade(&s, lights, 0, 2.0, rgb);
    check_near(rgb[0] + rgb[1] + rgb[2], 0.0, 0.0);
}

/* Cosines a little above 1, as rounding makes them, are still a mirror's peak. */
static void test_peak_of_a_narrow_lobe(void **state)
{
    (void)state;
    for (int i = 0; i < 1000; i++) {
        double angle = 0.0015 * i;
        const struct rl_surface s = {v3(0.0, 0.0, 0.0), v3(0.0, 0.0, 1.0), v3(sin(angle), 0.0, cos(angle))};
        const struct rl_point_light light = {.position = v3(-3.0 * sin(angle), 0.0, 3.0 * cos(angle)),
                                             .radiance = {1.0, 1.0, 1.0}};
        double rgb[3];
        shade(&s, &light, 1, 1e12, rgb);
        assert_true(rgb[0] >= 0.0 && rgb[0] <= 1.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exponent),
        cmocka_unit_test(test_shade),
        cmocka_unit_test(test_peak_of_a_narrow_lobe),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
