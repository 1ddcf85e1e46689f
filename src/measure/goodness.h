/* Do samples follow a distribution? Of values that would be uniform on [0, 1] if they did: their cdf's values, or an angle's share of
 * its range.
 *
 *     struct rl_goodness g = {0};
 *     rl_goodness_make(&g, 65536, &error);
 *     for (...) rl_goodness_add(&g, U);
 *     struct rl_chi_square c = rl_goodness_chi_square(&g, 64);      c.p against rl_sidak_level(0.01, number of tests)
 *     struct rl_interval m = rl_goodness_misfit(&g, 64, 0.95);      how far, not whether: against a bound that matters
 *     struct rl_interval k = rl_goodness_kolmogorov(&g, 0.95);
 *     rl_goodness_clear(&g);
 *
 * Samples are counted in fine bins; the tests read the counts, so that millions of samples need neither memory nor sorting.
 */
#ifndef RL_MEASURE_GOODNESS_H
#define RL_MEASURE_GOODNESS_H

#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "measure/statistics.h"

struct rl_goodness {
    size_t n_bins, n; /* n: samples counted */
    uint64_t *count;
};

/* All counts zero. */
int rl_goodness_make(struct rl_goodness *goodness, size_t n_bins, struct rl_error *error);
void rl_goodness_clear(struct rl_goodness *goodness);

/* A value outside of [0, 1] counts at the nearer end; NaN at 0. */
void rl_goodness_add(struct rl_goodness *goodness, double value);

struct rl_chi_square {
    double statistic, freedom;
    double p; /* that chance alone gives as much or more */
    double
        phi2; /* (statistic - freedom)/n: the misfit itself, whatever the number of samples; near 0 if there is none */
};

/* Pearson's test with n_groups bins of equal probability; n_groups divides n_bins. NaN without samples. */
struct rl_chi_square rl_goodness_chi_square(const struct rl_goodness *goodness, size_t n_groups);

/* How far the distribution that the samples came from is from the uniform one: the root mean square, over n_groups bins of equal
 * probability, of a bin's share over the expected one less 1 (Cohen's w; at least twice the total variation distance over
 * these bins). What p cannot tell: few samples make a large p, but a wide interval. Value: the root of phi2, 0 where chance alone gives as
 * much. Interval: the non-central chi-square's, inverted (Sankaran's approximation, 1963), its halves widened where a misfit of
 * some size makes the crowded bins noisier than it knows; a fit better than chance's mean counts as that mean. NaN without samples. */
struct rl_interval rl_goodness_misfit(const struct rl_goodness *goodness, size_t n_groups, double level);

/* Observed over expected count in each of n_groups bins. */
void rl_goodness_ratios(double ratio[], const struct rl_goodness *goodness, size_t n_groups);

/* Largest distance between the samples' cdf and the line, taken at the bins' ends: at most 1/n_bins below the true one. The interval
 * is for the distance of the distribution that the samples came from (Dvoretzky, Kiefer and Wolfowitz, with Massart's constant). */
struct rl_interval rl_goodness_kolmogorov(const struct rl_goodness *goodness, double level);

/* The probability that n samples of the right distribution, not binned, are this far from it or farther by chance: Kolmogorov's limit
 * with the correction for n by Stephens (1970), good to a percent or so from n = 5 on. */
double rl_kolmogorov_p(double distance, size_t n);

/* The level of each of n independent tests for which all of them together give a false alarm with probability `level`: 1 - (1 - level)^(1/n)
 * (Sidak 1967); and the p of the smallest of n. */
double rl_sidak_level(double level, double n);
double rl_sidak_p(double smallest_p, double n);

#endif
