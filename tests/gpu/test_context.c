/* Contexts: each backend opens or says why not, both software ones draw the same bits, and no environment
 * variable ends the process. */
#include "gpu/fixture.h"

static void names_are_the_documented_ones(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_gpu *gpu;
    assert_int_equal(rl_n_gpu_backends, 3);
    assert_int_equal(rl_gpu_open(&gpu, "bogus", &error), RL_ERR_INPUT);
    assert_null(gpu);
    assert_non_null(strstr(error.message, "bogus"));
    for (size_t i = 0; i < rl_n_gpu_backends; i++)
        assert_non_null(strstr(error.message, rl_gpu_backends[i]));
}

static void osmesa_opens_and_describes_itself(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_gpu *gpu;
    for (int i = 0; i < 3; i++) {
        check_ok(rl_gpu_open(&gpu, "osmesa", &error), &error);
        const struct rl_gpu_info *info = rl_gpu_describe(gpu);
        assert_string_equal(info->backend, "osmesa");
        assert_non_null(strstr(info->version, "4.5"));
        assert_true(strlen(info->renderer) > 0 && strlen(info->vendor) > 0 && strlen(info->glsl) > 0);
        rl_gpu_close(gpu);
    }
}

/* As `info` does it: each in turn, in one process, however the one before ended. */
static void every_backend_opens_or_says_why(void **state)
{
    (void)state;
    for (size_t round = 0; round < 2; round++)
        for (size_t i = 0; i < rl_n_gpu_backends; i++) {
            struct rl_error error = {0};
            struct rl_gpu *gpu;
            int status = rl_gpu_open(&gpu, rl_gpu_backends[i], &error);
            if (status == RL_OK) {
                assert_string_equal(rl_gpu_describe(gpu)->backend, rl_gpu_backends[i]);
                rl_gpu_close(gpu);
            } else {
                assert_int_equal(status, RL_ERR_UNAVAILABLE);
                assert_non_null(strstr(error.message, rl_gpu_backends[i]));
                print_message("%s\n", error.message);
            }
        }
}

static void draw(struct rl_image *image, struct rl_gpu *gpu)
{
    struct rl_scene scene;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    fixture_sphere(&scene, 160, 120, "random", 10.0);
    fixture_render(image, gpu, &scene, &settings);
    fixture_end(&scene);
}

static void both_software_backends_draw_the_same_bits(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_gpu *gpu;
    struct rl_image osmesa;
    struct rl_image egl;
    check_ok(rl_gpu_open(&gpu, "osmesa", &error), &error);
    draw(&osmesa, gpu);
    char renderer[sizeof rl_gpu_describe(gpu)->renderer];
    snprintf(renderer, sizeof renderer, "%s", rl_gpu_describe(gpu)->renderer);
    rl_gpu_close(gpu);
    int status = rl_gpu_open(&gpu, "egl-surfaceless", &error);
    if (status != RL_OK || strcmp(renderer, rl_gpu_describe(gpu)->renderer) != 0) {
        print_message("skipped: %s\n", status != RL_OK ? error.message : rl_gpu_describe(gpu)->renderer);
        rl_gpu_close(gpu);
        rl_image_clear(&osmesa);
        skip();
    }
    draw(&egl, gpu);
    rl_gpu_close(gpu);
    assert_int_equal(osmesa.width, egl.width);
    assert_memory_equal(osmesa.data, egl.data, sizeof(float) * 4 * 160 * 120);
    rl_image_clear(&osmesa);
    rl_image_clear(&egl);
}

/* `softpipe` is a driver that Mesa knows and that lacks OpenGL 4.5; but a process keeps the first driver it
 * has loaded. */
static void an_unknown_driver_is_an_error_and_no_crash(void **state)
{
    (void)state;
    static const char *const drivers[] = {"nonsense", "zink", "swr"};
    const char *before = getenv("GALLIUM_DRIVER");
    char kept[64];
    snprintf(kept, sizeof kept, "%s", before ? before : "");
    struct rl_error error;
    struct rl_gpu *gpu;
    for (size_t i = 0; i < sizeof drivers / sizeof drivers[0]; i++) {
        setenv("GALLIUM_DRIVER", drivers[i], 1);
        check_fails(rl_gpu_open(&gpu, "osmesa", &error), &error, RL_ERR_UNAVAILABLE, "GALLIUM_DRIVER");
        assert_null(gpu);
    }
    setenv("GALLIUM_DRIVER", "", 1);
    check_ok(rl_gpu_open(&gpu, "osmesa", &error), &error);
    rl_gpu_close(gpu);
    if (before)
        setenv("GALLIUM_DRIVER", kept, 1);
    else
        unsetenv("GALLIUM_DRIVER");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_are_the_documented_ones),
        cmocka_unit_test(osmesa_opens_and_describes_itself),
        cmocka_unit_test(every_backend_opens_or_says_why),
        cmocka_unit_test(both_software_backends_draw_the_same_bits),
        cmocka_unit_test(an_unknown_driver_is_an_error_and_no_crash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
