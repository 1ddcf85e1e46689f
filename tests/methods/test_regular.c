/* `regular`: a pattern for every count, unit normals, weights that sum to 1 and follow D. */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "methods/method.h"
#include "support/check.h"

static struct rl_microfacet pattern[RL_SAMPLES_MAX + 1];

static struct rl_ellipsoid fill(double rr, int n)
{
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    for (int i = 0; i <= RL_SAMPLES_MAX; i++)
        pattern[i] = (struct rl_microfacet){NAN, NAN, NAN, NAN};
    rl_method_find("regular")->pattern(&e, n, pattern);
    return e;
}

static void test_every_count(void **state)
{
    (void)state;
    static const double ratios[] = {1e-6, 0.5, 1.0, 3.0, 30.0, 1e6, 1e12};
    for (size_t r = 0; r < sizeof ratios / sizeof ratios[0]; r++) {
        for (int n = 1; n <= RL_SAMPLES_MAX; n++) {
            fill(ratios[r], n);
            double sum = 0.0;
            for (int i = 0; i < n; i++) {
                const struct rl_microfacet *m = &pattern[i];
                check_near(m->x * m->x + m->y * m->y + m->z * m->z, 1.0, 8.0 * DBL_EPSILON);
                assert_true(m->x > 0.0);
                assert_true(m->weight > 0.0 && m->weight <= 1.0);
                sum += m->weight;
            }
            check_near(sum, 1.0, 1e-13);
            if (n < RL_SAMPLES_MAX + 1)
                assert_true(isnan(pattern[n].x)); /* nothing behind the last */
        }
    }
}

/* The first is N itself; the paper's 13 are it and two rings of 6, the second turned by 30 degrees. */
static void test_thirteen(void **state)
{
    (void)state;
    struct rl_ellipsoid e = fill(30.0, 13);
    check_near(pattern[0].x, 1.0, 0.0);
    double reach = rl_ellipsoid_inverse(&e, 1.0 - 1.0 / 12.0).delta;
    double cell[3] = {RL_PI * rl_ellipsoid_pdf(&e, 0.0)};
    double total = cell[0];
    for (int ring = 1; ring <= 2; ring++) {
        double delta = ring * reach / 2.5;
        cell[ring] = 2.0 * RL_PI / 6.0 * rl_ellipsoid_pdf(&e, delta);
        total += 6.0 * cell[ring];
        for (int i = 0; i < 6; i++) {
            const struct rl_microfacet *m = &pattern[1 + 6 * (ring - 1) + i];
            double theta = (60.0 * i + 30.0 * (ring - 1)) * RL_PI / 180.0;
            check_near(m->x, cos(delta), 1e-15);
            check_near(m->y, sin(delta) * cos(theta), 1e-15);
            check_near(m->z, sin(delta) * sin(theta), 1e-15);
        }
    }
    check_relative(pattern[0].weight, cell[0] / total, 1e-13);
    check_relative(pattern[1].weight, cell[1] / total, 1e-13);
    check_relative(pattern[12].weight, cell[2] / total, 1e-13);
}

/* A ring's normals stand around N evenly: their mean lies along it. */
static void test_no_side_is_favoured(void **state)
{
    (void)state;
    static const int counts[] = {4, 7, 13, 37, 64, 100, 1024};
    for (size_t c = 0; c < sizeof counts / sizeof counts[0]; c++) {
        fill(3.0, counts[c]);
        double y = 0.0;
        double z = 0.0;
        for (int i = 0; i < counts[c]; i++) {
            y += pattern[i].weight * pattern[i].y;
            z += pattern[i].weight * pattern[i].z;
        }
        check_near(y, 0.0, 1e-14);
        check_near(z, 0.0, 1e-14);
    }
}

/* As a quadrature it closes in on E[cos delta] = pi (R - 1)/(2 k atan k), from above and slowly: the tails
 * that it leaves out hold 1/(2 m + 2) of D, m rings being about sqrt(n/3). */
static void test_more_points_are_closer(void **state)
{
    (void)state;
    struct rl_ellipsoid e = rl_ellipsoid_make(3.0);
    const double expected = 0.5 * RL_PI * 2.0 / (e.k * e.half_range);
    double last = 1.0;
    for (int n = 4; n <= 1024; n *= 4) {
        fill(3.0, n);
        double mean = 0.0;
        for (int i = 0; i < n; i++)
            mean += pattern[i].weight * pattern[i].x;
        double error = fabs(mean - expected);
        assert_true(error < last);
        last = error;
    }
    assert_true(last < 0.02);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_count),
        cmocka_unit_test(test_thirteen),
        cmocka_unit_test(test_no_side_is_favoured),
        cmocka_unit_test(test_more_points_are_closer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
