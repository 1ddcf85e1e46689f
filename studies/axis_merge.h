/* Within axis.c: of cases that an axis has made the same, which one is measured. */
#ifndef RL_STUDIES_AXIS_MERGE_H
#define RL_STUDIES_AXIS_MERGE_H

#include "results/record.h"

/* Makes cases that are the same one: that in the largest group, which has the most beside it to be held against; else the first. */
int rl_axis_merge(struct rl_run *run, struct rl_error *error);

/* What a case is measured for beside its errors: how many rounds it is timed, the columns of a map, a series kept. NULL at the end. */
extern const char *const rl_axis_extras[];

/* Drops cases with `key` 0 for which there is one that is the same but has more. A study measures a case twice, timed and not, only where
 * it is of two R_r, say. Where an axis makes them the same, that with the clock is enough; with both, a judge would find the one
 * without. */
void rl_axis_drop_less(struct rl_run *run, const char *key);

#endif
