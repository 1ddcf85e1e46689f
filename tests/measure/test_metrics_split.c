/* Mean squared error of repeated seeds, split into bias and variance: by hand, and whether its intervals hold. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "measure/metrics.h"
#include "measure/noise.h"
#include "model/random.h"
#include "support/check.h"

static struct rl_error error;

static void make(struct rl_image *image, int width, int height, int channels, const float *values)
{
    check_ok(rl_image_allocate(image, width, height, channels, &error), &error);
    size_t n = (size_t)width * (size_t)height * (size_t)channels;
    if (values)
        memcpy(image->data, values, n * sizeof *values);
}

static void test_by_hand(void **state)
{
    (void)state;
    static const float values[3][2] = {{1.0F, 4.0F}, {2.0F, 4.0F}, {3.0F, 4.0F}};
    struct rl_image image[3] = {0};
    const struct rl_image *const images[3] = {&image[0], &image[1], &image[2]};
    struct rl_image reference = {0};
    struct rl_bias_variance s;
    for (int k = 0; k < 3; k++)
        make(&image[k], 2, 1, 1, values[k]);
    make(&reference, 2, 1, 1, (const float[]){1.0F, 5.0F});
    check_ok(rl_bias_variance_compute(&s, images, 3, &reference, &error), &error);
    /* left: mean 2, variance 1, bias^2 1 - 1/3; right: mean 4, variance 0, bias^2 1 */
    check_near(s.variance, 0.5, 1e-15);
    check_near(s.bias2, 5.0 / 6.0, 1e-15);
    /* left: (0 + 1 + 4)/3, right: 1 */
    check_near(s.mse, 4.0 / 3.0, 1e-15);
    /* Without seed 1, 2, 3: variance 1/4, 1, 1/4, bias^2 3/2, 1/2, 1/2; jackknife errors 1/2 and 2/3; t with 2 degrees of
     * freedom. */
    check_near(s.variance_high - s.variance, 4.302652729696142 / 2.0, 1e-10);
    check_near(s.variance - s.variance_low, 4.302652729696142 / 2.0, 1e-10);
    check_near(s.bias2_high - s.bias2, 4.302652729696142 * 2.0 / 3.0, 1e-10);
    check_near(s.bias2 - s.bias2_low, 4.302652729696142 * 2.0 / 3.0, 1e-10);
    for (int k = 0; k < 3; k++)
        rl_image_clear(&image[k]);
    rl_image_clear(&reference);
}

/* mse is the mean of the images' own. */
static void test_agrees_with_metrics(void **state)
{
    (void)state;
    enum { K = 5, SIDE = 37 };
    const uint64_t seed = 7;
    struct rl_image image[K] = {0};
    const struct rl_image *images[K];
    struct rl_image reference = {0};
    double mse = 0.0;
    make(&reference, SIDE, SIDE, 4, NULL);
    for (int i = 0; i < SIDE * SIDE; i++)
        reference.data[4 * i + 3] = i % 3 ? 1.0F : 0.0F;
    for (int k = 0; k < K; k++) {
        make(&image[k], SIDE, SIDE, 4, reference.data);
        for (int i = 0; i < SIDE * SIDE * 4; i++)
            if (i % 4 != 3)
                image[k].data[i] = (float)(0.1 + noise(seed, (uint64_t)k << 32 | (uint64_t)i));
        images[k] = &image[k];
        struct rl_metrics m;
        check_ok(rl_metrics_compute(&m, &image[k], &reference, &error), &error);
        mse += m.rmse * m.rmse / K;
    }
    struct rl_bias_variance s;
    check_ok(rl_bias_variance_compute(&s, images, K, &reference, &error), &error);
    check_relative(s.mse, mse, 1e-13);
    check_relative(s.bias2 + s.variance, s.mse, 1e-15);
    for (int k = 0; k < K; k++)
        rl_image_clear(&image[k]);
    rl_image_clear(&reference);
}

/* Uneven pictures, as highlights are: bias and noise in one corner only, or everywhere. Over and over, the intervals should
 * hold about 95 times in 100 (the jackknife errs towards more), and be about as wide as the figures really scatter: one
 * that measured how uneven the picture is would always hold and tell nothing. */
static void repeat(int side, int lit, uint64_t seed)
{
    enum { TRIALS = 400, K = 4, LARGEST = 40 };
    static const double t3 = 3.182446305284263; /* Student's, 3 degrees of freedom */
    struct rl_image image[K] = {0};
    const struct rl_image *images[K];
    struct rl_image reference = {0};
    assert_true(side <= LARGEST);
    for (int k = 0; k < K; k++) {
        make(&image[k], side, side, 1, NULL);
        images[k] = &image[k];
    }
    make(&reference, side, side, 1, NULL);
    double share = (double)(lit * lit) / (side * side);
    double truth[2] = {0.04 * share, 0.25 * share};
    double holds[2] = {0.0}, half[2] = {0.0}, sum[2] = {0.0}, squares[2] = {0.0};
    uint64_t next = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        for (int k = 0; k < K; k++)
            for (int y = 0; y < lit; y++)
                for (int x = 0; x < lit; x++)
                    rl_image_pixel(&image[k], x, y)[0] = (float)(0.2 + 0.5 * noise(seed, next++));
        struct rl_bias_variance s;
        check_ok(rl_bias_variance_compute(&s, images, K, &reference, &error), &error);
        const double value[2] = {s.bias2, s.variance};
        const double low[2] = {s.bias2_low, s.variance_low};
        const double high[2] = {s.bias2_high, s.variance_high};
        for (int q = 0; q < 2; q++) {
            holds[q] += low[q] <= truth[q] && truth[q] <= high[q];
            half[q] += 0.5 * (high[q] - low[q]) / TRIALS;
            sum[q] += value[q] / TRIALS;
            squares[q] += value[q] * value[q] / TRIALS;
        }
    }
    for (int q = 0; q < 2; q++) {
        double scatter = sqrt(squares[q] - sum[q] * sum[q]);
        printf("%s: holds %.3f, half width / (t scatter) %.2f\n", q ? "variance" : "bias^2",
               holds[q] / TRIALS, half[q] / (t3 * scatter));
        assert_true(holds[q] / TRIALS > 0.95 - 4.0 * 0.011);
        assert_true(half[q] > 0.8 * t3 * scatter && half[q] < 2.0 * t3 * scatter);
        /* Unbiased: without the correction by variance/K, bias^2 would be 2.6 times as large. */
        check_near(sum[q], truth[q], 4.0 * scatter / sqrt(TRIALS));
    }
    for (int k = 0; k < K; k++)
        rl_image_clear(&image[k]);
    rl_image_clear(&reference);
}

static void test_intervals_hold(void **state)
{
    (void)state;
    const uint64_t seed = 20260102;
    printf("seed %llu\n", (unsigned long long)seed);
    repeat(40, 40, seed);
    repeat(40, 9, seed + 1);
}

/* Pictures that differ from the reference in few values, as those of two roundings do: by 1/16 with the probability p. Or in
 * all: by 0.005 with Gaussian noise of 0.05. How often does the interval hold the expected bias^2? In every
 * trial something differs: 2916 p K, the differences expected, is 7 or more. */
static double coverage(size_t n_seeds, double p, int trials, uint64_t seed, double *mean_high)
{
    enum { SIDE = 54, PIXELS = SIDE * SIDE, MOST = 64 };
    struct rl_image image[MOST] = {0}, reference = {0};
    const struct rl_image *images[MOST];
    const double truth = p > 0.0 ? pow(p / 16.0, 2.0) : 0.005 * 0.005;
    uint64_t next = 0;
    double holds = 0.0;
    for (size_t k = 0; k < n_seeds; k++) {
        make(&image[k], SIDE, SIDE, 1, NULL);
        images[k] = &image[k];
    }
    make(&reference, SIDE, SIDE, 1, NULL);
    *mean_high = 0.0;
    for (int trial = 0; trial < trials; trial++) {
        for (size_t k = 0; k < n_seeds; k++)
            for (int i = 0; i < PIXELS; i++) {
                double differs = rl_random_uniform(seed, next) < p ? 1.0 / 16.0 : 0.0;
                image[k].data[i] = (float)(p > 0.0 ? differs : 0.005 + 0.05 * noise(seed, next));
                next++;
            }
        struct rl_bias_variance s;
        check_ok(rl_bias_variance_compute(&s, images, n_seeds, &reference, &error), &error);
        holds += s.bias2_low <= truth && truth <= s.bias2_high;
        *mean_high += s.bias2_high / truth / trials;
    }
    for (size_t k = 0; k < n_seeds; k++)
        rl_image_clear(&image[k]);
    rl_image_clear(&reference);
    return holds / trials;
}

static void test_coverage(void **state)
{
    (void)state;
    enum { TRIALS = 120, LONG_TRIALS = 40 };
    const uint64_t seed = 20261125;
    static const size_t seeds[] = {4, 8, 16, 64};
    static const double p[] = {0.0, 0.0006, 0.005, 0.05};
    printf("seed %llu\nK\tp (0: dense)\tcoverage\tmean upper end / truth\n", (unsigned long long)seed);
    for (size_t i = 0; i < 4; i++)
        for (size_t k = 0; k < 4; k++) {
            int trials = seeds[i] == 64 ? LONG_TRIALS : TRIALS;
            double high, holds = coverage(seeds[i], p[k], trials, seed + 4 * i + k, &high);
            printf("%zu\t%g\t%.3f\t%.3g\n", seeds[i], p[k], holds, high);
            /* Four standard deviations of a share of `trials` about 0.95. */
            assert_true(holds > 0.95 - 4.0 * sqrt(0.95 * 0.05 / trials));
        }
}

static void test_two_seeds_tell_nothing(void **state)
{
    (void)state;
    struct rl_image a = {0};
    struct rl_image b = {0};
    struct rl_bias_variance s;
    make(&a, 1, 1, 1, (const float[]){1.0F});
    make(&b, 1, 1, 1, (const float[]){3.0F});
    const struct rl_image *const images[2] = {&a, &b};
    check_ok(rl_bias_variance_compute(&s, images, 2, &a, &error), &error);
    check_near(s.variance, 2.0, 0.0);
    check_near(s.bias2, 0.0, 0.0);
    assert_true(isinf(s.variance_high) && isinf(s.bias2_low));
    rl_image_clear(&a);
    rl_image_clear(&b);
}

static void test_what_cannot_be_split(void **state)
{
    (void)state;
    struct rl_image a = {0};
    struct rl_image b = {0};
    struct rl_image c = {0};
    struct rl_bias_variance s;
    make(&a, 2, 2, 4, NULL);
    make(&b, 2, 3, 4, NULL);
    make(&c, 2, 2, 1, NULL);
    const struct rl_image *const unequal[2] = {&a, &b};
    const struct rl_image *const equal[2] = {&a, &a};
    const struct rl_image *const grey[2] = {&c, &c};
    check_fails(rl_bias_variance_compute(&s, equal, 1, &a, &error), &error, RL_ERR_INPUT, "at least 2 seeds");
    check_fails(rl_bias_variance_compute(&s, equal, 0, &a, &error), &error, RL_ERR_INPUT, "at least 2 seeds");
    check_fails(rl_bias_variance_compute(&s, unequal, 2, &a, &error), &error, RL_ERR_INPUT, "2 x 3");
    check_fails(rl_bias_variance_compute(&s, equal, 2, &a, &error), &error, RL_ERR_INPUT,
                "nothing to compare");
    check_fails(rl_bias_variance_compute(&s, grey, 2, &a, &error), &error, RL_ERR_INPUT, "the image has Y");
    c.data[3] = NAN;
    check_fails(rl_bias_variance_compute(&s, grey, 2, &c, &error), &error, RL_ERR_CHECK, "3 values");
    rl_image_clear(&a);
    rl_image_clear(&b);
    rl_image_clear(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_agrees_with_metrics),
        cmocka_unit_test(test_intervals_hold),
        cmocka_unit_test(test_coverage),
        cmocka_unit_test(test_two_seeds_tell_nothing),
        cmocka_unit_test(test_what_cannot_be_split),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
