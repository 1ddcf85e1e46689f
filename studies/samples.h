/* Within the study `samples`: plan (samples.c), measuring (samples_measure.c) and claims (samples_claims.c). */
#ifndef RL_STUDIES_SAMPLES_H
#define RL_STUDIES_SAMPLES_H

#include "studies/study.h"

/* Two kinds of groups: "series=methods", the methods at one N, R_r and setting; "series=floor", env_size ascending at one N
 * and R_r with float normals, the largest map last. Metrics: rmse, mae, bias, relmse, max; of squared error over seeds bias2 and
 * variance, as radiance floor and noise (their roots); texel_error (floor series: root of the bias against the largest map);
 * frame_ms where timed, with its series. */
int rl_samples_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                       const struct rl_scene *scene, struct rl_error *error);

int rl_samples_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
