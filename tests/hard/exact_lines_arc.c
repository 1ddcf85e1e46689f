/* The integral of F d psi along an arc of a great circle.
 *
 * With L = (a (1 - u^2) + 2 u e)/(1 + u^2), linear and quadratic forms in L are polynomials in u over powers of 1 + u^2. Along the arc F is
 * analytic but where one of these is 0:
 *
 *     N.L + N.V                     attenuation off: the radius passes delta = pi/2
 *     N.L - N.V                     masking and shadowing swap
 *     2 N.V (N.V + N.L) - 1 - V.L   masking is 1; with N.L for the first N.V, shadowing is (V.H and N.H are those of V + L, and
 *                                   |V + L|^2 = 2 + 2 V.L)
 *     (V.q)^2 - (N.V |q|)^2         the radius' masking begins
 *
 * Attenuation off, an arc may pass -V closer than anything that the rule's nodes see from afar (holds_opposite moves V off by a third of
 * the bits): there the arc is split in geometric steps towards its nearest place.
 */
#include "exact_lines.h"

#include <stdlib.h>

enum { DEGREE = 4, STEPS_MOST = 512, BREAKS_MOST = 5 * DEGREE + 2 + STEPS_MOST, DEEPEST = 1200 };

struct arc {
    vector a, e;
    mpfr_t end;
    struct lobe *lobe;
    struct rule *rule;
};

struct polynomial {
    int degree;
    mpfr_t c[DEGREE + 1];
};

static void polynomial_init(struct polynomial *p)
{
    p->degree = 0;
    for (int i = 0; i <= DEGREE; i++) {
        mpfr_init(p->c[i]);
        mpfr_set_zero(p->c[i], 1);
    }
}

static void polynomial_clear(struct polynomial *p)
{
    for (int i = 0; i <= DEGREE; i++)
        mpfr_clear(p->c[i]);
}

static void polynomial_at(mpfr_t out, const struct polynomial *p, mpfr_t u)
{
    mpfr_set(out, p->c[p->degree], MPFR_RNDN);
    for (int i = p->degree - 1; i >= 0; i--)
        mpfr_fma(out, out, u, p->c[i], MPFR_RNDN);
}

/* w.L + h, times 1 + u^2. */
static void linear_form(struct polynomial *p, struct arc *arc, vector w, mpfr_t h)
{
    mpfr_t along;
    mpfr_init(along);
    p->degree = 2;
    vector_dot(along, w, arc->a);
    mpfr_add(p->c[0], h, along, MPFR_RNDN);
    mpfr_sub(p->c[2], h, along, MPFR_RNDN);
    vector_dot(p->c[1], w, arc->e);
    mpfr_mul_2ui(p->c[1], p->c[1], 1, MPFR_RNDN);
    mpfr_clear(along);
}

/* to += sign a b; of degree 2 both. */
static void add_product(struct polynomial *to, const struct polynomial *a, const struct polynomial *b,
                        int sign)
{
    mpfr_t term;
    mpfr_init(term);
    to->degree = 4;
    for (int i = 0; i <= 2; i++)
        for (int j = 0; j <= 2; j++) {
            mpfr_mul(term, a->c[i], b->c[j], MPFR_RNDN);
            (sign < 0 ? mpfr_sub : mpfr_add)(to->c[i + j], to->c[i + j], term, MPFR_RNDN);
        }
    mpfr_clear(term);
}

/* The zero between a and b, where the signs differ, by halving. */
static void halve_to_zero(mpfr_t zero, const struct polynomial *p, mpfr_t from, mpfr_t to)
{
    mpfr_t a, b, at;
    mpfr_inits(a, b, at, (mpfr_ptr)0);
    mpfr_set(a, from, MPFR_RNDN);
    mpfr_set(b, to, MPFR_RNDN);
    polynomial_at(at, p, a);
    bool rising = mpfr_sgn(at) < 0;
    /* A break that is off by this much leaves a jump of a second derivative, at most, over that length. */
    for (mpfr_prec_t step = 0; step < mpfr_get_default_prec() / 2; step++) {
        mpfr_add(zero, a, b, MPFR_RNDN);
        mpfr_div_2ui(zero, zero, 1, MPFR_RNDN);
        polynomial_at(at, p, zero);
        mpfr_set((mpfr_sgn(at) < 0) == rising ? a : b, zero, MPFR_RNDN);
    }
    mpfr_clears(a, b, at, (mpfr_ptr)0);
}

/* Adds the zeros between 0 and `end` in ascending order: between two neighbouring zeros of the derivative there is at most one. */
static int add_zeros(mpfr_t zero[], int n, const struct polynomial *p, mpfr_t end)
{
    if (p->degree == 0)
        return n;
    struct polynomial slope;
    mpfr_t bend[DEGREE + 2], low, high;
    polynomial_init(&slope);
    mpfr_inits(low, high, (mpfr_ptr)0);
    for (int i = 0; i < DEGREE + 2; i++)
        mpfr_init(bend[i]);
    slope.degree = p->degree - 1;
    for (int i = 1; i <= p->degree; i++)
        mpfr_mul_ui(slope.c[i - 1], p->c[i], (unsigned long)i, MPFR_RNDN);
    mpfr_set_zero(bend[0], 1);
    int bends = add_zeros(bend, 1, &slope, end);
    mpfr_set(bend[bends], end, MPFR_RNDN);
    for (int i = 0; i < bends; i++) {
        polynomial_at(low, p, bend[i]);
        polynomial_at(high, p, bend[i + 1]);
        if ((mpfr_sgn(low) < 0) != (mpfr_sgn(high) < 0))
            halve_to_zero(zero[n++], p, bend[i], bend[i + 1]);
    }
    polynomial_clear(&slope);
    mpfr_clears(low, high, (mpfr_ptr)0);
    for (int i = 0; i < DEGREE + 2; i++)
        mpfr_clear(bend[i]);
    return n;
}

/* Those of G. */
static int add_breaks(mpfr_t zero[], int n, struct arc *arc)
{
    struct polynomial form, sum, normal, view, product;
    struct polynomial *const all[] = {&form, &sum, &normal, &view, &product};
    enum { ALL = sizeof all / sizeof all[0] };
    vector N, w;
    mpfr_t h;
    for (int i = 0; i < ALL; i++)
        polynomial_init(all[i]);
    vector_init(N);
    vector_init(w);
    mpfr_init(h);
    mpfr_ptr v_n = arc->lobe->V[2];
    vector_set(w, arc->lobe->V);
    mpfr_set_zero(N[0], 1);
    mpfr_set_zero(N[1], 1);
    mpfr_set_ui(N[2], 1, MPFR_RNDN);
    /* N.L - N.V */
    mpfr_neg(h, v_n, MPFR_RNDN);
    linear_form(&form, arc, N, h);
    n = add_zeros(zero, n, &form, arc->end);
    /* sum = N.V + N.L, view = 1 + V.L, normal = N.L, masking: 2 v_n sum - view */
    linear_form(&sum, arc, N, v_n);
    mpfr_set_ui(h, 1, MPFR_RNDN);
    linear_form(&view, arc, w, h);
    mpfr_set_zero(h, 1);
    linear_form(&normal, arc, N, h);
    for (int i = 0; i <= 2; i++) {
        mpfr_mul(form.c[i], sum.c[i], v_n, MPFR_RNDN);
        mpfr_mul_2ui(form.c[i], form.c[i], 1, MPFR_RNDN);
        mpfr_sub(form.c[i], form.c[i], view.c[i], MPFR_RNDN);
    }
    n = add_zeros(zero, n, &form, arc->end);
    /* shadowing: 2 normal sum - view (1 + u^2) */
    add_product(&product, &normal, &sum, 1);
    add_product(&product, &normal, &sum, 1);
    for (int i = 0; i <= 2; i++)
        mpfr_set_ui(form.c[i], i != 1, MPFR_RNDN);
    add_product(&product, &view, &form, -1);
    n = add_zeros(zero, n, &product, arc->end);
    polynomial_clear(&product);
    polynomial_init(&product);
    /* (v_x q_x + v_y q_y)^2 - v_n^2 (q_x^2 + q_y^2) */
    for (int axis = 0; axis < 2; axis++) {
        vector unit;
        vector_init(unit);
        for (int i = 0; i < 3; i++)
            mpfr_set_ui(unit[i], i == axis, MPFR_RNDN);
        linear_form(&form, arc, unit, w[axis]);
        for (int i = 0; i <= 2; i++)
            mpfr_mul(form.c[i], form.c[i], v_n, MPFR_RNDN);
        add_product(&product, &form, &form, -1);
        vector_clear(unit);
    }
    mpfr_set_zero(w[2], 1);
    vector_dot(h, w, w);
    linear_form(&form, arc, w, h);
    add_product(&product, &form, &form, 1);
    n = add_zeros(zero, n, &product, arc->end);
    for (int i = 0; i < ALL; i++)
        polynomial_clear(all[i]);
    vector_clear(N);
    vector_clear(w);
    mpfr_clear(h);
    return n;
}

/* Where the arc passes -V within a fifth of the bits: that place, and steps to either side of it, each a quarter of the one before. */
static int add_steps(mpfr_t at[], int n, struct arc *arc)
{
    mpfr_prec_t bits = mpfr_get_default_prec();
    mpfr_t along, across, u, step;
    mpfr_inits(along, across, u, step, (mpfr_ptr)0);
    vector_dot(along, arc->lobe->V, arc->a);
    vector_dot(across, arc->lobe->V, arc->e);
    mpfr_hypot(step, along, across, MPFR_RNDN);
    mpfr_ui_sub(u, 1, step, MPFR_RNDN);
    /* The distance squared is 2 - 2 step. */
    bool near = mpfr_cmp_si_2exp(u, 1, -(mpfr_exp_t)(bits * 2 / 5)) < 0;
    /* tan of half the angle at which L is nearest to -V */
    mpfr_sub(u, step, along, MPFR_RNDN);
    mpfr_neg(across, across, MPFR_RNDN);
    mpfr_div(u, across, u, MPFR_RNDN);
    mpfr_set_ui(step, 1, MPFR_RNDN);
    for (mpfr_prec_t i = 0; near && i < bits / 5; i++) {
        mpfr_div_2ui(step, step, 2, MPFR_RNDN);
        for (int side = -1; side <= 1; side++) {
            mpfr_ptr place = at[n];
            mpfr_mul_si(place, step, side, MPFR_RNDN);
            mpfr_add(place, place, u, MPFR_RNDN);
            if (mpfr_sgn(place) > 0 && mpfr_less_p(place, arc->end) && (side != 0 || i == 0))
                n++;
        }
    }
    mpfr_clears(along, across, u, step, (mpfr_ptr)0);
    return n;
}

static int add_folds(mpfr_t zero[], int n, struct arc *arc)
{
    struct polynomial form;
    vector N;
    polynomial_init(&form);
    vector_init(N);
    mpfr_set_zero(N[0], 1);
    mpfr_set_zero(N[1], 1);
    mpfr_set_ui(N[2], 1, MPFR_RNDN);
    linear_form(&form, arc, N, arc->lobe->V[2]);
    n = add_steps(zero, add_zeros(zero, n, &form, arc->end), arc);
    polynomial_clear(&form);
    vector_clear(N);
    return n;
}

/* F d psi/du. */
static void integrand(mpfr_t out, struct arc *arc, mpfr_t u)
{
    enum { Q_X, Q_Y, H_N, D_X, D_Y, SCALE, TWICE, LESS, Q, H, V_T, SINE, COSINE, TURN, N_TERMS };
    mpfr_t t[N_TERMS];
    mpfr_ptr *v = (mpfr_ptr[]){arc->lobe->V[0], arc->lobe->V[1], arc->lobe->V[2]};
    for (int i = 0; i < N_TERMS; i++)
        mpfr_init(t[i]);
    /* 1/(1 + u^2), 2 u and 1 - u^2 over it */
    mpfr_sqr(t[LESS], u, MPFR_RNDN);
    mpfr_add_ui(t[SCALE], t[LESS], 1, MPFR_RNDN);
    mpfr_ui_div(t[SCALE], 1, t[SCALE], MPFR_RNDN);
    mpfr_ui_sub(t[LESS], 1, t[LESS], MPFR_RNDN);
    mpfr_mul(t[LESS], t[LESS], t[SCALE], MPFR_RNDN);
    mpfr_mul(t[TWICE], u, t[SCALE], MPFR_RNDN);
    mpfr_mul_2ui(t[TWICE], t[TWICE], 1, MPFR_RNDN);
    for (int i = 0; i < 3; i++) {
        mpfr_fmma(t[Q_X + i], arc->a[i], t[LESS], arc->e[i], t[TWICE], MPFR_RNDN);
        mpfr_add(t[Q_X + i], t[Q_X + i], v[i], MPFR_RNDN);
    }
    for (int i = 0; i < 2; i++)
        mpfr_fmms(t[D_X + i], arc->e[i], t[LESS], arc->a[i], t[TWICE], MPFR_RNDN);
    /* d psi/du = (q_x q_y' - q_y q_x')/|q|^2, dL/du = 2/(1 + u^2) times the tangent */
    mpfr_fmms(t[TURN], t[Q_X], t[D_Y], t[Q_Y], t[D_X], MPFR_RNDN);
    mpfr_fmma(t[Q], t[Q_X], t[Q_X], t[Q_Y], t[Q_Y], MPFR_RNDN);
    if (mpfr_zero_p(t[Q])) {
        mpfr_set_zero(out, 1);
    } else {
        mpfr_fma(t[H], t[H_N], t[H_N], t[Q], MPFR_RNDN);
        mpfr_sqrt(t[H], t[H], MPFR_RNDN);
        mpfr_mul(t[TURN], t[TURN], t[SCALE], MPFR_RNDN);
        mpfr_mul_2ui(t[TURN], t[TURN], 1, MPFR_RNDN);
        mpfr_div(t[TURN], t[TURN], t[Q], MPFR_RNDN);
        mpfr_sqrt(t[Q], t[Q], MPFR_RNDN);
        mpfr_fmma(t[V_T], v[0], t[Q_X], v[1], t[Q_Y], MPFR_RNDN);
        mpfr_div(t[V_T], t[V_T], t[Q], MPFR_RNDN);
        mpfr_div(t[SINE], t[Q], t[H], MPFR_RNDN);
        mpfr_div(t[COSINE], t[H_N], t[H], MPFR_RNDN);
        lobe_radial(out, arc->lobe, t[V_T], t[SINE], t[COSINE], mpfr_sgn(t[H_N]) < 0);
        mpfr_mul(out, out, t[TURN], MPFR_RNDN);
    }
    for (int i = 0; i < N_TERMS; i++)
        mpfr_clear(t[i]);
}

static void apply_rule(mpfr_t out, struct arc *arc, mpfr_t low, mpfr_t high)
{
    mpfr_t middle, half, u, f;
    mpfr_inits(middle, half, u, f, (mpfr_ptr)0);
    mpfr_add(middle, low, high, MPFR_RNDN);
    mpfr_div_2ui(middle, middle, 1, MPFR_RNDN);
    mpfr_sub(half, high, middle, MPFR_RNDN);
    mpfr_set_zero(out, 1);
    for (int i = 0; i < arc->rule->n; i++) {
        mpfr_fma(u, half, arc->rule->node[i], middle, MPFR_RNDN);
        integrand(f, arc, u);
        mpfr_fma(out, f, arc->rule->weight[i], out, MPFR_RNDN);
    }
    mpfr_mul(out, out, half, MPFR_RNDN);
    mpfr_clears(middle, half, u, f, (mpfr_ptr)0);
}

/* sum += the integral over a piece, of which the rule says `whole`. */
static void add_piece(mpfr_t sum, struct arc *arc, mpfr_t low, mpfr_t high, mpfr_t whole, mpfr_t tolerance,
                      int depth)
{
    mpfr_t middle, left, right, both;
    mpfr_inits(middle, left, right, both, (mpfr_ptr)0);
    mpfr_add(middle, low, high, MPFR_RNDN);
    mpfr_div_2ui(middle, middle, 1, MPFR_RNDN);
    apply_rule(left, arc, low, middle);
    apply_rule(right, arc, middle, high);
    mpfr_add(both, left, right, MPFR_RNDN);
    mpfr_sub(whole, whole, both, MPFR_RNDN);
    if (mpfr_cmpabs(whole, tolerance) <= 0 || depth == DEEPEST || mpfr_equal_p(middle, low) ||
        mpfr_equal_p(middle, high)) {
        mpfr_add(sum, sum, both, MPFR_RNDN);
    } else {
        add_piece(sum, arc, low, middle, left, tolerance, depth + 1);
        add_piece(sum, arc, middle, high, right, tolerance, depth + 1);
    }
    mpfr_clears(middle, left, right, both, (mpfr_ptr)0);
}

static int compare(const void *a, const void *b)
{
    return mpfr_cmp((mpfr_srcptr)a, (mpfr_srcptr)b);
}

static void integrate_between(mpfr_t sum, struct arc *arc, mpfr_t tolerance)
{
    mpfr_t at[BREAKS_MOST], whole;
    mpfr_init(whole);
    for (int i = 0; i < BREAKS_MOST; i++)
        mpfr_init(at[i]);
    mpfr_set_zero(at[0], 1);
    int n = (arc->lobe->attenuation ? add_breaks : add_folds)(at, 1, arc);
    mpfr_set(at[n], arc->end, MPFR_RNDN);
    qsort(at[1], (size_t)(n - 1), sizeof at[0], compare);
    for (int i = 0; i < n; i++) {
        apply_rule(whole, arc, at[i], at[i + 1]);
        add_piece(sum, arc, at[i], at[i + 1], whole, tolerance, 0);
    }
    for (int i = 0; i < BREAKS_MOST; i++)
        mpfr_clear(at[i]);
    mpfr_clear(whole);
}

/* An arc of less than a quarter turn. */
static void integrate_short(mpfr_t sum, struct arc *arc, vector from, vector to, mpfr_t tolerance)
{
    mpfr_t cosine;
    vector m;
    mpfr_init(cosine);
    vector_init(m);
    vector_cross(m, from, to);
    vector_dot(arc->end, m, m);
    if (!mpfr_zero_p(arc->end)) {
        /* tan of half the angle is sin/(1 + cos) */
        vector_dot(cosine, from, to);
        mpfr_sqrt(arc->end, arc->end, MPFR_RNDN);
        mpfr_add_ui(cosine, cosine, 1, MPFR_RNDN);
        mpfr_div(arc->end, arc->end, cosine, MPFR_RNDN);
        vector_set(arc->a, from);
        vector_cross(arc->e, m, from);
        vector_unit(arc->e);
        integrate_between(sum, arc, tolerance);
    }
    mpfr_clear(cosine);
    vector_clear(m);
}

void arc_integrate(mpfr_t sum, struct lobe *lobe, struct rule *rule, vector from, vector to, mpfr_t tolerance)
{
    struct arc arc = {.lobe = lobe, .rule = rule};
    vector middle;
    vector_init(middle);
    vector_init(arc.a);
    vector_init(arc.e);
    mpfr_init(arc.end);
    for (int i = 0; i < 3; i++)
        mpfr_add(middle[i], from[i], to[i], MPFR_RNDN);
    vector_unit(middle);
    integrate_short(sum, &arc, from, middle, tolerance);
    integrate_short(sum, &arc, middle, to, tolerance);
    vector_clear(middle);
    vector_clear(arc.a);
    vector_clear(arc.e);
    mpfr_clear(arc.end);
}
