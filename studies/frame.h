/* Within the study `frame`: plan and tables (frame.c), measuring (frame_measure.c) and claims (frame_claims.c). */
#ifndef RL_STUDIES_FRAME_H
#define RL_STUDIES_FRAME_H

#include "studies/study.h"

/* "series=lobe", by R_r: `points` normals N spread evenly over the sphere, `samples` microfacet normals of each in both frames.
 * Metrics: width, the mean over N of printed over orthonormal median |delta|; width90, of the 90 % quantile; against_formula, the
 * geometric mean of measured over expected width; worst, of all N; half, the share of the sphere where the width is below a half. With
 * columns > 0 a series map, width by row of latitude and column of longitude.
 * "series=light", by R_r and place of the light about the mirror direction: the reference's L_o at each N, eye and light turning with
 * it. Metrics: orthonormal, and its spread over N, which is none; rms, max and mean of the printed frame's difference. Series
 * profile: pairs of |n_x| and difference.
 * "series=scene": the same scene by the reference in both frames: rmse, max, bias, share of pixels that move by more than 1/255. */
int rl_frame_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                     const struct rl_scene *scene, struct rl_error *error);

int rl_frame_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
