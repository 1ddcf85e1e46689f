/* Verdicts: figures worked out by hand, every kind of change, and whether alarms are as rare as they are said to be. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "measure/goodness.h"
#include "measure/noise.h"
#include "measure/regression.h"
#include "support/check.h"

static void means(void **state)
{
    (void)state;
    static const double value[] = {1.0, 2.0, 3.0, 6.0};
    struct rl_mean m = rl_mean_of(value, 4);
    check_near(m.value, 3.0, 0.0);
    check_near(m.deviation, sqrt(14.0 / 3.0), 1e-15);
    assert_true(m.n == 4);
    m = rl_mean_of(value, 1);
    check_near(m.value, 1.0, 0.0);
    check_near(m.deviation, 0.0, 0.0);
    assert_true(isnan(rl_mean_of((const double[]){1.0, NAN}, 2).value));
}

/* Both deviate by 2: the standard error is 2 sqrt(1/4 + 1/4) = sqrt(2), t = 3/sqrt(2) with 6 degrees of freedom. p and the factor of 95 %
 * by mpmath's incomplete beta function. */
static void random_by_hand(void **state)
{
    (void)state;
    const struct rl_mean before = {10.0, 2.0, 4}, now = {13.0, 2.0, 4};
    struct rl_regression r;
    rl_regression_random(&r, &before, &now, RL_BEST_LOWER, 9.0, 0.05);
    check_near(r.change, 3.0, 0.0);
    check_near(r.p, 0.07814074941121586, 1e-14);
    check_near(r.half_width, 2.44691185114497 * sqrt(2.0), 1e-11);
    check_near(r.detectable, (2.44691185114497 + 1.2815515655446) * sqrt(2.0), 1e-11);
    assert_int_equal(r.verdict, RL_CHANGE_SAME);
    /* A pooled deviation: (3 x 4 + 1 x 9)/4 = 5.25, and 1/4 + 1/2. */
    const struct rl_mean wider = {10.0, 3.0, 2};
    rl_regression_random(&r, &before, &wider, RL_BEST_LOWER, 9.0, 0.05);
    check_near(r.half_width, 2.7764451051977987 * sqrt(5.25 * 0.75), 1e-11); /* Student's t, 4 degrees */
    check_near(r.p, 1.0, 0.0);
}

static void verdicts_of_random(void **state)
{
    (void)state;
    /* The standard error is 0.1 x sqrt(1/50 + 1/50) = 0.02, the half width at 1 % 0.0525. */
    static const struct {
        double before, now, relevant;
        enum rl_best best;
        enum rl_change verdict;
    } row[] = {
        {1.0, 1.0, 0.1, RL_BEST_LOWER, RL_CHANGE_SAME},
        {1.0, 1.04, 0.1, RL_BEST_LOWER, RL_CHANGE_SAME},
        {1.0, 1.05, 0.1, RL_BEST_LOWER, RL_CHANGE_INCONCLUSIVE}, /* 0.1025 is in the interval */
        {1.0, 1.0, 0.05, RL_BEST_LOWER, RL_CHANGE_INCONCLUSIVE},
        {1.0, 1.06, 0.1, RL_BEST_LOWER, RL_CHANGE_WORSE},
        {1.0, 1.06, 1.0, RL_BEST_LOWER, RL_CHANGE_WORSE}, /* found, though it does not matter */
        {1.0, 0.94, 0.1, RL_BEST_LOWER, RL_CHANGE_BETTER},
        {1.0, 1.06, 0.1, RL_BEST_ZERO, RL_CHANGE_WORSE},
        {1.0, 0.94, 0.1, RL_BEST_ZERO, RL_CHANGE_BETTER},
        {-1.0, -1.06, 0.1, RL_BEST_ZERO, RL_CHANGE_WORSE},
        {-1.0, -0.94, 0.1, RL_BEST_ZERO, RL_CHANGE_BETTER},
        {-0.1, 0.1, 0.1, RL_BEST_ZERO, RL_CHANGE_WORSE},
        {1.0, 1.06, 0.1, RL_BEST_SAME, RL_CHANGE_WORSE},
        {1.0, 0.94, 0.1, RL_BEST_SAME, RL_CHANGE_WORSE},
        {1.0, NAN, 0.1, RL_BEST_LOWER, RL_CHANGE_WORSE},
        {1.0, INFINITY, 0.1, RL_BEST_LOWER, RL_CHANGE_WORSE},
        {1.0, -INFINITY, 0.1, RL_BEST_LOWER, RL_CHANGE_WORSE},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        const struct rl_mean before = {row[i].before, 0.1, 50}, now = {row[i].now, 0.1, 50};
        struct rl_regression r;
        rl_regression_random(&r, &before, &now, row[i].best, row[i].relevant, 0.01);
        if (r.verdict != row[i].verdict)
            print_error("row %zu: ", i);
        assert_string_equal(rl_change_name(r.verdict), rl_change_name(row[i].verdict));
    }
}

/* A mean may stay what it was by chance where the seeds have lost their effect; the deviation does not. */
static void seeds_without_effect(void **state)
{
    (void)state;
    const struct rl_mean before = {1.0, 0.1, 50}, now = {1.0, 0.0, 8}, none = {1.0, 0.0, 50};
    struct rl_regression r;
    rl_regression_random(&r, &before, &now, RL_BEST_LOWER, 0.5, 0.01);
    assert_int_equal(r.verdict, RL_CHANGE_WORSE);
    assert_non_null(strstr(r.reason, "seeds"));
    rl_regression_random(&r, &none, &now, RL_BEST_LOWER, 0.5, 0.01);
    assert_int_equal(r.verdict, RL_CHANGE_SAME);
    check_near(r.p, 1.0, 0.0);
}

static void verdicts_of_fixed(void **state)
{
    (void)state;
    static const struct {
        double before, now, tolerance;
        enum rl_best best;
        enum rl_change verdict;
    } row[] = {
        {1.0, 1.0, 0.0, RL_BEST_SAME, RL_CHANGE_SAME},
        {1.0, 1.5, 0.5, RL_BEST_SAME, RL_CHANGE_SAME},
        {1.0, 0.5, 0.5, RL_BEST_SAME, RL_CHANGE_SAME},
        {1.0, 0.0, 0.5, RL_BEST_SAME, RL_CHANGE_WORSE},
        {1.0, 0.0, 0.5, RL_BEST_LOWER, RL_CHANGE_BETTER},
        {1.0, 2.0, 0.5, RL_BEST_LOWER, RL_CHANGE_WORSE},
        {-1.0, -2.0, 0.5, RL_BEST_ZERO, RL_CHANGE_WORSE},
        {-1.0, 0.0, 0.5, RL_BEST_ZERO, RL_CHANGE_BETTER},
        {1.0, 1.0 + 1e-15, 0.0, RL_BEST_LOWER, RL_CHANGE_WORSE},
        {1.0, NAN, 0.5, RL_BEST_LOWER, RL_CHANGE_WORSE},
        {1.0, -INFINITY, 0.5, RL_BEST_LOWER, RL_CHANGE_WORSE},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_regression r;
        rl_regression_fixed(&r, row[i].before, row[i].now, row[i].best, row[i].tolerance);
        if (r.verdict != row[i].verdict)
            print_error("row %zu: ", i);
        assert_string_equal(rl_change_name(r.verdict), rl_change_name(row[i].verdict));
        assert_true(isnan(r.p));
    }
}

enum { BEFORE = 64, NOW = 8, TRIES = 2000 };

static struct rl_mean draw(uint64_t seed, size_t n, double mean)
{
    double value[BEFORE];
    for (size_t i = 0; i < n; i++)
        value[i] = mean + noise(seed, i);
    return rl_mean_of(value, n);
}

/* Nothing has changed: p is uniform, and 5 % of verdicts at the level 0.05 are alarms. Something has, by what is said to be detectable:
 * 90 % are. Seeds 1 to 6000. */
static void as_often_as_said(void **state)
{
    (void)state;
    struct rl_goodness p;
    assert_int_equal(rl_goodness_make(&p, 1000, NULL), RL_OK);
    size_t alarms = 0, found = 0;
    for (uint64_t k = 0; k < TRIES; k++) {
        struct rl_mean before = draw(3 * k + 1, BEFORE, 5.0), now = draw(3 * k + 2, NOW, 5.0);
        struct rl_regression r;
        rl_regression_random(&r, &before, &now, RL_BEST_SAME, 10.0, 0.05);
        rl_goodness_add(&p, r.p);
        alarms += r.verdict == RL_CHANGE_WORSE;
        /* 3.28 standard errors of a deviation that is 1: (t + 1.2816) x sqrt(1/64 + 1/8), t = 1.9944 of 70 degrees */
        now = draw(3 * k + 3, NOW, 5.0 + (1.9944 + 1.2816) * sqrt(1.0 / BEFORE + 1.0 / NOW));
        rl_regression_random(&r, &before, &now, RL_BEST_SAME, 10.0, 0.05);
        found += r.verdict == RL_CHANGE_WORSE;
    }
    double distance = rl_goodness_kolmogorov(&p, 0.95).value;
    rl_goodness_clear(&p);
    assert_true(rl_kolmogorov_p(distance, TRIES) > 0.01);
    check_near((double)alarms / TRIES, 0.05, 3.0 * sqrt(0.05 * 0.95 / TRIES));
    check_near((double)found / TRIES, 0.90,
               3.0 * sqrt(0.9 * 0.1 / TRIES) + 0.01); /* t is shifted, not normal */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(means),
        cmocka_unit_test(random_by_hand),
        cmocka_unit_test(verdicts_of_random),
        cmocka_unit_test(seeds_without_effect),
        cmocka_unit_test(verdicts_of_fixed),
        cmocka_unit_test(as_often_as_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
