/* The study `visibility`: its plan, what it measures of scenes whose answer is known, and that its verdicts follow from the rows. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "studies/judged.h"
#include "studies/planner.h"
#include "studies/study.h"
#include "studies/visibility.h"
#include "support/check.h"

static const struct rl_place place = {"visibility", "made-up", "made-up.yaml", 1};

enum { RATIOS = 3, BUFFERS = 4, VIEWS = 4 };

static const double ratios[RATIOS] = {10.0, 1e3, 1e5};
static const struct {
    int bits;
    const char *reversed;
} buffers[BUFFERS] = {{16, "off"}, {24, "off"}, {32, "off"}, {32, "on"}};

/* A made-up world: shares wrong by buffer and ratio. */
struct world {
    double wrong[BUFFERS][RATIOS], ideal[BUFFERS][RATIOS], worst[BUFFERS];
    double spread; /* between views */
    double changed, changed_sure, closed, back_faces;
    double time, noise;
};

static const struct world usual = {
    .wrong = {{0.0, 0.1, 0.4}, {0.0, 0.0, 0.02}, {0.0, 0.0, 0.02}, {0.0, 0.0, 0.0}},
    .ideal = {{0.0, 0.1, 0.4}, {0.0, 0.0, 0.02}, {0.0, 0.0, 0.02}, {0.0, 0.0, 0.0}},
    .worst = {0.9, 0.95, 0.9, 0.0},
    .spread = 1e-5,
    .closed = 1.0,
    .back_faces = 50.0,
    .time = 1.5,
    .noise = 0.02,
};

static void metric(struct rl_record *r, const char *name, double value, double spread)
{
    assert_int_equal(rl_record_metric_add(r, name, value, value - spread, value + spread, "1", NULL), RL_OK);
    r->status = RL_RECORD_OK;
}

/* What the views add to the share is the same for the truth and the picture, and for all buffers, but for a hundredth of it. */
static void add_share(struct rl_record *r, const char *name, double value, double spread)
{
    double view[VIEWS];
    for (int v = 0; v < VIEWS; v++)
        view[v] = value > 0.0 ? value + spread * (v - 1.5) * (name[0] == 'w' ? 1.0 : 0.99) : 0.0;
    metric(r, name, value, value > 0.0 ? 2.0 * spread : 0.0);
    assert_int_equal(rl_record_series_add(r, name, view, VIEWS, NULL), RL_OK);
}

static void add_depth(struct rl_run *run, const struct world *w)
{
    for (int k = 0; k < RATIOS; k++)
        for (int b = 0; b < BUFFERS; b++) {
            struct rl_record *r =
                rl_run_add(run, &place, k, NULL, "series=depth ratio=%g depth_bits=%d reversed_depth=%s",
                           ratios[k], buffers[b].bits, buffers[b].reversed);
            add_share(r, "wrong", w->wrong[b][k], w->spread);
            add_share(r, "ideal", w->ideal[b][k], w->spread);
            metric(r, "worst", k == 1 ? w->worst[b] : 0.0, 0.0);
        }
}

static void add_culling(struct rl_run *run, const struct world *w)
{
    static const char *const methods[] = {"none", "random"};
    for (int m = 0; m < 2; m++) {
        metric(rl_run_add(run, &place, 10 + m, NULL, "series=culling arm=again method=%s depth_bits=24",
                          methods[m]),
               "time_to_on", 1.0, w->noise);
        struct rl_record *r = rl_run_add(run, &place, 10 + m, NULL,
                                         "series=culling arm=off method=%s depth_bits=24", methods[m]);
        metric(r, "time_to_on", w->time, 0.01);
        metric(r, "closed", w->closed, 0.0);
        metric(r, "triangles", 100.0, 0.0);
        metric(r, "back_faces", w->back_faces, 0.0);
        metric(r, "pixels", 1000.0, 0.0);
        metric(r, "sure_pixels", 900.0, 0.0);
        /* Only of one method: the worst counts. */
        metric(r, "changed", m ? w->changed : 0.0, 0.0);
        metric(r, "changed_sure", m ? w->changed_sure : 0.0, 0.0);
    }
}

static struct rl_claim judge(struct world w, const char *words)
{
    struct rl_run run = {.study = "visibility", .grid = "default"};
    add_depth(&run, &w);
    add_culling(&run, &w);
    struct rl_claim found = claim_of("visibility", &run, words);
    rl_run_clear(&run);
    return found;
}

static void test_reach(void **state)
{
    (void)state;
    static const char of_16[] = "16 bits show the right", of_24[] = "24 bits show",
                      of_32[] = "32 bits reversed show";
    struct world w = usual;
    struct rl_claim c = judge(w, of_16);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS_UP_TO);
    assert_true(c.value == 10.0 && c.high == 1e3);
    c = judge(w, of_24);
    assert_true(c.verdict == RL_VERDICT_HOLDS_UP_TO && c.value == 1e3 && c.high == 1e5);
    assert_int_equal(judge(w, of_32).verdict, RL_VERDICT_HOLDS);
    w.wrong[0][0] = 0.05;
    c = judge(w, of_16);
    assert_true(c.verdict == RL_VERDICT_FAILS && c.value == 0.05);
    w.wrong[0][0] = 1e-3; /* the bound itself */
    assert_int_equal(judge(w, of_16).verdict, RL_VERDICT_INCONCLUSIVE);
}

static void test_steps(void **state)
{
    (void)state;
    static const char of_16[] = "a step, z^2/(near 2^16)", of_24[] = "a step, z^2/(near 2^24)",
                      room[] = "4 steps";
    struct world w = usual;
    assert_int_equal(judge(w, of_16).verdict, RL_VERDICT_HOLDS);
    assert_true(judge(w, of_16).value == 0.9);
    assert_int_equal(judge(w, of_24).verdict, RL_VERDICT_HOLDS);
    w.worst[0] = 1.1;
    w.worst[1] = 3.0;
    assert_int_equal(judge(w, of_16).verdict, RL_VERDICT_FAILS);
    assert_int_equal(judge(w, of_24).verdict, RL_VERDICT_FAILS);
    assert_int_equal(judge(w, room).verdict, RL_VERDICT_HOLDS);
    w.worst[1] = 5.0;
    assert_int_equal(judge(w, room).verdict, RL_VERDICT_FAILS);
}

static void test_shares(void **state)
{
    (void)state;
    static const char ideal_16[] = "16 bits as many pixels are wrong as with an ideal",
                      ideal_24[] = "24 bits as many pixels are wrong as with an ideal",
                      real[] = "in the usual order", near[] = "may be as near as one likes";
    struct world w = usual;
    assert_int_equal(judge(w, ideal_16).verdict, RL_VERDICT_HOLDS);
    assert_int_equal(judge(w, ideal_24).verdict, RL_VERDICT_HOLDS);
    assert_int_equal(judge(w, real).verdict, RL_VERDICT_HOLDS);
    assert_int_equal(judge(w, near).verdict, RL_VERDICT_HOLDS);
    /* At one ratio only; the others, which agree, do not make up for it. */
    w.wrong[0][1] = 0.15;
    struct rl_claim c = judge(w, ideal_16);
    assert_int_equal(c.verdict, RL_VERDICT_FAILS);
    assert_true(fabs(c.value - 0.5) < 0.01);
    w.wrong[1][2] = 0.03;
    assert_int_equal(judge(w, ideal_24).verdict, RL_VERDICT_FAILS);
    assert_int_equal(judge(w, real).verdict, RL_VERDICT_FAILS);
    w.wrong[3][2] = 0.01;
    assert_int_equal(judge(w, near).verdict, RL_VERDICT_FAILS);
    /* Nothing wrong, nothing to compare. */
    memset(w.ideal, 0, sizeof w.ideal);
    memset(w.wrong, 0, sizeof w.wrong);
    assert_int_equal(judge(w, ideal_16).verdict, RL_VERDICT_INCONCLUSIVE);
    assert_int_equal(judge(w, real).verdict, RL_VERDICT_INCONCLUSIVE);
    /* But a number still, of all pixels. */
    w.wrong[1][2] = 5e-4;
    w.wrong[2][2] = 8e-4;
    c = judge(w, real);
    assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
    assert_true(fabs(c.value - 3e-4) < 1e-12 && c.low <= c.value && c.value <= c.high);
    assert_string_equal(c.unit, "of the pixels");
    c = judge(w, ideal_24);
    assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
    assert_true(fabs(c.value - 5e-4) < 1e-12);
}

static void test_culling(void **state)
{
    (void)state;
    static const char none[] = "changes no pixel, bit for bit", outline[] = "of closed meshes culling",
                      half[] = "half of the triangles", time[] = "surfaces alone take longer";
    struct world w = usual;
    assert_int_equal(judge(w, none).verdict, RL_VERDICT_HOLDS);
    assert_int_equal(judge(w, outline).verdict, RL_VERDICT_HOLDS);
    assert_int_equal(judge(w, half).verdict, RL_VERDICT_HOLDS);
    assert_int_equal(judge(w, time).verdict, RL_VERDICT_HOLDS);
    w.changed = 2.0;
    struct rl_claim c = judge(w, none);
    assert_true(c.verdict == RL_VERDICT_FAILS && c.value == 2.0);
    assert_int_equal(judge(w, outline).verdict, RL_VERDICT_HOLDS);
    w.changed_sure = 1.0;
    assert_int_equal(judge(w, outline).verdict, RL_VERDICT_FAILS);
    w.back_faces = 30.0;
    assert_int_equal(judge(w, half).verdict, RL_VERDICT_FAILS);
    w.time = 1.01; /* more, but no more than chance */
    assert_int_equal(judge(w, time).verdict, RL_VERDICT_INCONCLUSIVE);
    w.time = 0.9;
    assert_int_equal(judge(w, time).verdict, RL_VERDICT_FAILS);
}

/* Claims about closed meshes are not made of open ones, nor claims about back faces where there is none. */
static void test_left_out(void **state)
{
    (void)state;
    struct world w = usual;
    w.closed = 0.0;
    w.back_faces = 0.0;
    struct rl_run run = {.study = "visibility", .grid = "default"};
    struct rl_claims claims = {0};
    add_depth(&run, &w);
    add_culling(&run, &w);
    judge_run(&claims, "visibility", &run);
    for (size_t i = 0; i < claims.n; i++) {
        assert_null(strstr(claims.claim[i].text, "closed meshes"));
        assert_null(strstr(claims.claim[i].text, "triangles"));
        assert_null(strstr(claims.claim[i].text, "saves time"));
    }
    rl_claims_clear(&claims);
    rl_run_clear(&run);
}

static void test_nothing(void **state)
{
    (void)state;
    struct rl_run run = {.study = "visibility", .grid = "default"};
    add_depth(&run, &usual);
    add_culling(&run, &usual);
    check_undecided("visibility", &run, 14);
    rl_run_clear(&run);
}

static void test_plan(void **state)
{
    (void)state;
    const struct rl_study *study = rl_study_find("visibility");
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "visibility", .grid = "default"};
        int last = -1;
        assert_int_equal(study->plan(&run, &place, (enum rl_grid)grid, 0, NULL), RL_OK);
        for (size_t i = 0; i < run.n_records; i++) {
            const char *p = run.record[i].parameters;
            bool first = run.record[i].group != last;
            last = run.record[i].group;
            assert_true(!first || !rl_parameters_match(p, "series=culling") ||
                        rl_parameters_match(p, "arm=on"));
            /* 16 bits have no stencil, which the pass of a sampled highlight needs. */
            assert_false(rl_parameters_match(p, "depth_bits=16 method=random"));
        }
        rl_run_clear(&run);
    }
}

static double value(const struct rl_record *r, const char *name)
{
    const struct rl_metric *m = rl_record_metric(r, name);
    assert_non_null(m);
    return m->value;
}

/* Cards that cross, with 16 bits and a near plane too near: as many pixels are wrong as an ideal depth buffer gets wrong, to a step; reversed float
 * has hardly any. Balls without close surfaces have none with any. */
static void test_depth(void **state)
{
    (void)state;
    static const struct {
        const char *scene;
        double ratio;
    } row[] = {{"layers", 1e3}, {"three-lights", 10.0}};
    struct rl_error error = {0};
    struct rl_bench bench;
    check_ok(rl_bench_open(&bench, "auto", 1, "", NULL, &error), &error);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_scene scene;
        struct rl_run run = {.study = "visibility", .grid = "default"};
        check_ok(rl_study_scene_load(&scene, row[i].scene, &error), &error);
        for (int b = 0; b < BUFFERS; b++)
            rl_run_add(&run, &place, 0, NULL,
                       "series=depth ratio=%g depth_bits=%d reversed_depth=%s method=none views=2 width=64 "
                       "height=48 "
                       "map=%s",
                       row[i].ratio, buffers[b].bits, buffers[b].reversed, b ? "off" : "on");
        check_ok(rl_visibility_measure(run.record, run.n_records, &bench, &scene, &error), &error);
        const struct rl_record *r = run.record;
        const struct rl_series *map = rl_record_series(&r[0], "map");
        size_t wrong = 0;
        assert_non_null(map);
        assert_int_equal(map->n, 2 + 64 * 48 / RL_VISIBILITY_PACKED);
        assert_true(map->value[0] == 64.0 && map->value[1] == 48.0);
        for (size_t k = 0; k < (size_t)64 * 48; k++) {
            uint64_t packed = (uint64_t)map->value[2 + k / RL_VISIBILITY_PACKED];
            wrong += (packed >> 2 * (k % RL_VISIBILITY_PACKED) & 3) == 2;
        }
        assert_true(value(&r[0], "sure") > 0.5);
        assert_true(i == 0 ? wrong > 100 : wrong == 0);
        for (int b = 0; b < BUFFERS; b++) {
            assert_true(i == 0 || value(&r[b], "wrong") == 0.0);
            assert_true(value(&r[b], "worst") < 5.0);
        }
        check_near(value(&r[0], "wrong"), value(&r[0], "ideal"), 0.01);
        assert_true(i == 1 || value(&r[0], "worst") > 0.5);
        assert_true(value(&r[3], "wrong") <= 0.1 * value(&r[0], "wrong"));
        rl_run_clear(&run);
        rl_scene_clear(&scene);
    }
    rl_bench_close(&bench);
}

/* Of cards half of which would be seen from behind, were they not all turned this way; and of a pot without a bottom. */
static void test_back_faces(void **state)
{
    (void)state;
    static const char *const scenes[] = {"layers", "three-lights", "lamps"};
    struct rl_error error = {0};
    struct rl_bench bench;
    check_ok(rl_bench_open(&bench, "auto", 1, "", NULL, &error), &error);
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        struct rl_scene scene;
        struct rl_run run = {.study = "visibility", .grid = "default"};
        check_ok(rl_study_scene_load(&scene, scenes[i], &error), &error);
        static const char *const arms[] = {"on", "again", "off"};
        for (int a = 0; a < 3; a++)
            rl_run_add(
                &run, &place, 0, NULL,
                "series=culling arm=%s culling=%s method=none samples=4 depth_bits=24 views=1 rounds=0 "
                "width=96 height=72",
                arms[a], a < 2 ? "on" : "off");
        check_ok(rl_visibility_measure(run.record, run.n_records, &bench, &scene, &error), &error);
        const struct rl_record *r = run.record;
        assert_true(value(&r[1], "changed") == 0.0);
        assert_true(value(&r[2], "closed") == (i == 1));
        assert_true(i == 2 ? value(&r[2], "changed") > 0.0 : value(&r[2], "changed_sure") == 0.0);
        assert_true((value(&r[2], "back_faces") > 0.0) == (i > 0));
        assert_true(value(&r[2], "pixels") > 500.0);
        assert_null(rl_record_metric(&r[2], "frame_ms"));
        rl_run_clear(&run);
        rl_scene_clear(&scene);
    }
    rl_bench_close(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reach),   cmocka_unit_test(test_steps),    cmocka_unit_test(test_shares),
        cmocka_unit_test(test_culling), cmocka_unit_test(test_left_out), cmocka_unit_test(test_nothing),
        cmocka_unit_test(test_plan),    cmocka_unit_test(test_depth),    cmocka_unit_test(test_back_faces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
