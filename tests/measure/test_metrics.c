/* Error metrics against values worked out by hand, chosen so that known mistakes (a squared MAE, a relMSE
 * whose denominator is not squared, alpha counted as colour) give others. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "measure/metrics.h"
#include "support/check.h"

static struct rl_error error;

static void make(struct rl_image *image, int width, int height, int channels, const float *values)
{
    check_ok(rl_image_allocate(image, width, height, channels, &error), &error);
    size_t n = (size_t)width * (size_t)height * (size_t)channels;
    if (values)
        memcpy(image->data, values, n * sizeof *values);
}

static void rename_channels(struct rl_image *image, const char *const names[])
{
    for (int c = 0; c < image->channels; c++)
        snprintf(image->channel_name[c], sizeof image->channel_name[c], "%s", names[c]);
}

static void test_by_hand(void **state)
{
    (void)state;
    struct rl_image v = {0};
    struct rl_image r = {0};
    struct rl_metrics m;
    make(&v, 2, 1, 1, (const float[]){1.0F, 2.0F});
    make(&r, 2, 1, 1, (const float[]){0.5F, 3.0F});
    check_ok(rl_metrics_compute(&m, &v, &r, &error), &error);
    /* e = 1/2, -1 */
    check_near(m.mae, 0.75, 1e-15);
    check_relative(m.rmse, 0.79056941504209483, 1e-15); /* sqrt(5/8) */
    check_near(m.bias, -0.25, 1e-15);
    check_near(m.max, 1.0, 0.0);
    check_relative(m.relmse, 0.53577141945973397, 1e-14); /* (0.25/0.51^2 + 1/3.01^2)/2 */
    check_relative(m.psnr, 11.583624920952497, 1e-14);    /* 20 log10(3/rmse) */
    assert_int_equal(m.nonfinite, 0);
    assert_int_equal(m.pixels, 2);
    assert_int_equal(m.mismatched, 0);
    rl_image_clear(&v);
    rl_image_clear(&r);
}

static void test_colour_by_name_and_alpha_as_coverage(void **state)
{
    (void)state;
    struct rl_image v = {0};
    struct rl_image r = {0};
    struct rl_metrics m;
    /* R G B A: the first pixel is compared, the second is background, the third and fourth are covered in one
     * only. */
    make(&r, 4, 1, 4,
         (const float[]){0.25F, 0.5F, 0.75F, 0.5F, 9.0F, 9.0F, 9.0F, 0.49F, 1.0F, 1.0F, 1.0F, 1.0F, 5.0F,
                         5.0F, 5.0F, 0.0F});
    /* Depth Z first, then A, B, G, R: the same colours but for G + 0.3, and another alpha. */
    make(&v, 4, 1, 5, (const float[]){7.0F, 1.0F, 0.75F, 0.8F, 0.25F, 7.0F, 0.0F, 0.0F, 0.0F, 0.0F,
                                      7.0F, 0.2F, 0.0F,  0.0F, 0.0F,  7.0F, 1.0F, 0.0F, 0.0F, 0.0F});
    rename_channels(&v, (const char *const[]){"Z", "A", "B", "G", "R"});
    check_ok(rl_metrics_compute(&m, &v, &r, &error), &error);
    assert_int_equal(m.pixels, 1);
    assert_int_equal(m.mismatched, 2);
    check_near(m.bias, 0.1, 1e-8);
    check_near(m.mae, 0.1, 1e-8);
    check_near(m.max, 0.3, 1e-7);
    check_near(m.rmse, sqrt(0.09 / 3.0), 1e-7);
    check_near(m.psnr, 20.0 * log10(1.0 / sqrt(0.03)), 1e-6); /* the peak is 1 where the reference has less */

    /* Without alpha in the image, the reference's alone counts; without it in the reference, every pixel does. */
    struct rl_image opaque = {0};
    make(&opaque, 4, 1, 3, NULL);
    check_ok(rl_metrics_compute(&m, &opaque, &r, &error), &error);
    assert_int_equal(m.pixels, 2);
    assert_int_equal(m.mismatched, 0);
    check_near(m.bias, -(0.25 + 0.5 + 0.75 + 3.0) / 6.0, 1e-15);
    check_ok(rl_metrics_compute(&m, &r, &opaque, &error), &error);
    assert_int_equal(m.pixels, 4);
    assert_int_equal(m.mismatched, 0);
    check_near(m.max, 9.0, 0.0);
    rl_image_clear(&v);
    rl_image_clear(&r);
    rl_image_clear(&opaque);
}

/* What HDR pictures have: negative values, among them the one that an offset without a magnitude divides by nothing at, and 1e30, whose
 * square no float holds. By hand. */
static void test_hdr_values(void **state)
{
    (void)state;
    static const struct {
        float v, r;
        double rmse, relmse;
    } row[] = {
        {0.01F, -0.01F, 0.02, 1.0}, /* 0.02^2/(0.01 + 0.01)^2 */
        {0.0F, -0.01F, 0.01, 0.25},
        {-0.004F, 0.0F, 0.004, 0.16},
        {0.0F, -0.004F, 0.004, 0.0816326530612244898}, /* (4/14)^2 */
        {1e30F, 0.0F, 1e30, 1e64},
        {0.0F, 1e30F, 1e30, 1.0},
        {-1e30F, 1e30F, 2e30, 4.0},
        {3.4e38F, -3.4e38F, 6.8e38, 4.0},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_image v = {0};
        struct rl_image r = {0};
        struct rl_metrics m;
        make(&v, 1, 1, 1, &row[i].v);
        make(&r, 1, 1, 1, &row[i].r);
        check_ok(rl_metrics_compute(&m, &v, &r, &error), &error);
        check_relative(m.rmse, row[i].rmse, 1e-7); /* the values are floats */
        check_relative(m.relmse, row[i].relmse, 2e-7);
        assert_int_equal(m.nonfinite, 0);
        rl_image_clear(&v);
        rl_image_clear(&r);
    }
}

static void test_equal_images(void **state)
{
    (void)state;
    struct rl_image v = {0};
    struct rl_metrics m;
    make(&v, 1, 2, 3, (const float[]){1.0F, -0.01F, 3.0F, 0.0F, 1e30F, 2.0F});
    check_ok(rl_metrics_compute(&m, &v, &v, &error), &error);
    check_near(m.rmse, 0.0, 0.0);
    check_near(m.mae, 0.0, 0.0);
    check_near(m.max, 0.0, 0.0);
    check_near(m.bias, 0.0, 0.0);
    check_near(m.relmse, 0.0, 0.0);
    assert_true(isinf(m.psnr) && m.psnr > 0.0);
    rl_image_clear(&v);
}

static void test_nonfinite_values_void_the_rest(void **state)
{
    (void)state;
    struct rl_image v = {0};
    struct rl_image r = {0};
    struct rl_metrics m;
    make(&v, 2, 1, 4, (const float[]){NAN, 0.0F, 0.0F, 1.0F, 0.0F, INFINITY, 0.0F, 0.0F});
    make(&r, 2, 1, 4, (const float[]){0.0F, 0.0F, 0.0F, 1.0F, 0.0F, -INFINITY, 0.0F, NAN});
    check_ok(rl_metrics_compute(&m, &v, &r, &error), &error);
    assert_int_equal(m.nonfinite, 4); /* in the background too */
    assert_int_equal(m.pixels, 1);
    assert_true(isnan(m.rmse) && isnan(m.mae) && isnan(m.max) && isnan(m.bias) && isnan(m.relmse) &&
                isnan(m.psnr));
    rl_image_clear(&v);
    rl_image_clear(&r);
}

static void test_what_cannot_be_compared(void **state)
{
    (void)state;
    struct rl_image a = {0};
    struct rl_image b = {0};
    struct rl_image y = {0};
    struct rl_image other = {0};
    struct rl_image empty = {0};
    struct rl_image out = {0};
    struct rl_metrics m;
    make(&a, 3, 2, 4, NULL);
    make(&b, 2, 3, 4, NULL);
    make(&y, 3, 2, 1, NULL);
    make(&other, 3, 2, 2, NULL);
    check_fails(rl_metrics_compute(&m, &a, &b, &error), &error, RL_ERR_INPUT,
                "the image has 3 x 2 pixels, the reference 2 x 3");
    check_fails(rl_metrics_compute(&m, &a, &y, &error), &error, RL_ERR_INPUT,
                "the image has R, G, B, the reference Y");
    check_fails(rl_metrics_compute(&m, &y, &a, &error), &error, RL_ERR_INPUT,
                "the image has Y, the reference R, G, B");
    check_fails(rl_metrics_compute(&m, &other, &other, &error), &error, RL_ERR_INPUT, "no colour");
    check_fails(rl_metrics_compute(&m, &a, &a, &error), &error, RL_ERR_INPUT, "nothing to compare");
    check_fails(rl_metrics_compute(&m, &a, &empty, &error), &error, RL_ERR_INPUT, "empty");
    check_fails(rl_error_image(&out, &a, &b, &error), &error, RL_ERR_INPUT, "3 x 2");
    assert_null(out.data);
    rl_image_clear(&a);
    rl_image_clear(&b);
    rl_image_clear(&y);
    rl_image_clear(&other);
}

/* One large error among four million small ones; a sum in float, or a plain one in double, is off by more
 * than this. */
static void test_sums_are_accurate(void **state)
{
    (void)state;
    enum { SIDE = 2048 };
    struct rl_image v = {0};
    struct rl_image r = {0};
    struct rl_metrics m;
    make(&v, SIDE, SIDE, 1, NULL);
    make(&r, SIDE, SIDE, 1, NULL);
    const double n = (double)SIDE * SIDE;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++)
        v.data[i] = 0.1F;
    v.data[7] = 16777216.0F;
    check_ok(rl_metrics_compute(&m, &v, &r, &error), &error);
    const double tenth = 0.1F;
    check_relative(m.mae, (16777216.0 + (n - 1.0) * tenth) / n, 4e-16);
    check_relative(m.bias, (16777216.0 + (n - 1.0) * tenth) / n, 4e-16);
    check_relative(m.rmse, sqrt((16777216.0 * 16777216.0 + (n - 1.0) * tenth * tenth) / n), 4e-16);
    rl_image_clear(&v);
    rl_image_clear(&r);
}

static void test_error_image(void **state)
{
    (void)state;
    struct rl_image v = {0};
    struct rl_image r = {0};
    struct rl_image out = {0};
    make(&v, 3, 1, 4, (const float[]){1.0F, 0.5F, 0.0F, 1.0F, NAN, 0.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F, 1.0F});
    make(&r, 3, 1, 4,
         (const float[]){0.25F, 1.0F, 1.0F, 1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F});
    check_ok(rl_error_image(&out, &v, &r, &error), &error);
    assert_int_equal(out.width, 3);
    assert_int_equal(out.height, 1);
    assert_int_equal(out.channels, 1);
    assert_string_equal(out.channel_name[0], "Y");
    check_near(out.data[0], -0.25, 1e-7); /* (3/4 - 1/2 - 1)/3 */
    check_near(out.data[1], 0.0, 0.0);    /* background, whatever it holds */
    check_near(out.data[2], 0.0, 0.0);    /* covered in one only */
    rl_image_clear(&out);
    rl_image_clear(&v);
    rl_image_clear(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_colour_by_name_and_alpha_as_coverage),
        cmocka_unit_test(test_hdr_values),
        cmocka_unit_test(test_equal_images),
        cmocka_unit_test(test_nonfinite_values_void_the_rest),
        cmocka_unit_test(test_what_cannot_be_compared),
        cmocka_unit_test(test_sums_are_accurate),
        cmocka_unit_test(test_error_image),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
