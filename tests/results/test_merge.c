/* Merging databases: shares of one run in any order give the whole; what is there already, fails or differs is named. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "results/merge_files.h"

static void test_shares(void **state)
{
    (void)state;
    struct rl_merge_outcome o;
    struct rl_error error;
    struct file f = plain;
    const char *share[] = {"oo....", "....oo", "..of.."};
    remove(path[0]);
    for (int i = 0; i < 3; i++) {
        f.state = share[i];
        make(i + 1, &f);
    }
    check_ok(merge(2, false, &o, &error), &error);
    assert_true(o.copied == 4 && o.known == 0 && o.differing == 0);
    rl_merge_outcome_clear(&o);
    expect("oo..oo", 0.0);
    check_ok(merge(3, false, &o, &error), &error);
    assert_true(o.copied == 2 && o.known == 4 && o.differing == 0 && o.agreeing == 4);
    assert_lines(&o.agreements, 4, "1.db: there already, with the same results: samples ball samples=0\n");
    assert_lines(&o.agreements, 4, "2.db: there already, with the same results: samples ball samples=5\n");
    rl_merge_outcome_clear(&o);
    expect("ooofoo", 0.0);

    char *before, *after;
    size_t size, size_after;
    read_file(&before, &size, 0);
    check_ok(merge(3, false, &o, &error), &error);
    assert_true(o.copied == 0 && o.known == 6 && o.differing == 0);
    assert_int_equal(o.agreeing, 5); /* what failed both times was not measured twice */
    assert_lines(&o.agreements, 5, "3.db: there already, with the same results: samples ball samples=2\n");
    rl_merge_outcome_clear(&o);
    read_file(&after, &size_after, 0);
    assert_int_equal(size, size_after);
    assert_memory_equal(before, after, size); /* not a byte */
    free(before);
    free(after);

    struct rl_run run; /* where each was measured goes with it */
    load(&run, 0);
    assert_string_equal(run.provenance.cpu, "a");
    assert_string_equal(run.grid, "quick");
    assert_string_equal(run.started, "2026-01-31T12:00:00Z");
    assert_string_equal(run.record[3].message, "out of luck");
    rl_run_clear(&run);
}

/* Other processors give their cases other identities: the plan takes them up. */
static void test_other_machines(void **state)
{
    (void)state;
    struct rl_merge_outcome o;
    struct rl_error error;
    struct file f = plain;
    remove(path[0]);
    f.state = "oo....";
    make(1, &f);
    f.cpu = "b";
    f.state = "..oooo";
    make(2, &f);
    check_ok(merge(2, false, &o, &error), &error);
    assert_true(o.copied == 6 && o.differing == 0);
    rl_merge_outcome_clear(&o);
    expect("oooooo", 0.0);
    check_ok(merge(2, false, &o, &error), &error);
    assert_true(o.copied == 0 && o.known == 6);
    rl_merge_outcome_clear(&o);
    /* A result merged is a file like any other. */
    rename(path[0], path[3]);
    struct rl_merge_options options = {path[0], (const char *[]){path[3]}, 1, false};
    check_ok(rl_database_merge(&o, &options, &error), &error);
    assert_true(o.copied == 6);
    rl_merge_outcome_clear(&o);
    expect("oooooo", 0.0);
}

static void test_failures_and_twice(void **state)
{
    (void)state;
    struct rl_merge_outcome o;
    struct rl_error error;
    struct file f = plain;
    remove(path[0]);
    f.state = "fof.oo";
    make(1, &f);
    f.state = "offo..";
    make(2, &f);
    check_ok(merge(2, false, &o, &error), &error);
    assert_int_equal(o.differing, 0);
    rl_merge_outcome_clear(&o);
    expect("oofooo", 0.0); /* measured wins over failed, whichever came first */

    f.state = "oooooo";
    f.value = 0.25;
    make(1, &f);
    check_ok(merge(1, false, &o, &error), &error);
    assert_true(o.copied == 1 && o.known == 5 && o.differing == 5 && o.agreeing == 0);
    assert_non_null(strstr(
        o.notes.data, "1.db: different results: samples ball samples=4: rmse is 4.25 there, kept is 4\n"));
    rl_merge_outcome_clear(&o);
    struct rl_run run;
    load(&run, 0);
    assert_true(rl_record_metric(&run.record[0], "rmse")->value == 0.0);
    assert_true(rl_record_metric(&run.record[2], "rmse")->value == 2.25);
    rl_run_clear(&run);
    /* On another processor the last digits may be others. */
    f.cpu = "b";
    f.value = 1e-9;
    f.state = ".o....";
    make(1, &f);
    check_ok(merge(1, false, &o, &error), &error);
    assert_int_equal(o.differing, 0);
    rl_merge_outcome_clear(&o);
}

/* Of many cases that are there already a few are named, and the rest counted. */
static void test_many_twice(void **state)
{
    (void)state;
    enum { MERGED = 5 }; /* times CASES: more than are named */
    struct rl_merge_outcome o;
    struct rl_error error;
    struct file f = plain;
    remove(path[0]);
    f.state = "oooooo";
    for (int i = 1; i <= MERGED; i++)
        make(i, &f);
    check_ok(merge(MERGED, false, &o, &error), &error);
    assert_true(o.copied == CASES && o.agreeing == (size_t)(MERGED - 1) * CASES && o.differing == 0);
    assert_true(o.agreeing > RL_MERGE_NAMED);
    assert_lines(&o.agreements, RL_MERGE_NAMED,
                 "2.db: there already, with the same results: samples ball samples=0\n");
    rl_merge_outcome_clear(&o);
}

/* Another commit of the same sources is the same program; so it has the same identities. */
static void test_other_commit(void **state)
{
    (void)state;
    struct rl_merge_outcome o;
    struct rl_error error;
    struct file f = plain;
    remove(path[0]);
    f.state = "ooo...";
    make(1, &f);
    f.state = "..oooo";
    f.commit = "decade";
    make(2, &f);
    check_ok(merge(2, false, &o, &error), &error);
    assert_true(o.copied == 6 && o.known == 1 && o.differing == 0);
    rl_merge_outcome_clear(&o);
    expect("oooooo", 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shares),
        cmocka_unit_test(test_other_machines),
        cmocka_unit_test(test_failures_and_twice),
        cmocka_unit_test(test_other_commit),
        cmocka_unit_test(test_many_twice),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
