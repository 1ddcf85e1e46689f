/* Adaptive integration with a heap of pieces (see quadrature.h). */
#include "reference/quadrature.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/vec3.h"

enum { PIECES_AT_FIRST = 128 };

/* u in [u0, u1], a part of [0, 1], of one panel. */
struct piece {
    double u0, u1, worst;
    double value[RL_QUADRATURE_COMPONENTS], error[RL_QUADRATURE_CONTROLLED];
    const struct rl_panel *panel;
};

struct work {
    rl_quadrature_function *f;
    void *user;
    int controlled;
    double length; /* of all panels */
    double enough; /* error that pieces of the smaller rule may have, together */
    size_t evaluations;
    struct piece *heap; /* the worst first */
    size_t n, capacity;
    struct piece *owned; /* NULL while the heap is the caller's array */
};

/* How a panel's variable is changed: v goes from v0 to v1. */
struct change {
    const struct rl_panel *panel;
    bool both;
    double low, high, v0, v1;
};

static struct change change_of(const struct rl_panel *p)
{
    struct change c = {.panel = p,
                       .both = p->root_at_a && p->root_at_b,
                       .low = p->a - p->gap_a,
                       .high = p->b + p->gap_b,
                       .v1 = p->b - p->a};
    if (c.both) {
        double whole = c.high - c.low;
        c.v0 = p->gap_a > 0.0 ? 2.0 * asin(sqrt(p->gap_a / whole)) : 0.0;
        c.v1 = RL_PI - (p->gap_b > 0.0 ? 2.0 * asin(sqrt(p->gap_b / whole)) : 0.0);
    } else if (p->root_at_a) {
        c.v0 = sqrt(p->gap_a);
        c.v1 = sqrt(p->b - c.low);
    } else if (p->root_at_b) {
        c.v0 = sqrt(c.high - p->a);
        c.v1 = sqrt(p->gap_b);
    }
    return c;
}

/* x and dx/du. */
static double place_node(const struct change *c, double u, double *derivative)
{
    double v = (1.0 - u) * c->v0 + u * c->v1;
    *derivative = c->v1 - c->v0;
    if (c->both) {
        double whole = c->high - c->low, sine, cosine;
        sincos(0.5 * v, &sine, &cosine);
        *derivative *= whole * sine * cosine;
        return v < 0.5 * RL_PI ? c->low + whole * sine * sine : c->high - whole * cosine * cosine;
    }
    if (c->panel->root_at_a) {
        *derivative *= 2.0 * v;
        return c->low + v * v;
    }
    if (c->panel->root_at_b) {
        *derivative *= -2.0 * v;
        return c->high - v * v;
    }
    return c->panel->a + v;
}

/* f times dx/du at the rule's nodes first, first + 2, ... Returns what f does. */
static bool evaluate(struct work *work, double f[RL_QUADRATURE_COMPONENTS][RL_RULE_BATCH],
                     const struct piece *piece, const struct change *change, int first, int n)
{
    double x[RL_RULE_BATCH] = {0.0}, derivative[RL_RULE_BATCH] = {0.0};
    for (int i = 0; i < n; i++) {
        double t = rl_rule_node(first + 2 * i);
        double u = 0.5 * ((1.0 - t) * piece->u0 + (1.0 + t) * piece->u1);
        x[i] = place_node(change, u, &derivative[i]);
    }
    if (n < RL_RULE_BATCH)
        x[n] = x[n - 1];
    bool some = work->f(f, x, n, piece->panel, work->user);
    for (int c = 0; c < RL_QUADRATURE_COMPONENTS; c++)
        for (int i = 0; i < n; i++)
            f[c][i] *= derivative[i];
    return some;
}

/* Values and errors of a piece from one rule or the other (rest = NULL: the smaller one). */
static void estimate(struct piece *piece, const struct work *work,
                     double gauss[RL_QUADRATURE_COMPONENTS][RL_RULE_BATCH], double (*rest)[RL_RULE_BATCH])
{
    double half = 0.5 * (piece->u1 - piece->u0);
    piece->worst = 0.0;
    for (int c = 0; c < RL_QUADRATURE_COMPONENTS; c++) {
        if (c >= work->controlled && c < RL_QUADRATURE_CONTROLLED) {
            piece->value[c] = piece->value[0];
            piece->error[c] = piece->error[0];
            continue;
        }
        double error;
        piece->value[c] =
            half * (rest ? rl_rule_kronrod(gauss[c], rest[c], &error) : rl_rule_gauss(gauss[c], &error));
        if (c >= RL_QUADRATURE_CONTROLLED)
            continue;
        piece->error[c] = half * error;
        piece->worst = fmax(piece->worst, piece->error[c]);
    }
}

/* Applies the rules to a piece. On a fresh panel the smaller one is good enough where its error is within the panel's share of
 * `enough`, by length; a panel that had to be halved is not so smooth that 7 points could be trusted. A fresh panel in which there is
 * nothing is left out: returns false. */
static bool apply_rules(struct work *work, struct piece *piece, bool fresh)
{
    struct change change = change_of(piece->panel);
    double gauss[RL_QUADRATURE_COMPONENTS][RL_RULE_BATCH], rest[RL_QUADRATURE_COMPONENTS][RL_RULE_BATCH];
    bool some = evaluate(work, gauss, piece, &change, 1, RL_RULE_GAUSS);
    work->evaluations += fresh && !some ? 1 : RL_RULE_GAUSS;
    if (fresh && !some)
        return false;
    estimate(piece, work, gauss, NULL);
    if (fresh && piece->worst <= work->enough * (piece->panel->b - piece->panel->a) / work->length)
        return true;
    evaluate(work, rest, piece, &change, 0, RL_RULE_BATCH);
    work->evaluations += RL_RULE_BATCH;
    estimate(piece, work, gauss, rest);
    return true;
}

static void sift_down(struct work *work, size_t at)
{
    struct piece moved = work->heap[at];
    for (;;) {
        size_t child = 2 * at + 1;
        if (child + 1 < work->n && work->heap[child + 1].worst > work->heap[child].worst)
            child++;
        if (child >= work->n || !(work->heap[child].worst > moved.worst))
            break;
        work->heap[at] = work->heap[child];
        at = child;
    }
    work->heap[at] = moved;
}

/* Room for one piece more. */
static bool reserve(struct work *work)
{
    if (work->n < work->capacity)
        return true;
    struct piece *more = malloc(2 * work->capacity * sizeof *more);
    if (!more)
        return false;
    memcpy(more, work->heap, work->n * sizeof *more);
    free(work->owned);
    work->heap = work->owned = more;
    work->capacity *= 2;
    return true;
}

static void push(struct work *work, const struct piece *piece)
{
    size_t at = work->n++;
    for (; at > 0 && work->heap[(at - 1) / 2].worst < piece->worst; at = (at - 1) / 2)
        work->heap[at] = work->heap[(at - 1) / 2];
    work->heap[at] = *piece;
}

/* Sums afresh: running sums would keep the rounding of large errors long since replaced. */
static double total(struct rl_quadrature_result *result, const struct work *work)
{
    memset(result->value, 0, sizeof result->value);
    memset(result->error, 0, sizeof result->error);
    for (size_t i = 0; i < work->n; i++) {
        for (int c = 0; c < RL_QUADRATURE_COMPONENTS; c++)
            result->value[c] += work->heap[i].value[c];
        for (int c = 0; c < RL_QUADRATURE_CONTROLLED; c++)
            result->error[c] += work->heap[i].error[c];
    }
    return fmax(result->error[0], fmax(result->error[1], result->error[2]));
}

/* Halves the worst piece; false when that is no longer possible. */
static bool refine(struct work *work)
{
    struct piece left = work->heap[0], right = work->heap[0];
    double middle = 0.5 * (left.u0 + left.u1);
    if (!(left.u1 - left.u0 > 1e-14) || !reserve(work))
        return false;
    left.u1 = right.u0 = middle;
    apply_rules(work, &left, false);
    apply_rules(work, &right, false);
    work->heap[0] = left;
    sift_down(work, 0);
    push(work, &right);
    return true;
}

void rl_quadrature(struct rl_quadrature_result *result, rl_quadrature_function *f, void *user,
                   const struct rl_panel *panels, size_t n_panels,
                   const struct rl_quadrature_options *options)
{
    struct piece first[PIECES_AT_FIRST];
    struct work work = {
        .f = f,
        .user = user,
        .controlled = options->controlled > 0 ? options->controlled : RL_QUADRATURE_CONTROLLED,
        .enough = options->wary ? -1.0 : 0.25 * options->tolerance,
        .heap = first,
        .capacity = PIECES_AT_FIRST,
    };
    size_t most = options->max_evaluations > 0 ? options->max_evaluations : 100000;
    const size_t two_rules = 2 * (size_t)RL_RULE_NODES;
    bool complete = true;
    for (size_t i = 0; i < n_panels; i++)
        work.length += panels[i].b - panels[i].a;
    for (size_t i = 0; i < n_panels && complete; i++) {
        struct piece piece = {.u1 = 1.0, .panel = &panels[i]};
        complete = reserve(&work);
        if (complete && apply_rules(&work, &piece, true))
            push(&work, &piece);
    }
    double error = total(result, &work);
    while (complete && error > options->tolerance && work.evaluations + two_rules <= most) {
        if (!refine(&work))
            break;
        error = total(result, &work);
    }
    for (int c = 0; c < RL_QUADRATURE_CONTROLLED && !complete; c++)
        result->error[c] = INFINITY;
    result->converged = complete && error <= options->tolerance;
    result->evaluations = work.evaluations;
    free(work.owned);
}
