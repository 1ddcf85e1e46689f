/* Runs studies: plans their cases, skips those the database already has, measures the rest group by group.
 *
 * A case that fails is kept with its message and does not stop the others; it is left alone until a run asks for it (retry). Each
 * group is stored as soon as it is measured, so that an interruption, however rude, loses at most the group that was being measured.
 *
 * Where the time of a group went (spent.h) is kept with its first case, as the metrics spent_measured, spent_reference, spent_setup and
 * spent_evaluation, seconds.
 */
#ifndef RL_STUDIES_RUNNER_H
#define RL_STUDIES_RUNNER_H

#include <stddef.h>

#include "base/error.h"
#include "base/progress.h"
#include "studies/planner.h"
#include "studies/spent.h"

struct rl_run_outcome {
    size_t planned; /* cases; of the shard, if one was asked for, as all of these */
    size_t measured, skipped;
    size_t failed;                  /* in this run or, without retry, before */
    double seconds[RL_SPENT_KINDS]; /* of the whole run, from its call to its end */
};

/* All studies are planned before the first is measured. RL_OK even if cases failed: look at the outcome. RL_ERR_CANCELLED: what was
 * finished is kept. */
int rl_studies_run(struct rl_run_outcome *outcome, const struct rl_study *const *studies, size_t n_studies,
                   const struct rl_run_options *options, const struct rl_progress *progress,
                   struct rl_error *error);

#endif
