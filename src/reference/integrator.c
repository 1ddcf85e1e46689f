/* L_o at one point: the outer integral over theta (see integrator.h; lines.h and inner.h have the mathematics). */
#include "reference/integrator.h"

#include <math.h>
#include <stdalign.h>
#include <stdlib.h>
#include <string.h>

#include "reference/batch.h"
#include "reference/breaks.h"
#include "reference/integrators.h"
#include "reference/occlusion.h"
#include "reference/panels.h"
#include "reference/quadrature.h"

/* Enough for the lights of nearly every scene; more is allocated. */
enum { MEMORY_AT_FIRST = 96 * 1024 };

/* A panel's stretches: stretch[first .. first + n - 1] of the job, once it is known. */
struct trace {
    size_t first, n;
    bool known;
};

/* One integral over theta. */
struct job {
    struct rl_lines lines;
    rl_batch_function *batch; /* NULL: one line after the other */
    struct rl_break *breaks;
    struct rl_panel *panel;
    struct trace *trace;        /* of each panel */
    struct rl_stretch *stretch; /* room for what the panels keep, and behind it for one line more */
    size_t room, used;
};

/* Of `memory`, if there is any, n elements of `size` bytes; *at moves on. */
static void *take(char *memory, size_t *at, size_t n, size_t size)
{
    void *taken = memory ? memory + *at : NULL;
    *at += (n * size + 15) / 16 * 16;
    return taken;
}

/* Lays the job out in `memory`; NULL only counts. Returns the bytes needed. */
static size_t lay_out(struct job *job, char *memory, const struct rl_light_set *set,
                      const struct rl_integrate_options *options)
{
    size_t at = rl_lines_size(set), edges = rl_lines_edges_most(set);
    size_t breaks = rl_breaks_most(set) + (options->occlusion ? RL_OCCLUSION_BREAKS : 0);
    job->breaks = take(memory, &at, breaks, sizeof *job->breaks);
    job->panel = take(memory, &at, breaks + 1, sizeof *job->panel);
    job->trace = take(memory, &at, breaks + 1, sizeof *job->trace);
    job->room = 8 * edges;
    job->stretch = take(memory, &at, job->room + 2 * edges + 2, sizeof *job->stretch);
    return at;
}

static void line_alone(double value[RL_QUADRATURE_COMPONENTS][RL_RULE_BATCH], const struct job *job, int i,
                       double theta)
{
    double at[RL_QUADRATURE_COMPONENTS];
    rl_lines_integrate(at, &job->lines, theta);
    for (int c = 0; c < RL_QUADRATURE_COMPONENTS; c++)
        value[c][i] = at[c];
}

/* The panel's stretches, from one of its lines. They are kept while there is room. */
static const struct rl_stretch *trace_panel(struct job *job, const struct rl_panel *panel, double theta,
                                            size_t *n)
{
    struct trace *trace = &job->trace[panel - job->panel];
    if (!trace->known) {
        struct rl_stretch *stretch = job->stretch + job->used;
        trace->n = rl_lines_trace(stretch, SIZE_MAX, &job->lines, theta);
        trace->first = job->used;
        trace->known = job->used + trace->n <= job->room;
        job->used += trace->known ? trace->n : 0;
    }
    *n = trace->n;
    return job->stretch + trace->first;
}

static bool lines_at(double value[RL_QUADRATURE_COMPONENTS][RL_RULE_BATCH], const double theta[RL_RULE_BATCH],
                     int n_lines, const struct rl_panel *panel, void *user)
{
    struct job *job = user;
    size_t n;
    const struct rl_stretch *stretch = trace_panel(job, panel, theta[n_lines / 2], &n);
    if (n == 0) {
        memset(value, 0, RL_QUADRATURE_COMPONENTS * sizeof value[0]);
        return false;
    }
    unsigned again =
        job->batch ? job->batch(value, &job->lines, stretch, n, theta) : (1U << RL_RULE_BATCH) - 1U;
    for (int i = 0; i < n_lines && again >> i; i++)
        if (again >> i & 1U)
            line_alone(value, job, i, theta[i]);
    return true;
}

static void integrate_theta(struct rl_estimate *estimate, struct job *job,
                            const struct rl_integrate_options *options)
{
    const struct rl_light_set *set = job->lines.set;
    bool complete;
    size_t n = rl_breaks_find(job->breaks, &complete, &job->lines);
    if (options->occlusion)
        n += rl_occlusion_breaks(job->breaks + n, options->occlusion, &job->lines);
    if (!complete)
        job->batch = NULL;
    n = rl_panels_between(job->panel, job->breaks, n);
    memset(job->trace, 0, n * sizeof *job->trace);
    /* A little is left for rounding, which comes on top: mostly less than this many units of the brightest light. */
    static const double rounding = 1.5e-13;
    double tolerance = options->tolerance * set->brightest;
    struct rl_quadrature_options quadrature = {
        .tolerance = RL_PI * fmax(0.5 * tolerance, 0.99 * tolerance - rounding * set->brightest),
        .max_evaluations = options->max_evaluations,
        .wary = options->occlusion != NULL || !complete,
        .controlled = set->grey ? 1 : 3,
    };
    struct rl_quadrature_result result;
    rl_quadrature(&result, lines_at, job, job->panel, n, &quadrature);
    estimate->evaluations = result.evaluations;
    /* Where it was more, what is left of the tolerance is known now. */
    double left = 0.98 * RL_PI * tolerance - result.value[3];
    if (result.converged && left < quadrature.tolerance && left > 0.25 * quadrature.tolerance) {
        quadrature.tolerance = left;
        rl_quadrature(&result, lines_at, job, job->panel, n, &quadrature);
        estimate->evaluations += result.evaluations;
    }
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

    struct job job;
    size_t size = lay_out(&job, NULL, set, options);
    alignas(16) char at_first[MEMORY_AT_FIRST];
    char *owned = size > sizeof at_first ? malloc(size) : NULL;
    if (size > sizeof at_first && !owned) {
        estimate->converged = false;
        estimate->error[0] = estimate->error[1] = estimate->error[2] = INFINITY;
        return;
    }
    char *memory = owned ? owned : at_first;
    lay_out(&job, memory, set, options);
    job.used = 0;
    rl_lines_make(&job.lines, memory, surface, e, set, options);
    job.batch = rl_batch_for(&job.lines, options->simd);
    if (job.lines.n_polygons > 0)
        integrate_theta(estimate, &job, options);
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
    .uses = RL_USES_TOLERANCE | RL_USES_MAX_EVALUATIONS,
    .default_tolerance = 1e-12,
    .default_evaluations = 100000,
    .integrate = reference_integrate,
};
