/* Merging databases: shares become a whole; once more changes nothing; what does not belong together is refused and nothing is
 * changed; what is measured twice is compared; a measurement is never lost to a failure. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "base/files.h"
#include "results/database.h"
#include "results/merge.h"
#include "support/check.h"
#include "support/temporary.h"

enum { CASES = 6, PATHS = 8 };

static struct temporary folder;
static char path[PATHS][PATH_MAX];

/* A file with the plan of CASES cases in groups of two; those of `state` are measured ('o': their value is `value` + number), failed
 * ('f') or neither ('.'). */
struct file {
    const char *state, *version, *renderer, *cpu;
    uint64_t scene;
    double value;
    const char *commit, *code; /* NULL: "c0ffee" and this program's */
};

static const struct file plain = {"......", "1.0", "llvmpipe", "a", 7, 0.0, NULL, NULL};

static void fill(struct rl_run *run, const struct file *f)
{
    struct rl_place place = {"samples", "ball", "ball.yaml", f->scene};
    char environment[RL_HASH_TEXT];
    *run = (struct rl_run){.study = "samples", .grid = "quick", .started = "2026-01-31T12:00:00Z"};
    rl_provenance_fill(&run->provenance, 2, "osmesa", f->renderer, "4.5");
    run->provenance.dirty = false;
    snprintf(run->provenance.commit, sizeof run->provenance.commit, "%s", f->commit ? f->commit : "c0ffee");
    if (f->code)
        snprintf(run->provenance.code_hash, sizeof run->provenance.code_hash, "%s", f->code);
    snprintf(run->provenance.version, sizeof run->provenance.version, "%s", f->version);
    snprintf(run->provenance.cpu, sizeof run->provenance.cpu, "%s", f->cpu);
    snprintf(run->provenance.time, sizeof run->provenance.time, "2026-01-31T12:00:0%sZ", f->cpu);
    for (int i = 0; i < CASES; i++)
        assert_non_null(rl_run_add(run, &place, i / 2, NULL, "samples=%d", i));
    rl_provenance_environment(&run->provenance, environment);
    rl_run_identify(run, environment);
}

/* Writes file number `i`, anew. */
static void make(int i, const struct file *f)
{
    struct rl_run run;
    struct rl_database *db;
    struct rl_error error = {0};
    fill(&run, f);
    remove(path[i]);
    check_ok(rl_database_open(&db, path[i], RL_DATABASE_WRITE, &error), &error);
    check_ok(rl_database_begin_run(db, &run, &error), &error);
    for (int k = 0; k < CASES; k++) {
        struct rl_record *r = &run.record[k];
        if (f->state[k] == '.')
            continue;
        r->status = f->state[k] == 'o' ? RL_RECORD_OK : RL_RECORD_FAILED;
        snprintf(r->message, sizeof r->message, "%s", f->state[k] == 'o' ? "" : "out of luck");
        if (f->state[k] == 'o') {
            double raw[] = {i, k};
            rl_record_metric_add(r, "rmse", f->value + k, NAN, 1.0, "1", NULL);
            rl_record_metric_add(r, "frame_ms", i, i, i, "ms", NULL); /* times agree in no two files */
            rl_record_series_add(r, "frame_ms", raw, 2, NULL);
        }
        check_ok(rl_database_store(db, &run, (size_t)k, 1, &error), &error);
    }
    rl_database_close(db);
    rl_run_clear(&run);
}

/* Merges files 1..n into file 0. */
static int merge(int n, bool allow_mixed, struct rl_merge_outcome *outcome, struct rl_error *error)
{
    const char *from[PATHS];
    for (int i = 0; i < n; i++)
        from[i] = path[i + 1];
    *error = (struct rl_error){0};
    struct rl_merge_options options = {path[0], from, (size_t)n, allow_mixed};
    return rl_database_merge(outcome, &options, error);
}

static void load(struct rl_run *run, int i)
{
    struct rl_database *db;
    struct rl_error error = {0};
    check_ok(rl_database_open(&db, path[i], RL_DATABASE_READ, &error), &error);
    check_ok(rl_database_load_run(db, "samples", run, &error), &error);
    rl_database_close(db);
}

/* File 0 holds these cases in the plan's order; 'o' with the value that an undisturbed run has. */
static void expect(const char *state, double value)
{
    struct rl_run run;
    load(&run, 0);
    assert_int_equal(run.n_records, strlen(state));
    for (size_t i = 0; i < run.n_records; i++) {
        const struct rl_record *r = &run.record[i];
        char parameters[32];
        snprintf(parameters, sizeof parameters, "samples=%zu", i);
        assert_string_equal(r->parameters, parameters);
        assert_int_equal(r->group, (int)i / 2);
        assert_int_equal(r->status, state[i] == 'o'   ? RL_RECORD_OK
                                    : state[i] == 'f' ? RL_RECORD_FAILED
                                                      : RL_RECORD_PLANNED);
        if (state[i] != 'o')
            continue;
        const struct rl_metric *m = rl_record_metric(r, "rmse");
        assert_true(m && m->value == value + (double)i && isnan(m->low) && m->high == 1.0);
        const struct rl_series *s = rl_record_series(r, "frame_ms");
        assert_true(s && s->n == 2 && s->value[1] == (double)i);
    }
    rl_run_clear(&run);
}

/* So many lines, this one among them. */
static void assert_lines(const struct rl_buffer *buffer, int n, const char *line)
{
    int found = 0;
    for (const char *c = buffer->data; c && *c; c++)
        found += *c == '\n';
    if (found != n || !strstr(buffer->data, line))
        fail_msg("%d lines, expected %d with '%s': %s", found, n, line, buffer->data);
}

static void read_file(char **data, size_t *size, int i)
{
    struct rl_error error = {0};
    check_ok(rl_file_read(data, size, path[i], &error), &error);
}

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

static int make_folder(void **state)
{
    (void)state;
    temporary_make(&folder);
    for (int i = 0; i < PATHS; i++) {
        char name[16];
        snprintf(name, sizeof name, "%d.db", i);
        temporary_path(&folder, path[i], name);
    }
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shares),
        cmocka_unit_test(test_other_machines),
        cmocka_unit_test(test_failures_and_twice),
        cmocka_unit_test(test_mixed),
        cmocka_unit_test(test_other_commit),
        cmocka_unit_test(test_many_twice),
        cmocka_unit_test(test_bad_files),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
