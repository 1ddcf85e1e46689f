/* Databases of one plan of cases, by what of it each has measured; file 0 is what the others are merged into. Include after cmocka.h. */
#ifndef RL_TESTS_RESULTS_MERGE_FILES_H
#define RL_TESTS_RESULTS_MERGE_FILES_H

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

static inline void fill(struct rl_run *run, const struct file *f)
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
static inline void make(int i, const struct file *f)
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
static inline int merge(int n, bool allow_mixed, struct rl_merge_outcome *outcome, struct rl_error *error)
{
    const char *from[PATHS];
    for (int i = 0; i < n; i++)
        from[i] = path[i + 1];
    *error = (struct rl_error){0};
    struct rl_merge_options options = {path[0], from, (size_t)n, allow_mixed};
    return rl_database_merge(outcome, &options, error);
}

static inline void load(struct rl_run *run, int i)
{
    struct rl_database *db;
    struct rl_error error = {0};
    check_ok(rl_database_open(&db, path[i], RL_DATABASE_READ, &error), &error);
    check_ok(rl_database_load_run(db, "samples", run, &error), &error);
    rl_database_close(db);
}

/* File 0 holds these cases in the plan's order; 'o' with the value that an undisturbed run has. */
static inline void expect(const char *state, double value)
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
static inline void assert_lines(const struct rl_buffer *buffer, int n, const char *line)
{
    int found = 0;
    for (const char *c = buffer->data; c && *c; c++)
        found += *c == '\n';
    if (found != n || !strstr(buffer->data, line))
        fail_msg("%d lines, expected %d with '%s': %s", found, n, line, buffer->data);
}

static inline void read_file(char **data, size_t *size, int i)
{
    struct rl_error error = {0};
    check_ok(rl_file_read(data, size, path[i], &error), &error);
}

static inline int make_folder(void **state)
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

static inline int remove_folder(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

#endif
