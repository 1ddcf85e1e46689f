/* The hard scenes in tests/hard/scenes, small, by every method: no pixel that is not finite. One that cannot be drawn is refused with its
 * file and line instead: such a file's first line says with which words. */
#include "gpu/against_cpu.h"

#include <dirent.h>

#include "hard/scene_files.h"

static struct rl_gpu *gpu;

static int open_gpu(void **state)
{
    (void)state;
    struct rl_error error;
    return rl_gpu_open(&gpu, "auto", &error);
}

static int close_gpu(void **state)
{
    (void)state;
    rl_gpu_close(gpu);
    return 0;
}

static size_t check_finite(const struct rl_image *image, const char *scene, const char *method,
                           const char *how)
{
    size_t foreground = 0, bad = 0;
    for (size_t i = 0; i < 4 * (size_t)image->width * (size_t)image->height; i++) {
        bad += !isfinite(image->data[i]) || image->data[i] < 0.0f;
        foreground += i % 4 == 3 && image->data[i] > 0.0f;
    }
    if (bad > 0)
        print_error("%s, %s%s: %zu values are negative or not finite\n", scene, method, how, bad);
    assert_true(foreground > 0);
    return bad;
}

/* What the GPU's pipeline has to choose from. */
static const struct {
    const char *name;
    enum rl_texel_format format;
    enum rl_margin margin;
    int bits;
    enum rl_frame_kind frame;
} variants[] = {
    {"", RL_TEXEL_RGBA8, RL_MARGIN_OFF, 8, RL_FRAME_ORTHONORMAL},
    {", halves", RL_TEXEL_RGBA16F, RL_MARGIN_AUTO, RL_NORMAL_BITS_HALF, RL_FRAME_ORTHONORMAL},
    {", floats", RL_TEXEL_RGBA32F, RL_MARGIN_VALUE, RL_NORMAL_BITS_FLOAT, RL_FRAME_PRINTED},
    {", r11g11b10f", RL_TEXEL_R11G11B10F, RL_MARGIN_OFF, 16, RL_FRAME_ORTHONORMAL},
};

static size_t draw_on_gpu(const char *name, const struct rl_scene *scene, const struct rl_method *method)
{
    size_t bad = 0;
    size_t n = method->needs_environment ? sizeof variants / sizeof variants[0] : 1;
    for (size_t i = 0; i < n; i++) {
        struct rl_settings settings = scene->settings;
        struct rl_image image;
        settings.method = method->name;
        settings.env_format = variants[i].format;
        settings.env_size = 32;
        settings.normal_size = 64;
        settings.normal_bits = variants[i].bits;
        settings.margin_kind = variants[i].margin;
        settings.margin = 0.1;
        settings.frame = method->orthonormal_only ? RL_FRAME_ORTHONORMAL : variants[i].frame;
        fixture_render(&image, gpu, scene, &settings);
        bad += check_finite(&image, name, method->name, variants[i].name);
        rl_image_clear(&image);
    }
    return bad;
}

static size_t draw_on_cpu(const char *name, struct rl_scene *scene, const struct rl_method *method)
{
    struct rl_image image;
    scene->settings.method = method->name;
    scene->settings.env_size = 16;
    scene->settings.tolerance = 1e-4;
    render_cpu(&image, scene);
    size_t bad = check_finite(&image, name, method->name, " on the CPU");
    rl_image_clear(&image);
    return bad;
}

static size_t draw_scene(const char *name, const char *path)
{
    struct rl_error error;
    struct rl_scene scene;
    size_t bad = 0;
    check_ok(rl_scene_load(&scene, path, &error), &error);
    for (size_t m = 0; m < rl_n_methods; m++) {
        if (rl_methods[m]->on_gpu)
            bad += draw_on_gpu(name, &scene, rl_methods[m]);
        if (rl_methods[m]->on_cpu)
            bad += draw_on_cpu(name, &scene, rl_methods[m]);
    }
    rl_scene_clear(&scene);
    return bad;
}

static void test_pictures(void **state)
{
    (void)state;
    struct scene_files files;
    size_t bad = 0, drawn = 0;
    scene_files_list(&files);
    for (size_t i = 0; i < files.n; i++) {
        if (files.refused[i][0])
            continue;
        print_message("%s\n", files.name[i]);
        bad += draw_scene(files.name[i], files.path[i]);
        drawn++;
    }
    assert_int_equal(bad, 0);
    assert_true(drawn >= 15);
}

static void test_refused(void **state)
{
    (void)state;
    struct scene_files files;
    struct rl_error error;
    struct rl_scene scene;
    size_t refused = 0;
    scene_files_list(&files);
    for (size_t i = 0; i < files.n; i++) {
        if (!files.refused[i][0])
            continue;
        print_message("%s: %s\n", files.name[i], files.refused[i]);
        check_fails(rl_scene_load(&scene, files.path[i], &error), &error, RL_ERR_INPUT, files.refused[i]);
        const char *at = strstr(error.message, files.path[i]);
        assert_non_null(at);
        at += strlen(files.path[i]);
        assert_true(at[0] == ':' && at[1] >= '1' && at[1] <= '9'); /* the line */
        rl_scene_clear(&scene);
        refused++;
    }
    assert_true(refused >= 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pictures),
        cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
