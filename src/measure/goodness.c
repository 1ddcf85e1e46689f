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
