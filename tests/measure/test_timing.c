/* Interleaved timing: every arm once a round, orders that vary, warm-up thrown away, an end when precise, and on request. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "measure/timing.h"

enum { LOG_MAX = 4096 };

struct log {
    size_t n;
    int arm[LOG_MAX];
};

struct fake {
    struct log *log;
    int arm;
    double seconds;  /* of each frame */
    int steady_from; /* before: twice, then half as slow, in turn */
    int count, fails_at;
};

static int fake_frame(void *user, double *seconds, struct rl_error *error)
{
    struct fake *f = user;
    if (f->log->n < LOG_MAX)
        f->log->arm[f->log->n++] = f->arm;
    f->count++;
    if (f->fails_at && f->count == f->fails_at)
        return rl_fail(error, RL_ERR_SYSTEM, "the card fell out");
    *seconds = f->count > f->steady_from ? f->seconds : f->seconds * (f->count % 2 ? 2.0 : 0.5);
    return RL_OK;
}

static void make(struct rl_timing_arm arm[3], struct fake fake[3], struct log *log)
{
    static const char *const name[] = {"a", "b", "c"};
    *log = (struct log){0};
    for (int i = 0; i < 3; i++) {
        fake[i] = (struct fake){.log = log, .arm = i, .seconds = 0.001 * (i + 1)};
        arm[i] = (struct rl_timing_arm){name[i], fake_frame, &fake[i]};
    }
}

static void test_rounds(void **state)
{
    (void)state;
    struct rl_timing_arm arm[3];
    struct fake fake[3];
    struct log log;
    make(arm, fake, &log);
    struct rl_timing timing;
    struct rl_timing_options options = {
        .warm_up = 2, .min_rounds = 12, .max_rounds = 50, .precision = 0.02, .max_seconds = 100.0, .seed = 5};
    assert_int_equal(rl_timing_run(&timing, arm, 3, &options, NULL, NULL), RL_OK);
    assert_int_equal(timing.n_rounds, 12); /* steady: no more than asked for */
    assert_int_equal(log.n, 3 * (2 + 12));
    int orders_seen = 0;
    bool seen[27] = {false};
    for (size_t r = 0; r < log.n / 3; r++) {
        const int *round = &log.arm[3 * r];
        assert_int_equal((1 << round[0]) | (1 << round[1]) | (1 << round[2]), 7);
        int code = 9 * round[0] + 3 * round[1] + round[2];
        orders_seen += !seen[code];
        seen[code] = true;
    }
    assert_true(orders_seen >= 4); /* of 6, in 14 rounds */
    for (int i = 0; i < 3; i++)
        for (size_t r = 0; r < timing.n_rounds; r++)
            assert_true(fabs(timing.ms[i][r] - (i + 1)) < 1e-12);
    rl_timing_clear(&timing);
}

static void test_goes_on_until_precise(void **state)
{
    (void)state;
    struct rl_timing_arm arm[3];
    struct fake fake[3];
    struct log log;
    struct rl_timing timing;
    struct rl_timing_options options = {
        .min_rounds = 10, .max_rounds = 200, .precision = 0.02, .max_seconds = 100.0};
    make(arm, fake, &log);
    fake[1].steady_from = 12;
    assert_int_equal(rl_timing_run(&timing, arm, 3, &options, NULL, NULL), RL_OK);
    assert_in_range(timing.n_rounds, 15, 60);
    rl_timing_clear(&timing);

    fake[1].steady_from = 1000000; /* never */
    assert_int_equal(rl_timing_run(&timing, arm, 3, &options, NULL, NULL), RL_OK);
    assert_int_equal(timing.n_rounds, 200);
    rl_timing_clear(&timing);

    options.max_seconds = 0.0;
    assert_int_equal(rl_timing_run(&timing, arm, 3, &options, NULL, NULL), RL_OK);
    assert_int_equal(timing.n_rounds, 10);
    rl_timing_clear(&timing);
}

static bool stop(void *user)
{
    struct log *log = user;
    return log->n >= 7;
}

static void test_ends_early(void **state)
{
    (void)state;
    struct rl_timing_arm arm[3];
    struct fake fake[3];
    struct log log;
    struct rl_timing timing;
    struct rl_error error;
    make(arm, fake, &log);
    struct rl_progress progress = {.cancelled = stop, .user = &log};
    assert_int_equal(rl_timing_run(&timing, arm, 3, &RL_TIMING_DEFAULT, &progress, &error), RL_ERR_CANCELLED);
    assert_int_equal(log.n, 7);
    assert_null(timing.ms);

    make(arm, fake, &log);
    fake[2].fails_at = 4;
    assert_int_equal(rl_timing_run(&timing, arm, 3, &RL_TIMING_DEFAULT, NULL, &error), RL_ERR_SYSTEM);
    assert_string_equal(error.message, "c: the card fell out");
    assert_int_equal(rl_timing_run(&timing, arm, 0, &RL_TIMING_DEFAULT, NULL, &error), RL_ERR_INPUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rounds),
        cmocka_unit_test(test_goes_on_until_precise),
        cmocka_unit_test(test_ends_early),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
