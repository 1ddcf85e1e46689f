/* What the plan drops changes no pixel by a bit, and is named with its reason; what the GPU does follows from the plan. */
#include "gpu/drop_scene.h"

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

static void test_same_bits(void **state)
{
    (void)state;
    static const char *const methods[] = {NULL, "plain", "regular", "random"};
    for (size_t i = 0; i < sizeof methods / sizeof methods[0]; i++)
        for (int ball = 0; ball < 2; ball++)
            for (int k = 0; k < (i < 2 ? 8 : 6); k++) {
                struct rl_scene scene;
                struct rl_settings settings = RL_SETTINGS_DEFAULT;
                settings.env_size = 64;
                settings.attenuation = k != 1;
                settings.margin_kind = k == 2 ? RL_MARGIN_VALUE : RL_MARGIN_OFF;
                settings.margin = 0.3;
                settings.culling = k != 4;
                begin_scene(&scene, methods[i], ball);
                if (k == 4) /* the floor's back, lit from below */
                    fixture_camera(&scene, v3(0.0, -2.0, 5.0), v3(0.0, 0.0, 0.0), 30.0);
                if (k == 5) { /* the floor cut off on both sides, the ball cut open */
                    scene.camera.near_plane = 4.9;
                    scene.camera.far_plane = 5.3;
                }
                if (k > 5)
                    settings.interpolation = k == 6 ? RL_INTERPOLATION_GOURAUD : RL_INTERPOLATION_CONSTANT;
                if (k == 3) {
                    memset(&scene.material[0].effect, 0, sizeof scene.material[0].effect);
                    give(&scene.material[0], "kajiya", 0.4, 0.2);
                }
                fixture_check_drop(gpu, &scene, settings);
                fixture_end(&scene);
            }
}

/* The same of the scenes that come along. */
static void test_scenes(void **state)
{
    (void)state;
    static const char *const names[] = {"teapot-star", "sphere-quad", "two-roughness", "three-lights",
                                        "lamps",       "window",      "metals",        "fur",
                                        "glass",       "everything",  "office",        "facets"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        struct rl_scene scene;
        struct rl_error error;
        char path[128];
        snprintf(path, sizeof path, "studies/scenes/%s.yaml", names[i]);
        check_ok(rl_scene_load(&scene, path, &error), &error);
        scene.width = 96;
        scene.height = 72;
        fixture_check_drop(gpu, &scene, scene.settings);
        rl_scene_clear(&scene);
    }
}

static void test_reasons(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    begin_scene(&scene, "random", false);
    give(&scene.material[0], "diffuse-area", 0.0, 0.0);
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_int_equal(plan.n_lights, 1);
    assert_int_equal(plan.light[0], 0);
    assert_int_equal(plan.n_sources, 2);
    assert_int_equal(plan.source[0], 0);
    assert_int_equal(plan.source[1], 2);
    assert_int_equal(plan.n_materials, 1);
    assert_int_equal(plan.n_environments, 1);
    assert_true(plan.object[0].drawn && plan.object[0].highlit && !plan.object[1].drawn);
    assert_int_equal(plan.n_drops, 8);
    assert_true(dropped(&plan, "object", "away", "outside the view"));
    assert_true(dropped(&plan, "material", "paint", "every object that wears it is outside the view"));
    assert_true(dropped(&plan, "material", "spare", "no object wears it"));
    assert_true(dropped(&plan, "light", "low", "behind every surface"));
    assert_true(dropped(&plan, "light", "cellar", "behind every surface"));
    assert_true(dropped(&plan, "light", "antipodes", "behind every surface"));
    assert_true(dropped(&plan, "light", "off", "its strength is 0"));
    assert_true(dropped(&plan, "effect", "diffuse-area", "material floor: its coefficients are 0"));
    rl_plan_clear(&plan);
    settings.drop = false;
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_int_equal(plan.n_lights, 2);
    assert_int_equal(plan.n_sources, 5);
    assert_int_equal(plan.n_materials, 3);
    assert_int_equal(plan.n_environments, 2);
    rl_plan_clear(&plan);

    /* Without attenuation the map is asked for directions below the horizon, too; fur is lit from there. */
    settings.drop = true;
    settings.attenuation = false;
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_int_equal(plan.n_lights, 2);
    assert_int_equal(plan.n_sources, 2);
    rl_plan_clear(&plan);
    settings.attenuation = true;
    memset(&scene.material[0].effect, 0, sizeof scene.material[0].effect);
    give(&scene.material[0], "kajiya", 0.4, 0.2);
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_int_equal(plan.n_lights, 2);
    assert_int_equal(plan.n_sources, 4);
    rl_plan_clear(&plan);

    fixture_end(&scene);
}

/* All of what shines lies below the floor: no highlight is left, and no environment map. */
static void test_dark_floor(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    const struct rl_settings settings = RL_SETTINGS_DEFAULT;
    fixture_begin(&scene, 64, 48);
    fixture_camera(&scene, v3(0.0, 2.0, 5.0), v3(0.0, 0.0, 0.0), 30.0);
    fixture_object(&scene, RL_SHAPE_PLANE, 4, 2.0, v3(0.0, 0.0, 0.0),
                   fixture_material(&scene, 20.0, 0.05, 0.0, 0.8, "random"));
    fixture_quad(&scene, v3(1.0, -1.5, -2.0), v3(0.6, 0.0, 0.0), v3(0.0, 0.6, 0.2), 7.0, 1.5, 1.0);
    fixture_source(&scene, false, v3(1.0, 1.0, 1.0), 1.0, 1.0, 0.5);
    scene.material[0].name = "floor";
    scene.light[0].name = "low";
    scene.source[0].name = "bulb";
    memset(scene.material[0].effect, 0, sizeof scene.material[0].effect);
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_int_equal(plan.n_environments + plan.n_normal_maps, 0);
    assert_int_equal(plan.n_programs, 1);
    assert_true(dropped(&plan, "light", "low", "behind every surface"));
    assert_true(dropped(&plan, "highlight", "random", "material floor: every shaped light is behind"));
    assert_true(dropped(&plan, "light", "bulb", "no effect or highlight sees such lights"));
    rl_plan_clear(&plan);
    fixture_check_drop(gpu, &scene, settings);
    fixture_end(&scene);
}

/* Where light from below the floor is all there is, ambient light is left, which no interpolation may change by a bit; and where a light or
 * a coefficient is 0, terms below 0 times 0 are left out, which leave no sign. */
static void test_nothing_but_constants(void **state)
{
    (void)state;
    static const char *const effects[] = {"diffuse", "goldman-printed"};
    static const char *const methods[] = {NULL, "plain", "random"};
    enum { BELOW, DARK, ZERO, WAYS };
    for (int k = 0; k < RL_INTERPOLATIONS * WAYS * 2 * 3 * 2; k++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        const int way = k / RL_INTERPOLATIONS % WAYS;
        const char *effect = effects[k / (RL_INTERPOLATIONS * WAYS) % 2];
        settings.interpolation = k % RL_INTERPOLATIONS;
        settings.culling = k / (RL_INTERPOLATIONS * WAYS * 2 * 3) == 0;
        settings.env_size = 32;
        settings.normal_size = 64;
        fixture_begin(&scene, 64, 48);
        fixture_camera(&scene, v3(0.3, 2.0, 5.0), v3(0.1, 0.0, 0.0), 30.0);
        int floor =
            fixture_material(&scene, 20.0, 0.07, 0.0, 0.8, methods[k / (RL_INTERPOLATIONS * WAYS * 2) % 3]);
        scene.material[floor].name = "floor";
        if (effect != effects[0]) /* nothing else that could make a zero positive */
            memset(scene.material[floor].effect, 0, sizeof scene.material[floor].effect);
        double *value = rl_effect_give(&scene.material[floor], rl_effect_find(effect));
        for (int c = 0; c < (effect == effects[0] ? 3 : 6); c++)
            value[c] = way == ZERO ? 0.0 : 0.7;
        if (effect != effects[0])
            value[7] = 0.5; /* c */
        fixture_object(&scene, RL_SHAPE_PLANE, 4, 2.0, v3(0.0, 0.0, 0.0), floor);
        scene.object[0].name = "floor";
        double height = way == BELOW || effect != effects[0] ? -1.0 : 1.0, strength = way == DARK ? 0.0 : 3.0;
        fixture_source(&scene, false, v3(1.0, -9.0, 1.0), strength, strength, 0.0);
        fixture_source(&scene, true, v3(0.3, height, 0.2), 0.0, strength, strength);
        scene.source[0].name = scene.source[1].name = "lamp";
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        if (way != BELOW || (effect == effects[0] && settings.culling)) { /* fur is lit from below, too */
            assert_int_equal(plan.material[0].sees, 0);
            assert_int_equal(plan.material[0].interpolation, RL_INTERPOLATION_PHONG);
        }
        rl_plan_clear(&plan);
        fixture_check_drop(gpu, &scene, settings);
        fixture_end(&scene);
    }
}

/* Black by its factor, a highlight is as one without colour. */
static void test_zero_factor(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_plan plan;
    struct rl_scene scene;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    settings.env_size = 32;
    begin_scene(&scene, "random", true);
    double *value = rl_effect_give(&scene.material[1], rl_effect_find("fresnel"));
    value[0] = value[1] = value[2] = 0.0;
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_true(dropped(&plan, "highlight", "random", "material paint: its factor fresnel is 0"));
    assert_true(dropped(&plan, "effect", "fresnel", "its coefficients are 0"));
    assert_null(rl_plan_of_object(&plan, &scene, 2)->method);
    assert_non_null(rl_plan_of_object(&plan, &scene, 0)->method);
    rl_plan_clear(&plan);
    fixture_check_drop(gpu, &scene, settings);
    fixture_end(&scene);
}

/* A dark light is dropped but where it may hide another in an environment map. */
static void test_dark_light(void **state)
{
    (void)state;
    static const struct {
        const char *method;
        size_t lights;
    } rows[] = {{NULL, 1}, {"plain", 1}, {"random", 2}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        settings.env_size = 32;
        begin_scene(&scene, rows[i].method, true);
        memset(scene.light[1].radiance, 0, sizeof scene.light[1].radiance);
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        assert_int_equal(plan.n_lights, rows[i].lights);
        assert_int_equal(dropped(&plan, "light", "low", "its radiance is 0"), rows[i].lights == 1);
        rl_plan_clear(&plan);
        memset(scene.light[0].radiance, 0, sizeof scene.light[0].radiance);
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        assert_int_equal(plan.n_lights + plan.n_environments, 0);
        assert_true(!rows[i].method || dropped(&plan, "highlight", rows[i].method,
                                               "material floor: the radiance of every shaped light is 0"));
        rl_plan_clear(&plan);
        fixture_check_drop(gpu, &scene, settings);
        fixture_end(&scene);
    }
}

/* What was asked for by settings, and finds nothing to act on. */
static void test_settings(void **state)
{
    (void)state;
    static const struct {
        const char *method;
        double rr;
        enum rl_margin margin;
        const char *reason; /* NULL: it acts */
    } rows[] = {
        {NULL, 10.0, RL_MARGIN_VALUE, "no highlight that has a pass of its own"},
        {"plain", 10.0, RL_MARGIN_VALUE, "no highlight that has a pass of its own"},
        {"random", 1.0, RL_MARGIN_AUTO, "no sphere is large enough for so rough a surface"},
        {"random", 10.0, RL_MARGIN_VALUE, NULL},
        {"random", 10.0, RL_MARGIN_OFF, NULL},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        begin_scene(&scene, rows[i].method, true);
        settings.margin_kind = rows[i].margin;
        settings.rr = rows[i].rr;
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        assert_int_equal(dropped(&plan, "effect", "sphere", rows[i].reason ? rows[i].reason : ""),
                         rows[i].reason != NULL);
        rl_plan_clear(&plan);
        fixture_end(&scene);
    }
}

/* A light is what its corners enclose, not its bounding sphere. */
static void test_squares(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof drop_squares / sizeof drop_squares[0]; i++) {
        const struct drop_square *row = &drop_squares[i];
        struct rl_error error;
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        settings.env_size = 64;
        begin_square(&scene, row);
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        if (dropped(&plan, "light", "square", "behind every surface") != row->drops)
            fail_msg("row %zu: %s", i, row->drops ? "not dropped" : "dropped");
        if (!plan.on_cpu)
            fixture_check_drop(gpu, &scene, settings);
        rl_plan_clear(&plan);
        fixture_end(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_same_bits),   cmocka_unit_test(test_scenes),
        cmocka_unit_test(test_reasons),     cmocka_unit_test(test_dark_floor),
        cmocka_unit_test(test_zero_factor), cmocka_unit_test(test_dark_light),
        cmocka_unit_test(test_settings),    cmocka_unit_test(test_nothing_but_constants),
        cmocka_unit_test(test_squares),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
