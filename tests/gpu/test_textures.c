/* Normal maps hold the method's normals to their bits; samples of a pixel are different texels. */
#include "gpu/fixture.h"
#include "gpu/program.h"
#include "gpu/textures.h"

/* A texel as a shader decodes it: 2 t - 1. Halves are handed over as floats. */
static void decode(double h[3], const struct rl_normal_texels *texels, size_t i)
{
    for (int c = 0; c < 3; c++) {
        double t;
        if (texels->type == GL_FLOAT)
            t = ((const float *)texels->data)[4 * i + (size_t)c];
        else if (texels->type == GL_UNSIGNED_BYTE)
            t = ((const uint8_t *)texels->data)[4 * i + (size_t)c] / 255.0;
        else if (texels->type == GL_UNSIGNED_SHORT)
            t = ((const uint16_t *)texels->data)[4 * i + (size_t)c] / 65535.0;
        else
            t = (((const uint32_t *)texels->data)[i] >> (10 * c) & 1023) / 1023.0;
        h[c] = 2.0 * t - 1.0;
    }
}

static void normals_are_the_methods_to_their_bits(void **state)
{
    (void)state;
    static const struct {
        int bits;
        GLenum internal_format;
        double step; /* of the stored value (H + 1)/2 */
        double tolerance;
    } rows[] = {
        {4, GL_RGBA16, 1.0 / 15, 1e-5},
        {5, GL_RGBA16, 1.0 / 31, 1e-5},
        {7, GL_RGBA16, 1.0 / 127, 1e-5},
        {8, GL_RGBA8, 1.0 / 255, 1e-12},
        {9, GL_RGBA16, 1.0 / 511, 1e-5},
        {10, GL_RGB10_A2, 1.0 / 1023, 1e-12},
        {12, GL_RGBA16, 1.0 / 4095, 1e-5},
        {15, GL_RGBA16, 1.0 / 32767, 1e-5},
        {16, GL_RGBA16, 1.0 / 65535, 1e-12},
        {RL_NORMAL_BITS_HALF, GL_RGBA16F, 1.0 / 2048, 1e-12},
        {RL_NORMAL_BITS_FLOAT, GL_RGBA32F, 1e-7, 1e-12},
    };
    const struct rl_method *method = rl_method_find("random");
    const struct rl_plan_normal_map map = {.rr = 7.0, .method = method};
    struct rl_ellipsoid e = rl_ellipsoid_make(map.rr);
    for (size_t r = 0; r < sizeof rows / sizeof rows[0]; r++) {
        struct rl_error error;
        struct rl_normal_texels texels;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        settings.normal_bits = rows[r].bits;
        settings.normal_size = 64;
        settings.seed = 5;
        check_ok(rl_normal_texels_make(&texels, &map, &settings, &error), &error);
        assert_int_equal(texels.internal_format, rows[r].internal_format);
        for (size_t i = 0; i < (size_t)64 * 64; i++) {
            double h[3];
            struct rl_microfacet expected = method->texel(&e, 5, i);
            decode(h, &texels, i);
            check_near(rl_normal_component(rows[r].bits, expected.x), h[0], 1e-15);
            check_near(rl_normal_component(rows[r].bits, expected.y), h[1], 1e-15);
            check_near(rl_normal_component(rows[r].bits, expected.z), h[2], 1e-15);
            /* Half a step of the stored value is a whole one of H. */
            check_near(h[0], expected.x, rows[r].step + 2.0 * rows[r].tolerance);
            check_near(h[1], expected.y, rows[r].step + 2.0 * rows[r].tolerance);
            check_near(h[2], expected.z, rows[r].step + 2.0 * rows[r].tolerance);
            /* Nothing but the steps occurs; those of floats vary. */
            double level = (h[1] + 1.0) / 2.0 / rows[r].step;
            if (texels.type != GL_FLOAT)
                check_near(level, round(level), 2e-5 / rows[r].step);
        }
        free(texels.data);
    }
}

/* What is read back from the GPU is what was baked: no driver's format or rounding stands between. */
static void the_gpu_holds_what_was_baked(void **state)
{
    (void)state;
    static const int bits[] = {4, 5, 6, 8, 10, 12, 16, RL_NORMAL_BITS_HALF, RL_NORMAL_BITS_FLOAT};
    const struct rl_plan_normal_map map = {.rr = 30.0, .method = rl_method_find("random")};
    struct rl_error error;
    struct rl_gpu *gpu;
    check_ok(rl_gpu_open(&gpu, "auto", &error), &error);
    for (size_t b = 0; b < sizeof bits / sizeof bits[0]; b++) {
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        struct rl_normal_texels texels;
        float *read;
        settings.normal_bits = bits[b];
        settings.normal_size = 64;
        settings.seed = 9;
        check_ok(rl_normal_texels_make(&texels, &map, &settings, &error), &error);
        check_ok(rl_gpu_normal_map_read(&read, gpu, &map, &settings, &error), &error);
        for (size_t i = 0; i < (size_t)64 * 64; i++) {
            double h[3];
            decode(h, &texels, i);
            for (size_t c = 0; c < 3; c++)
                check_near(2.0 * read[4 * i + c] - 1.0, h[c], 2.5e-7);
        }
        free(read);
        free(texels.data);
    }
    rl_gpu_close(gpu);
}

static void samples_of_a_pixel_are_distinct_texels(void **state)
{
    (void)state;
    static const int sizes[] = {64, 128, 256, 512, 1024, 2048};
    for (size_t s = 0; s < sizeof sizes / sizeof sizes[0]; s++) {
        unsigned texels = (unsigned)sizes[s] * (unsigned)sizes[s];
        unsigned step = rl_normal_map_step(sizes[s]);
        assert_true(step % 2 == 1);
        unsigned char *seen = calloc(texels, 1);
        assert_non_null(seen);
        for (unsigned i = 0; i < RL_SAMPLES_MAX; i++) {
            unsigned at = i * step & (texels - 1);
            assert_false(seen[at]);
            seen[at] = 1;
        }
        /* The same in the shader's 32 bits: no product may be cut. */
        assert_true((uint64_t)step * (RL_SAMPLES_MAX - 1) <= UINT32_MAX);
        free(seen);
    }
}

static void units_keep_floats_exact(void **state)
{
    (void)state;
    static const float scales[] = {1.0f, 3.0f, 1e-20f, 65504.0f, 3e38f, 0.7f};
    for (size_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
        int exponent;
        float unit = rl_texel_unit(RL_TEXEL_RGBA16F, scales[i]);
        assert_true(frexpf(unit, &exponent) == 0.5f && isfinite(unit));
        assert_true(scales[i] / unit <= 2.0f && scales[i] / unit >= 0.5f);
        assert_true(rl_texel_unit(RL_TEXEL_RGBA8, scales[i]) == scales[i]);
    }
    assert_true(rl_texel_unit(RL_TEXEL_RGBA8, 0.0f) == 1.0f);
}

/* What is drawn becomes the nearest level whether OpenGL rounds or cuts off. */
static void texels_are_safe_from_either_rounding(void **state)
{
    (void)state;
    static const struct {
        enum rl_texel_format format;
        double levels;
    } rows[] = {{RL_TEXEL_RGBA8, 255}, {RL_TEXEL_RGB10A2, 1023}, {RL_TEXEL_RGBA16, 65535}};
    for (size_t r = 0; r < sizeof rows / sizeof rows[0]; r++)
        for (int i = 0; i <= 1000; i++) {
            double value = i / 1000.0;
            double drawn = rl_texel_nearest(rows[r].format, 0, value) * rows[r].levels;
            double fraction = drawn - floor(drawn);
            check_near(drawn, value * rows[r].levels, 0.76);
            assert_true(drawn == rows[r].levels || (fraction > 0.05 && fraction < 0.45));
        }
    /* By hand: steps of 2^-11, 2^-7 and 2^-6 between 1/2 and 1, and of 2^-24 below the least normal half. */
    check_near(rl_texel_nearest(RL_TEXEL_RGBA16F, 0, 0.70003), 1434.0 / 2048, 0.0);
    check_near(rl_texel_nearest(RL_TEXEL_R11G11B10F, 0, 0.7), 90.0 / 128, 0.0);
    check_near(rl_texel_nearest(RL_TEXEL_R11G11B10F, 2, 0.7), 45.0 / 64, 0.0);
    check_near(rl_texel_nearest(RL_TEXEL_RGBA16F, 0, 0x1.8p-24), 0x1p-23, 0.0);
    check_near(rl_texel_nearest(RL_TEXEL_RGBA32F, 0, 0.7), (float)0.7, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_are_the_methods_to_their_bits),
        cmocka_unit_test(the_gpu_holds_what_was_baked),
        cmocka_unit_test(samples_of_a_pixel_are_distinct_texels),
        cmocka_unit_test(units_keep_floats_exact),
        cmocka_unit_test(texels_are_safe_from_either_rounding),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
