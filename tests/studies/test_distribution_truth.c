/* What the study `distribution` holds normal maps against: D integrated is D's closed form. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "model/vec3.h"
#include "studies/distribution.h"
#include "support/check.h"

/* U(delta), the median and the root mean square sine as the formulas of src/model/ellipsoid.h give them: with h = sqrt(R^2 - 1) or, below 1,
 * sqrt(1 - R^2), and atan or atanh, U = 1/2 + atan(h sin delta)/(2 atan h), and the mean of sin^2 is (h/atan h - 1)/h^2 or
 * (1 - h/atanh h)/h^2; at R = 1, (1 + sin delta)/2 and 1/3. */
static void truth_is_d(void **state)
{
    (void)state;
    static const double rr[] = {0.01, 0.3, 0.999, 1.0, 1.001, 2.0, 30.0, 1000.0, 1e6};
    for (size_t i = 0; i < sizeof rr / sizeof rr[0]; i++) {
        struct rl_distribution_truth t;
        rl_distribution_truth_make(&t, rr[i]);
        double h = sqrt(fabs(rr[i] - 1.0) * (rr[i] + 1.0)), range = rr[i] < 1.0 ? atanh(h) : atan(h);
        for (int k = -200; k <= 200; k++) {
            /* From 1e-9 to the end, and as close to it. */
            double small = pow(10.0, -9.0 * (fabs((double)k) - 1.0) / 199.0) * 0.5 * RL_PI,
                   delta = k % 2 ? small : 0.5 * RL_PI - small;
            double s = copysign(sin(delta), k), expected = 0.5 + 0.5 * s;
            if (k == 0)
                s = 0.0, expected = 0.5;
            else if (h > 0.0)
                expected = 0.5 + 0.5 * (rr[i] < 1.0 ? atanh(h * s) : atan(h * s)) / range;
            check_near(rl_distribution_truth_cdf(&t, s, k ? cos(delta) : 1.0), expected, 1e-10);
        }
        double median = h == 0.0 ? 0.5 : (rr[i] < 1.0 ? tanh(0.5 * range) : tan(0.5 * range)) / h;
        check_relative(sin(t.median), median, 1e-9);
        double square = h == 0.0 ? 1.0 / 3.0 : (rr[i] < 1.0 ? 1.0 - h / range : h / range - 1.0) / (h * h);
        check_relative(t.rms_sine, sqrt(square), 1e-9);
    }
}

/* Shares of a half space back from the angles they are within. */
static void quantiles_invert(void **state)
{
    (void)state;
    static const double rr[] = {0.01, 1.0, 30.0, 1e6}, inner[] = {0.0, 1e-6, 0.3, 0.5, 0.999, 1.0};
    for (size_t i = 0; i < sizeof rr / sizeof rr[0]; i++) {
        struct rl_distribution_truth t;
        rl_distribution_truth_make(&t, rr[i]);
        for (size_t k = 0; k < sizeof inner / sizeof inner[0]; k++) {
            double delta = rl_distribution_truth_quantile(&t, inner[k]);
            check_near(2.0 * rl_distribution_truth_cdf(&t, sin(delta), cos(delta)) - 1.0, inner[k], 1e-10);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(truth_is_d),
        cmocka_unit_test(quantiles_invert),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
