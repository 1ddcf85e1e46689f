/* Provenance attributes: what was set is what an image says, also after a file. */
#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/hash.h"
#include "base/version.h"
#include "results/stamp.h"
#include "support/check.h"
#include "support/temporary.h"

static struct rl_error error;

static void expect_text(const struct rl_image *image, const char *name, const char *value)
{
    const struct rl_attribute *a = rl_image_attribute(image, name);
    assert_non_null(a);
    assert_non_null(a->string);
    assert_string_equal(a->string, value);
}

static void expect_number(const struct rl_image *image, const char *name, double value)
{
    const struct rl_attribute *a = rl_image_attribute(image, name);
    assert_non_null(a);
    assert_null(a->string);
    assert_true(a->number == value);
}

static void expect_stamp(const struct rl_image *image, const struct rl_scene *scene)
{
    static const struct {
        const char *name, *value;
    } text[] = {
        {"roughlight:scene", "two-roughness.yaml"},
        {"roughlight:normal_bits", "half"},
        {"roughlight:env_format", "r11g11b10f"},
        {"roughlight:attenuation", "off"},
        {"roughlight:shadows", "off"},
        {"roughlight:culling", "on"},
        {"roughlight:reversed_depth", "off"},
        {"roughlight:frame", "printed"},
        {"roughlight:light_from", "object"},
        {"roughlight:seed", "12345678901234567890"},
        {"roughlight:renderer", "a test"},
    };
    for (size_t i = 0; i < sizeof text / sizeof text[0]; i++)
        expect_text(image, text[i].name, text[i].value);
    char hash[RL_HASH_TEXT];
    rl_hash_text(hash, scene->hash);
    expect_text(image, "roughlight:scene_hash", hash);
    expect_text(image, "roughlight:version", rl_version.version);
    expect_number(image, "roughlight:env_size", 128.0);
    expect_number(image, "roughlight:margin", 0.25);
    expect_number(image, "roughlight:depth_bits", 24.0);
    expect_number(image, "roughlight:tolerance", 0x1p-20);
    expect_number(image, "roughlight:seconds", 0.5);
    expect_number(image, "roughlight:threads", 3.0);
    expect_number(image, "roughlight:foreground", 4.0);
    expect_number(image, "roughlight:within_tolerance", 3.0);
    expect_number(image, "roughlight:worst_error", 0.5);
    expect_number(image, "roughlight:rms_error", 0.25);
    expect_number(image, "roughlight:mean_error", 0.125);
    expect_number(image, "roughlight:max_seconds", 10.0);
    expect_number(image, "whiteLuminance", 3000.0);
    const struct rl_attribute *materials = rl_image_attribute(image, "roughlight:materials");
    assert_non_null(materials);
    assert_non_null(strstr(materials->string, "regular 21, R_r 7, gouraud"));
    assert_non_null(rl_image_attribute(image, "roughlight:cpu"));
    assert_non_null(rl_image_attribute(image, "roughlight:date"));
}

static void test_stamp(void **state)
{
    (void)state;
    struct temporary folder = {0};
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_image image = {0};
    struct rl_image read = {0};
    struct rl_write_report report;
    char path[PATH_MAX];
    check_ok(rl_scene_load(&scene, "studies/scenes/two-roughness.yaml", &error), &error);
    struct rl_settings s = scene.settings;
    s.method = "regular";
    s.samples = 21;
    s.rr = 7.0;
    s.normal_bits = RL_NORMAL_BITS_HALF;
    s.env_size = 128;
    s.env_format = RL_TEXEL_R11G11B10F;
    s.margin_kind = RL_MARGIN_VALUE;
    s.margin = 0.25;
    s.seed = UINT64_C(12345678901234567890);
    s.attenuation = false;
    s.frame = RL_FRAME_PRINTED;
    s.interpolation = RL_INTERPOLATION_GOURAUD;
    s.light_from = RL_LIGHT_FROM_OBJECT;
    s.tolerance = 0x1p-20; /* a number that an EXR's 32-bit float holds exactly */
    check_ok(rl_plan_make(&plan, &scene, &s, &error), &error);
    check_ok(rl_image_allocate(&image, 2, 2, 4, &error), &error);
    check_ok(rl_stamp_image(&image, &scene, &plan, "a test", 3, 0.5, &error), &error);
    assert_null(rl_image_attribute(&image, "whiteLuminance")); /* the scene is radiometric */
    scene.white = 3000.0;
    check_ok(rl_stamp_image(&image, &scene, &plan, "a test", 3, 0.5, &error), &error);
    const struct rl_stamp_accuracy accuracy = {4, 3, 0.5, 0.25, 0.125, 10.0};
    check_ok(rl_stamp_accuracy(&image, &accuracy, &error), &error);
    expect_stamp(&image, &scene);

    temporary_make(&folder);
    temporary_path(&folder, path, "stamp.exr");
    check_ok(rl_image_write(&image, path, &report, &error), &error);
    check_ok(rl_image_read(&read, path, &error), &error);
    expect_stamp(&read, &scene);
    temporary_remove(&folder);
    rl_image_clear(&read);
    rl_image_clear(&image);
    rl_plan_clear(&plan);
    rl_scene_clear(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_stamp)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
