/* The runner, with a study of the test's own whose cases cost nothing: what is done is skipped, what failed waits until it is asked for, an
 * interruption keeps what was finished. Also how a case's parameters become settings. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/clock.h"
#include "base/files.h"
#include "results/database.h"
#include "studies/runner.h"
#include "support/temporary.h"

enum { GROUPS = 5 };

static struct temporary folder;

/* What the made-up study did and is to do; a descriptor has no place for a pointer of a test's own. */
static struct {
    int measured[GROUPS]; /* times */
    int failing;          /* this group fails, or -1 */
    int cancel_after;     /* groups, or -1 */
    int finished;
    int pause_on; /* a kind of work that each group spends 40 ms on, or -1 */
} script;

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int first_group,
                struct rl_error *error)
{
    int n = grid == RL_GRID_QUICK ? 2 : GROUPS;
    for (int g = 0; g < n; g++)
        for (int arm = 0; arm < 2; arm++)
            if (!rl_run_add(run, place, first_group + g, error, "number=%d arm=%d", g, arm))
                return RL_ERR_SYSTEM;
    return RL_OK;
}

static int measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                   struct rl_error *error)
{
    assert_int_equal(n, 2);
    if (script.pause_on >= 0) {
        rl_spent_on(&bench->spent, (enum rl_spent_kind)script.pause_on);
        nanosleep(&(struct timespec){.tv_nsec = 40000000}, NULL);
    }
    assert_true(strcmp(records[0].scene, RL_NO_SCENE) == 0 ? scene == NULL : scene->n_objects > 0);
    int group = (int)rl_parameter_number(records[0].parameters, "number");
    script.measured[group]++;
    script.finished++;
    if (group == script.failing)
        return rl_fail(error, RL_ERR_UNAVAILABLE, "out of luck");
    for (size_t i = 0; i < n; i++) {
        int status = rl_record_metric_add(&records[i], "answer", 42.0 + group, 42.0, 43.0, "1", error);
        if (status != RL_OK)
            return status;
    }
    return RL_OK;
}

static int judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    (void)claims, (void)run, (void)error;
    return RL_OK;
}

static const char *const scenes[] = {"sphere-quad", NULL};

static const struct rl_sweep sweeps[] = {{.name = "number", .kind = RL_SWEEP_WHOLE, .low = 0, .high = 9}};

static const struct rl_study study = {.name = "made-up",
                                      .summary = "",
                                      .text = "",
                                      .scenes = scenes,
                                      .plan = plan,
                                      .sweeps = {sweeps, 1},
                                      .measure = measure,
                                      .judge = judge};

/* The same with cases that no scene enters into: they are planned once, whatever the scenes. */
static const struct rl_study study_alone = {.name = "made-up",
                                            .summary = "",
                                            .text = "",
                                            .scenes = scenes,
                                            .plan = plan,
                                            .plan_alone = plan,
                                            .measure = measure,
                                            .judge = judge};

static bool cancelled(void *user)
{
    (void)user;
    return script.cancel_after >= 0 && script.finished >= script.cancel_after;
}

static char database[PATH_MAX], cache[PATH_MAX];

/* With what a test sets beside the grid. */
static struct rl_run_options extra;

static int run(enum rl_grid grid, struct rl_run_outcome *outcome, struct rl_error *error)
{
    const struct rl_study *const studies[] = {&study};
    const struct rl_progress progress = {.cancelled = cancelled};
    struct rl_run_options options = extra;
    options.database = database;
    options.cache = cache;
    options.backend = "osmesa";
    options.grid = grid;
    *error = (struct rl_error){0};
    return rl_studies_run(outcome, studies, 1, &options, &progress, error);
}

static void reset(const char *name)
{
    memset(&script, 0, sizeof script);
    extra = (struct rl_run_options){0};
    script.failing = script.cancel_after = script.pause_on = -1;
    temporary_path(&folder, database, name);
    temporary_path(&folder, cache, "cache");
}

static void load(struct rl_run *loaded)
{
    struct rl_database *db;
    assert_int_equal(rl_database_open(&db, database, RL_DATABASE_READ, NULL), RL_OK);
    assert_int_equal(rl_database_load_run(db, "made-up", loaded, NULL), RL_OK);
    rl_database_close(db);
}

static void test_skips_what_is_done(void **state)
{
    (void)state;
    struct rl_run_outcome o;
    struct rl_error error;
    reset("skip.db");
    if (run(RL_GRID_QUICK, &o, &error) != RL_OK)
        fail_msg("%s", error.message);
    assert_true(o.planned == 4 && o.measured == 4 && o.skipped == 0 && o.failed == 0);
    assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_OK); /* the full grid holds the quick one */
    assert_true(o.planned == 10 && o.measured == 6 && o.skipped == 4);
    assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_OK);
    assert_true(o.measured == 0 && o.skipped == 10);
    for (int g = 0; g < GROUPS; g++)
        assert_int_equal(script.measured[g], 1);
    struct rl_run loaded;
    load(&loaded);
    assert_string_equal(loaded.grid, "full");
    assert_int_equal(rl_run_count(&loaded, RL_RECORD_OK), 10);
    assert_true(rl_record_metric(&loaded.record[9], "answer")->value == 46.0);
    rl_run_clear(&loaded);
}

/* A pause shows in the kind of work it was planted in and in no other, in the group's first case and in the run's sum; and the sum of
 * all kinds is the time from begin to end. */
static void test_accounts_for_its_time(void **state)
{
    (void)state;
    for (int kind = 0; kind < RL_SPENT_HARNESS; kind++) {
        struct rl_run_outcome o;
        struct rl_error error;
        struct rl_run loaded;
        reset("spent.db");
        unlink(database);
        script.pause_on = kind;
        double begin = rl_clock_seconds(), all = 0.0;
        assert_int_equal(run(RL_GRID_QUICK, &o, &error), RL_OK);
        double took = rl_clock_seconds() - begin;
        for (int k = 0; k < RL_SPENT_KINDS; k++)
            all += o.seconds[k];
        /* Closing the GPU comes after the last look at the clock. */
        assert_true(all <= took && all >= took - fmax(0.01 * took, 0.05));
        assert_true(o.seconds[kind] >= 0.08);
        for (int k = 0; k < RL_SPENT_HARNESS; k++)
            assert_true(k == kind || k == RL_SPENT_SETUP || o.seconds[k] < 0.04);
        load(&loaded);
        for (size_t i = 0; i < loaded.n_records; i++)
            for (int k = 0; k < RL_SPENT_HARNESS; k++) {
                char name[RL_NAME_MAX];
                snprintf(name, sizeof name, "spent_%s", rl_spent_name((enum rl_spent_kind)k));
                const struct rl_metric *m = rl_record_metric(&loaded.record[i], name);
                assert_true((m != NULL) == (i % 2 == 0)); /* two cases a group */
                assert_true(!m || (m->value >= 0.04) == (k == kind));
                assert_true(!m || rl_metric_timed(m));
            }
        rl_run_clear(&loaded);
    }
}

static void test_shares_as_text(void **state)
{
    (void)state;
    static const double seconds[RL_SPENT_KINDS] = {[RL_SPENT_MEASURED] = 7.0,
                                                   [RL_SPENT_REFERENCE] = 2.0,
                                                   [RL_SPENT_SETUP] = 0.5,
                                                   [RL_SPENT_EVALUATION] = 0.3,
                                                   [RL_SPENT_HARNESS] = 0.2};
    char text[256];
    rl_spent_text(text, sizeof text, seconds);
    assert_string_equal(text, "10.0 s: 70.0 % measured, 20.0 % reference, 5.0 % set-up, 3.0 % evaluation, "
                              "2.0 % harness");
    static const double group[RL_SPENT_KINDS] = {[RL_SPENT_MEASURED] = 3.0, [RL_SPENT_SETUP] = 1.0};
    rl_spent_text(text, sizeof text, group);
    assert_string_equal(text, "4.0 s: 75.0 % measured, 0.0 % reference, 25.0 % set-up, 0.0 % evaluation");
}

static void test_retries_on_request(void **state)
{
    (void)state;
    struct rl_run_outcome o;
    struct rl_error error;
    reset("fail.db");
    script.failing = 3;
    assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_OK); /* the others go on */
    assert_true(o.measured == 8 && o.failed == 2);
    struct rl_run loaded;
    load(&loaded);
    assert_int_equal(loaded.record[6].status, RL_RECORD_FAILED);
    assert_string_equal(loaded.record[6].message, "out of luck");
    assert_int_equal(loaded.record[6].n_metrics, 0);
    rl_run_clear(&loaded);
    script.failing = -1;
    assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_OK); /* left alone, and still counted */
    assert_true(o.measured == 0 && o.skipped == 8 && o.failed == 2);
    assert_int_equal(script.measured[3], 1);
    extra.retry = true;
    assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_OK);
    assert_true(o.measured == 2 && o.skipped == 8 && o.failed == 0);
    assert_int_equal(script.measured[3], 2);
    assert_int_equal(script.measured[4], 1);
}

static void test_measures_again(void **state)
{
    (void)state;
    struct rl_run_outcome o;
    struct rl_error error;
    reset("again.db");
    assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_OK);
    extra.again = true;
    script.failing = 1; /* what is measured afresh and fails is failed, whatever it was before */
    assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_OK);
    assert_true(o.measured == 8 && o.skipped == 0 && o.failed == 2);
    for (int g = 0; g < GROUPS; g++)
        assert_int_equal(script.measured[g], 2);
    struct rl_run loaded;
    load(&loaded);
    assert_int_equal(rl_run_count(&loaded, RL_RECORD_OK), 8);
    assert_int_equal(rl_run_count(&loaded, RL_RECORD_FAILED), 2);
    rl_run_clear(&loaded);
}

/* Each group belongs to one of n shares, whole; together they are everything; the grid around it does not matter. */
static void test_shards(void **state)
{
    (void)state;
    struct rl_run_outcome o;
    struct rl_error error;
    enum { SHARDS = 3 };
    int share[GROUPS] = {0};
    size_t planned = 0;
    for (int i = 1; i <= SHARDS; i++) {
        char name[32];
        snprintf(name, sizeof name, "shard-%d.db", i);
        reset(name);
        extra.shard = i;
        extra.n_shards = SHARDS;
        assert_int_equal(run(RL_GRID_QUICK, &o, &error), RL_OK);
        size_t small = o.planned;
        assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_OK);
        assert_true(o.skipped == small && o.measured + o.skipped == o.planned);
        planned += o.planned;
        for (int g = 0; g < GROUPS; g++) {
            assert_true(script.measured[g] == 0 || share[g] == 0);
            share[g] += script.measured[g];
        }
        struct rl_run loaded;
        load(&loaded); /* the whole plan is noted, so that one sees what is missing */
        assert_int_equal(loaded.n_records, 2 * GROUPS);
        rl_run_clear(&loaded);
    }
    assert_int_equal(planned, 2 * GROUPS);
    for (int g = 0; g < GROUPS; g++)
        assert_int_equal(share[g], 1);
}

/* An axis reaches what a study lets it replace, and the claims' command has it. */
static void test_axis(void **state)
{
    (void)state;
    struct rl_run_outcome o;
    struct rl_error error;
    struct rl_axis axis;
    reset("axis.db");
    assert_int_equal(rl_axis_parse(&axis, "number=4,2", &error), RL_OK);
    extra.axes = &axis;
    extra.n_axes = 1;
    assert_int_equal(run(RL_GRID_QUICK, &o, &error), RL_OK);
    assert_true(o.planned == 4 && o.measured == 4);
    assert_true(script.measured[0] == 0 && script.measured[2] == 1 && script.measured[4] == 1);
    struct rl_run loaded;
    struct rl_claim claim = {0};
    load(&loaded);
    rl_claim_source(&claim, &loaded, "sphere-quad");
    assert_string_equal(claim.command,
                        "roughlight study run made-up --scene sphere-quad --quick --axis number=4,2");
    rl_run_clear(&loaded);
    extra.n_axes = 0;
    assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_OK); /* the same cases as the study's own */
    assert_true(o.measured == 6 && o.skipped == 4);

    reset("never.db");
    assert_int_equal(rl_axis_parse(&axis, "numbers=4", &error), RL_OK);
    extra.axes = &axis;
    extra.n_axes = 1;
    assert_int_equal(run(RL_GRID_QUICK, &o, &error), RL_ERR_INPUT);
    assert_non_null(strstr(error.message, "expected one of number"));
    assert_int_not_equal(access(database, F_OK), 0); /* nothing was begun */
}

static void test_interrupted(void **state)
{
    (void)state;
    struct rl_run_outcome o;
    struct rl_error error;
    reset("interrupt.db");
    script.cancel_after = 2;
    assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_ERR_CANCELLED);
    assert_int_equal(o.measured, 4);
    script.cancel_after = -1;
    assert_int_equal(run(RL_GRID_FULL, &o, &error), RL_OK);
    assert_true(o.measured == 6 && o.skipped == 4);
    for (int g = 0; g < GROUPS; g++)
        assert_int_equal(script.measured[g], 1);
}

static void test_without_a_scene(void **state)
{
    (void)state;
    const struct rl_study *const studies[] = {&study_alone};
    const char *const two[] = {"sphere-quad", "teapot-star"};
    reset("alone.db");
    struct rl_run_options options = {.database = database,
                                     .cache = cache,
                                     .backend = "osmesa",
                                     .grid = RL_GRID_QUICK,
                                     .scenes = two,
                                     .n_scenes = 2};
    struct rl_run_outcome o;
    assert_int_equal(rl_studies_run(&o, studies, 1, &options, NULL, NULL), RL_OK);
    assert_true(o.planned == 12 && o.measured == 12 && o.failed == 0);
    struct rl_run loaded;
    load(&loaded);
    assert_string_equal(rl_run_scene(&loaded, 0), RL_NO_SCENE);
    assert_string_equal(rl_run_scene(&loaded, 1), "sphere-quad");
    assert_string_equal(rl_run_scene(&loaded, 2), "teapot-star");
    assert_null(rl_run_scene(&loaded, 3));
    assert_int_equal(loaded.record[11].group, 5);
    struct rl_claim claim = {0};
    rl_claim_source(&claim, &loaded, RL_NO_SCENE);
    assert_string_equal(claim.command, "roughlight study run made-up --quick");
    rl_claim_source(&claim, &loaded, "sphere-quad");
    assert_string_equal(claim.command, "roughlight study run made-up --scene sphere-quad --quick");
    rl_run_clear(&loaded);
}

static int make_folder(void **state)
{
    (void)state;
    temporary_make(&folder);
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_skips_what_is_done),
        cmocka_unit_test(test_accounts_for_its_time),
        cmocka_unit_test(test_shares_as_text),
        cmocka_unit_test(test_retries_on_request),
        cmocka_unit_test(test_measures_again),
        cmocka_unit_test(test_shards),
        cmocka_unit_test(test_axis),
        cmocka_unit_test(test_interrupted),
        cmocka_unit_test(test_without_a_scene),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
