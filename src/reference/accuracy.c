/* Accuracy reached, pixel by pixel (see accuracy.h). */
#include "reference/accuracy.h"

#include <math.h>

/* Measured over the example scenes: the panels' first rule is nine tenths of an image's time whatever the tolerance from 1e-1 to
 * 1e-5, so nothing is gained by a pass looser than 1e-2; and after it a factor of 100 more costs 20 per cent at most. */
static const double loosest = 1e-2, step = 1e-2;

/* Of the tolerance, how much a loose pass must reach for the last one to stop at the same step: rl_integrate_lines keeps a
 * hundredth back for rounding. */
static const double surely = 0.98;

int rl_accuracy_passes(double tolerance[RL_PASSES_MAX], double wanted)
{
    /* One pass less than a step that would hardly be one. */
    const double barely = 3.0;
    double t = loosest;
    int n = 0;
    while (n < RL_PASSES_MAX - 1 && t > barely * wanted) {
        tolerance[n++] = t;
        t *= step;
    }
    tolerance[n++] = wanted;
    return n;
}

static double worst(const double error[3])
{
    return fmax(error[0], fmax(error[1], error[2]));
}

/* The float at or above x >= 0. */
static float round_up(double x)
{
    float f = (float)x;
    return (double)f < x ? nextafterf(f, INFINITY) : f;
}

bool rl_accuracy_improve(struct rl_accuracy *reached, const struct rl_estimate *estimate, double wanted,
                         bool last)
{
    double error = worst(estimate->error);
    if (reached->drawn) {
        double before = worst((const double[3]){reached->error[0], reached->error[1], reached->error[2]});
        if (!(error <= before))
            return false;
    }
    for (int c = 0; c < 3; c++)
        reached->error[c] = round_up(estimate->error[c]);
    reached->drawn = true;
    reached->done = last ? estimate->converged : error <= surely * wanted;
    return true;
}

void rl_accuracy_summarise(struct rl_accuracy_summary *summary, const struct rl_accuracy *reached,
                           const struct rl_image *image)
{
    *summary = (struct rl_accuracy_summary){0};
    double sum = 0.0, squares = 0.0;
    size_t n = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < n; i++) {
        if (!reached[i].drawn)
            continue;
        summary->foreground++;
        summary->within += reached[i].done;
        for (int c = 0; c < 3; c++) {
            double error = reached[i].error[c];
            summary->worst_error = fmax(summary->worst_error, error);
            sum += error;
            squares += error * error;
            summary->nonfinite += !isfinite(image->data[i * (size_t)image->channels + (size_t)c]);
        }
    }
    double values = fmax(1.0, 3.0 * (double)summary->foreground);
    summary->mean_error = sum / values;
    summary->rms_error = sqrt(squares / values);
}
