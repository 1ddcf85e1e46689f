/* Convex spherical polygons: cut, intersected, and what light fills of them. */
#include "exact_lines.h"

void convex_init(struct convex *c)
{
    c->n = 0;
    for (int i = 0; i < CORNERS_MOST; i++)
        vector_init(c->corner[i]);
}

void convex_clear(struct convex *c)
{
    for (int i = 0; i < CORNERS_MOST; i++)
        vector_clear(c->corner[i]);
}

/* Where the arc from a to b meets the great circle of m, from which they are d_a and d_b away, on different sides. */
static void meet(vector out, vector a, vector b, mpfr_t d_a, mpfr_t d_b)
{
    for (int i = 0; i < 3; i++) {
        mpfr_fmms(out[i], d_a, b[i], d_b, a[i], MPFR_RNDN);
        if (mpfr_sgn(d_a) < 0)
            mpfr_neg(out[i], out[i], MPFR_RNDN);
    }
    vector_unit(out);
}

void convex_cut(struct convex *c, vector m)
{
    struct convex kept;
    mpfr_t d_a, d_b;
    convex_init(&kept);
    mpfr_inits(d_a, d_b, (mpfr_ptr)0);
    for (int i = 0; i < c->n; i++) {
        vector *a = &c->corner[i], *b = &c->corner[(i + 1) % c->n];
        vector_dot(d_a, m, *a);
        vector_dot(d_b, m, *b);
        if (mpfr_sgn(d_a) >= 0)
            vector_set(kept.corner[kept.n++], *a);
        if (mpfr_sgn(d_a) * mpfr_sgn(d_b) < 0)
            meet(kept.corner[kept.n++], *a, *b, d_a, d_b);
    }
    c->n = kept.n;
    for (int i = 0; i < kept.n; i++)
        vector_set(c->corner[i], kept.corner[i]);
    convex_clear(&kept);
    mpfr_clears(d_a, d_b, (mpfr_ptr)0);
}

void convex_intersect(struct convex *a, struct convex *b)
{
    vector m;
    vector_init(m);
    for (int i = 0; i < b->n; i++) {
        vector_cross(m, b->corner[i], b->corner[(i + 1) % b->n]);
        convex_cut(a, m);
    }
    vector_clear(m);
}

/* Without attenuation: whether -V lies inside. On an edge nothing can be said; V is moved off it first, by a third of the bits. */
static bool holds_opposite(struct convex *c, struct lobe *lobe)
{
    mpfr_exp_t close = -(mpfr_exp_t)(mpfr_get_default_prec() / 3);
    vector m;
    mpfr_t side;
    bool inside = true, on = false;
    vector_init(m);
    mpfr_init(side);
    for (int i = 0; i < c->n; i++) {
        vector_cross(m, c->corner[i], c->corner[(i + 1) % c->n]);
        if (mpfr_zero_p(m[0]) && mpfr_zero_p(m[1]) && mpfr_zero_p(m[2]))
            continue;
        vector_unit(m);
        vector_dot(side, m, lobe->V);
        inside = inside && mpfr_sgn(side) < 0;
        on = on || mpfr_zero_p(side) || mpfr_get_exp(side) < close;
    }
    vector_clear(m);
    if (on) {
        static const unsigned long parts[] = {3, 5, 7};
        for (int i = 0; i < 3; i++) {
            mpfr_set_ui_2exp(side, parts[i], close, MPFR_RNDN);
            mpfr_add(lobe->V[i], lobe->V[i], side, MPFR_RNDN);
        }
        vector_unit(lobe->V);
    }
    mpfr_clear(side);
    return on ? holds_opposite(c, lobe) : inside;
}

void convex_highlight(mpfr_t out, struct lobe *lobe, struct rule *rule, struct convex *c, mpfr_t tolerance)
{
    mpfr_t pi;
    vector N;
    mpfr_init(pi);
    mpfr_const_pi(pi, MPFR_RNDN);
    vector_init(N);
    for (int i = 0; i < 3; i++)
        mpfr_set_ui(N[i], i == 2, MPFR_RNDN);
    mpfr_set_zero(out, 1);
    if (lobe->attenuation)
        convex_cut(c, N);
    bool more = c->n > 2 && !lobe->attenuation && holds_opposite(c, lobe);
    for (int i = 0; i < c->n && c->n > 2; i++)
        arc_integrate(out, lobe, rule, c->corner[i], c->corner[(i + 1) % c->n], tolerance);
    mpfr_div(out, out, pi, MPFR_RNDN);
    if (more)
        mpfr_add_ui(out, out, 1, MPFR_RNDN);
    mpfr_clear(pi);
    vector_clear(N);
}
