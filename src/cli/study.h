/* Within src/cli: the verbs of `roughlight study` that have files of their own, and what they share. */
#ifndef RL_CLI_STUDY_H
#define RL_CLI_STUDY_H

#include <limits.h>
#include <stddef.h>

#include "cli/command.h"
#include "studies/study.h"

/* --db, or build/results.db */
const char *rl_study_database(const struct rl_arguments *arguments);
/* References are kept beside the database. */
void rl_study_cache(char cache[PATH_MAX], const struct rl_arguments *arguments);

/* Each case of the latest run of these studies that failed, a line each on stderr; and, if asked for, each that no one has measured.
 * Returns how many were named. */
size_t rl_study_name_failures(const struct rl_study *const *studies, size_t n, const char *database,
                              bool missing);

/* What --axis takes, study by study; the tables that export writes, with their columns. */
void rl_study_print_axes(void);
void rl_study_print_tables(void);

/* Each returns an rl_exit, as rl_command.run does. */
int rl_study_run_command(const struct rl_arguments *arguments, struct rl_error *error);

int rl_study_merge_command(const struct rl_arguments *arguments, struct rl_error *error);
int rl_study_check_command(const struct rl_arguments *arguments, struct rl_error *error);
int rl_study_status_command(const struct rl_arguments *arguments, struct rl_error *error);

#endif
