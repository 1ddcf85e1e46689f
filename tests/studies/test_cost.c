/* First estimates: what there is to do, added up as by hand; every group of every study has one; what is measured takes its place. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "results/database.h"
#include "studies/eta.h"
#include "studies/forecast.h"
#include "studies/study.h"
#include "support/check.h"
#include "support/temporary.h"

static const struct rl_place place = {"a study", "one", "one", 1};

static void test_sum(void **state)
{
    (void)state;
    static const struct rl_cost costs[] = {
        {.pattern = "series=map", .group = 10.0, .texel = 1e6},
        {.pattern = "",
         .group = 0.5,
         .picture = 1.0,
         .pixel = 1e6,
         .sample = 2e6,
         .texel = 3e6,
         .second = 7.0},
    };
    static const struct {
        const char *parameters;
        double seconds;
    } row[] = {
        {"arm=base", 0.5 + 1.0 + 1.0 + 2.0}, /* one picture of one pixel, one sample */
        {"arm=base width=4 height=3 samples=5", 0.5 + 1.0 + 12.0 + 2.0 * 12.0 * 5.0},
        {"arm=base width=4 height=3 samples=0", 0.5 + 1.0 + 12.0 + 2.0 * 12.0},
        {"size=3 seeds=2", 0.5 + 2.0 + 18.0 + 36.0},
        {"points=7 samples=2", 0.5 + 1.0 + 7.0 + 28.0},
        {"width=2 height=1 seeds=3 views=2 rounds=4", 0.5 + 10.0 + 20.0 + 40.0},
        {"width=2 height=1 frames=4 timed_width=3 timed_height=3", 0.5 + 5.0 + 38.0 + 76.0},
        {"normal_size=3 normal_bits=float seeds=2", 0.5 + 2.0 + 2.0 + 4.0 + 3.0 * 18.0},
        {"seconds=0.5", 0.5 + 1.0 + 1.0 + 2.0 + 3.5},
        {"series=map normal_size=4 seconds=9", 10.0 + 16.0},
    };
    struct rl_run run = {0};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        const struct rl_record *r = rl_run_add(&run, &place, (int)i, NULL, "%s", row[i].parameters);
        check_relative(rl_cost_seconds(costs, 2, r, 1), row[i].seconds, 1e-12);
    }
    /* A group costs the sum of its cases, by the kind of the first. */
    check_relative(rl_cost_seconds(costs, 2, run.record, 2), row[0].seconds + row[1].seconds - 0.5, 1e-12);
    assert_true(isnan(rl_cost_seconds(costs, 1, run.record, 1)));
    assert_true(isnan(rl_cost_seconds(NULL, 0, run.record, 1)));
    rl_run_clear(&run);
}

static void make(struct rl_forecast *f, const struct rl_study *study, enum rl_grid grid, const char *database)
{
    struct rl_error error = {0};
    const struct rl_provenance nobody = {.version = "1"};
    const struct rl_run_options options = {.grid = grid, .database = database};
    check_ok(rl_forecast_make(f, study, &options, &nobody, &error), &error);
}

static void test_every_study(void **state)
{
    (void)state;
    for (size_t i = 0; i < rl_n_studies; i++) {
        double before = 0.0;
        for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
            struct rl_forecast f;
            make(&f, rl_studies[i], (enum rl_grid)grid, "/nowhere/results.db");
            bool good = f.groups_open > 0 && f.groups_unknown == 0 && f.groups_first == f.groups_open &&
                        f.seconds == f.seconds_first && f.seconds >= before;
            for (size_t k = 0; k < f.planned->run.n_records; k++)
                good = good && f.entry[k].source == RL_FORECAST_FIRST && f.entry[k].group_seconds > 0.0;
            if (!good)
                fail_msg("%s: grid %d: %zu groups, %zu unknown, %zu estimated: %g s, %g s before",
                         rl_studies[i]->name, grid, f.groups_open, f.groups_unknown, f.groups_first,
                         f.seconds, before);
            before = f.seconds;
            rl_forecast_clear(&f);
        }
    }
}

/* One group of the quick grid is measured: it and those like it are no first estimates any more. */
static void test_measured(void **state)
{
    (void)state;
    struct temporary folder = {0};
    char path[PATH_MAX];
    struct rl_error error = {0};
    struct rl_forecast f;
    temporary_make(&folder);
    temporary_path(&folder, path, "results.db");
    const struct rl_study *study = rl_study_find("samples");
    make(&f, study, RL_GRID_QUICK, path);
    struct rl_run *run = &f.planned->run;
    size_t n = rl_group_end(run, 0), groups = f.groups_first;
    struct rl_eta eta = {0};
    check_ok(rl_eta_add(&eta, run, 0, NULL, &error), &error);
    check_relative(rl_eta_seconds(&eta), f.entry[0].group_seconds, 1e-12); /* the same, while it runs */
    rl_eta_clear(&eta);
    for (size_t i = 0; i < n; i++) {
        run->record[i].status = RL_RECORD_OK;
        run->record[i].seconds = 1234.0;
    }
    struct rl_database *db;
    check_ok(rl_database_open(&db, path, RL_DATABASE_WRITE, &error), &error);
    check_ok(rl_database_begin_run(db, run, &error), &error);
    check_ok(rl_database_store(db, run, 0, n, &error), &error);
    rl_database_close(db);
    rl_forecast_clear(&f);

    make(&f, study, RL_GRID_QUICK, path);
    assert_int_equal(f.entry[0].source, RL_FORECAST_SAME);
    assert_true(f.entry[0].group_seconds == 1234.0);
    bool similar = false;
    for (size_t i = n; i < f.planned->run.n_records; i++)
        similar = similar || f.entry[i].source == RL_FORECAST_SIMILAR;
    assert_true(similar && f.groups_first < groups - 1 && f.groups_unknown == 0);
    rl_forecast_clear(&f);
    temporary_remove(&folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sum),
        cmocka_unit_test(test_every_study),
        cmocka_unit_test(test_measured),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
