/* Ranges and spellings of the settings. */
#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "scene/settings.h"
#include "support/check.h"

static struct rl_error error;

static void test_default(void **state)
{
    (void)state;
    struct rl_settings s = RL_SETTINGS_DEFAULT;
    check_ok(rl_settings_check(&s, &error), &error);
    const char *key = "unset";
    check_ok(rl_settings_check_key(&s, &key, &error), &error);
    assert_null(key);
}

/* Every knob, just inside and just outside of its range. */
static void test_ranges(void **state)
{
    (void)state;
#define WITH(field, value) (s = RL_SETTINGS_DEFAULT, s.field = (value), rl_settings_check(&s, &error))
    struct rl_settings s;
    check_ok(WITH(method, "regular"), &error);
    check_fails(WITH(method, "Regular"), &error, RL_ERR_INPUT,
                "--method: found 'Regular', expected plain, regular, random, exhaustive or");
    check_ok(WITH(samples, 0), &error);
    check_ok(WITH(samples, 1024), &error);
    check_fails(WITH(samples, -1), &error, RL_ERR_INPUT, "--samples: found -1, expected 1 to 1024");
    check_fails(WITH(samples, 1025), &error, RL_ERR_INPUT, "--samples: found 1025");
    check_ok(WITH(rr, 0.0), &error);
    check_ok(WITH(rr, 1e12), &error);
    check_fails(WITH(rr, -1.0), &error, RL_ERR_INPUT, "--rr: found -1, expected 1e-06 to 1e+12");
    check_fails(WITH(rr, NAN), &error, RL_ERR_INPUT, "--rr: found nan");
    check_fails(WITH(rr, INFINITY), &error, RL_ERR_INPUT, "--rr: found inf");
    check_ok(WITH(normal_bits, 4), &error);
    check_ok(WITH(normal_bits, 16), &error);
    check_ok(WITH(normal_bits, RL_NORMAL_BITS_FLOAT), &error);
    check_fails(WITH(normal_bits, 3), &error, RL_ERR_INPUT, "--normal-bits: found 3");
    check_fails(WITH(normal_bits, 17), &error, RL_ERR_INPUT, "--normal-bits: found 17");
    check_fails(WITH(normal_bits, -8), &error, RL_ERR_INPUT, "--normal-bits: found -8");
    check_ok(WITH(normal_size, 64), &error);
    check_ok(WITH(normal_size, 2048), &error);
    check_fails(WITH(normal_size, 32), &error, RL_ERR_INPUT, "--normal-size: found 32");
    check_fails(WITH(normal_size, 100), &error, RL_ERR_INPUT,
                "--normal-size: found 100, expected a power of two");
    check_fails(WITH(normal_size, 4096), &error, RL_ERR_INPUT, "--normal-size");
    check_fails(WITH(normal_size, INT_MIN), &error, RL_ERR_INPUT, "--normal-size");
    check_ok(WITH(env_size, 8), &error);
    check_ok(WITH(env_size, 4096), &error);
    check_fails(WITH(env_size, 7), &error, RL_ERR_INPUT, "--env-size: found 7, expected 8 to 4096");
    check_fails(WITH(env_size, 4097), &error, RL_ERR_INPUT, "--env-size");
    check_fails(WITH(env_format, RL_TEXEL_FORMATS), &error, RL_ERR_INPUT, "--env-format");
    check_fails(WITH(margin_kind, (enum rl_margin)7), &error, RL_ERR_INPUT, "--margin");
    check_fails((WITH(margin, -0.1), s.margin_kind = RL_MARGIN_VALUE, rl_settings_check(&s, &error)), &error,
                RL_ERR_INPUT, "--margin: found -0.1");
    check_fails((WITH(margin, NAN), s.margin_kind = RL_MARGIN_VALUE, rl_settings_check(&s, &error)), &error,
                RL_ERR_INPUT, "--margin: found nan");
    check_fails((WITH(margin_bound, 0.0), s.margin_kind = RL_MARGIN_AUTO, rl_settings_check(&s, &error)),
                &error, RL_ERR_INPUT, "--margin: found the bound 0");
    check_ok(WITH(margin_bound, NAN), &error);
    check_ok(WITH(margin, NAN), &error); /* nobody reads it with margin off */
    check_ok(WITH(width, 16384), &error);
    check_fails(WITH(width, 16385), &error, RL_ERR_INPUT, "--size: found 16385, expected 1 to 16384");
    check_fails(WITH(height, -1), &error, RL_ERR_INPUT, "--size: found -1");
    check_fails(WITH(frame, (enum rl_frame_kind)5), &error, RL_ERR_INPUT, "--frame");
    check_ok(WITH(depth_bits, 16), &error);
    check_ok(WITH(depth_bits, 24), &error);
    check_ok(WITH(depth_bits, 32), &error);
    check_fails(WITH(depth_bits, 8), &error, RL_ERR_INPUT, "--depth-bits: found 8, expected 16, 24 or 32");
    check_fails(WITH(depth_bits, 20), &error, RL_ERR_INPUT, "--depth-bits: found 20");
    check_ok(WITH(interpolation, RL_INTERPOLATION_CONSTANT), &error);
    check_fails(WITH(interpolation, RL_INTERPOLATIONS), &error, RL_ERR_INPUT,
                "--interpolation: found kind 3, expected phong, gouraud or constant");
    check_fails(WITH(interpolation, -2), &error, RL_ERR_INPUT, "--interpolation: found kind -2");
    check_ok(WITH(tolerance, 1e-12), &error);
    check_fails(WITH(tolerance, 0.0), &error, RL_ERR_INPUT, "--tolerance: found 0, expected 1e-12 to 0.1");
    check_fails(WITH(tolerance, NAN), &error, RL_ERR_INPUT, "--tolerance");
    assert_int_equal(WITH(samples, -1), RL_ERR_INPUT);
    assert_int_equal(rl_settings_check(&s, NULL), RL_ERR_INPUT); /* a caller may want the code alone */
#undef WITH
}

static void test_names_and_back(void **state)
{
    (void)state;
    for (int i = 0; i < RL_TEXEL_FORMATS; i++) {
        enum rl_texel_format format;
        check_ok(rl_parse_texel_format(&format, rl_texel_format_name((enum rl_texel_format)i), "x", &error),
                 &error);
        assert_int_equal(format, i);
    }
    static const int bits[] = {4, 8, 16, RL_NORMAL_BITS_HALF, RL_NORMAL_BITS_FLOAT};
    for (size_t i = 0; i < sizeof bits / sizeof bits[0]; i++) {
        char text[16];
        int back = 0;
        rl_normal_bits_name(text, bits[i]);
        check_ok(rl_parse_normal_bits(&back, text, "x", &error), &error);
        assert_int_equal(back, bits[i]);
    }
    static const enum rl_frame_kind frames[] = {RL_FRAME_ORTHONORMAL, RL_FRAME_PRINTED};
    for (size_t i = 0; i < 2; i++) {
        enum rl_frame_kind frame;
        check_ok(rl_parse_frame(&frame, rl_frame_name(frames[i]), "x", &error), &error);
        assert_int_equal(frame, frames[i]);
    }
    for (int i = 0; i < RL_INTERPOLATIONS; i++) {
        int interpolation = -1;
        check_ok(rl_parse_interpolation(&interpolation, rl_interpolation_name((enum rl_interpolation)i), "x",
                                        &error),
                 &error);
        assert_int_equal(interpolation, i);
    }
    assert_string_equal(rl_texel_format_name(RL_TEXEL_FORMATS), "unknown");
    assert_string_equal(rl_interpolation_name(RL_INTERPOLATIONS), "unknown");
}

static void test_margin(void **state)
{
    (void)state;
    struct rl_settings s = RL_SETTINGS_DEFAULT;
    char name[32];
    check_near(s.margin_bound, 0.02, 0.0);
    check_ok(rl_parse_margin(&s, "auto:0.005", "--margin", &error), &error);
    assert_int_equal(s.margin_kind, RL_MARGIN_AUTO);
    check_near(s.margin_bound, 0.005, 0.0);
    rl_margin_name(name, &s);
    assert_string_equal(name, "auto:0.005");
    check_ok(rl_parse_margin(&s, "auto", "--margin", &error), &error); /* what another bound was before */
    assert_int_equal(s.margin_kind, RL_MARGIN_AUTO);
    check_near(s.margin_bound, 0.02, 0.0);
    check_ok(rl_parse_margin(&s, "0.25", "--margin", &error), &error);
    assert_int_equal(s.margin_kind, RL_MARGIN_VALUE);
    check_near(s.margin, 0.25, 0.0);
    rl_margin_name(name, &s);
    assert_string_equal(name, "0.25");
    check_ok(rl_parse_margin(&s, "off", "--margin", &error), &error);
    assert_int_equal(s.margin_kind, RL_MARGIN_OFF);
    rl_margin_name(name, &s);
    assert_string_equal(name, "off");
}

static void test_misspelt(void **state)
{
    (void)state;
    enum rl_texel_format format;
    enum rl_frame_kind frame;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    int bits;
    check_fails(rl_parse_texel_format(&format, "rgba64", "--env-format", &error), &error, RL_ERR_INPUT,
                "--env-format: found 'rgba64', expected rgba8, rgb10a2,");
    check_fails(rl_parse_frame(&frame, "", NULL, &error), &error, RL_ERR_INPUT,
                "found '', expected orthonormal");
    int interpolation;
    check_fails(rl_parse_interpolation(&interpolation, "flat", "--interpolation", &error), &error,
                RL_ERR_INPUT, "--interpolation: found 'flat', expected phong, gouraud or constant");
    static const char *const no_bits[] = {"", "3", "17", "8.5", "8bit", "Half", "-16"};
    for (size_t i = 0; i < sizeof no_bits / sizeof no_bits[0]; i++)
        check_fails(rl_parse_normal_bits(&bits, no_bits[i], "--normal-bits", &error), &error, RL_ERR_INPUT,
                    "expected 4 to 16, half or float");
    static const char *const no_margin[] = {"", "-1", "nan", "inf", "1e7", "1x", "on"};
    for (size_t i = 0; i < sizeof no_margin / sizeof no_margin[0]; i++)
        check_fails(rl_parse_margin(&settings, no_margin[i], "--margin", &error), &error, RL_ERR_INPUT,
                    "expected off, auto, auto:BOUND or a number");
    static const char *const no_bound[] = {"auto:", "auto:0", "auto:1", "auto:-0.1", "auto:nan", "auto:0.1x"};
    for (size_t i = 0; i < sizeof no_bound / sizeof no_bound[0]; i++)
        check_fails(rl_parse_margin(&settings, no_bound[i], "--margin", &error), &error, RL_ERR_INPUT,
                    "expected a bound from 1e-6 to 0.999");
    assert_int_equal(settings.margin_kind, RL_MARGIN_OFF); /* as it was */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_default),        cmocka_unit_test(test_ranges),
        cmocka_unit_test(test_names_and_back), cmocka_unit_test(test_margin),
        cmocka_unit_test(test_misspelt),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
