/* Within the study `accuracy`: plan (accuracy.c), measuring (accuracy_points.c, accuracy_images.c, accuracy_kernel.c) and claims
 * (accuracy_claims.c; accuracy_image_claims.c). */
#ifndef RL_STUDIES_ACCURACY_H
#define RL_STUDIES_ACCURACY_H

#include "measure/statistics.h"
#include "studies/judging.h"
#include "studies/study.h"

/* "part=points": one integrator at one tolerance on the fixed points of one kind of light (points.h). The cases of a group take turns at
 * every point. Time is of the thread's own clock, so that what else the machine does does not count: the median of several
 * repeats after an untimed evaluation where one takes less than 2 ms, else that one. Truth is the reference at 1e-13.
 *
 * Metrics: time_us, true_error (medians over points), error_p90, error_max, bounded (share of points at which the stated error
 * is no less than the true one), within (at which the true error is no more than the tolerance), converged (at which the integrator says so),
 * evaluations. Series, by point: time_us, true_error, stated_error, converged. */
int rl_accuracy_measure_points(struct rl_record *records, size_t n, struct rl_bench *bench,
                               struct rl_error *error);

/* "part=images": a whole image on some threads, by the clock on the wall. Cases of a group take turns round by round. Metrics: seconds,
 * worst_error (the largest that is stated of any pixel), unconverged, lines, texel_normals (per second; exhaustive). Series, by round:
 * seconds, others (how many cores' worth of time other programs took of those that this one may use). */
int rl_accuracy_measure_images(struct rl_record *records, size_t n, struct rl_bench *bench,
                               const struct rl_scene *scene, struct rl_error *error);

/* "part=kernel": exhaustive's inner loop alone (texel_sum.h), by instruction set and threads. Metric and series, by round:
 * texel_normals, per second. */
int rl_accuracy_measure_kernel(struct rl_record *records, size_t n, struct rl_bench *bench,
                               struct rl_error *error);

int rl_accuracy_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

/* Those about one scene's images. */
int rl_accuracy_judge_images(const struct rl_judging *j);

/* Seconds that an image of 640x480 to 1e-6 of that scene, one of those that come with the program, may take; NaN: there is no bar. */
double rl_accuracy_bar(const char *scene);

#endif
