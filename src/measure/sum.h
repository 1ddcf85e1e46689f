/* Compensated summation (Neumaier 1974): the error of the sum does not grow with the number of terms. */
#ifndef RL_MEASURE_SUM_H
#define RL_MEASURE_SUM_H

#include <math.h>

struct rl_sum {
    double total, lost; /* start at zero */
};

static inline void rl_sum_add(struct rl_sum *sum, double term)
{
    double next = sum->total + term;
    /* What the addition rounded away, recovered from the larger of the two. */
    sum->lost += fabs(sum->total) >= fabs(term) ? (sum->total - next) + term : (term - next) + sum->total;
    sum->total = next;
}

static inline double rl_sum_value(const struct rl_sum *sum)
{
    /* Beside an infinity `lost` is NaN. */
    return isfinite(sum->total) ? sum->total + sum->lost : sum->total;
}

#endif
