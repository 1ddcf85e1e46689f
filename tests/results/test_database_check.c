/* Files that SQLite finds in order and that are no results database all the same: each change of a sound one is refused, with what was found
 * and where. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <sqlite3.h>
#include <cmocka.h>

#include "results/database_file.h"

static const struct {
    const char *change, *words; /* NULL: none, the file is as good as before */
} row[] = {
    {"DROP TABLE samples", "damaged: found 5 of 6 tables"},
    {"CREATE TABLE notes(text)",
     "damaged: found the table 'notes', expected the tables that roughlight makes"},
    {"CREATE UNIQUE INDEX one ON runs(study)", "found the index 'one'"},
    {"CREATE TRIGGER again AFTER INSERT ON cases BEGIN DELETE FROM runs; END", "found the trigger 'again'"},
    /* It would never end. */
    {"DROP TABLE runs; CREATE VIEW runs AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n)"
     " SELECT i AS id, 'samples' AS study, '' AS grid, '' AS started, 1 AS provenance FROM n",
     "found the view 'runs'"},
    {"ALTER TABLE cases ADD COLUMN extra", "found the table 'cases'"},
    {"UPDATE cases SET provenance = 7", "table cases: found a row that belongs to none of table provenance"},
    {"UPDATE cases SET id = 7", "found a row that belongs to none of table cases"},
    {"UPDATE run_cases SET scene_hash = '-1'",
     "table run_cases, column scene_hash: found '-1', expected 16 hexadecimal digits"},
    {"UPDATE run_cases SET scene_hash = upper('00000000000000aa')",
     "column scene_hash: found '00000000000000AA'"},
    {"UPDATE cases SET identity = identity || '0'", "table cases, column identity: found '"},
    {"UPDATE cases SET identity = CAST(identity AS BLOB)", "table cases, column identity: found '"},
    {"UPDATE run_cases SET parameters = hex(zeroblob(192))",
     "table run_cases, column parameters: found '00000000000000000000000000000000000000000000000', expected "
     "a "
     "text of "
     "less than 384 bytes"},
    {"UPDATE run_cases SET parameters = substr(hex(zeroblob(192)), 2)", NULL}, /* 383 */
    {"UPDATE metrics SET unit = 'm' || char(0) || 's'", "table metrics, column unit: found 'm'"},
    {"UPDATE runs SET study = 5", NULL}, /* a column of texts makes a text of it */
    {"UPDATE run_cases SET group_number = -1",
     "column group_number: found '-1', expected a whole number from 0 to"},
    {"UPDATE run_cases SET group_number = 2147483648", "column group_number: found '2147483648'"},
    {"UPDATE run_cases SET group_number = 2147483647", NULL},
    {"UPDATE run_cases SET group_number = 0.5", "column group_number: found '0.5'"},
    {"UPDATE cases SET message = 'a' || char(10) || 'b'", NULL},
    {"ANALYZE", NULL},
};

static void make_changed(const char *path, const char *change)
{
    struct rl_run run;
    sqlite3 *raw = NULL;
    remove(path);
    make_run(&run, 1, "env");
    struct rl_database *db = must_open(path, RL_DATABASE_WRITE);
    assert_int_equal(rl_database_begin_run(db, &run, NULL), RL_OK);
    measure(&run.record[0], 0);
    assert_int_equal(rl_database_store(db, &run, 0, 1, NULL), RL_OK);
    rl_database_close(db);
    rl_run_clear(&run);
    sqlite3_open(path, &raw);
    assert_int_equal(sqlite3_exec(raw, change, NULL, NULL, NULL), SQLITE_OK);
    sqlite3_close(raw);
}

static void test_changed(void **state)
{
    (void)state;
    char path[PATH_MAX];
    temporary_path(&folder, path, "changed.db");
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        make_changed(path, row[i].change);
        for (int mode = RL_DATABASE_READ; mode <= RL_DATABASE_WRITE; mode++) {
            struct rl_database *db;
            struct rl_error error = {0};
            int status = rl_database_open(&db, path, (enum rl_database_mode)mode, &error);
            if (row[i].words)
                check_fails(status, &error, RL_ERR_INPUT, row[i].words);
            else
                check_ok(status, &error);
            assert_true(!row[i].words || strstr(error.message, path));
            rl_database_close(db);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_changed),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
