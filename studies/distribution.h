/* Within the study `distribution`: plan (distribution.c), measuring (distribution_maps.c, distribution_generators.c) and claims
 * (distribution_claims.c). */
#ifndef RL_STUDIES_DISTRIBUTION_H
#define RL_STUDIES_DISTRIBUTION_H

#include "studies/study.h"

/* Bins of equal probability of the chi-square tests, and of the histogram that is kept. */
enum { RL_DISTRIBUTION_BINS = 64 };

/* Probability of any false alarm among all chi-square tests of a run. */
#define RL_DISTRIBUTION_LEVEL 0.01

/* "series=map": the texels of one normal map, by R_r, normal_bits and normal_size, as the GPU has them. Metrics: p_delta, p_theta,
 * phi2_delta, phi2_theta (goodness.h); kolmogorov of U; mean_u; mean_tilt, the angle between N and the mean normal; tilt, the part
 * of it that storing the normals did (against the same normals unrounded); width, the median |delta| over the distribution's.
 * Series delta_bins where `keep` is 1: observed over expected count. All n records are of one R_r and normal_size. */
int rl_distribution_measure_maps(struct rl_record *records, size_t n, struct rl_bench *bench,
                                 struct rl_error *error);

/* "series=point": one surface point at size x size pixels, a highlight's edge, estimated by `samples` normals from each `generator`
 * (lcg, baked, hash) with several seeds. Metrics: truth; bias, the mean error, over seeds; bias2, its square without what noise
 * adds to it; variance over pixels; floor and noise, the roots of these; bias_share, how much of a seed's squared error is its mean
 * error squared. "series=patch": a whole highlight over a plane patch, one seed; series picture, row by row. */
int rl_distribution_measure_generator(struct rl_record *r, struct rl_bench *bench, struct rl_error *error);

int rl_distribution_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
