/* The study `fur`, measured: pictures are what the closed forms say, panels hold their pixels, and scenes wear the fur. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "studies/fur.h"
#include "studies/judged.h"
#include "studies/runner.h"
#include "support/check.h"

static const struct rl_place alone = {"fur", RL_NO_SCENE, "", 0};

static double figure(const struct rl_run *run, const char *scene, const char *pattern, const char *name)
{
    const struct rl_record *r = rl_run_find(run, scene, pattern);
    const struct rl_metric *m = r ? rl_record_metric(r, name) : NULL;
    if (!m)
        fail_msg("nothing was measured for '%s'", pattern);
    return m ? m->value : NAN;
}

/* The quick grid, group by group, as the runner would. */
static void measure(struct rl_run *run, struct rl_bench *bench, const struct rl_scene *scene)
{
    const struct rl_study *study = rl_study_find("fur");
    struct rl_error error;
    for (size_t first = 0, end; first < run->n_records; first = end) {
        for (end = first; end < run->n_records && run->record[end].group == run->record[first].group; end++)
            run->record[end].status = RL_RECORD_OK;
        check_ok(study->measure(&run->record[first], end - first, bench, scene, &error), &error);
    }
}

static void pictures_are_the_forms(const struct rl_run *run)
{
    assert_true(figure(run, RL_NO_SCENE, "series=terms", "right") < 1e-7);
    check_near(figure(run, RL_NO_SCENE, "series=terms", "wrong"), 2.0, 0.01);
    check_near(figure(run, RL_NO_SCENE, "series=form beta=30 sines=minus sign=lost", "middle"), 81.0 / 256.0,
               1e-12);
    check_near(figure(run, RL_NO_SCENE, "series=form beta=30 sines=plus sign=kept", "middle"), 0.0, 0.0);
    check_near(figure(run, RL_NO_SCENE, "series=form beta=150 sines=plus sign=kept", "middle"), 81.0 / 256.0,
               1e-12);
    check_near(figure(run, RL_NO_SCENE, "series=form beta=0 sines=minus sign=lost", "least"), 1.0, 1e-12);
    check_near(figure(run, RL_NO_SCENE, "series=form beta=0 sines=plus sign=lost", "least"), 0.0, 1e-12);
    check_near(figure(run, RL_NO_SCENE, "series=form beta=0 sines=minus sign=kept", "rim"), 0.0, 0.0);
    check_near(figure(run, RL_NO_SCENE, "series=form beta=0 sines=plus sign=kept", "rim"), 1.0, 1e-12);
    check_near(figure(run, RL_NO_SCENE, "series=profile beta=0 effect=kajiya-printed", "middle"), 0.3, 1e-3);
    check_near(figure(run, RL_NO_SCENE, "series=profile beta=30 effect=kajiya-printed", "middle"),
               0.1 + 0.3 * 81.0 / 256.0, 1e-3);
    check_near(figure(run, RL_NO_SCENE, "series=profile beta=30 effect=kajiya", "middle"), 0.1, 1e-3);
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, RL_NO_SCENE, "series=profile"));)
        assert_true(rl_record_metric(r, "off")->value < 1.0 / 255.0);
}

/* The backdrop in two corners, and green right under the ball's middle, the first row of the lower half. */
static void panels_hold_pixels(const struct rl_run *run)
{
    const struct rl_record *r = rl_run_find(run, RL_NO_SCENE, "series=panel effect=lambert");
    const struct rl_series *s = r ? rl_record_series(r, "pixels") : NULL;
    if (!s) {
        fail_msg("the panel has no pixels");
        return;
    }
    assert_int_equal(s->n, 800);
    uint64_t corner = (uint64_t)s->value[0], middle = (uint64_t)s->value[20];
    /* sRGB of 0.12 is 0.381. */
    assert_int_equal(corner & 0xffffff, 0x616161);
    assert_int_equal((uint64_t)s->value[760] >> 24, 0x616161);
    /* Irradiance 2, N.L = cos 30 to within a pixel, reflectance 0.63, in that exposure. */
    double linear = 2.0 * 0.63 / RL_PI * 0.866 * rl_record_metric(r, "exposure")->value;
    check_near((double)(middle >> 32 & 0xff), 255.0 * (1.055 * pow(linear, 1.0 / 2.4) - 0.055), 6.0);
    assert_true(rl_record_metric(r, "negative")->value == 0.0);
    assert_true(figure(run, RL_NO_SCENE, "series=panel effect=goldman-printed beta=150", "negative") > 0.3);
    assert_true(figure(run, RL_NO_SCENE, "series=panel effect=goldman beta=150", "negative") == 0.0);
}

static void costs_are_there(const struct rl_run *run, const char *scene, double objects, double triangles)
{
    for (const char *const *e = rl_fur_models; *e; e++) {
        char pattern[160];
        snprintf(pattern, sizeof pattern, "series=mono effect=%s", *e);
        assert_true(figure(run, scene, pattern, "rmse") > 0.0);
        snprintf(pattern, sizeof pattern, "series=time effect=%s interpolation=gouraud", *e);
        assert_true(figure(run, scene, pattern, "draws") == objects);
        assert_true(figure(run, scene, pattern, "triangles") == triangles);
        assert_true(figure(run, scene, pattern, "time_to_pixel") > 0.0);
        assert_true(isfinite(figure(run, scene, pattern, "above_baseline_ms")));
    }
    assert_true(figure(run, scene, "series=time effect=kajiya interpolation=phong arm=frame",
                       "time_to_pixel") == 1.0);
}

static void all_is_measured(void **state)
{
    (void)state;
    static const char *const needed[] = {"series=terms",
                                         "series=form sines=plus sign=lost",
                                         "series=profile effect=lengyel",
                                         "series=panel effect=phong",
                                         "series=vertex effect=kajiya tessellation=16",
                                         "series=time arm=again"};
    struct rl_bench bench;
    struct rl_error error;
    struct rl_run run = {.study = "fur", .grid = "quick"};
    check_ok(rl_study_find("fur")->plan_alone(&run, &alone, RL_GRID_QUICK, 0, &error), &error);
    check_plan(&run, needed, sizeof needed / sizeof needed[0]);
    check_ok(rl_bench_open(&bench, "auto", 0, "", NULL, &error), &error);
    measure(&run, &bench, NULL);
    pictures_are_the_forms(&run);
    panels_hold_pixels(&run);
    costs_are_there(&run, RL_NO_SCENE, 1.0,
                    figure(&run, RL_NO_SCENE, "series=vertex tessellation=16", "triangles"));
    for (const char *const *e = rl_fur_models; *e; e++) {
        double last = 1.0;
        for (int t = 8; t <= 32; t *= 2) {
            char pattern[96];
            snprintf(pattern, sizeof pattern, "series=vertex effect=%s tessellation=%d", *e, t);
            double here = figure(&run, RL_NO_SCENE, pattern, "rmse");
            assert_true(here > 0.0 && here < last);
            last = here;
        }
    }
    rl_bench_close(&bench);
    rl_run_clear(&run);
}

static void scenes_wear_fur(void **state)
{
    (void)state;
    struct rl_bench bench;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_run run = {.study = "fur", .grid = "quick"};
    const struct rl_study *study = rl_study_find("fur");
    check_ok(rl_study_scene_load(&scene, "teapot-star", &error), &error);
    check_ok(study->fits(&scene, &error), &error);
    const struct rl_place place = {"fur", "teapot-star", "teapot-star", scene.hash};
    check_ok(study->plan(&run, &place, RL_GRID_QUICK, 0, &error), &error);
    check_ok(rl_bench_open(&bench, "auto", 0, "", NULL, &error), &error);
    measure(&run, &bench, &scene);
    double triangles = 0.0;
    for (size_t i = 0; i < scene.n_objects; i++)
        triangles += (double)scene.object[i].mesh.n_triangles;
    assert_true(figure(&run, "teapot-star", "series=vertex effect=kajiya", "triangles") == triangles);
    assert_true(figure(&run, "teapot-star", "series=vertex effect=kajiya", "rmse") > 0.0);
    costs_are_there(&run, "teapot-star", (double)scene.n_objects, triangles);
    assert_non_null(rl_run_find(&run, "teapot-star", "series=panel effect=goldman"));
    assert_null(rl_run_find(&run, "teapot-star", "series=panel beta=30"));
    rl_bench_close(&bench);
    rl_run_clear(&run);
    rl_scene_clear(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_is_measured),
        cmocka_unit_test(scenes_wear_fur),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
