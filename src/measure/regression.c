/* Compares a figure with its baseline (see regression.h). */
#include "measure/regression.h"

#include <math.h>

#include <gsl/gsl_cdf.h>

#include "measure/statistics.h"
#include "measure/sum.h"

const char *rl_change_name(enum rl_change verdict)
{
    static const char *const name[RL_CHANGES] = {"same", "better", "worse", "inconclusive", "incomparable"};
    return name[verdict];
}

struct rl_mean rl_mean_of(const double value[], size_t n)
{
    struct rl_sum sum = {0}, squares = {0};
    for (size_t i = 0; i < n; i++)
        rl_sum_add(&sum, value[i]);
    double mean = rl_sum_value(&sum) / (double)n;
    for (size_t i = 0; i < n; i++)
        rl_sum_add(&squares, (value[i] - mean) * (value[i] - mean));
    double deviation = n > 1 ? sqrt(rl_sum_value(&squares) / ((double)n - 1.0)) : 0.0;
    return (struct rl_mean){mean, deviation, n};
}

/* Which of the two a change is that has been found. */
static enum rl_change direction(double before, double now, enum rl_best best)
{
    bool better =
        (best == RL_BEST_LOWER && now < before) || (best == RL_BEST_ZERO && fabs(now) < fabs(before));
    return better ? RL_CHANGE_BETTER : RL_CHANGE_WORSE;
}

static struct rl_regression not_finite(double change)
{
    return (struct rl_regression){RL_CHANGE_WORSE, change, NAN, NAN, NAN, "not finite"};
}

/* Of each single value, by both samples. */
static double pooled_deviation(const struct rl_mean *a, const struct rl_mean *b)
{
    double freedom_a = (double)a->n - 1.0, freedom_b = (double)b->n - 1.0;
    return sqrt((freedom_a * a->deviation * a->deviation + freedom_b * b->deviation * b->deviation) /
                (freedom_a + freedom_b));
}

void rl_regression_random(struct rl_regression *r, const struct rl_mean *before, const struct rl_mean *now,
                          enum rl_best best, double relevant, double level)
{
    const double z_90 = 1.2815515655446004; /* of the normal distribution 9 tenths lie below */
    double change = now->value - before->value;
    if (!isfinite(now->value) || !isfinite(now->deviation)) {
        *r = not_finite(change);
        return;
    }
    double freedom = (double)before->n + (double)now->n - 2.0;
    double deviation = pooled_deviation(before, now);
    double standard_error = deviation * sqrt(1.0 / (double)before->n + 1.0 / (double)now->n);
    double half_width = rl_student_factor(1.0 - level, freedom) * standard_error;
    double t = change == 0.0 ? 0.0 : fabs(change) / standard_error;
    *r = (struct rl_regression){.change = change,
                                .half_width = half_width,
                                .detectable = half_width + z_90 * standard_error,
                                .p = 2.0 * gsl_cdf_tdist_Q(t, freedom),
                                .reason = ""};
    if (now->deviation == 0.0 && before->deviation > 0.0) {
        r->verdict = RL_CHANGE_WORSE;
        r->reason = "seeds make no difference any more";
    } else if (fabs(change) > half_width) {
        r->verdict = direction(before->value, now->value, best);
    } else {
        r->verdict = fabs(change) + half_width < relevant ? RL_CHANGE_SAME : RL_CHANGE_INCONCLUSIVE;
    }
}

void rl_regression_fixed(struct rl_regression *r, double before, double now, enum rl_best best,
                         double tolerance)
{
    double change = now - before;
    if (!isfinite(now)) {
        *r = not_finite(change);
        return;
    }
    bool same = fabs(change) <= tolerance;
    *r = (struct rl_regression){.verdict = same ? RL_CHANGE_SAME : direction(before, now, best),
                                .change = change,
                                .half_width = tolerance,
                                .detectable = tolerance,
                                .p = NAN,
                                .reason = ""};
}
