/* Within src/results: whether databases may be merged. */
#ifndef RL_RESULTS_MERGE_CHECK_H
#define RL_RESULTS_MERGE_CHECK_H

#include "results/merge.h"

/* RL_ERR_INPUT if one of the files is missing or broken, if a file is named twice, or, unless that is allowed, if they are mixed. */
int rl_merge_check(const struct rl_merge_options *options, struct rl_error *error);

#endif
