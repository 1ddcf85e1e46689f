/* Within the study `budget`: plan (budget.c), measuring (budget_measure.c) and claims (budget_claims.c). */
#ifndef RL_STUDIES_BUDGET_H
#define RL_STUDIES_BUDGET_H

#include "studies/study.h"

/* One group for each R_r, of the arms base, sampling, normals, map, format, sphere, frame (the GPU's, with one setting of the
 * base changed), parallax and bits (of the reference), and all. What each is held against is in budget_measure.c.
 *
 * Metrics: mse, rmse, bias, with intervals over seeds and by the tolerance of the references that they rest on; of all arms but base and all, share, their part of the sum of mse; of
 * all, interaction: its mse less that sum, and interaction_share, the same over its mse. */
int rl_budget_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                      const struct rl_scene *scene, struct rl_error *error);

int rl_budget_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
