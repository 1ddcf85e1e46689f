/* Arms timed by the shared helper: made-up frames of known length, their figures, the caps, and what noise leaves undecided. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "studies/timing_arms.h"

static const struct rl_place place = {"made-up", "none", "", 0};

/* Frames say how long they took and take no time. Every other one is longer, the rest shorter, by the spread. */
struct made_up {
    double ms, spread;
    int frames;
};

static int frame(void *user, double *seconds, struct rl_error *error)
{
    (void)error;
    struct made_up *m = user;
    *seconds = m->ms / 1000.0 * (1.0 + m->spread * (m->frames++ % 2 ? 1.0 : -1.0));
    return RL_OK;
}

enum { ARMS = 4 };

/* Times the arms none, four, again and slow. */
static void time_arms(struct rl_run *run, double spread, int most_frames)
{
    static const char *const name[ARMS] = {"none", "four", "again", "slow"};
    struct made_up m[ARMS] = {{1.0, 0.0, 0}, {4.0, spread, 0}, {4.0, spread, 0}, {10.0, spread, 0}};
    struct rl_timing_arm arm[ARMS];
    struct rl_bench bench = {0};
    struct rl_error error;
    *run = (struct rl_run){.study = "made-up"};
    for (int i = 0; i < ARMS; i++)
        assert_non_null(rl_run_add(run, &place, 0, NULL, "arm=%s", name[i]));
    for (int i = 0; i < ARMS; i++)
        arm[i] = (struct rl_timing_arm){name[i], frame, &m[i]};
    const struct rl_arms_options options = {.frames = 30,
                                            .most_frames = most_frames,
                                            .most_seconds = 10.0,
                                            .baseline = "arm=none",
                                            .against = "arm=four",
                                            .ratio = "time_to_four",
                                            .difference = "above_four_ms"};
    rl_spent_begin(&bench.spent, RL_SPENT_EVALUATION);
    assert_int_equal(rl_arms_time(run->record, arm, ARMS, &bench, &options, &error), RL_OK);
    assert_int_equal(bench.spent.now, RL_SPENT_EVALUATION);
    assert_true(bench.spent.seconds[RL_SPENT_MEASURED] > 0.0);
}

static double value(const struct rl_run *run, int arm, const char *name)
{
    const struct rl_metric *m = rl_record_metric(&run->record[arm], name);
    assert_non_null(m);
    return m->value;
}

static void steady_arms_stop_at_thirty(void **state)
{
    (void)state;
    struct rl_run run;
    time_arms(&run, 0.0, 60);
    for (int i = 0; i < ARMS; i++) {
        assert_true(value(&run, i, "frames") == 30.0);
        assert_true(value(&run, i, "time_capped") == 0.0 && value(&run, i, "time_precision") < 1e-9);
        assert_true(rl_record_series(&run.record[i], "frame_ms")->n == 30);
    }
    assert_true(fabs(value(&run, 3, "frame_ms") - 10.0) < 1e-9);
    assert_true(fabs(value(&run, 3, "above_baseline_ms") - 9.0) < 1e-9);
    assert_true(fabs(value(&run, 0, "above_baseline_ms")) < 1e-9);
    assert_true(fabs(value(&run, 3, "time_to_four") - 2.5) < 1e-9);
    assert_true(fabs(value(&run, 0, "above_four_ms") + 3.0) < 1e-9);
    rl_run_clear(&run);
}

static void unsteady_arms_go_on_to_the_cap(void **state)
{
    (void)state;
    struct rl_run run;
    time_arms(&run, 0.5, 45);
    assert_true(value(&run, 1, "frames") == 45.0);
    assert_true(value(&run, 1, "time_capped") == 1.0 && value(&run, 1, "time_precision") > 0.02);
    assert_true(value(&run, 0, "time_capped") == 0.0); /* the arm that was steady all along says so */
    rl_run_clear(&run);
}

static void noise_leaves_undecided(void **state)
{
    (void)state;
    struct rl_metric again = {.value = 1.0, .low = 0.99, .high = 1.03};
    double noise = rl_arms_noise(&again);
    assert_true(fabs(noise - 0.03) < 1e-12);
    static const struct {
        double low, high, bound;
        enum rl_verdict verdict;
    } row[] = {
        {0.95, 0.96, 1.0, RL_VERDICT_HOLDS},        {0.98, 0.99, 1.0, RL_VERDICT_INCONCLUSIVE},
        {1.01, 1.02, 1.0, RL_VERDICT_INCONCLUSIVE}, {1.04, 1.05, 1.0, RL_VERDICT_FAILS},
        {1.04, 1.05, 1.1, RL_VERDICT_HOLDS},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_metric m = {.value = row[i].low, .low = row[i].low, .high = row[i].high};
        assert_int_equal(rl_arms_at_most(&m, noise, row[i].bound), row[i].verdict);
        assert_int_equal(rl_arms_at_most(&m, NAN, row[i].bound), RL_VERDICT_INCONCLUSIVE);
    }
    assert_true(isnan(rl_arms_noise(NULL)));
    assert_int_equal(rl_arms_at_most(NULL, noise, 1.0), RL_VERDICT_INCONCLUSIVE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady_arms_stop_at_thirty),
        cmocka_unit_test(unsteady_arms_go_on_to_the_cap),
        cmocka_unit_test(noise_leaves_undecided),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
