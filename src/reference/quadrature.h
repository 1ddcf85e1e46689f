/* Adaptive Gauss-Kronrod integration (7 and 15 points) of a vector-valued function over several panels at once.
 *
 *     I = sum over panels of the integral of f from a to b
 *
 * The panels' ends are where f is known to break. Always the worst piece is halved, wherever it lies, until the largest
 * component's summed error is within the tolerance. An end where f behaves like a square root of the distance (a line that
 * touches an edge) is marked, and the variable is changed there so that f becomes smooth:
 *
 *     x = a + w u^2;   x = b - w (1 - u)^2;   x = a + w u^2 (3 - 2u) for both ends
 *
 * Error of a piece: QUADPACK's form (Piessens et al. 1983), (1000 |K - G| / A)^1.5 A, between |K - G|/10 and A, with A the integral of
 * |f - mean|: |K - G| is the lower rule's error, and the higher one's goes down faster.
 *
 *     struct rl_panel panel = {.a = 0.0, .b = 1.0};
 *     rl_quadrature(&result, f, user, &panel, 1, &(struct rl_quadrature_options){.tolerance = 1e-8});
 */
#ifndef RL_REFERENCE_QUADRATURE_H
#define RL_REFERENCE_QUADRATURE_H

#include <stdbool.h>
#include <stddef.h>

enum { RL_KRONROD_NODES = 15, RL_QUADRATURE_CONTROLLED = 3, RL_QUADRATURE_COMPONENTS = 4 };

struct rl_panel {
    double a, b;
    bool root_at_a, root_at_b;
};

/* f(x). The first three components are controlled; the fourth only summed along (with the Kronrod rule). Returns whether f may
 * differ from 0 anywhere in the panel that x lies in; false lets a fresh panel be skipped after one evaluation. */
typedef bool rl_quadrature_function(double value[RL_QUADRATURE_COMPONENTS], double x, void *user);

struct rl_quadrature_options {
    double tolerance;       /* absolute, on the largest controlled component */
    size_t max_evaluations; /* 0: 100000 */
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

/* The 15-point rule on [-1, 1]: node and weight i = 0 .. 14, ascending. */
double rl_kronrod_node(int i);
double rl_kronrod_weight(int i);

#endif
