/* Every way in which the strength of lights can be wrong: with the kind of light, in its unit, with the other lights. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene/wrong.h"

/* Unit square, and a tetrahedron that is closed or open. */
#define QUAD "    polygon: [[0, 3, 0], [1, 3, 0], [1, 3, 1], [0, 3, 1]]\n"
#define POINT "    position: [0, 3, 0]\n"
#define SUN "    direction: [0, -1, 0]\n"

static const struct {
    const char *kind, *text;
} kinds[] = {{"polygon", QUAD},
             {"mesh", "    mesh: body.obj\n"},
             {"position", "    position: [0, 3, 0]\n"},
             {"direction", "    direction: [0, -1, 0]\n"}};
enum { N_KINDS = sizeof kinds / sizeof kinds[0] };

/* With the kinds of light that may have it (a bit each), its unit and a sound value. */
static const struct {
    const char *key;
    unsigned kinds;
    const char *unit, *value;
} strengths[] = {
    {"radiance", 3, NULL, "[1, 2, 3]"},         {"intensity", 4, NULL, "[1, 2, 3]"},
    {"irradiance", 8, NULL, "[1, 2, 3]"},       {"luminance", 3, "cd/m2", "100"},
    {"luminous-intensity", 1 | 4, "cd", "100"}, {"flux", 7, "lm", "100"},
    {"flux-per-side", 1, "lm", "100"},          {"illuminance", 8, "lx", "100"},
};
enum { N_STRENGTHS = sizeof strengths / sizeof strengths[0] };

static void write_meshes(void)
{
    static const char corners[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
    static const char sheet[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    char name[PATH_MAX], text[256];
    temporary_path(&folder, name, "open.obj");
    put_file(name, corners, strlen(corners));
    temporary_path(&folder, name, "sheet.obj");
    put_file(name, sheet, strlen(sheet));
    snprintf(text, sizeof text, "%sf 2 3 4\n", corners);
    temporary_path(&folder, name, "body.obj");
    put_file(name, text, strlen(text));
}

/* What comes of lights[0] from line 24, and no other light. */
static int load(const char *text)
{
    char path[PATH_MAX];
    temporary_path(&folder, path, "scene.yaml");
    write_scene(path, 24, 32, text);
    struct rl_scene scene;
    error.message[0] = '\0';
    int status = rl_scene_load(&scene, path, &error);
    if (status == RL_OK)
        rl_scene_clear(&scene);
    return status;
}

/* Each kind of light with each strength: sound, or refused with the light's key and what it would take. */
static void test_kinds(void **state)
{
    (void)state;
    char text[512], expected[256];
    int sound = 0;
    write_meshes();
    for (unsigned k = 0; k < N_KINDS; k++)
        for (unsigned s = 0; s < N_STRENGTHS; s++) {
            snprintf(text, sizeof text, "  - name: lamp\n%s    %s: %s", kinds[k].text, strengths[s].key,
                     strengths[s].value);
            int status = load(text);
            if (strengths[s].kinds & 1U << k) {
                check_ok(status, &error);
                sound++;
                continue;
            }
            snprintf(expected, sizeof expected, "scene.yaml:26: lights[0].%s: found it with %s, expected ",
                     strengths[s].key, kinds[k].kind);
            check_fails(status, &error, RL_ERR_INPUT, expected);
            for (unsigned other = 0; other < N_STRENGTHS; other++)
                if (strengths[other].kinds & 1U << k)
                    assert_non_null(strstr(strstr(error.message, "expected"), strengths[other].key));
        }
    assert_int_equal(sound, 2 + 1 + 1 + 2 + 2 + 3 + 1 + 1);
}

/* Two strengths of one light, whatever they are. */
static void test_two_of_one_light(void **state)
{
    (void)state;
    char text[512], expected[256];
    for (unsigned k = 0; k < N_KINDS; k++)
        for (unsigned a = 0; a < N_STRENGTHS; a++)
            for (unsigned b = a + 1; b < N_STRENGTHS; b++) {
                if (!(strengths[a].kinds & strengths[b].kinds & 1U << k))
                    continue;
                snprintf(text, sizeof text, "  - name: lamp\n%s    %s: %s\n    %s: %s", kinds[k].text,
                         strengths[b].key, strengths[b].value, strengths[a].key, strengths[a].value);
                snprintf(expected, sizeof expected, "lights[0].%s: found %s and %s, expected one of them",
                         strengths[b].key, strengths[a].key, strengths[b].key);
                check_fails(load(text), &error, RL_ERR_INPUT, expected);
            }
}

/* Each photometric strength with each unit; a wrong one says whose it is. */
static void test_units(void **state)
{
    (void)state;
    static const struct {
        const char *unit, *of;
    } units[] = {{"cd/m2", "luminance"}, {"cd", "luminous-intensity"}, {"lm", "flux"}, {"lx", "illuminance"}};
    static const char *const unknown[] = {"W", "cd/m", "lumen", "K", "kk lm", "lm lm", "cd/m3", "k", "%"};
    char text[512], expected[256];
    for (unsigned s = 0; s < N_STRENGTHS; s++) {
        if (!strengths[s].unit)
            continue;
        unsigned k = 0;
        while (!(strengths[s].kinds & 1U << k))
            k++;
        for (size_t u = 0; u < sizeof units / sizeof units[0]; u++) {
            snprintf(text, sizeof text, "  - name: lamp\n%s    %s: 12 k%s", kinds[k].text, strengths[s].key,
                     units[u].unit);
            int status = load(text);
            if (strcmp(units[u].unit, strengths[s].unit) == 0) {
                check_ok(status, &error);
                continue;
            }
            snprintf(expected, sizeof expected, "scene.yaml:26: lights[0].%s: found '12 k%s', expected ",
                     strengths[s].key, units[u].unit);
            check_fails(status, &error, RL_ERR_INPUT, expected);
            snprintf(expected, sizeof expected, " in %s, such as ", strengths[s].unit);
            assert_non_null(strstr(error.message, expected));
            snprintf(expected, sizeof expected, "; %s is the unit of %s", units[u].unit, units[u].of);
            assert_non_null(strstr(error.message, expected));
        }
        for (size_t u = 0; u < sizeof unknown / sizeof unknown[0]; u++) {
            snprintf(text, sizeof text, "  - name: lamp\n%s    %s: 12 %s", kinds[k].text, strengths[s].key,
                     unknown[u]);
            snprintf(expected, sizeof expected, "lights[0].%s: found '12 %s', expected ", strengths[s].key,
                     unknown[u]);
            check_fails(load(text), &error, RL_ERR_INPUT, expected);
            assert_null(strstr(error.message, "is the unit of"));
        }
    }
}

static void test_values(void **state)
{
    (void)state;
    static const struct wrong table[] = {
        {24, 32, "  - name: a\n" POINT "    flux: -1 lm", 26,
         "lights[0].flux: found '-1 lm', expected a luminous flux from 0 to 1e+12 in lm, such as 800 lm"},
        {24, 32, "  - name: a\n" POINT "    flux: 1e13", 26,
         "lights[0].flux: found '1e13', expected a luminous"},
        {24, 32, "  - name: a\n" POINT "    flux: 2e6 Mlm", 26, "lights[0].flux: found '2e6 Mlm', expected"},
        {24, 32, "  - name: a\n" POINT "    flux: nan", 26,
         "lights[0].flux: found 'nan', expected a luminous"},
        {24, 32, "  - name: a\n" POINT "    flux: inf lm", 26, "lights[0].flux: found 'inf lm', expected a "},
        {24, 32, "  - name: a\n" POINT "    flux: 1e400", 26, "lights[0].flux: found '1e400', expected a "},
        {24, 32, "  - name: a\n" POINT "    flux: 0x10 lm", 26,
         "lights[0].flux: found '0x10 lm', expected a "},
        {24, 32, "  - name: a\n" POINT "    flux: 1 2 lm", 26, "lights[0].flux: found '1 2 lm', expected a "},
        {24, 32, "  - name: a\n" POINT "    flux: lm", 26, "lights[0].flux: found 'lm', expected a luminous"},
        {24, 32, "  - name: a\n" POINT "    flux: 8e lm", 26,
         "lights[0].flux: found '8e lm', expected a lum"},
        {24, 32, "  - name: a\n" POINT "    flux:", 26, "lights[0].flux: found nothing, expected a luminous"},
        {24, 32, "  - name: a\n" POINT "    flux: [1, 1, 1]", 26,
         "lights[0].flux: found a list of 3, expected a luminous flux"},
        {24, 32, "  - name: a\n" POINT "    flux: {lm: 5}", 26,
         "lights[0].flux: found a mapping, expected a "},
        {24, 32, "  - name: a\n" POINT "    intensity: 100 cd", 26,
         "lights[0].intensity: found '100 cd', expected a list of 3"},
        {24, 32, "  - name: a\n" SUN, 24, "lights[0]: found no strength, expected irradiance or illuminance"},
        /* Colours. */
        {24, 32, "  - name: a\n" POINT "    flux: 1\n    colour: [0, 0, 0]", 27,
         "lights[0].colour: found black, expected a colour with a component above 0"},
        {24, 32, "  - name: a\n" POINT "    flux: 1\n    colour: [1, -1, 1]", 27,
         "lights[0].colour[1]: found '-1', expected 0 to"},
        {24, 32, "  - name: a\n" POINT "    flux: 1\n    colour: red", 27,
         "lights[0].colour: found 'red', expected a list of 3"},
        {24, 32, "  - name: a\n" POINT "    intensity: [1, 1, 1]\n    colour: [1, 1, 1]", 27,
         "lights[0].colour: found it with intensity, which has a colour itself, expected it only with lum"},
        /* A luminance that is too high once the area is known. */
        {24, 32, "  - name: a\n" QUAD "    scale: 1e-6\n    flux: 1e6 lm", 27,
         "lights[0].flux: found '1e6 lm', expected at most 1e+09 times camera.white (80 cd/m2) as the lum"},
        {24, 32, "  - name: a\n" SUN "    illuminance: 1e12", 26,
         "lights[0].illuminance: found '1e12', expected at most 1e+09 times camera.white (80 cd/m2) in any"},
    };
    CHECK_ALL(table);
    write_meshes();
    static const struct wrong open[] = {
        {24, 32, "  - mesh: open.obj\n    flux: 100 lm", 25,
         "lights[0].flux: found it with an open mesh, which shines from both sides, expected a closed one"},
        {24, 32, "  - mesh: sheet.obj\n    flux: 100 lm", 25, "lights[0].flux: found it with an open mesh"},
    };
    CHECK_ALL(open);
}

/* Radiometric and photometric lights in one scene: both are named, with lines and keys. */
static void test_mixtures(void **state)
{
    (void)state;
    static const struct wrong table[] = {
        {26, 26, "    flux: 800 lm", 32,
         "lights[1].radiance: found the radiometric radiance of triangle, and in line 26 the photometric "
         "flux of "
         "quad, expected all lights of a scene radiometric or all photometric"},
        {32, 32, "    luminance: 3000 cd/m2", 32,
         "lights[1].luminance: found the photometric luminance of triangle, and in line 26 the radiometric "
         "radiance of quad, expected all"},
        {24, 32,
         "  - {direction: [0, 1, 0], illuminance: 5}\n  - {position: [0, 0, 9], intensity: [1, 1, 1]}", 25,
         "lights[1].intensity: found the radiometric intensity of lights[1], and in line 24 the photometric "
         "illuminance of lights[0], expected all"},
        {6, 6, "  field-of-view: 40\n  white: 100", 7,
         "camera.white: found it, and in line 27 the radiometric radiance of quad, expected it only with "
         "phot"},
    };
    CHECK_ALL(table);
}

static void test_white(void **state)
{
    (void)state;
    static const struct {
        const char *value, *found;
    } rows[] = {{"0", "'0'"},       {"-5 cd/m2", "'-5 cd/m2'"},   {"100 lx", "'100 lx'"}, {"on", "'on'"},
                {"1e13", "'1e13'"}, {"[1, 1, 1]", "a list of 3"}, {"1e-7", "'1e-7'"},     {"", "nothing"}};
    char text[512], expected[256];
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        snprintf(text, sizeof text,
                 "  white: %s\n  field-of-view: 40\nmaterials: [{name: matt}]\n"
                 "objects: [{shape: sphere, material: matt}]\nlights: [{position: [0, 9, 0], flux: 1}]",
                 rows[i].value);
        snprintf(
            expected, sizeof expected,
            "camera.white: found %s, expected a luminance from 1e-06 to 1e+12 in cd/m2, such as 3000 cd/m2",
            rows[i].found);
        const struct wrong wrong = {6, 32, text, 6, expected};
        check_all(&wrong, 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_kinds),  cmocka_unit_test(test_two_of_one_light), cmocka_unit_test(test_units),
        cmocka_unit_test(test_values), cmocka_unit_test(test_mixtures),         cmocka_unit_test(test_white),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
