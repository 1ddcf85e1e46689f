/* Checks a results database before it is read (see database_check.h). A file may come from elsewhere, and SQLite keeps anything in any
 * column: a text that is cut, or a hash that is none, would be another case than the file has; a view or a trigger may be any program, one
 * that never ends too (sqlite.org/security.html). Columns of figures are checked where they are read (rl_sql_real). */
#include "results/database_check.h"

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "results/record.h"

#define ADVICE "put it aside and run the studies again"

int rl_database_distrust(struct rl_database *db, struct rl_error *error)
{
    int code = sqlite3_db_config(db->handle, SQLITE_DBCONFIG_DEFENSIVE, 1, NULL);
    if (code == SQLITE_OK)
        code = sqlite3_db_config(db->handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, NULL);
    return code == SQLITE_OK ? rl_sql_script(db, "PRAGMA cell_size_check = ON", error)
                             : rl_sql_fail(db, code, error);
}

/* ---- Tables ---- */

/* Whether it is one of the script's statements, from its first letter to its semicolon. */
static bool is_ours(const char *sql, const char *script)
{
    size_t length = strlen(sql);
    for (const char *at = script; *sql && (at = strstr(at, sql)) != NULL; at++)
        if ((at == script || at[-1] == ';') && at[length] == ';')
            return true;
    return false;
}

/* Beside tables and their own indices a file may have SQLite's (ANALYZE makes some). */
static int check_schema(struct rl_database *db, const char *script, struct rl_error *error)
{
    sqlite3_stmt *s = NULL;
    size_t n = 0, wanted = 0;
    for (const char *c = script; *c; c++)
        wanted += *c == ';';
    int status = rl_sql_prepare(db, &s, error, "SELECT type, name, sql FROM sqlite_master", "");
    if (status != RL_OK)
        return status;
    while ((status = rl_sql_row(db, s, error)) > 0) {
        char type[16], name[RL_NAME_MAX];
        rl_sql_text(s, 0, type, sizeof type);
        rl_sql_text(s, 1, name, sizeof name);
        const char *sql = (const char *)sqlite3_column_text(s, 2);
        bool table = strcmp(type, "table") == 0, index = strcmp(type, "index") == 0;
        bool ours = table && sql && is_ours(sql, script);
        n += ours;
        if (!ours && !((table || index) && strncmp(name, "sqlite_", 7) == 0)) {
            status =
                rl_fail(error, RL_ERR_INPUT,
                        "%s: damaged: found the %s '%s', expected the tables that roughlight makes and no "
                        "others; " ADVICE,
                        db->path, type, name);
            break;
        }
    }
    sqlite3_finalize(s);
    if (status == RL_OK && n != wanted)
        return rl_fail(error, RL_ERR_INPUT, "%s: damaged: found %zu of %zu tables; " ADVICE, db->path, n,
                       wanted);
    return status;
}

/* ---- Pages and references ---- */

static int check_pages(struct rl_database *db, struct rl_error *error)
{
    sqlite3_stmt *s = NULL;
    /* Not quick_check: what an index has must be what its table has, for SQLite answers from either. */
    int status = rl_sql_prepare(db, &s, error, "PRAGMA integrity_check(1)", "");
    if (status != RL_OK)
        return status;
    char answer[256] = "";
    status = rl_sql_row(db, s, error);
    if (status > 0) {
        const char *said = (const char *)sqlite3_column_text(s, 0);
        snprintf(answer, sizeof answer, "%.*s", said ? (int)strcspn(said, "\n") : 0, said ? said : "");
    }
    sqlite3_finalize(s);
    if (status < 0)
        return status;
    if (strcmp(answer, "ok") != 0)
        return rl_fail(error, RL_ERR_INPUT, "%s: damaged (%s); " ADVICE, db->path, answer);
    return RL_OK;
}

static int check_references(struct rl_database *db, struct rl_error *error)
{
    sqlite3_stmt *s = NULL;
    int status = rl_sql_prepare(db, &s, error, "PRAGMA foreign_key_check", "");
    if (status != RL_OK)
        return status;
    char from[RL_NAME_MAX], to[RL_NAME_MAX];
    status = rl_sql_row(db, s, error);
    if (status > 0) {
        rl_sql_text(s, 0, from, sizeof from);
        rl_sql_text(s, 2, to, sizeof to);
        status = rl_fail(error, RL_ERR_INPUT,
                         "%s: damaged: table %s: found a row that belongs to none of table %s; " ADVICE,
                         db->path, from, to);
    }
    sqlite3_finalize(s);
    return status;
}

/* ---- Columns ---- */

#define SIZE_OF(type, member) sizeof(((type *)0)->member)

/* size 0: a whole number from 0. Else a text of fewer bytes, or of exactly 16 hexadecimal digits. */
static const struct column {
    const char *table, *name;
    size_t size;
    bool hash;
} columns[] = {
    {"provenance", "environment", RL_HASH_TEXT, true},
    {"provenance", "version", SIZE_OF(struct rl_provenance, version), false},
    {"provenance", "commit_id", SIZE_OF(struct rl_provenance, commit), false},
    {"provenance", "code_hash", SIZE_OF(struct rl_provenance, code_hash), false},
    {"provenance", "compiler", SIZE_OF(struct rl_provenance, compiler), false},
    {"provenance", "cflags", SIZE_OF(struct rl_provenance, cflags), false},
    {"provenance", "cpu", SIZE_OF(struct rl_provenance, cpu), false},
    {"provenance", "threads", 0, false},
    {"provenance", "backend", SIZE_OF(struct rl_provenance, backend), false},
    {"provenance", "renderer", SIZE_OF(struct rl_provenance, renderer), false},
    {"provenance", "gl_version", SIZE_OF(struct rl_provenance, gl_version), false},
    {"provenance", "os", SIZE_OF(struct rl_provenance, os), false},
    {"provenance", "time", SIZE_OF(struct rl_provenance, time), false},
    {"runs", "study", RL_NAME_MAX, false},
    {"runs", "grid", RL_GRID_MAX, false},
    {"runs", "started", SIZE_OF(struct rl_run, started), false},
    {"run_cases", "position", 0, false},
    {"run_cases", "group_number", 0, false},
    {"run_cases", "identity", RL_HASH_TEXT, true},
    {"run_cases", "scene", RL_NAME_MAX, false},
    {"run_cases", "scene_path", RL_SCENE_PATH_MAX, false},
    {"run_cases", "scene_hash", RL_HASH_TEXT, true},
    {"run_cases", "parameters", RL_PARAMETERS_MAX, false},
    {"cases", "identity", RL_HASH_TEXT, true},
    {"cases", "study", RL_NAME_MAX, false},
    {"cases", "scene", RL_NAME_MAX, false},
    {"cases", "scene_hash", RL_HASH_TEXT, true},
    {"cases", "parameters", RL_PARAMETERS_MAX, false},
    {"cases", "message", SIZE_OF(struct rl_record, message), false},
    {"metrics", "position", 0, false},
    {"metrics", "name", RL_NAME_MAX, false},
    {"metrics", "unit", RL_NAME_MAX, false},
};

enum { N_COLUMNS = sizeof columns / sizeof columns[0] };

static bool fits(sqlite3_stmt *s, int i, const struct column *c)
{
    int type = sqlite3_column_type(s, i);
    if (c->size == 0)
        return type == SQLITE_INTEGER && sqlite3_column_int64(s, i) >= 0 &&
               sqlite3_column_int64(s, i) <= INT_MAX;
    const char *text = (const char *)sqlite3_column_text(s, i);
    if (type != SQLITE_TEXT || !text || strlen(text) != (size_t)sqlite3_column_bytes(s, i))
        return false;
    return c->hash ? strlen(text) == c->size - 1 && text[strspn(text, "0123456789abcdef")] == '\0'
                   : strlen(text) < c->size;
}

static int fail_column(const struct rl_database *db, sqlite3_stmt *s, int i, const struct column *c,
                       struct rl_error *error)
{
    char found[48], expected[48];
    rl_sql_text(s, i, found, sizeof found);
    if (c->hash)
        snprintf(expected, sizeof expected, "%zu hexadecimal digits", c->size - 1);
    else if (c->size > 0)
        snprintf(expected, sizeof expected, "a text of less than %zu bytes", c->size);
    else
        snprintf(expected, sizeof expected, "a whole number from 0 to %d", INT_MAX);
    return rl_fail(error, RL_ERR_INPUT, "%s: damaged: table %s, column %s: found '%s', expected %s; " ADVICE,
                   db->path, c->table, c->name, found, expected);
}

/* The n columns of one table, in one go through its rows. */
static int check_columns(struct rl_database *db, const struct column *c, int n, struct rl_error *error)
{
    char sql[256] = "SELECT ";
    sqlite3_stmt *s = NULL;
    for (int i = 0; i < n; i++) {
        size_t used = strlen(sql);
        snprintf(sql + used, sizeof sql - used, "%s%s%s", c[i].name, i + 1 < n ? ", " : " FROM ",
                 i + 1 < n ? "" : c->table);
    }
    int status = rl_sql_prepare(db, &s, error, sql, "");
    if (status != RL_OK)
        return status;
    while ((status = rl_sql_row(db, s, error)) > 0) {
        int i = 0;
        while (i < n && fits(s, i, &c[i]))
            i++;
        if (i < n) {
            status = fail_column(db, s, i, &c[i], error);
            break;
        }
    }
    sqlite3_finalize(s);
    return status;
}

static int check_all_columns(struct rl_database *db, struct rl_error *error)
{
    int status = RL_OK;
    for (int i = 0, n; i < N_COLUMNS && status == RL_OK; i += n) {
        for (n = 1; i + n < N_COLUMNS && strcmp(columns[i + n].table, columns[i].table) == 0; n++)
            continue;
        status = check_columns(db, &columns[i], n, error);
    }
    return status;
}

int rl_database_check(struct rl_database *db, const char *script, struct rl_error *error)
{
    /* One look at the file, while somebody may be writing to it. */
    int status = rl_sql_script(db, "BEGIN", error);
    if (status != RL_OK)
        return status;
    status = check_schema(db, script, error);
    if (status == RL_OK)
        status = check_pages(db, error);
    if (status == RL_OK)
        status = check_references(db, error);
    if (status == RL_OK)
        status = check_all_columns(db, error);
    return rl_sql_end(db, status, error);
}
