/* Tests of fit: figures worked out by hand, p uniform where the samples follow, misfits found. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "measure/goodness.h"
#include "model/random.h"
#include "support/check.h"

static void counts_by_hand(void **state)
{
    (void)state;
    /* 3, 1, 4, 2 in quarters: expected 2.5, sum (0.25 + 2.25 + 2.25 + 0.25)/2.5 = 2; cdf 0.3, 0.4, 0.8 against 0.25, 0.5, 0.75. */
    static const double values[] = {0.1, 0.2, 0.2499, 0.3, 0.5, 0.6, 0.7, 0.74, 0.75, 1.0};
    struct rl_goodness g;
    assert_int_equal(rl_goodness_make(&g, 8, NULL), RL_OK);
    for (size_t i = 0; i < 10; i++)
        rl_goodness_add(&g, values[i]);
    struct rl_chi_square c = rl_goodness_chi_square(&g, 4);
    check_near(c.statistic, 2.0, 1e-12);
    check_near(c.freedom, 3.0, 0.0);
    check_near(c.p, 0.57240670447087982,
               1e-12); /* Q of chi-square 2, 3 degrees: erfc(1) + 2/sqrt(pi) exp(-1) */
    check_near(c.phi2, -0.1, 1e-12);
    double ratio[4];
    rl_goodness_ratios(ratio, &g, 4);
    check_near(ratio[2], 1.6, 1e-12);
    /* In eighths the cdf is 0.1 0.3 0.4 0.4 0.6 0.8 0.9; farthest from the line at 1/2. */
    struct rl_interval k = rl_goodness_kolmogorov(&g, 0.95);
    check_near(k.value, 0.1, 1e-12);
    check_near(k.high, 0.1 + sqrt(log(40.0) / 20.0), 1e-12);
    check_near(k.low, 0.0, 0.0);
    rl_goodness_clear(&g);
}

static void ends_are_counted(void **state)
{
    (void)state;
    struct rl_goodness g;
    assert_int_equal(rl_goodness_make(&g, 2, NULL), RL_OK);
    assert_true(isnan(rl_goodness_chi_square(&g, 2).p));
    assert_true(isnan(rl_goodness_kolmogorov(&g, 0.95).value));
    rl_goodness_add(&g, -0.1);
    rl_goodness_add(&g, NAN);
    rl_goodness_add(&g, 1.0);
    rl_goodness_add(&g, 1.1);
    assert_true(g.count[0] == 2 && g.count[1] == 2 && g.n == 4);
    rl_goodness_clear(&g);
}

/* lambda = (sqrt(n) + 0.12 + 0.11/sqrt(n)) D; the limit's series by mpmath. */
static void kolmogorov_p(void **state)
{
    (void)state;
    const double scale = 10.0 + 0.12 + 0.011;
    check_near(rl_kolmogorov_p(1.3581 / scale, 100), 0.049999630431667426, 1e-12);
    check_near(rl_kolmogorov_p(1.6276 / scale, 100), 0.010001537333060768, 1e-12);
    check_near(rl_kolmogorov_p(0.5 / scale, 100), 0.9639452436648751, 1e-12);
    check_near(rl_kolmogorov_p(0.2 / scale, 100), 1.0, 0.0);
    check_near(rl_kolmogorov_p(0.0, 100), 1.0, 0.0);
    assert_true(rl_kolmogorov_p(1.0, 100) < 1e-80);
}

static void sidak(void **state)
{
    (void)state;
    check_near(rl_sidak_level(0.05, 1.0), 0.05, 1e-15);
    check_near(rl_sidak_level(0.19, 2.0), 0.1, 1e-15);
    check_relative(rl_sidak_level(0.01, 1e6), -log(0.99) * 1e-6, 1e-7);
    check_near(rl_sidak_p(0.1, 2.0), 0.19, 1e-15);
    check_near(rl_sidak_p(1.0, 5.0), 1.0, 0.0);
    check_near(rl_sidak_p(rl_sidak_level(0.01, 77.0), 77.0), 0.01, 1e-15);
}

/* p of uniform samples is uniform: 400 of them are below 1/2 half the time and below 0.01 seldom. A bin that has 5 % too much is found. */
static void p_is_fair(void **state)
{
    (void)state;
    int half = 0;
    int hundredth = 0;
    for (uint64_t seed = 0; seed < 400; seed++) {
        struct rl_goodness g;
        assert_int_equal(rl_goodness_make(&g, 64, NULL), RL_OK);
        for (uint64_t i = 0; i < 4096; i++)
            rl_goodness_add(&g, rl_random_uniform(seed, i));
        double p = rl_goodness_chi_square(&g, 64).p;
        half += p < 0.5;
        hundredth += p < 0.01;
        rl_goodness_clear(&g);
    }
    assert_in_range(half, 160, 240); /* 4 standard deviations */
    assert_in_range(hundredth, 0, 12);
    struct rl_goodness g;
    assert_int_equal(rl_goodness_make(&g, 64, NULL), RL_OK);
    for (uint64_t i = 0; i < 262144; i++) {
        double u = rl_random_uniform(7, i);
        rl_goodness_add(&g, u);
        if (u < 1.0 / 64 && rl_random_uniform(8, i) < 0.1)
            rl_goodness_add(&g, u);
    }
    assert_true(rl_goodness_chi_square(&g, 64).p < 1e-4);
    assert_true(rl_goodness_chi_square(&g, 64).phi2 > 1e-4);
    rl_goodness_clear(&g);
}

/* The non-central chi-square's cdf as it is defined: a Poisson mixture of central ones. */
static double mixture(double x, double freedom, double lambda)
{
    double sum = 0.0;
    unsigned last = (unsigned)(0.5 * lambda + 12.0 * sqrt(lambda) + 40.0);
    for (unsigned i = 0; i <= last; i++)
        sum += gsl_ran_poisson_pdf(i, 0.5 * lambda) * gsl_cdf_chisq_P(x, freedom + 2.0 * i);
    return sum;
}

/* Counts n (1 +- w)/64 in turn: the misfit is w but for the chance that is taken off, and its ends are where the mixture has them. */
static void misfit_by_the_mixture(void **state)
{
    (void)state;
    static const double off[] = {0.015625, 0.03125, 0.25, 0.875}; /* whole counts */
    for (size_t i = 0; i < sizeof off / sizeof off[0]; i++) {
        struct rl_goodness g;
        assert_int_equal(rl_goodness_make(&g, 64, NULL), RL_OK);
        for (size_t b = 0; b < 64; b++) {
            g.count[b] = (uint64_t)(4096.0 * (1.0 + (b % 2 ? off[i] : -off[i])));
            g.n += g.count[b];
        }
        double n = (double)g.n, statistic = n * off[i] * off[i];
        struct rl_interval m = rl_goodness_misfit(&g, 64, 0.95);
        check_near(m.value, sqrt(off[i] * off[i] - 63.0 / n < 0.0 ? 0.0 : off[i] * off[i] - 63.0 / n), 1e-12);
        check_near(mixture(fmax(statistic, 63.0), 63.0, n * m.high * m.high), 0.025, 0.001);
        if (m.low > 0.0)
            check_near(mixture(statistic, 63.0, n * m.low * m.low), 0.975, 0.001);
        else
            assert_true(gsl_cdf_chisq_P(statistic, 63.0) < 0.975);
        rl_goodness_clear(&g);
    }
    struct rl_goodness none;
    assert_int_equal(rl_goodness_make(&none, 64, NULL), RL_OK);
    assert_true(isnan(rl_goodness_misfit(&none, 64, 0.95).value));
    rl_goodness_clear(&none);
}

/* Samples that fit, that misfit by little, and that crowd into a few bins, for which the non-central chi-square alone is too sure: the
 * interval holds the truth in 95 % of 1000 seeds, to 4 standard deviations. Fewer samples never make a smaller upper end. */
static void misfit_is_covered(void **state)
{
    (void)state;
    static const double crowded[] = {0.0, 0.05,
                                     0.5}; /* this share of the samples goes to the first two bins of 16 */
    for (size_t i = 0; i < sizeof crowded / sizeof crowded[0]; i++) {
        int held = 0;
        double ratio = crowded[i] * 8.0 + 1.0 - crowded[i], rest = 1.0 - crowded[i];
        double truth =
            sqrt((2.0 * (ratio - 1.0) * (ratio - 1.0) + 14.0 * (rest - 1.0) * (rest - 1.0)) / 16.0);
        for (uint64_t seed = 0; seed < 1000; seed++) {
            struct rl_goodness g;
            assert_int_equal(rl_goodness_make(&g, 16, NULL), RL_OK);
            for (uint64_t k = 0; k < 2000; k++) {
                double u = rl_random_uniform(seed, 2 * k);
                rl_goodness_add(&g, rl_random_uniform(seed, 2 * k + 1) < crowded[i] ? u / 8.0 : u);
            }
            struct rl_interval m = rl_goodness_misfit(&g, 16, 0.95);
            held += m.low <= truth + 1e-12 && truth <= m.high;
            assert_true(m.low <= m.value && m.value <= m.high);
            assert_true(m.high > 0.05); /* 2000 samples, however well they fit, show no less */
            rl_goodness_clear(&g);
        }
        if (held < 922)
            fail_msg("crowded by %g: the interval holds the truth in %d of 1000", crowded[i], held);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(counts_by_hand),    cmocka_unit_test(ends_are_counted),
        cmocka_unit_test(kolmogorov_p),      cmocka_unit_test(sidak),
        cmocka_unit_test(p_is_fair),         cmocka_unit_test(misfit_by_the_mixture),
        cmocka_unit_test(misfit_is_covered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
