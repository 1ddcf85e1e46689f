/* `cubature`: hcubature over the area of the lights, by the change of variables d omega_L = 4 (V.H) d omega_H and
 * d omega_H = |sin delta| d delta d theta:
 *
 *     L_o = (1/pi) integral over the lights' seen area of  D(delta) G L_e / (4 (V.H) |sin delta|) (h/r^3) d area
 *
 *   1. The seen area is cut into cells on which nothing is hidden, with their apex at the poles (area.h).
 *   2. Cells are cut into boxes on which the integrand is tame (boxes.h).
 *   3. hcubature (Genz and Malik 1980; Berntsen, Espelid and Genz 1991) takes each box: first all with few points, then those that
 *      did not suffice share what is left of tolerance and points.
 *
 * Error: SAFETY times the sum of hcubature's, the bounds on what kinks of G may add that slip through between its points, and
 * what rounding of directions does to U. Where the points do not suffice to look everywhere it is all that L_o could be.
 */
#include <cubature.h>
#include <float.h>
#include <string.h>

#include "reference/boxes.h"
#include "reference/integrators.h"

#define EVALUATIONS_MOST ((size_t)5000000)
/* Points of hcubature's rule in two dimensions; it may take twice as many more than it was allowed. */
#define RULE ((size_t)17)
#define FIRST_EVALUATIONS (5 * RULE)
#define SAFETY 2.0

struct task {
    struct rl_boxes boxes;
    const struct rl_area_cell *cell;
    size_t evaluations;
};

static int integrand_at(unsigned dimension, const double *x, void *user, unsigned n_values, double *value)
{
    (void)dimension;
    (void)n_values;
    struct task *task = user;
    task->evaluations++;
    *value = rl_boxes_integrand(&task->boxes, task->cell, x[0], x[1]);
    return 0;
}

static void integrate_box(struct task *task, struct rl_box *box, double tolerance, size_t most)
{
    const double low[2] = {box->s0, box->t0}, high[2] = {box->s1, box->t1};
    task->cell = box->cell;
    /* hcubature fails for want of memory only. */
    if (hcubature(1, integrand_at, task, 2, low, high, most, tolerance, 0.0, ERROR_INDIVIDUAL, &box->value,
                  &box->error) != 0)
        task->boxes.failed = true;
    box->done = box->error <= tolerance;
}

/* Step 3. The tolerance is that of the sum over boxes weighted by radiance, in units of the brightest. */
static void integrate_boxes(struct task *task, double tolerance, size_t most)
{
    double share = 0.25 * tolerance / (double)task->boxes.n, spent = 0.0;
    size_t left = 0, first = most / task->boxes.n - 2 * RULE;
    first = first < FIRST_EVALUATIONS ? first : FIRST_EVALUATIONS;
    for (size_t i = 0; i < task->boxes.n; i++) {
        integrate_box(task, &task->boxes.box[i], share, first);
        spent += task->boxes.box[i].done ? task->boxes.box[i].error : 0.0;
        left += !task->boxes.box[i].done;
    }
    for (size_t i = 0; i < task->boxes.n && !task->boxes.failed; i++) {
        struct rl_box *box = &task->boxes.box[i];
        if (box->done || left == 0 || task->evaluations >= most)
            continue;
        size_t evaluations = (most - task->evaluations) / left;
        if (evaluations > 2 * FIRST_EVALUATIONS)
            integrate_box(task, box, fmax(share, (tolerance - spent) / (double)left), evaluations - 2 * RULE);
        spent += box->error;
        left--;
    }
}

static void conclude(struct rl_estimate *estimate, const struct task *task, const struct rl_light_set *set,
                     double tolerance)
{
    /* A few units in the last place of the normal's direction, times the density at its peak. */
    double rounding = fmin(1.0, 16.0 * DBL_EPSILON * task->boxes.e->norm / task->boxes.stretch);
    for (int c = 0; c < 3; c++) {
        double brightest = 0.0;
        for (size_t i = 0; i < task->boxes.n; i++) {
            const struct rl_box *box = &task->boxes.box[i];
            double radiance = set->radiance[set->polygon[box->cell->polygon].radiance][c];
            estimate->value[c] += radiance * box->value / RL_PI;
            estimate->error[c] += radiance * (SAFETY * box->error + box->kink) / RL_PI;
            brightest = fmax(brightest, radiance);
        }
        estimate->error[c] += brightest * rounding;
        estimate->converged = estimate->converged && estimate->error[c] <= tolerance;
    }
    estimate->evaluations = task->evaluations;
}

static int run(struct rl_estimate *estimate, struct task *task, const struct rl_light_set *set,
               const struct rl_integrate_options *options, struct rl_error *error)
{
    struct rl_area area;
    int status = rl_area_make(&area, task->boxes.cast, task->boxes.surface, task->boxes.attenuation, error);
    if (status != RL_OK)
        return status;
    size_t most = options->max_evaluations ? options->max_evaluations : EVALUATIONS_MOST;
    /* Half the points, or more, are for hcubature to place. */
    task->boxes.most = most / (6 * RULE);
    rl_boxes_make(&task->boxes, &area, 0.5 * RL_PI * options->tolerance);
    if (task->boxes.unresolved || task->boxes.n * 3 * RULE > most)
        rl_cast_unknown(estimate, set); /* there may be a peak between the points */
    else {
        if (!task->boxes.failed && task->boxes.n > 0)
            integrate_boxes(task, 0.45 * RL_PI / SAFETY * options->tolerance, most);
        conclude(estimate, task, set, options->tolerance * set->brightest);
    }
    if (task->boxes.failed)
        status = rl_fail_memory(error, "cubature");
    rl_boxes_free(&task->boxes);
    rl_area_free(&area);
    return status;
}

static int integrate(struct rl_estimate *estimate, const struct rl_surface *surface,
                     const struct rl_ellipsoid *e, const struct rl_light_set *set,
                     const struct rl_integrate_options *options, struct rl_error *error)
{
    memset(estimate, 0, sizeof *estimate);
    estimate->converged = true;
    if (rl_cast_needless(surface, set))
        return RL_OK;
    double l = options->frame == RL_FRAME_PRINTED ? hypot(surface->N.y, surface->N.z) : 1.0;
    if (!(l > 0.0))
        return rl_fail(
            error, RL_ERR_INPUT,
            "cubature: the printed frame has collapsed at this normal, expected one with a density");
    struct rl_cast cast;
    int status = rl_cast_make(&cast, surface->P, set, error);
    if (status != RL_OK)
        return status;
    struct task task = {.boxes = {.surface = surface,
                                  .e = e,
                                  .cast = &cast,
                                  .attenuation = options->attenuation,
                                  .stretch = fmin(1.0, l)}};
    status = run(estimate, &task, set, options, error);
    rl_cast_free(&cast);
    return status;
}

const struct rl_integrator rl_integrator_cubature = {
    .name = "cubature",
    .summary = "hcubature over the lights' area, its poles taken out",
    .evaluation = "points",
    .error = "bounds the true error, conservatively",
    .uses = RL_USES_TOLERANCE | RL_USES_MAX_EVALUATIONS,
    .default_tolerance = 1e-8,
    .default_evaluations = EVALUATIONS_MOST,
    .integrate = integrate,
};
