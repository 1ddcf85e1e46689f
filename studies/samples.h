/* Within the study `samples`: the judgement of its claims, apart from the measuring. */
#ifndef RL_STUDIES_SAMPLES_H
#define RL_STUDIES_SAMPLES_H

#include "studies/study.h"

/* Cases "series=methods": method x N x R_r x setting. Metrics rmse, noise (standard deviation over seeds), floor (root of bias^2),
 * bias2, variance. Cases "series=floor": env_size at one N and R_r, float normals. */
int rl_samples_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
