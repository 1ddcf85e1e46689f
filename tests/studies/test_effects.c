/* The study `effects`: verdicts follow from figures of a made-up run; what is measured has a row for whatever is in the tables, and adds up. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "studies/effects.h"
#include "studies/features.h"
#include "studies/judged.h"
#include "studies/runner.h"
#include "support/check.h"

static const struct rl_place made_up = {"effects", "made-up", "made-up.yaml", 1};

struct world {
    double zero, zero_work, sum; /* of the whole */
    double added, removed, room,
        floor; /* ms of phong, half its intervals, and chance; the full frame is 10 ms */
    double added_modules, removed_modules; /* of phong */
    double random, sphere;                 /* ms: what random adds, what the spheres' removal saves */
    double max;                            /* of phong */
};

static const struct world usual = {1.0, 0.0, 1.01, 0.5, 0.45, 0.05, 0.02, 5.0, 1.0, 2.0, -1.0, 0.3};

static void metric(struct rl_record *r, const char *name, double value, double room)
{
    assert_int_equal(rl_record_metric_add(r, name, value, value - room, value + room, "1", NULL), RL_OK);
    r->status = RL_RECORD_OK;
}

static void feature(struct rl_run *run, const char *name, const char *kind, const struct world *w,
                    double added, double removed, double max, double named)
{
    static const char *const work[] = {"draws", "triangles", "bytes", "textures", "programs"};
    struct rl_record *r = rl_run_add(run, &made_up, 0, NULL, "feature=%s kind=%s", name, kind);
    metric(r, "named", named, 0.0);
    metric(r, "added_ms", added, w->room);
    metric(r, "removed_ms", removed, w->room);
    metric(r, "max", max, 0.0);
    for (size_t i = 0; i < sizeof work / sizeof work[0]; i++) {
        char text[RL_NAME_MAX];
        snprintf(text, sizeof text, "added_%s", work[i]);
        metric(r, text, 1.0, 0.0);
        snprintf(text, sizeof text, "removed_%s", work[i]);
        metric(r, text, 1.0, 0.0);
    }
    metric(r, "added_modules", w->added_modules, 0.0);
    metric(r, "removed_modules", w->removed_modules, 0.0);
}

/* Beside the effect that decides there is one like it that is right, and one that the scene does not name, whose figures are not asked. */
static void make(struct rl_run *run, const struct world *w)
{
    *run = (struct rl_run){.study = "effects", .grid = "default"};
    struct rl_record *r = rl_run_add(run, &made_up, 0, NULL, "feature=all kind=base");
    metric(r, "full_ms", 10.0, 0.1);
    metric(r, "floor_ms", w->floor, 0.0);
    metric(r, "time_zero", w->zero, 0.001);
    metric(r, "zero_work", w->zero_work, 0.0);
    metric(r, "time_sum", w->sum, 0.01);
    feature(run, "phong", "effect", w, w->added, w->removed, w->max, 1.0);
    feature(run, "diffuse", "effect", &usual, 0.2, 0.2, 0.4, 1.0);
    feature(run, "blinn", "effect", &usual, 90.0, 1.0, 0.0, 0.0);
    feature(run, "random", "highlight", &usual, w->random, w->random, 0.5, 1.0);
    feature(run, "sphere", "switch", w, w->sphere, w->sphere, 0.0, 1.0);
}

static void verdicts_flip(void **state)
{
    (void)state;
    static const char zero[] = "no time:", work[] = "no work:", both[] = "adds to a bare scene is",
                      sum[] = "add up", share[] = "it would not bring", dearest[] = "no effect costs more",
                      shows[] = "highlight shows", spheres[] = "spheres save time";
    static const struct {
        const char *words;
        size_t field;
        double value;
        enum rl_verdict verdict;
    } rows[] = {
        {zero, offsetof(struct world, zero), 1.0, RL_VERDICT_HOLDS},
        {zero, offsetof(struct world, zero), 1.02, RL_VERDICT_INCONCLUSIVE},
        {zero, offsetof(struct world, zero), 1.1, RL_VERDICT_FAILS},
        {work, offsetof(struct world, zero_work), 0.0, RL_VERDICT_HOLDS},
        {work, offsetof(struct world, zero_work), 1.0, RL_VERDICT_FAILS},
        {both, offsetof(struct world, removed), 0.45, RL_VERDICT_HOLDS},
        {both, offsetof(struct world, removed), 0.05, RL_VERDICT_INCONCLUSIVE},
        {both, offsetof(struct world, removed), 2.0, RL_VERDICT_FAILS},
        {both, offsetof(struct world, floor), 1.0, RL_VERDICT_INCONCLUSIVE},
        {sum, offsetof(struct world, sum), 1.0, RL_VERDICT_HOLDS},
        {sum, offsetof(struct world, sum), 1.3, RL_VERDICT_FAILS},
        {sum, offsetof(struct world, sum), 0.9, RL_VERDICT_INCONCLUSIVE},
        {share, offsetof(struct world, removed_modules), 5.0, RL_VERDICT_HOLDS},
        {share, offsetof(struct world, removed_modules), 6.0, RL_VERDICT_FAILS},
        {dearest, offsetof(struct world, added), 0.5, RL_VERDICT_HOLDS},
        {dearest, offsetof(struct world, added), 3.0, RL_VERDICT_FAILS},
        {dearest, offsetof(struct world, random), 0.5, RL_VERDICT_INCONCLUSIVE},
        {shows, offsetof(struct world, max), 0.3, RL_VERDICT_HOLDS},
        {shows, offsetof(struct world, max), 0.001, RL_VERDICT_FAILS},
        {spheres, offsetof(struct world, sphere), -1.0, RL_VERDICT_HOLDS},
        {spheres, offsetof(struct world, sphere), 1.0, RL_VERDICT_FAILS},
        {spheres, offsetof(struct world, sphere), -0.06, RL_VERDICT_INCONCLUSIVE},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct world w = usual;
        struct rl_run run;
        memcpy((char *)&w + rows[i].field, &rows[i].value, sizeof rows[i].value);
        make(&run, &w);
        struct rl_claim c = claim_of("effects", &run, rows[i].words);
        check_verdict(&c, rows[i].verdict, rows[i].words, rows[i].value);
        rl_run_clear(&run);
    }
}

/* A clock that two arms of the same work differ by a quarter of the frame on tells nothing, whichever way the figures are. */
static void chance_decides_nothing(void **state)
{
    (void)state;
    static const struct {
        const char *words;
        size_t field;
        double right, wrong;
    } rows[] = {
        {"no time:", offsetof(struct world, zero), 1.0, 1.2},
        {"adds to a bare scene is", offsetof(struct world, removed), 0.45, 2.0},
        {"add up", offsetof(struct world, sum), 1.0, 1.3},
        {"no effect costs more", offsetof(struct world, added), 0.5, 3.0},
        {"spheres save time", offsetof(struct world, sphere), -1.0, 1.0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        for (int wrong = 0; wrong < 2; wrong++) {
            struct world w = usual;
            struct rl_run run;
            w.floor = 2.5;
            memcpy((char *)&w + rows[i].field, wrong ? &rows[i].wrong : &rows[i].right, sizeof(double));
            make(&run, &w);
            struct rl_claim c = claim_of("effects", &run, rows[i].words);
            if (c.verdict != RL_VERDICT_INCONCLUSIVE)
                fail_msg("%s is %s", rows[i].words, rl_verdict_name(c.verdict));
            rl_run_clear(&run);
        }
}

/* Four named features: five differences of arms in the sum, each off by 0.02 ms of 10 at most. */
static void the_sum_has_a_floor_for_each_difference(void **state)
{
    (void)state;
    struct rl_run run;
    make(&run, &usual);
    struct rl_claim c = claim_of("effects", &run, "add up");
    check_near(c.low, 1.01 - 0.01 - 5.0 * 0.02 / 10.0, 1e-12);
    check_near(c.high, 1.01 + 0.01 + 5.0 * 0.02 / 10.0, 1e-12);
    rl_run_clear(&run);
}

static void nothing_measured_decides_nothing(void **state)
{
    (void)state;
    struct rl_run run;
    make(&run, &usual);
    check_undecided("effects", &run, 8);
    rl_run_clear(&run);
}

static void measure(struct rl_run *run, const char *name)
{
    struct rl_error error;
    struct rl_bench bench;
    struct rl_scene scene;
    const struct rl_study *study = rl_study_find("effects");
    *run = (struct rl_run){.study = "effects"};
    check_ok(rl_study_scene_load(&scene, name, &error), &error);
    check_ok(rl_effects_fits(&scene, &error), &error);
    const struct rl_place place = {"effects", name, name, scene.hash};
    check_ok(study->plan(run, &place, RL_GRID_QUICK, 0, &error), &error);
    check_ok(rl_bench_open(&bench, "auto", 0, "", NULL, &error), &error);
    check_ok(study->measure(run->record, run->n_records, &bench, &scene, &error), &error);
    for (size_t i = 0; i < run->n_records; i++)
        run->record[i].status = RL_RECORD_OK;
    rl_bench_close(&bench);
    rl_scene_clear(&scene);
}

static double value_of(const struct rl_run *run, const char *name, const char *feature_name, const char *key)
{
    char pattern[128];
    snprintf(pattern, sizeof pattern, "feature=%s", feature_name);
    const struct rl_record *r = rl_run_find(run, name, pattern);
    const struct rl_metric *m = r ? rl_record_metric(r, key) : NULL;
    if (!m)
        fail_msg("%s has no %s", feature_name, key);
    return m ? m->value : NAN;
}

/* Everything of the tables does something in the scene that names what comes with the program, or where it hosts what it does not; each
 * brings its module and takes it away. */
static void everything_is_measured(void **state)
{
    (void)state;
    static const char name[] = "everything";
    struct rl_run run;
    struct rl_feature f[RL_FEATURES_MAX];
    size_t n = rl_features_list(f);
    measure(&run, name);
    assert_int_equal(run.n_records, n + 1);
    for (size_t i = 0; i < n; i++) {
        const char *of = f[i].name;
        assert_true(value_of(&run, name, of, "row") == (double)i);
        /* Culling shows in no pixel of closed meshes. */
        bool is_switch = f[i].kind == RL_FEATURE_SWITCH;
        bool culling = is_switch && f[i].which == RL_SWITCH_CULLING;
        double max = value_of(&run, name, of, "max"), rmse = value_of(&run, name, of, "rmse");
        double share = value_of(&run, name, of, "share");
        assert_true(culling ? max == 0.0 && rmse == 0.0 && share == 0.0
                            : max > 0.0 && rmse > 0.0 && share > 0.0 && share <= 1.0);
        assert_true(isfinite(value_of(&run, name, of, "added_ms")) &&
                    isfinite(value_of(&run, name, of, "removed_ms")));
        bool module = !is_switch || f[i].which == RL_SWITCH_SPHERE;
        assert_true(!module || value_of(&run, name, of, "removed_modules") >= 1.0);
    }
    assert_true(value_of(&run, name, "random", "removed_textures") == 2.0);
    assert_true(value_of(&run, name, "regular", "removed_textures") == 1.0);
    assert_true(value_of(&run, name, "diffuse-area", "removed_bytes") == 32 + 4 * 16);
    assert_true(value_of(&run, name, "sphere", "removed_draws") == 2.0);
    assert_true(value_of(&run, name, "phong", "removed_draws") == 0.0);
    assert_true(value_of(&run, name, "attenuation", "removed_modules") == 0.0);
    assert_int_equal(claim_of("effects", &run, "no work").verdict, RL_VERDICT_HOLDS);
    assert_int_equal(claim_of("effects", &run, "would not bring").verdict, RL_VERDICT_HOLDS);
    assert_int_equal(claim_of("effects", &run, "highlight shows").verdict, RL_VERDICT_HOLDS);
    rl_run_clear(&run);
}

/* A scene without any highlight hosts them, and what excludes its own effects takes their place. */
static void others_are_hosted(void **state)
{
    (void)state;
    static const char name[] = "lamps";
    struct rl_run run;
    measure(&run, name);
    assert_true(value_of(&run, name, "phong", "named") == 1.0);
    assert_true(value_of(&run, name, "blinn", "named") == 0.0);
    assert_true(value_of(&run, name, "blinn", "removed_modules") >= 1.0);
    assert_true(value_of(&run, name, "blinn", "max") > 0.0);
    assert_true(value_of(&run, name, "kajiya", "removed_modules") >= 1.0);
    /* There is no shaped light: nothing for a highlight to show. */
    assert_true(value_of(&run, name, "random", "added_modules") == 0.0);
    assert_true(value_of(&run, name, "random", "max") == 0.0);
    rl_run_clear(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdicts_flip),
        cmocka_unit_test(chance_decides_nothing),
        cmocka_unit_test(the_sum_has_a_floor_for_each_difference),
        cmocka_unit_test(nothing_measured_decides_nothing),
        cmocka_unit_test(everything_is_measured),
        cmocka_unit_test(others_are_hosted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
