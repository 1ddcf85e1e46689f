/* Databases that are to be merged have to agree in what made their results (see merge_check.h). */
#include "results/merge_check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "results/database.h"
#include "results/sql.h"

/* Something that has one value for each study. */
struct fact {
    char study[RL_NAME_MAX], name[RL_NAME_MAX + 8], value[192];
    char note[64];    /* shown after the value, not compared */
    const char *path; /* where it was first found */
};

struct facts {
    size_t n;
    struct fact *fact;
};

/* Of a study's latest run. Which program it was, the hash of its sources tells; the commit is for people to look up. */
static const char query[] =
    "WITH planned AS (SELECT runs.study, run_cases.* FROM run_cases JOIN runs ON runs.id = run"
    "  WHERE run IN (SELECT max(id) FROM runs GROUP BY study)),"
    " made AS (SELECT planned.study, provenance.* FROM planned JOIN cases USING (identity)"
    "  JOIN provenance ON provenance.id = cases.provenance)"
    " SELECT study, 'version', version, '' FROM made"
    " UNION SELECT study, 'code', code_hash, ' (commit ' || commit_id || iif(dirty, ', modified)', ')') FROM "
    "made"
    " UNION SELECT study, 'renderer', renderer, '' FROM made"
    " UNION SELECT study, 'scene ' || scene, scene_hash, '' FROM planned";

static int compare(struct facts *facts, const struct fact *new, struct rl_error *error)
{
    for (size_t i = 0; i < facts->n; i++) {
        const struct fact *old = &facts->fact[i];
        if (strcmp(old->study, new->study) != 0 || strcmp(old->name, new->name) != 0)
            continue;
        if (strcmp(old->value, new->value) == 0)
            return RL_OK;
        return rl_fail(
            error, RL_ERR_INPUT,
            "%s: study %s: found %s %s%s, expected %s%s as in %s (--allow-mixed takes them together)",
            new->path, new->study, new->name, new->value, new->note, old->value, old->note, old->path);
    }
    struct fact *grown = realloc(facts->fact, (facts->n + 1) * sizeof *grown);
    if (!grown)
        return rl_fail_memory(error, "what databases have in common");
    facts->fact = grown;
    facts->fact[facts->n++] = *new;
    return RL_OK;
}

static int check_file(struct facts *facts, const char *path, bool allow_mixed, struct rl_error *error)
{
    struct rl_database *db;
    sqlite3_stmt *s = NULL;
    int status = rl_database_open(&db, path, RL_DATABASE_READ, error);
    if (status == RL_OK && !allow_mixed)
        status = rl_sql_prepare(db, &s, error, query, "");
    while (s && (status = rl_sql_row(db, s, error)) > 0) {
        struct fact fact = {.path = path};
        rl_sql_text(s, 0, fact.study, sizeof fact.study);
        rl_sql_text(s, 1, fact.name, sizeof fact.name);
        rl_sql_text(s, 2, fact.value, sizeof fact.value);
        rl_sql_text(s, 3, fact.note, sizeof fact.note);
        status = compare(facts, &fact, error);
        if (status != RL_OK)
            break;
    }
    sqlite3_finalize(s);
    rl_database_close(db);
    return status;
}

static int check_twice(const struct rl_merge_options *o, struct rl_error *error)
{
    struct stat a, b;
    for (size_t i = 0; i < o->n_from; i++)
        for (size_t k = 0; k <= i; k++) {
            const char *other = k < i ? o->from[k] : o->into;
            if (stat(o->from[i], &a) == 0 && stat(other, &b) == 0 && a.st_dev == b.st_dev &&
                a.st_ino == b.st_ino)
                return rl_fail(error, RL_ERR_INPUT, "%s: the same file as %s, expected different ones",
                               o->from[i], other);
        }
    return RL_OK;
}

int rl_merge_check(const struct rl_merge_options *o, struct rl_error *error)
{
    struct facts facts = {0};
    struct stat info;
    int status = check_twice(o, error);
    if (status == RL_OK && stat(o->into, &info) == 0 && S_ISREG(info.st_mode) && info.st_size > 0)
        status = check_file(&facts, o->into, o->allow_mixed, error);
    for (size_t i = 0; i < o->n_from && status == RL_OK; i++)
        status = check_file(&facts, o->from[i], o->allow_mixed, error);
    free(facts.fact);
    return status;
}
