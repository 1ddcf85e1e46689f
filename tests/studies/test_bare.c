/* The study `bare`: verdicts follow from figures of a made-up run; the bare program draws the plan's picture and takes no other scene. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "studies/bare.h"
#include "studies/judged.h"
#include "studies/runner.h"
#include "support/check.h"
#include "support/temporary.h"

static const struct rl_place made_up = {"bare", "made-up", "made-up.yaml", 1};

struct world {
    double plan, again, literals, baked, room; /* ratios, and half the width of their intervals */
    double worst, draws, programs, textures, stencil;
};

static const struct world usual = {0.99, 1.0, 0.87, 1.14, 0.004, 1e-5, 1.0, 1.0, 0.0, 0.0};

static void metric(struct rl_record *r, const char *name, double value, double room)
{
    assert_int_equal(rl_record_metric_add(r, name, value, value - room, value + room, "1", NULL), RL_OK);
    r->status = RL_RECORD_OK;
}

/* A smaller picture beside it must not decide. */
static void make(struct rl_run *run, const struct world *w)
{
    *run = (struct rl_run){.study = "bare", .grid = "default"};
    for (int k = 0; k < 2; k++) {
        const struct {
            const char *arm;
            double ratio;
        } rows[] = {{"plan", w->plan}, {"uniforms", 1.0}, {"again", w->again}, {"literals", w->literals}};
        for (size_t i = 0; i < 4; i++) {
            struct rl_record *r =
                rl_run_add(run, &made_up, k, NULL, "arm=%s width=%d", rows[i].arm, k ? 640 : 160);
            metric(r, "time_to_uniforms", k ? rows[i].ratio : 1.0, i == 1 ? 0.0 : w->room);
            if (i > 0) {
                metric(r, "worst", k ? w->worst : 0.0, 0.0);
                continue;
            }
            metric(r, "time_to_literals", k ? w->baked : 1.0, w->room);
            metric(r, "draws", k ? w->draws : 1.0, 0.0);
            metric(r, "programs", k ? w->programs : 1.0, 0.0);
            metric(r, "textures", k ? w->textures : 0.0, 0.0);
            metric(r, "stencil", k ? w->stencil : 0.0, 0.0);
        }
    }
}

static void verdicts_flip(void **state)
{
    (void)state;
    static const char bound[] = "1.03 times a bare OpenGL program", work[] = "draws once",
                      same[] = "the same picture", literals[] = "in place of uniforms",
                      baked[] = "baking a scene's constants";
    static const struct {
        const char *words;
        size_t field;
        double value;
        enum rl_verdict verdict;
    } rows[] = {
        {bound, offsetof(struct world, plan), 0.99, RL_VERDICT_HOLDS},
        {bound, offsetof(struct world, plan), 1.019, RL_VERDICT_HOLDS},
        {bound, offsetof(struct world, plan), 1.025, RL_VERDICT_INCONCLUSIVE},
        {bound, offsetof(struct world, plan), 1.05, RL_VERDICT_FAILS},
        {bound, offsetof(struct world, again), 1.05, RL_VERDICT_INCONCLUSIVE}, /* so much is chance */
        {bound, offsetof(struct world, room), 0.05, RL_VERDICT_INCONCLUSIVE},
        {work, offsetof(struct world, draws), 1.0, RL_VERDICT_HOLDS},
        {work, offsetof(struct world, draws), 2.0, RL_VERDICT_FAILS},
        {work, offsetof(struct world, programs), 2.0, RL_VERDICT_FAILS},
        {work, offsetof(struct world, textures), 1.0, RL_VERDICT_FAILS},
        {work, offsetof(struct world, stencil), 1.0, RL_VERDICT_FAILS},
        {same, offsetof(struct world, worst), 1e-5, RL_VERDICT_HOLDS},
        {same, offsetof(struct world, worst), 1e-3, RL_VERDICT_FAILS},
        {baked, offsetof(struct world, baked), 1.0, RL_VERDICT_HOLDS},
        {baked, offsetof(struct world, baked), 1.14, RL_VERDICT_FAILS},
        {baked, offsetof(struct world, again), 1.2, RL_VERDICT_INCONCLUSIVE},
        {literals, offsetof(struct world, literals), 0.87, RL_VERDICT_FAILS},
        {literals, offsetof(struct world, literals), 0.95, RL_VERDICT_HOLDS},
        {literals, offsetof(struct world, literals), 0.9, RL_VERDICT_INCONCLUSIVE},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct world w = usual;
        struct rl_run run;
        memcpy((char *)&w + rows[i].field, &rows[i].value, sizeof rows[i].value);
        make(&run, &w);
        struct rl_claim c = claim_of("bare", &run, rows[i].words);
        check_verdict(&c, rows[i].verdict, rows[i].words, rows[i].value);
        rl_run_clear(&run);
    }
}

static void nothing_measured_decides_nothing(void **state)
{
    (void)state;
    struct rl_run run;
    make(&run, &usual);
    check_undecided("bare", &run, 5);
    rl_run_clear(&run);
}

/* The pictures are one but for rounding, the work is what the bar says, and every time has been taken. */
static void measured(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_bench bench;
    struct rl_scene scene;
    struct rl_run run = {.study = "bare"};
    const struct rl_study *study = rl_study_find("bare");
    check_ok(rl_study_scene_load(&scene, "lamps", &error), &error);
    check_ok(rl_bare_fits(&scene, &error), &error);
    const struct rl_place place = {"bare", "lamps", "lamps", scene.hash};
    check_ok(study->plan(&run, &place, RL_GRID_QUICK, 0, &error), &error);
    check_ok(rl_bench_open(&bench, "auto", 0, "", NULL, &error), &error);
    check_ok(study->measure(run.record, run.n_records, &bench, &scene, &error), &error);
    for (size_t i = 0; i < run.n_records; i++) {
        run.record[i].status = RL_RECORD_OK;
        assert_true(rl_record_metric(&run.record[i], "frame_ms")->value > 0.0);
    }
    assert_true(claim_of("bare", &run, "baking a scene's constants").value > 0.0);
    assert_int_equal(claim_of("bare", &run, "draws once").verdict, RL_VERDICT_HOLDS);
    assert_int_equal(claim_of("bare", &run, "the same picture").verdict, RL_VERDICT_HOLDS);
    rl_bench_close(&bench);
    rl_run_clear(&run);
    rl_scene_clear(&scene);
}

static double work_of(struct rl_gpu_scene *gs, const char *name)
{
    struct rl_error error;
    struct rl_run run = {.study = "bare"};
    struct rl_record *r = rl_run_add(&run, &made_up, 0, NULL, "arm=plan");
    check_ok(rl_bare_add_work(r, gs, &error), &error);
    r->status = RL_RECORD_OK;
    double value = rl_record_metric(r, name)->value;
    rl_run_clear(&run);
    return value;
}

/* What is allocated is told, not what the plan says: one that asked for a stencil buffer and takes it back leaves one behind. */
static void work_is_what_opengl_has(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_bench bench;
    struct rl_scene scene;
    struct rl_bench_scene *set;
    static const char *const names[] = {"lamps", "teapot-star"};
    check_ok(rl_bench_open(&bench, "auto", 0, "", NULL, &error), &error);
    for (int i = 0; i < 2; i++) {
        check_ok(rl_study_scene_load(&scene, names[i], &error), &error);
        check_ok(rl_bench_scene_make(&set, &bench, &scene, "method=random width=64 height=48", 1, &error),
                 &error);
        assert_true(work_of(set->gpu_scene, "stencil") == (double)i);
        assert_true(work_of(set->gpu_scene, "textures") == 2.0 * i); /* normals and the environment */
        struct rl_gpu_scene *gs;
        set->plan.stencil = true;
        check_ok(rl_gpu_scene_make(&gs, bench.gpu, &set->scene, &set->plan, &error), &error);
        set->plan.stencil = false;
        assert_true(work_of(gs, "stencil") == 1.0);
        rl_gpu_scene_free(gs);
        rl_bench_scene_free(set);
        rl_scene_clear(&scene);
    }
    rl_bench_close(&bench);
}

static void other_scenes_are_refused(void **state)
{
    (void)state;
    static const char *const scenes[] = {"teapot-star", "metals", "fur"};
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        struct rl_error error;
        struct rl_scene scene;
        check_ok(rl_study_scene_load(&scene, scenes[i], &error), &error);
        check_fails(rl_bare_fits(&scene, &error), &error, RL_ERR_INPUT,
                    "the bare program is written for one object");
        rl_scene_clear(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdicts_flip),
        cmocka_unit_test(nothing_measured_decides_nothing),
        cmocka_unit_test(measured),
        cmocka_unit_test(work_is_what_opengl_has),
        cmocka_unit_test(other_scenes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
