/* Whole pictures of the scenes that come with the program: GPU against the CPU renderer, for every effect of the table. Highlights of shaped
 * lights are drawn by `plain`: the other methods are estimates, and have other tests. */
#include "gpu/against_cpu.h"
#include "gpu/fixture.h"
#include "reference/renderer.h"
#include "scene/irradiance.h"
#include "studies/features.h"

/* Between them every effect that comes with the program; others are put on one of their materials. */
static const char *const scenes[] = {"lamps", "window", "metals", "fur", "glass", "office", "facets"};
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

static void check_image(const char *name, int interpolation, bool culling, size_t outliers)
{
    struct rl_scene scene;
    load(&scene, name);
    scene.settings.culling = culling;
    scene.settings.interpolation = interpolation;
    check_against_cpu(name, gpu, &scene, outliers);
    rl_scene_clear(&scene);
}

/* Whether the plan of the scene as it is has the effect. */
static bool shows(const struct rl_scene *scene, const struct rl_effect *effect)
{
    struct rl_plan plan;
    struct rl_error error;
    bool seen = false;
    check_ok(rl_plan_make(&plan, scene, &scene->settings, &error), &error);
    for (size_t m = 0; m < plan.n_materials; m++)
        for (size_t e = 0; e < plan.material[m].n_effects; e++)
            seen = seen || effect == plan.material[m].effect[e];
    rl_plan_clear(&plan);
    return seen;
}

static bool has_scene(const struct rl_effect *effect)
{
    bool seen = false;
    for (size_t i = 0; i < N_SCENES && !seen; i++) {
        struct rl_scene scene;
        load(&scene, scenes[i]);
        seen = shows(&scene, effect);
        rl_scene_clear(&scene);
    }
    return seen;
}

/* The effect on a material of the first scene where it does something, as the study `effects` puts it there: with values of its own choice.
 * To be cleared both, the view first. */
static void host(struct rl_view *view, struct rl_scene *scene, const struct rl_effect *effect)
{
    const struct rl_feature feature = {.name = effect->name, .kind = RL_FEATURE_EFFECT, .effect = effect};
    struct rl_error error;
    for (size_t i = 0; i < N_SCENES; i++) {
        load(scene, scenes[i]);
        check_ok(rl_view_make(view, scene, &scene->settings, &error), &error);
        rl_view_host(view, &feature);
        if (shows(&view->scene, effect))
            return;
        rl_view_clear(view);
        rl_scene_clear(scene);
    }
    fail_msg("no scene shows the effect %s, nor does one where it is put on a material", effect->name);
}

/* Every scene, and every effect that none of them names. */
static void check_images(int interpolation, size_t outliers)
{
    for (size_t i = 0; i < N_SCENES; i++)
        check_image(scenes[i], interpolation, true, outliers);
    for (size_t row = 0; row < rl_n_effects; row++) {
        struct rl_view view;
        struct rl_scene scene;
        if (has_scene(rl_effects[row]))
            continue;
        host(&view, &scene, rl_effects[row]);
        view.scene.settings.interpolation = interpolation;
        check_against_cpu(rl_effects[row]->name, gpu, &view.scene, outliers);
        rl_view_clear(&view);
        rl_scene_clear(&scene);
    }
}

static void test_images(void **state)
{
    (void)state;
    check_images(RL_INTERPOLATION_OF_MATERIAL, 40);
}

/* Every effect in the vertex shader. */
static void test_vertices(void **state)
{
    (void)state;
    check_images(RL_INTERPOLATION_GOURAUD, 40);
}

/* Of triangles with one value each every edge is an outline, where more pixels may be off. */
static void test_facets(void **state)
{
    (void)state;
    check_images(RL_INTERPOLATION_CONSTANT, 80);
}

/* The teapot has no bottom: from below its inside is seen, where back faces are. */
static void test_both_sides(void **state)
{
    (void)state;
    for (int i = 0; i < RL_INTERPOLATIONS; i++)
        check_image("lamps", i, false, 40);
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

/* Put on a material where no scene of its own would show it: of every effect that works. */
static void test_every_effect_is_hosted(void **state)
{
    (void)state;
    for (size_t row = 0; row < rl_n_effects; row++) {
        struct rl_view view;
        struct rl_scene scene;
        host(&view, &scene, rl_effects[row]);
        assert_true(shows(&view.scene, rl_effects[row]));
        rl_view_clear(&view);
        rl_scene_clear(&scene);
    }
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

/* On the letter of office.yaml a picture times white is what a luminance meter reads: k_d E/pi and the ambient 25 cd/m^2. */
static void test_cd_per_square_metre(void **state)
{
    (void)state;
    static const int pixels[][2] = {{80, 80}, {75, 75}, {90, 85}};
    struct rl_scene scene;
    struct rl_image image;
    struct rl_error error;
    load(&scene, "office");
    assert_int_equal(scene.n_lights + scene.n_sources, 4);
    fixture_render(&image, gpu, &scene, &scene.settings);
    for (size_t i = 0; i < sizeof pixels / sizeof pixels[0]; i++) {
        double rgb[4][3];
        int x = pixels[i][0], y = pixels[i][1];
        rl_vec3 d = rl_camera_ray(&scene.camera, WIDTH, HEIGHT, x, y), from = scene.camera.position;
        rl_vec3 P = v3_madd(from, (0.7501 - from.y) / d.y, d);
        check_ok(rl_scene_irradiance(rgb, &scene, P, v3(0, 1, 0), &error), &error);
        for (int c = 0; c < 3; c++) {
            double E = rgb[0][c] + rgb[1][c] + rgb[2][c] + rgb[3][c];
            check_relative(200.0 * (double)rl_image_pixel(&image, x, y)[c], 0.85 * E / RL_PI + 25.0, 1e-5);
        }
    }
    rl_image_clear(&image);
    rl_scene_clear(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_images),
        cmocka_unit_test(test_vertices),
        cmocka_unit_test(test_facets),
        cmocka_unit_test(test_both_sides),
        cmocka_unit_test(test_factors_keep_apart),
        cmocka_unit_test(test_every_effect_is_hosted),
        cmocka_unit_test(test_lamps),
        cmocka_unit_test(test_cd_per_square_metre),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
