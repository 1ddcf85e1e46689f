/* Has a figure changed since it was last known? One figure as a baseline has it against the same one measured now.
 *
 * Random figures have one value for each of n seeds. If nothing has changed, those of the baseline and those of now come from one
 * distribution, so its deviation is estimated from both together, and the difference of the means over its standard error follows
 * Student's t with n + n' - 2 degrees of freedom: exactly if the values are normal, whatever the number of seeds. (Welch's test, which
 * allows for two deviations, would give away most of its power to the few seeds of now, at levels as small as Sidak's: 8 seeds reach
 * 1e-6 at 11 standard errors, in place of 5.)
 *
 * Fixed figures have no noise: only rounding may move them, by at most a tolerance that comes with the baseline.
 *
 *     struct rl_regression r;
 *     rl_regression_random(&r, &before, &now, RL_BEST_LOWER, relevant, rl_sidak_level(1e-4, n));
 */
#ifndef RL_MEASURE_REGRESSION_H
#define RL_MEASURE_REGRESSION_H

#include <stdbool.h>
#include <stddef.h>

enum rl_change {
    RL_CHANGE_SAME,
    RL_CHANGE_BETTER,
    RL_CHANGE_WORSE,
    RL_CHANGE_INCONCLUSIVE,
    RL_CHANGE_INCOMPARABLE,
    RL_CHANGES
};

/* "same", "better", ... */
const char *rl_change_name(enum rl_change verdict);

/* Which change is an improvement. */
enum rl_best {
    RL_BEST_LOWER, /* an error: less is better */
    RL_BEST_ZERO,  /* a signed error: nearer to zero is better */
    RL_BEST_SAME   /* not an error but what must stay as it is: every change is for the worse */
};

/* A figure. Of a fixed one deviation is 0 and n is 1. */
struct rl_mean {
    double value;     /* the mean over seeds */
    double deviation; /* sample standard deviation over seeds */
    size_t n;         /* seeds, or pairs of them: independent values */
};

/* Mean and deviation of n >= 1 values; one value has deviation 0. Not finite if a value is not. */
struct rl_mean rl_mean_of(const double value[], size_t n);

struct rl_regression {
    enum rl_change verdict;
    double change; /* now less before */
    double
        half_width; /* of the interval for the true change, of confidence 1 - level; of fixed ones the tolerance */
    double
        detectable; /* the least change that is found in 9 cases of 10; of fixed ones the tolerance: always */
    double p;       /* two-sided; NaN of fixed ones */
    const char *reason; /* a few words where the figures alone do not say it, or "" */
};

/* The verdict is
 *     worse, better   if the interval for the change lies on one side of 0;
 *     same            if it holds 0 and no change as large as `relevant` > 0;
 *     inconclusive    if it holds both: a change that matters may have gone unseen, more seeds would tell.
 * Worse also where a value is not finite now, and where seeds make no difference any more. Both n >= 2; 0 < level < 1 is that of this
 * one test. */
void rl_regression_random(struct rl_regression *r, const struct rl_mean *before, const struct rl_mean *now,
                          enum rl_best best, double relevant, double level);

/* Same if the change is within `tolerance` >= 0, else better or worse; worse where the value is not finite now. */
void rl_regression_fixed(struct rl_regression *r, double before, double now, enum rl_best best,
                         double tolerance);

#endif
