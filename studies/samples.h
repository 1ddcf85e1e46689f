/* Within the study `samples`: plan (samples.c), measuring (samples_measure.c) and claims (samples_claims.c). */
#ifndef RL_STUDIES_SAMPLES_H
#define RL_STUDIES_SAMPLES_H

#include "studies/study.h"

/* Three kinds of cases: "series=methods", by setting, R_r and N; "series=floor", over env_size at one N and R_r with
 * float normals; "series=time", which are only timed, beside the methods of one R_r: setting none without a highlight, again a
 * second random 4. Metrics: rmse, mae, bias, relmse, max; of squared error over seeds bias2 and variance, and their roots floor
 * and noise; floor_centre, the same against a reference that sees the lights from the object's centre, and parallax, the RMSE
 * between the two references; where timed those of timing_arms.h, time_to_random4 among them. */
int rl_samples_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                       const struct rl_scene *scene, struct rl_error *error);

int rl_samples_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
