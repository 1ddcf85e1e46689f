/* The time left: from what was measured before, from what is measured meanwhile, and whatever order it comes in. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "studies/eta.h"

/* Four cases of a study, one a group: samples 1, 4, 16 at 10 x 10 pixels, and 16 at 20 x 20. */
static void plan(struct rl_run *run, const char *study)
{
    static const struct {
        int samples, size;
    } row[] = {{1, 10}, {4, 10}, {16, 10}, {16, 20}};
    const struct rl_place place = {study, "one", "one", 1};
    *run = (struct rl_run){0};
    for (int i = 0; i < 4; i++)
        assert_non_null(rl_run_add(run, &place, i, NULL, "samples=%d width=%d height=%d", row[i].samples,
                                   row[i].size, row[i].size));
}

static void add_all(struct rl_eta *eta, const struct rl_run *run, const struct rl_run *times)
{
    for (size_t i = 0; i < run->n_records; i++)
        assert_int_equal(rl_eta_add(eta, run, i, times, NULL), RL_OK);
}

static void measured(struct rl_eta *eta, struct rl_run *run, size_t i, double seconds)
{
    run->record[i].seconds = seconds;
    rl_eta_measured(eta, &run->record[i]);
}

static void test_nothing_known(void **state)
{
    (void)state;
    struct rl_run run;
    struct rl_eta eta = {0};
    plan(&run, "a");
    assert_true(fabs(rl_eta_seconds(&eta) - (0.0)) <= 0.0);
    add_all(&eta, &run, NULL);
    assert_true(isnan(rl_eta_seconds(&eta)));
    assert_int_equal(eta.total, 4);
    /* The first one speaks for all, in proportion to the pixels: 2 + 2 + 4 * 2. */
    measured(&eta, &run, 0, 2.0);
    assert_true(fabs(rl_eta_seconds(&eta) - (12.0)) <= 1e-9);
    assert_int_equal(eta.done, 1);
    /* samples=16 differs from samples=4 in one value, as it does from samples=1, but that is newer: 5 + 4 * 5. */
    measured(&eta, &run, 1, 5.0);
    assert_true(fabs(rl_eta_seconds(&eta) - (25.0)) <= 1e-9);
    measured(&eta, &run, 1, 5.0); /* once is enough */
    measured(&eta, &run, 3, 80.0);
    assert_true(fabs(rl_eta_seconds(&eta) - (5.0)) <= 1e-9); /* one value is less than two, though newer */
    measured(&eta, &run, 2, 18.0);
    assert_true(fabs(rl_eta_seconds(&eta) - (0.0)) <= 0.0);
    assert_int_equal(eta.done, eta.total);
    rl_eta_clear(&eta);
    rl_run_clear(&run);
}

static void test_from_before(void **state)
{
    (void)state;
    struct rl_run run, times;
    struct rl_eta eta = {0};
    plan(&run, "a");
    plan(&times, "a");
    for (size_t i = 0; i < 4; i++)
        times.record[i].seconds = (double[]){1.0, 3.0, 9.0, 40.0}[i];
    add_all(&eta, &run, &times);
    assert_true(fabs(rl_eta_seconds(&eta) - (53.0)) <= 1e-9);
    measured(&eta, &run, 0, 100.0); /* the same case, from before, is more like it than another from now */
    assert_true(fabs(rl_eta_seconds(&eta) - (52.0)) <= 1e-9);
    rl_eta_dropped(&eta, &run.record[3]);
    assert_int_equal(eta.total, 3);
    assert_true(fabs(rl_eta_seconds(&eta) - (12.0)) <= 1e-9);
    rl_eta_clear(&eta);
    rl_run_clear(&run);
    rl_run_clear(&times);
}

/* A study of which nothing is known is taken for the mean of the others, until something is. */
static void test_two_studies(void **state)
{
    (void)state;
    struct rl_run run[2];
    struct rl_eta eta = {0};
    plan(&run[0], "a");
    plan(&run[1], "b");
    for (size_t i = 0; i < 2; i++)
        assert_int_equal(rl_eta_add(&eta, &run[0], i, NULL, NULL), RL_OK);
    for (size_t i = 0; i < 3; i++)
        assert_int_equal(rl_eta_add(&eta, &run[1], i, NULL, NULL), RL_OK);
    measured(&eta, &run[0], 0, 4.0);
    assert_true(fabs(rl_eta_seconds(&eta) - (4.0 + 3 * 4.0)) <= 1e-9);
    measured(&eta, &run[1], 0, 10.0);
    assert_true(fabs(rl_eta_seconds(&eta) - (4.0 + 2 * 10.0)) <= 1e-9);
    rl_eta_clear(&eta);
    rl_run_clear(&run[0]);
    rl_run_clear(&run[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nothing_known),
        cmocka_unit_test(test_from_before),
        cmocka_unit_test(test_two_studies),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
