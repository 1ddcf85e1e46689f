/* L_o at one point: the outer integral over theta (see integrator.h; lines.h and inner.h have the mathematics). */
#include "reference/integrator.h"

#include <math.h>
#include <stdalign.h>
#include <stdlib.h>
#include <string.h>

#include "reference/breaks.h"
#include "reference/integrators.h"
#include "reference/quadrature.h"

/* Enough for the lights of nearly every scene; more is allocated. */
enum { MEMORY_AT_FIRST = 48 * 1024 };

static bool lines_at(double value[RL_QUADRATURE_COMPONENTS][RL_RULE_ROOM], const double theta[RL_RULE_ROOM],
                     const struct rl_panel *panel, void *user)
{
    (void)panel;
    bool some = false;
    for (int i = 0; i < RL_RULE_NODES; i++) {
        double at[RL_QUADRATURE_COMPONENTS];
        some = rl_lines_integrate(at, user, theta[i]) || some;
        for (int c = 0; c < RL_QUADRATURE_COMPONENTS; c++)
            value[c][i] = at[c];
    }
    return some;
}

static int by_theta(const void *a, const void *b)
{
    double x = ((const struct rl_break *)a)->theta, y = ((const struct rl_break *)b)->theta;
    return (x > y) - (x < y);
}

/* Sorts, and leaves one break where several coincide. */
static size_t merge_breaks(struct rl_break *breaks, size_t n)
{
    size_t kept = 0;
    qsort(breaks, n, sizeof *breaks, by_theta);
    for (size_t i = 0; i < n; i++)
        if (kept == 0 || breaks[i].theta - breaks[kept - 1].theta >= 1e-15)
            breaks[kept++] = breaks[i];
        else if (breaks[i].kind > breaks[kept - 1].kind)
            breaks[kept - 1].kind = breaks[i].kind;
    return kept;
}

/* The next break's index beyond i that ends a panel, going round; `turn` counts times past pi. */
static size_t next_end(const struct rl_break *breaks, size_t n, size_t i, double *turn)
{
    do {
        i++;
        if (i == n) {
            i = 0;
            *turn += RL_PI;
        }
    } while (breaks[i].kind == RL_BREAK_ROOT);
    return i;
}

/* Whether a root lies beyond the panel's end at break i, in steps of +1 or -1, no further than the panel is long; *gap: how far. */
static bool root_beyond(double *gap, const struct rl_break *breaks, size_t n, size_t i, int step,
                        double reach)
{
    double theta = breaks[i].theta, turn = 0.0;
    for (size_t seen = 0; seen < n; seen++) {
        *gap = fabs(breaks[i].theta + turn - theta);
        if (*gap > reach)
            return false;
        if (breaks[i].kind != RL_BREAK_KINK)
            return true;
        if (step > 0 ? i + 1 == n : i == 0)
            turn += step * RL_PI;
        i = step > 0 ? (i + 1 == n ? 0 : i + 1) : (i == 0 ? n : i) - 1;
    }
    return false;
}

/* Panels between the breaks of [0, pi), which is a circle: the last one runs past pi to the first break. */
static size_t panels_between(struct rl_panel *panels, const struct rl_break *breaks, size_t n_breaks)
{
    size_t first = 0, n = 0;
    while (first < n_breaks && breaks[first].kind == RL_BREAK_ROOT)
        first++;
    if (first == n_breaks) {
        panels[0] = (struct rl_panel){.a = 0.0, .b = RL_PI};
        return 1;
    }
    size_t i = first;
    do {
        double turn = 0.0;
        size_t to = next_end(breaks, n_breaks, i, &turn);
        struct rl_panel *p = &panels[n++];
        *p = (struct rl_panel){.a = breaks[i].theta, .b = breaks[to].theta + turn};
        p->root_at_a = root_beyond(&p->gap_a, breaks, n_breaks, i, -1, p->b - p->a);
        p->root_at_b = root_beyond(&p->gap_b, breaks, n_breaks, to, 1, p->b - p->a);
        i = to;
    } while (i != first);
    return n;
}

static void integrate_theta(struct rl_estimate *estimate, const struct rl_lines *lines, void *memory,
                            const struct rl_integrate_options *options)
{
    struct rl_panel *panels = memory;
    struct rl_break *breaks = (struct rl_break *)(panels + rl_breaks_most(lines->set) + 1);
    size_t n = panels_between(panels, breaks, merge_breaks(breaks, rl_breaks_find(breaks, lines)));
    /* A little is left for rounding, which comes on top. */
    double tolerance = options->tolerance * lines->set->brightest;
    const struct rl_quadrature_options quadrature = {
        .tolerance = 0.99 * RL_PI * tolerance,
        .max_evaluations = options->max_evaluations,
        .controlled = 3,
    };
    struct rl_quadrature_result result;
    rl_quadrature(&result, lines_at, (void *)lines, panels, n, &quadrature);
    estimate->evaluations = result.evaluations;
    estimate->converged = result.converged;
    for (int c = 0; c < 3; c++) {
        estimate->value[c] = result.value[c] / RL_PI;
        estimate->error[c] = (result.error[c] + result.value[3]) / RL_PI;
        estimate->converged = estimate->converged && estimate->error[c] <= tolerance;
    }
}

void rl_integrate_lines(struct rl_estimate *estimate, const struct rl_surface *surface,
                        const struct rl_ellipsoid *e, const struct rl_light_set *set,
                        const struct rl_integrate_options *options)
{
    memset(estimate, 0, sizeof *estimate);
    estimate->converged = true;
    if (!(v3_dot(surface->N, surface->V) > 0.0) || set->n_polygons == 0 || !(set->brightest > 0.0))
        return;

    size_t lines_size = rl_lines_size(set), n_breaks = rl_breaks_most(set) + 1;
    size_t size = lines_size + n_breaks * (sizeof(struct rl_panel) + sizeof(struct rl_break));
    alignas(16) char at_first[MEMORY_AT_FIRST];
    char *owned = size > sizeof at_first ? malloc(size) : NULL;
    if (size > sizeof at_first && !owned) {
        estimate->converged = false;
        estimate->error[0] = estimate->error[1] = estimate->error[2] = INFINITY;
        return;
    }
    char *memory = owned ? owned : at_first;
    struct rl_lines lines;
    rl_lines_make(&lines, memory, surface, e, set, options);
    if (lines.n_edges > 0)
        integrate_theta(estimate, &lines, memory + lines_size, options);
    free(owned);
}

static int reference_integrate(struct rl_estimate *estimate, const struct rl_surface *surface,
                               const struct rl_ellipsoid *e, const struct rl_light_set *set,
                               const struct rl_integrate_options *options, struct rl_error *error)
{
    (void)error;
    rl_integrate_lines(estimate, surface, e, set, options);
    return RL_OK;
}

const struct rl_integrator rl_integrator_reference = {
    .name = "reference",
    .summary = "along lines, split where the integrand breaks",
    .evaluation = "lines",
    .error = "bounds the true error",
    .integrate = reference_integrate,
};
