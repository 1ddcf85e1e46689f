/* The study `fps`: its cases and scenes; its verdicts on Table 1 follow from the raw frame times, paired by round; what chance explains
 * decides nothing. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "model/random.h"
#include "scene/plan.h"
#include "studies/fps.h"
#include "studies/judged.h"
#include "studies/planner.h"
#include "support/check.h"

enum { ROUNDS = 60 };

static const struct rl_place place = {"fps", "made-up", "made-up.yaml", 1};

/* Milliseconds of each arm; `jitter`: relative spread of single frames; `wave`: how much the machine slows down in the middle of the run,
 * for all arms alike. */
struct world {
    double none, plain, regular, random, again, environment, jitter, wave;
};

static const struct world usual = {2.0, 2.5, 18.0, 9.0, 9.0, 3.0, 0.01, 0.0};

static void add_arm(struct rl_run *run, const char *arm, double ms, int index, const struct world *w)
{
    double value[ROUNDS];
    for (int i = 0; i < ROUNDS; i++) {
        double chance = 2.0 * rl_random_uniform(11, (uint64_t)index * 1000 + (uint64_t)i) - 1.0;
        value[i] = ms * (1.0 + w->jitter * chance) * (1.0 + (i > 20 && i < 40 ? w->wave : 0.0));
    }
    struct rl_record *r = rl_run_add(run, &place, 0, NULL, "arm=%s series=table1 method=x samples=4", arm);
    assert_int_equal(rl_record_series_add(r, "frame_ms", value, ROUNDS, NULL), RL_OK);
    r->status = RL_RECORD_OK;
}

static struct rl_claim judge(struct world w, const char *words)
{
    struct rl_run run = {.study = "fps", .grid = "quick"};
    snprintf(run.provenance.renderer, sizeof run.provenance.renderer, "a made-up renderer");
    const struct {
        const char *arm;
        double ms;
    } arm[] = {{"none", w.none},       {"plain", w.plain},          {"regular-13", w.regular},
               {"random-4", w.random}, {"random-4-again", w.again}, {"environment", w.environment}};
    for (int i = 0; i < 6; i++)
        if (arm[i].ms > 0.0)
            add_arm(&run, arm[i].arm, arm[i].ms, i, &w);
    struct rl_claim found = claim_of("fps", &run, words);
    rl_run_clear(&run);
    return found;
}

static void test_flips(void **state)
{
    (void)state;
    static const char faster[] = "paper: 4 random normals are faster than 13 regular";
    struct world w = usual;
    struct rl_claim c = judge(w, faster);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_true(fabs(c.value - 2.0) < 0.02 && c.low <= c.value && c.value <= c.high);
    assert_string_equal(c.command, "roughlight study run fps --scene made-up.yaml --quick");
    w.regular = 8.0;
    assert_int_equal(judge(w, faster).verdict, RL_VERDICT_FAILS);
    w.regular = 9.3; /* faster by 3 %, but two equal arms differ by 10 % */
    w.again = 9.9;
    assert_int_equal(judge(w, faster).verdict, RL_VERDICT_INCONCLUSIVE);

    static const char plain[] = "the light's shape costs a factor of 530/38";
    w = usual;
    assert_int_equal(judge(w, plain).verdict, RL_VERDICT_FAILS);
    w.plain = w.random / 13.9;
    assert_int_equal(judge(w, plain).verdict, RL_VERDICT_HOLDS);
    w.again = 1.3 * w.random; /* equal arms differ by more than the margin of a quarter */
    assert_int_equal(judge(w, plain).verdict, RL_VERDICT_INCONCLUSIVE);
    w.plain = w.random / 11.0; /* too fast by a fifth, and three tenths are chance */
    assert_int_equal(judge(w, plain).verdict, RL_VERDICT_INCONCLUSIVE);
    w.plain = w.random / 5.0;
    assert_int_equal(judge(w, plain).verdict, RL_VERDICT_FAILS);

    static const char real_time[] = "random 4 reaches 24 frames/s";
    w = usual;
    c = judge(w, real_time);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_true(fabs(c.value - 1000.0 / 9.0) < 1.0);
    assert_non_null(strstr(c.note, "a made-up renderer"));
    w.random = 50.0;
    assert_int_equal(judge(w, real_time).verdict, RL_VERDICT_FAILS);
    w.regular = 50.0;
    assert_int_equal(judge(w, "regular 13 reaches 24 frames/s").verdict, RL_VERDICT_FAILS);

    static const char fair[] = "ours: the clock is fair";
    w = usual;
    assert_int_equal(judge(w, fair).verdict, RL_VERDICT_HOLDS);
    w.again = 9.5;
    assert_int_equal(judge(w, fair).verdict, RL_VERDICT_FAILS);

    static const char environment[] = "ours: drawing the environment map anew";
    w = usual;
    assert_int_equal(judge(w, environment).verdict, RL_VERDICT_HOLDS);
    w.environment = 20.0;
    assert_int_equal(judge(w, environment).verdict, RL_VERDICT_FAILS);
    w.again = 9.9; /* equal arms differ by a tenth: less than that is no difference, in either direction */
    w.environment = 8.5;
    assert_int_equal(judge(w, environment).verdict, RL_VERDICT_INCONCLUSIVE);
    w.environment = 9.5;
    assert_int_equal(judge(w, environment).verdict, RL_VERDICT_INCONCLUSIVE);
}

/* A machine that is three times as slow for a third of the run: ratios within a round do not notice. */
static void test_paired(void **state)
{
    (void)state;
    struct world w = usual;
    w.wave = 2.0;
    struct rl_claim c = judge(w, "paper: 4 random normals are faster than 13 regular");
    assert_true(fabs(c.value - 2.0) < 0.02 && c.high - c.low < 0.05);
}

static void test_missing(void **state)
{
    (void)state;
    struct world w = usual;
    w.random = 0.0;
    assert_int_equal(judge(w, "faster than 13 regular").verdict, RL_VERDICT_INCONCLUSIVE);
    assert_int_equal(judge(w, "random 4 reaches").verdict, RL_VERDICT_INCONCLUSIVE);
    w = usual;
    w.again = 0.0; /* without a noise floor no difference can be told from chance */
    assert_int_equal(judge(w, "faster than 13 regular").verdict, RL_VERDICT_INCONCLUSIVE);
    assert_int_equal(judge(w, "the clock is fair").verdict, RL_VERDICT_INCONCLUSIVE);
    assert_int_equal(judge(w, "the light's shape costs a factor").verdict, RL_VERDICT_INCONCLUSIVE);
    assert_int_equal(judge(w, "drawing the environment map anew").verdict, RL_VERDICT_INCONCLUSIVE);
}

static int count(const struct rl_run *run, const char *pattern)
{
    int n = 0;
    for (size_t i = 0; i < run->n_records; i++)
        n += rl_parameters_match(run->record[i].parameters, pattern);
    return n;
}

/* Table 1 on every scene, the other series on the first one or with the full grid; no case twice, a group each series. */
static void test_plan(void **state)
{
    (void)state;
    static const struct {
        enum rl_grid grid;
        int first_group, cases, groups;
    } row[] = {{RL_GRID_QUICK, 0, 59, 7},
               {RL_GRID_QUICK, 7, 6, 1},
               {RL_GRID_DEFAULT, 0, 60, 7},
               {RL_GRID_DEFAULT, 7, 6, 1},
               {RL_GRID_FULL, 7, 119, 7}};
    static const char *const series[] = {"series=table1",    "series=size",      "series=environment",
                                         "series=objects",   "series=roughness", "series=maps",
                                         "series=exhaustive"};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_run run = {.study = "fps"};
        assert_int_equal(rl_study_find("fps")->plan(&run, &place, row[i].grid, row[i].first_group, NULL),
                         RL_OK);
        if ((int)run.n_records != row[i].cases)
            fail_msg("row %zu: %zu cases, expected %d", i, run.n_records, row[i].cases);
        assert_int_equal(run.record[0].group, row[i].first_group);
        assert_int_equal(run.record[run.n_records - 1].group, row[i].first_group + row[i].groups - 1);
        assert_int_equal(count(&run, "series=table1"), 6);
        for (int k = 0; k < 7; k++)
            assert_int_equal(count(&run, series[k]) > 0, k < row[i].groups);
        for (size_t k = 0; k < run.n_records; k++) {
            if (count(&run, run.record[k].parameters) != 1)
                fail_msg("twice: %s", run.record[k].parameters);
            struct rl_settings settings;
            assert_int_equal(rl_bench_settings(&settings, run.record[k].parameters, NULL), RL_OK);
            /* Medians of 30 frames or more, but where one takes as long as many frames. */
            bool slow = rl_parameters_match(run.record[k].parameters, "series=maps") ||
                        rl_parameters_match(run.record[k].parameters, "series=exhaustive");
            double rounds = rl_parameter_number(run.record[k].parameters, "rounds");
            double least = row[i].grid == RL_GRID_QUICK             ? 5.0
                           : slow && row[i].grid == RL_GRID_DEFAULT ? 12.0
                                                                    : 30.0;
            if (rounds < least)
                fail_msg("%g rounds: %s", rounds, run.record[k].parameters);
        }
        rl_run_clear(&run);
    }
}

/* Objects in place of one: an environment map each, a normal map each roughness, the programs shared; their pixels about as many. */
static void test_scenes(void **state)
{
    (void)state;
    static const struct {
        int objects, roughnesses;
    } row[] = {{1, 1}, {2, 1}, {10, 1}, {4, 4}, {4, 3}};
    struct rl_scene scene;
    struct rl_error error = {0};
    check_ok(rl_study_scene_load(&scene, "teapot-star", &error), &error);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_scene copy;
        struct rl_plan plan;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        check_ok(rl_fps_scene_make(&copy, &scene, row[i].objects, row[i].roughnesses, &error), &error);
        check_ok(rl_plan_make(&plan, &copy, &settings, &error), &error);
        assert_int_equal(plan.n_environments, row[i].objects);
        assert_int_equal(plan.n_normal_maps, row[i].roughnesses);
        assert_int_equal(plan.n_programs, 3); /* environment, surface, highlight */
        double squares = 0.0;
        for (size_t k = 0; k < copy.n_objects; k++) {
            const struct rl_object *o = &copy.object[k];
            rl_vec3 low, high, centre;
            double radius;
            rl_mesh_bounds(&o->mesh, &low, &high, &centre, &radius);
            check_near(v3_length(v3_sub(centre, o->centre)), 0.0, 1e-5);
            check_near(radius, o->radius, 1e-5);
            squares += o->radius * o->radius;
            for (size_t l = 0; l < k; l++) /* side by side, as seen by the camera */
                assert_true(v3_length(v3_sub(o->centre, copy.object[l].centre)) >= 1.999 * o->radius);
        }
        check_relative(squares, scene.object[0].radius * scene.object[0].radius, 1e-12);
        rl_plan_clear(&plan);
        rl_fps_scene_free(&copy);
    }
    rl_scene_clear(&scene);

    check_ok(rl_fps_check("series=size width=640", &error), &error);
    check_ok(rl_fps_check("objects=10 roughnesses=1", &error), &error);
    check_fails(rl_fps_check("objects=0", &error), &error, RL_ERR_INPUT,
                "objects=0: expected a whole number");
    check_fails(rl_fps_check("roughnesses=2.5", &error), &error, RL_ERR_INPUT, "roughnesses=2.5");
    check_fails(rl_fps_check("objects=1001", &error), &error, RL_ERR_INPUT, "1 to 1000");
}

static void test_undecided(void **state)
{
    (void)state;
    struct rl_run run = {.study = "fps", .grid = "default"};
    assert_int_equal(rl_study_find("fps")->plan(&run, &place, RL_GRID_DEFAULT, 0, NULL), RL_OK);
    check_undecided("fps", &run, 25);
    rl_run_clear(&run);
}

/* Maps are made anew each time, not found again among what the context keeps: no machine draws a normal in a tenth of a nanosecond. */
static void test_maps_are_made(void **state)
{
    (void)state;
    enum { SIZE = 128 };
    struct rl_scene scene;
    struct rl_bench bench;
    struct rl_error error = {0};
    struct rl_progress quiet = {0};
    struct rl_run run = {.study = "fps"};
    check_ok(rl_study_scene_load(&scene, "sphere-quad", &error), &error);
    for (int roughnesses = 1; roughnesses <= 2; roughnesses++)
        assert_non_null(rl_run_add(&run, &place, 0, NULL,
                                   "arm=normal-maps series=maps method=random samples=4 width=32 height=24 "
                                   "rounds=3 seconds=1 roughnesses=%d normal_size=%d",
                                   roughnesses, SIZE));
    check_ok(rl_bench_open(&bench, "osmesa", 2, ".", &quiet, &error), &error);
    check_ok(rl_fps_measure(run.record, run.n_records, &bench, &scene, &error), &error);
    for (size_t i = 0; i < run.n_records; i++) {
        const struct rl_metric *ms = rl_record_metric(&run.record[i], "frame_ms");
        double least_ms = 1e-10 * 1e3 * SIZE * SIZE * (double)(i + 1);
        assert_non_null(ms);
        if (!(ms->low > least_ms))
            fail_msg("%zu maps of %d x %d texels in %g ms", i + 1, SIZE, SIZE, ms->low);
    }
    rl_bench_close(&bench);
    rl_run_clear(&run);
    rl_scene_clear(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_flips),         cmocka_unit_test(test_paired), cmocka_unit_test(test_missing),
        cmocka_unit_test(test_plan),          cmocka_unit_test(test_scenes), cmocka_unit_test(test_undecided),
        cmocka_unit_test(test_maps_are_made),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
