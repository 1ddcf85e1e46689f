/* Scenes that have nothing to study are refused before anything is measured, and pictures of nothing when they are made: figures of
 * nothing would decide claims. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "studies/bench.h"
#include "studies/planner.h"
#include "studies/scene_check.h"
#include "support/check.h"

#define CAMERA(distance) "camera: {position: [0, 0, " distance "], target: [0, 0, 0], field-of-view: 30}\n"
#define BALL "materials:\n  - {name: a, rr: 10}\nobjects:\n  - {shape: sphere, material: a}\n"
#define DULL "materials:\n  - {name: a, diffuse: [1, 1, 1]}\nobjects:\n  - {shape: sphere, material: a}\n"
#define DULL_BALL                                                                                            \
    "materials:\n  - {name: a, diffuse: [1, 1, 1]}\n  - {name: b, rr: 10}\nobjects:\n"                       \
    "  - {shape: sphere, material: a}\n  - {shape: sphere, material: b, translate: [0, 0, 9]}\n"
#define LIGHT "lights:\n  - {polygon: [[-1, 3, 1], [1, 3, 1], [0, 3, 3]], radiance: [1, 1, 1]}\n"

#define POINTS                                                                                               \
    "lights:\n  - {position: [0, 9, 0], intensity: [1, 1, 1]}\n"                                             \
    "  - {direction: [0, -1, 0], irradiance: [1, 1, 1]}\n"

static const struct {
    const char *text, *message; /* NULL: fine */
} rows[] = {
    {CAMERA("4") BALL LIGHT, NULL},
    {CAMERA("0.5") BALL LIGHT, NULL}, /* from within */
    {CAMERA("4") BALL,
     "found no shaped light (and 0 without a shape), expected a polygon or mesh light to study"},
    {CAMERA("4") BALL POINTS,
     "found no shaped light (and 2 without a shape), expected a polygon or mesh light"},
    {CAMERA("4") DULL LIGHT, "found no object with a highlight, expected one whose material has rr"},
    {CAMERA("400000") BALL LIGHT, "found no object with a highlight at any pixel of "},
    {CAMERA("4") DULL_BALL LIGHT, "found no object with a highlight at any pixel of "}, /* behind */
};

static void write_scene(char path[64], const char *text)
{
    snprintf(path, 64, "/tmp/rl-scene-check-%ld.yaml", (long)getpid());
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    assert_true(fputs(text, f) >= 0);
    assert_int_equal(fclose(f), 0);
}

static void test_nothing_to_study(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char path[64];
        struct rl_error error = {0};
        struct rl_planned *planned = NULL;
        write_scene(path, rows[i].text);
        const char *const scenes[] = {path};
        const struct rl_provenance provenance = {0};
        const struct rl_run_options options = {.scenes = scenes, .n_scenes = 1};
        int status = rl_planned_make(&planned, rl_study_find("samples"), &options, &provenance, &error);
        unlink(path);
        rl_planned_free(planned);
        assert_int_equal(status, rows[i].message ? RL_ERR_INPUT : RL_OK);
        if (rows[i].message && (!strstr(error.message, rows[i].message) || !strstr(error.message, path)))
            fail_msg("'%s', expected '%s: %s...'", error.message, path, rows[i].message);
    }
}

/* So small that no pixel of a few shows it, though one of the film might. */
static void test_reference_of_nothing(void **state)
{
    (void)state;
    struct rl_bench bench;
    struct rl_scene scene;
    struct rl_error error = {0};
    char path[64], cache[256];
    const char *build = getenv("BUILD");
    write_scene(path, CAMERA("100") BALL LIGHT);
    snprintf(cache, sizeof cache, "%s/tests/cache", build ? build : "build");
    check_ok(rl_bench_open(&bench, "auto", 0, cache, NULL, &error), &error);
    check_ok(rl_study_scene_load(&scene, path, &error), &error);
    check_ok(rl_scene_check(&scene, &error), &error);
    const struct rl_image *image;
    int status =
        rl_bench_reference(&image, &bench, &scene, "rr=10 width=4 height=4", RL_LIGHT_FROM_POINT, &error);
    assert_int_equal(status, RL_ERR_INPUT);
    assert_non_null(strstr(error.message, "reference: found no object at any pixel of 4x4"));
    /* Nothing of it was kept: it fails again. */
    status =
        rl_bench_reference(&image, &bench, &scene, "rr=10 width=4 height=4", RL_LIGHT_FROM_POINT, &error);
    assert_int_equal(status, RL_ERR_INPUT);
    check_ok(
        rl_bench_reference(&image, &bench, &scene, "rr=10 width=3 height=3", RL_LIGHT_FROM_POINT, &error),
        &error);
    rl_scene_clear(&scene);
    rl_bench_close(&bench);
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nothing_to_study),
        cmocka_unit_test(test_reference_of_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
