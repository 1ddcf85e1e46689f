/* What comes out of the results database: the latest run of a study, whole (see database.h). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "results/database.h"
#include "results/sql.h"

static void read_provenance(sqlite3_stmt *s, int column, struct rl_provenance *p)
{
    rl_sql_text(s, column + 0, p->version, sizeof p->version);
    rl_sql_text(s, column + 1, p->commit, sizeof p->commit);
    p->dirty = sqlite3_column_int(s, column + 2) != 0;
    rl_sql_text(s, column + 3, p->code_hash, sizeof p->code_hash);
    rl_sql_text(s, column + 4, p->compiler, sizeof p->compiler);
    rl_sql_text(s, column + 5, p->cflags, sizeof p->cflags);
    rl_sql_text(s, column + 6, p->cpu, sizeof p->cpu);
    p->threads = sqlite3_column_int(s, column + 7);
    rl_sql_text(s, column + 8, p->backend, sizeof p->backend);
    rl_sql_text(s, column + 9, p->renderer, sizeof p->renderer);
    rl_sql_text(s, column + 10, p->gl_version, sizeof p->gl_version);
    rl_sql_text(s, column + 11, p->os, sizeof p->os);
    rl_sql_text(s, column + 12, p->time, sizeof p->time);
}

/* The latest run's row number, or 0 if the study was never run. */
static int find_run(struct rl_database *db, struct rl_run *run, int64_t *id, struct rl_error *error)
{
    sqlite3_stmt *s = NULL;
    int status = rl_sql_prepare(
        db, &s, error,
        "SELECT runs.id, grid, started, version, commit_id, dirty, code_hash, compiler, cflags, cpu,"
        " threads, backend, renderer, gl_version, os, time FROM runs"
        " JOIN provenance ON provenance.id = runs.provenance"
        " WHERE study = ? ORDER BY runs.id DESC LIMIT 1",
        "t", run->study);
    if (status != RL_OK)
        return status;
    *id = 0;
    status = rl_sql_row(db, s, error);
    if (status > 0) {
        *id = sqlite3_column_int64(s, 0);
        rl_sql_text(s, 1, run->grid, sizeof run->grid);
        rl_sql_text(s, 2, run->started, sizeof run->started);
        read_provenance(s, 3, &run->provenance);
    }
    sqlite3_finalize(s);
    return status < 0 ? status : RL_OK;
}

static int read_metrics(struct rl_database *db, struct rl_record *r, int64_t id, struct rl_error *error)
{
    sqlite3_stmt *s = NULL;
    int status = rl_sql_prepare(
        db, &s, error, "SELECT name, value, low, high, unit FROM metrics WHERE case_id = ? ORDER BY position",
        "i", id);
    if (status != RL_OK)
        return status;
    while ((status = rl_sql_row(db, s, error)) > 0) {
        char name[RL_NAME_MAX], unit[RL_NAME_MAX];
        rl_sql_text(s, 0, name, sizeof name);
        rl_sql_text(s, 4, unit, sizeof unit);
        const struct rl_sql_place place = {"metrics", id, name, -1};
        double figure[3];
        for (int i = 0; i < 3 && status >= RL_OK; i++)
            status = rl_sql_real(db, s, 1 + i, &figure[i], &place, error);
        if (status == RL_OK)
            status = rl_record_metric_add(r, name, figure[0], figure[1], figure[2], unit, error);
        if (status != RL_OK)
            break;
    }
    sqlite3_finalize(s);
    return status;
}

/* Rows come ordered by series; each run of rows with one name becomes a series. */
static int read_samples(struct rl_database *db, struct rl_record *r, int64_t id, struct rl_error *error)
{
    sqlite3_stmt *s = NULL;
    int status = rl_sql_prepare(
        db, &s, error,
        "SELECT series, value, position FROM samples WHERE case_id = ? ORDER BY series, position", "i", id);
    if (status != RL_OK)
        return status;
    double *value = NULL;
    size_t n = 0, capacity = 0;
    char name[RL_NAME_MAX] = "", next[RL_NAME_MAX];
    while ((status = rl_sql_row(db, s, error)) > 0) {
        rl_sql_text(s, 0, next, sizeof next);
        if (n > 0 && strcmp(name, next) != 0) {
            status = rl_record_series_add(r, name, value, n, error);
            n = 0;
            if (status != RL_OK)
                break;
        }
        if (n == capacity) {
            capacity = capacity ? 2 * capacity : 64;
            double *grown = realloc(value, capacity * sizeof *grown);
            if (!grown) {
                status = rl_fail_memory(error, "raw figures");
                break;
            }
            value = grown;
        }
        snprintf(name, sizeof name, "%s", next);
        const struct rl_sql_place place = {"samples", id, name, sqlite3_column_int(s, 2)};
        status = rl_sql_real(db, s, 1, &value[n++], &place, error);
        if (status != RL_OK)
            break;
    }
    if (status == RL_OK && n > 0)
        status = rl_record_series_add(r, name, value, n, error);
    free(value);
    sqlite3_finalize(s);
    return status;
}

/* One planned case and, if it has been measured, what came of it. */
static int read_record(struct rl_database *db, sqlite3_stmt *s, struct rl_run *run, struct rl_error *error)
{
    char scene[RL_NAME_MAX], path[RL_SCENE_PATH_MAX], hash[RL_HASH_TEXT], parameters[RL_PARAMETERS_MAX];
    rl_sql_text(s, 2, scene, sizeof scene);
    rl_sql_text(s, 3, path, sizeof path);
    rl_sql_text(s, 4, hash, sizeof hash);
    rl_sql_text(s, 5, parameters, sizeof parameters);
    struct rl_place place = {run->study, scene, path, strtoull(hash, NULL, 16)};
    struct rl_record *r = rl_run_add(run, &place, sqlite3_column_int(s, 0), error, "%s", parameters);
    if (!r)
        return RL_ERR_SYSTEM;
    rl_sql_text(s, 1, r->identity, sizeof r->identity);
    if (sqlite3_column_type(s, 6) == SQLITE_NULL)
        return RL_OK;
    int64_t id = sqlite3_column_int64(s, 6);
    char word[RL_NAME_MAX];
    rl_sql_text(s, 7, word, sizeof word);
    r->status = strcmp(word, "ok") == 0 ? RL_RECORD_OK : RL_RECORD_FAILED;
    rl_sql_text(s, 8, r->message, sizeof r->message);
    const struct rl_sql_place row = {"cases", id, NULL, -1};
    int status = rl_sql_real(db, s, 9, &r->seconds, &row, error);
    if (status == RL_OK)
        status = read_metrics(db, r, id, error);
    return status == RL_OK ? read_samples(db, r, id, error) : status;
}

static int read_records(struct rl_database *db, struct rl_run *run, int64_t id, struct rl_error *error)
{
    sqlite3_stmt *s = NULL;
    int status = rl_sql_prepare(
        db, &s, error,
        "SELECT group_number, p.identity, p.scene, p.scene_path, p.scene_hash, p.parameters, c.id,"
        " status, message, seconds FROM run_cases AS p LEFT JOIN cases AS c"
        " ON c.identity = p.identity WHERE run = ? ORDER BY position",
        "i", id);
    if (status != RL_OK)
        return status;
    while ((status = rl_sql_row(db, s, error)) > 0) {
        status = read_record(db, s, run, error);
        if (status != RL_OK)
            break;
    }
    sqlite3_finalize(s);
    return status;
}

/* In one transaction, so that a run that goes on meanwhile is seen at one moment. */
int rl_database_load_run(struct rl_database *db, const char *study, struct rl_run *run,
                         struct rl_error *error)
{
    *run = (struct rl_run){0};
    snprintf(run->study, sizeof run->study, "%s", study);
    int64_t id = 0;
    int status = rl_sql_script(db, "BEGIN", error);
    if (status != RL_OK)
        return status;
    status = find_run(db, run, &id, error);
    if (status == RL_OK && id > 0)
        status = read_records(db, run, id, error);
    status = rl_sql_end(db, status, error);
    if (status != RL_OK)
        rl_run_clear(run);
    return status;
}

int rl_database_load_times(struct rl_database *db, const char *study, struct rl_run *run,
                           struct rl_error *error)
{
    *run = (struct rl_run){0};
    snprintf(run->study, sizeof run->study, "%s", study);
    sqlite3_stmt *s = NULL;
    int status = rl_sql_prepare(db, &s, error,
                                "SELECT scene, scene_hash, parameters, identity, seconds, id FROM cases"
                                " WHERE study = ? AND status = 'ok' ORDER BY id DESC",
                                "t", study);
    if (status != RL_OK)
        return status;
    while ((status = rl_sql_row(db, s, error)) > 0) {
        char scene[RL_NAME_MAX], hash[RL_HASH_TEXT], parameters[RL_PARAMETERS_MAX];
        rl_sql_text(s, 0, scene, sizeof scene);
        rl_sql_text(s, 1, hash, sizeof hash);
        rl_sql_text(s, 2, parameters, sizeof parameters);
        struct rl_place place = {study, scene, "", strtoull(hash, NULL, 16)};
        struct rl_record *r = rl_run_add(run, &place, 0, error, "%s", parameters);
        if (!r) {
            status = RL_ERR_SYSTEM;
            break;
        }
        rl_sql_text(s, 3, r->identity, sizeof r->identity);
        r->status = RL_RECORD_OK;
        const struct rl_sql_place row = {"cases", sqlite3_column_int64(s, 5), NULL, -1};
        status = rl_sql_real(db, s, 4, &r->seconds, &row, error);
        if (status != RL_OK)
            break;
    }
    sqlite3_finalize(s);
    if (status != RL_OK)
        rl_run_clear(run);
    return status;
}
