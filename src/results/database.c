/* Opens the results database, makes its tables, and keeps it to one writer (see database.h). */
#include "results/database.h"

#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/files.h"
#include "results/database_check.h"
#include "results/sql.h"

/* Marks a file as this program's (SQLite keeps both numbers in the header): "rlgt", and the version of the tables. */
enum { APPLICATION_ID = 0x726c6774, TABLES_VERSION = 1, BUSY_TIMEOUT_MS = 2000 };

static const char tables[] =
    "CREATE TABLE provenance(id INTEGER PRIMARY KEY, environment TEXT NOT NULL, version TEXT NOT NULL,"
    " commit_id TEXT NOT NULL, dirty INTEGER NOT NULL, code_hash TEXT NOT NULL, compiler TEXT NOT NULL,"
    " cflags TEXT NOT NULL, cpu TEXT NOT NULL, threads INTEGER NOT NULL, backend TEXT NOT NULL,"
    " renderer TEXT NOT NULL, gl_version TEXT NOT NULL, os TEXT NOT NULL, time TEXT NOT NULL);"
    "CREATE TABLE runs(id INTEGER PRIMARY KEY, study TEXT NOT NULL, grid TEXT NOT NULL, started TEXT NOT "
    "NULL,"
    " provenance INTEGER NOT NULL REFERENCES provenance(id));"
    "CREATE TABLE run_cases(run INTEGER NOT NULL REFERENCES runs(id) ON DELETE CASCADE, position INTEGER NOT "
    "NULL,"
    " group_number INTEGER NOT NULL, identity TEXT NOT NULL, scene TEXT NOT NULL, scene_path TEXT NOT NULL,"
    " scene_hash TEXT NOT NULL, parameters TEXT NOT NULL, PRIMARY KEY(run, position)) WITHOUT ROWID;"
    "CREATE TABLE cases(id INTEGER PRIMARY KEY, identity TEXT NOT NULL UNIQUE, study TEXT NOT NULL,"
    " scene TEXT NOT NULL, scene_hash TEXT NOT NULL, parameters TEXT NOT NULL,"
    " status TEXT NOT NULL CHECK(status IN ('ok', 'failed')), message TEXT NOT NULL, seconds REAL,"
    " finished TEXT NOT NULL, provenance INTEGER NOT NULL REFERENCES provenance(id));"
    "CREATE TABLE metrics(case_id INTEGER NOT NULL REFERENCES cases(id) ON DELETE CASCADE, position INTEGER "
    "NOT NULL,"
    " name TEXT NOT NULL, value REAL, low REAL, high REAL, unit TEXT NOT NULL,"
    " PRIMARY KEY(case_id, position), UNIQUE(case_id, name)) WITHOUT ROWID;"
    "CREATE TABLE samples(case_id INTEGER NOT NULL REFERENCES cases(id) ON DELETE CASCADE, series TEXT NOT "
    "NULL,"
    " position INTEGER NOT NULL, value REAL, PRIMARY KEY(case_id, series, position)) WITHOUT ROWID;";

void rl_database_missing_folder(char folder[PATH_MAX], const char *path)
{
    const char *slash = strrchr(path, '/');
    snprintf(folder, PATH_MAX, "%.*s", slash ? (int)(slash - path) : 0, path);
    if (access(folder, F_OK) == 0)
        folder[0] = '\0';
}

static int take_lock(struct rl_database *db, struct rl_error *error)
{
    char *copy = strdup(db->path);
    if (!copy)
        return rl_fail_memory(error, db->path);
    int status = rl_directory_create(dirname(copy), error);
    free(copy);
    if (status != RL_OK)
        return status;
    db->lock = open(db->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (db->lock < 0)
        return rl_fail(error, RL_ERR_SYSTEM, "%s: cannot open for writing: %s", db->path, strerror(errno));
    struct stat info;
    if (fstat(db->lock, &info) != 0 || !S_ISREG(info.st_mode))
        return rl_fail(error, RL_ERR_INPUT, "%s: not a regular file", db->path);
    /* This lock is apart from SQLite's own and held all along, so that a second run is told at its start. */
    if (flock(db->lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return rl_fail(error, RL_ERR_SYSTEM, "%s: locked: another run of roughlight is writing to it",
                       db->path);
    return RL_OK;
}

/* The first column of the first row as a number. */
static int query_number(struct rl_database *db, const char *sql, int64_t *value, struct rl_error *error)
{
    sqlite3_stmt *statement = NULL;
    int status = rl_sql_prepare(db, &statement, error, sql, "");
    if (status != RL_OK)
        return status;
    status = rl_sql_row(db, statement, error);
    if (status > 0)
        *value = sqlite3_column_int64(statement, 0);
    sqlite3_finalize(statement);
    return status < 0 ? status : RL_OK;
}

static int make_tables(struct rl_database *db, struct rl_error *error)
{
    char marks[96];
    snprintf(marks, sizeof marks, "PRAGMA application_id = %d; PRAGMA user_version = %d", APPLICATION_ID,
             TABLES_VERSION);
    int status = rl_sql_begin(db, error);
    if (status != RL_OK)
        return status;
    status = rl_sql_script(db, tables, error);
    if (status == RL_OK)
        status = rl_sql_script(db, marks, error);
    return rl_sql_end(db, status, error);
}

/* Makes the tables in an empty file; refuses one that is another program's or of another version. */
static int check_tables(struct rl_database *db, enum rl_database_mode mode, struct rl_error *error)
{
    int64_t n_tables = 0, application = 0, version = 0;
    int status = query_number(db, "SELECT count(*) FROM sqlite_master", &n_tables, error);
    if (status == RL_OK && n_tables == 0) {
        if (mode == RL_DATABASE_READ)
            return rl_fail(error, RL_ERR_INPUT, "%s: holds no results yet", db->path);
        return make_tables(db, error);
    }
    if (status == RL_OK)
        status = query_number(db, "PRAGMA application_id", &application, error);
    if (status == RL_OK)
        status = query_number(db, "PRAGMA user_version", &version, error);
    if (status != RL_OK)
        return status;
    if (application != APPLICATION_ID)
        return rl_fail(error, RL_ERR_INPUT, "%s: an SQLite database, but not one of roughlight's results",
                       db->path);
    if (version != TABLES_VERSION)
        return rl_fail(error, RL_ERR_INPUT, "%s: tables of version %lld, this program reads version %d",
                       db->path, (long long)version, TABLES_VERSION);
    return rl_database_check(db, tables, error);
}

static int open_file(struct rl_database *db, enum rl_database_mode mode, struct rl_error *error)
{
    struct stat info;
    if (mode == RL_DATABASE_READ && stat(db->path, &info) != 0)
        return rl_fail(error, RL_ERR_INPUT, "%s: cannot open: %s", db->path, strerror(errno));
    if (mode == RL_DATABASE_READ && !S_ISREG(info.st_mode))
        return rl_fail(error, RL_ERR_INPUT, "%s: not a regular file, a results database is expected",
                       db->path);
    /* Reading opens the file for writing too where it may: what a killed writer left in its journal must be undone first. */
    int flags = mode == RL_DATABASE_WRITE || access(db->path, W_OK) == 0 ? SQLITE_OPEN_READWRITE
                                                                         : SQLITE_OPEN_READONLY;
    int code = sqlite3_open_v2(db->path, &db->handle, flags, NULL);
    if (code != SQLITE_OK)
        return rl_sql_fail(db, code, error);
    sqlite3_extended_result_codes(db->handle, 1);
    sqlite3_busy_timeout(db->handle, BUSY_TIMEOUT_MS);
    int status = rl_database_distrust(db, error);
    if (status == RL_OK)
        status = rl_sql_script(db, "PRAGMA foreign_keys = ON", error);
    return status == RL_OK ? check_tables(db, mode, error) : status;
}

int rl_database_open(struct rl_database **out, const char *path, enum rl_database_mode mode,
                     struct rl_error *error)
{
    *out = NULL;
    struct rl_database *db = calloc(1, sizeof *db);
    if (!db)
        return rl_fail_memory(error, path);
    db->lock = -1;
    db->path = strdup(path);
    if (!db->path) {
        free(db);
        return rl_fail_memory(error, path);
    }
    int status = mode == RL_DATABASE_WRITE ? take_lock(db, error) : RL_OK;
    if (status == RL_OK)
        status = open_file(db, mode, error);
    if (status != RL_OK) {
        rl_database_close(db);
        return status;
    }
    *out = db;
    return RL_OK;
}

void rl_database_close(struct rl_database *db)
{
    if (!db)
        return;
    rl_sql_forget(db);
    sqlite3_close(db->handle);
    /* Last: closing any descriptor of a file drops the process's POSIX locks on it, SQLite's among them. */
    if (db->lock >= 0)
        close(db->lock);
    free(db->path);
    free(db);
}
