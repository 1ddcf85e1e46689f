/* A results database in a folder of the test's own, and cases whose figures depend on their number alone. Include after cmocka.h. */
#ifndef RL_TESTS_RESULTS_DATABASE_FILE_H
#define RL_TESTS_RESULTS_DATABASE_FILE_H

#include "model/random.h"
#include "results/database.h"
#include "support/check.h"
#include "support/temporary.h"

static struct temporary folder;

static const struct rl_place place = {"samples", "teapot-star", "studies/scenes/teapot-star.yaml", 0x1234};

static inline int make_folder(void **state)
{
    (void)state;
    temporary_make(&folder);
    return 0;
}

static inline int remove_folder(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

static inline void make_run(struct rl_run *run, int n, const char *environment)
{
    *run = (struct rl_run){.study = "samples", .grid = "quick", .started = "2026-01-31T12:00:00Z"};
    rl_provenance_fill(&run->provenance, 2, "osmesa", "llvmpipe", "4.5");
    for (int i = 0; i < n; i++)
        assert_non_null(rl_run_add(run, &place, i / 2, NULL, "method=%s samples=%d",
                                   i % 2 ? "random" : "regular", i + 1));
    rl_run_identify(run, environment);
}

static inline struct rl_database *must_open(const char *path, enum rl_database_mode mode)
{
    struct rl_database *db = NULL;
    struct rl_error error = {0};
    if (rl_database_open(&db, path, mode, &error) != RL_OK)
        fail_msg("%s", error.message);
    return db;
}

/* A value that depends on the case alone: what any undisturbed run would store. */
static inline double value_of(size_t i, size_t k)
{
    return rl_random_uniform(7, i * 1000 + k);
}

enum { SERIES_LENGTH = 40, METRICS = 3 };

static inline void measure(struct rl_record *r, size_t i)
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

static inline void refused(const char *path, enum rl_database_mode mode, const char *words)
{
    struct rl_database *db = NULL;
    struct rl_error error = {0};
    assert_int_not_equal(rl_database_open(&db, path, mode, &error), RL_OK);
    assert_null(db);
    if (!strstr(error.message, words) || !strstr(error.message, path) || strchr(error.message, '\n'))
        fail_msg("expected one line with '%s' and '%s', found: %s", path, words, error.message);
}

#endif
