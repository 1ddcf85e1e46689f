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

static size_t count_modules(int program, const char *module)
{
    size_t n = 0;
    for (size_t i = 0; i < plan.program[program].n_modules; i++)
        n += strcmp(plan.program[program].module[i], module) == 0;
    return n;
}

/* Which modules carry the interpolation out; a material that says nothing links none of the others'. */
static void test_interpolation(void **state)
{
    (void)state;
    static const struct {
        enum rl_interpolation interpolation;
        const char *vertex, *between;
    } rows[] = {
        {RL_INTERPOLATION_PHONG, "passes/object_vertex", "common/visible"},
        {RL_INTERPOLATION_GOURAUD, "passes/gouraud_vertex", "common/radiance_smooth"},
        {RL_INTERPOLATION_CONSTANT, "passes/constant_vertex", "common/radiance_flat"},
    };
    for (size_t i = 0; i < 3; i++)
        for (int overridden = 0; overridden < 2; overridden++) {
            load(0, -1, NULL);
            struct rl_settings settings = scene.settings;
            rl_effect_give_colour(&scene.material[0], "ambient", 0.1, 0.1, 0.1);
            if (overridden)
                settings.interpolation = (int)rows[i].interpolation;
            else
                scene.material[0].interpolation = rows[i].interpolation;
            make(&settings);
            const struct rl_plan_material *shiny = rl_plan_of_object(&plan, &scene, 0);
            const struct rl_plan_program *program = &plan.program[shiny->surface_program];
            assert_int_equal(shiny->interpolation, rows[i].interpolation);
            assert_string_equal(program->module[program->n_vertex - 1], rows[i].vertex);
            for (size_t k = 0; k < 3; k++)
                assert_int_equal(has_module(shiny->surface_program, rows[k].between), k == i);
            /* The effect is in one of the stages. */
            size_t at = 0;
            while (strcmp(program->module[at], "effects/diffuse") != 0)
                at++;
            assert_int_equal(at < program->n_vertex, rows[i].interpolation != RL_INTERPOLATION_PHONG);
            assert_int_equal(count_modules(shiny->surface_program, "effects/diffuse"), 1);
            /* What is the same everywhere is each pixel's. */
            for (size_t k = 0; k < program->n_vertex; k++)
                assert_string_not_equal(program->module[k], "effects/ambient");
            assert_int_equal(count_modules(shiny->surface_program, "effects/ambient"), 1);
            /* The highlight's own pass is each pixel's. */
            const struct rl_plan_program *highlight = &plan.program[shiny->highlight_program];
            assert_int_equal(highlight->n_vertex, 1);
            assert_string_equal(highlight->module[0], "passes/object_vertex");
            /* `matt` has no effect but ambient light, which is the same everywhere: nothing is interpolated, whatever is asked of all. */
            assert_int_equal(rl_plan_of_object(&plan, &scene, 1)->interpolation, RL_INTERPOLATION_PHONG);
            clear();
        }
}

/* A highlight that is drawn with the surface stays each pixel's, with its lights and its factor, though vertices see the same lights. */
static void test_interpolation_and_plain(void **state)
{
    (void)state;
    load(10, 11,
         "    diffuse: [0.1, 0.2, 0.3]\n    fresnel: {reflectance: [0.1, 0.1, 0.1]}\n    highlight: plain\n"
         "    interpolation: gouraud");
    make(&scene.settings);
    int index = rl_plan_of_object(&plan, &scene, 0)->surface_program;
    const struct rl_plan_program *program = &plan.program[index];
    assert_int_equal(count_modules(index, "common/lights"), 2);
    assert_int_equal(count_modules(index, "effects/fresnel"), 1);
    assert_string_equal(program->module[program->n_modules - 1], "passes/interpolated_highlight");
    assert_string_equal(program->module[program->n_modules - 2], "methods/plain");
    clear();
    /* With no effect but the factor there is nothing to interpolate. */
    load(10, 11,
         "    fresnel: {reflectance: [0.1, 0.1, 0.1]}\n    highlight: plain\n    interpolation: gouraud");
    make(&scene.settings);
    const struct rl_plan_material *shiny = rl_plan_of_object(&plan, &scene, 0);
    assert_int_equal(shiny->n_effects, 1);
    assert_int_equal(shiny->interpolation, RL_INTERPOLATION_PHONG);
    assert_true(has_module(shiny->surface_program, "passes/object_vertex"));
    clear();
}

/* One triangle below the horizon of the light by the normals at its corners, not by the normal of its plane: only where the plane's counts
 * is the light kept. */
static void test_facets_keep_lights(void **state)
{
    (void)state;
    load(23, 32, "lights:\n  - {name: sun, direction: [0, -1, 0], irradiance: [1, 1, 1]}");
    for (size_t o = 0; o < scene.n_objects; o++) {
        const struct rl_mesh *mesh = &scene.object[o].mesh;
        scene.object[o].material = 0;
        for (size_t i = 0; i < mesh->n_vertices; i++)
            memcpy(mesh->normal[i], (float[3]){0.0f, -1.0f, 0.0f}, sizeof mesh->normal[i]);
    }
    struct rl_settings settings = scene.settings;
    make(&settings);
    assert_int_equal(plan.n_sources, 0);
    rl_plan_clear(&plan);
    settings.interpolation = RL_INTERPOLATION_GOURAUD;
    make(&settings);
    assert_int_equal(plan.n_sources, 0);
    rl_plan_clear(&plan);
    settings.interpolation = RL_INTERPOLATION_CONSTANT;
    make(&settings);
    assert_int_equal(plan.n_sources, 1);
    clear();
}

/* A switch of an effect takes the words that those of `render` take. */
static void test_switch(void **state)
{
    (void)state;
    static const struct {
        const char *word;
        double value;
    } rows[] = {{"on", 1.0}, {"off", 0.0}, {"true", 1.0}, {"false", 0.0}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char text[128];
        const struct rl_effect *fur = rl_effect_find("lengyel");
        snprintf(text, sizeof text, "    lengyel: {diffuse: [0, 0, 0], specular: [0, 0, 0], monochrome: %s}",
                 rows[i].word);
        load(13, 13, text);
        const double *value = rl_effect_given(&scene.material[1], fur);
        assert_non_null(value);
        assert_true(value[rl_effect_values(fur) - 1] == rows[i].value);
        rl_scene_clear(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_switch),
        cmocka_unit_test(test_sources),
        cmocka_unit_test(test_kinds),
        cmocka_unit_test(test_effects),
        cmocka_unit_test(test_interpolation),
        cmocka_unit_test(test_interpolation_and_plain),
        cmocka_unit_test(test_facets_keep_lights),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
