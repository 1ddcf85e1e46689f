/* Fits: exact data, figures worked out by hand, what has no answer, and whether intervals hold as often as they claim. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "measure/fit.h"
#include "measure/noise.h"
#include "support/check.h"

/* Terms of very different size, as times have them: 1, pixels, pixels x samples. */
static void test_exact(void **state)
{
    (void)state;
    static const double x[5][3] = {{1, 76800, 307200},
                                   {1, 307200, 307200},
                                   {1, 307200, 1228800},
                                   {1, 2073600, 8294400},
                                   {1, 2073600, 0}};
    static const double c[3] = {0.75, 2e-6, 1.25e-5};
    double y[5];
    for (int i = 0; i < 5; i++)
        y[i] = c[0] * x[i][0] + c[1] * x[i][1] + c[2] * x[i][2];
    struct rl_fit fit = rl_fit_least_squares(&x[0][0], y, NULL, 5, 3, 0.95);
    for (int k = 0; k < 3; k++) {
        check_near(fit.coefficient[k].value, c[k], 1e-11 * c[k]);
        assert_true(fit.coefficient[k].low <= fit.coefficient[k].value * (1.0 + 1e-12));
        assert_true(fit.coefficient[k].high - fit.coefficient[k].low < 1e-9 * c[k]);
    }
    check_near(fit.r2, 1.0, 1e-12);
    check_near(fit.worst.value, 0.0, 1e-11);
    assert_true(isnan(fit.coefficient[3].value));
}

/* x = 0 1 2 3, y = 1 3 2 5: the line 1.1 + 1.1 x, residuals -0.1 0.8 -1.3 0.6, squares 2.7 of 8.75; variance 1.35 of 2 degrees, of the slope
 * 1.35/5, of the constant 1.35 (1/4 + 2.25/5); t of 2 degrees at 95 %: 4.302652729696142. */
static void test_by_hand(void **state)
{
    (void)state;
    static const double x[4][2] = {{1, 0}, {1, 1}, {1, 2}, {1, 3}}, y[4] = {1, 3, 2, 5};
    struct rl_fit fit = rl_fit_least_squares(&x[0][0], y, NULL, 4, 2, 0.95);
    check_near(fit.coefficient[0].value, 1.1, 1e-14);
    check_near(fit.coefficient[1].value, 1.1, 1e-14);
    check_near(fit.coefficient[1].high - 1.1, 4.302652729696142 * sqrt(1.35 / 5.0), 1e-10);
    check_near(1.1 - fit.coefficient[0].low, 4.302652729696142 * sqrt(1.35 * 0.7), 1e-10);
    check_near(fit.r2, 1.0 - 2.7 / 8.75, 1e-14);
    check_near(fit.worst.value, 0.65, 1e-14);
    assert_int_equal(fit.worst_point, 2);
    check_near(fit.residual, sqrt((0.01 + 0.64 / 9.0 + 1.69 / 4.0 + 0.36 / 25.0) / 2.0), 1e-14);

    /* A weight of 3 is the point three times; with equal weights of any size nothing changes. */
    static const double x6[6][2] = {{1, 0}, {1, 1}, {1, 2}, {1, 3}, {1, 3}, {1, 3}},
                        y6[6] = {1, 3, 2, 5, 5, 5};
    static const double weight[4] = {1, 1, 1, 3}, sevens[4] = {7, 7, 7, 7};
    struct rl_fit thrice = rl_fit_least_squares(&x6[0][0], y6, NULL, 6, 2, 0.95);
    struct rl_fit heavy = rl_fit_least_squares(&x[0][0], y, weight, 4, 2, 0.95);
    struct rl_fit scaled = rl_fit_least_squares(&x[0][0], y, sevens, 4, 2, 0.95);
    for (int k = 0; k < 2; k++) {
        check_near(heavy.coefficient[k].value, thrice.coefficient[k].value, 1e-13);
        check_near(scaled.coefficient[k].high, fit.coefficient[k].high, 1e-13);
    }
}

static void check_nothing(struct rl_fit fit)
{
    for (int k = 0; k < RL_FIT_TERMS_MAX; k++)
        assert_true(isnan(fit.coefficient[k].value) && isnan(fit.coefficient[k].low));
    assert_true(isnan(fit.r2) && isnan(fit.residual) && isnan(fit.worst.value) && isnan(fit.worst.high));
}

static void check_refused(struct rl_fit fit, enum rl_fit_refusal refusal)
{
    check_nothing(fit);
    assert_int_equal(fit.refusal, refusal);
}

static void test_no_answer(void **state)
{
    (void)state;
    static const double x[3][2] = {{1, 2}, {1, 3}, {1, 5}}, y[3] = {1, 2, 3};
    static const double same[3][2] = {{1, 2}, {1, 2}, {1, 2}}, none[3][2] = {{1, 0}, {1, 0}, {1, 0}};
    static const double endless[3][2] = {{1, INFINITY}, {1, 3}, {1, 5}}, hole[3] = {1, NAN, 3};
    static const double negative[3] = {1, -1, 1};
    assert_false(isnan(rl_fit_least_squares(&x[0][0], y, NULL, 3, 2, 0.95).r2));
    check_nothing(rl_fit_least_squares(&x[0][0], y, NULL, 2, 2, 0.95));
    check_nothing(rl_fit_least_squares(&x[0][0], y, NULL, 0, 2, 0.95));
    check_nothing(rl_fit_least_squares(&x[0][0], y, NULL, 3, 0, 0.95));
    check_nothing(rl_fit_least_squares(&x[0][0], y, NULL, 3, 2, 1.0));
    check_nothing(rl_fit_least_squares(&same[0][0], y, NULL, 3, 2, 0.95));
    check_nothing(rl_fit_least_squares(&none[0][0], y, NULL, 3, 2, 0.95));
    check_nothing(rl_fit_least_squares(&endless[0][0], y, NULL, 3, 2, 0.95));
    check_nothing(rl_fit_least_squares(&x[0][0], hole, NULL, 3, 2, 0.95));
    check_nothing(rl_fit_least_squares(&x[0][0], y, negative, 3, 2, 0.95));

    static const double one = 1.0, zero = 0.0;
    struct rl_fit_point point[3] = {
        {{1, 2}, &one, NULL, 1, 0}, {{1, 3}, &one, NULL, 1, 0}, {{1, 5}, &one, NULL, 1, 0}};
    check_near(rl_fit_rounds(point, 3, 2, 0.95, 10, 1).coefficient[0].value, 1.0, 1e-13);
    assert_int_equal(rl_fit_rounds(point, 3, 2, 0.95, 10, 1).refusal, RL_FIT_DONE);
    check_refused(rl_fit_rounds(point, 2, 2, 0.95, 10, 1), RL_FIT_FEW_POINTS);
    check_refused(rl_fit_rounds(point, 3, 2, 0.95, 0, 1), RL_FIT_INVALID);
    check_refused(rl_fit_rounds(NULL, 0, 2, 0.95, 10, 1), RL_FIT_FEW_POINTS);
    point[1].minus = &one; /* nothing is left: no relative residual */
    struct rl_fit fit = rl_fit_rounds(point, 3, 2, 0.95, 10, 1);
    check_refused(fit, RL_FIT_NOT_POSITIVE);
    assert_true(fit.refused_point == 1 && fit.refused_y == 0.0);
    point[1].minus = &zero;
    point[2].x[1] = NAN;
    fit = rl_fit_rounds(point, 3, 2, 0.95, 10, 1);
    check_refused(fit, RL_FIT_NOT_FINITE);
    assert_int_equal(fit.refused_point, 2);
    point[2].x[1] = 5.0;
    point[1].n = 0;
    check_refused(rl_fit_rounds(point, 3, 2, 0.95, 10, 1), RL_FIT_NOT_FINITE);
    point[1].n = 1;
    point[1].x[1] = point[2].x[1] = 2.0;
    check_refused(rl_fit_rounds(point, 3, 2, 0.95, 10, 1), RL_FIT_DEPENDENT);
}

/* How often an interval missed the truth, of as many trials. */
static void check_misses(const char *what, int misses, int trials, double least, double most)
{
    double share = (double)misses / trials;
    print_message("%s: missed %d of %d (seeds 1 to %d)\n", what, misses, trials, trials);
    if (share < least || share > most)
        fail_msg("%s: misses %.4f of the time, expected %.3f to %.3f", what, share, least, most);
}

/* Normal noise: Student's intervals are exact, so 5 % miss; 2000 trials give +-1.5 % at three standard deviations. */
static void test_coverage_normal(void **state)
{
    (void)state;
    enum { TRIALS = 2000, N = 6 };
    static const double x[N][2] = {{1, 1}, {1, 2}, {1, 4}, {1, 8}, {1, 16}, {1, 32}};
    double weight[N], y[N];
    int misses[2] = {0, 0};
    for (int i = 0; i < N; i++)
        weight[i] = 1.0 / ((3.0 + 0.5 * x[i][1]) * (3.0 + 0.5 * x[i][1]));
    for (int trial = 1; trial <= TRIALS; trial++) {
        for (int i = 0; i < N; i++)
            y[i] = (3.0 + 0.5 * x[i][1]) * (1.0 + 0.05 * noise((uint64_t)trial, (uint64_t)i));
        struct rl_fit fit = rl_fit_least_squares(&x[0][0], y, weight, N, 2, 0.95);
        misses[0] += 3.0 < fit.coefficient[0].low || 3.0 > fit.coefficient[0].high;
        misses[1] += 0.5 < fit.coefficient[1].low || 0.5 > fit.coefficient[1].high;
    }
    check_misses("Student, constant", misses[0], TRIALS, 0.035, 0.065);
    check_misses("Student, slope", misses[1], TRIALS, 0.035, 0.065);
}

enum { POINTS = 4, ROUNDS = 30 };

/* Frame times: in proportion to themselves, a slow spell of a whole round in common, and a baseline to subtract that has it too. */
struct frames {
    double time[POINTS][ROUNDS], baseline[ROUNDS];
    struct rl_fit_point point[POINTS];
};

static void make_frames(struct frames *f, uint64_t seed, double spread)
{
    static const double x[POINTS] = {1, 2, 5, 10};
    for (int r = 0; r < ROUNDS; r++) {
        double spell = 1.0 + 2.0 * spread * noise(seed, 100 * (uint64_t)r);
        f->baseline[r] = 4.0 * spell * (1.0 + spread * noise(seed, 100 * (uint64_t)r + 1));
        for (int i = 0; i < POINTS; i++)
            f->time[i][r] = (4.0 + 2.0 + 3.0 * x[i]) * spell *
                            (1.0 + spread * noise(seed, 100 * (uint64_t)r + 2 + (uint64_t)i));
    }
    for (int i = 0; i < POINTS; i++)
        f->point[i] = (struct rl_fit_point){{1.0, x[i]}, f->time[i], f->baseline, ROUNDS, 0};
}

/* Rounds drawn again from 30 are as good as asymptotics are: 2.5 to 9 % may miss. */
static void test_coverage_rounds(void **state)
{
    (void)state;
    enum { TRIALS = 400 };
    int misses[2] = {0, 0};
    for (int trial = 1; trial <= TRIALS; trial++) {
        struct frames f;
        make_frames(&f, (uint64_t)trial, 0.02);
        struct rl_fit fit = rl_fit_rounds(f.point, POINTS, 2, 0.95, 300, 7);
        misses[0] += 2.0 < fit.coefficient[0].low || 2.0 > fit.coefficient[0].high;
        misses[1] += 3.0 < fit.coefficient[1].low || 3.0 > fit.coefficient[1].high;
    }
    check_misses("rounds, constant", misses[0], TRIALS, 0.025, 0.09);
    check_misses("rounds, slope", misses[1], TRIALS, 0.025, 0.09);
}

/* Without noise there is nothing to draw; a point that does not obey the model is named. The same seed gives the same. */
static void test_rounds(void **state)
{
    (void)state;
    struct frames f;
    make_frames(&f, 3, 0.0);
    struct rl_fit fit = rl_fit_rounds(f.point, POINTS, 2, 0.95, 50, 1);
    check_near(fit.coefficient[0].low, 2.0, 1e-12);
    check_near(fit.coefficient[1].high, 3.0, 1e-12);
    check_near(fit.worst.high, 0.0, 1e-12);
    for (int r = 0; r < ROUNDS; r++)
        f.time[3][r] += 0.2 * (f.time[3][r] - f.baseline[r]);
    fit = rl_fit_rounds(f.point, POINTS, 2, 0.95, 50, 1);
    assert_true(fit.worst.value > 0.05 && fit.r2 < 0.999);

    make_frames(&f, 3, 0.05);
    fit = rl_fit_rounds(f.point, POINTS, 2, 0.95, 50, 1);
    struct rl_fit again = rl_fit_rounds(f.point, POINTS, 2, 0.95, 50, 1);
    assert_true(fit.coefficient[1].low == again.coefficient[1].low && fit.worst.high == again.worst.high);
    assert_true(fit.coefficient[1].low < fit.coefficient[1].value &&
                fit.coefficient[1].value < fit.coefficient[1].high);
    /* The whole round slow or fast together: in rounds of their own the points' slope is less certain. */
    double width = fit.coefficient[1].high - fit.coefficient[1].low;
    for (int i = 0; i < POINTS; i++)
        f.point[i].block = i;
    again = rl_fit_rounds(f.point, POINTS, 2, 0.95, 50, 1);
    assert_true(again.coefficient[1].high - again.coefficient[1].low != width);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exact),           cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_no_answer),       cmocka_unit_test(test_rounds),
        cmocka_unit_test(test_coverage_normal), cmocka_unit_test(test_coverage_rounds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
