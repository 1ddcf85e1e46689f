/* The results database: what goes in comes out; every broken file is named; a writer killed at any moment loses only the case
 * it was writing. */
#include <fcntl.h>
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <sqlite3.h>
#include <cmocka.h>

#include "base/clock.h"
#include "base/files.h"
#include "model/random.h"
#include "results/database.h"
#include "support/check.h"
#include "support/temporary.h"

static struct temporary folder;

static const struct rl_place place = {"samples", "teapot-star", "studies/scenes/teapot-star.yaml", 0x1234};

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

static void make_run(struct rl_run *run, int n, const char *environment)
{
    *run = (struct rl_run){.study = "samples", .grid = "quick", .started = "2026-01-31T12:00:00Z"};
    rl_provenance_fill(&run->provenance, 2, "osmesa", "llvmpipe", "4.5");
    for (int i = 0; i < n; i++)
        assert_non_null(rl_run_add(run, &place, i / 2, NULL, "method=%s samples=%d",
                                   i % 2 ? "random" : "regular", i + 1));
    rl_run_identify(run, environment);
}

static struct rl_database *must_open(const char *path, enum rl_database_mode mode)
{
    struct rl_database *db = NULL;
    struct rl_error error = {0};
    if (rl_database_open(&db, path, mode, &error) != RL_OK)
        fail_msg("%s", error.message);
    return db;
}

/* A value that depends on the case alone: what any undisturbed run would store. */
static double value_of(size_t i, size_t k)
{
    return rl_random_uniform(7, i * 1000 + k);
}

enum { SERIES_LENGTH = 40, METRICS = 3 };

static void measure(struct rl_record *r, size_t i)
{
    static const char *const name[METRICS] = {"rmse", "bias", "frame_ms"};
    double raw[SERIES_LENGTH];
    rl_record_reset(r);
    for (size_t k = 0; k < METRICS; k++)
        assert_int_equal(rl_record_metric_add(r, name[k], value_of(i, k), 0.0, 1.0, "1", NULL), RL_OK);
    for (size_t k = 0; k < SERIES_LENGTH; k++)
        raw[k] = value_of(i, 100 + k);
    assert_int_equal(rl_record_series_add(r, "frame_ms", raw, SERIES_LENGTH, NULL), RL_OK);
    r->status = RL_RECORD_OK;
    r->seconds = 0.5;
}

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

static void refused(const char *path, enum rl_database_mode mode, const char *words)
{
    struct rl_database *db = NULL;
    struct rl_error error = {0};
    assert_int_not_equal(rl_database_open(&db, path, mode, &error), RL_OK);
    assert_null(db);
    if (!strstr(error.message, words) || !strstr(error.message, path) || strchr(error.message, '\n'))
        fail_msg("expected one line with '%s' and '%s', found: %s", path, words, error.message);
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

static void test_one_writer(void **state)
{
    (void)state;
    char path[PATH_MAX];
    temporary_path(&folder, path, "writer.db");
    struct rl_database *db = must_open(path, RL_DATABASE_WRITE);
    refused(path, RL_DATABASE_WRITE, "another run of roughlight");
    struct rl_database *reader = must_open(path, RL_DATABASE_READ); /* one may look on */
    rl_database_close(reader);
    rl_database_close(db);

    sqlite3 *raw = NULL;
    sqlite3_open(path, &raw);
    assert_int_equal(sqlite3_exec(raw, "BEGIN EXCLUSIVE", NULL, NULL, NULL), SQLITE_OK);
    refused(path, RL_DATABASE_WRITE, "locked by another program");
    sqlite3_exec(raw, "ROLLBACK", NULL, NULL, NULL);
    sqlite3_close(raw);
    rl_database_close(must_open(path, RL_DATABASE_WRITE));
}

/* A process that may not let any file grow stands for a full disk: the case is refused, what was there stays. */
static void test_disk_full(void **state)
{
    (void)state;
    char path[PATH_MAX];
    temporary_path(&folder, path, "full.db");
    struct rl_run run;
    make_run(&run, 4, "env");
    struct rl_database *db = must_open(path, RL_DATABASE_WRITE);
    rl_database_begin_run(db, &run, NULL);
    measure(&run.record[0], 0);
    rl_database_store(db, &run, 0, 1, NULL);
    rl_database_close(db);

    pid_t child = fork();
    if (child == 0) {
        signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &(struct rlimit){1024, 1024});
        struct rl_error error = {0};
        int status = rl_database_open(&db, path, RL_DATABASE_WRITE, &error);
        if (status == RL_OK) {
            measure(&run.record[1], 1);
            status = rl_database_begin_run(db, &run, &error);
        }
        _exit(status == RL_ERR_SYSTEM && strstr(error.message, "full.db: cannot") ? 0 : 1);
    }
    int ended = 1;
    waitpid(child, &ended, 0);
    assert_int_equal(ended, 0);

    struct rl_run back;
    db = must_open(path, RL_DATABASE_READ);
    assert_int_equal(rl_database_load_run(db, "samples", &back, NULL), RL_OK);
    assert_int_equal(rl_run_count(&back, RL_RECORD_OK), 1);
    rl_database_close(db);
    rl_run_clear(&back);
    rl_run_clear(&run);
}

enum { KILL_CASES = 60, KILLS = 30 };

/* Opens, plans, and measures whatever is not done, pair by pair, as `study run` does. */
static void run_all(const char *path)
{
    struct rl_run run;
    make_run(&run, KILL_CASES, "env");
    struct rl_database *db = must_open(path, RL_DATABASE_WRITE);
    assert_int_equal(rl_database_begin_run(db, &run, NULL), RL_OK);
    for (size_t i = 0; i < KILL_CASES; i += 2) {
        enum rl_record_status done = RL_RECORD_PLANNED;
        assert_int_equal(rl_database_state(db, run.record[i].identity, &done, NULL), RL_OK);
        if (done == RL_RECORD_OK)
            continue;
        measure(&run.record[i], i);
        measure(&run.record[i + 1], i + 1);
        assert_int_equal(rl_database_store(db, &run, i, 2, NULL), RL_OK);
    }
    rl_database_close(db);
    rl_run_clear(&run);
}

/* Every case is there wholly, with the values an undisturbed run gives, or not at all, and so is its pair. */
static size_t check_cases(const char *path)
{
    struct rl_database *db = must_open(path, RL_DATABASE_READ); /* checks integrity too */
    struct rl_run back;
    assert_int_equal(rl_database_load_run(db, "samples", &back, NULL), RL_OK);
    for (size_t i = 0; i < back.n_records; i++) {
        const struct rl_record *r = &back.record[i];
        assert_int_equal(r->status, back.record[i ^ 1].status);
        if (r->status != RL_RECORD_OK)
            continue;
        assert_int_equal(r->n_metrics, METRICS);
        assert_true(r->metric[0].value == value_of(i, 0) && r->metric[2].value == value_of(i, 2));
        assert_int_equal(r->n_series, 1);
        assert_int_equal(r->series[0].n, SERIES_LENGTH);
        assert_true(r->series[0].value[SERIES_LENGTH - 1] == value_of(i, 100 + SERIES_LENGTH - 1));
    }
    size_t n = rl_run_count(&back, RL_RECORD_OK);
    rl_database_close(db);
    rl_run_clear(&back);
    return n;
}

static void test_killed(void **state)
{
    (void)state;
    uint64_t seed = 20260131;
    print_message("seed %llu\n", (unsigned long long)seed);
    char path[PATH_MAX];
    temporary_path(&folder, path, "undisturbed.db");
    double start = rl_clock_seconds();
    run_all(path);
    double whole_run = rl_clock_seconds() - start;
    temporary_path(&folder, path, "killed.db");
    int in_the_middle = 0;
    for (int i = 0; i < KILLS; i++) {
        pid_t child = fork();
        if (child == 0) {
            run_all(path);
            _exit(0);
        }
        /* From before the tables are made until some cases later. Finished runs are begun again from nothing. */
        long ns = (long)(fmin(0.9, 0.6 * whole_run) * 1e9 * rl_random_uniform(seed, (uint64_t)i));
        nanosleep(&(struct timespec){0, ns}, NULL);
        kill(child, SIGKILL);
        int ended = 0;
        waitpid(child, &ended, 0);
        struct rl_database *db = must_open(path, RL_DATABASE_WRITE);
        rl_database_close(db);
        size_t n = check_cases(path);
        in_the_middle += n > 0 && n < KILL_CASES;
        if (n == KILL_CASES)
            remove(path);
    }
    print_message("whole run %.3f s; %d of %d kills left some cases done and some not\n", whole_run,
                  in_the_middle, KILLS);
    assert_true(in_the_middle > KILLS / 4);
    run_all(path);
    assert_int_equal(check_cases(path), KILL_CASES);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip),      cmocka_unit_test(test_done_and_replace),
        cmocka_unit_test(test_bad_files),       cmocka_unit_test(test_damaged),
        cmocka_unit_test(test_text_for_number), cmocka_unit_test(test_one_writer),
        cmocka_unit_test(test_disk_full),       cmocka_unit_test(test_killed),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
