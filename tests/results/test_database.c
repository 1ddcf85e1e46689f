/* The results database: what goes in comes out; every broken file is named. */
#include <fcntl.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

#include <sqlite3.h>
#include <cmocka.h>

#include "base/files.h"
#include "results/database_file.h"

static void test_round_trip(void **state)
{
    (void)state;
    char path[PATH_MAX];
    temporary_path(&folder, path, "deep/er/results.db"); /* folders are made */
    struct rl_run run, back;
    make_run(&run, 4, "env");
    struct rl_database *db = must_open(path, RL_DATABASE_WRITE);
    assert_int_equal(rl_database_begin_run(db, &run, NULL), RL_OK);

    double raw[] = {3.25, 1e-300, -1.0 / 3.0, 0.1};
    struct rl_record *r = &run.record[1];
    rl_record_metric_add(r, "rmse", 0.1, NAN, INFINITY, "1", NULL);
    rl_record_metric_add(r, "frame_ms", 8.5, 8.25, 8.75, "ms", NULL);
    rl_record_series_add(r, "later", raw, 4, NULL);
    rl_record_series_add(r, "earlier", raw + 1, 2, NULL);
    r->status = RL_RECORD_OK;
    r->seconds = 1.5;
    run.record[0].status = RL_RECORD_FAILED;
    snprintf(run.record[0].message, sizeof run.record[0].message,
             "shader: it's \"broken\"; DROP TABLE cases");
    assert_int_equal(rl_database_store(db, &run, 0, 2, NULL), RL_OK);
    rl_database_close(db);

    db = must_open(path, RL_DATABASE_READ);
    assert_int_equal(rl_database_load_run(db, "samples", &back, NULL), RL_OK);
    assert_int_equal(back.n_records, 4);
    assert_string_equal(back.grid, "quick");
    assert_string_equal(back.started, "2026-01-31T12:00:00Z");
    assert_memory_equal(back.provenance.code_hash, run.provenance.code_hash, RL_HASH_TEXT);
    assert_string_equal(back.provenance.renderer, "llvmpipe");
    assert_int_equal(back.provenance.threads, 2);
    assert_int_equal(back.record[0].status, RL_RECORD_FAILED);
    assert_string_equal(back.record[0].message, run.record[0].message);
    assert_int_equal(back.record[2].status, RL_RECORD_PLANNED);
    const struct rl_record *b = &back.record[1];
    assert_int_equal(b->status, RL_RECORD_OK);
    assert_string_equal(b->identity, r->identity);
    assert_string_equal(b->parameters, "method=random samples=2");
    assert_string_equal(b->scene, "teapot-star");
    assert_string_equal(b->scene_path, "studies/scenes/teapot-star.yaml");
    assert_string_equal(b->scene_hash, "0000000000001234");
    assert_int_equal(b->group, 0);
    assert_true(b->seconds == 1.5);
    const struct rl_metric *m = rl_record_metric(b, "rmse");
    assert_true(m && m->value == 0.1 && isnan(m->low) && isinf(m->high));
    assert_string_equal(rl_record_metric(b, "frame_ms")->unit, "ms");
    const struct rl_series *s = rl_record_series(b, "later");
    assert_true(s && s->n == 4);
    assert_memory_equal(s->value, raw, sizeof raw); /* bit for bit */
    assert_int_equal(rl_record_series(b, "earlier")->n, 2);
    rl_run_clear(&back);
    assert_int_equal(rl_database_load_run(db, "fps", &back, NULL), RL_OK);
    assert_int_equal(back.n_records, 0);
    rl_run_clear(&back);
    rl_run_clear(&run);
    rl_database_close(db);
}

static void test_done_and_replace(void **state)
{
    (void)state;
    char path[PATH_MAX];
    temporary_path(&folder, path, "done.db");
    struct rl_run run, other, back;
    make_run(&run, 2, "env");
    make_run(&other, 2, "another environment");
    struct rl_database *db = must_open(path, RL_DATABASE_WRITE);
    rl_database_begin_run(db, &run, NULL);
    enum rl_record_status done = RL_RECORD_OK;
    rl_database_state(db, run.record[0].identity, &done, NULL);
    assert_int_equal(done, RL_RECORD_PLANNED);
    run.record[0].status = RL_RECORD_FAILED;
    rl_database_store(db, &run, 0, 1, NULL);
    rl_database_state(db, run.record[0].identity, &done, NULL);
    assert_int_equal(done, RL_RECORD_FAILED);
    measure(&run.record[0], 0);
    assert_int_equal(rl_database_store(db, &run, 0, 1, NULL),
                     RL_OK); /* replaces the failed one and its figures */
    rl_database_state(db, run.record[0].identity, &done, NULL);
    assert_int_equal(done, RL_RECORD_OK);
    rl_database_state(db, other.record[0].identity, &done, NULL);
    assert_int_equal(done, RL_RECORD_PLANNED); /* measured elsewhere is not measured here */

    /* A second run of the same cases finds them; the latest run is what is loaded. */
    snprintf(run.grid, sizeof run.grid, "full");
    rl_database_begin_run(db, &run, NULL);
    assert_int_equal(rl_database_load_run(db, "samples", &back, NULL), RL_OK);
    assert_string_equal(back.grid, "full");
    assert_int_equal(back.record[0].status, RL_RECORD_OK);
    assert_int_equal(back.record[0].n_metrics, METRICS);
    assert_int_equal(back.record[1].status, RL_RECORD_PLANNED);
    rl_run_clear(&back);
    rl_run_clear(&run);
    rl_run_clear(&other);
    rl_database_close(db);
}

static void test_bad_files(void **state)
{
    (void)state;
    char path[PATH_MAX];
    temporary_path(&folder, path, "missing.db");
    refused(path, RL_DATABASE_READ, "No such file");

    temporary_path(&folder, path, "text.db");
    rl_file_write(path, "claim\tverdict\n", 14, NULL);
    refused(path, RL_DATABASE_WRITE, "not an SQLite database");
    refused(path, RL_DATABASE_READ, "not an SQLite database");

    temporary_path(&folder, path, "empty.db");
    rl_file_write(path, "", 0, NULL);
    refused(path, RL_DATABASE_READ, "holds no results yet");

    refused(folder.folder, RL_DATABASE_WRITE, "directory");
    refused("/proc/results.db", RL_DATABASE_WRITE, "cannot open for writing");
    refused("/dev/null", RL_DATABASE_WRITE, "not a regular file");

    temporary_path(&folder, path, "foreign.db");
    sqlite3 *raw = NULL;
    sqlite3_open(path, &raw);
    sqlite3_exec(raw, "CREATE TABLE cats(name)", NULL, NULL, NULL);
    sqlite3_close(raw);
    refused(path, RL_DATABASE_WRITE, "not one of roughlight's");

    temporary_path(&folder, path, "newer.db");
    rl_database_close(must_open(path, RL_DATABASE_WRITE));
    sqlite3_open(path, &raw);
    sqlite3_exec(raw, "PRAGMA user_version = 99", NULL, NULL, NULL);
    sqlite3_close(raw);
    refused(path, RL_DATABASE_WRITE, "tables of version 99");
}

static void test_damaged(void **state)
{
    (void)state;
    char path[PATH_MAX];
    temporary_path(&folder, path, "damaged.db");
    struct rl_run run;
    make_run(&run, 40, "env");
    struct rl_database *db = must_open(path, RL_DATABASE_WRITE);
    rl_database_begin_run(db, &run, NULL);
    rl_database_close(db);
    rl_run_clear(&run);
    int file = open(path, O_RDWR | O_CLOEXEC);
    char noise[8192];
    memset(noise, 0x5a, sizeof noise);
    assert_int_equal(pwrite(file, noise, sizeof noise, 4096), (ssize_t)sizeof noise); /* pages 2 and 3 */
    close(file);
    refused(path, RL_DATABASE_READ, "damaged");
    refused(path, RL_DATABASE_WRITE, "damaged");
}

/* SQLite takes a text into a column of numbers, and would read it as 0. */
static void test_text_for_number(void **state)
{
    (void)state;
    static const struct {
        const char *change, *words;
    } row[] = {
        {"UPDATE metrics SET value = 'abc' WHERE name = 'rmse'",
         "damaged: table metrics, column value, row of case 1, metric rmse: found the text 'abc', expected a "
         "number"},
        {"UPDATE metrics SET low = '1e' WHERE name = 'bias'",
         "table metrics, column low, row of case 1, metric bias: found the text '1e'"},
        {"UPDATE metrics SET high = x'00' WHERE name = 'frame_ms'",
         "table metrics, column high, row of case 1, metric frame_ms: found bytes"},
        {"UPDATE samples SET value = 'a\nb' WHERE position = 7",
         "table samples, column value, row of case 1, series frame_ms, position 7: found the text 'a?b'"},
        {"UPDATE cases SET seconds = ''", "table cases, column seconds, row of case 1: found the text ''"},
        {"UPDATE metrics SET value = 3", NULL}, /* a whole number is a number */
        {"UPDATE metrics SET low = NULL", NULL},
    };
    char path[PATH_MAX];
    temporary_path(&folder, path, "text.db");
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_run run, back;
        struct rl_error error = {0};
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
        assert_int_equal(sqlite3_exec(raw, row[i].change, NULL, NULL, NULL), SQLITE_OK);
        sqlite3_close(raw);
        db = must_open(path, RL_DATABASE_READ);
        int status = rl_database_load_run(db, "samples", &back, &error);
        if (row[i].words)
            check_fails(status, &error, RL_ERR_INPUT, row[i].words);
        else
            check_ok(status, &error);
        assert_true(!row[i].words || strstr(error.message, path));
        rl_run_clear(&back);
        bool of_case = row[i].words && strstr(row[i].words, "cases");
        assert_int_equal(rl_database_load_times(db, "samples", &back, &error),
                         of_case ? RL_ERR_INPUT : RL_OK);
        rl_run_clear(&back);
        rl_database_close(db);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip),      cmocka_unit_test(test_done_and_replace),
        cmocka_unit_test(test_bad_files),       cmocka_unit_test(test_damaged),
        cmocka_unit_test(test_text_for_number),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
