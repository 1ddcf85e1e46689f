/* The results database under others' hands: a second writer, a full disk; a writer killed at any moment loses only the case it was
 * writing. */
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
#include "results/database_file.h"

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
        cmocka_unit_test(test_one_writer),
        cmocka_unit_test(test_disk_full),
        cmocka_unit_test(test_killed),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
