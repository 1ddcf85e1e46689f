/* Merging databases: what was measured by another program, renderer or on another scene is refused unless told, and broken files are
 * named. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <sqlite3.h>
#include <cmocka.h>

#include "results/merge_files.h"

static void test_mixed(void **state)
{
    (void)state;
    static const struct {
        struct file file;
        const char *words;
    } row[] = {
        {{"..oo..", "2.0", "llvmpipe", "a", 7, 0.0, NULL, NULL},
         "2.db: study samples: found version 2.0, expected 1.0 as in "},
        {{"..oo..", "1.0", "radeon", "a", 7, 0.0, NULL, NULL}, "found renderer radeon, expected llvmpipe"},
        {{"..oo..", "1.0", "llvmpipe", "a", 8, 0.0, NULL, NULL},
         "found scene ball 0000000000000008, expected 0000000000000007"},
        {{"..oo..", "1.0", "llvmpipe", "a", 7, 0.0, "decade", "0123456789abcdef"},
         "found code 0123456789abcdef (commit decade), expected "},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_merge_outcome o;
        struct rl_error error;
        struct file f = plain;
        f.state = "oo....";
        remove(path[0]);
        make(1, &f);
        make(2, &row[i].file);
        check_fails(merge(2, false, &o, &error), &error, RL_ERR_INPUT, row[i].words);
        rl_merge_outcome_clear(&o);
        struct stat info;
        assert_int_not_equal(stat(path[0], &info), 0); /* nothing was begun */
        check_ok(merge(1, false, &o, &error), &error);
        rl_merge_outcome_clear(&o);
        rename(path[2], path[1]);
        check_fails(merge(1, false, &o, &error), &error, RL_ERR_INPUT,
                    row[i].words + (i ? 0 : 5)); /* INTO counts */
        rl_merge_outcome_clear(&o);
        expect("oo....", 0.0);
        check_ok(merge(1, true, &o, &error), &error);
        assert_int_equal(o.copied, 2);
        rl_merge_outcome_clear(&o);
        struct rl_run run;
        load(&run, 0);
        assert_int_equal(rl_run_count(&run, RL_RECORD_OK), 4);
        /* Another scene's cases are cases of their own. */
        assert_int_equal(run.n_records, row[i].file.scene == 7 ? CASES : 2 * CASES);
        assert_int_equal(run.record[run.n_records - 1].group, (int)run.n_records / 2 - 1);
        rl_run_clear(&run);
    }
}

static void test_bad_files(void **state)
{
    (void)state;
    struct rl_merge_outcome o;
    struct rl_error error;
    struct file f = plain;
    f.state = "oo....";
    remove(path[0]);
    make(1, &f);
    remove(path[2]);
    check_fails(merge(2, false, &o, &error), &error, RL_ERR_INPUT, "2.db: cannot open: No such file");
    check_ok(rl_file_write(path[2], "not a database", 14, &error), &error);
    check_fails(merge(2, true, &o, &error), &error, RL_ERR_INPUT, "2.db: not an SQLite database");
    struct rl_merge_options same = {path[1], (const char *[]){path[1]}, 1, false};
    check_fails(rl_database_merge(&o, &same, &error), &error, RL_ERR_INPUT, "the same file as");
    struct rl_merge_options twice = {path[0], (const char *[]){path[1], path[1]}, 2, false};
    check_fails(rl_database_merge(&o, &twice, &error), &error, RL_ERR_INPUT, "the same file as");
    struct stat info;
    assert_int_not_equal(stat(path[0], &info), 0);

    struct rl_database *db; /* a file that is being written to: after its writer */
    check_ok(merge(1, false, &o, &error), &error);
    rl_merge_outcome_clear(&o);
    check_ok(rl_database_open(&db, path[0], RL_DATABASE_WRITE, &error), &error);
    check_fails(merge(1, false, &o, &error), &error, RL_ERR_SYSTEM, "another run of roughlight");
    rl_database_close(db);
    check_ok(rl_database_open(&db, path[1], RL_DATABASE_WRITE, &error), &error);
    check_ok(merge(1, false, &o, &error), &error); /* reading is no harm */
    rl_merge_outcome_clear(&o);
    rl_database_close(db);
    expect("oo....", 0.0);
}

/* Groups of the other file get the numbers behind those that are there, as far as there are numbers. */
static void test_group_numbers(void **state)
{
    (void)state;
    struct rl_merge_outcome o;
    struct rl_error error;
    struct file last = plain, other = plain;
    sqlite3 *raw = NULL;
    last.state = other.state = "oo....";
    other.scene = 8; /* cases of their own */
    remove(path[0]);
    make(1, &last);
    make(2, &other);
    sqlite3_open(path[1], &raw);
    assert_int_equal(sqlite3_exec(raw, "UPDATE run_cases SET group_number = 2147483647", NULL, NULL, NULL),
                     0);
    sqlite3_close(raw);
    for (int again = 0; again < 2; again++) {
        check_ok(merge(1, false, &o, &error), &error);
        rl_merge_outcome_clear(&o);
    }
    check_fails(
        merge(2, true, &o, &error), &error, RL_ERR_INPUT,
        "2.db: study samples: found group 0 to be added to 2147483648 others, expected to count up to "
        "2147483647");
    rl_merge_outcome_clear(&o);
    struct rl_run run;
    load(&run, 0);
    assert_int_equal(run.n_records, CASES);
    rl_run_clear(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_mixed),
        cmocka_unit_test(test_bad_files),
        cmocka_unit_test(test_group_numbers),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
