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

/* Median with the distribution-free interval from order statistics (binomial); `level` in (0, 1). For n < 6 no such interval
 * reaches 95 %: low and high are then the smallest and largest sample. n = 0 gives NaN. The samples are not changed. */
struct rl_interval rl_median_interval(const double *samples, size_t n, double level);

/* Mean with Student's t interval; n = 1 gives an infinite one. */
struct rl_interval rl_mean_interval(const double *samples, size_t n, double level);

/* Median of the ratios a[i]/b[i] of paired samples, with its interval as above. */
struct rl_interval rl_ratio_interval(const double *a, const double *b, size_t n, double level);

/* Slope of the least-squares line through (log x, log y), with Student's t interval; needs n >= 3 positive points, else NaN. */
struct rl_interval rl_loglog_slope(const double *x, const double *y, size_t n, double level);

#endif
