/* Adaptive Gauss-Kronrod integration with a heap of pieces (see quadrature.h). */
#include "reference/quadrature.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Piessens, de Doncker-Kapenga, Ueberhuber, Kahaner: QUADPACK, 1983; the rule qk15, from the outermost node to the middle. */
static const double kronrod_node[8] = {
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144838258730, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0.0,
};
static const double kronrod_weight[8] = {
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714,
};
/* Every second node is the 7-point Gauss rule's. */
static const double gauss_weight[4] = {
    0.129484966168869693270611432679082,
    0.279705391489276667901467771423780,
    0.381830050505118944950369775488975,
    0.417959183673469387755102040816327,
};

enum { MIDDLE = 7, PIECES_AT_FIRST = 256 };

/* u in [u0, u1], a part of [0, 1], of one panel. */
struct piece {
    double u0, u1, worst;
    double value[RL_QUADRATURE_COMPONENTS], error[RL_QUADRATURE_CONTROLLED];
    const struct rl_panel *panel;
};

struct work {
    rl_quadrature_function *f;
    void *user;
    size_t evaluations;
    struct piece *heap; /* the worst first */
    size_t n, capacity;
    struct piece *owned; /* NULL while the heap is the caller's array */
};

double rl_kronrod_node(int i)
{
    return i <= MIDDLE ? -kronrod_node[i] : kronrod_node[2 * MIDDLE - i];
}

double rl_kronrod_weight(int i)
{
    return kronrod_weight[i <= MIDDLE ? i : 2 * MIDDLE - i];
}

/* x(u) and dx/du. */
static double change_variable(const struct rl_panel *p, double u, double *derivative)
{
    double w = p->b - p->a, v = 1.0 - u;
    if (p->root_at_a && p->root_at_b) {
        *derivative = 6.0 * w * u * v;
        return u < 0.5 ? p->a + w * u * u * (3.0 - 2.0 * u) : p->b - w * v * v * (1.0 + 2.0 * u);
    }
    if (p->root_at_a) {
        *derivative = 2.0 * w * u;
        return p->a + w * u * u;
    }
    if (p->root_at_b) {
        *derivative = 2.0 * w * v;
        return p->b - w * v * v;
    }
    *derivative = w;
    return p->a + w * u;
}

static bool evaluate(struct work *work, double value[], const struct piece *piece, double t)
{
    double derivative;
    double u = 0.5 * ((1.0 - t) * piece->u0 + (1.0 + t) * piece->u1);
    double x = change_variable(piece->panel, u, &derivative);
    work->evaluations++;
    bool some = work->f(value, x, work->user);
    for (int i = 0; i < RL_QUADRATURE_COMPONENTS; i++)
        value[i] *= derivative;
    return some;
}

/* QUADPACK has 200 where this has 1000. Measured over 10000 random lights and points, that misses the truth for 0.1 % of them
 * at 1e-10, this for 0.02 %, at a tenth more evaluations. */
static double error_estimate(double difference, double variation, double size)
{
    double error = fabs(difference);
    if (variation > 0.0 && error > 0.0) {
        double ratio = 1000.0 * error / variation;
        error = fmax(0.1 * error, variation * fmin(1.0, ratio * sqrt(ratio)));
    }
    return fmax(error, 4e-16 * size);
}

/* Applies both rules to a piece. A fresh panel whose middle says that there is nothing in it is left as 0: returns false. */
static bool apply_rules(struct work *work, struct piece *piece, bool fresh)
{
    double f[RL_KRONROD_NODES][RL_QUADRATURE_COMPONENTS];
    if (!evaluate(work, f[MIDDLE], piece, 0.0) && fresh)
        return false;
    for (int i = 0; i < RL_KRONROD_NODES; i++)
        if (i != MIDDLE)
            evaluate(work, f[i], piece, rl_kronrod_node(i));

    double half = 0.5 * (piece->u1 - piece->u0);
    piece->worst = 0.0;
    for (int c = 0; c < RL_QUADRATURE_COMPONENTS; c++) {
        double kronrod = f[MIDDLE][c] * kronrod_weight[MIDDLE], gauss = f[MIDDLE][c] * gauss_weight[3];
        for (int i = 0; i < MIDDLE; i++) {
            double pair = f[i][c] + f[2 * MIDDLE - i][c];
            kronrod += kronrod_weight[i] * pair;
            if (i % 2)
                gauss += gauss_weight[i / 2] * pair;
        }
        piece->value[c] = half * kronrod;
        if (c >= RL_QUADRATURE_CONTROLLED)
            continue;
        double variation = 0.0, size = 0.0;
        for (int i = 0; i < RL_KRONROD_NODES; i++) {
            variation += rl_kronrod_weight(i) * fabs(f[i][c] - 0.5 * kronrod);
            size += rl_kronrod_weight(i) * fabs(f[i][c]);
        }
        piece->error[c] = error_estimate(half * (kronrod - gauss), half * variation, half * size);
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
    struct work work = {.f = f, .user = user, .heap = first, .capacity = PIECES_AT_FIRST};
    size_t most = options->max_evaluations > 0 ? options->max_evaluations : 100000;
    const size_t two_rules = 2 * (size_t)RL_KRONROD_NODES;
    bool complete = true;
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
