/* The radiance that follows from each quantity of light, by hand. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene/scene_file.h"
#include "scene/units.h"

/* 2 m x 3 m. */
#define PANEL "polygon: [[0, 3, 0], [2, 3, 0], [2, 3, 3], [0, 3, 3]]"

/* 1 m x 2 m x 3 m, its corners three times over as files have them. */
static void put_box(void)
{
    static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    char name[PATH_MAX], text[4096];
    int length = 0;
    for (int f = 0; f < 6; f++) {
        for (int k = 0; k < 4; k++)
            length += snprintf(text + length, sizeof text - (size_t)length, "v %d %d %d\n", side[f][k] & 1,
                               side[f][k] & 2, 3 * (side[f][k] >> 2));
        length += snprintf(text + length, sizeof text - (size_t)length, "f %d %d %d\nf %d %d %d\n", 4 * f + 1,
                           4 * f + 2, 4 * f + 3, 4 * f + 1, 4 * f + 3, 4 * f + 4);
    }
    temporary_path(&folder, name, "box.obj");
    put_file(name, text, (size_t)length);
}

/* The sound scene with this one light. */
static void load_light(struct rl_scene *scene, const char *light)
{
    char text[512];
    snprintf(text, sizeof text, "  - {%s}", light);
    load_with(scene, 24, 32, text);
}

static const double *strength_of(const struct rl_scene *scene)
{
    return scene->n_lights ? scene->light[0].radiance : scene->source[0].strength;
}

static void test_table(void **state)
{
    (void)state;
    const struct {
        const char *light;
        double expected; /* of the luminance, in cd/m^2 (of a point cd, of parallel light lx) */
    } rows[] = {
        {PANEL ", luminance: 3000", 3000.0},
        {PANEL ", luminance: 3 kcd/m2", 3000.0},
        {PANEL ", luminous-intensity: 600 cd", 600.0 / 6.0},
        {PANEL ", luminous-intensity: 600 cd, scale: 2", 600.0 / 24.0},
        {PANEL ", flux: 800 lm", 800.0 / (2.0 * RL_PI * 6.0)},
        {PANEL ", flux: 800 lm, stretch: [5, 7, 1]", 800.0 / (2.0 * RL_PI * 30.0)},
        {PANEL ", flux-per-side: 800 lm", 800.0 / (RL_PI * 6.0)},
        {"mesh: box.obj, luminance: 3000 cd/m^2", 3000.0},
        {"mesh: box.obj, flux: 12 klm", 12000.0 / (RL_PI * 22.0)},
        {"mesh: box.obj, flux: 12 klm, scale: 0.5", 12000.0 / (RL_PI * 5.5)},
        {"position: [0, 9, 0], luminous-intensity: 63.5 cd", 63.5},
        {"position: [0, 9, 0], flux: 800lm", 800.0 / (4.0 * RL_PI)},
        {"direction: [0, -1, 0], illuminance: 0.1 Mlx", 100000.0},
        {"direction: [0, -1, 0], illuminance: 0", 0.0},
        {"position: [0, 9, 0], luminous-intensity: 5000 mcd", 5.0},
    };
    put_box();
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_scene scene;
        load_light(&scene, rows[i].light);
        check_near(scene.white, 80.0, 0.0);
        for (int c = 0; c < 3; c++)
            check_relative(80.0 * strength_of(&scene)[c], rows[i].expected, 1e-6); /* meshes are in floats */
        if (!strstr(rows[i].light, "mesh"))
            check_relative(80.0 * strength_of(&scene)[1], rows[i].expected, 1e-14);
        rl_scene_clear(&scene);
    }
}

/* A colour changes the colour and not the luminance, whatever its own is. */
static void test_colours(void **state)
{
    (void)state;
    static const double colours[][3] = {{1, 1, 1}, {1, 0, 0}, {0, 0, 1}, {200, 150, 80}, {1e-6, 2e-6, 0}};
    for (size_t i = 0; i < sizeof colours / sizeof colours[0]; i++) {
        struct rl_scene scene;
        char text[256];
        const double *colour = colours[i];
        snprintf(text, sizeof text, PANEL ", luminance: 400, colour: [%g, %g, %g]", colour[0], colour[1],
                 colour[2]);
        load_light(&scene, text);
        const double *rgb = scene.light[0].radiance;
        check_relative(80.0 * (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]), 400.0, 1e-14);
        for (int c = 0; c < 3; c++)
            check_near(rgb[c] * colour[(c + 1) % 3], rgb[(c + 1) % 3] * colour[c],
                       1e-12 * rgb[c] * colour[c]);
        rl_scene_clear(&scene);
    }
}

/* Everything that is seen is divided by white, ambient light too; a radiometric scene has none, and nothing is divided. */
static void test_white(void **state)
{
    (void)state;
    static const struct {
        const char *camera, *lights;
        double white, radiance, ambient; /* as the program has them, red */
    } rows[] = {
        {"white: 3 kcd/m2, ", "lights: [{" PANEL ", luminance: 6000}]", 3000.0, 2.0, 0.01},
        {"", "lights: [{" PANEL ", luminance: 6000}]", 80.0, 75.0, 0.375},
        {"white: 60, ", "", 60.0, 0.0, 0.5},
        {"", "lights: [{" PANEL ", radiance: [2, 4, 6]}]", 0.0, 2.0, 30.0},
        {"", "", 0.0, 0.0, 30.0},
    };
    const struct rl_effect *ambient = rl_effect_find("ambient"), *diffuse = rl_effect_find("diffuse");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_scene scene;
        char text[512];
        snprintf(text, sizeof text,
                 "camera: {%sposition: [0, 1, 5], target: [0, 0, 0], field-of-view: 40}\n"
                 "materials: [{name: matt, ambient: [30, 60, 90], diffuse: [0.1, 0.2, 0.3]}]\n"
                 "objects: [{shape: sphere, material: matt}]\n%s",
                 rows[i].camera, rows[i].lights);
        load_with(&scene, 2, 32, text);
        check_near(scene.white, rows[i].white, 0.0);
        if (scene.n_lights)
            check_relative(scene.light[0].radiance[0], rows[i].radiance, 1e-15);
        for (int c = 0; c < 3; c++) {
            check_relative(rl_effect_given(&scene.material[0], ambient)[c], (c + 1) * rows[i].ambient, 1e-15);
            check_near(rl_effect_given(&scene.material[0], diffuse)[c], 0.1 * (c + 1), 1e-16);
        }
        rl_scene_clear(&scene);
    }
}

static void test_units(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double value;
        enum rl_unit unit;
    } rows[] = {
        {"5", 5.0, RL_UNIT_NONE},
        {"-5e-1", -0.5, RL_UNIT_NONE},
        {"+.5 lm", 0.5, RL_UNIT_LUMEN},
        {"5lx", 5.0, RL_UNIT_LUX},
        {"5 \t lx", 5.0, RL_UNIT_LUX},
        {"5 mlx", 5e-3, RL_UNIT_LUX},
        {"5 klx", 5e3, RL_UNIT_LUX},
        {"5 Mcd", 5e6, RL_UNIT_CANDELA},
        {"5 mcd/m\xc2\xb2", 5e-3, RL_UNIT_LUMINANCE},
        {"5 kcd/m^2", 5e3, RL_UNIT_LUMINANCE},
        {"5 klmx", 5.0, RL_UNIT_UNKNOWN},
        {"0x5", 0.0, RL_UNIT_UNKNOWN},
        {"5 LM", 5.0, RL_UNIT_UNKNOWN},
        {"5 lm ", 5.0, RL_UNIT_UNKNOWN},
        {"5 c", 5.0, RL_UNIT_UNKNOWN},
        {"5 m", 5.0, RL_UNIT_UNKNOWN},
        {"5 mm lm", 5.0, RL_UNIT_UNKNOWN},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        double value = NAN;
        enum rl_unit unit;
        assert_true(rl_measure_scan(&value, &unit, rows[i].text));
        check_relative(value, rows[i].value, 1e-15);
        assert_int_equal(unit, rows[i].unit);
    }
    static const char *const none[] = {"",      "lm",  " 5",  "5e", "nan",  "inf",
                                       "1e999", "--5", "5-5", "e5", "5.5.5"};
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++) {
        double value;
        enum rl_unit unit;
        assert_false(rl_measure_scan(&value, &unit, none[i]));
    }
    for (int u = 0; u < RL_UNIT_NONE; u++) {
        char text[32];
        double value;
        enum rl_unit unit;
        snprintf(text, sizeof text, "7 %s", rl_unit_name((enum rl_unit)u));
        assert_true(rl_measure_scan(&value, &unit, text));
        assert_int_equal(unit, u);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_colours),
        cmocka_unit_test(test_white),
        cmocka_unit_test(test_units),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
