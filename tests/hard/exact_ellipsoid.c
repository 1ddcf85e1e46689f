/* The ellipsoid distribution, as Kimura and Tokoi print it: with k = sqrt(R^2 - 1),
 *
 *     D(delta) = k cos(delta) / (2 atan(k) (1 + k^2 sin^2 delta)),   U(delta) = 1/2 + atan(k sin delta)/(2 atan k)
 *
 * and the same with k = i h for R < 1, where atan(i x) = i atanh(x).
 */
#include "exact.h"

/* U may be 5e-324, and 2U - 1 is to be exact. */
enum { INVERSE_BITS = 2600 };

struct shape {
    int sign; /* of R^2 - 1 */
    mpfr_t k, range;
};

static void arc(mpfr_t to, const struct shape *s, mpfr_t x)
{
    if (s->sign > 0)
        mpfr_atan(to, x, MPFR_RNDN);
    else
        mpfr_atanh(to, x, MPFR_RNDN);
}

static void shape_make(struct shape *s, mpfr_t rr, mpfr_prec_t bits)
{
    mpfr_inits2(bits, s->k, s->range, (mpfr_ptr)0);
    mpfr_sqr(s->k, rr, MPFR_RNDN);
    mpfr_sub_ui(s->k, s->k, 1, MPFR_RNDN);
    s->sign = mpfr_sgn(s->k);
    mpfr_abs(s->k, s->k, MPFR_RNDN);
    mpfr_sqrt(s->k, s->k, MPFR_RNDN);
    arc(s->range, s, s->k);
}

static void shape_clear(struct shape *s)
{
    mpfr_clears(s->k, s->range, (mpfr_ptr)0);
}

void exact_ellipsoid_pdf(mpfr_t out[], mpfr_t in[])
{
    struct shape s;
    mpfr_t sine, cosine;
    shape_make(&s, in[0], EXACT_BITS);
    mpfr_inits(sine, cosine, (mpfr_ptr)0);
    mpfr_sin_cos(sine, cosine, in[1], MPFR_RNDN);
    if (s.sign == 0) {
        mpfr_div_2ui(out[0], cosine, 1, MPFR_RNDN);
    } else {
        /* 1 +- k^2 sin^2 */
        mpfr_mul(sine, sine, s.k, MPFR_RNDN);
        mpfr_sqr(sine, sine, MPFR_RNDN);
        if (s.sign < 0)
            mpfr_neg(sine, sine, MPFR_RNDN);
        mpfr_add_ui(sine, sine, 1, MPFR_RNDN);
        mpfr_mul(cosine, cosine, s.k, MPFR_RNDN);
        mpfr_div(out[0], cosine, sine, MPFR_RNDN);
        mpfr_div(out[0], out[0], s.range, MPFR_RNDN);
        mpfr_div_2ui(out[0], out[0], 1, MPFR_RNDN);
    }
    mpfr_clears(sine, cosine, (mpfr_ptr)0);
    shape_clear(&s);
}

void exact_ellipsoid_cdf(mpfr_t out[], mpfr_t in[])
{
    struct shape s;
    mpfr_t sine;
    shape_make(&s, in[0], EXACT_BITS);
    mpfr_init(sine);
    mpfr_sin(sine, in[1], MPFR_RNDN);
    if (s.sign != 0) {
        mpfr_mul(sine, sine, s.k, MPFR_RNDN);
        arc(sine, &s, sine);
        mpfr_div(sine, sine, s.range, MPFR_RNDN);
    }
    mpfr_add_ui(out[0], sine, 1, MPFR_RNDN);
    mpfr_div_2ui(out[0], out[0], 1, MPFR_RNDN);
    mpfr_clear(sine);
    shape_clear(&s);
}

void exact_ellipsoid_inverse(mpfr_t out[], mpfr_t in[])
{
    struct shape s;
    mpfr_t u;
    shape_make(&s, in[0], INVERSE_BITS);
    mpfr_init2(u, INVERSE_BITS);
    /* U in [0, 1]; a step beyond an end is taken back to it. */
    mpfr_set(u, in[1], MPFR_RNDN);
    if (mpfr_sgn(u) < 0)
        mpfr_set_zero(u, 1);
    if (mpfr_cmp_ui(u, 1) > 0)
        mpfr_set_ui(u, 1, MPFR_RNDN);
    mpfr_mul_2ui(u, u, 1, MPFR_RNDN);
    mpfr_sub_ui(u, u, 1, MPFR_RNDN);
    if (s.sign != 0) {
        mpfr_mul(u, u, s.range, MPFR_RNDN);
        if (s.sign > 0)
            mpfr_tan(u, u, MPFR_RNDN);
        else
            mpfr_tanh(u, u, MPFR_RNDN);
        mpfr_div(u, u, s.k, MPFR_RNDN);
    }
    /* tan(atan k)/k may round to just above 1. */
    if (mpfr_cmp_ui(u, 1) > 0)
        mpfr_set_ui(u, 1, MPFR_RNDN);
    if (mpfr_cmp_si(u, -1) < 0)
        mpfr_set_si(u, -1, MPFR_RNDN);
    mpfr_asin(out[0], u, MPFR_RNDN);
    mpfr_set(out[1], u, MPFR_RNDN);
    mpfr_sqr(u, u, MPFR_RNDN);
    mpfr_ui_sub(u, 1, u, MPFR_RNDN);
    mpfr_sqrt(out[2], u, MPFR_RNDN);
    mpfr_clear(u);
    shape_clear(&s);
}
