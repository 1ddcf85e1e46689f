/* Plans: what effects bring, and the lights that they see. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene/planned.h"

/* Only modules of lights that are there. */
static void test_sources(void **state)
{
    (void)state;
    load(24, 32, "  - {direction: [0, -1, 0], irradiance: [1, 1, 1]}");
    make(&scene.settings);
    const struct rl_plan_material *shiny = rl_plan_of_object(&plan, &scene, 0);
    assert_int_equal(shiny->sees, RL_SEES_SOURCES);
    assert_int_equal(plan.sees, RL_SEES_SOURCES);
    assert_null(shiny->method); /* the highlight is of shaped lights */
    assert_int_equal(shiny->n_point_lights, 0);
    assert_true(has_module(shiny->surface_program, "common/sources"));
    assert_true(has_module(shiny->surface_program, "common/parallel_sources"));
    assert_false(any_module("common/point_sources"));
    assert_false(any_module("common/centroids"));
    assert_false(any_module("common/lights"));
    assert_int_equal(rl_plan_of_object(&plan, &scene, 1)->sees, 0);
    clear();

    load(0, -1, NULL);
    make(&scene.settings);
    assert_int_equal(plan.sees, RL_SEES_CENTROIDS);
    assert_true(any_module("common/centroids"));
    assert_false(any_module("common/sources"));
    clear();
}

/* Point lights come before parallel ones, and each kind brings its own module: no shader asks which a light is. */
static void test_kinds(void **state)
{
    (void)state;
    load(24, 32,
         "  - {direction: [0, -1, 0], irradiance: [1, 1, 1]}\n"
         "  - {position: [0, 3, 0], intensity: [1, 1, 1]}\n"
         "  - {direction: [1, -1, 0], irradiance: [1, 1, 1]}\n"
         "  - {position: [1, 3, 0], intensity: [1, 1, 1]}");
    make(&scene.settings);
    static const size_t order[] = {1, 3, 0, 2};
    const struct rl_plan_material *shiny = rl_plan_of_object(&plan, &scene, 0);
    assert_int_equal(plan.n_sources, 4);
    assert_int_equal(plan.n_points, 2);
    assert_memory_equal(plan.source, order, sizeof order);
    assert_true(shiny->n_points == 2 && shiny->n_parallels == 2);
    assert_true(has_module(shiny->surface_program, "common/point_sources"));
    assert_true(has_module(shiny->surface_program, "common/parallel_sources"));
    const struct rl_plan_material *matt = rl_plan_of_object(&plan, &scene, 1);
    assert_true(matt->n_points == 0 && matt->n_parallels == 0);
    clear();
    load(24, 32, "  - {position: [0, 3, 0], intensity: [1, 1, 1]}");
    make(&scene.settings);
    assert_true(any_module("common/point_sources"));
    assert_false(any_module("common/parallel_sources"));
    clear();
}

/* An effect brings its own module, those it needs and those of its choices; with coefficient 0 or without its lights, nothing. */
static void test_effects(void **state)
{
    (void)state;
    load(13, 13, "    cook-torrance: {reflectance: [0.5, 0, 0], roughness: 0.2, distribution: ellipsoid}");
    make(&scene.settings);
    assert_int_equal(rl_plan_of_object(&plan, &scene, 1)->n_effects, 0); /* there are shaped lights alone */
    assert_false(any_module("effects/cook_torrance"));
    clear();
    load(25, 26, "    position: [0, 3, 0]\n    intensity: [1, 1, 1]");
    struct rl_material *matt = &scene.material[1];
    double *value = rl_effect_give(matt, rl_effect_find("cook-torrance"));
    value[0] = 0.5;
    value[1] = value[2] = 0.0;
    value[9] = 0.2;
    value[10] = 1.0;
    make(&scene.settings);
    int program = rl_plan_of_object(&plan, &scene, 1)->surface_program;
    assert_true(has_module(program, "effects/cook_torrance"));
    assert_true(has_module(program, "common/fresnel"));
    assert_true(has_module(program, "common/ellipsoid_facets"));
    assert_false(any_module("common/beckmann"));
    assert_false(any_module("common/polygons"));
    rl_plan_clear(&plan);
    value[0] = 0.0;
    make(&scene.settings);
    assert_false(any_module("effects/cook_torrance"));
    assert_false(any_module("common/fresnel"));
    rl_plan_clear(&plan);
    rl_effect_give_colour(matt, "diffuse-area", 1.0, 1.0, 1.0);
    make(&scene.settings);
    assert_true(any_module("common/polygons"));
    assert_true(any_module("common/arctangent"));
    clear();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sources),
        cmocka_unit_test(test_kinds),
        cmocka_unit_test(test_effects),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
