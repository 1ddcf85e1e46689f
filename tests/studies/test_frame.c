/* The study `frame`: verdicts follow from figures of a made-up run; what is measured obeys what is known of it. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "studies/judged.h"
#include "studies/runner.h"
#include "studies/study.h"
#include "support/check.h"
#include "support/temporary.h"

static const struct rl_place alone = {"frame", RL_NO_SCENE, "", 0};
static const struct rl_place made_up = {"frame", "made-up", "made-up.yaml", 1};

struct world {
    double width, against, half; /* of the lobe */
    double rms, spread;          /* of the highlight */
    double rmse, max;            /* of a scene */
    double room;                 /* half width of intervals, relative */
};

static const struct world usual = {0.785, 1.002, 0.134, 0.05, 1e-9, 0.001, 0.02, 0.002};

static void metric(struct rl_record *r, const char *name, double value, double room)
{
    assert_int_equal(
        rl_record_metric_add(r, name, value, value * (1.0 - room), value * (1.0 + room), "1", NULL), RL_OK);
    r->status = RL_RECORD_OK;
}

/* Other R_r than the central one, which is nearest to 30, are as they should be: they must not decide. */
static void make_at(struct rl_run *run, const struct world *w, double central)
{
    const double rr[] = {3.0, central};
    *run = (struct rl_run){.study = "frame", .grid = "default"};
    for (size_t i = 0; i < 2; i++) {
        struct rl_record *r = rl_run_add(run, &alone, 0, NULL, "series=lobe rr=%g", rr[i]);
        metric(r, "width", i ? w->width : 1.0, w->room);
        metric(r, "against_formula", i ? 1.0 : w->against, w->room);
        metric(r, "half", i ? w->half : 0.0, w->room);
        for (int p = 0; p < 2; p++) {
            r = rl_run_add(run, &alone, 1, NULL, "series=light place=%s rr=%g", p ? "inside" : "far", rr[i]);
            metric(r, "rms", i && p ? w->rms : 0.0, w->room);
            metric(r, "spread", i && p ? w->spread : 0.0, w->room);
        }
        r = rl_run_add(run, &made_up, 2, NULL, "series=scene rr=%g", rr[i]);
        metric(r, "rmse", i ? w->rmse : 0.0, w->room);
        metric(r, "max", i ? w->max : 0.0, w->room);
    }
}

static void make(struct rl_run *run, const struct world *w)
{
    make_at(run, w, 30.0);
}

static struct rl_claim judge(struct world w, const char *words)
{
    struct rl_run run;
    make(&run, &w);
    struct rl_claim found = claim_of("frame", &run, words);
    rl_run_clear(&run);
    return found;
}

/* Off the study's own grid the R_r that is nearest to 30 is judged, and the claim says which. */
static void another_rr_is_judged(void **state)
{
    (void)state;
    static const char *const words[] = {"is a rotation",
                                        "half its width",
                                        "a highlight of R_r 20 by",
                                        "1e-5, R_r 20)",
                                        "whole picture at R_r 20 by",
                                        "picture at R_r 20 by more"};
    const double expected[] = {usual.width, usual.half, usual.rms, usual.spread, usual.rmse, usual.max};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        struct rl_run run;
        make_at(&run, &usual, 20.0);
        struct rl_claim c = claim_of("frame", &run, words[i]);
        rl_run_clear(&run);
        assert_true(c.verdict != RL_VERDICT_INCONCLUSIVE);
        check_near(c.value, expected[i], 0.0);
    }
}

static void verdicts_flip(void **state)
{
    (void)state;
    static const char rotation[] = "is a rotation", formula[] = "narrows the lobe", half[] = "half its width",
                      light[] = "moves a highlight", spread[] = "the same everywhere",
                      picture[] = "the whole picture", pixel[] = "no pixel";
    static const struct {
        const char *words;
        size_t field;
        double value;
        enum rl_verdict verdict;
    } rows[] = {
        {rotation, offsetof(struct world, width), 0.785, RL_VERDICT_FAILS},
        {rotation, offsetof(struct world, width), 1.0, RL_VERDICT_HOLDS},
        {rotation, offsetof(struct world, width), 0.99, RL_VERDICT_INCONCLUSIVE},
        {formula, offsetof(struct world, against), 1.002, RL_VERDICT_HOLDS},
        {formula, offsetof(struct world, against), 0.95, RL_VERDICT_FAILS},
        {half, offsetof(struct world, half), 0.134, RL_VERDICT_FAILS},
        {half, offsetof(struct world, half), 0.005, RL_VERDICT_HOLDS},
        {half, offsetof(struct world, half), 0.01, RL_VERDICT_INCONCLUSIVE},
        {light, offsetof(struct world, rms), 0.05, RL_VERDICT_FAILS},
        {light, offsetof(struct world, rms), 0.001, RL_VERDICT_HOLDS},
        {spread, offsetof(struct world, spread), 1e-9, RL_VERDICT_HOLDS},
        {spread, offsetof(struct world, spread), 1e-3, RL_VERDICT_FAILS},
        {picture, offsetof(struct world, rmse), 0.001, RL_VERDICT_HOLDS},
        {picture, offsetof(struct world, rmse), 0.01, RL_VERDICT_FAILS},
        {pixel, offsetof(struct world, max), 0.02, RL_VERDICT_FAILS},
        {pixel, offsetof(struct world, max), 0.001, RL_VERDICT_HOLDS},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct world w = usual;
        memcpy((char *)&w + rows[i].field, &rows[i].value, sizeof rows[i].value);
        struct rl_claim c = judge(w, rows[i].words);
        check_verdict(&c, rows[i].verdict, rows[i].words, rows[i].value);
        check_near(c.value, rows[i].value, 0.0);
    }
    assert_string_equal(judge(usual, picture).command, "roughlight study run frame --scene made-up.yaml");
    assert_string_equal(judge(usual, light).command, "roughlight study run frame");
}

static void nothing_measured(void **state)
{
    (void)state;
    struct rl_run run;
    make(&run, &usual);
    check_undecided("frame", &run, 7);
    rl_run_clear(&run);
}

static const struct rl_record *measured(const struct rl_run *run, const char *scene, const char *pattern)
{
    const struct rl_record *r = rl_run_find(run, scene, pattern);
    if (!r)
        fail_msg("nothing was measured for '%s'", pattern);
    return r;
}

static struct rl_metric figure(const struct rl_run *run, const char *scene, const char *pattern,
                               const char *name)
{
    const struct rl_metric *m = rl_record_metric(measured(run, scene, pattern), name);
    assert_non_null(m);
    assert_true(m->low <= m->value && m->value <= m->high);
    return *m;
}

/* The quick grid, and one scene, as the runner would. */
static void measure_all(struct rl_run *run, struct rl_bench *bench, const struct rl_scene *scene)
{
    const struct rl_study *study = rl_study_find("frame");
    const struct rl_place place = {"frame", "sphere-quad", "sphere-quad", scene->hash};
    struct rl_error error;
    *run = (struct rl_run){.study = "frame", .grid = "quick"};
    check_ok(study->plan_alone(run, &alone, RL_GRID_QUICK, 0, &error), &error);
    check_ok(study->plan(run, &place, RL_GRID_QUICK, 100, &error), &error);
    for (size_t i = 0; i < run->n_records; i++) {
        bool has_scene = strcmp(run->record[i].scene, RL_NO_SCENE) != 0;
        run->record[i].status = RL_RECORD_OK;
        check_ok(study->measure(&run->record[i], 1, bench, has_scene ? scene : NULL, &error), &error);
    }
}

static void what_is_known_is_measured(void **state)
{
    (void)state;
    struct temporary folder = {0};
    char cache[PATH_MAX];
    struct rl_bench bench;
    struct rl_scene scene = {0};
    struct rl_error error;
    struct rl_run run;
    temporary_make(&folder);
    temporary_path(&folder, cache, "cache");
    check_ok(rl_bench_open(&bench, "auto", 0, cache, NULL, &error), &error);
    check_ok(rl_study_scene_load(&scene, "sphere-quad", &error), &error);
    measure_all(&run, &bench, &scene);
    /* Over the sphere |n_x| is uniform: l has the mean pi/4, and is below 1/2 where |n_x| > sqrt(3)/2. */
    static const char lobe[] = "series=lobe rr=30";
    check_near(figure(&run, RL_NO_SCENE, lobe, "width").value, RL_PI / 4.0, 0.02);
    check_near(figure(&run, RL_NO_SCENE, lobe, "width90").value, 0.79, 0.02);
    check_near(figure(&run, RL_NO_SCENE, lobe, "half").value, 1.0 - sqrt(0.75), 0.03);
    check_near(figure(&run, RL_NO_SCENE, lobe, "against_formula").value, 1.0, 0.015);
    check_near(figure(&run, RL_NO_SCENE, "series=lobe rr=3", "against_formula").value, 1.0, 0.015);
    const struct rl_series *map = rl_record_series(measured(&run, RL_NO_SCENE, lobe), "map");
    assert_non_null(map);
    assert_int_equal(map->n, 18 * 36);
    assert_true(map->value[9 * 36 + 18] < 0.2); /* beside +x: sin(5 degrees) sqrt(2) */
    assert_true(map->value[9 * 36 + 27] > 0.7); /* beside +y */
    /* A narrower lobe sees more of a light that the mirror direction meets, less of one that it misses. */
    assert_true(figure(&run, RL_NO_SCENE, "series=light place=middle rr=30", "mean").value > 0.01);
    assert_true(figure(&run, RL_NO_SCENE, "series=light place=outside rr=30", "mean").value < -0.01);
    assert_true(figure(&run, RL_NO_SCENE, "series=light place=middle rr=30", "spread").value < 1e-12);
    /* As N goes to +-x all of the lobe goes into the mirror direction: L_o tends to G = 1 in the light. */
    const struct rl_series *profile =
        rl_record_series(measured(&run, RL_NO_SCENE, "series=light place=middle rr=30"), "profile");
    double truth = figure(&run, RL_NO_SCENE, "series=light place=middle rr=30", "orthonormal").value;
    assert_non_null(profile);
    for (size_t i = 0; i < profile->n; i += 2)
        if (profile->value[i] > 0.99)
            check_near(truth + profile->value[i + 1], 1.0, 0.02);
    /* The sphere's picture moves, most of it hardly. */
    assert_true(figure(&run, "sphere-quad", "series=scene rr=30", "max").value > 1.0 / 255.0);
    assert_true(figure(&run, "sphere-quad", "series=scene rr=30", "rmse").value < 1.0 / 255.0);
    assert_true(figure(&run, "sphere-quad", "series=scene rr=30", "moved").value > 0.001);
    rl_run_clear(&run);
    rl_scene_clear(&scene);
    rl_bench_close(&bench);
    temporary_remove(&folder);
}

static void every_grid_has_what_claims_need(void **state)
{
    (void)state;
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "frame"};
        const struct rl_study *study = rl_study_find("frame");
        assert_int_equal(study->plan_alone(&run, &alone, (enum rl_grid)grid, 0, NULL), RL_OK);
        assert_int_equal(study->plan(&run, &made_up, (enum rl_grid)grid, 100, NULL), RL_OK);
        static const char *const needed[] = {"series=lobe rr=30", "series=light place=middle rr=30",
                                             "series=light place=far rr=30", "series=scene rr=30"};
        check_plan(&run, needed, sizeof needed / sizeof needed[0]);
        rl_run_clear(&run);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdicts_flip),
        cmocka_unit_test(another_rr_is_judged),
        cmocka_unit_test(nothing_measured),
        cmocka_unit_test(what_is_known_is_measured),
        cmocka_unit_test(every_grid_has_what_claims_need),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
