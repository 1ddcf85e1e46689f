/* What goes into the results database: runs as planned, cases as measured; each in one transaction (see database.h). */
#include <string.h>

#include "results/database.h"
#include "results/sql.h"

static int add_provenance(struct rl_database *db, const struct rl_provenance *p, struct rl_error *error)
{
    char environment[RL_HASH_TEXT];
    rl_provenance_environment(p, environment);
    int status = rl_sql_run(
        db, error,
        "INSERT INTO provenance(environment, version, commit_id, dirty, code_hash, compiler, cflags, cpu,"
        " threads, backend, renderer, gl_version, os, time)"
        " VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        "tttittttittttt", environment, p->version, p->commit, (int64_t)p->dirty, p->code_hash, p->compiler,
        p->cflags, p->cpu, (int64_t)p->threads, p->backend, p->renderer, p->gl_version, p->os, p->time);
    if (status == RL_OK)
        db->provenance = sqlite3_last_insert_rowid(db->handle);
    return status;
}

static int add_run(struct rl_database *db, const struct rl_run *run, struct rl_error *error)
{
    int status = add_provenance(db, &run->provenance, error);
    if (status == RL_OK)
        status =
            rl_sql_run(db, error, "INSERT INTO runs(study, grid, started, provenance) VALUES(?, ?, ?, ?)",
                       "ttti", run->study, run->grid, run->started, db->provenance);
    if (status != RL_OK)
        return status;
    db->run = sqlite3_last_insert_rowid(db->handle);
    for (size_t i = 0; i < run->n_records && status == RL_OK; i++) {
        const struct rl_record *r = &run->record[i];
        status = rl_sql_run(
            db, error,
            "INSERT INTO run_cases(run, position, group_number, identity, scene, scene_path, scene_hash,"
            " parameters) VALUES(?, ?, ?, ?, ?, ?, ?, ?)",
            "iiittttt", db->run, (int64_t)i, (int64_t)r->group, r->identity, r->scene, r->scene_path,
            r->scene_hash, r->parameters);
    }
    return status;
}

int rl_database_begin_run(struct rl_database *db, const struct rl_run *run, struct rl_error *error)
{
    int status = rl_sql_begin(db, error);
    return status == RL_OK ? rl_sql_end(db, add_run(db, run, error), error) : status;
}

int rl_database_state(struct rl_database *db, const char *identity, enum rl_record_status *state,
                      struct rl_error *error)
{
    sqlite3_stmt *statement = NULL;
    int status = rl_sql_prepare(db, &statement, error, "SELECT status = 'ok' FROM cases WHERE identity = ?",
                                "t", identity);
    if (status != RL_OK)
        return status;
    status = rl_sql_row(db, statement, error);
    *state = status < 1                         ? RL_RECORD_PLANNED
             : sqlite3_column_int(statement, 0) ? RL_RECORD_OK
                                                : RL_RECORD_FAILED;
    sqlite3_finalize(statement);
    return status < 0 ? status : RL_OK;
}

static int store_samples(struct rl_database *db, int64_t id, const struct rl_series *s,
                         struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < s->n && status == RL_OK; i++)
        status =
            rl_sql_run(db, error, "INSERT INTO samples(case_id, series, position, value) VALUES(?, ?, ?, ?)",
                       "itid", id, s->name, (int64_t)i, s->value[i]);
    return status;
}

static int store_record(struct rl_database *db, const struct rl_record *r, struct rl_error *error)
{
    char now[32];
    rl_provenance_now(now);
    int status = rl_sql_run(db, error, "DELETE FROM cases WHERE identity = ?", "t", r->identity);
    if (status == RL_OK)
        status = rl_sql_run(
            db, error,
            "INSERT INTO cases(identity, study, scene, scene_hash, parameters, status, message, seconds,"
            " finished, provenance) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
            "tttttttdti", r->identity, r->study, r->scene, r->scene_hash, r->parameters,
            r->status == RL_RECORD_OK ? "ok" : "failed", r->message, r->seconds, now, db->provenance);
    if (status != RL_OK)
        return status;
    int64_t id = sqlite3_last_insert_rowid(db->handle);
    for (size_t i = 0; i < r->n_metrics && status == RL_OK; i++) {
        const struct rl_metric *m = &r->metric[i];
        status = rl_sql_run(db, error,
                            "INSERT INTO metrics(case_id, position, name, value, low, high, unit) VALUES(?, "
                            "?, ?, ?, ?, ?, ?)",
                            "iitdddt", id, (int64_t)i, m->name, m->value, m->low, m->high, m->unit);
    }
    for (size_t i = 0; i < r->n_series && status == RL_OK; i++)
        status = store_samples(db, id, &r->series[i], error);
    return status;
}

int rl_database_store(struct rl_database *db, const struct rl_run *run, size_t first, size_t n,
                      struct rl_error *error)
{
    int status = rl_sql_begin(db, error);
    if (status != RL_OK)
        return status;
    for (size_t i = first; i < first + n && status == RL_OK; i++)
        status = store_record(db, &run->record[i], error);
    return rl_sql_end(db, status, error);
}
