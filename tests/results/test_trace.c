/* A claim's cases are those whose figures were read for it, and those read for its scene before any claim. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "results/trace.h"

enum { SCENES = 2, CASES = 4 };

/* Four measured cases n=0..3 of each of two scenes, with one metric and one series. */
static void fill(struct rl_run *run)
{
    static const char *const scene[SCENES] = {"one", "two"};
    for (int s = 0; s < SCENES; s++)
        for (int i = 0; i < CASES; i++) {
            const struct rl_place place = {"samples", scene[s], scene[s], (uint64_t)s};
            struct rl_record *r = rl_run_add(run, &place, 0, NULL, "n=%d", i);
            assert_non_null(r);
            r->status = RL_RECORD_OK;
            assert_int_equal(rl_record_metric_add(r, "rmse", i, i, i, "1", NULL), RL_OK);
            assert_int_equal(rl_record_series_add(r, "ms", &(double){1.0}, 1, NULL), RL_OK);
        }
    rl_run_identify(run, "here");
}

static void begin(struct rl_claims *claims, const char *scene)
{
    struct rl_claim *c = rl_claims_add(claims, NULL);
    assert_non_null(c);
    snprintf(c->scene, sizeof c->scene, "%s", scene);
}

static const struct rl_record *look(const struct rl_run *run, const char *scene, const char *pattern)
{
    const struct rl_record *r = rl_run_find(run, scene, pattern);
    assert_non_null(r);
    return r;
}

/* The digits of the cases' n in the order of the run. */
static void check_cases(const struct rl_run *run, const struct rl_claim *c, const char *expected)
{
    char found[RL_NAME_MAX] = "";
    for (size_t k = 0; k < c->n_cases; k++)
        for (size_t i = 0; i < run->n_records; i++)
            if (strcmp(run->record[i].identity, c->identity[k]) == 0) {
                assert_string_equal(run->record[i].scene, c->scene);
                strncat(found, run->record[i].parameters + 2, 1);
            }
    assert_string_equal(found, expected);
}

static void test_cases(void **state)
{
    (void)state;
    struct rl_run run = {.study = "samples"};
    struct rl_claims claims = {0};
    fill(&run);
    assert_int_equal(rl_trace_begin(&claims, &run, NULL), RL_OK);
    rl_record_metric(look(&run, "one", "n=3"),
                     "rmse"); /* before the scene's first claim: of all its claims */
    begin(&claims, "one");
    rl_record_metric(look(&run, "one", "n=0"), "rmse");
    rl_record_series(look(&run, "one", "n=1"), "ms");
    rl_record_series(look(&run, "one", "n=1"), "ms");
    begin(&claims, "one");
    look(&run, "one", "n=1"); /* nothing is read */
    rl_record_metric(look(&run, "one", "n=2"), "no such metric");
    begin(&claims, "one");
    rl_record_series(look(&run, "two", "n=2"), "ms"); /* the next scene's */
    begin(&claims, "two");
    rl_record_metric(look(&run, "two", "n=0"), "rmse");
    begin(&claims, "two");
    assert_int_equal(rl_trace_end(&claims, NULL), RL_OK);
    rl_record_metric(look(&run, "two", "n=1"), "rmse"); /* too late */

    static const char *const expected[] = {"013", "23", "3", "02", "2"};
    assert_int_equal(claims.n, sizeof expected / sizeof expected[0]);
    for (size_t i = 0; i < claims.n; i++)
        check_cases(&run, &claims.claim[i], expected[i]);
    rl_claims_clear(&claims);
    rl_run_clear(&run);
}

/* The sizes and seeds of a claim's own cases, each once, in their order; those of no picture have none. */
static void test_extent(void **state)
{
    (void)state;
    static const char *const parameters[] = {"width=96 height=72 seeds=16", "width=196 height=72 seeds=1",
                                             "width=96 height=72 seeds=6", "loss=0.1",
                                             "width=96 height=72 timed_width=640 timed_height=480 seeds=16"};
    enum { N = sizeof parameters / sizeof parameters[0] };
    struct rl_run run = {.study = "samples"};
    struct rl_claims claims = {0};
    const struct rl_place place = {"samples", "one", "one", 1};
    for (size_t i = 0; i < N; i++) {
        struct rl_record *r = rl_run_add(&run, &place, 0, NULL, "%s", parameters[i]);
        assert_int_equal(rl_record_metric_add(r, "rmse", 1.0, 1.0, 1.0, "1", NULL), RL_OK);
        r->status = RL_RECORD_OK;
    }
    rl_run_identify(&run, "here");
    assert_int_equal(rl_trace_begin(&claims, &run, NULL), RL_OK);
    begin(&claims, "one");
    rl_record_metric(&run.record[3], "rmse");
    begin(&claims, "one");
    rl_record_metric(&run.record[0], "rmse");
    begin(&claims, "one");
    for (size_t i = 0; i < N; i++)
        rl_record_metric(&run.record[i], "rmse");
    assert_int_equal(rl_trace_end(&claims, NULL), RL_OK);
    assert_string_equal(claims.claim[0].size_px, "");
    assert_string_equal(claims.claim[0].seeds, "");
    assert_string_equal(claims.claim[1].size_px, "96x72");
    assert_string_equal(claims.claim[1].seeds, "16");
    assert_string_equal(claims.claim[2].size_px, "96x72, 196x72, timed 640x480");
    assert_string_equal(claims.claim[2].seeds, "16, 1, 6");
    rl_claims_clear(&claims);
    rl_run_clear(&run);
}

/* The claims of a run traced before keep their cases, and get none of the next run's. */
static void test_runs(void **state)
{
    (void)state;
    struct rl_run run[2] = {{.study = "a"}, {.study = "b"}};
    struct rl_claims claims = {0};
    for (int i = 0; i < 2; i++) {
        fill(&run[i]);
        assert_int_equal(rl_trace_begin(&claims, &run[i], NULL), RL_OK);
        rl_record_metric(look(&run[i], "one", i ? "n=2" : "n=1"), "rmse");
        begin(&claims, "one");
        assert_int_equal(rl_trace_end(&claims, NULL), RL_OK);
    }
    check_cases(&run[0], &claims.claim[0], "1");
    check_cases(&run[1], &claims.claim[1], "2");
    rl_claims_clear(&claims);
    for (int i = 0; i < 2; i++)
        rl_run_clear(&run[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_cases), cmocka_unit_test(test_extent),
                                       cmocka_unit_test(test_runs)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
