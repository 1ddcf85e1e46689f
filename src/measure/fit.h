/* Models fitted by least squares: y = sum over terms of coefficient x term, each coefficient with a confidence interval.
 *
 *     double x[3][2] = {{1, 10}, {1, 20}, {1, 40}}, y[3] = {3, 5, 9};
 *     struct rl_fit line = rl_fit_least_squares(&x[0][0], y, NULL, 3, 2, 0.95);     line.coefficient[1].value: 0.2
 *
 * Times have noise in proportion to themselves, which points of one round share. For them there is rl_fit_rounds: relative residuals
 * count, and intervals come from drawing the rounds again (a bootstrap: Efron and Tibshirani 1993, chapters 6 and 13).
 */
#ifndef RL_MEASURE_FIT_H
#define RL_MEASURE_FIT_H

#include <stddef.h>
#include <stdint.h>

#include "measure/statistics.h"

enum { RL_FIT_TERMS_MAX = 4 };

/* Why there is no answer. */
enum rl_fit_refusal {
    RL_FIT_DONE,
    RL_FIT_FEW_POINTS,   /* no more of them than terms */
    RL_FIT_NOT_FINITE,   /* a y, or a term */
    RL_FIT_NOT_POSITIVE, /* of rl_fit_rounds: a y that relative residuals cannot be taken of */
    RL_FIT_DEPENDENT,    /* terms are multiples of one another, or 0 everywhere */
    RL_FIT_INVALID       /* arguments out of their range; no memory */
};

struct rl_fit {
    struct rl_interval
        coefficient[RL_FIT_TERMS_MAX]; /* of as many terms as were asked for; the others are NaN */
    double r2; /* 1 - (residuals' squares / squares about the mean), weighted; below 0: worse than the mean */
    double residual; /* standard deviation of (y - model)/y, for as many degrees of freedom as are left */
    struct rl_interval worst; /* the largest |y - model|/|y|; its interval only from rl_fit_rounds */
    size_t worst_point;
    enum rl_fit_refusal refusal; /* of rl_fit_rounds */
    size_t refused_point; /* of RL_FIT_NOT_FINITE, RL_FIT_NOT_POSITIVE: the first such one, and its y */
    double refused_y;
};

/* x: n rows of n_terms values; weight: n, in proportion to 1/variance, or NULL for equal ones. Intervals are Student's, with the
 * variance taken from the residuals: right where residuals are independent and normal. All NaN where there is no answer:
 * no more points than terms, values that are not finite, terms that are multiples of one another, no memory. */
struct rl_fit rl_fit_least_squares(const double *x, const double *y, const double *weight, size_t n,
                                   int n_terms, double level);

/* A point that was measured over and over: y is the median over rounds of sample[r] - minus[r] (minus NULL: 0). */
struct rl_fit_point {
    double x[RL_FIT_TERMS_MAX];
    const double *sample, *minus;
    size_t n;  /* rounds */
    int block; /* points of one block were measured in the same rounds: these are drawn together */
};

/* Every point weighs 1/y^2. The intervals hold the middle `level` of what `resamples` draws of rounds give, and the value. NaN as above, and where a
 * y is not above 0: `refusal` says why. Points of a block have equally many rounds. */
struct rl_fit rl_fit_rounds(const struct rl_fit_point *point, size_t n, int n_terms, double level,
                            int resamples, uint64_t seed);

#endif
