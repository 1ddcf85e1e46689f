/* Within the study `distribution`: plan (distribution.c), measuring (distribution_maps.c, distribution_generators.c), what maps are held
 * against (distribution_truth.c) and claims (distribution_claims.c). */
#ifndef RL_STUDIES_DISTRIBUTION_H
#define RL_STUDIES_DISTRIBUTION_H

#include <stdbool.h>

#include "studies/study.h"

/* Bins of equal probability of the chi-square tests, and of the histogram that is kept. */
enum { RL_DISTRIBUTION_BINS = 64 };

/* D's cdf by integration of its density as published, apart from all that normals are drawn by (distribution_truth.c). Angles in
 * radians. R_r from 0.01 to 1e6. */
enum { RL_DISTRIBUTION_STEPS = 2048 };
struct rl_distribution_truth {
    double rr;
    bool smooth;  /* rr >= 1: the peak is at delta = 0 */
    double width; /* of the peak; steps are even in asinh(angle from the peak / width) */
    double step;
    double share[RL_DISTRIBUTION_STEPS + 1]; /* of D from the peak to a step's end */
    double slope[RL_DISTRIBUTION_STEPS + 1]; /* of the share there, by the step */
    double median;                           /* of |delta| */
    double rms_sine;                         /* root mean square of sin(delta) */
};
void rl_distribution_truth_make(struct rl_distribution_truth *truth, double rr);

/* U in [0, 1] from sin(delta) and cos(delta) >= 0, whose length may be any. */
double rl_distribution_truth_cdf(const struct rl_distribution_truth *truth, double sin_delta,
                                 double cos_delta);

/* The |delta| that a share `inner` in [0, 1] of D is within. */
double rl_distribution_truth_quantile(const struct rl_distribution_truth *truth, double inner);

/* "series=map": the texels of one normal map, by R_r, normal_bits and normal_size, as the GPU has them. Metrics: p_delta, p_theta,
 * phi2_delta, phi2_theta, misfit_delta, misfit_theta (goodness.h); kolmogorov of U; mean_u; d_median and d_rms_sine, D's own; mean_tilt, the angle between N and the mean normal; tilt, the part
 * of it that storing the normals did (against the same normals unrounded); width, the median |delta| over the distribution's.
 * Series delta_bins where `keep` is 1: observed over expected count. All n records are of one R_r and normal_size. */
int rl_distribution_measure_maps(struct rl_record *records, size_t n, struct rl_bench *bench,
                                 struct rl_error *error);

/* "series=point": one surface point at size x size pixels, a highlight's edge, estimated by `samples` normals from each `generator`
 * (lcg, baked, hash) with `seeds` seeds from `seed` (1) on. Metrics: truth; bias, the mean error, over seeds; bias2, its square
 * without what noise adds to it; variance over pixels; floor and noise, the roots of these; bias_share, how much of a seed's squared
 * error is its mean error squared. "series=patch": a whole highlight over a plane patch, one seed; series picture, row by row. */
int rl_distribution_measure_generator(struct rl_record *r, struct rl_bench *bench, struct rl_error *error);

int rl_distribution_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
