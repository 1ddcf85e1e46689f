/* What the plan drops of the CPU's work changes no bit of a picture nor of its stated errors; and what may not be dropped there is not. */
#include "gpu/drop_scene.h"
#include "reference/renderer.h"

static void draw(struct rl_image *image, struct rl_image *errors, const struct rl_scene *scene,
                 const struct rl_settings *settings, size_t *dropped_lights)
{
    struct rl_error error;
    struct rl_plan plan;
    struct rl_render_stats stats;
    const struct rl_render_limits limits = {.threads = 1, .errors = errors};
    check_ok(rl_plan_make(&plan, scene, settings, &error), &error);
    assert_true(plan.on_cpu);
    *dropped_lights = scene->n_lights + scene->n_sources - plan.n_lights - plan.n_sources;
    check_ok(rl_reference_render_within(image, &stats, scene, &plan, &limits, NULL, &error), &error);
    rl_plan_clear(&plan);
}

/* Returns how many lights are dropped. */
static size_t check_drop(const struct rl_scene *scene, struct rl_settings settings)
{
    struct rl_image with = {0}, without = {0}, off_with = {0}, off_without = {0};
    size_t dropped_lights, none;
    settings.drop = true;
    draw(&with, &off_with, scene, &settings, &dropped_lights);
    settings.drop = false;
    draw(&without, &off_without, scene, &settings, &none);
    assert_int_equal(none, 0);
    size_t bytes = 4 * sizeof(float) * (size_t)with.width * (size_t)with.height;
    assert_memory_equal(with.data, without.data, bytes);
    assert_memory_equal(off_with.data, off_without.data, bytes);
    rl_image_clear(&with);
    rl_image_clear(&without);
    rl_image_clear(&off_with);
    rl_image_clear(&off_without);
    return dropped_lights;
}

enum variant {
    ORDINARY,
    SHADOWS,
    UNATTENUATED,
    FROM_OBJECT,
    BOTH_SIDES,
    CUT,
    GOURAUD,
    CONSTANT,
    FUR,
    BRIGHT_BELOW, /* the dropped light is the brightest, of which the tolerance is a part */
    ONE_RADIANCE, /* and all lights are seen as one */
    DARK_BELOW,
    VARIANTS
};

static void make_variant(struct rl_scene *scene, struct rl_settings *settings, const char *method,
                         enum variant variant, bool ball)
{
    *settings = RL_SETTINGS_DEFAULT;
    settings->method = method;
    settings->env_size = 32;
    settings->tolerance = 1e-4;
    settings->width = 24;
    settings->height = 18;
    begin_scene(scene, method, ball);
    settings->shadows = variant == SHADOWS;
    settings->attenuation = variant != UNATTENUATED;
    settings->light_from = variant == FROM_OBJECT ? RL_LIGHT_FROM_OBJECT : RL_LIGHT_FROM_POINT;
    settings->culling = variant != BOTH_SIDES;
    if (variant == CUT) {
        scene->camera.near_plane = 4.9;
        scene->camera.far_plane = 5.3;
    }
    if (variant == GOURAUD || variant == CONSTANT)
        settings->interpolation = variant == GOURAUD ? RL_INTERPOLATION_GOURAUD : RL_INTERPOLATION_CONSTANT;
    if (variant == FUR) {
        memset(&scene->material[0].effect, 0, sizeof scene->material[0].effect);
        give(&scene->material[0], "kajiya", 0.4, 0.2);
    }
    for (int c = 0; c < 3; c++) {
        if (variant == BRIGHT_BELOW)
            scene->light[1].radiance[c] = 500.0 * (c + 1);
        if (variant == ONE_RADIANCE)
            scene->light[1].radiance[c] = scene->light[0].radiance[c];
        if (variant == DARK_BELOW)
            scene->light[1].radiance[c] = 0.0;
    }
}

static void test_same_bits(void **state)
{
    (void)state;
    static const char *const methods[] = {"reference", "exhaustive"};
    size_t most = 0;
    for (size_t i = 0; i < sizeof methods / sizeof methods[0]; i++)
        for (int ball = 0; ball < 2; ball++)
            for (int k = 0; k < VARIANTS; k++) {
                struct rl_scene scene;
                struct rl_settings settings;
                if (i == 1 && k == SHADOWS)
                    continue;
                make_variant(&scene, &settings, methods[i], (enum variant)k, ball);
                size_t lights = check_drop(&scene, settings);
                most = lights > most ? lights : most;
                fixture_end(&scene);
            }
    /* One shaped light, a point and a parallel light behind the floor, a parallel one without strength. */
    assert_int_equal(most, 4);
}

static void test_scenes(void **state)
{
    (void)state;
    static const char *const names[] = {"sphere-quad", "lamps",      "window", "metals",
                                        "fur",         "everything", "facets", "ball-shadow"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        struct rl_scene scene;
        struct rl_error error;
        char path[128];
        snprintf(path, sizeof path, "studies/scenes/%s.yaml", names[i]);
        check_ok(rl_scene_load(&scene, path, &error), &error);
        struct rl_settings settings = scene.settings;
        settings.method = "reference";
        settings.tolerance = 1e-3;
        settings.width = 24;
        settings.height = 18;
        for (int shadows = 0; shadows < 2; shadows++) {
            settings.shadows = shadows == 1;
            check_drop(&scene, settings);
        }
        rl_scene_clear(&scene);
    }
}

/* The middle of the picture with shadows on, off, and what the plan says of the object `away`. */
static void test_keeps_casters(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    float middle[2];
    fixture_begin(&scene, 33, 25);
    fixture_camera(&scene, v3(0.0, 2.0, 5.0), v3(0.0, 0.0, 0.0), 10.0);
    int floor = fixture_material(&scene, 5.0, 0.05, 0.5, 0.0, NULL);
    /* Without any effect it is black, and casts a shadow. */
    scene.material[scene.n_materials++] = (struct rl_material){.name = "black", .rr = 5.0};
    fixture_object(&scene, RL_SHAPE_PLANE, 4, 2.0, v3(0.0, 0.0, 0.0), floor);
    fixture_object(&scene, RL_SHAPE_SPHERE, 8, 0.5, v3(0.0, 3.0, -3.0), 1);
    scene.material[0].name = "floor";
    scene.object[0].name = "floor";
    scene.object[1].name = "away";
    fixture_source(&scene, true, v3(0.0, 1.0, -1.0), 1.0, 1.0, 1.0);
    scene.source[0].name = "sun";
    for (int shadows = 0; shadows < 2; shadows++) {
        struct rl_plan plan;
        struct rl_image image = {0}, errors = {0};
        size_t lights;
        settings.method = "reference";
        settings.shadows = shadows == 1;
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        assert_false(plan.object[1].drawn);
        assert_true(plan.shadows == settings.shadows && plan.n_sources == 1);
        assert_true(dropped(&plan, "object", "away", shadows ? "its shadow is not" : "outside the view"));
        rl_plan_clear(&plan);
        draw(&image, &errors, &scene, &settings, &lights);
        middle[shadows] = rl_image_pixel(&image, 16, 12)[1];
        rl_image_clear(&image);
        rl_image_clear(&errors);
        check_drop(&scene, settings);
    }
    assert_true(middle[0] > 0.1f);
    check_near(middle[1], 0.8 * 0.05, 1e-7);
    fixture_end(&scene);
}

/* A dark light before another hides it from the integral. */
static void test_keeps_dark_lights(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_settings settings;
    make_variant(&scene, &settings, "reference", ORDINARY, true);
    fixture_quad(&scene, v3(-0.6, 1.0, -1.5), v3(0.4, 0.0, 0.0), v3(0.0, 0.4, 0.1), 0.0, 0.0, 0.0);
    scene.light[2].name = "lid";
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    /* The ball sees the light under the floor. */
    assert_int_equal(plan.n_lights, 3);
    rl_plan_clear(&plan);
    check_drop(&scene, settings);
    scene.n_objects = 2;
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_int_equal(plan.n_lights, 2);
    assert_true(plan.light[0] == 0 && plan.light[1] == 2);
    assert_true(dropped(&plan, "light", "low", "behind every surface"));
    rl_plan_clear(&plan);
    check_drop(&scene, settings);
    fixture_end(&scene);
}

/* Shadows of nothing are dropped, and said to be. */
static void test_no_shadows(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_settings settings;
    make_variant(&scene, &settings, "reference", SHADOWS, true);
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_true(plan.shadows);
    rl_plan_clear(&plan);
    scene.n_objects = 1;
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_true(!plan.shadows && dropped(&plan, "effect", "shadows", "a single object"));
    rl_plan_clear(&plan);
    check_drop(&scene, settings);
    scene.n_objects = 3;
    size_t n = scene.n_lights;
    scene.n_lights = scene.n_sources = 0;
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_true(!plan.shadows && dropped(&plan, "effect", "shadows", "no light that could be hidden"));
    rl_plan_clear(&plan);
    check_drop(&scene, settings);
    scene.n_lights = n;
    /* A method of the GPU has none; asked for by name it is refused even where it has no highlight to draw. */
    settings.method = "random";
    assert_int_equal(rl_plan_make(&plan, &scene, &settings, &error), RL_ERR_INPUT);
    assert_non_null(strstr(error.message, "which the method random cannot draw"));
    scene.n_lights = 0;
    assert_int_equal(rl_plan_make(&plan, &scene, &settings, &error), RL_ERR_INPUT);
    scene.n_lights = n;
    fixture_end(&scene);
}

/* The same of squares whose bounding spheres reach over the floor, by both methods of the CPU. */
static void test_squares(void **state)
{
    (void)state;
    static const char *const methods[] = {"reference", "exhaustive"};
    for (size_t i = 0; i < 2 * sizeof drop_squares / sizeof drop_squares[0]; i++) {
        const struct drop_square *row = &drop_squares[i / 2];
        struct rl_scene scene;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        settings.method = methods[i % 2];
        settings.env_size = 32;
        settings.tolerance = 1e-4;
        settings.width = 24;
        settings.height = 18;
        begin_square(&scene, row);
        size_t lights = check_drop(&scene, settings);
        assert_true(lights <= row->drops || (row->method && settings.method != row->method));
        fixture_end(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_same_bits),     cmocka_unit_test(test_scenes),
        cmocka_unit_test(test_keeps_casters), cmocka_unit_test(test_keeps_dark_lights),
        cmocka_unit_test(test_no_shadows),    cmocka_unit_test(test_squares),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
