/* SQLite calls with one-line errors (see sql.h). */
#include "results/sql.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

static const char *explain(int code)
{
    switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return "locked by another program";
    case SQLITE_NOTADB:
        return "not an SQLite database";
    case SQLITE_CORRUPT:
        return "damaged";
    case SQLITE_FULL:
        return "cannot write: the disk is full";
    case SQLITE_READONLY:
        return "cannot write: the file or its folder is read-only";
    case SQLITE_CANTOPEN:
        return "cannot open the file or its journal";
    case SQLITE_IOERR:
        return "cannot read or write";
    case SQLITE_NOMEM:
        return "out of memory";
    default:
        return "SQLite failed";
    }
}

int rl_sql_fail(const struct rl_database *db, int code, struct rl_error *error)
{
    /* Bad data in the file is the caller's input; the rest is the machine's doing. */
    int primary = code & 0xff;
    enum rl_status status =
        primary == SQLITE_NOTADB || primary == SQLITE_CORRUPT ? RL_ERR_INPUT : RL_ERR_SYSTEM;
    return rl_fail(error, status, "%s: %s (%s)", db->path, explain(code),
                   db->handle ? sqlite3_errmsg(db->handle) : sqlite3_errstr(code));
}

int rl_sql_script(struct rl_database *db, const char *sql, struct rl_error *error)
{
    int code = sqlite3_exec(db->handle, sql, NULL, NULL, NULL);
    return code == SQLITE_OK ? RL_OK : rl_sql_fail(db, code, error);
}

static int bind(sqlite3_stmt *statement, const char *types, va_list arguments)
{
    int code = SQLITE_OK;
    for (int i = 1; code == SQLITE_OK && *types; i++, types++) {
        if (*types == 't') {
            code = sqlite3_bind_text(statement, i, va_arg(arguments, const char *), -1, SQLITE_TRANSIENT);
        } else if (*types == 'i') {
            code = sqlite3_bind_int64(statement, i, va_arg(arguments, int64_t));
        } else {
            code = sqlite3_bind_double(statement, i, va_arg(arguments, double));
        }
    }
    return code;
}

int rl_sql_prepare(struct rl_database *db, sqlite3_stmt **statement, struct rl_error *error, const char *sql,
                   const char *types, ...)
{
    va_list arguments;
    int code = sqlite3_prepare_v2(db->handle, sql, -1, statement, NULL);
    va_start(arguments, types);
    if (code == SQLITE_OK)
        code = bind(*statement, types, arguments);
    va_end(arguments);
    if (code == SQLITE_OK)
        return RL_OK;
    int status = rl_sql_fail(db, code, error);
    sqlite3_finalize(*statement);
    *statement = NULL;
    return status;
}

int rl_sql_row(const struct rl_database *db, sqlite3_stmt *statement, struct rl_error *error)
{
    int code = sqlite3_step(statement);
    if (code == SQLITE_ROW)
        return 1;
    return code == SQLITE_DONE ? 0 : rl_sql_fail(db, code, error);
}

/* Of this text, or a free place; NULL: all are taken by others. */
static struct rl_sql_kept *find_kept(struct rl_database *db, const char *sql)
{
    size_t i = 0;
    while (i < RL_SQL_KEPT_MAX && db->kept[i].sql && db->kept[i].sql != sql)
        i++;
    return i < RL_SQL_KEPT_MAX ? &db->kept[i] : NULL;
}

void rl_sql_forget(struct rl_database *db)
{
    for (size_t i = 0; i < RL_SQL_KEPT_MAX; i++) {
        sqlite3_finalize(db->kept[i].statement);
        db->kept[i] = (struct rl_sql_kept){0};
    }
}

int rl_sql_run(struct rl_database *db, struct rl_error *error, const char *sql, const char *types, ...)
{
    struct rl_sql_kept *kept = find_kept(db, sql);
    sqlite3_stmt *statement = kept ? kept->statement : NULL;
    va_list arguments;
    int code = statement ? SQLITE_OK : sqlite3_prepare_v2(db->handle, sql, -1, &statement, NULL);
    if (kept && code == SQLITE_OK)
        *kept = (struct rl_sql_kept){sql, statement};
    va_start(arguments, types);
    if (code == SQLITE_OK)
        code = bind(statement, types, arguments);
    va_end(arguments);
    int status = code == SQLITE_OK ? rl_sql_row(db, statement, error) : rl_sql_fail(db, code, error);
    while (status > 0)
        status = rl_sql_row(db, statement, error);
    if (kept)
        sqlite3_reset(statement);
    else
        sqlite3_finalize(statement);
    return status;
}

void rl_sql_text(sqlite3_stmt *statement, int column, char *text, size_t size)
{
    const unsigned char *value = sqlite3_column_text(statement, column);
    snprintf(text, size, "%s", value ? (const char *)value : "");
    /* It will be part of a line, of a table or on a terminal. */
    for (; *text; text++)
        if ((unsigned char)*text < ' ' || *text == 0x7f)
            *text = '?';
}

/* "row case 7, metric rmse" */
static void place_text(char *text, size_t size, const struct rl_sql_place *p)
{
    int n = snprintf(text, size, "case %lld", (long long)p->case_id);
    if (p->name && n > 0 && (size_t)n < size)
        n += snprintf(text + n, size - (size_t)n, ", %s %s", p->position < 0 ? "metric" : "series", p->name);
    if (p->position >= 0 && n > 0 && (size_t)n < size)
        snprintf(text + n, size - (size_t)n, ", position %d", p->position);
}

int rl_sql_real(const struct rl_database *db, sqlite3_stmt *statement, int column, double *value,
                const struct rl_sql_place *place, struct rl_error *error)
{
    int type = sqlite3_column_type(statement, column);
    *value = NAN;
    if (type == SQLITE_FLOAT || type == SQLITE_INTEGER)
        *value = sqlite3_column_double(statement, column);
    if (type == SQLITE_FLOAT || type == SQLITE_INTEGER || type == SQLITE_NULL)
        return RL_OK;
    char row[192], found[64] = "bytes";
    place_text(row, sizeof row, place);
    if (type == SQLITE_TEXT)
        snprintf(found, sizeof found, "the text '%.40s'",
                 (const char *)sqlite3_column_text(statement, column));
    return rl_fail(
        error, RL_ERR_INPUT,
        "%s: damaged: table %s, column %s, row of %s: found %s, expected a number; put it aside and "
        "run the studies again",
        db->path, place->table, sqlite3_column_name(statement, column), row, found);
}

int rl_sql_begin(struct rl_database *db, struct rl_error *error)
{
    return rl_sql_script(db, "BEGIN IMMEDIATE", error);
}

int rl_sql_end(struct rl_database *db, int status, struct rl_error *error)
{
    if (status == RL_OK)
        status = rl_sql_script(db, "COMMIT", error);
    /* Some errors have undone it already; then this one has nothing to do, which is no further error. */
    if (status != RL_OK && !sqlite3_get_autocommit(db->handle))
        sqlite3_exec(db->handle, "ROLLBACK", NULL, NULL, NULL);
    return status;
}
