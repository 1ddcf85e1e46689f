/* Cuts cells into boxes (see boxes.h). */
#include "reference/boxes.h"

#include <stdlib.h>

#include "model/attenuation.h"

enum { DEEPEST = 100, LOOKS = 3 };
/* Turn of the normal across a box, in units of its distance from N and the width of D; and about N or the box's apex, in radians. */
#define COARSEST 0.35
#define WIDEST 0.7
/* How much near(s) may change along a box. */
#define STEEPEST 0.3
/* Size of a box in units of its distance from P. */
#define LARGEST 1.0
/* What a rule makes of a kink, as part of the integrand's variation from it times the box's size. */
#define KINK 0.01

/* A point of a cell: the direction to it, the normal that reflects the eye there, and the area per ds dt. */
struct spot {
    rl_vec3 X, L, H; /* X relative to P */
    double v_h, n_h, sine, r, area;
};

static struct spot spot_at(const struct rl_boxes *boxes, const struct rl_area_cell *cell, double s, double t)
{
    const struct rl_cast_polygon *polygon = &boxes->cast->polygon[cell->polygon];
    double near = rl_area_near(cell, s), u = near + t * (1.0 - near);
    double bx = cell->from.x + s * (cell->to.x - cell->from.x),
           by = cell->from.y + s * (cell->to.y - cell->from.y);
    rl_vec3 X = v3_madd(polygon->origin, cell->apex.x + u * bx, polygon->T);
    X = v3_madd(X, cell->apex.y + u * by, polygon->B);
    struct spot spot = {.X = X, .r = v3_length(X)};
    spot.L = v3_scale(1.0 / spot.r, X);
    rl_vec3 sum = v3_add(spot.L, boxes->surface->V);
    spot.v_h = 0.5 * v3_length(sum);
    spot.H = v3_normalize(sum);
    spot.n_h = v3_dot(spot.H, boxes->surface->N);
    if (spot.n_h < 0.0) { /* -H reflects V into the same L */
        spot.H = v3_scale(-1.0, spot.H);
        spot.n_h = -spot.n_h;
    }
    spot.sine = v3_length(v3_cross(spot.H, boxes->surface->N));
    spot.area = u * (1.0 - near) * fabs(cell->from.x * cell->to.y - cell->from.y * cell->to.x);
    return spot;
}

static double density(const struct rl_boxes *boxes, double sine, double cosine)
{
    double l = boxes->stretch;
    if (l == 1.0)
        return rl_ellipsoid_pdf_sincos(boxes->e, sine, cosine);
    double length = hypot(l * cosine, sine);
    return rl_ellipsoid_pdf_sincos(boxes->e, sine / length, l * cosine / length) * l / (length * length);
}

/* The integrand without G, per ds dt. */
static double weight_at(const struct rl_boxes *boxes, const struct rl_area_cell *cell,
                        const struct spot *spot)
{
    if (!(spot->sine > 0.0 && spot->v_h > 0.0))
        return 0.0;
    double h = fabs(boxes->cast->polygon[cell->polygon].distance), r = spot->r;
    return density(boxes, spot->sine, spot->n_h) / (4.0 * spot->v_h * spot->sine) * h / (r * r * r) *
           spot->area;
}

double rl_boxes_integrand(const struct rl_boxes *boxes, const struct rl_area_cell *cell, double s, double t)
{
    struct spot spot = spot_at(boxes, cell, s, t);
    rl_vec3 N = boxes->surface->N;
    double G = boxes->attenuation
                   ? rl_attenuation(spot.n_h, v3_dot(N, boxes->surface->V), v3_dot(N, spot.L), spot.v_h)
                   : 1.0;
    return G * weight_at(boxes, cell, &spot);
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
static void look_for_kinks(const struct rl_boxes *boxes, struct rl_box *box, struct spot spot[LOOKS][LOOKS])
{
    double to_one[LOOKS][LOOKS], swap[LOOKS][LOOKS], weight = 0.0;
    double n_v = v3_dot(boxes->surface->N, boxes->surface->V);
    bool reduced = false;
    for (int i = 0; i < LOOKS; i++)
        for (int j = 0; j < LOOKS; j++) {
            const struct spot *at = &spot[i][j];
            double n_l = v3_dot(boxes->surface->N, at->L), twice = 2.0 * at->n_h / at->v_h;
            to_one[i][j] = boxes->attenuation ? twice * fmin(n_v, n_l) - 1.0 : n_v + n_l;
            swap[i][j] = twice * (n_v - n_l);
            reduced = reduced || to_one[i][j] < 0.0;
            weight = fmax(weight, weight_at(boxes, box->cell, at));
        }
    double s, t, varies = 0.0;
    box->kink_across_s = false;
    if (may_vanish(to_one, &s, &t)) {
        varies = boxes->attenuation ? fmin(1.0, s + t) : 1.0;
        box->kink_across_s = s > t;
    }
    if (boxes->attenuation && reduced && may_vanish(swap, &s, &t)) {
        varies = fmin(1.0, varies + s + t);
        box->kink_across_s = s > t;
    }
    box->kink = KINK * varies * weight * (box->s1 - box->s0) * (box->t1 - box->t0);
}

/* Whether a box takes up too much of a turn about its apex, or its inner border runs too far along it. An edge that passes close by
 * the apex takes up nearly half a turn, most of it in a small part of s, and so does the fall of near(s) behind it. */
static bool lopsided(const struct rl_box *box)
{
    struct rl_point2 from = box->cell->from, to = box->cell->to;
    double ax = from.x + box->s0 * (to.x - from.x), ay = from.y + box->s0 * (to.y - from.y);
    double bx = from.x + box->s1 * (to.x - from.x), by = from.y + box->s1 * (to.y - from.y);
    return fabs(atan2(ax * by - ay * bx, ax * bx + ay * by)) > WIDEST ||
           fabs(rl_area_near(box->cell, box->s0) - rl_area_near(box->cell, box->s1)) > STEEPEST;
}

/* Whether the box must be halved, and along which direction. */
static bool too_large(const struct rl_boxes *boxes, const struct rl_box *box, struct spot spot[LOOKS][LOOKS],
                      bool *along_s)
{
    enum { LAST = LOOKS - 1 };
    double nearest = 1.0, closest = spot[0][0].r, turn_about = 0.0;
    double turn_s = 0.0, turn_t = 0.0, size_s = 0.0, size_along_t = 0.0;
    for (int j = 0; j < LOOKS; j++) {
        double sine = 1.0;
        for (int i = 0; i < LOOKS; i++) {
            sine = fmin(sine, spot[i][j].sine);
            closest = fmin(closest, spot[i][j].r);
        }
        double turn = apart(spot[0][j].H, spot[1][j].H) + apart(spot[1][j].H, spot[2][j].H);
        turn_s = fmax(turn_s, turn);
        turn_about = fmax(turn_about, turn / fmax(sine, 1e-12)); /* nearer, rounding turns it */
        turn_t = fmax(turn_t, apart(spot[j][0].H, spot[j][1].H) + apart(spot[j][1].H, spot[j][2].H));
        size_s = fmax(size_s, v3_length(v3_sub(spot[LAST][j].X, spot[0][j].X)));
        size_along_t = fmax(size_along_t, v3_length(v3_sub(spot[j][LAST].X, spot[j][0].X)));
        nearest = fmin(nearest, sine);
    }
    bool wide = turn_about > WIDEST || lopsided(box), large = fmax(size_s, size_along_t) > LARGEST * closest;
    *along_s = wide || (large ? size_s > size_along_t : turn_s > turn_t);
    return wide || large || fmax(turn_s, turn_t) > COARSEST * (nearest + boxes->stretch / boxes->e->rr);
}

/* Looks at a few spots of the box: where its kinks are, and whether it must be halved. */
static bool look(const struct rl_boxes *boxes, struct rl_box *box, bool *along_s)
{
    static const double place[LOOKS] = {1.0 / 16.0, 0.5, 15.0 / 16.0};
    struct spot spot[LOOKS][LOOKS];
    for (int i = 0; i < LOOKS; i++)
        for (int j = 0; j < LOOKS; j++)
            spot[i][j] = spot_at(boxes, box->cell, box->s0 + place[i] * (box->s1 - box->s0),
                                 box->t0 + place[j] * (box->t1 - box->t0));
    look_for_kinks(boxes, box, spot);
    return too_large(boxes, box, spot, along_s);
}

static void halve(struct rl_box half[2], const struct rl_box *box, bool along_s)
{
    half[0] = half[1] = *box;
    if (along_s)
        half[0].s1 = half[1].s0 = 0.5 * (box->s0 + box->s1);
    else
        half[0].t1 = half[1].t0 = 0.5 * (box->t0 + box->t1);
}

static void keep(struct rl_boxes *boxes, const struct rl_box *box)
{
    if (boxes->n == boxes->room) {
        size_t room = 2 * boxes->room + 256;
        struct rl_box *grown = realloc(boxes->box, room * sizeof *grown);
        boxes->failed = boxes->failed || !grown;
        if (!grown)
            return;
        boxes->box = grown;
        boxes->room = room;
    }
    boxes->box[boxes->n++] = *box;
}

static void add_box(struct rl_boxes *boxes, struct rl_box box, int depth)
{
    bool along_s, coarse = look(boxes, &box, &along_s);
    boxes->unresolved = boxes->unresolved || (coarse && boxes->n >= boxes->most);
    if (coarse && depth < DEEPEST && boxes->n < boxes->most) {
        struct rl_box half[2];
        halve(half, &box, along_s);
        add_box(boxes, half[0], depth + 1);
        add_box(boxes, half[1], depth + 1);
    } else {
        keep(boxes, &box);
    }
}

/* The boxes with the largest bounds first, all those within a factor of 4 of the largest at once. */
static void close_in_on_kinks(struct rl_boxes *boxes, double tolerance)
{
    while (!boxes->failed) {
        double sum = 0.0, largest = 0.0;
        for (size_t i = 0; i < boxes->n; i++) {
            sum += boxes->box[i].kink;
            largest = fmax(largest, boxes->box[i].kink);
        }
        if (sum <= tolerance)
            return;
        size_t n = boxes->n;
        for (size_t i = 0; i < n && !boxes->failed; i++) {
            if (boxes->box[i].kink < 0.25 * largest)
                continue;
            if (boxes->n >= boxes->most)
                return;
            struct rl_box half[2];
            bool ignored;
            halve(half, &boxes->box[i], boxes->box[i].kink_across_s);
            look(boxes, &half[0], &ignored);
            look(boxes, &half[1], &ignored);
            boxes->box[i] = half[0];
            keep(boxes, &half[1]);
        }
    }
}

void rl_boxes_make(struct rl_boxes *boxes, const struct rl_area *area, double kinks)
{
    for (size_t i = 0; i < area->n && !boxes->failed; i++)
        add_box(boxes, (struct rl_box){.cell = &area->cell[i], .s1 = 1.0, .t1 = 1.0}, 0);
    close_in_on_kinks(boxes, kinks);
}

void rl_boxes_free(struct rl_boxes *boxes)
{
    free(boxes->box);
    boxes->box = NULL;
    boxes->n = boxes->room = 0;
}
