/* Intervals for medians, means, ratios and slopes (see statistics.h). */
#include "measure/statistics.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include "measure/sum.h"

static const struct rl_interval unknown = {.value = NAN, .low = NAN, .high = NAN};

static bool valid_level(double level)
{
    return level > 0.0 && level < 1.0;
}

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a;
    double y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The largest l for which P(B < l) <= tail, B binomial with n tries of 1/2: l samples from either end span an
 * interval that misses the median with probability 2 P(B < l). 0: even the extremes miss it more often, and only the whole line
 * does not. */
static size_t rank_from_end(size_t n, double tail)
{
    size_t low = 0;
    size_t high = n / 2;
    while (low < high) {
        size_t middle = (low + high + 1) / 2;
        if (gsl_cdf_binomial_P((unsigned)(middle - 1), 0.5, (unsigned)n) <= tail)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

/* Sorts its argument. */
static struct rl_interval median_of(double *samples, size_t n, double level)
{
    for (size_t i = 0; i < n; i++)
        if (isnan(samples[i]))
            return unknown;
    qsort(samples, n, sizeof *samples, compare_doubles);
    size_t rank = rank_from_end(n, 0.5 * (1.0 - level));
    double lower = samples[(n - 1) / 2];
    double upper = samples[n / 2];
    return (struct rl_interval){
        .value = lower == upper ? lower : 0.5 * lower + 0.5 * upper,
        .low = rank > 0 ? samples[rank - 1] : -INFINITY,
        .high = rank > 0 ? samples[n - rank] : INFINITY,
    };
}

enum pairing { FIRST_ALONE, RATIO, DIFFERENCE };

static struct rl_interval paired_median(const double *a, const double *b, size_t n, double level,
                                        enum pairing pairing)
{
    double *scratch = n > 0 && valid_level(level) ? malloc(n * sizeof *scratch) : NULL;
    if (!scratch)
        return unknown;
    for (size_t i = 0; i < n; i++)
        scratch[i] = pairing == RATIO ? a[i] / b[i] : pairing == DIFFERENCE ? a[i] - b[i] : a[i];
    struct rl_interval result = median_of(scratch, n, level);
    free(scratch);
    return result;
}

struct rl_interval rl_median_interval(const double *samples, size_t n, double level)
{
    return paired_median(samples, NULL, n, level, FIRST_ALONE);
}

struct rl_interval rl_ratio_interval(const double *a, const double *b, size_t n, double level)
{
    return paired_median(a, b, n, level, RATIO);
}

struct rl_interval rl_difference_interval(const double *a, const double *b, size_t n, double level)
{
    return paired_median(a, b, n, level, DIFFERENCE);
}

double rl_student_factor(double level, double freedom)
{
    return gsl_cdf_tdist_Pinv(0.5 + 0.5 * level, freedom);
}

struct rl_interval rl_mean_interval(const double *samples, size_t n, double level)
{
    if (n == 0 || !valid_level(level))
        return unknown;
    struct rl_sum sum = {0};
    for (size_t i = 0; i < n; i++)
        rl_sum_add(&sum, samples[i]);
    double mean = rl_sum_value(&sum) / (double)n;
    if (isnan(mean))
        return unknown;
    if (n == 1)
        return (struct rl_interval){.value = mean, .low = -INFINITY, .high = INFINITY};
    struct rl_sum squares = {0};
    for (size_t i = 0; i < n; i++)
        rl_sum_add(&squares, (samples[i] - mean) * (samples[i] - mean));
    double variance = rl_sum_value(&squares) / ((double)n - 1.0);
    double half = rl_student_factor(level, (double)n - 1.0) * sqrt(variance / (double)n);
    return (struct rl_interval){.value = mean, .low = mean - half, .high = mean + half};
}

/* `log_x` and `log_y` have room for n. */
static struct rl_interval slope_of_logs(double *log_x, double *log_y, const double *x, const double *y,
                                        size_t n, double level)
{
    bool all_same = true;
    for (size_t i = 0; i < n; i++) {
        if (!(x[i] > 0.0) || !(y[i] > 0.0) || isinf(x[i]) || isinf(y[i]))
            return unknown;
        log_x[i] = log(x[i]);
        log_y[i] = log(y[i]);
        all_same = all_same && log_x[i] == log_x[0];
    }
    if (all_same)
        return unknown;
    double intercept = 0.0;
    double slope = 0.0;
    double var_intercept = 0.0;
    double covariance = 0.0;
    double var_slope = 0.0;
    double residual = 0.0;
    gsl_fit_linear(log_x, 1, log_y, 1, n, &intercept, &slope, &var_intercept, &covariance, &var_slope,
                   &residual);
    double half = rl_student_factor(level, (double)n - 2.0) * sqrt(var_slope);
    return (struct rl_interval){.value = slope, .low = slope - half, .high = slope + half};
}

struct rl_interval rl_loglog_slope(const double *x, const double *y, size_t n, double level)
{
    double *logs = n >= 3 && valid_level(level) ? malloc(2 * n * sizeof *logs) : NULL;
    if (!logs)
        return unknown;
    struct rl_interval result = slope_of_logs(logs, logs + n, x, y, n, level);
    free(logs);
    return result;
}
