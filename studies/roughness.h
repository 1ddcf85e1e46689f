/* Within the study `roughness`: plan (roughness.c), measuring (roughness_measure.c) and claims (roughness_claims.c). */
#ifndef RL_STUDIES_ROUGHNESS_H
#define RL_STUDIES_ROUGHNESS_H

#include "studies/study.h"

/* A group is one R_r. "series=methods": one setting, method and N, with the metrics of rl_seeds_add_error. "series=needed", after
 * those of its setting: variance_1, the variance of a single random normal, from N x variance over all N; floor and
 * floor_centre at the largest N; needed and needed_centre, the N at which
 *
 *     variance_1 / N + floor^2 = (1/255)^2
 *
 * rounded up, against either reference; infinite where the floor alone is 1/255 or more, at the value or at that end of its interval. */
int rl_roughness_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error);

int rl_roughness_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
