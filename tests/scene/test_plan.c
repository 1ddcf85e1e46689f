/* Plans: what is in them follows from what the scene asks for, and nothing else is. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene/margin.h"
#include "scene/planned.h"

static void test_random(void **state)
{
    (void)state;
    load(0, -1, NULL);
    make(&scene.settings);
    assert_int_equal(plan.settings.width, 64);
    assert_int_equal(plan.settings.height, 48);
    assert_false(plan.on_cpu);
    assert_int_equal(plan.n_materials, 2);
    const struct rl_plan_material *shiny = rl_plan_of_object(&plan, &scene, 0);
    const struct rl_plan_material *matt = rl_plan_of_object(&plan, &scene, 1);
    assert_string_equal(shiny->method->name, "random");
    assert_int_equal(shiny->samples, 16);
    check_near(shiny->rr, 30.0, 0.0);
    assert_int_equal(shiny->n_effects, 1);
    assert_string_equal(shiny->effect[0]->name, "diffuse");
    assert_int_equal(shiny->n_point_lights, 2);
    assert_int_equal(shiny->sphere_program, -1); /* margin: off */
    assert_int_equal(shiny->pattern, -1);
    assert_int_equal(shiny->normal_map, 0);
    assert_true(has_module(shiny->surface_program, "effects/diffuse"));
    assert_false(has_module(shiny->surface_program, "effects/ambient"));
    assert_true(has_module(shiny->highlight_program, "methods/random"));
    assert_true(has_module(shiny->highlight_program, "common/normal_map"));
    assert_true(has_module(shiny->highlight_program, "common/attenuation"));
    assert_false(has_module(shiny->highlight_program, "common/pattern"));

    assert_null(matt->method);
    assert_int_equal(matt->highlight_program, -1);
    assert_int_equal(matt->normal_map, -1);
    assert_int_equal(matt->n_point_lights, 0);
    assert_true(has_module(matt->surface_program, "effects/ambient"));
    assert_false(has_module(matt->surface_program, "effects/diffuse"));

    assert_int_equal(plan.n_environments, 1);
    assert_int_equal(plan.environment[0], 0);
    assert_int_equal(plan.environment[1], -1);
    assert_string_equal(plan.program[plan.environment_program].pass, "environment");
    assert_int_equal(plan.n_programs, 4); /* environment, two surfaces, one highlight */
    check_near((double)plan.radiance_scale, 3.0, 0.0);
    clear();
}

static void test_regular(void **state)
{
    (void)state;
    load(34, 35, "  attenuation: off\n  frame: printed");
    scene.settings.method = "regular";
    make(&scene.settings);
    const struct rl_plan_material *shiny = rl_plan_of_object(&plan, &scene, 0);
    assert_int_equal(shiny->samples, 13);
    assert_int_equal(shiny->normal_map, -1);
    assert_int_equal(shiny->pattern, 0);
    assert_int_equal(plan.pattern[0].samples, 13);
    assert_true(has_module(shiny->highlight_program, "methods/regular"));
    assert_true(has_module(shiny->highlight_program, "common/pattern"));
    assert_true(has_module(shiny->highlight_program, "common/attenuation_off"));
    assert_true(has_module(shiny->highlight_program, "common/frame_printed"));
    assert_false(any_module("common/normal_map"));
    assert_false(any_module("common/frame"));
    assert_false(any_module("common/attenuation"));
    /* The override gives no highlight to what had none. */
    assert_null(rl_plan_of_object(&plan, &scene, 1)->method);
    clear();
}

/* `plain` takes no samples: it is part of the surface program, and there is neither environment nor
 * texture. */
static void test_plain(void **state)
{
    (void)state;
    load(11, 11, "    highlight: plain");
    scene.settings.margin_kind = RL_MARGIN_AUTO;
    make(&scene.settings);
    const struct rl_plan_material *shiny = rl_plan_of_object(&plan, &scene, 0);
    assert_int_equal(shiny->samples, 1);
    assert_int_equal(shiny->highlight_program, -1);
    assert_int_equal(shiny->sphere_program, -1);
    assert_true(has_module(shiny->surface_program, "methods/plain"));
    assert_int_equal(plan.n_environments, 0);
    assert_int_equal(plan.environment_program, -1);
    assert_int_equal(plan.n_normal_maps + plan.n_patterns, 0);
    assert_false(any_module("common/environment"));
    clear();
}

static void test_reference(void **state)
{
    (void)state;
    load(11, 11, "    highlight: reference");
    make(&scene.settings);
    assert_true(plan.on_cpu);
    assert_int_equal(plan.n_programs, 0);
    assert_int_equal(plan.n_environments, 0);
    assert_string_equal(rl_plan_of_object(&plan, &scene, 0)->method->name, "reference");
    assert_int_equal(rl_plan_of_object(&plan, &scene, 1)->n_effects, 1); /* base shading is still wanted */
    rl_plan_clear(&plan);
    scene.settings.method = "random";
    make(&scene.settings);
    assert_false(plan.on_cpu);
    clear();
}

/* `exhaustive` runs on the CPU but wants a map of every object that wears it; no program draws it. */
static void test_exhaustive(void **state)
{
    (void)state;
    struct rl_error error;
    load(11, 11, "    highlight: exhaustive");
    make(&scene.settings);
    assert_true(plan.on_cpu);
    assert_int_equal(plan.n_programs, 0);
    assert_int_equal(plan.n_environments, 1);
    assert_int_equal(plan.environment[0], 0);
    assert_int_equal(plan.environment[1], -1);
    assert_int_equal(plan.environment_program, -1);
    assert_string_equal(rl_plan_of_object(&plan, &scene, 0)->method->name, "exhaustive");
    rl_plan_clear(&plan);
    scene.settings.frame = RL_FRAME_PRINTED;
    check_fails(rl_plan_make(&plan, &scene, &scene.settings, &error), &error, RL_ERR_INPUT,
                "the method exhaustive with the frame printed, expected the frame orthonormal");
    scene.settings.method = "reference";
    make(&scene.settings);
    clear();
}

/* No light, no highlight and no diffuse reflection; no specular colour, no highlight. */
static void test_left_out(void **state)
{
    (void)state;
    load(23, 32, "");
    make(&scene.settings);
    assert_null(rl_plan_of_object(&plan, &scene, 0)->method);
    assert_int_equal(rl_plan_of_object(&plan, &scene, 0)->n_effects, 0);
    assert_int_equal(plan.n_environments, 0);
    assert_int_equal(plan.n_programs, 2); /* black, and ambient */
    check_near((double)plan.radiance_scale, 1.0, 0.0);
    clear();

    load(10, 10, "    specular: [0, 0, 0]");
    make(&scene.settings);
    assert_null(rl_plan_of_object(&plan, &scene, 0)->method);
    assert_int_equal(plan.n_environments, 0);
    clear();

    load(21, 21, "    material: shiny"); /* nobody wears matt */
    make(&scene.settings);
    assert_int_equal(plan.n_materials, 1);
    assert_int_equal(plan.n_environments, 2);
    assert_int_equal(plan.n_programs, 3);
    assert_false(any_module("effects/ambient"));
    clear();
}

/* Two materials that differ in R_r alone share programs, not normal maps; those alike in R_r share these,
 * too. */
/* Back faces that are drawn have a module that turns their normals, and every light counts; a stencil is there for highlights alone. */
static void test_visibility(void **state)
{
    (void)state;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    load(0, -1, NULL);
    make(&settings);
    assert_true(plan.stencil);
    assert_true(any_module("common/visible"));
    assert_false(any_module("common/visible_both"));
    rl_plan_clear(&plan);
    settings.culling = false;
    settings.method = "plain";
    make(&settings);
    assert_false(plan.stencil);
    assert_true(any_module("common/visible_both"));
    assert_false(any_module("common/visible"));
    rl_plan_clear(&plan);
    settings.depth_bits = 16;
    make(&settings);
    rl_plan_clear(&plan);
    settings.method = "regular";
    check_fails(rl_plan_make(&plan, &scene, &settings, &error), &error, RL_ERR_INPUT, path);
    assert_non_null(strstr(error.message, "16 bits"));
    assert_non_null(strstr(error.message, "method regular"));
    rl_scene_clear(&scene);
}

static void test_sharing(void **state)
{
    (void)state;
    for (int alike = 0; alike < 2; alike++) {
        load(13, 13, alike ? "    rr: 30\n    diffuse: [1, 1, 1]" : "    rr: 31\n    diffuse: [1, 1, 1]");
        make(&scene.settings);
        const struct rl_plan_material *a = rl_plan_of_object(&plan, &scene, 0),
                                      *b = rl_plan_of_object(&plan, &scene, 1);
        assert_int_equal(plan.n_programs, 3);
        assert_int_equal(a->surface_program, b->surface_program);
        assert_int_equal(a->highlight_program, b->highlight_program);
        assert_int_equal(a->normal_map == b->normal_map, alike);
        assert_int_equal(plan.n_normal_maps, alike ? 1 : 2);
        assert_int_equal(plan.n_environments, 2); /* one an object: each is taken from its own place */
        clear();
    }
    load(13, 13, "    rr: 31");
    scene.settings.rr = 7.0;
    scene.settings.method = "regular";
    make(&scene.settings);
    assert_int_equal(plan.n_patterns, 1);
    check_near(plan.pattern[0].rr, 7.0, 0.0);
    clear();
}

static void test_margin(void **state)
{
    (void)state;
    load(35, 35, "  margin: 0.25");
    make(&scene.settings);
    const struct rl_plan_material *shiny = rl_plan_of_object(&plan, &scene, 0);
    assert_string_equal(plan.program[shiny->sphere_program].pass, "sphere");
    check_near(shiny->margin, 0.25, 0.0);
    assert_int_equal(rl_plan_of_object(&plan, &scene, 1)->sphere_program, -1);
    clear();
}

/* The bound reaches the closed form: the less may be lost, the larger the sphere. */
static void test_margin_bound(void **state)
{
    (void)state;
    static const struct {
        const char *line;
        double bound;
    } row[] = {{"  margin: auto:0.5", 0.5}, {"  margin: auto:0.3", 0.3}, {"  margin: auto:0.2", 0.2}};
    double margin[3];
    for (size_t i = 0; i < 3; i++) {
        load(35, 35, row[i].line);
        scene.settings.rr = 100.0;
        make(&scene.settings);
        const struct rl_plan_material *shiny = rl_plan_of_object(&plan, &scene, 0);
        margin[i] = shiny->margin;
        assert_true(shiny->sphere_program >= 0);
        check_near(margin[i], rl_margin_auto(&scene, shiny, &plan.settings, row[i].bound), 1e-9);
        clear();
    }
    assert_true(margin[0] < margin[1] && margin[1] < margin[2]);
}

static void test_refused(void **state)
{
    (void)state;
    load(0, -1, NULL);
    struct rl_settings s = scene.settings;
    s.method = "magic";
    check_fails(rl_plan_make(&plan, &scene, &s, &error), &error, RL_ERR_INPUT,
                "--method: found 'magic', expected plain,");
    s = scene.settings;
    s.samples = 100000;
    check_fails(rl_plan_make(&plan, &scene, &s, &error), &error, RL_ERR_INPUT, "--samples: found 100000");
    assert_null(plan.material);
    rl_scene_clear(&scene);
    load(13, 13, "    rr: 5\n    highlight: reference");
    check_fails(rl_plan_make(&plan, &scene, &scene.settings, &error), &error, RL_ERR_INPUT,
                "reference runs on the CPU alone");
    rl_scene_clear(&scene);
}

/* Two plans of one scene agree in every program and module. */
static void test_deterministic(void **state)
{
    (void)state;
    static const char *const scenes[] = {
        "studies/scenes/teapot-star.yaml", "studies/scenes/three-lights.yaml",
        "studies/scenes/two-roughness.yaml", "studies/scenes/sphere-quad.yaml"};
    static const size_t normal_maps[] = {1, 1, 2, 1},
                        environments[] = {1, 1, 2, 1}; /* ring and ball have one centre */
    for (size_t k = 0; k < 4; k++) {
        check_ok(rl_scene_load(&scene, scenes[k], &error), &error);
        struct rl_plan other;
        make(&scene.settings);
        check_ok(rl_plan_make(&other, &scene, &scene.settings, &error), &error);
        assert_int_equal(plan.n_normal_maps, normal_maps[k]);
        assert_int_equal(plan.n_environments, environments[k]);
        assert_int_equal(plan.n_programs, other.n_programs);
        for (size_t i = 0; i < plan.n_programs; i++) {
            assert_int_equal(plan.program[i].n_modules, other.program[i].n_modules);
            for (size_t j = 0; j < plan.program[i].n_modules; j++)
                assert_string_equal(plan.program[i].module[j], other.program[i].module[j]);
        }
        rl_plan_clear(&other);
        clear();
    }
}

/* Every module that a plan names is a file. */
static void test_modules_exist(void **state)
{
    (void)state;
    static const char *const methods[] = {"plain", "regular", "random"};
    for (size_t k = 0; k < 6; k++) {
        load(34, 35, k < 3 ? "  margin: 1" : "  margin: 1\n  attenuation: off\n  frame: printed");
        scene.settings.method = methods[k % 3];
        make(&scene.settings);
        for (size_t i = 0; i < plan.n_programs; i++)
            for (size_t j = 0; j < plan.program[i].n_modules; j++) {
                char file[PATH_MAX];
                snprintf(file, sizeof file, "shaders/%s.glsl", plan.program[i].module[j]);
                if (access(file, R_OK) != 0)
                    print_error("%s is missing\n", file);
                assert_int_equal(access(file, R_OK), 0);
            }
        clear();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),        cmocka_unit_test(test_regular),
        cmocka_unit_test(test_plain),         cmocka_unit_test(test_reference),
        cmocka_unit_test(test_exhaustive),    cmocka_unit_test(test_left_out),
        cmocka_unit_test(test_sharing),       cmocka_unit_test(test_margin),
        cmocka_unit_test(test_margin_bound),  cmocka_unit_test(test_refused),
        cmocka_unit_test(test_deterministic), cmocka_unit_test(test_modules_exist),
        cmocka_unit_test(test_visibility),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
