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
    size_t evaluations;
    struct piece *heap; /* the worst first */
    size_t n, capacity;
    struct piece *owned; /* NULL while the heap is the caller's array */
};

/* x and dx/du at the nodes of a piece. */
static void place_nodes(double x[RL_RULE_ROOM], double derivative[RL_RULE_ROOM], const struct piece *piece)
{
    const struct rl_panel *p = piece->panel;
    double v0 = 0.0, v1 = p->b - p->a;
    double low = p->a - p->gap_a, high = p->b + p->gap_b, whole = high - low;
    bool both = p->root_at_a && p->root_at_b;
    if (both) {
        v0 = 2.0 * asin(sqrt(p->gap_a / whole));
        v1 = RL_PI - 2.0 * asin(sqrt(p->gap_b / whole));
    } else if (p->root_at_a) {
        v0 = sqrt(p->gap_a);
        v1 = sqrt(p->b - low);
    } else if (p->root_at_b) {
        v0 = sqrt(high - p->a);
        v1 = sqrt(p->gap_b);
    }
    for (int i = 0; i < RL_RULE_NODES; i++) {
        double t = rl_rule_node(i);
        double u = 0.5 * ((1.0 - t) * piece->u0 + (1.0 + t) * piece->u1);
        double v = (1.0 - u) * v0 + u * v1;
        derivative[i] = v1 - v0;
        if (both) {
            double s = sin(0.5 * v), c = cos(0.5 * v);
            x[i] = v < 0.5 * RL_PI ? low + whole * s * s : high - whole * c * c;
            derivative[i] *= whole * s * c;
        } else if (p->root_at_a) {
            x[i] = low + v * v;
            derivative[i] *= 2.0 * v;
        } else if (p->root_at_b) {
            x[i] = high - v * v;
            derivative[i] *= -2.0 * v;
        } else {
            x[i] = p->a + v;
        }
    }
    x[RL_RULE_NODES] = x[RL_RULE_NODES - 1];
}

/* Applies the rule to a piece. A fresh panel in which there is nothing is left out: returns false. */
static bool apply_rule(struct work *work, struct piece *piece, bool fresh)
{
    double x[RL_RULE_ROOM], derivative[RL_RULE_ROOM], f[RL_QUADRATURE_COMPONENTS][RL_RULE_ROOM];
    place_nodes(x, derivative, piece);
    bool some = work->f(f, x, piece->panel, work->user);
    work->evaluations += fresh && !some ? 1 : RL_RULE_NODES;
    if (fresh && !some)
        return false;
    double half = 0.5 * (piece->u1 - piece->u0);
    piece->worst = 0.0;
    for (int c = 0; c < RL_QUADRATURE_COMPONENTS; c++) {
        bool follows = c >= work->controlled && c < RL_QUADRATURE_CONTROLLED;
        double error = 0.0;
        if (follows) {
            piece->value[c] = piece->value[0];
            piece->error[c] = piece->error[0];
            continue;
        }
        for (int i = 0; i < RL_RULE_NODES; i++)
            f[c][i] *= derivative[i];
        if (c >= RL_QUADRATURE_CONTROLLED) {
            piece->value[c] = half * rl_rule_sum(f[c]);
            continue;
        }
        piece->value[c] = half * rl_rule_estimate(f[c], &error);
        piece->error[c] = half * error;
        piece->worst = fmax(piece->worst, piece->error[c]);
    }
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
    apply_rule(work, &left, false);
    apply_rule(work, &right, false);
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
        .heap = first,
        .capacity = PIECES_AT_FIRST,
    };
    size_t most = options->max_evaluations > 0 ? options->max_evaluations : 100000;
    const size_t two_rules = 2 * (size_t)RL_RULE_NODES;
    bool complete = true;
    for (size_t i = 0; i < n_panels && complete; i++) {
        struct piece piece = {.u1 = 1.0, .panel = &panels[i]};
        complete = reserve(&work);
        if (complete && apply_rule(&work, &piece, true))
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
