/* The study `hard`: verdicts follow from figures of a made-up run; both backends are planned for what both have. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "studies/judged.h"
#include "studies/study.h"
#include "support/check.h"

static const struct rl_place alone = {"hard", RL_NO_SCENE, "", 0};

static void metric(struct rl_record *r, const char *name, double value)
{
    assert_int_equal(rl_record_add_exact(r, name, value, "1", NULL), RL_OK);
    r->status = RL_RECORD_OK;
}

/* Two functions with 10 rows each and one map, on both backends; in C they have these shares of their bounds. */
static void make(struct rl_run *run, double rows, double map)
{
    static const char *const backend[] = {"cpu", "gpu"};
    *run = (struct rl_run){.study = "hard", .grid = "default"};
    for (int b = 0; b < 2; b++) {
        for (int f = 0; f < 2; f++) {
            double share = b == 0 && f == 1 ? rows : 0.25;
            struct rl_record *r =
                rl_run_add(run, &alone, f, NULL, "series=rows function=%s backend=%s data=1",
                           f ? "phong" : "frame", backend[b]);
            metric(r, "rows", 10.0);
            metric(r, "failed", share <= 1.0 ? 0.0 : 3.0);
            metric(r, "worst_share", share);
            metric(r, "line", 7.0 + f);
        }
        struct rl_record *r =
            rl_run_add(run, &alone, 2, NULL,
                       "series=map map=frame-printed function=frame-printed backend=%s data=2", backend[b]);
        metric(r, "points", 100.0);
        metric(r, "worst_ulp", 2.0);
        metric(r, "median_ulp", 0.5);
        metric(r, "beyond_points", b == 0 && map > 1.0 ? 4.0 : 0.0);
        metric(r, "conditioned_points", 1.0);
        metric(r, "worst_share", b == 0 ? map : 0.125);
    }
}

static void check(double rows, double map, const char *words, enum rl_verdict expected, double value,
                  const char *note)
{
    struct rl_run run;
    make(&run, rows, map);
    struct rl_claim c = claim_of("hard", &run, words);
    check_verdict(&c, expected, words, rows);
    check_near(c.value, value, 0.0);
    check_near(c.high - c.low, 0.0, 0.0);
    if (!strstr(c.note, note))
        fail_msg("'%s' has the note '%s', expected '%s'", words, c.note, note);
    rl_run_clear(&run);
}

static void test_verdicts(void **state)
{
    (void)state;
    static const char in_c[] = "in C every row", in_glsl[] = "in GLSL every row";
    check(0.9, 0.5, in_c, RL_VERDICT_HOLDS, 0.9,
          "0 of 20 rows of 2 functions fail; the worst row is line 8 of phong.tsv");
    check(1.1, 0.5, in_c, RL_VERDICT_FAILS, 1.1, "3 of 20 rows");
    check(1.1, 1.5, in_glsl, RL_VERDICT_HOLDS, 0.25, "line 7 of frame.tsv");
    check(0.9, 0.5, "frame-printed in C", RL_VERDICT_HOLDS, 0.5,
          "100 points: worst 2 ulp, median 0.5 ulp; 0 beyond");
    check(0.9, 1.5, "frame-printed in C", RL_VERDICT_FAILS, 1.5, "4 beyond the bound, 1 above the plain one");
    check(0.9, 1.5, "frame-printed in GLSL", RL_VERDICT_HOLDS, 0.125, "");
}

/* Every function of the catalogue and every map, each once a backend; a map's claim has its figure. */
static void test_plan(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_run run = {.study = "hard", .grid = "default"};
    const struct rl_study *study = rl_study_find("hard");
    check_ok(study->plan_alone(&run, &alone, RL_GRID_DEFAULT, 0, &error), &error);
    size_t rows = 0, maps = 0, glsl = 0;
    for (size_t i = 0; i < run.n_records; i++) {
        const char *p = run.record[i].parameters;
        char map[RL_NAME_MAX];
        rows += rl_parameters_match(p, "series=rows backend=cpu");
        glsl += rl_parameters_match(p, "series=rows backend=gpu");
        if (!rl_parameters_match(p, "series=map"))
            continue;
        maps++;
        bool drawn = false;
        assert_true(rl_parameter(p, "map", map, sizeof map));
        for (size_t k = 0; k < study->n_figures_alone; k++)
            drawn = drawn || strcmp(study->figures_alone[k].name, map) == 0;
        if (!drawn)
            fail_msg("no figure of the map %s", map);
    }
    assert_true(rows >= 28);
    assert_true(glsl >= 26);
    assert_int_equal(maps, 2 * (study->n_figures_alone - 1));
    rl_run_clear(&run);
}

static void test_nothing_measured(void **state)
{
    (void)state;
    struct rl_run run = {.study = "hard", .grid = "default"};
    struct rl_claim c = claim_of("hard", &run, "in C every row");
    check_verdict(&c, RL_VERDICT_INCONCLUSIVE, c.text, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_verdicts),
        cmocka_unit_test(test_plan),
        cmocka_unit_test(test_nothing_measured),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
