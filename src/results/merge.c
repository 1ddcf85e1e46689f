/* Merges databases, one after the other, study by study (see merge.h). Cases are copied by SQLite from the other file; what is to be
 * copied is decided here, from both plans. */
#include "results/merge.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "results/database.h"
#include "results/merge_check.h"
#include "results/sql.h"

/* One study of one file on its way into another. */
struct merge {
    struct rl_database *into;
    const char *path; /* of the other */
    struct rl_merge_outcome *outcome;
    struct rl_run *have, *more; /* the plan there is, and the other file's */
    uint64_t *key;              /* of have->record, with room for those of more */
    bool changed;               /* the plan */
};

void rl_merge_outcome_clear(struct rl_merge_outcome *outcome)
{
    rl_buffer_clear(&outcome->notes);
    rl_buffer_clear(&outcome->agreements);
    *outcome = (struct rl_merge_outcome){0};
}

/* Copies a case from the attached database "source"; whatever failed under its identity is gone then. */
static int copy_case(struct rl_database *db, const char *identity, struct rl_error *error)
{
    static const char *const step[] = {
        "DELETE FROM main.cases WHERE identity = ?",
        "INSERT INTO main.provenance(environment, version, commit_id, dirty, code_hash, compiler, cflags, "
        "cpu, threads,"
        " backend, renderer, gl_version, os, time)"
        " SELECT environment, version, commit_id, dirty, code_hash, compiler, cflags, cpu, threads, backend,"
        " renderer, gl_version, os, time FROM source.provenance AS p"
        " WHERE id = (SELECT provenance FROM source.cases WHERE identity = ?) AND NOT EXISTS"
        " (SELECT 1 FROM main.provenance AS q WHERE q.environment = p.environment AND q.time = p.time)",
        "INSERT INTO main.cases(identity, study, scene, scene_hash, parameters, status, message, seconds, "
        "finished,"
        " provenance) SELECT identity, study, scene, scene_hash, parameters, status, message, seconds, "
        "finished,"
        " (SELECT q.id FROM main.provenance AS q JOIN source.provenance AS p USING (environment, time)"
        "  WHERE p.id = c.provenance ORDER BY q.id LIMIT 1) FROM source.cases AS c WHERE identity = ?",
        "INSERT INTO main.metrics SELECT new.id, position, name, value, low, high, unit FROM source.metrics"
        " JOIN source.cases AS old ON old.id = case_id JOIN main.cases AS new USING (identity) WHERE "
        "identity = ?",
        "INSERT INTO main.samples SELECT new.id, series, position, value FROM source.samples"
        " JOIN source.cases AS old ON old.id = case_id JOIN main.cases AS new USING (identity) WHERE "
        "identity = ?",
    };
    int status = RL_OK;
    for (size_t i = 0; i < sizeof step / sizeof step[0] && status == RL_OK; i++)
        status = rl_sql_run(db, error, step[i], "t", identity);
    return status;
}

/* Results of one environment are equal to the last bit; another processor may round otherwise. */
static bool differs(double a, double b, bool same_environment)
{
    if (a == b || (isnan(a) && isnan(b)))
        return false;
    return same_environment || !(fabs(a - b) <= 1e-6 * fmax(fabs(a), fabs(b)));
}

/* "2.db: WORDS: samples teapot-star samples=4" */
static void name_case(struct rl_buffer *to, const struct merge *m, const char *words,
                      const struct rl_record *r)
{
    rl_buffer_printf(to, "%s: %s: %s %s %s", m->path, words, r->study, r->scene, r->parameters);
}

static void note_agreement(struct merge *m, const struct rl_record *r)
{
    struct rl_buffer *to = &m->outcome->agreements;
    if (m->outcome->agreeing++ >= RL_MERGE_NAMED)
        return;
    name_case(to, m, "there already, with the same results", r);
    rl_buffer_add(to, "\n");
}

/* A line in the outcome: two measurements of a case do not agree, and in what, or they do. */
static void compare(struct merge *m, const struct rl_record *have, const struct rl_record *more)
{
    bool same = strcmp(have->identity, more->identity) == 0;
    for (size_t i = 0; i < have->n_metrics; i++) {
        const struct rl_metric *a = &have->metric[i], *b = rl_record_metric(more, a->name);
        if (rl_metric_timed(a) || (b && !differs(a->value, b->value, same) &&
                                   !differs(a->low, b->low, same) && !differs(a->high, b->high, same)))
            continue;
        m->outcome->differing++;
        name_case(&m->outcome->notes, m, "different results", have);
        rl_buffer_printf(&m->outcome->notes, ": %s is ", a->name);
        rl_buffer_number(&m->outcome->notes, b ? b->value : NAN);
        rl_buffer_add(&m->outcome->notes, " there, kept is ");
        rl_buffer_number(&m->outcome->notes, a->value);
        rl_buffer_add(&m->outcome->notes, "\n");
        return;
    }
    note_agreement(m, have);
}

/* The case of the plan that is the same on any machine, or NULL. */
static struct rl_record *find(struct merge *m, const struct rl_record *r, uint64_t key)
{
    for (size_t i = 0; i < m->have->n_records; i++)
        if (m->key[i] == key && strcmp(m->have->record[i].parameters, r->parameters) == 0 &&
            strcmp(m->have->record[i].scene, r->scene) == 0)
            return &m->have->record[i];
    return NULL;
}

static int add(struct merge *m, struct rl_record **added, const struct rl_record *r, uint64_t key,
               int64_t first_group, struct rl_error *error)
{
    struct rl_place place = {r->study, r->scene, r->scene_path, strtoull(r->scene_hash, NULL, 16)};
    if (r->group > INT_MAX - first_group)
        return rl_fail(error, RL_ERR_INPUT,
                       "%s: study %s: found group %d to be added to %lld others, expected to count up to %d",
                       m->path, r->study, r->group, (long long)first_group, INT_MAX);
    *added = rl_run_add(m->have, &place, (int)first_group + r->group, error, "%s", r->parameters);
    if (!*added)
        return RL_ERR_SYSTEM;
    m->key[m->have->n_records - 1] = key;
    memcpy((*added)->identity, r->identity, sizeof(*added)->identity);
    m->changed = true;
    return RL_OK;
}

/* A case of the other file: into the plan if it is not there, and copied if that is a gain. */
static int take(struct merge *m, const struct rl_record *r, int64_t first_group, struct rl_error *error)
{
    uint64_t key = rl_record_key(r);
    struct rl_record *have = find(m, r, key);
    int status = have ? RL_OK : add(m, &have, r, key, first_group, error);
    if (status != RL_OK)
        return status;
    if (r->status == RL_RECORD_PLANNED)
        return RL_OK;
    if (have->status == RL_RECORD_OK && r->status == RL_RECORD_OK)
        compare(m, have, r);
    if (have->status == RL_RECORD_OK || have->status == r->status) {
        m->outcome->known++;
        return RL_OK;
    }
    /* An earlier run than the plan's may have measured it. */
    enum rl_record_status state;
    status = rl_database_state(m->into, r->identity, &state, error);
    if (status != RL_OK)
        return status;
    if (state != RL_RECORD_OK) {
        status = copy_case(m->into, r->identity, error);
        m->outcome->copied++;
    } else {
        m->outcome->known++;
    }
    m->changed = m->changed || strcmp(have->identity, r->identity) != 0;
    memcpy(have->identity, r->identity, sizeof have->identity);
    have->status = state == RL_RECORD_OK ? state : r->status;
    return status;
}

/* Numbers the plan's cases, and gives the other file's groups numbers of their own: the first of them. */
static int64_t prepare(struct merge *m)
{
    struct rl_run *have = m->have;
    int64_t first_group = 0;
    if (have->n_records == 0) {
        memcpy(have->grid, m->more->grid, sizeof have->grid);
        memcpy(have->started, m->more->started, sizeof have->started);
        have->provenance = m->more->provenance;
    }
    for (size_t i = 0; i < have->n_records; i++) {
        m->key[i] = rl_record_key(&have->record[i]);
        first_group = have->record[i].group >= first_group ? (int64_t)have->record[i].group + 1 : first_group;
    }
    return first_group;
}

static int take_all(struct merge *m, struct rl_error *error)
{
    int64_t first_group = prepare(m);
    int status = rl_sql_run(m->into, error, "ATTACH ? AS source", "t", m->path);
    if (status != RL_OK)
        return status;
    /* Neither here nor with the other file attached rl_sql_begin, which would lock that one for writing. */
    status = rl_sql_script(m->into, "BEGIN", error);
    for (size_t i = 0; i < m->more->n_records && status == RL_OK; i++)
        status = take(m, &m->more->record[i], first_group, error);
    status = rl_sql_end(m->into, status, error);
    int detached = rl_sql_script(m->into, "DETACH source", status == RL_OK ? error : NULL);
    if (status == RL_OK)
        status = detached;
    /* The plan comes after the cases: if the process ends between, merging once more finds both. */
    return status == RL_OK && m->changed ? rl_database_begin_run(m->into, m->have, error) : status;
}

static int merge_study(struct rl_merge_outcome *outcome, struct rl_database *into, struct rl_database *source,
                       const char *study, struct rl_error *error)
{
    struct rl_run have, more;
    int status = rl_database_load_run(into, study, &have, error);
    if (status != RL_OK)
        return status;
    status = rl_database_load_run(source, study, &more, error);
    if (status == RL_OK) {
        struct merge m = {
            .into = into, .path = source->path, .outcome = outcome, .have = &have, .more = &more};
        m.key = calloc(have.n_records + more.n_records + 1, sizeof *m.key);
        status = m.key ? take_all(&m, error) : rl_fail_memory(error, "a merged plan");
        free(m.key);
        rl_run_clear(&more);
    }
    rl_run_clear(&have);
    return status;
}

/* Every study that the source has a run of. */
static int merge_studies(struct rl_merge_outcome *outcome, struct rl_database *into,
                         struct rl_database *source, struct rl_error *error)
{
    sqlite3_stmt *s = NULL;
    int status =
        rl_sql_prepare(source, &s, error, "SELECT study FROM runs GROUP BY study ORDER BY min(id)", "");
    if (status != RL_OK)
        return status;
    while ((status = rl_sql_row(source, s, error)) > 0) {
        char study[RL_NAME_MAX];
        rl_sql_text(s, 0, study, sizeof study);
        status = merge_study(outcome, into, source, study, error);
        if (status != RL_OK)
            break;
    }
    sqlite3_finalize(s);
    return status;
}

static int merge_file(struct rl_merge_outcome *outcome, struct rl_database *into, const char *path,
                      struct rl_error *error)
{
    struct rl_database *source;
    int status = rl_database_open(&source, path, RL_DATABASE_READ, error);
    if (status != RL_OK)
        return status;
    status = merge_studies(outcome, into, source, error);
    rl_database_close(source);
    return status;
}

int rl_database_merge(struct rl_merge_outcome *outcome, const struct rl_merge_options *o,
                      struct rl_error *error)
{
    *outcome = (struct rl_merge_outcome){0};
    struct rl_database *into;
    int status = rl_merge_check(o, error);
    if (status == RL_OK)
        status = rl_database_open(&into, o->into, RL_DATABASE_WRITE, error);
    if (status != RL_OK)
        return status;
    for (size_t i = 0; i < o->n_from && status == RL_OK; i++)
        status = merge_file(outcome, into, o->from[i], error);
    rl_database_close(into);
    if (status == RL_OK)
        status = rl_buffer_check(&outcome->notes, error);
    return status == RL_OK ? rl_buffer_check(&outcome->agreements, error) : status;
}
