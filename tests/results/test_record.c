/* Parameters' text, how records are found by it, and what a case's identity depends on. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "results/record.h"

static void test_parameters(void **state)
{
    (void)state;
    static const char text[] = "kind=error samples=4 rr=30 normal_bits=8";
    static const struct {
        const char *pattern;
        bool match;
    } row[] = {
        {"", true},        {"samples=4", true},       {"rr=30 kind=error", true}, /* in any order */
        {"rr=3", false},                    /* the start of a value is not the value */
        {"rr=300", false}, {"r=30", false}, /* the end of a key is not the key */
        {"bits=8", false}, {"samples=4 rr=3", false}, {"samples", false},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
        assert_int_equal(rl_parameters_match(text, row[i].pattern), row[i].match);

    char value[16];
    assert_true(rl_parameter(text, "kind", value, sizeof value));
    assert_string_equal(value, "error");
    assert_false(rl_parameter(text, "bits", value, sizeof value));
    assert_string_equal(value, "");
    assert_true(rl_parameter_number(text, "rr") == 30.0);
    assert_true(isnan(rl_parameter_number(text, "kind")));
    assert_true(isnan(rl_parameter_number(text, "missing")));
}

static void identity(char out[RL_HASH_TEXT], const char *study, uint64_t hash, const char *path,
                     const char *parameters, const char *environment)
{
    struct rl_run run = {0};
    struct rl_place place = {study, "scene", path, hash};
    assert_non_null(rl_run_add(&run, &place, 0, NULL, "%s", parameters));
    rl_run_identify(&run, environment);
    memcpy(out, run.record[0].identity, RL_HASH_TEXT);
    rl_run_clear(&run);
}

static void test_identity(void **state)
{
    (void)state;
    char base[RL_HASH_TEXT], same[RL_HASH_TEXT], other[RL_HASH_TEXT];
    identity(base, "samples", 1, "a.yaml", "rr=3", "env");
    identity(same, "samples", 1, "elsewhere/a.yaml", "rr=3",
             "env"); /* where the scene lies does not matter */
    assert_string_equal(base, same);

    static const struct {
        const char *study;
        uint64_t hash;
        const char *parameters, *environment;
    } row
        [] =
            {
                {"fps", 1, "rr=3", "env"},      {"samples", 2, "rr=3", "env"},
                {"samples", 1, "rr=30", "env"}, {"samples", 1, "rr=3", "other"},
                {"samples", 1, "rr=3e", "nv"}, /* the border between two parts counts */
            };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        identity(other, row[i].study, row[i].hash, "a.yaml", row[i].parameters, row[i].environment);
        assert_string_not_equal(base, other);
    }
}

static void test_find(void **state)
{
    (void)state;
    struct rl_run run = {0};
    struct rl_place here = {"samples", "here", "here.yaml", 1}, there = {"samples", "there", "there.yaml", 2};
    for (int n = 1; n <= 4; n *= 2) {
        assert_non_null(rl_run_add(&run, &here, n, NULL, "samples=%d rr=%g", n, 30.0));
        assert_non_null(rl_run_add(&run, &there, n, NULL, "samples=%d rr=%g", n, 30.0));
    }
    assert_null(rl_run_find(&run, NULL, "samples=2")); /* planned is not measured */
    for (size_t i = 0; i < run.n_records; i++)
        run.record[i].status = RL_RECORD_OK;
    run.record[2].status = RL_RECORD_FAILED; /* here, 2 */
    assert_null(rl_run_find(&run, "here", "samples=2"));
    const struct rl_record *r = rl_run_find(&run, "there", "samples=2");
    assert_ptr_equal(r, &run.record[3]);
    assert_ptr_equal(rl_run_next(&run, r, "there", "rr=30"), &run.record[5]);
    assert_null(rl_run_next(&run, &run.record[5], "there", "rr=30"));
    assert_int_equal(rl_run_count(&run, RL_RECORD_OK), 5);
    rl_run_clear(&run);
}

static void test_too_long(void **state)
{
    (void)state;
    struct rl_run run = {0};
    struct rl_place place = {"samples", "s", "s.yaml", 1};
    struct rl_error error;
    assert_null(rl_run_add(&run, &place, 0, &error, "%0500d", 1));
    assert_int_equal(error.status, RL_ERR_INPUT);
    assert_int_equal(run.n_records, 0);
    rl_run_clear(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_parameters),
        cmocka_unit_test(test_identity),
        cmocka_unit_test(test_find),
        cmocka_unit_test(test_too_long),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
