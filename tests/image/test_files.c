/* Image files: what is written comes back, as far as the format can hold it. */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/files.h"
#include "image/fixture.h"

static void test_exr_keeps_every_bit(void **state)
{
    (void)state;
    static const int channels[] = {1, 2, 3, 4, 5, RL_IMAGE_CHANNELS_MAX};
    for (size_t i = 0; i < sizeof channels / sizeof channels[0]; i++) {
        struct rl_image image = {0};
        struct rl_image back = {0};
        struct rl_write_report report;
        make(&image, 7, 5, channels[i]);
        const float special[] = {-0.0F, FLT_MAX, -FLT_MAX, FLT_MIN, FLT_TRUE_MIN, -1.5F, 70000.0F};
        memcpy(image.data, special, sizeof special);
        check_ok(rl_image_write(&image, exr, &report, &error), &error);
        assert_int_equal(report.clipped, 0);
        check_ok(rl_image_read(&back, exr, &error), &error);
        assert_same_pixels(&image, &back);
        rl_image_clear(&image);
        rl_image_clear(&back);
    }
}

static void test_exr_keeps_attributes(void **state)
{
    (void)state;
    struct rl_image image = {0};
    struct rl_image back = {0};
    make(&image, 2, 2, 4);
    check_ok(rl_image_set_number(&image, "roughlight:rr", 1.0 / 3.0, &error), &error);
    check_ok(rl_image_set_number(&image, "roughlight:seed", 4294967297.0, &error), &error);
    check_ok(rl_image_set_string(&image, "roughlight:scene", "t\xc3\xa9st \"a b\".yaml", &error), &error);
    check_ok(rl_image_set_string(&image, "roughlight:hash", "0123456789012345", &error), &error);
    check_ok(rl_image_set_string(&image, "lines", "one\ntwo", &error), &error);
    check_ok(rl_image_set_string(&image, "DateTime", "2026:01:02 03:04:05", &error), &error);
    check_ok(rl_image_write(&image, exr, NULL, &error), &error);
    check_ok(rl_image_read(&back, exr, &error), &error);
    assert_int_equal(back.n_attributes, image.n_attributes);
    for (size_t i = 0; i < image.n_attributes; i++) {
        const struct rl_attribute *a = &image.attribute[i];
        const struct rl_attribute *b = rl_image_attribute(&back, a->name);
        assert_non_null(b);
        if (a->string)
            assert_string_equal(b->string, a->string);
        else
            assert_true(!b->string && b->number == a->number);
    }
    rl_image_clear(&image);
    rl_image_clear(&back);
}

static void test_png_keeps_attributes_as_strings(void **state)
{
    (void)state;
    struct rl_image image = {0};
    struct rl_image back = {0};
    make(&image, 2, 2, 4);
    check_ok(rl_image_set_number(&image, "roughlight:rr", 0.1, &error), &error);
    check_ok(rl_image_set_string(&image, "roughlight:scene", "t\xc3\xa9st.yaml", &error), &error);
    check_ok(rl_image_set_string(&image, "lines", "one\ntwo", &error), &error);
    check_ok(rl_image_write(&image, png, NULL, &error), &error);
    check_ok(rl_image_read(&back, png, &error), &error);
    assert_int_equal(back.n_attributes, 3);
    assert_true(strtod(rl_image_attribute(&back, "roughlight:rr")->string, NULL) == 0.1);
    assert_string_equal(rl_image_attribute(&back, "roughlight:scene")->string, "t\xc3\xa9st.yaml");
    assert_string_equal(rl_image_attribute(&back, "lines")->string, "one\ntwo");
    rl_image_clear(&image);
    rl_image_clear(&back);
}

static void test_full_attribute_table_comes_back(void **state)
{
    (void)state;
    struct rl_image image = {0};
    struct rl_image back = {0};
    make(&image, 1, 1, 1);
    for (int i = 0; i < RL_IMAGE_ATTRIBUTES_MAX; i++) {
        char name[32];
        snprintf(name, sizeof name, "roughlight:%d", i);
        check_ok(rl_image_set_number(&image, name, i, &error), &error);
    }
    check_ok(rl_image_write(&image, exr, NULL, &error), &error);
    check_ok(rl_image_read(&back, exr, &error), &error);
    assert_int_equal(back.n_attributes, RL_IMAGE_ATTRIBUTES_MAX);
    rl_image_clear(&image);
    rl_image_clear(&back);
}

/* Linear values from the formula of IEC 61966-2-1 (mpmath, 20 digits). */
static void test_png_is_srgb(void **state)
{
    (void)state;
    static const struct {
        float linear;
        double back; /* the nearest of the 256 codes, decoded */
    } cases[] = {
        {0.0F, 0.0},
        {0.0001F, 0.0},              /* 0.33 of the first step */
        {0.0002F, 0.000303526984},   /* code 1 */
        {0.18F, 0.18116424424986},   /* code 118: 117.646 */
        {0.2158605F, 0.21586050011}, /* code 128 */
        {0.5F, 0.50288645803685},    /* code 188: 187.516 */
        {0.999F, 1.0},               /* 254.89 */
        {1.0F, 1.0},
    };
    enum { N = sizeof cases / sizeof cases[0] };
    struct rl_image image = {0};
    struct rl_image back = {0};
    struct rl_write_report report;
    check_ok(rl_image_allocate(&image, N, 1, 3, &error), &error);
    for (int i = 0; i < N; i++)
        for (int c = 0; c < 3; c++)
            rl_image_pixel(&image, i, 0)[c] = cases[i].linear;
    check_ok(rl_image_write(&image, png, &report, &error), &error);
    assert_int_equal(report.clipped, 0);
    check_ok(rl_image_read(&back, png, &error), &error);
    assert_int_equal(back.channels, 3);
    for (int i = 0; i < N; i++)
        for (int c = 0; c < 3; c++)
            check_near(rl_image_pixel(&back, i, 0)[c], cases[i].back, 1e-7);

    /* What was read is written again as it was. */
    struct rl_image again = {0};
    check_ok(rl_image_write(&back, png, &report, &error), &error);
    check_ok(rl_image_read(&again, png, &error), &error);
    assert_same_pixels(&back, &again);
    rl_image_clear(&image);
    rl_image_clear(&back);
    rl_image_clear(&again);
}

static void test_png_layouts(void **state)
{
    (void)state;
    static const char *const layouts[][4] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    for (int n = 1; n <= 4; n++) {
        struct rl_image image = {0};
        struct rl_image back = {0};
        make(&image, 3, 2, n);
        for (int c = 0; c < n; c++)
            snprintf(image.channel_name[c], sizeof image.channel_name[c], "%s", layouts[n - 1][c]);
        check_ok(rl_image_write(&image, png, NULL, &error), &error);
        check_ok(rl_image_read(&back, png, &error), &error);
        assert_int_equal(back.channels, n);
        for (int c = 0; c < n; c++)
            assert_string_equal(back.channel_name[c], layouts[n - 1][c]);
        rl_image_clear(&image);
        rl_image_clear(&back);
    }
    static const char *const wrong[][2] = {{"Z", "A"}, {"A", "Y"}, {"C0", "C1"}};
    for (size_t i = 0; i < 3; i++) {
        struct rl_image image = {0};
        make(&image, 1, 1, 2);
        for (int c = 0; c < 2; c++)
            snprintf(image.channel_name[c], sizeof image.channel_name[c], "%s", wrong[i][c]);
        check_fails(rl_image_write(&image, png, NULL, &error), &error, RL_ERR_INPUT, "R G B A");
        rl_image_clear(&image);
    }
    struct rl_image image = {0};
    make(&image, 1, 1, 5);
    check_fails(rl_image_write(&image, png, NULL, &error), &error, RL_ERR_INPUT, "5 channel");
    rl_image_clear(&image);
}

static void test_png_alpha_is_unassociated(void **state)
{
    (void)state;
    /* colour 1/2 covered to 128/255, multiplied by it: 188 and 128 in the file */
    const double alpha = 128.0 / 255.0;
    const float pixels[2][4] = {
        {(float)(0.5 * alpha), 0.0F, (float)alpha, (float)alpha},
        {0.0F, 0.0F, 0.0F, 0.0F},
    };
    struct rl_image image = {0};
    struct rl_image back = {0};
    struct rl_write_report report;
    check_ok(rl_image_allocate(&image, 2, 1, 4, &error), &error);
    memcpy(image.data, pixels, sizeof pixels);
    check_ok(rl_image_write(&image, png, &report, &error), &error);
    assert_int_equal(report.clipped, 0);
    check_ok(rl_image_read(&back, png, &error), &error);
    const float *p = back.data;
    check_near(p[0], 0.50288645803685 * alpha, 1e-7);
    check_near(p[1], 0.0, 0.0);
    check_near(p[2], alpha, 1e-7);
    check_near(p[3], alpha, 1e-7);
    check_near(p[7], 0.0, 0.0);
    rl_image_clear(&image);
    rl_image_clear(&back);
}

static void test_png_counts_what_it_clips(void **state)
{
    (void)state;
    const float pixels[5][4] = {
        {-0.1F, 0.5F, 1.0F, 1.0F},  /* 1: below 0 */
        {1.5F, 1e30F, 0.0F, 1.0F},  /* 2: above 1 */
        {0.0F, 0.6F, 0.5F, 0.5F},   /* 1: colour 1.2 under its alpha */
        {0.0F, 0.25F, 0.0F, 0.0F},  /* 1: colour without alpha */
        {0.25F, 0.25F, 0.0F, 1.25F} /* 1: alpha itself */
    };
    struct rl_image image = {0};
    struct rl_image back = {0};
    struct rl_write_report report = {77, 77, 77, 77, 77}, before;
    check_ok(rl_image_allocate(&image, 5, 1, 4, &error), &error);
    memcpy(image.data, pixels, sizeof pixels);
    check_ok(rl_image_write(&image, png, &report, &error), &error);
    assert_int_equal(report.clipped, 6);
    assert_int_equal(report.above, 4);
    assert_int_equal(report.below, 1);
    assert_int_equal(report.uncovered, 1);
    assert_int_equal(report.nonfinite, 0);
    rl_image_clipping(&before, &image);
    assert_memory_equal(&before, &report, sizeof report);
    check_ok(rl_image_read(&back, png, &error), &error);
    check_near(back.data[0], 0.0, 0.0);
    check_near(back.data[5], 1.0, 0.0);
    check_near(back.data[9], 128.0 / 255.0, 1e-7);
    check_near(back.data[13], 0.0, 0.0);
    check_ok(rl_image_write(&image, exr, &report, &error), &error);
    assert_int_equal(report.clipped, 0);
    rl_image_clear(&image);
    rl_image_clear(&back);
}

static void read_whole(char **content, size_t *size, const char *path)
{
    check_ok(rl_file_read(content, size, path, &error), &error);
}

static void test_equal_images_make_equal_files(void **state)
{
    (void)state;
    const char *const paths[2] = {exr, png};
    struct rl_image image = {0};
    make(&image, 9, 9, 4);
    check_ok(rl_image_set_number(&image, "roughlight:rr", 30.0, &error), &error);
    char *first[2];
    size_t first_size[2];
    for (int i = 0; i < 2; i++) {
        check_ok(rl_image_write(&image, paths[i], NULL, &error), &error);
        read_whole(&first[i], &first_size[i], paths[i]);
    }
    sleep(1); /* the EXR writer would note the second */
    for (int i = 0; i < 2; i++) {
        char *second = NULL;
        size_t size = 0;
        check_ok(rl_image_write(&image, paths[i], NULL, &error), &error);
        read_whole(&second, &size, paths[i]);
        assert_int_equal(size, first_size[i]);
        assert_memory_equal(second, first[i], size);
        free(second);
        free(first[i]);
    }
    rl_image_clear(&image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exr_keeps_every_bit),
        cmocka_unit_test(test_exr_keeps_attributes),
        cmocka_unit_test(test_png_keeps_attributes_as_strings),
        cmocka_unit_test(test_full_attribute_table_comes_back),
        cmocka_unit_test(test_png_is_srgb),
        cmocka_unit_test(test_png_layouts),
        cmocka_unit_test(test_png_alpha_is_unassociated),
        cmocka_unit_test(test_png_counts_what_it_clips),
        cmocka_unit_test(test_equal_images_make_equal_files),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
