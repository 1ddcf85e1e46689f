/* Interleaved timing: every arm once a round, orders that vary, warm-up thrown away, an end when precise, and on request. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <time.h>

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

/* ---- Times as clocks give them ---- */

/* Frames in a row, the last of them again and again. */
struct script {
    const double *seconds;
    size_t n, next;
};

static int scripted_frame(void *user, double *seconds, struct rl_error *error)
{
    struct script *s = user;
    (void)error;
    *seconds = s->seconds[s->next < s->n ? s->next : s->n - 1];
    s->next++;
    return RL_OK;
}

/* Rounds that are timed until the median is precise, from 1 to 20; or the error. */
static void test_clocks(void **state)
{
    (void)state;
    static const double steady[] = {0.002}, zero[] = {0.0}, back[] = {0.002, 0.002, -3600.0},
                        just_back[] = {0.002, -1e-9}, ahead[] = {0.002, 0.002, 3600.0, 0.002}, nan[] = {NAN},
                        infinite[] = {INFINITY}, tick[] = {0.0, 1e-3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    static const struct {
        const double *seconds;
        size_t n;
        int status;
        size_t rounds;
        const char *message;
    } row[] = {
        {steady, 1, RL_OK, 6, ""}, /* one sample is not precise, nor are five that agree: six are */
        {zero, 1, RL_OK, 20, ""},  /* nothing is relative to 0 */
        {tick, 8, RL_OK, 20, ""},  /* a tick now and then: the median is 0 */
        {ahead, 4, RL_OK, 9, ""},  /* ranks 2 and 8 of 9 are the first that leave the step out */
        {back, 3, RL_ERR_SYSTEM, 0, "found a frame of -3600 s, expected 0 or more: the clock went back"},
        {just_back, 2, RL_ERR_SYSTEM, 0, "found a frame of -1e-09 s, expected 0 or more"},
        {nan, 1, RL_ERR_SYSTEM, 0, "found a frame of "},
        {infinite, 1, RL_ERR_SYSTEM, 0, "found a frame of inf s"},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct script script = {row[i].seconds, row[i].n, 0};
        const struct rl_timing_arm arm = {"one arm", scripted_frame, &script};
        const struct rl_timing_options options = {
            .min_rounds = 1, .max_rounds = 20, .precision = 0.02, .max_seconds = 100.0};
        struct rl_timing timing;
        struct rl_error error = {0};
        int status = rl_timing_run(&timing, &arm, 1, &options, NULL, &error);
        if (status != row[i].status || timing.n_rounds != row[i].rounds ||
            !strstr(error.message, row[i].message) || (status == RL_OK) != (timing.ms != NULL))
            fail_msg("row %zu: status %d, %zu rounds, '%s'", i, status, timing.n_rounds, error.message);
        for (size_t k = 0; timing.ms && k < timing.n_rounds; k++)
            assert_true(timing.ms[0][k] == 1000.0 * row[i].seconds[k < row[i].n ? k : row[i].n - 1]);
        rl_timing_clear(&timing);
    }
}

/* The cap on seconds, by a clock that stands still, goes back by an hour after its first reading, or runs ahead by one: a test's own
 * clock_gettime, which the linker puts in place of the library's. */
static clockid_t asked;
static long readings;
static double step_s = NAN; /* NaN: the real clock */

int __real_clock_gettime(clockid_t clock, struct timespec *now);
int __wrap_clock_gettime(clockid_t clock, struct timespec *now);
int __wrap_clock_gettime(clockid_t clock, struct timespec *now)
{
    if (isnan(step_s))
        return __real_clock_gettime(clock, now);
    asked = clock;
    *now = (struct timespec){.tv_sec = 100000 + (readings++ > 0 ? (time_t)step_s : 0)};
    return 0;
}

static void test_clock_steps(void **state)
{
    (void)state;
    static const struct {
        double step_s;
        size_t rounds; /* of 3 to 8, with a cap of 10 s; a steady arm is precise after 6 */
    } row[] = {{0.0, 6}, {-3600.0, 6}, {9.0, 6}, {11.0, 3}, {3600.0, 3}};
    static const double steady[] = {0.002};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct script script = {steady, 1, 0};
        const struct rl_timing_arm arm = {"one arm", scripted_frame, &script};
        const struct rl_timing_options options = {
            .min_rounds = 3, .max_rounds = 8, .precision = 0.02, .max_seconds = 10.0};
        struct rl_timing timing;
        readings = 0;
        step_s = row[i].step_s;
        int status = rl_timing_run(&timing, &arm, 1, &options, NULL, NULL);
        step_s = NAN;
        assert_int_equal(status, RL_OK);
        /* One that setting the time of day does not move. */
        assert_int_equal(asked, CLOCK_MONOTONIC);
        assert_int_equal(timing.n_rounds, row[i].rounds);
        rl_timing_clear(&timing);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rounds),      cmocka_unit_test(test_goes_on_until_precise),
        cmocka_unit_test(test_ends_early),  cmocka_unit_test(test_clocks),
        cmocka_unit_test(test_clock_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
