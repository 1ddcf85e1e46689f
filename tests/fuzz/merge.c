/* Databases of results: the input is the bytes of one. It is merged into nothing, once more into what came of that, into a sound database,
 * and a sound one is merged into it. */
#include <math.h>

#include "base/files.h"
#include "fuzz/harness.h"
#include "fuzz/merge_mutate.h"
#include "results/database.h"
#include "results/merge.h"

enum { CASES = 4 };

/* A database of a study that seeds have, too: two cases measured, one failed, one planned. Nothing in it is of this machine or program, so
 * that an input does the same everywhere. */
static void make_sound(const char *path)
{
    struct rl_run run = {.study = "samples", .grid = "quick", .started = "2026-01-31T12:00:00Z"};
    run.provenance = (struct rl_provenance){.version = "1.0",
                                            .commit = "c0ffee",
                                            .code_hash = "0123456789abcdef",
                                            .compiler = "cc",
                                            .cflags = "-O2",
                                            .cpu = "cpu",
                                            .os = "os",
                                            .threads = 2,
                                            .backend = "osmesa",
                                            .renderer = "llvmpipe",
                                            .gl_version = "4.5",
                                            .time = "2026-01-31T12:00:00Z"};
    struct rl_place place = {"samples", "ball", "ball.yaml", 7};
    char environment[RL_HASH_TEXT];
    struct rl_database *db;
    struct rl_error error = {0};
    const double raw[] = {1.0, 2.0, 3.0};
    for (int i = 0; i < CASES; i++)
        FUZZ_CHECK(rl_run_add(&run, &place, i / 2, &error, "samples=%d", i));
    rl_provenance_environment(&run.provenance, environment);
    rl_run_identify(&run, environment);
    FUZZ_CHECK(rl_database_open(&db, path, RL_DATABASE_WRITE, &error) == RL_OK);
    FUZZ_CHECK(rl_database_begin_run(db, &run, &error) == RL_OK);
    for (size_t i = 0; i < CASES - 1; i++) {
        struct rl_record *r = &run.record[i];
        r->status = i < CASES - 2 ? RL_RECORD_OK : RL_RECORD_FAILED;
        snprintf(r->message, sizeof r->message, "%s", r->status == RL_RECORD_OK ? "" : "out of luck");
        if (r->status == RL_RECORD_OK) {
            FUZZ_CHECK(rl_record_metric_add(r, "rmse", (double)i, NAN, 1.0, "1", &error) == RL_OK);
            FUZZ_CHECK(rl_record_series_add(r, "frame_ms", raw, 3, &error) == RL_OK);
        }
        FUZZ_CHECK(rl_database_store(db, &run, i, 1, &error) == RL_OK);
    }
    rl_database_close(db);
    rl_run_clear(&run);
}

static void check_outcome(int status, const struct rl_error *error, const struct rl_merge_outcome *outcome)
{
    fuzz_check_error(status, error);
    for (const char *c = outcome->notes.data; status == RL_OK && c && *c; c++)
        FUZZ_CHECK((unsigned char)*c >= ' ' || *c == '\n');
}

static int merge(const char *into, const char *from, bool allow_mixed, size_t *copied)
{
    struct rl_merge_options options = {.into = into, .from = &from, .n_from = 1, .allow_mixed = allow_mixed};
    struct rl_merge_outcome outcome;
    struct rl_error error = {0};
    int status = rl_database_merge(&outcome, &options, &error);
    check_outcome(status, &error, &outcome);
    *copied = outcome.copied;
    rl_merge_outcome_clear(&outcome);
    return status;
}

/* What a sound database became is read as any study would read it. */
static void check_readable(const char *path)
{
    struct rl_database *db;
    struct rl_run run;
    struct rl_error error = {0};
    FUZZ_CHECK(rl_database_open(&db, path, RL_DATABASE_READ, &error) == RL_OK);
    int status = rl_database_load_run(db, "samples", &run, &error);
    fuzz_check_error(status, &error);
    FUZZ_CHECK(status == RL_OK && run.n_records >= CASES);
    rl_run_clear(&run);
    rl_database_close(db);
}

static void copy(const char *to, const char *from)
{
    char *data;
    size_t size;
    FUZZ_CHECK(rl_file_read(&data, &size, from, NULL) == RL_OK);
    fuzz_write(to, data, size);
    free(data);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static char sound[PATH_MAX], input[PATH_MAX], all[PATH_MAX];
    size_t copied;
    if (!sound[0]) {
        fuzz_path(input, "input.db");
        fuzz_path(all, "all.db");
        make_sound(fuzz_path(sound, "sound.db"));
    }
    fuzz_write(input, data, size);
    remove(all);
    if (merge(all, input, false, &copied) == RL_OK) {
        FUZZ_CHECK(merge(all, input, false, &copied) == RL_OK);
        FUZZ_CHECK(copied == 0); /* merging once more changes nothing */
    }
    copy(all, sound);
    merge(all, input, true, &copied);
    check_readable(all);
    merge(input, sound, true, &copied);
    return 0;
}
