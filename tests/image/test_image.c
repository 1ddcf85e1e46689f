/* Images in memory: sizes and their limits, channel names, attributes. */
#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "image/image.h"
#include "image/srgb.h"
#include "support/check.h"

static struct rl_error error;

static void test_allocate_names_channels(void **state)
{
    (void)state;
    static const struct {
        int channels;
        const char *names[5];
    } cases[] = {
        {1, {"Y"}},
        {2, {"C0", "C1"}},
        {3, {"R", "G", "B"}},
        {4, {"R", "G", "B", "A"}},
        {5, {"C0", "C1", "C2", "C3", "C4"}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct rl_image image = {0};
        check_ok(rl_image_allocate(&image, 3, 2, cases[i].channels, &error), &error);
        assert_int_equal(image.width, 3);
        assert_int_equal(image.height, 2);
        for (int c = 0; c < cases[i].channels; c++) {
            assert_string_equal(image.channel_name[c], cases[i].names[c]);
            assert_int_equal(rl_image_channel(&image, cases[i].names[c]), c);
        }
        assert_int_equal(rl_image_channel(&image, "Z"), -1);
        for (int v = 0; v < 3 * 2 * cases[i].channels; v++)
            assert_true(image.data[v] == 0.0F);
        rl_image_clear(&image);
        assert_null(image.data);
    }
}

static void test_pixel_addresses_rows_from_the_top(void **state)
{
    (void)state;
    struct rl_image image = {0};
    check_ok(rl_image_allocate(&image, 3, 2, 4, &error), &error);
    rl_image_pixel(&image, 2, 1)[3] = 5.0F;
    assert_true(image.data[23] == 5.0F);
    assert_ptr_equal(rl_image_pixel(&image, 0, 0), image.data);
    rl_image_clear(&image);
}

static void test_allocate_refuses_sizes(void **state)
{
    (void)state;
    static const int cases[][3] = {
        {0, 1, 1},
        {1, 0, 1},
        {1, 1, 0},
        {-1, 5, 3},
        {1, 1, 17},
        {INT_MAX, 1, 16},
        {INT_MAX, INT_MAX, 16},
        {65536, 65536, 1},
        {16384, 16385, 4},
        {INT_MIN, INT_MIN, 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct rl_image image = {0};
        int status = rl_image_allocate(&image, cases[i][0], cases[i][1], cases[i][2], &error);
        check_fails(status, &error, RL_ERR_INPUT, "expected");
        assert_null(image.data);
    }
}

static void test_attributes(void **state)
{
    (void)state;
    struct rl_image image = {0};
    check_ok(rl_image_allocate(&image, 1, 1, 1, &error), &error);
    check_ok(rl_image_set_string(&image, "scene", "a", &error), &error);
    check_ok(rl_image_set_number(&image, "rr", 30.5, &error), &error);
    check_ok(rl_image_set_string(&image, "scene", "longer than it was", &error), &error);
    assert_int_equal(image.n_attributes, 2);
    assert_string_equal(rl_image_attribute(&image, "scene")->string, "longer than it was");
    assert_null(rl_image_attribute(&image, "rr")->string);
    assert_true(rl_image_attribute(&image, "rr")->number == 30.5);
    assert_null(rl_image_attribute(&image, "RR"));

    /* A string becomes a number and back. */
    check_ok(rl_image_set_number(&image, "scene", 1.0, &error), &error);
    assert_null(rl_image_attribute(&image, "scene")->string);
    check_ok(rl_image_set_string(&image, "scene", "", &error), &error);
    assert_string_equal(rl_image_attribute(&image, "scene")->string, "");
    rl_image_clear(&image);
    assert_int_equal(image.n_attributes, 0);
}

static void test_attribute_table_fills(void **state)
{
    (void)state;
    struct rl_image image = {0};
    check_ok(rl_image_allocate(&image, 1, 1, 1, &error), &error);
    for (int i = 0; i < RL_IMAGE_ATTRIBUTES_MAX; i++) {
        char name[16];
        snprintf(name, sizeof name, "n%d", i);
        check_ok(rl_image_set_string(&image, name, name, &error), &error);
    }
    check_fails(rl_image_set_string(&image, "more", "x", &error), &error, RL_ERR_SYSTEM, "'more'");
    check_fails(rl_image_set_number(&image, "more", 1.0, &error), &error, RL_ERR_SYSTEM, "'more'");
    check_ok(rl_image_set_string(&image, "n63", "still", &error), &error);
    assert_string_equal(rl_image_attribute(&image, "n63")->string, "still");
    rl_image_clear(&image);
}

static void test_attribute_names_are_checked(void **state)
{
    (void)state;
    struct rl_image image = {0};
    check_ok(rl_image_allocate(&image, 1, 1, 1, &error), &error);
    char name[66];
    memset(name, 'n', sizeof name);
    name[63] = '\0';
    check_ok(rl_image_set_number(&image, name, 1.0, &error), &error);
    name[63] = 'n';
    name[64] = '\0';
    check_fails(rl_image_set_number(&image, name, 1.0, &error), &error, RL_ERR_INPUT, "1 to 63");
    check_fails(rl_image_set_string(&image, "", "x", &error), &error, RL_ERR_INPUT, "''");
    check_fails(rl_image_set_string(&image, "tab\there", "x", &error), &error, RL_ERR_INPUT, "ASCII");
    check_fails(rl_image_set_string(&image, "\xc3\xbc", "x", &error), &error, RL_ERR_INPUT, "ASCII");
    assert_int_equal(image.n_attributes, 1);
    rl_image_clear(&image);
}

/* Values from the formula of IEC 61966-2-1 in 20 digits (bc -l). */
static void test_srgb(void **state)
{
    (void)state;
    static const struct {
        double linear, encoded;
    } cases[] = {
        {0.0, 0.0},
        {0.001, 0.01292},
        {0.0031308, 0.040449936},
        {0.01, 0.099852822734128},
        {0.18, 0.461356129500},
        {0.5, 0.735356983052},
        {1.0, 1.0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        check_near(rl_srgb_encode(cases[i].linear), cases[i].encoded, 1e-9);
        check_near(rl_srgb_decode(cases[i].encoded), cases[i].linear, 1e-7);
    }
    for (int code = 0; code < 65536; code++)
        assert_int_equal(lround(65535.0 * rl_srgb_encode(rl_srgb_decode(code / 65535.0))), code);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_allocate_names_channels),
        cmocka_unit_test(test_pixel_addresses_rows_from_the_top),
        cmocka_unit_test(test_allocate_refuses_sizes),
        cmocka_unit_test(test_attributes),
        cmocka_unit_test(test_attribute_table_fills),
        cmocka_unit_test(test_attribute_names_are_checked),
        cmocka_unit_test(test_srgb),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
