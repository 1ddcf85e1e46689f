/* Tests of fit on counts in fine bins (see goodness.h). */
#include "measure/goodness.h"

#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_cdf.h>

int rl_goodness_make(struct rl_goodness *goodness, size_t n_bins, struct rl_error *error)
{
    *goodness = (struct rl_goodness){.n_bins = n_bins, .count = calloc(n_bins, sizeof *goodness->count)};
    return goodness->count ? RL_OK : rl_fail_memory(error, "a histogram");
}

void rl_goodness_clear(struct rl_goodness *goodness)
{
    free(goodness->count);
    *goodness = (struct rl_goodness){0};
}

void rl_goodness_add(struct rl_goodness *goodness, double value)
{
    double scaled = fmin(fmax(value, 0.0), 1.0) * (double)goodness->n_bins;
    size_t bin = (size_t)scaled;
    goodness->count[bin < goodness->n_bins ? bin : goodness->n_bins - 1]++;
    goodness->n++;
}

static double group_count(const struct rl_goodness *goodness, size_t n_groups, size_t group)
{
    uint64_t sum = 0;
    size_t width = goodness->n_bins / n_groups;
    for (size_t i = group * width; i < (group + 1) * width; i++)
        sum += goodness->count[i];
    return (double)sum;
}

struct rl_chi_square rl_goodness_chi_square(const struct rl_goodness *goodness, size_t n_groups)
{
    struct rl_chi_square c = {NAN, (double)n_groups - 1.0, NAN, NAN};
    if (goodness->n == 0)
        return c;
    double expected = (double)goodness->n / (double)n_groups;
    c.statistic = 0.0;
    for (size_t g = 0; g < n_groups; g++) {
        double excess = group_count(goodness, n_groups, g) - expected;
        c.statistic += excess * excess / expected;
    }
    c.p = gsl_cdf_chisq_Q(c.statistic, c.freedom);
    c.phi2 = (c.statistic - c.freedom) / (double)goodness->n;
    return c;
}

/* P(X <= x) for non-central chi-square of `freedom` and non-centrality `lambda`: a power of X/(freedom + lambda) is nearly normal
 * (Sankaran 1963; as Johnson, Kotz and Balakrishnan give it, Continuous Univariate Distributions 2, 1995, section 29.8). With 63
 * degrees of freedom it is within 0.001 where intervals end (tests/measure/test_goodness.c). */
static double noncentral_cdf(double x, double freedom, double lambda)
{
    double mean = freedom + lambda, spread = freedom + 2.0 * lambda;
    double h = 1.0 - 2.0 / 3.0 * mean * (freedom + 3.0 * lambda) / (spread * spread);
    double p = spread / (mean * mean), m = (h - 1.0) * (1.0 - 3.0 * h);
    double centre = 1.0 + h * p * (h - 1.0 - 0.5 * (2.0 - h) * m * p);
    return gsl_cdf_ugaussian_P((pow(x / mean, h) - centre) / (h * sqrt(2.0 * p) * (1.0 + 0.5 * m * p)));
}

/* The non-centrality at which x is the quantile `share`: the cdf falls as it grows. 0 where it would be negative. */
static double noncentrality(double x, double freedom, double share)
{
    if (noncentral_cdf(x, freedom, 0.0) <= share)
        return 0.0;
    double low = 0.0, high = freedom;
    while (noncentral_cdf(x, freedom, high) > share) {
        low = high;
        high *= 2.0;
    }
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        *(noncentral_cdf(x, freedom, middle) > share ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

/* How much wider the statistic spreads than if the bins were alike: it goes by the variance of the bins' ratios over the samples,
 * which the non-central chi-square takes over the bins. */
static double excess_spread(const struct rl_goodness *goodness, size_t n_groups, double mean_square)
{
    double n = (double)goodness->n, mean = 0.0, square = 0.0;
    for (size_t g = 0; g < n_groups; g++) {
        double share = group_count(goodness, n_groups, g) / n, off = share * (double)n_groups - 1.0;
        mean += share * off;
        square += share * off * off;
    }
    return mean_square > 0.0 ? sqrt(fmax(1.0, (square - mean * mean) / mean_square)) : 1.0;
}

struct rl_interval rl_goodness_misfit(const struct rl_goodness *goodness, size_t n_groups, double level)
{
    struct rl_chi_square c = rl_goodness_chi_square(goodness, n_groups);
    if (isnan(c.statistic))
        return (struct rl_interval){NAN, NAN, NAN};
    double n = (double)goodness->n, tail = 0.5 * (1.0 - level);
    double value = sqrt(fmax(c.phi2, 0.0));
    double low = sqrt(noncentrality(c.statistic, c.freedom, 1.0 - tail) / n);
    double high = sqrt(noncentrality(fmax(c.statistic, c.freedom), c.freedom, tail) / n);
    double wider = excess_spread(goodness, n_groups, c.statistic / n);
    return (struct rl_interval){value, fmax(value - wider * (value - fmin(low, value)), 0.0),
                                value + wider * (fmax(high, value) - value)};
}

void rl_goodness_ratios(double ratio[], const struct rl_goodness *goodness, size_t n_groups)
{
    for (size_t g = 0; g < n_groups; g++)
        ratio[g] = group_count(goodness, n_groups, g) * (double)n_groups / (double)goodness->n;
}

struct rl_interval rl_goodness_kolmogorov(const struct rl_goodness *goodness, double level)
{
    if (goodness->n == 0)
        return (struct rl_interval){NAN, NAN, NAN};
    double largest = 0.0;
    uint64_t below = 0;
    for (size_t i = 0; i + 1 < goodness->n_bins; i++) {
        below += goodness->count[i];
        double line = (double)(i + 1) / (double)goodness->n_bins;
        largest = fmax(largest, fabs((double)below / (double)goodness->n - line));
    }
    double band = sqrt(log(2.0 / (1.0 - level)) / (2.0 * (double)goodness->n));
    return (struct rl_interval){largest, fmax(largest - band, 0.0), largest + band};
}

double rl_kolmogorov_p(double distance, size_t n)
{
    double root = sqrt((double)n), lambda = (root + 0.12 + 0.11 / root) * distance, sum = 0.0;
    /* Below, the series converges slowly, and the answer is 1 to nine digits. */
    if (lambda < 0.28)
        return 1.0;
    for (int k = 1; k <= 20; k++)
        sum += (k % 2 ? 2.0 : -2.0) * exp(-2.0 * k * k * lambda * lambda);
    return fmin(fmax(sum, 0.0), 1.0);
}

double rl_sidak_level(double level, double n)
{
    return -expm1(log1p(-level) / n);
}

double rl_sidak_p(double smallest_p, double n)
{
    return smallest_p < 1.0 ? -expm1(n * log1p(-smallest_p)) : 1.0;
}
