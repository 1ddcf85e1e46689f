/* D's own cdf, against which normal maps are held. It is integrated from the density as published (Trowbridge and Reitz 1975),
 *
 *     f(delta) = cos(delta) / (cos^2(delta) + R^2 sin^2(delta))
 *
 * but for a constant that its whole integral gives, and from the R_r that was asked for. None of src/model is used: its cdf is the inverse
 * of what normals are drawn by, so that held against it they would fit whatever R_r both took.
 *
 * f is even and has its peak at delta = 0 where R > 1, at +-90 degrees where R < 1, of a width of about 1/R or R. With x the angle from
 * the peak and x = width sinh(z) it is smooth at every scale, so that even steps of z do: Gauss-Legendre within each, and between
 * their ends the cubic that has both ends' values and densities (tests/studies/test_distribution.c: within 1e-10). */
#include <math.h>

#include "model/vec3.h"
#include "studies/distribution.h"

enum { STEPS = RL_DISTRIBUTION_STEPS };

/* f dx/dz at z; and times sin^2(delta). */
static double density(const struct rl_distribution_truth *t, double z, double *square)
{
    double x = t->width * sinh(z);
    double sine = t->smooth ? sin(x) : cos(x), cosine = t->smooth ? cos(x) : sin(x);
    double f = cosine / (cosine * cosine + t->rr * t->rr * sine * sine) * t->width * cosh(z);
    *square = f * sine * sine;
    return f;
}

void rl_distribution_truth_make(struct rl_distribution_truth *t, double rr)
{
    /* Gauss-Legendre of four points (Abramowitz and Stegun, table 25.4). */
    static const double node[] = {-0.861136311594053, -0.339981043584856, 0.339981043584856,
                                  0.861136311594053};
    static const double weight[] = {0.347854845137454, 0.652145154862546, 0.652145154862546,
                                    0.347854845137454};
    *t = (struct rl_distribution_truth){.rr = rr, .smooth = rr >= 1.0, .width = rr >= 1.0 ? 1.0 / rr : rr};
    t->step = asinh(0.5 * RL_PI / t->width) / STEPS;
    double squares = 0.0, square;
    for (int i = 0; i < STEPS; i++) {
        double here = 0.0;
        for (int k = 0; k < 4; k++) {
            here += 0.5 * t->step * weight[k] * density(t, t->step * (i + 0.5 + 0.5 * node[k]), &square);
            squares += 0.5 * t->step * weight[k] * square;
        }
        t->share[i + 1] = t->share[i] + here;
    }
    double total = t->share[STEPS];
    for (int i = 0; i <= STEPS; i++) {
        t->share[i] /= total;
        t->slope[i] = density(t, t->step * i, &square) * t->step / total;
    }
    t->rms_sine = sqrt(squares / total);
    t->median = rl_distribution_truth_quantile(t, 0.5);
}

/* The cubic in step i that has the ends' values and slopes, at 0 <= a <= 1. */
static double within(const struct rl_distribution_truth *t, int i, double a)
{
    double b = 1.0 - a, rise = t->share[i + 1] - t->share[i];
    return t->share[i] + a * a * (3.0 - 2.0 * a) * rise + a * b * (b * t->slope[i] - a * t->slope[i + 1]);
}

double rl_distribution_truth_cdf(const struct rl_distribution_truth *t, double sin_delta, double cos_delta)
{
    double sine = fabs(sin_delta), x = t->smooth ? atan2(sine, cos_delta) : atan2(cos_delta, sine);
    double at = asinh(x / t->width) / t->step;
    int i = at < STEPS - 1 ? (int)at : STEPS - 1;
    double share = within(t, i, fmin(at - i, 1.0)), inner = t->smooth ? share : 1.0 - share;
    return sin_delta < 0.0 ? 0.5 - 0.5 * inner : 0.5 + 0.5 * inner;
}

double rl_distribution_truth_quantile(const struct rl_distribution_truth *t, double inner)
{
    double share = t->smooth ? inner : 1.0 - inner;
    int i = 0;
    while (i < STEPS - 1 && t->share[i + 1] < share)
        i++;
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 50; k++) {
        double middle = 0.5 * (low + high);
        *(within(t, i, middle) < share ? &low : &high) = middle;
    }
    double x = t->width * sinh(t->step * (i + low));
    return t->smooth ? x : 0.5 * RL_PI - x;
}
