/* The ellipsoid distribution: against tables, against itself, and against the integral of its density. */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <gsl/gsl_integration.h>

#include <cmocka.h>

#include "model/ellipsoid.h"
#include "model/ellipsoid_tables.h"
#include "model/random.h"
#include "model/vec3.h"
#include "support/check.h"

#define LENGTH(a) (sizeof(a) / sizeof(a)[0])

/* Half a unit in the last place of a value just above a power of two, relative to it. */
#define ULP (0.5 * DBL_EPSILON)

static const double ratios[] = {1e-6,       0.01, 0.5,  1.0 - 1e-6, 1.0 - 1e-15, 1.0, 1.0 + 1e-15,
                                1.0 + 1e-6, 3.0,  30.0, 300.0,      1e6,         1e12};

static void test_valid(void **state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(ratios); i++)
        assert_true(rl_ellipsoid_valid(ratios[i]));
    static const double invalid[] = {0.0, -0.0, -1.0, 9e-7, 1.1e12, INFINITY, -INFINITY, NAN};
    for (size_t i = 0; i < LENGTH(invalid); i++)
        assert_false(rl_ellipsoid_valid(invalid[i]));
}

static void test_pdf_and_cdf_tables(void **state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(by_delta); i++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(by_delta[i].rr);
        double delta = by_delta[i].delta;
        check_relative(rl_ellipsoid_pdf(&e, delta), by_delta[i].pdf, 8.0 * ULP);
        check_relative(rl_ellipsoid_cdf(&e, delta), by_delta[i].cdf, 8.0 * ULP);
        /* The same from sine and cosine, and on the other side. */
        check_relative(rl_ellipsoid_pdf_sincos(&e, -sin(delta), cos(delta)), by_delta[i].pdf, 8.0 * ULP);
        check_near(rl_ellipsoid_cdf_sincos(&e, -sin(delta), cos(delta)), 1.0 - by_delta[i].cdf, 8.0 * ULP);
    }
}

static void test_inverse_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(by_u); i++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(by_u[i].rr);
        struct rl_delta d = rl_ellipsoid_inverse(&e, by_u[i].u);
        check_relative(d.delta, by_u[i].delta, 8.0 * ULP);
        check_relative(d.sin_delta, by_u[i].sin_delta, 8.0 * ULP);
        check_relative(d.cos_delta, by_u[i].cos_delta, 8.0 * ULP);
    }
}

static void test_inverse_ends(void **state)
{
    (void)state;
    const double half_pi = 1.5707963267948966;
    for (size_t i = 0; i < LENGTH(ratios); i++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(ratios[i]);
        struct rl_delta d = rl_ellipsoid_inverse(&e, 0.5);
        check_near(d.delta, 0.0, 0.0);
        check_near(d.sin_delta, 0.0, 0.0);
        check_near(d.cos_delta, 1.0, 0.0);
        static const double low[] = {0.0, -0.0, -1.0, -INFINITY, DBL_TRUE_MIN, 1e-310, DBL_MIN};
        for (size_t j = 0; j < LENGTH(low); j++) {
            d = rl_ellipsoid_inverse(&e, low[j]);
            check_near(d.delta, -half_pi, 0.0);
            check_near(d.sin_delta, -1.0, 0.0);
            check_near(d.cos_delta, 0.0, 1e-140); /* sqrt(2 t), and t is R^2/k times a number of that size */
            assert_true(d.cos_delta >= 0.0);
        }
        d = rl_ellipsoid_inverse(&e, low[0]);
        check_near(d.cos_delta, 0.0, 0.0);
        static const double high[] = {1.0, 1.0 + DBL_EPSILON, 2.0, INFINITY};
        for (size_t j = 0; j < LENGTH(high); j++) {
            d = rl_ellipsoid_inverse(&e, high[j]);
            check_near(d.delta, half_pi, 0.0);
            check_near(d.sin_delta, 1.0, 0.0);
            check_near(d.cos_delta, 0.0, 0.0);
        }
    }
}

/* Evenly spread U, and U that crowd at both ends and in the middle. */
static double spread(int i, int n)
{
    switch (i % 4) {
    case 0:
        return (i + 0.5) / n;
    case 1:
        return pow(2.0, -60.0 * i / n);
    case 2:
        return 1.0 - pow(2.0, -50.0 * i / n);
    default:
        return 0.5 + (i % 8 < 4 ? 0.5 : -0.5) * pow(2.0, -50.0 * i / n);
    }
}

static void test_round_trip(void **state)
{
    (void)state;
    enum { N = 4000 };
    for (size_t r = 0; r < LENGTH(ratios); r++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(ratios[r]);
        for (int i = 0; i < N; i++) {
            double u = spread(i, N);
            struct rl_delta d = rl_ellipsoid_inverse(&e, u);
            check_near(d.sin_delta * d.sin_delta + d.cos_delta * d.cos_delta, 1.0, 4.0 * ULP);
            /* An error of an ulp in x = 2 u A is one of A ulps in U where sinh(x) grows like e^x. */
            double bound = (16.0 + (ratios[r] < 1.0 ? 2.0 * e.half_range : 0.0)) * ULP;
            check_relative(rl_ellipsoid_cdf_sincos(&e, d.sin_delta, d.cos_delta), u, bound);
        }
    }
}

static void test_symmetry_and_order(void **state)
{
    (void)state;
    enum { N = 2000 };
    for (size_t r = 0; r < LENGTH(ratios); r++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(ratios[r]);
        double last_u = -1.0;
        double last_delta = -2.0;
        for (int i = 0; i <= N; i++) {
            double delta = (2.0 * i / N - 1.0) * 0.5 * RL_PI;
            double u = rl_ellipsoid_cdf(&e, delta);
            assert_true(u >= last_u && u >= 0.0 && u <= 1.0);
            assert_true(rl_ellipsoid_pdf(&e, delta) == rl_ellipsoid_pdf(&e, -delta));
            assert_true(rl_ellipsoid_pdf(&e, delta) > 0.0);
            last_u = u;
            struct rl_delta below = rl_ellipsoid_inverse(&e, (double)i / N);
            struct rl_delta above = rl_ellipsoid_inverse(&e, 1.0 - (double)i / N);
            assert_true(below.delta > last_delta);
            check_near(above.delta, -below.delta, 1e-13); /* 1 - i/N is rounded */
            last_delta = below.delta;
        }
    }
}

static double density(double delta, void *ellipsoid)
{
    return rl_ellipsoid_pdf(ellipsoid, delta);
}

/* From 0 to pi/2 in pieces that grow with the distance from the peak, whose width is 1/R, and shrink towards
 * the other end, where a small R has its two peaks. */
static void test_density_integrates_to_one(void **state)
{
    (void)state;
    gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(1000);
    for (size_t r = 0; r < LENGTH(ratios); r++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(ratios[r]);
        gsl_function f = {density, &e};
        /* Near pi/2 neighbouring doubles are 2e-16 apart, which a peak of small R, norm/(2 R) high,
         * multiplies. */
        double tolerance = 1e-13 + (ratios[r] < 1.0 ? 8.0 * ULP * e.norm / (2.0 * ratios[r]) : 0.0);
        double half = 0.0;
        double from = 0.0;
        for (int piece = -52; piece <= 32; piece++) {
            double to = 0.5 * RL_PI * (piece < 0 ? pow(2.0, piece) : 1.0 - pow(2.0, -piece - 1.0));
            if (piece == 32)
                to = 0.5 * RL_PI;
            double part = 0.0;
            double bound = 0.0;
            gsl_integration_qag(&f, from, to, 1e-16, 1e-13, 1000, GSL_INTEG_GAUSS31, workspace, &part,
                                &bound);
            half += part;
            /* The cdf is this integral all the way. */
            check_near(rl_ellipsoid_cdf(&e, to), 0.5 + half, tolerance);
            from = to;
        }
        check_near(2.0 * half, 1.0, tolerance);
    }
    gsl_integration_workspace_free(workspace);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_valid),
        cmocka_unit_test(test_pdf_and_cdf_tables),
        cmocka_unit_test(test_inverse_table),
        cmocka_unit_test(test_inverse_ends),
        cmocka_unit_test(test_round_trip),
        cmocka_unit_test(test_symmetry_and_order),
        cmocka_unit_test(test_density_integrates_to_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
