/* The results database: one SQLite file with every case measured, its figures, raw samples and where they come from.
 *
 *     struct rl_database *db;
 *     rl_database_open(&db, "build/results.db", RL_DATABASE_WRITE, &error);
 *     rl_run_identify(&run, environment);
 *     rl_database_begin_run(db, &run, &error);                   what is going to be measured
 *     rl_database_state(db, run.record[0].identity, &state, &error);
 *     ... measure ...
 *     rl_database_store(db, &run, first, n, &error);             one group, whole or not at all
 *     rl_database_close(db);
 *
 * Tables: provenance (program, machine, renderer), runs and run_cases (what each `study run` planned), cases (one row each, by
 * identity), metrics (value and interval), samples (raw figures in order). Every change is one transaction, so a killed
 * process leaves a file that holds each case wholly or not at all. One process writes at a time; others may read meanwhile.
 * Errors are one line that names the file: missing, read-only, locked, not a database, not roughlight's, damaged, disk full.
 */
#ifndef RL_RESULTS_DATABASE_H
#define RL_RESULTS_DATABASE_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "results/record.h"

struct rl_database;

enum rl_database_mode {
    RL_DATABASE_READ, /* the file must exist */
    RL_DATABASE_WRITE /* made, with its folder, if it does not exist; only one process at a time */
};

/* The folder that opening `path` for writing would create; "" if it is there. */
void rl_database_missing_folder(char folder[PATH_MAX], const char *path);

int rl_database_open(struct rl_database **db, const char *path, enum rl_database_mode mode,
                     struct rl_error *error);
/* NULL is fine. */
void rl_database_close(struct rl_database *db);

/* Notes a run: its provenance, its grid and all its records as planned. The records need their identities. Later calls of
 * rl_database_store refer to the latest run begun. */
int rl_database_begin_run(struct rl_database *db, const struct rl_run *run, struct rl_error *error);

/* What is known of the case of that identity: RL_RECORD_PLANNED if it has not been measured. */
int rl_database_state(struct rl_database *db, const char *identity, enum rl_record_status *state,
                      struct rl_error *error);

/* Stores `n` records of `run` from `first` on, OK or failed, in one transaction; each replaces what was there under its
 * identity. */
int rl_database_store(struct rl_database *db, const struct rl_run *run, size_t first, size_t n,
                      struct rl_error *error);

/* The latest run of a study with all that was measured for it, in the order of its plan; cases not yet measured have
 * RL_RECORD_PLANNED. A study never run gives an empty run. Free with rl_run_clear. */
int rl_database_load_run(struct rl_database *db, const char *study, struct rl_run *run,
                         struct rl_error *error);

/* Every case of a study that was measured without failing, in whatever run and environment, the latest first: what it is and the
 * seconds its group took, without figures. Free with rl_run_clear. */
int rl_database_load_times(struct rl_database *db, const char *study, struct rl_run *run,
                           struct rl_error *error);

#endif
