/* Adaptive integration of a vector-valued function over several panels at once, by the 7-point Gauss rule where that is good
 * enough, else by the 15-point Kronrod rule that goes on from its points (rule.h).
 *
 *     I = sum over panels of the integral of f from a to b
 *
 * The panels' ends are where f is known to break. Always the worst piece is halved, wherever it lies, until the largest
 * component's summed error is within the tolerance. Where f behaves like a square root of the distance from a point at or a
 * little beyond a panel's end (a line that touches an edge, or would touch it if the edge went on), the variable is changed so
 * that f becomes smooth: with the roots at r before a and at s beyond b,
 *
 *     x = r + v^2;    x = s - v^2;    x = (r + s)/2 - (s - r)/2 cos(v)  for both
 *
 * f is asked for up to 8 points at once, so that it may work on them side by side.
 *
 *     struct rl_panel panel = {.a = 0.0, .b = 1.0};
 *     rl_quadrature(&result, f, user, &panel, 1, &(struct rl_quadrature_options){.tolerance = 1e-8, .controlled = 1});
 */
#ifndef RL_REFERENCE_QUADRATURE_H
#define RL_REFERENCE_QUADRATURE_H

#include <stdbool.h>
#include <stddef.h>

#include "reference/rule.h"

enum { RL_QUADRATURE_CONTROLLED = 3, RL_QUADRATURE_COMPONENTS = 4 };

struct rl_panel {
    double a, b;
    bool root_at_a, root_at_b;
    double gap_a, gap_b; /* how far beyond that end the root lies, >= 0 */
};

/* value[component][i] = f(x[i]), i = 0 .. n - 1, all inside `panel`, of which x[n / 2] is near the middle; n is 7 or 8, and x[7] is a
 * valid place in either case. The first three components are controlled; the fourth is only summed along. Returns whether f may
 * differ from 0 anywhere in the panel; if not, a fresh panel is left out, and counts as one evaluation. */
typedef bool rl_quadrature_function(double value[RL_QUADRATURE_COMPONENTS][RL_RULE_BATCH],
                                    const double x[RL_RULE_BATCH], int n, const struct rl_panel *panel,
                                    void *user);

struct rl_quadrature_options {
    double tolerance;       /* absolute, on the largest controlled component */
    size_t max_evaluations; /* 0: 100000 */
    bool wary;              /* f may break inside a panel: the smaller rule is not trusted */
    int controlled; /* components 0 .. controlled - 1 differ; the rest of the three follow component 0. 1 to 3 */
};

struct rl_quadrature_result {
    double value[RL_QUADRATURE_COMPONENTS];
    double error[RL_QUADRATURE_CONTROLLED];
    size_t evaluations;
    bool converged;
};

/* Stops early, with converged = false and the error reached, when evaluations or memory run out. */
void rl_quadrature(struct rl_quadrature_result *result, rl_quadrature_function *f, void *user,
                   const struct rl_panel *panels, size_t n_panels,
                   const struct rl_quadrature_options *options);

#endif
