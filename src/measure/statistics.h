/* Statistics of small samples: medians, means and fitted slopes, each with a confidence interval.
 *
 *     struct rl_interval m = rl_median_interval(ms, n, 0.95);      m.value, m.low, m.high
 */
#ifndef RL_MEASURE_STATISTICS_H
#define RL_MEASURE_STATISTICS_H

#include <stddef.h>

struct rl_interval {
    double value, low, high;
};

/* Of what is known without error. */
static inline struct rl_interval rl_exact_interval(double x)
{
    return (struct rl_interval){x, x, x};
}

/* Of what cannot be below 0, as times and ratios of times: an interval that reaches below it, as that of too few samples does, begins
 * at 0. It bounds nothing that was measured. */
static inline struct rl_interval rl_interval_from_0(struct rl_interval x)
{
    if (x.low < 0.0)
        x.low = 0.0;
    return x;
}

/* All of these take a confidence level in (0, 1). Where there is no answer (no samples, a NaN among them, no
 * memory) value, low and high are NaN. The samples are not changed. */

/* Median with the distribution-free interval from order statistics: the l-th smallest and the l-th largest of n samples span the
 * median but for a probability of 2 P(B < l), B binomial with n tries of 1/2 (David and Nagaraja 2003, section 7.1); l is the
 * largest that keeps to the level. Even the smallest and the largest miss it with 2^(1-n): for 95 % there must be 6 samples, for
 * 99 % 8. With fewer nothing is known at that level, and low and high are -infinity and infinity. */
struct rl_interval rl_median_interval(const double *samples, size_t n, double level);

/* Mean with Student's t interval; n = 1 gives an infinite one. */
struct rl_interval rl_mean_interval(const double *samples, size_t n, double level);

/* Median of the ratios a[i]/b[i] of paired samples, with its interval as above. */
struct rl_interval rl_ratio_interval(const double *a, const double *b, size_t n, double level);

/* Median of the differences a[i] - b[i] of paired samples, with its interval as above. */
struct rl_interval rl_difference_interval(const double *a, const double *b, size_t n, double level);

/* Slope of the least-squares line through (log x, log y), with Student's t interval; NaN for n < 3, for a
 * point that is not positive and finite, and where all x are the same. */
struct rl_interval rl_loglog_slope(const double *x, const double *y, size_t n, double level);

/* The factor on a standard error that makes a two-sided interval: Student's t of `freedom` > 0 degrees of
 * freedom. */
double rl_student_factor(double level, double freedom);

#endif
