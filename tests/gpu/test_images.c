/* Whole pictures of the scenes that come with the program: GPU against the CPU renderer, for every effect of the table. Highlights of shaped
 * lights are drawn by `plain`: the other methods are estimates, and have other tests. */
#include "gpu/fixture.h"
#include "reference/renderer.h"

/* Between them every effect. */
static const char *const scenes[] = {"lamps", "window", "metals", "fur", "glass"};
enum { N_SCENES = sizeof scenes / sizeof scenes[0], WIDTH = 160, HEIGHT = 120 };

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

static void load(struct rl_scene *scene, const char *name)
{
    struct rl_error error;
    char path[128];
    snprintf(path, sizeof path, "studies/scenes/%s.yaml", name);
    check_ok(rl_scene_load(scene, path, &error), &error);
    scene->settings.method = "plain";
    scene->width = WIDTH;
    scene->height = HEIGHT;
}

static void render_cpu(struct rl_image *image, const struct rl_scene *scene)
{
    struct rl_error error;
    struct rl_plan plan;
    struct rl_render_stats stats;
    check_ok(rl_plan_make(&plan, scene, &scene->settings, &error), &error);
    check_ok(rl_reference_render(image, &stats, scene, &plan, 1, NULL, &error), &error);
    rl_plan_clear(&plan);
}

/* At outlines the rasteriser decides to 1/256 of a pixel: another surface, or one a little off at a grazing angle. */
static void compare(const char *name, const struct rl_image *a, const struct rl_image *b)
{
    enum { OUTLIERS = 40 };
    size_t off = 0, foreground = 0;
    double worst = 0.0, sum = 0.0, brightest = 0.0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const float *p = rl_image_pixel((struct rl_image *)a, x, y);
            const float *q = rl_image_pixel((struct rl_image *)b, x, y);
            double here = 0.0, value = 0.0;
            for (int c = 0; c < 4; c++) {
                assert_true(isfinite(p[c]) && isfinite(q[c]));
                here = fmax(here, fabs((double)p[c] - (double)q[c]));
                value = fmax(value, fabs((double)q[c]));
            }
            foreground += q[3] > 0.0f;
            brightest = fmax(brightest, value);
            if (here > 2e-4 * (1.0 + value)) {
                off++;
                continue;
            }
            worst = fmax(worst, here);
            sum += here * here;
        }
    print_message("%-8s values to %-6.3g worst %-8.2g rmse %-8.2g outliers %zu of %zu\n", name, brightest,
                  worst, sqrt(sum / (double)foreground), off, foreground);
    assert_true(10 * foreground > (size_t)WIDTH * HEIGHT);
    assert_in_range(off, 0, OUTLIERS);
    assert_true(sqrt(sum / (double)foreground) < 2e-5);
}

static void test_images(void **state)
{
    (void)state;
    for (size_t i = 0; i < N_SCENES; i++) {
        struct rl_scene scene;
        struct rl_image drawn, expected;
        load(&scene, scenes[i]);
        fixture_render(&drawn, gpu, &scene, &scene.settings);
        render_cpu(&expected, &scene);
        compare(scenes[i], &drawn, &expected);
        rl_image_clear(&drawn);
        rl_image_clear(&expected);
        rl_scene_clear(&scene);
    }
}

/* Glass and gold share the program of the highlight pass, though not of the surface pass: each keeps its own factor. */
static void test_factors_keep_apart(void **state)
{
    (void)state;
    struct rl_scene scene;
    struct rl_image image;
    size_t golden = 0, grey = 0;
    load(&scene, "glass");
    scene.settings.method = "regular";
    fixture_render(&image, gpu, &scene, &scene.settings);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const float *p = rl_image_pixel(&image, x, y);
            golden += p[0] > 0.1f && p[0] > 1.5f * p[2];
            grey += p[0] > 0.02f && p[0] < 1.1f * p[2];
        }
    assert_true(golden > 50 && grey > 50);
    rl_image_clear(&image);
    rl_scene_clear(&scene);
}

static void test_every_effect_has_a_scene(void **state)
{
    (void)state;
    bool seen[RL_MATERIAL_EFFECTS_MAX] = {false};
    for (size_t i = 0; i < N_SCENES; i++) {
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_error error;
        load(&scene, scenes[i]);
        check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
        for (size_t m = 0; m < plan.n_materials; m++) {
            for (size_t e = 0; e < plan.material[m].n_effects; e++)
                for (size_t row = 0; row < rl_n_effects; row++)
                    seen[row] = seen[row] || rl_effects[row] == plan.material[m].effect[e];
        }
        rl_plan_clear(&plan);
        rl_scene_clear(&scene);
    }
    for (size_t row = 0; row < rl_n_effects; row++)
        if (!seen[row])
            fail_msg("no scene shows the effect %s", rl_effects[row]->name);
}

/* What lamps.yaml promises: one pass for all of it, and nothing beside the surface's own and the point and parallel lights' modules. */
static void test_lamps(void **state)
{
    (void)state;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_error error;
    struct rl_gpu_scene *gs;
    double seconds;
    load(&scene, "lamps");
    check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
    assert_int_equal(plan.n_programs, 1);
    assert_int_equal(plan.n_normal_maps + plan.n_patterns + plan.n_environments, 0);
    check_ok(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error);
    struct rl_gpu_counters counters = rl_gpu_scene_counters(gs);
    size_t mesh = 24 * scene.object[0].mesh.n_vertices + 12 * scene.object[0].mesh.n_triangles;
    assert_int_equal(counters.textures, 0);
    assert_int_equal(counters.programs, 1);
    assert_int_equal(counters.bytes_uploaded, mesh + 64); /* and the lights */
    rl_gpu_scene_reset_counters(gs);
    check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
    counters = rl_gpu_scene_counters(gs);
    assert_int_equal(counters.draws, 1);
    assert_int_equal(counters.bytes_uploaded, 0);
    rl_gpu_scene_free(gs);
    rl_plan_clear(&plan);
    rl_scene_clear(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_images),
        cmocka_unit_test(test_factors_keep_apart),
        cmocka_unit_test(test_every_effect_has_a_scene),
        cmocka_unit_test(test_lamps),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
