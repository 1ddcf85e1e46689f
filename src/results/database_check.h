/* Within src/results: whether a file that says it is a results database can be worked with. */
#ifndef RL_RESULTS_DATABASE_CHECK_H
#define RL_RESULTS_DATABASE_CHECK_H

#include "results/sql.h"

/* Before anything else is asked of a file: no code of its own is run that SQLite would run for it, and pages are looked at more closely. */
int rl_database_distrust(struct rl_database *db, struct rl_error *error);

/* RL_ERR_INPUT: the pages are damaged; there are other tables than those of `script` (CREATE TABLE statements, each with its semicolon), or
 * views or triggers; rows refer to none; a text, a hash or a number is none or does not fit. */
int rl_database_check(struct rl_database *db, const char *script, struct rl_error *error);

#endif
