/* Fresnel's reflectance and distributions of facets against closed forms. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "model/facets.h"
#include "model/fresnel.h"
#include "support/check.h"

static double normal_incidence(double n, double k)
{
    return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
}

static void test_limits(void **state)
{
    (void)state;
    static const double n[] = {0.01, 0.2, 0.999, 1.0, 1.001, 1.5, 4.0, 100.0, 1e8},
                        k[] = {0.0, 1e-6, 0.1, 3.0, 100.0};
    for (size_t i = 0; i < sizeof n / sizeof n[0]; i++)
        for (size_t j = 0; j < sizeof k / sizeof k[0]; j++) {
            check_near(rl_fresnel(n[i], k[j], 1.0), normal_incidence(n[i], k[j]), 1e-14);
            bool nothing = n[i] == 1.0 && k[j] == 0.0;
            check_near(rl_fresnel(n[i], k[j], 0.0), nothing ? 0.0 : 1.0, 1e-14);
            for (int c = 0; c <= 64; c++) {
                double f = rl_fresnel(n[i], k[j], c / 64.0);
                assert_true(f >= 0.0 && f <= 1.0 + 1e-15);
            }
        }
}

/* Dielectrics: the formula of Cook and Torrance 1982, eq. (in g and c), and angles where something happens. */
static void test_dielectric(void **state)
{
    (void)state;
    for (int i = 0; i < 12; i++)
        for (int j = 1; j <= 64; j++) {
            double n = 1.05 + 0.25 * i, c = j / 64.0;
            double g = sqrt(n * n + c * c - 1.0), a = (g - c) / (g + c);
            double b = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
            check_near(rl_fresnel(n, 0.0, c), 0.5 * a * a * (1.0 + b * b), 1e-14);
        }
    /* Brewster's angle, tan = n: only the s part is left, ((n^2 - 1)/(n^2 + 1))^2/2. */
    double n = 1.5, r = (n * n - 1.0) / (n * n + 1.0);
    check_near(rl_fresnel(n, 0.0, 1.0 / sqrt(1.0 + n * n)), 0.5 * r * r, 1e-15);
    /* Total reflection beyond sin = n, for n < 1. */
    check_near(rl_fresnel(0.5, 0.0, 0.8), 1.0, 1e-15);
    check_near(rl_fresnel(0.5, 0.0, 0.5), 1.0, 1e-15);
    assert_true(rl_fresnel(0.5, 0.0, 0.95) < 0.5);
    /* Both media exchanged: n at an angle, 1/n at the refracted one. */
    double s = 0.6, c_inside = sqrt(1.0 - s * s / (n * n));
    check_near(rl_fresnel(n, 0.0, 0.8), rl_fresnel(1.0 / n, 0.0, c_inside), 1e-14);
}

static void test_index(void **state)
{
    (void)state;
    static const double part[] = {0.0, 1e-6, 0.04, 0.25, 0.5, 0.9, 0.999, 1.0};
    for (size_t i = 0; i < sizeof part / sizeof part[0]; i++)
        check_near(rl_fresnel_of(rl_fresnel_index(part[i]), 1.0, 0.0), part[i], 5e-8 * part[i] + 1e-16);
}

/* The integral of D cos(delta) over the hemisphere is 1; in u = tan^2(delta)/m^2/(1 + tan^2/m^2). */
static void test_facets(void **state)
{
    (void)state;
    static const double m[] = {0.001, 0.1, 0.5, 1.0, 10.0};
    enum { STEPS = 20000 };
    for (size_t i = 0; i < sizeof m / sizeof m[0]; i++) {
        double beckmann = 0.0, ellipsoid = 0.0;
        for (int j = 0; j < STEPS; j++) {
            double u = (j + 0.5) / STEPS, t = m[i] * m[i] * u / (1.0 - u); /* tan^2 */
            double cc = 1.0 / (1.0 + t), c = sqrt(cc), ss = t * cc;
            /* cos d omega = pi d(sin^2) = pi cos^4 d(tan^2) */
            double weight = RL_PI * cc * cc * m[i] * m[i] / ((1.0 - u) * (1.0 - u)) / STEPS;
            beckmann += weight * rl_facets_beckmann(c, ss, m[i]);
            ellipsoid += weight * rl_facets_ellipsoid(c, ss, m[i]);
        }
        check_near(beckmann, 1.0, 1e-6);
        check_near(ellipsoid, 1.0, 1e-6);
    }
    /* m = 1 is a sphere's ellipsoid: the same in every direction. */
    check_near(rl_facets_ellipsoid(0.6, 0.64, 1.0), 1.0 / RL_PI, 1e-15);
    check_near(rl_facets_beckmann(0.6, 0.64, 1.0), exp(-16.0 / 9.0) / (RL_PI * 0.1296), 1e-15);
    check_near(rl_facets_beckmann(1e-200, 1.0, 1.0), 0.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_limits),
        cmocka_unit_test(test_dielectric),
        cmocka_unit_test(test_index),
        cmocka_unit_test(test_facets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
