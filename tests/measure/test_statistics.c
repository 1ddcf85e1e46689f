/* Intervals: against tables, by hand, at the edges, and whether they hold as often as they claim. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "measure/noise.h"
#include "measure/statistics.h"
#include "measure/sum.h"
#include "support/check.h"

static void assert_unknown(struct rl_interval i)
{
    assert_true(isnan(i.value) && isnan(i.low) && isnan(i.high));
}

/* Ranks (from 1) of the order statistics that span the interval: exact binomial sums (Python fractions). 0: the smallest and the largest
 * of n miss the median with 2^(1-n), which is more than the level leaves, and there is no interval but the whole line. */
static void test_median_ranks(void **state)
{
    (void)state;
    static const struct {
        size_t n;
        double level;
        int low, high;
    } cases[] = {
        {1, 0.95, 0, 0},     {2, 0.95, 0, 0},        {3, 0.95, 0, 0},     {4, 0.95, 0, 0},
        {5, 0.95, 0, 0},     {5, 0.93, 1, 5},        {1, 0.5, 0, 0},      {2, 0.49, 1, 2},
        {6, 0.95, 1, 6},     {7, 0.95, 1, 7},        {10, 0.95, 2, 9},    {20, 0.95, 6, 15},
        {25, 0.95, 8, 18},   {30, 0.95, 10, 21},     {100, 0.95, 40, 61}, {1000, 0.95, 469, 532},
        {6, 0.99, 0, 0},     {7, 0.99, 0, 0},        {8, 0.99, 1, 8},     {20, 0.99, 4, 17},
        {100, 0.99, 37, 64}, {1000, 0.99, 459, 542},
    };
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; c++) {
        size_t n = cases[c].n;
        double samples[1000] = {0};
        double before[1000];
        /* 1 to n, out of order: 7 has no factor in common with any n above but 7. */
        for (size_t i = 0; i < n; i++)
            samples[i] = n == 7 ? (double)(7 - i) : (double)(i * 7 % n + 1);
        memcpy(before, samples, sizeof before);
        struct rl_interval m = rl_median_interval(samples, n, cases[c].level);
        check_near(m.value, 0.5 * (double)(n + 1), 0.0);
        if (cases[c].low > 0) {
            check_near(m.low, cases[c].low, 0.0);
            check_near(m.high, cases[c].high, 0.0);
        } else if (m.low != -INFINITY || m.high != INFINITY) {
            fail_msg("%zu samples at %g: [%g, %g], expected the whole line", n, cases[c].level, m.low,
                     m.high);
        }
        assert_memory_equal(samples, before, n * sizeof *samples);
    }
}

/* Times as clocks give them: one alone, all the same, none at all by the clock's tick, a step. Whatever is said is exact, or unknown: NaN,
 * NaN, NaN; never one without the others. */
static void test_times(void **state)
{
    (void)state;
    static const double same[] = {2.5, 2.5, 2.5, 2.5, 2.5, 2.5}, zero[6] = {0.0},
                        step[] = {2.0, 2.0, 2.0, -1e9, 2.0, 2.0, 2.0, 2.0, 2.0},
                        late[] = {2.0, 2.0, 2.0, 1e9, 2.0, 2.0, 2.0, 2.0, 2.0};
    static const struct {
        const double *a, *b; /* b: median of a/b; NULL: of a */
        size_t n;
        double value, low, high;
    } row[] = {
        {same, NULL, 1, 2.5, -INFINITY, INFINITY},
        {same, NULL, 2, 2.5, -INFINITY, INFINITY},
        {same, NULL, 5, 2.5, -INFINITY, INFINITY},
        {same, NULL, 6, 2.5, 2.5, 2.5},
        {zero, NULL, 5, 0.0, -INFINITY, INFINITY},
        {zero, NULL, 6, 0.0, 0.0, 0.0},
        {step, NULL, 9, 2.0, 2.0, 2.0}, /* ranks 2 and 8 of 9: one step moves neither */
        {late, NULL, 9, 2.0, 2.0, 2.0},
        {step, NULL, 6, 2.0, -1e9, 2.0}, /* ranks 1 and 6 */
        {same, same, 6, 1.0, 1.0, 1.0},
        {same, same, 1, 1.0, -INFINITY, INFINITY},
        {zero, same, 6, 0.0, 0.0, 0.0},
        {same, zero, 6, INFINITY, INFINITY, INFINITY}, /* longer than nothing */
        {zero, zero, 6, NAN, NAN, NAN},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_interval m = row[i].b ? rl_ratio_interval(row[i].a, row[i].b, row[i].n, 0.95)
                                        : rl_median_interval(row[i].a, row[i].n, 0.95);
        const double found[] = {m.value, m.low, m.high}, expected[] = {row[i].value, row[i].low, row[i].high};
        for (int k = 0; k < 3; k++)
            if (isnan(expected[k]) ? !isnan(found[k]) : found[k] != expected[k])
                fail_msg("row %zu: %g [%g, %g], expected %g [%g, %g]", i, m.value, m.low, m.high,
                         row[i].value, row[i].low, row[i].high);
    }
    struct rl_interval m = rl_interval_from_0(rl_median_interval(same, 2, 0.95));
    assert_true(m.value == 2.5 && m.low == 0.0 && m.high == INFINITY);
    m = rl_interval_from_0(rl_median_interval(same, 6, 0.95));
    assert_true(m.value == 2.5 && m.low == 2.5 && m.high == 2.5);
    assert_unknown(rl_interval_from_0(rl_median_interval(same, 0, 0.95)));
    m = rl_mean_interval(same, 6, 0.95);
    assert_true(m.value == 2.5 && m.low == 2.5 && m.high == 2.5);
}

static void test_median_edges(void **state)
{
    (void)state;
    const double samples[] = {3.0, INFINITY, -INFINITY, 2.0, 1.0};
    const double with_nan[] = {3.0, NAN, 1.0};
    struct rl_interval m = rl_median_interval(samples, 5, 0.95);
    check_near(m.value, 2.0, 0.0);
    assert_true(isinf(m.low) && m.low < 0.0 && isinf(m.high) && m.high > 0.0);
    m = rl_median_interval((const double[]){INFINITY, INFINITY}, 2, 0.95);
    assert_true(isinf(m.value) && m.value > 0.0);
    m = rl_median_interval((const double[]){1.6e308, 1.7e308}, 2, 0.95);
    check_relative(m.value, 1.65e308, 1e-15);
    assert_unknown(rl_median_interval(with_nan, 3, 0.95));
    assert_unknown(rl_median_interval(NULL, 0, 0.95));
    assert_unknown(rl_median_interval(samples, 5, 0.0));
    assert_unknown(rl_median_interval(samples, 5, 1.0));
    assert_unknown(rl_median_interval(samples, 5, NAN));
}

/* Student's t from the incomplete beta function in 25 digits (mpmath). */
static void test_student_factor(void **state)
{
    (void)state;
    static const struct {
        double level, freedom, factor;
    } cases[] = {
        {0.95, 1.0, 12.70620473617470}, {0.95, 4.0, 2.776445105197794},  {0.95, 10.0, 2.228138851986275},
        {0.99, 5.0, 4.032142983555228}, {0.95, 63.0, 1.998340542520742},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        check_relative(rl_student_factor(cases[i].level, cases[i].freedom), cases[i].factor, 1e-12);
}

static void test_mean(void **state)
{
    (void)state;
    /* variance 2.5, half width 2.776445105 sqrt(2.5/5) */
    const double samples[] = {5.0, 1.0, 4.0, 2.0, 3.0};
    struct rl_interval m = rl_mean_interval(samples, 5, 0.95);
    check_near(m.value, 3.0, 1e-15);
    check_near(m.low, 3.0 - 1.963243161475, 1e-11);
    check_near(m.high, 3.0 + 1.963243161475, 1e-11);
    m = rl_mean_interval(samples, 1, 0.95);
    check_near(m.value, 5.0, 0.0);
    assert_true(isinf(m.low) && m.low < 0.0 && isinf(m.high) && m.high > 0.0);
    assert_unknown(rl_mean_interval(samples, 0, 0.95));
    assert_unknown(rl_mean_interval((const double[]){1.0, NAN}, 2, 0.95));
    assert_unknown(rl_mean_interval(samples, 5, 1.5));
    /* A large offset costs no digits of the spread. */
    const double offset[] = {1e9 + 1.0, 1e9 + 2.0, 1e9 + 3.0, 1e9 + 4.0, 1e9 + 5.0};
    m = rl_mean_interval(offset, 5, 0.95);
    check_near(m.high - m.value, 1.963243161475, 1e-6);
}

static void test_pairs(void **state)
{
    (void)state;
    const double a[] = {2.0, 30.0, 8.0, 500.0, 12.0, 6.0};
    const double b[] = {1.0, 10.0, 2.0, 100.0, 2.0, 4.0};
    /* ratios 2 3 4 5 6 1.5; differences 1 20 6 400 10 2. The ratio of the medians would be 10/3. */
    struct rl_interval r = rl_ratio_interval(a, b, 6, 0.95);
    check_near(r.value, 3.5, 0.0);
    check_near(r.low, 1.5, 0.0);
    check_near(r.high, 6.0, 0.0);
    struct rl_interval d = rl_difference_interval(a, b, 6, 0.95);
    check_near(d.value, 8.0, 0.0);
    check_near(d.low, 1.0, 0.0);
    check_near(d.high, 400.0, 0.0);
    assert_unknown(rl_ratio_interval((const double[]){0.0}, (const double[]){0.0}, 1, 0.95));
    assert_unknown(rl_ratio_interval(a, b, 0, 0.95));
    assert_unknown(rl_difference_interval(a, b, 0, 0.95));
}

static void test_slope(void **state)
{
    (void)state;
    const double n[] = {1.0, 4.0, 16.0, 64.0, 256.0, 1024.0};
    double error[6];
    for (int i = 0; i < 6; i++)
        error[i] = 0.3 / sqrt(n[i]);
    struct rl_interval s = rl_loglog_slope(n, error, 6, 0.95);
    check_near(s.value, -0.5, 1e-14);
    check_near(s.low, -0.5, 1e-6);
    check_near(s.high, -0.5, 1e-6);

    /* logs 0, 1, 2 against 0, 1, 1: slope 1/2, residuals -1/6, 1/3, -1/6, its variance 1/12; t with 1 degree
     * of freedom */
    const double x[] = {1.0, exp(1.0), exp(2.0)};
    const double y[] = {1.0, exp(1.0), exp(1.0)};
    s = rl_loglog_slope(x, y, 3, 0.95);
    check_near(s.value, 0.5, 1e-14);
    check_near(s.high - s.value, 12.70620473617470 / sqrt(12.0), 1e-10);
    check_near(s.value - s.low, 12.70620473617470 / sqrt(12.0), 1e-10);

    assert_unknown(rl_loglog_slope(x, y, 2, 0.95));
    assert_unknown(rl_loglog_slope(NULL, NULL, 0, 0.95));
    assert_unknown(rl_loglog_slope(x, y, 3, 0.0));
    assert_unknown(rl_loglog_slope((const double[]){2.0, 2.0, 2.0}, y, 3, 0.95));
    static const double bad[] = {0.0, -1.0, INFINITY, NAN};
    for (int i = 0; i < 4; i++) {
        const double values[] = {1.0, 2.0, bad[i]};
        assert_unknown(rl_loglog_slope(values, y, 3, 0.95));
        assert_unknown(rl_loglog_slope(y, values, 3, 0.95));
    }
}

/* How often intervals of samples with mean and median 10 hold: 95 % or, the median's ranks being whole, a
 * little more. Bounds are four standard deviations of 2000 trials. */
static void test_intervals_hold(void **state)
{
    (void)state;
    enum { TRIALS = 2000, N = 15 };
    const uint64_t seed = 20260101;
    printf("seed %llu\n", (unsigned long long)seed);
    int median_holds = 0;
    int mean_holds = 0;
    int slope_holds = 0;
    for (int t = 0; t < TRIALS; t++) {
        double samples[N];
        double x[N];
        double y[N];
        for (int i = 0; i < N; i++) {
            samples[i] = 10.0 + noise(seed, (uint64_t)t * N + (uint64_t)i);
            x[i] = i + 1.0;
            y[i] = pow(x[i], -0.5) * exp(0.1 * (samples[i] - 10.0));
        }
        struct rl_interval m = rl_median_interval(samples, N, 0.95);
        median_holds += m.low <= 10.0 && 10.0 <= m.high;
        m = rl_mean_interval(samples, N, 0.95);
        mean_holds += m.low <= 10.0 && 10.0 <= m.high;
        m = rl_loglog_slope(x, y, N, 0.95);
        slope_holds += m.low <= -0.5 && -0.5 <= m.high;
    }
    check_near(median_holds / (double)TRIALS, 0.9648, 4.0 * 0.0042); /* ranks 4 and 12 of 15 */
    check_near(mean_holds / (double)TRIALS, 0.95, 4.0 * 0.0049);
    check_near(slope_holds / (double)TRIALS, 0.95, 4.0 * 0.0049);
}

static void test_sum(void **state)
{
    (void)state;
    /* 1 + 1e100 + 1 - 1e100 is 2; added up plainly, 0 (Neumaier's own example). */
    const double terms[] = {1.0, 1e100, 1.0, -1e100};
    struct rl_sum sum = {0};
    for (int i = 0; i < 4; i++)
        rl_sum_add(&sum, terms[i]);
    check_near(rl_sum_value(&sum), 2.0, 0.0);

    struct rl_sum tenths = {0};
    for (int i = 0; i < 10000000; i++)
        rl_sum_add(&tenths, 0.1);
    check_relative(rl_sum_value(&tenths), 1e6, 1e-15);

    struct rl_sum infinite = {0};
    rl_sum_add(&infinite, 1.0);
    rl_sum_add(&infinite, INFINITY);
    rl_sum_add(&infinite, 1.0);
    assert_true(isinf(rl_sum_value(&infinite)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_median_ranks), cmocka_unit_test(test_median_edges),
        cmocka_unit_test(test_times),        cmocka_unit_test(test_student_factor),
        cmocka_unit_test(test_mean),         cmocka_unit_test(test_pairs),
        cmocka_unit_test(test_slope),        cmocka_unit_test(test_intervals_hold),
        cmocka_unit_test(test_sum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
