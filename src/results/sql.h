/* Within src/results: SQLite with errors as this project has them. */
#ifndef RL_RESULTS_SQL_H
#define RL_RESULTS_SQL_H

#include <sqlite3.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"

/* A statement that was run and is kept for the next time. */
struct rl_sql_kept {
    const char *sql;
    sqlite3_stmt *statement;
};

enum { RL_SQL_KEPT_MAX = 16 };

struct rl_database {
    sqlite3 *handle;
    char *path;
    int lock;    /* file descriptor that holds the one writer's lock, or -1 */
    int64_t run; /* rows of the latest run begun */
    int64_t provenance;
    struct rl_sql_kept kept[RL_SQL_KEPT_MAX];
};

/* What SQLite said about the last call, in words that name the file. */
int rl_sql_fail(const struct rl_database *db, int code, struct rl_error *error);

/* Statements without arguments or results; several may be separated by semicolons. */
int rl_sql_script(struct rl_database *db, const char *sql, struct rl_error *error);

/* Prepares a statement and binds its arguments: one letter of `types` each: t (const char *), i (int64_t), d (double; NaN
 * becomes NULL). */
int rl_sql_prepare(struct rl_database *db, sqlite3_stmt **statement, struct rl_error *error, const char *sql,
                   const char *types, ...);
/* The same, and runs it to its end. Prepared once for every `sql`, which must be a literal; rl_sql_forget before the file is closed. */
int rl_sql_run(struct rl_database *db, struct rl_error *error, const char *sql, const char *types, ...);

void rl_sql_forget(struct rl_database *db);

/* The next row: 1, no more: 0, or a negative status. */
int rl_sql_row(const struct rl_database *db, sqlite3_stmt *statement, struct rl_error *error);

/* A column of the present row; NULL becomes "", control characters '?'. */
void rl_sql_text(sqlite3_stmt *statement, int column, char *text, size_t size);

/* Where a row comes from, for errors. */
struct rl_sql_place {
    const char *table;
    int64_t case_id;
    const char *name; /* of the metric or series; NULL: the row is the case itself */
    int position;     /* in the series; -1: the row is no raw figure */
};

/* A REAL column; NULL becomes NaN. SQLite keeps anything in any column, so what is no number there is RL_ERR_INPUT: a number made
 * of it would be a result that nobody measured. */
int rl_sql_real(const struct rl_database *db, sqlite3_stmt *statement, int column, double *value,
                const struct rl_sql_place *place, struct rl_error *error);

/* Begins a transaction that may write; `end` commits it if `status` is RL_OK, else (or if that fails) undoes it. */
int rl_sql_begin(struct rl_database *db, struct rl_error *error);
int rl_sql_end(struct rl_database *db, int status, struct rl_error *error);

#endif
