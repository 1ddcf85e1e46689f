/* F = the integral of D G over delta, from 0 along one radius.
 *
 * D = norm cos(delta)/(1 + K sin^2 delta), K = R^2 - 1; G as it is defined, with N.H = cos(delta), V.H = v_t sin(delta) + v_N cos(delta)
 * and N.L = 2 (V.H)(N.H) - v_N. Let rho, phi be the length and the angle from N of (v_t, v_N). By the sums of angles,
 *
 *     N.L = rho cos(2 delta - phi), so that masking and shadowing are equal (N.L = N.V) at delta = phi;
 *     masking is 1 where tan(delta) = 1/tan(phi);
 *     shadowing is 1 where 2 cos(delta) cos(2 delta - phi) = cos(delta - phi), which is cos(3 delta - phi) = 0.
 *
 * Outwards from delta = 0 there come: G = 1; if phi > pi/4, masking from pi/2 - phi to phi; then shadowing. And shadowing is
 * 4 cos^2 delta - masking. What is to be integrated then is
 *
 *     D, by s = sin(delta);    4 D cos^2, by (1 - s^2)/(1 + K s^2) = -1/K + (1 + 1/K)/(1 + K s^2);
 *
 * and D times masking, which is rational in z = e^(i delta): with w = v_N + i v_t, in all,
 *
 *     norm 2 v_N (2/i) (Z + 1)^2/((conj(w) Z + w)(4 Z - K (Z - 1)^2)) dz,   Z = z^2,
 *
 * whose three poles in Z are -w/conj(w) and (R +- 1)^2/K; each gives its residue times log((z - z_j)/(z + z_j))/(2 z_j).
 */
#include "exact_lines.h"

struct complex_number {
    mpfr_t re, im;
};

static void c_init(struct complex_number *a)
{
    mpfr_inits(a->re, a->im, (mpfr_ptr)0);
}

static void c_clear(struct complex_number *a)
{
    mpfr_clears(a->re, a->im, (mpfr_ptr)0);
}

/* a *= b */
static void c_mul(struct complex_number *a, struct complex_number *b)
{
    mpfr_t re;
    mpfr_init(re);
    mpfr_fmms(re, a->re, b->re, a->im, b->im, MPFR_RNDN);
    mpfr_fmma(a->im, a->re, b->im, a->im, b->re, MPFR_RNDN);
    mpfr_swap(a->re, re);
    mpfr_clear(re);
}

/* a /= b */
static void c_div(struct complex_number *a, struct complex_number *b)
{
    mpfr_t norm;
    mpfr_init(norm);
    mpfr_fmma(norm, b->re, b->re, b->im, b->im, MPFR_RNDN);
    mpfr_neg(b->im, b->im, MPFR_RNDN);
    c_mul(a, b);
    mpfr_neg(b->im, b->im, MPFR_RNDN);
    mpfr_div(a->re, a->re, norm, MPFR_RNDN);
    mpfr_div(a->im, a->im, norm, MPFR_RNDN);
    mpfr_clear(norm);
}

/* a = log a, of argument in (-pi, pi]. */
static void c_log(struct complex_number *a)
{
    mpfr_t angle;
    mpfr_init(angle);
    mpfr_atan2(angle, a->im, a->re, MPFR_RNDN);
    mpfr_fmma(a->re, a->re, a->re, a->im, a->im, MPFR_RNDN);
    mpfr_log(a->re, a->re, MPFR_RNDN);
    mpfr_div_2ui(a->re, a->re, 1, MPFR_RNDN);
    mpfr_swap(a->im, angle);
    mpfr_clear(angle);
}

/* to = b - a, or b + a */
static void c_off(struct complex_number *to, struct complex_number *b, struct complex_number *a, int sign)
{
    (sign < 0 ? mpfr_sub : mpfr_add)(to->re, b->re, a->re, MPFR_RNDN);
    (sign < 0 ? mpfr_sub : mpfr_add)(to->im, b->im, a->im, MPFR_RNDN);
}

/* An angle by its sine and cosine: z = cosine + i sine. */
struct place {
    mpfr_t s, c;
};

static void place_init(struct place *p)
{
    mpfr_inits(p->s, p->c, (mpfr_ptr)0);
}

static void place_clear(struct place *p)
{
    mpfr_clears(p->s, p->c, (mpfr_ptr)0);
}

void lobe_make(struct lobe *lobe, mpfr_t rr, bool attenuation)
{
    mpfr_inits(lobe->rr, lobe->kk, lobe->k, lobe->norm, (mpfr_ptr)0);
    vector_init(lobe->V);
    lobe->attenuation = attenuation;
    mpfr_set(lobe->rr, rr, MPFR_RNDN);
    if (mpfr_cmp_ui(rr, 1) == 0) {
        mpfr_set_ui_2exp(lobe->k, 1, -(mpfr_exp_t)(mpfr_get_default_prec() * 2 / 5), MPFR_RNDN);
        mpfr_add(lobe->rr, lobe->rr, lobe->k, MPFR_RNDN);
    }
    mpfr_sqr(lobe->kk, lobe->rr, MPFR_RNDN);
    mpfr_sub_ui(lobe->kk, lobe->kk, 1, MPFR_RNDN);
    mpfr_abs(lobe->k, lobe->kk, MPFR_RNDN);
    mpfr_sqrt(lobe->k, lobe->k, MPFR_RNDN);
    (mpfr_sgn(lobe->kk) > 0 ? mpfr_atan : mpfr_atanh)(lobe->norm, lobe->k, MPFR_RNDN);
    mpfr_div(lobe->norm, lobe->k, lobe->norm, MPFR_RNDN);
    mpfr_div_2ui(lobe->norm, lobe->norm, 1, MPFR_RNDN);
}

void lobe_clear(struct lobe *lobe)
{
    mpfr_clears(lobe->rr, lobe->kk, lobe->k, lobe->norm, (mpfr_ptr)0);
    vector_clear(lobe->V);
}

/* The integral of ds/(1 + K s^2) from 0. */
static void arc_of(mpfr_t out, struct lobe *lobe, mpfr_t s)
{
    mpfr_mul(out, lobe->k, s, MPFR_RNDN);
    (mpfr_sgn(lobe->kk) > 0 ? mpfr_atan : mpfr_atanh)(out, out, MPFR_RNDN);
    mpfr_div(out, out, lobe->k, MPFR_RNDN);
}

/* out += sign * the integral of cos^3/(1 + K sin^2) from 0. */
static void add_cube(mpfr_t out, struct lobe *lobe, mpfr_t s, int sign)
{
    mpfr_t part;
    mpfr_init(part);
    arc_of(part, lobe, s);
    mpfr_sub(part, part, s, MPFR_RNDN);
    mpfr_div(part, part, lobe->kk, MPFR_RNDN);
    (sign < 0 ? mpfr_sub : mpfr_add)(out, out, part, MPFR_RNDN);
    arc_of(part, lobe, s);
    (sign < 0 ? mpfr_sub : mpfr_add)(out, out, part, MPFR_RNDN);
    mpfr_clear(part);
}

/* The poles in Z, and in z. */
static void find_poles(struct complex_number Z[3], struct complex_number z[3], struct lobe *lobe,
                       struct complex_number *w)
{
    mpfr_t root;
    mpfr_init(root);
    mpfr_fmma(root, w->re, w->re, w->im, w->im, MPFR_RNDN);
    mpfr_sqrt(root, root, MPFR_RNDN);
    /* z = i w/|w| */
    mpfr_div(z[0].re, w->im, root, MPFR_RNDN);
    mpfr_neg(z[0].re, z[0].re, MPFR_RNDN);
    mpfr_div(z[0].im, w->re, root, MPFR_RNDN);
    mpfr_set(Z[0].re, z[0].re, MPFR_RNDN);
    mpfr_set(Z[0].im, z[0].im, MPFR_RNDN);
    c_mul(&Z[0], &z[0]);
    for (int i = 1; i < 3; i++) {
        (i == 1 ? mpfr_add_ui : mpfr_sub_ui)(root, lobe->rr, 1, MPFR_RNDN);
        mpfr_sqr(Z[i].re, root, MPFR_RNDN);
        mpfr_div(Z[i].re, Z[i].re, lobe->kk, MPFR_RNDN);
        mpfr_abs(root, Z[i].re, MPFR_RNDN);
        mpfr_sqrt(root, root, MPFR_RNDN);
        mpfr_set_zero(Z[i].im, 1);
        mpfr_set_zero(z[i].re, 1);
        mpfr_set_zero(z[i].im, 1);
        mpfr_set(mpfr_sgn(lobe->kk) > 0 ? z[i].re : z[i].im, root, MPFR_RNDN);
    }
    mpfr_clear(root);
}

/* term = (Z_j + 1)^2/(-conj(w) K product of the others (Z_j - Z_i))/(2 z_j): the residue, times what the logarithm has before it. */
static void residue(struct complex_number *term, struct complex_number Z[3], struct complex_number *z, int j,
                    struct lobe *lobe, struct complex_number *w)
{
    struct complex_number below;
    c_init(&below);
    mpfr_add_ui(term->re, Z[j].re, 1, MPFR_RNDN);
    mpfr_set(term->im, Z[j].im, MPFR_RNDN);
    mpfr_set(below.re, term->re, MPFR_RNDN);
    mpfr_set(below.im, term->im, MPFR_RNDN);
    c_mul(term, &below);
    mpfr_neg(w->im, w->im, MPFR_RNDN);
    c_div(term, w);
    mpfr_neg(w->im, w->im, MPFR_RNDN);
    for (int i = 0; i < 3; i++) {
        if (i == j)
            continue;
        c_off(&below, &Z[j], &Z[i], -1);
        c_div(term, &below);
    }
    c_div(term, z);
    mpfr_div(term->re, term->re, lobe->kk, MPFR_RNDN);
    mpfr_div(term->im, term->im, lobe->kk, MPFR_RNDN);
    mpfr_div_si(term->re, term->re, -2, MPFR_RNDN);
    mpfr_div_si(term->im, term->im, -2, MPFR_RNDN);
    c_clear(&below);
}

/* ratio = log((b - z)(a + z)/((b + z)(a - z))) */
static void log_between(struct complex_number *ratio, struct complex_number *a, struct complex_number *b,
                        struct complex_number *z)
{
    struct complex_number factor;
    c_init(&factor);
    c_off(ratio, b, z, -1);
    c_off(&factor, a, z, 1);
    c_mul(ratio, &factor);
    c_off(&factor, b, z, 1);
    c_div(ratio, &factor);
    c_off(&factor, a, z, -1);
    c_div(ratio, &factor);
    c_log(ratio);
    c_clear(&factor);
}

/* out += sign * the integral of D masking from one place to the other. */
static void add_masking(mpfr_t out, struct lobe *lobe, mpfr_t v_t, struct place *from, struct place *to,
                        int sign)
{
    struct complex_number w, Z[3], z[3], a, b, term, ratio;
    struct complex_number *const all[] = {&w,    &Z[0], &Z[1], &Z[2], &z[0], &z[1],
                                          &z[2], &a,    &b,    &term, &ratio};
    enum { ALL = sizeof all / sizeof all[0] };
    mpfr_t sum;
    mpfr_init(sum);
    for (int i = 0; i < ALL; i++)
        c_init(all[i]);
    mpfr_set(w.re, lobe->V[2], MPFR_RNDN);
    mpfr_set(w.im, v_t, MPFR_RNDN);
    mpfr_set(a.re, from->c, MPFR_RNDN);
    mpfr_set(a.im, from->s, MPFR_RNDN);
    mpfr_set(b.re, to->c, MPFR_RNDN);
    mpfr_set(b.im, to->s, MPFR_RNDN);
    find_poles(Z, z, lobe, &w);
    mpfr_set_zero(sum, 1);
    for (int j = 0; j < 3; j++) {
        residue(&term, Z, &z[j], j, lobe, &w);
        log_between(&ratio, &a, &b, &z[j]);
        c_mul(&term, &ratio);
        /* 2/i times it: its real part is twice the imaginary one. */
        mpfr_add(sum, sum, term.im, MPFR_RNDN);
    }
    mpfr_mul(sum, sum, lobe->norm, MPFR_RNDN);
    mpfr_mul(sum, sum, lobe->V[2], MPFR_RNDN);
    mpfr_mul_si(sum, sum, 4L * sign, MPFR_RNDN);
    mpfr_add(out, out, sum, MPFR_RNDN);
    for (int i = 0; i < ALL; i++)
        c_clear(all[i]);
    mpfr_clear(sum);
}

/* Whether G = 1 there: 2 (N.H) min(N.V, N.L) >= V.H. */
static bool is_full(struct lobe *lobe, mpfr_t v_t, struct place *at)
{
    mpfr_t v_h, n_l;
    mpfr_inits(v_h, n_l, (mpfr_ptr)0);
    mpfr_fmma(v_h, v_t, at->s, lobe->V[2], at->c, MPFR_RNDN);
    mpfr_mul(n_l, v_h, at->c, MPFR_RNDN);
    mpfr_mul_2ui(n_l, n_l, 1, MPFR_RNDN);
    mpfr_sub(n_l, n_l, lobe->V[2], MPFR_RNDN);
    mpfr_min(n_l, n_l, lobe->V[2], MPFR_RNDN);
    mpfr_mul(n_l, n_l, at->c, MPFR_RNDN);
    mpfr_mul_2ui(n_l, n_l, 1, MPFR_RNDN);
    bool full = mpfr_greaterequal_p(n_l, v_h);
    mpfr_clears(v_h, n_l, (mpfr_ptr)0);
    return full;
}

/* out += the integral from where G = 1 ends to `at`; `first` becomes that end. */
static void add_beyond(mpfr_t out, struct lobe *lobe, mpfr_t v_t, struct place *first, struct place *at)
{
    struct place swap;
    mpfr_t cube, length;
    place_init(&swap);
    mpfr_inits(cube, length, (mpfr_ptr)0);
    mpfr_set_zero(cube, 1);
    if (mpfr_greater_p(v_t, lobe->V[2])) {
        mpfr_hypot(length, v_t, lobe->V[2], MPFR_RNDN);
        mpfr_div(first->s, lobe->V[2], length, MPFR_RNDN);
        mpfr_div(first->c, v_t, length, MPFR_RNDN);
        mpfr_set(swap.s, first->c, MPFR_RNDN);
        mpfr_set(swap.c, first->s, MPFR_RNDN);
        add_masking(out, lobe, v_t, first, mpfr_less_p(at->s, swap.s) ? at : &swap, 1);
    } else {
        mpfr_const_pi(length, MPFR_RNDN);
        mpfr_div_2ui(length, length, 1, MPFR_RNDN);
        mpfr_atan2(swap.s, v_t, lobe->V[2], MPFR_RNDN);
        mpfr_add(swap.s, swap.s, length, MPFR_RNDN);
        mpfr_div_ui(swap.s, swap.s, 3, MPFR_RNDN);
        mpfr_sin_cos(first->s, first->c, swap.s, MPFR_RNDN);
        mpfr_set(swap.s, first->s, MPFR_RNDN);
        mpfr_set(swap.c, first->c, MPFR_RNDN);
    }
    if (mpfr_greater_p(at->s, swap.s)) {
        add_cube(cube, lobe, at->s, 1);
        add_cube(cube, lobe, swap.s, -1);
        mpfr_mul(cube, cube, lobe->norm, MPFR_RNDN);
        mpfr_mul_2ui(cube, cube, 2, MPFR_RNDN);
        mpfr_add(out, out, cube, MPFR_RNDN);
        add_masking(out, lobe, v_t, &swap, at, -1);
    }
    place_clear(&swap);
    mpfr_clears(cube, length, (mpfr_ptr)0);
}

void lobe_radial(mpfr_t out, struct lobe *lobe, mpfr_t v_t, mpfr_t sine, mpfr_t cosine, bool folded)
{
    struct place at, first;
    mpfr_t beyond;
    place_init(&at);
    place_init(&first);
    mpfr_init(beyond);
    mpfr_set_zero(beyond, 1);
    mpfr_set(at.s, sine, MPFR_RNDN);
    mpfr_set(at.c, cosine, MPFR_RNDN);
    mpfr_set(first.s, sine, MPFR_RNDN);
    if (lobe->attenuation && !is_full(lobe, v_t, &at))
        add_beyond(beyond, lobe, v_t, &first, &at);
    arc_of(out, lobe, first.s);
    mpfr_mul(out, out, lobe->norm, MPFR_RNDN);
    mpfr_add(out, out, beyond, MPFR_RNDN);
    if (folded)
        mpfr_ui_sub(out, 1, out, MPFR_RNDN);
    place_clear(&at);
    place_clear(&first);
    mpfr_clear(beyond);
}
