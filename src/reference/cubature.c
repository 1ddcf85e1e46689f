/* `cubature`: hcubature over the area of the lights, by the change of variables d omega_L = 4 (V.H) d omega_H and
 * d omega_H = |sin delta'| d delta' d theta, delta' being where the normal stands:
 *
 *     L_o = (1/pi) integral over the lights' seen area of  p(delta') G L_e / (4 (V.H) |sin delta'|)  (h/r^3) d area
 *
 * with h the distance of the light's plane and r that of the point from P. p is D, or in the printed frame, whose tangents have
 * the length l, D(delta) d delta/d delta' with tan(delta') = l tan(delta).
 *
 *   1. The seen area is cut into cells on which nothing is hidden, with their apex at the poles (area.h).
 *   2. Cells are halved until the microfacet normal turns by no more across any than its distance from N and the width of D allow, so
 *      that no peak is met unprepared; what is left inside are G's kinks.
 *   3. hcubature (Genz and Malik 1980; Berntsen, Espelid and Genz 1991) takes each box: first all with few points, then those that
 *      did not suffice share what is left of tolerance and points.
 *
 * Error: SAFETY times the sum of hcubature's, since a kink that slips through between its points is not in them, and what rounding of
 * the directions does to U.
 */
#include <cubature.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "model/attenuation.h"
#include "model/frame.h"
#include "reference/area.h"
#include "reference/integrators.h"

/* RULE: points of hcubature's rule in two dimensions, which it may exceed its limit by, twice. */
enum { EVALUATIONS_MOST = 5000000, RULE = 17, FIRST_EVALUATIONS = 5 * RULE, DEEPEST = 80, LOOKS = 3 };
#define SAFETY 2.0
/* Turn of the normal across a box, in units of its distance from N and the width of D; and about N or the box's apex, in radians. */
#define COARSEST 0.35
#define WIDEST 0.7
/* How much near(s) may change along a box. */
#define STEEPEST 0.3
/* What the rule makes of a kink, as part of the integrand's variation from it times the box's size. */
#define KINK 0.01

struct box {
    const struct rl_area_cell *cell;
    double s0, s1, t0, t1; /* u = near + t (1 - near) */
    double value, error;
    double kink; /* bound on what a kink inside may add to the error; 0: there is none */
    bool kink_across_s, done;
};

struct task {
    const struct rl_surface *surface;
    const struct rl_ellipsoid *e;
    const struct rl_cast *cast;
    bool attenuation, failed, unresolved;
    double stretch; /* l */
    const struct rl_area_cell *cell;
    size_t evaluations, n_boxes, box_room, boxes_most;
    struct box *box;
};

/* A point of a cell: the direction to it, the normal that reflects the eye there, and the area per ds dt. */
struct spot {
    rl_vec3 L, H;
    double v_h, n_h, sine, r, area;
};

static struct spot spot_at(const struct task *task, const struct rl_area_cell *cell, double s, double t)
{
    const struct rl_cast_polygon *polygon = &task->cast->polygon[cell->polygon];
    double near = rl_area_near(cell, s), u = near + t * (1.0 - near);
    double bx = cell->from.x + s * (cell->to.x - cell->from.x),
           by = cell->from.y + s * (cell->to.y - cell->from.y);
    rl_vec3 X = v3_madd(polygon->origin, cell->apex.x + u * bx, polygon->T);
    X = v3_madd(X, cell->apex.y + u * by, polygon->B);
    struct spot spot = {.r = v3_length(X)};
    spot.L = v3_scale(1.0 / spot.r, X);
    rl_vec3 sum = v3_add(spot.L, task->surface->V);
    spot.v_h = 0.5 * v3_length(sum);
    spot.H = v3_normalize(sum);
    spot.n_h = v3_dot(spot.H, task->surface->N);
    if (spot.n_h < 0.0) { /* -H reflects V into the same L */
        spot.H = v3_scale(-1.0, spot.H);
        spot.n_h = -spot.n_h;
    }
    spot.sine = v3_length(v3_cross(spot.H, task->surface->N));
    spot.area = u * (1.0 - near) * fabs(cell->from.x * cell->to.y - cell->from.y * cell->to.x);
    return spot;
}

static double density(const struct task *task, double sine, double cosine)
{
    double l = task->stretch;
    if (l == 1.0)
        return rl_ellipsoid_pdf_sincos(task->e, sine, cosine);
    double length = hypot(l * cosine, sine);
    return rl_ellipsoid_pdf_sincos(task->e, sine / length, l * cosine / length) * l / (length * length);
}

/* The integrand without G, per ds dt. */
static double weight_at(const struct task *task, const struct rl_area_cell *cell, const struct spot *spot)
{
    if (!(spot->sine > 0.0 && spot->v_h > 0.0))
        return 0.0;
    double h = fabs(task->cast->polygon[cell->polygon].distance), r = spot->r;
    return density(task, spot->sine, spot->n_h) / (4.0 * spot->v_h * spot->sine) * h / (r * r * r) *
           spot->area;
}

static int integrand_at(unsigned dimension, const double *x, void *user, unsigned n_values, double *value)
{
    (void)dimension;
    (void)n_values;
    struct task *task = user;
    task->evaluations++;
    struct spot spot = spot_at(task, task->cell, x[0], x[1]);
    rl_vec3 N = task->surface->N;
    double G = task->attenuation
                   ? rl_attenuation(spot.n_h, v3_dot(N, task->surface->V), v3_dot(N, spot.L), spot.v_h)
                   : 1.0;
    *value = G * weight_at(task, task->cell, &spot);
    return 0;
}

/* How far apart two normals are; H and -H are one. */
static double apart(rl_vec3 a, rl_vec3 b)
{
    return fmin(v3_length(v3_sub(a, b)), v3_length(v3_add(a, b)));
}

/* Whether a function known on a box's spots may be 0 somewhere in it, and by how much it varies along s and along t. */
static bool may_vanish(double f[LOOKS][LOOKS], double *along_s, double *along_t)
{
    double low = f[0][0], high = f[0][0];
    *along_s = *along_t = 0.0;
    for (int i = 0; i < LOOKS; i++)
        for (int j = 0; j < LOOKS; j++) {
            low = fmin(low, f[i][j]);
            high = fmax(high, f[i][j]);
        }
    for (int i = 0; i < LOOKS; i++) {
        *along_s = fmax(*along_s, fabs(f[LOOKS - 1][i] - f[0][i]));
        *along_t = fmax(*along_t, fabs(f[i][LOOKS - 1] - f[i][0]));
    }
    double margin = 0.25 * (high - low);
    return low <= margin && high >= -margin;
}

/* Kinks: where G reaches 1 and where masking and shadowing swap; without attenuation where H stands at right angles to N, beyond
 * which it is -H that reflects. */
static void look_for_kinks(const struct task *task, struct box *box, struct spot spot[LOOKS][LOOKS])
{
    double to_one[LOOKS][LOOKS], swap[LOOKS][LOOKS], weight = 0.0;
    double n_v = v3_dot(task->surface->N, task->surface->V);
    bool reduced = false;
    for (int i = 0; i < LOOKS; i++)
        for (int j = 0; j < LOOKS; j++) {
            const struct spot *at = &spot[i][j];
            double n_l = v3_dot(task->surface->N, at->L), twice = 2.0 * at->n_h / at->v_h;
            to_one[i][j] = task->attenuation ? twice * fmin(n_v, n_l) - 1.0 : n_v + n_l;
            swap[i][j] = twice * (n_v - n_l);
            reduced = reduced || to_one[i][j] < 0.0;
            weight = fmax(weight, weight_at(task, box->cell, at));
        }
    double s, t, varies = 0.0;
    box->kink_across_s = false;
    if (may_vanish(to_one, &s, &t)) {
        varies = task->attenuation ? fmin(1.0, s + t) : 1.0;
        box->kink_across_s = s > t;
    }
    if (task->attenuation && reduced && may_vanish(swap, &s, &t)) {
        varies = fmin(1.0, varies + s + t);
        box->kink_across_s = s > t;
    }
    box->kink = KINK * varies * weight * (box->s1 - box->s0) * (box->t1 - box->t0);
}

/* Whether a box takes up too much of a turn about its apex, or its inner border runs too far along it. An edge that passes close by
 * the apex takes up nearly half a turn, most of it in a small part of s, and so does the fall of near(s) behind it. */
static bool lopsided(const struct box *box)
{
    struct rl_point2 from = box->cell->from, to = box->cell->to;
    double ax = from.x + box->s0 * (to.x - from.x), ay = from.y + box->s0 * (to.y - from.y);
    double bx = from.x + box->s1 * (to.x - from.x), by = from.y + box->s1 * (to.y - from.y);
    return fabs(atan2(ax * by - ay * bx, ax * bx + ay * by)) > WIDEST ||
           fabs(rl_area_near(box->cell, box->s0) - rl_area_near(box->cell, box->s1)) > STEEPEST;
}

/* Looks at a few spots of the box: where its kinks are, and whether the normal turns by more across it than step 2 allows; if so,
 * along which direction. */
static bool look(const struct task *task, struct box *box, bool *along_s)
{
    static const double place[LOOKS] = {1.0 / 16.0, 0.5, 15.0 / 16.0};
    struct spot spot[LOOKS][LOOKS];
    double nearest = 1.0, turn_s = 0.0, turn_t = 0.0, turn_about = 0.0;
    for (int j = 0; j < LOOKS; j++) {
        double sine = 1.0;
        for (int i = 0; i < LOOKS; i++) {
            spot[i][j] = spot_at(task, box->cell, box->s0 + place[i] * (box->s1 - box->s0),
                                 box->t0 + place[j] * (box->t1 - box->t0));
            sine = fmin(sine, spot[i][j].sine);
        }
        double turn = apart(spot[0][j].H, spot[1][j].H) + apart(spot[1][j].H, spot[2][j].H);
        turn_s = fmax(turn_s, turn);
        turn_about = fmax(turn_about, turn / fmax(sine, 1e-12)); /* nearer, rounding turns it */
        nearest = fmin(nearest, sine);
    }
    for (int i = 0; i < LOOKS; i++)
        turn_t = fmax(turn_t, apart(spot[i][0].H, spot[i][1].H) + apart(spot[i][1].H, spot[i][2].H));
    look_for_kinks(task, box, spot);
    bool wide = turn_about > WIDEST || lopsided(box);
    *along_s = wide || turn_s > turn_t;
    return wide || fmax(turn_s, turn_t) > COARSEST * (nearest + task->stretch / task->e->rr);
}

static void halve(struct box half[2], const struct box *box, bool along_s)
{
    half[0] = half[1] = *box;
    if (along_s)
        half[0].s1 = half[1].s0 = 0.5 * (box->s0 + box->s1);
    else
        half[0].t1 = half[1].t0 = 0.5 * (box->t0 + box->t1);
}

static void keep(struct task *task, const struct box *box)
{
    if (task->n_boxes == task->box_room) {
        size_t room = 2 * task->box_room + 256;
        struct box *grown = realloc(task->box, room * sizeof *grown);
        task->failed = task->failed || !grown;
        if (!grown)
            return;
        task->box = grown;
        task->box_room = room;
    }
    task->box[task->n_boxes++] = *box;
}

/* Step 2 for a cell. */
static void add_box(struct task *task, struct box box, int depth)
{
    bool along_s, coarse = look(task, &box, &along_s);
    task->unresolved = task->unresolved || (coarse && task->n_boxes >= task->boxes_most);
    if (coarse && depth < DEEPEST && task->n_boxes < task->boxes_most) {
        struct box half[2];
        halve(half, &box, along_s);
        add_box(task, half[0], depth + 1);
        add_box(task, half[1], depth + 1);
    } else {
        keep(task, &box);
    }
}

/* Step 3: the boxes with the largest bounds first, all those within a factor of 4 of the largest at once. */
static void close_in_on_kinks(struct task *task, double tolerance)
{
    while (!task->failed) {
        double sum = 0.0, largest = 0.0;
        for (size_t i = 0; i < task->n_boxes; i++) {
            sum += task->box[i].kink;
            largest = fmax(largest, task->box[i].kink);
        }
        if (sum <= tolerance)
            return;
        size_t n = task->n_boxes;
        for (size_t i = 0; i < n && !task->failed; i++) {
            if (task->box[i].kink < 0.25 * largest)
                continue;
            if (task->n_boxes >= task->boxes_most)
                return;
            struct box half[2];
            bool ignored;
            halve(half, &task->box[i], task->box[i].kink_across_s);
            look(task, &half[0], &ignored);
            look(task, &half[1], &ignored);
            task->box[i] = half[0];
            keep(task, &half[1]);
        }
    }
}

static void integrate_box(struct task *task, struct box *box, double tolerance, size_t most)
{
    const double low[2] = {box->s0, box->t0}, high[2] = {box->s1, box->t1};
    task->cell = box->cell;
    /* hcubature fails for want of memory only. */
    if (hcubature(1, integrand_at, task, 2, low, high, most, tolerance, 0.0, ERROR_INDIVIDUAL, &box->value,
                  &box->error) != 0)
        task->failed = true;
    box->done = box->error <= tolerance;
}

/* Step 3. The tolerance is that of the sum over boxes weighted by radiance, in units of the brightest. */
static void integrate_boxes(struct task *task, double tolerance, size_t most)
{
    double share = 0.25 * tolerance / (double)task->n_boxes, spent = 0.0;
    size_t left = 0, first = most / task->n_boxes - 2 * RULE;
    first = first < FIRST_EVALUATIONS ? first : FIRST_EVALUATIONS;
    for (size_t i = 0; i < task->n_boxes; i++) {
        integrate_box(task, &task->box[i], share, first);
        spent += task->box[i].done ? task->box[i].error : 0.0;
        left += !task->box[i].done;
    }
    for (size_t i = 0; i < task->n_boxes && !task->failed; i++) {
        struct box *box = &task->box[i];
        if (box->done || task->evaluations >= most)
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
    double rounding = fmin(1.0, 16.0 * DBL_EPSILON * task->e->norm / task->stretch);
    for (int c = 0; c < 3; c++) {
        double brightest = 0.0;
        for (size_t i = 0; i < task->n_boxes; i++) {
            const struct box *box = &task->box[i];
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
    int status = rl_area_make(&area, task->cast, task->surface, task->attenuation, error);
    if (status != RL_OK)
        return status;
    size_t most = options->max_evaluations ? options->max_evaluations : EVALUATIONS_MOST;
    /* Half the points, or more, are for hcubature to place. */
    task->boxes_most = most / (6 * RULE);
    for (size_t i = 0; i < area.n && !task->failed; i++)
        add_box(task, (struct box){.cell = &area.cell[i], .s1 = 1.0, .t1 = 1.0}, 0);
    close_in_on_kinks(task, 0.5 * RL_PI * options->tolerance);
    if (task->unresolved || task->n_boxes * 3 * RULE > most)
        rl_cast_unknown(estimate, set); /* there may be a peak between the points */
    else {
        if (!task->failed && task->n_boxes > 0)
            integrate_boxes(task, 0.45 * RL_PI / SAFETY * options->tolerance, most);
        conclude(estimate, task, set, options->tolerance * set->brightest);
    }
    if (task->failed)
        status = rl_fail_memory(error, "cubature");
    free(task->box);
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
    struct task task = {.surface = surface,
                        .e = e,
                        .cast = &cast,
                        .attenuation = options->attenuation,
                        .stretch = fmin(1.0, l)};
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
