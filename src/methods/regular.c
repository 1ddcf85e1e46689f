/* `regular`: a fixed pattern of N normals, the same at every pixel, weighted by D (Kimura and Tokoi; 13 in the paper).
 *
 * The paper does not print its pattern. This one is a midpoint rule for the integral over (delta, theta): the normal N
 * itself and m rings at delta = j d, j = 1..m, of n_j points each, every other ring turned by half a step. A ring's point
 * stands for d x 2 pi/n_j of the domain, the centre for d x pi; each is weighted by D(delta) times that, and the weights are
 * scaled to sum to 1. 13 = 1 + 6 + 6. The rings reach to the quantile U = 1 - 1/(4 (m + 1)), so that more points cover more of
 * the tails. */
#include <math.h>

#include "methods/method.h"

/* Nearly as many rings as half the points on each: cells about as long as they are wide near the middle of the lobe. */
static int ring_count(int n)
{
    int m = (int)lround(sqrt((n - 1) / 3.0));
    return m < 1 ? 1 : m;
}

static void pattern(const struct rl_ellipsoid *e, int n, struct rl_microfacet *microfacets)
{
    microfacets[0] = (struct rl_microfacet){.x = 1.0, .weight = RL_PI * rl_ellipsoid_pdf(e, 0.0)};
    double sum = microfacets[0].weight;
    int m = n > 1 ? ring_count(n) : 0;
    double reach = rl_ellipsoid_inverse(e, 1.0 - 1.0 / (4.0 * (m + 1))).delta;
    double step = reach / (m + 0.5);
    int next = 1;
    for (int j = 1; j <= m; j++) {
        int count = (n - next) / (m - j + 1);
        double delta = step * j;
        double cell = 2.0 * RL_PI / count * rl_ellipsoid_pdf(e, delta);
        for (int i = 0; i < count; i++, next++) {
            double theta = 2.0 * RL_PI * (i + (j % 2 ? 0.0 : 0.5)) / count;
            microfacets[next] = (struct rl_microfacet){
                .x = cos(delta),
                .y = sin(delta) * cos(theta),
                .z = sin(delta) * sin(theta),
                .weight = cell,
            };
            sum += cell;
        }
    }
    for (int i = 0; i < n; i++)
        microfacets[i].weight /= sum;
}

const struct rl_method rl_method_regular = {
    .name = "regular",
    .summary = "a fixed pattern of N normals weighted by D, the same at every pixel (the paper: 13)",
    .on_gpu = true,
    .sampled = true,
    .default_samples = 13,
    .needs_environment = true,
    .needs_pattern = true,
    .pattern = pattern,
};
