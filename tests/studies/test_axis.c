/* Axes: what is read from the command line, what becomes of a plan, and what is refused, with words that help. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "studies/axis.h"
#include "support/check.h"

static const struct rl_place place = {"made-up", "ball", "ball.yaml", 7};

/* The values of an axis, a blank between. */
static void join(char text[], size_t size, const struct rl_axis *axis)
{
    size_t used = 0;
    text[0] = '\0';
    for (size_t i = 0; i < axis->n; i++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", i ? " " : "", axis->value[i]);
}

static void test_parse(void **state)
{
    (void)state;
    static const struct {
        const char *text, *name, *values; /* values NULL: refused */
    } row[] = {
        {"rr=1,2,4", "rr", "1 2 4"},
        {"rr=2.50,1e3,0.0001", "rr", "2.5 1000 0.0001"},
        {"rr=0.1234567", "rr", "0.1234567"}, /* nothing of a number given is lost */
        {"normal_bits=8,half", "normal_bits", "8 half"},
        {"samples=1:1024:log11", "samples", "1 2 4 8 16 32 64 128 256 512 1024"},
        {"rr=1:100:log9", "rr", "1 1.77828 3.16228 5.62341 10 17.7828 31.6228 56.2341 100"},
        {"margin=0:1:lin5", "margin", "0 0.25 0.5 0.75 1"},
        {"rr=100:1:log3", "rr", "100 10 1"},
        {"rr", NULL, NULL},
        {"rr=", NULL, NULL},
        {"=1", NULL, NULL},
        {"rr=1,,2", NULL, NULL},
        {"rr=1,2,", NULL, NULL},
        {"rr=1 2", NULL, NULL},
        {"rr=1;2", NULL, NULL},
        {"rr=1=2", NULL, NULL},
        {"rr=1:2", NULL, NULL},
        {"rr=1:2:log", NULL, NULL},
        {"rr=1:2:sin4", NULL, NULL},
        {"rr=1:2:log4x", NULL, NULL},
        {"rr=0:2:log4", NULL, NULL},
        {"rr=1:2:log1", NULL, NULL},
        {"rr=1:2:log100000", NULL, NULL},
        {"rr=1:inf:lin3", NULL, NULL},
        {"rr=123456789012345678901234567890123456", NULL, NULL},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_axis axis;
        struct rl_error error = {0};
        int status = rl_axis_parse(&axis, row[i].text, &error);
        print_message("%s: %s\n", row[i].text, status == RL_OK ? "taken" : error.message);
        if (!row[i].values) {
            check_fails(status, &error, RL_ERR_INPUT, "expected");
            continue;
        }
        char values[512];
        check_ok(status, &error);
        join(values, sizeof values, &axis);
        assert_string_equal(axis.name, row[i].name);
        assert_string_equal(values, row[i].values);
    }
}

static void add(struct rl_run *run, int group, const char *parameters)
{
    assert_non_null(rl_run_add(run, &place, group, NULL, "%s", parameters));
}

/* Two groups of a pair each, then a case of another kind alone. */
static void make_run(struct rl_run *run)
{
    *run = (struct rl_run){.study = "made-up"};
    add(run, 4, "arm=a method=random samples=4 rr=3 normal_bits=8");
    add(run, 4, "arm=b method=random samples=4 rr=3 normal_bits=8");
    add(run, 5, "arm=a method=random samples=4 rr=30 normal_bits=8");
    add(run, 5, "arm=b method=random samples=4 rr=30 normal_bits=8");
    add(run, 6, "arm=c points=9 seeds=2 share=0.5 offset=-3");
}

static const struct rl_sweep made_up[] = {
    RL_SWEEP_RR(NULL),
    {.name = "samples", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 1024},
    {.name = "normal_bits", .kind = RL_SWEEP_WORD, .words = rl_sweep_normal_bits},
    RL_SWEEP_NORMAL_SIZE(NULL),
    {.name = "points", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 100},
    {.name = "seeds", .of = "arm=c", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 64},
    {.name = "share", .kind = RL_SWEEP_REAL, .low = 0.01, .high = 1},
    {.name = "offset", .kind = RL_SWEEP_WHOLE, .low = -9, .high = 9},
    {.name = "env_size", .of = "base=0", .kind = RL_SWEEP_WHOLE, .low = 8, .high = 64, .together = 3},
    {.name = "margin", .kind = RL_SWEEP_REAL, .low = 0, .high = 10, .together = 3, .named_by = "arm"},
    {.name = "rounds", .kind = RL_SWEEP_WHOLE, .low = 0, .high = 9},
};
static const struct rl_sweeps sweeps = {made_up, sizeof made_up / sizeof made_up[0]};

static int apply(struct rl_run *run, const char *first, const char *second, rl_parameters_check *check,
                 struct rl_error *error)
{
    struct rl_axis *axis = calloc(2, sizeof *axis);
    assert_non_null(axis);
    *error = (struct rl_error){0};
    check_ok(rl_axis_parse(&axis[0], first, error), error);
    if (second)
        check_ok(rl_axis_parse(&axis[1], second, error), error);
    int status = rl_axes_apply(run, axis, second ? 2 : 1, &sweeps, check, error);
    free(axis);
    return status;
}

/* "group parameters" of every record, and whether each group's records are together */
static void expect(const struct rl_run *run, const char *const *expected, size_t n)
{
    for (size_t i = 0; i < run->n_records && i < n; i++) {
        char text[RL_PARAMETERS_MAX + 16];
        snprintf(text, sizeof text, "%d %s", run->record[i].group, run->record[i].parameters);
        assert_string_equal(text, expected[i]);
    }
    assert_int_equal(run->n_records, n);
}

static void test_apply(void **state)
{
    (void)state;
    struct rl_run run;
    struct rl_error error;
    make_run(&run);
    /* Both groups become the same at each value, and are one. */
    check_ok(apply(&run, "rr=10,30", NULL, NULL, &error), &error);
    static const char *const merged[] = {"0 arm=a method=random samples=4 rr=10 normal_bits=8",
                                         "0 arm=b method=random samples=4 rr=10 normal_bits=8",
                                         "1 arm=a method=random samples=4 rr=30 normal_bits=8",
                                         "1 arm=b method=random samples=4 rr=30 normal_bits=8",
                                         "4 arm=c points=9 seeds=2 share=0.5 offset=-3"};
    expect(&run, merged, 5);
    assert_string_equal(run.record[0].scene_path, "ball.yaml");
    assert_string_equal(run.record[0].scene_hash, "0000000000000007");
    /* Every combination, a group each; a case without the parameter stays as it is. */
    check_ok(apply(&run, "samples=1,2", "normal_bits=6,float", NULL, &error), &error);
    assert_int_equal(run.n_records, 2 * 2 * 2 * 2 + 1);
    static const char *const combined[] = {"0 arm=a method=random samples=1 rr=10 normal_bits=6",
                                           "0 arm=b method=random samples=1 rr=10 normal_bits=6",
                                           "1 arm=a method=random samples=1 rr=10 normal_bits=float",
                                           "1 arm=b method=random samples=1 rr=10 normal_bits=float",
                                           "2 arm=a method=random samples=2 rr=10 normal_bits=6"};
    struct rl_run start = run;
    start.n_records = 5;
    expect(&start, combined, 5);
    rl_run_clear(&run);
}

/* The values of a range become whole where only whole ones are taken, and then may be fewer. */
static void test_rounding(void **state)
{
    (void)state;
    static const struct {
        const char *axis, *first, *last;
        size_t n;
    } row[] = {
        {"samples=1:4:log9", "arm=a method=random samples=1 rr=3 normal_bits=8",
         "arm=c points=9 seeds=2 share=0.5 offset=-3", 2 * 2 * 4 + 1},
        {"seeds=1:4:log9", "arm=a method=random samples=4 rr=3 normal_bits=8",
         "arm=c points=9 seeds=4 share=0.5 offset=-3", 8},
        {"rr=1:4:log9", "arm=a method=random samples=4 rr=1 normal_bits=8",
         "arm=c points=9 seeds=2 share=0.5 offset=-3", 2 * 9 + 1},
        {"share=0.1:0.3:lin3", "arm=a method=random samples=4 rr=3 normal_bits=8",
         "arm=c points=9 seeds=2 share=0.3 offset=-3", 7},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_run run;
        struct rl_error error;
        make_run(&run);
        check_ok(apply(&run, row[i].axis, NULL, NULL, &error), &error);
        assert_string_equal(run.record[0].parameters, row[i].first);
        assert_string_equal(run.record[run.n_records - 1].parameters, row[i].last);
        assert_int_equal(run.n_records, row[i].n);
        rl_run_clear(&run);
    }
}

static void make_arms(struct rl_run *run)
{
    *run = (struct rl_run){.study = "made-up"};
    add(run, 0, "arm=off margin=off rr=3 rounds=0");
    add(run, 0, "arm=huge margin=1e6 rr=3 rounds=0");
    add(run, 0, "arm=0.5 margin=0.5 rr=3 rounds=0");
    add(run, 1, "arm=off margin=off rr=30 rounds=5");
    add(run, 1, "arm=huge margin=1e6 rr=30 rounds=5");
    add(run, 1, "arm=0.5 margin=0.5 rr=30 rounds=5");
    add(run, 2, "base=1 env_size=64 normal_size=64");
    add(run, 2, "base=0 env_size=16 normal_size=64");
    add(run, 2, "base=0 env_size=32 normal_size=64");
}

/* What tells arms apart stays, and what was meant side by side is one group. */
static void test_arms(void **state)
{
    (void)state;
    struct rl_run run;
    struct rl_error error;
    make_arms(&run);
    /* The untimed group becomes the same as the timed one, but for its clock. */
    check_ok(apply(&run, "rr=9", "margin=0.1,2", NULL, &error), &error);
    static const char *const margins[] = {
        "0 arm=off margin=off rr=9 rounds=5",  "0 arm=huge margin=1e6 rr=9 rounds=5",
        "0 arm=0.1 margin=0.1 rr=9 rounds=5",  "0 arm=2 margin=2 rr=9 rounds=5",
        "1 base=1 env_size=64 normal_size=64", "1 base=0 env_size=16 normal_size=64",
        "1 base=0 env_size=32 normal_size=64"};
    for (size_t i = 0; i < run.n_records; i++) /* numbers of groups may have gaps */
        run.record[i].group = i >= 4;
    expect(&run, margins, 7);
    check_ok(apply(&run, "env_size=8", NULL, NULL, &error), &error);
    assert_int_equal(run.n_records, 6);
    assert_string_equal(run.record[4].parameters, "base=1 env_size=64 normal_size=64");
    assert_string_equal(run.record[5].parameters, "base=0 env_size=8 normal_size=64");
    assert_int_equal(run.record[4].group, run.record[5].group);
    check_fails(apply(&run, "env_size=8,9,10,11", NULL, NULL, &error), &error, RL_ERR_INPUT,
                "found 4 values, expected at most 3");
    check_fails(apply(&run, "normal_size=96", NULL, NULL, &error), &error, RL_ERR_INPUT,
                "found '96', expected a power of two from 64 to 2048");
    rl_run_clear(&run);
    /* What is in two groups stays in the larger one, with what it is held against. */
    run = (struct rl_run){.study = "made-up"};
    add(&run, 0, "arm=a rr=3");
    add(&run, 1, "arm=b rr=30");
    add(&run, 1, "arm=a rr=30");
    check_ok(apply(&run, "rr=9", NULL, NULL, &error), &error);
    static const char *const larger[] = {"1 arm=b rr=9", "1 arm=a rr=9"};
    expect(&run, larger, 2);
    rl_run_clear(&run);
    /* Who asks for both gets both. */
    make_arms(&run);
    check_ok(apply(&run, "rr=9", "rounds=0,5", NULL, &error), &error);
    assert_int_equal(run.n_records, 2 * 3 + 3);
    rl_run_clear(&run);
}

static int no_threes(const char *parameters, struct rl_error *error)
{
    return rl_parameters_match(parameters, "points=3") ? rl_fail(error, RL_ERR_INPUT, "three is a crowd")
                                                       : RL_OK;
}

static void test_refused(void **state)
{
    (void)state;
    static const struct {
        const char *axis, *words;
    } row[] = {
        {"roughness=3", "no parameter of the study made-up, expected one of rr, samples, normal_bits"},
        {"arm=d", "told apart by in the study made-up and is not replaced, expected one of rr, samples"},
        {"method=regular", "told apart by in the study made-up and is not replaced, expected one of rr"},
        {"samples=0", "found '0', expected a whole number from 1 to 1024"},
        {"samples=2.5", "found '2.5', expected a whole number from 1 to 1024"},
        {"samples=4000", "expected a whole number from 1 to 1024"},
        {"samples=many", "found 'many', expected a whole number"},
        {"samples=0:9:lin4", "found '0', expected a whole number from 1"},
        {"rr=-1", "expected a number from 0.01 to 1e+06"},
        {"rr=1e30", "expected a number from 0.01 to 1e+06"},
        {"normal_bits=3", "found '3', expected one of 4, 5, 6"},
        {"points=1.5", "expected a whole number from 1 to 100"},
        {"offset=x", "expected a whole number from -9 to 9"},
        {"share=-0.5", "expected a number from 0.01 to 1"},
        {"points=1,3", "points=3 seeds=2 share=0.5 offset=-3: three is a crowd"},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_run run;
        struct rl_error error;
        make_run(&run);
        check_fails(apply(&run, row[i].axis, NULL, no_threes, &error), &error, RL_ERR_INPUT, row[i].words);
        rl_run_clear(&run);
    }
    struct rl_run run;
    struct rl_error error;
    make_run(&run);
    check_fails(apply(&run, "rr=1", "rr=2", NULL, &error), &error, RL_ERR_INPUT, "given twice");
    rl_run_clear(&run);
    make_run(&run);
    check_ok(apply(&run, "offset=-7,0", NULL, NULL, &error), &error); /* the study's own is below 0 */
    rl_run_clear(&run);
}

static void test_replace(void **state)
{
    (void)state;
    char out[RL_PARAMETERS_MAX], wide[RL_PARAMETERS_MAX];
    struct rl_error error = {0};
    check_ok(rl_parameters_replace(out, "env_size=4 size=8 s=1", "size", "16", &error), &error);
    assert_string_equal(out, "env_size=4 size=16 s=1");
    check_ok(rl_parameters_replace(out, "a=1", "b", "2", &error), &error);
    assert_string_equal(out, "a=1");
    memset(wide, 'x', sizeof wide);
    memcpy(wide, "a=1 b=", 6);
    wide[sizeof wide - 1] = '\0';
    check_fails(rl_parameters_replace(out, wide, "a", "11", &error), &error, RL_ERR_INPUT, "longer than");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_parse),   cmocka_unit_test(test_apply), cmocka_unit_test(test_rounding),
        cmocka_unit_test(test_refused), cmocka_unit_test(test_arms),  cmocka_unit_test(test_replace),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
