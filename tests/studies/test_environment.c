/* The study `environment`: scenes moved about look the same from where they must, and verdicts follow from the rows. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "studies/environment.h"
#include "studies/judged.h"
#include "studies/judging.h"
#include "studies/runner.h"
#include "support/check.h"

static const struct rl_place place = {"environment", "made-up", "made-up.yaml", 1};

/* A light that is moved away is seen in the same directions from the object's centre, and its sizes go with it. */
static void test_away(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene, copy;
    check_ok(rl_study_scene_load(&scene, "three-lights", &error), &error);
    struct rl_environment_move move = {.away = 5.0};
    check_ok(rl_environment_scene_make(&copy, &scene, &move, &error), &error);
    rl_vec3 centre = scene.object[rl_environment_object(&scene)].centre;
    for (size_t i = 0; i < scene.n_lights; i++) {
        const struct rl_polygon *p = scene.light[i].polygon, *q = copy.light[i].polygon;
        for (int k = 0; k < p->n; k++) {
            rl_vec3 a = v3_sub(p->vertex[k], centre), b = v3_sub(q->vertex[k], centre);
            check_near(v3_length(v3_sub(b, v3_scale(5.0, a))), 0.0, 1e-12);
        }
        check_near(copy.light[i].radius, 5.0 * scene.light[i].radius, 1e-12);
        check_near(copy.light[i].area, 25.0 * scene.light[i].area, 1e-9);
        check_near(q->area, 25.0 * p->area, 1e-9);
    }
    assert_true(copy.hash != scene.hash);
    const struct rl_effect *ambient = rl_effect_find("ambient");
    assert_null(rl_effect_given(&copy.material[0], ambient));
    assert_true(rl_effect_wanted(&scene.material[0], ambient));
    assert_memory_equal(copy.object[0].mesh.position, scene.object[0].mesh.position,
                        scene.object[0].mesh.n_vertices * sizeof *scene.object[0].mesh.position);
    rl_environment_scene_free(&copy);
    rl_scene_clear(&scene);
}

/* Turned: the first light's middle is where it was sent, it is alone, and all distances are as they were. */
static void test_turned(void **state)
{
    (void)state;
    static const rl_vec3 to[] = {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {-1, 0, 0}};
    struct rl_error error;
    struct rl_scene scene, copy;
    check_ok(rl_study_scene_load(&scene, "three-lights", &error), &error);
    for (size_t i = 0; i < 4; i++) {
        struct rl_environment_move move = {1.0, to[i]};
        check_ok(rl_environment_scene_make(&copy, &scene, &move, &error), &error);
        rl_vec3 u = v3_sub(copy.light[0].centre, copy.object[0].centre);
        check_near(v3_length(v3_sub(v3_normalize(u), v3_normalize(to[i]))), 0.0, 1e-9);
        assert_true(copy.light[0].radiance[0] > 0.0 && copy.light[1].radiance[1] == 0.0);
        const float *p = scene.object[1].mesh.position[7], *q = copy.object[1].mesh.position[7];
        check_near(v3_length(v3_sub(v3(q[0], q[1], q[2]), copy.camera.position)),
                   v3_length(v3_sub(v3(p[0], p[1], p[2]), scene.camera.position)), 1e-6);
        check_near(v3_dot(v3_cross(copy.camera.right, copy.camera.up), copy.camera.forward), -1.0, 1e-9);
        check_near(v3_dot(copy.light[0].polygon->normal, v3_normalize(u)),
                   v3_dot(scene.light[0].polygon->normal,
                          v3_normalize(v3_sub(scene.light[0].centre, scene.object[0].centre))),
                   1e-9);
        rl_environment_scene_free(&copy);
    }
    rl_scene_clear(&scene);
}

/* The distance of a point from a light, by trying 200 x 200 points of each triangle. */
static double tried(rl_vec3 p, const struct rl_light *light)
{
    double nearest = INFINITY;
    for (size_t k = 0; k < light->n_polygons; k++)
        for (int t = 0; t < light->polygon[k].n - 2; t++) {
            const uint32_t *corner = light->polygon[k].triangle[t];
            const rl_vec3 *v = light->polygon[k].vertex;
            rl_vec3 a = v[corner[0]], b = v3_sub(v[corner[1]], a), c = v3_sub(v[corner[2]], a);
            for (int i = 0; i <= 200; i++)
                for (int m = 0; m <= 200 - i; m++)
                    nearest =
                        fmin(nearest, v3_length(v3_sub(v3_madd(v3_madd(a, i / 200.0, b), m / 200.0, c), p)));
        }
    return nearest;
}

/* An object grows until it meets the first of the lights, no further. */
static void test_room(void **state)
{
    (void)state;
    static const char *const name[] = {"teapot-star", "sphere-quad", "three-lights"};
    for (size_t s = 0; s < 3; s++) {
        struct rl_error error;
        struct rl_scene scene;
        check_ok(rl_study_scene_load(&scene, name[s], &error), &error);
        const struct rl_object *object = &scene.object[rl_environment_object(&scene)];
        double nearest = INFINITY;
        for (size_t i = 0; i < scene.n_lights; i++)
            nearest = fmin(nearest, tried(object->centre, &scene.light[i]));
        double least = object->radius / nearest;
        print_message("%s: away from %g on\n", name[s], least);
        char text[64];
        snprintf(text, sizeof text, "series=parallax away=%.17g", 1.001 * least);
        check_ok(rl_environment_check(text, &scene, &error), &error);
        snprintf(text, sizeof text, "series=parallax away=%.17g", 0.999 * least);
        check_fails(rl_environment_check(text, &scene, &error), &error, RL_ERR_INPUT, "meets the light '");
        check_ok(rl_environment_check("series=size base=0 env_size=64", &scene, &error), &error);
        rl_scene_clear(&scene);
    }
}

/* RMSE of a made-up world. */
struct world {
    double texels_256, slope, bits_8, parallax, parallax_slope, corner, floor_256, floor_1024;
    double highlight;
    int hidden; /* of a map of so many texels noise hides the error, which is at most hidden_high */
    double hidden_high;
};

static const struct world usual = {0.001, -1.5, 0.0005, 0.03, 1.0, 0.01, 0.002, 0.001, 0.1, 0, 0.0};

static struct rl_record *add(struct rl_run *run, const char *parameters, const char *name, double value)
{
    struct rl_record *r = rl_run_add(run, &place, 0, NULL, "%s", parameters);
    assert_int_equal(rl_record_metric_add(r, name, value, 0.98 * value, 1.02 * value, "1", NULL), RL_OK);
    r->status = RL_RECORD_OK;
    return r;
}

static void make(struct rl_run *run, const struct world *w)
{
    char text[128];
    *run = (struct rl_run){.study = "environment", .grid = "default"};
    add(run, "series=size base=1 env_size=1024", "floor_centre", w->floor_1024);
    for (int size = 16; size <= 512; size *= 2) {
        snprintf(text, sizeof text, "series=size base=0 env_size=%d", size);
        double e = w->texels_256 * pow(size / 256.0, w->slope);
        struct rl_record *r = add(run, text, "rmse_map", e);
        double floor = w->floor_256 * 256.0 / size;
        assert_int_equal(rl_record_metric_add(r, "floor_centre", floor, floor, floor, "1", NULL), RL_OK);
        /* The two largest are too near to the base to be believed. */
        double seen = size == 512 ? 1e-9 : size == w->hidden ? 0.0 : e;
        double high = size == w->hidden ? w->hidden_high : seen;
        assert_int_equal(rl_record_metric_add(r, "floor_map", seen, seen, high, "1", NULL), RL_OK);
    }
    add(run, "series=format base=0 env_format=rgba8", "rmse_map", w->bits_8);
    /* In no order, and with one larger than the scene's own: as an axis may have them. */
    static const double distances[] = {4, 1, 0.5, 16, 2, 8};
    for (size_t i = 0; i < sizeof distances / sizeof distances[0]; i++) {
        double away = distances[i];
        snprintf(text, sizeof text, "series=parallax away=%g", away);
        struct rl_record *r = add(run, text, "parallax", w->parallax * pow(away, -w->parallax_slope));
        assert_int_equal(rl_record_metric_add(r, "size", 0.2 / away, 0.2 / away, 0.2 / away, "1", NULL),
                         RL_OK);
    }
    add(run, "series=seam base=0 place=middle env_size=64", "floor_map", 0.01);
    add(run, "series=seam base=0 place=edge env_size=64", "floor_map", 0.009);
    add(run, "series=seam base=0 place=corner env_size=64", "floor_map", w->corner);
    add(run, "series=seam base=0 place=middle env_size=256", "floor_map", 0.0001);
    for (size_t i = 0; i < run->n_records; i++)
        assert_int_equal(rl_record_metric_add(&run->record[i], "highlight", w->highlight, w->highlight,
                                              w->highlight, "1", NULL),
                         RL_OK);
}

static struct rl_claim judge(struct world w, const char *words)
{
    struct rl_run run;
    make(&run, &w);
    struct rl_claim found = claim_of("environment", &run, words);
    rl_run_clear(&run);
    return found;
}

static void test_flips(void **state)
{
    (void)state;
    static const char enough[] = "256 texels a face edge are enough";
    struct world w = usual;
    assert_int_equal(judge(w, enough).verdict, RL_VERDICT_HOLDS);
    w.texels_256 = 0.01;
    assert_int_equal(judge(w, enough).verdict, RL_VERDICT_FAILS);

    static const char bits[] = "texels of 8 bits are enough";
    assert_int_equal(judge(w, bits).verdict, RL_VERDICT_HOLDS);
    w.bits_8 = 0.004;
    assert_int_equal(judge(w, bits).verdict, RL_VERDICT_INCONCLUSIVE);
    w.bits_8 = 0.005;
    assert_int_equal(judge(w, bits).verdict, RL_VERDICT_FAILS);
    assert_null(strstr(judge(w, bits).note, rl_judging_exactly));
    w.bits_8 = 0.0; /* nothing between what the format holds */
    assert_int_equal(judge(w, bits).verdict, RL_VERDICT_HOLDS);
    assert_non_null(strstr(judge(w, bits).note, rl_judging_exactly));

    static const char true_256[] = "a map of 256 texels shows is true",
                      true_base[] = "the largest map shows is true";
    w = usual;
    assert_int_equal(judge(w, true_256).verdict, RL_VERDICT_HOLDS);
    assert_int_equal(judge(w, true_base).verdict, RL_VERDICT_HOLDS);
    w.floor_256 = 0.005;
    assert_int_equal(judge(w, true_256).verdict, RL_VERDICT_FAILS);
    w.floor_1024 = 0.005;
    assert_int_equal(judge(w, true_base).verdict, RL_VERDICT_FAILS);

    static const char slope[] = "in proportion to its texels' size";
    w = usual;
    assert_true(fabs(judge(w, slope).value + 1.5) < 1e-9);
    assert_int_equal(judge(w, slope).verdict, RL_VERDICT_HOLDS);
    w.slope = -0.5;
    assert_int_equal(judge(w, slope).verdict, RL_VERDICT_FAILS);

    /* What noise hides is not left out without a word: it may be as large as its interval says. */
    w = usual;
    w.hidden = 256;
    w.hidden_high = 0.001; /* on the line */
    struct rl_claim c = judge(w, slope);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_string_equal(c.note, "hidden by noise at texels 256 (at most 0.001)");
    w.hidden_high = 0.1; /* no fall is known there */
    c = judge(w, slope);
    assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
    assert_true(fabs(c.value + 1.5) < 1e-9 && c.high > -1.0);
    w.hidden_high = 0.0;
    c = judge(w, slope);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_string_equal(c.note, "left out, no error at all, texels 256");

    static const char parallax[] = "one map for a whole object serves";
    w = usual;
    c = judge(w, parallax);
    assert_int_equal(c.verdict, RL_VERDICT_FAILS);
    assert_non_null(strstr(c.note, "light's distance 0.2; "));
    assert_non_null(strstr(c.note, "1/255 is reached at 0.0261")); /* 0.2/255/0.03 */
    w.parallax = 0.001;
    assert_int_equal(judge(w, parallax).verdict, RL_VERDICT_HOLDS);

    static const char growth[] = "parallax grows in proportion";
    w = usual;
    assert_int_equal(judge(w, growth).verdict, RL_VERDICT_HOLDS);
    w.parallax_slope = 0.5;
    assert_int_equal(judge(w, growth).verdict, RL_VERDICT_FAILS);

    static const char seams[] = "seams do no harm";
    w = usual;
    assert_int_equal(judge(w, seams).verdict, RL_VERDICT_HOLDS);
    w.corner = 0.05;
    c = judge(w, seams);
    assert_int_equal(c.verdict, RL_VERDICT_FAILS);
    assert_true(fabs(c.value - 5.0) < 1e-9);
}

/* Without a highlight all errors are 0, and say nothing; nor is an error of 0 the format's where it is the map's size that differs. */
static void test_dark(void **state)
{
    (void)state;
    static const char *const words[] = {"256 texels a face edge are enough", "texels of 8 bits are enough",
                                        "a map of 256 texels shows is true", "the largest map shows is true",
                                        "one map for a whole object serves"};
    struct world dark = usual, equal = usual;
    dark.texels_256 = dark.bits_8 = dark.parallax = dark.floor_256 = dark.floor_1024 = dark.highlight = 0.0;
    equal.texels_256 = equal.bits_8 = equal.parallax = 0.0;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        struct rl_claim c = judge(dark, words[i]);
        assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
        assert_true(isnan(c.value));
        assert_string_equal(c.note, rl_judging_dark);
        c = judge(equal, words[i]);
        assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
        assert_int_equal(strstr(c.note, rl_judging_exactly) != NULL, i == 1);
    }
}

/* Nothing measured: no verdict is made up; every grid has what the claims need. */
static void test_plan(void **state)
{
    (void)state;
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "environment"};
        assert_int_equal(rl_study_find("environment")->plan(&run, &place, (enum rl_grid)grid, 0, NULL),
                         RL_OK);
        check_undecided("environment", &run, 8);
        static const char *const needed[] = {
            "series=size base=0 env_size=256", "series=format base=0 env_format=rgba8",
            "series=parallax away=1",          "series=seam base=0 place=corner",
            "series=seam base=0 place=edge",   "series=seam base=0 place=middle",
        };
        check_plan(&run, needed, sizeof needed / sizeof needed[0]);
        rl_run_clear(&run);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_away),  cmocka_unit_test(test_turned), cmocka_unit_test(test_room),
        cmocka_unit_test(test_flips), cmocka_unit_test(test_dark),   cmocka_unit_test(test_plan),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
