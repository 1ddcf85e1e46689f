/* Random numbers, photometry and terms of effects, each by its definition. */
#include "exact_arithmetic.h"

#include <gmp.h>

/* ---- Random numbers (Steele, Lea, Flood 2014, figures 16 and 17: SplitMix64), as whole numbers of any size ---- */

/* What is left of x by 2^64. */
static void keep_64(mpz_t x)
{
    mpz_fdiv_r_2exp(x, x, 64);
}

static void mix(mpz_t x)
{
    static const unsigned long shift[] = {30, 27, 31};
    static const char *const factor[] = {"bf58476d1ce4e5b9", "94d049bb133111eb", "1"};
    mpz_t w;
    mpz_init(w);
    for (int i = 0; i < 3; i++) {
        mpz_fdiv_q_2exp(w, x, shift[i]);
        mpz_xor(x, x, w);
        mpz_set_str(w, factor[i], 16);
        mpz_mul(x, x, w);
        keep_64(x);
    }
    mpz_clear(w);
}

/* high 2^32 + low */
static void from_words(mpz_t to, mpfr_t high, mpfr_t low)
{
    mpz_t w;
    mpz_init(w);
    mpfr_get_z(to, high, MPFR_RNDN);
    mpz_mul_2exp(to, to, 32);
    mpfr_get_z(w, low, MPFR_RNDN);
    mpz_add(to, to, w);
    keep_64(to);
    mpz_clear(w);
}

/* mix(mix(seed + golden) + (index + 1) golden), golden = 2^64 over the golden ratio, odd */
static void random_number(mpz_t to, mpfr_t in[])
{
    mpz_t golden, index;
    mpz_init_set_str(golden, "9e3779b97f4a7c15", 16);
    mpz_init(index);
    from_words(to, in[0], in[1]);
    from_words(index, in[2], in[3]);
    mpz_add(to, to, golden);
    keep_64(to);
    mix(to);
    mpz_add_ui(index, index, 1);
    mpz_addmul(to, index, golden);
    keep_64(to);
    mix(to);
    mpz_clears(golden, index, (mpz_ptr)0);
}

void exact_random_bits(mpfr_t out[], mpfr_t in[])
{
    static const unsigned long from[] = {40, 16, 0}, bits[] = {24, 24, 16};
    mpz_t x, part;
    mpz_inits(x, part, (mpz_ptr)0);
    random_number(x, in);
    for (int k = 0; k < 3; k++) {
        mpz_fdiv_q_2exp(part, x, from[k]);
        mpz_fdiv_r_2exp(part, part, bits[k]);
        mpfr_set_z(out[k], part, MPFR_RNDN);
    }
    mpz_clears(x, part, (mpz_ptr)0);
}

/* The middle of the interval of 2^-52 that the first 52 bits say. */
void exact_random_uniform(mpfr_t out[], mpfr_t in[])
{
    mpz_t x;
    mpz_init(x);
    random_number(x, in);
    mpz_fdiv_q_2exp(x, x, 12);
    mpz_mul_2exp(x, x, 1);
    mpz_add_ui(x, x, 1);
    mpfr_set_z_2exp(out[0], x, -53, MPFR_RNDN);
    mpz_clear(x);
}

/* ---- Photometry (ISO 80000-7) ---- */

/* pi A L of one side, twice that of both, pi S L of a closed body; 4 pi I of a point. */
void exact_flux(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    num side = times(pi(), in[0]);
    give(out[0], side);
    give(out[1], plus(side, side));
    give(out[2], side);
    give(out[3], times(times(number(4.0), pi()), in[1]));
}

/* ---- Angles ---- */

/* |a x b|^2/(|a|^2 |b|^2) */
static num sine_squared(vec a, vec b)
{
    vec across = cross(a, b);
    return over(dot(across, across), times(dot(a, a), dot(b, b)));
}

/* And 1 - cos, which is sin^2/(1 + cos): 1 and a cosine of 1 - 1e-200 have no difference in EXACT_BITS. */
void exact_sine_squared(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    vec a = vector(in, 0), b = vector(in, 3);
    num ss = sine_squared(a, b), one = number(1.0), cosine = dot(unit(a), unit(b));
    give(out[0], ss);
    give(out[1], sign_of(cosine) > 0 ? over(ss, plus(one, cosine)) : minus(one, cosine));
}

/* (L + V)/|L + V| and the cosine of the angle between it and L; nothing where they are opposite. */
void exact_half(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    vec l = unit(vector(in, 0)), h = sum(l, unit(vector(in, 3)));
    num none = number(0.0);
    bool opposite = mpfr_cmp_d(length(h), 0x1p-380) < 0; /* what is left then is rounding */
    h = opposite ? (vec){none, none, none} : unit(h);
    give(out[0], h.x);
    give(out[1], h.y);
    give(out[2], h.z);
    give(out[3], dot(l, h));
    give(out[4], opposite ? number(1.0) : sine_squared(l, h));
}

/* max(0, a.b)^n */
void exact_lobe(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    num cosine = dot(unit(vector(in, 0)), unit(vector(in, 3)));
    give(out[0], power(most_of(number(0.0), cosine), in[6]));
}

/* ---- Lines of fixed azimuth ---- */

/* In the plane of t = (cos theta, sin theta, 0) and N, V's foot and all L that a normal in this plane mirrors V to lie on one circle about 0,
 * L.b = -V.b. The plane of m cuts it along the straight line m_t x + m_n y = (V.b)(m.b): two points, or one
 * where rounded arguments let them just miss. The normal is along V + L, or across V - L, with N on its side. */
void exact_crossing(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    mpfr_t s, c;
    mpfr_inits(s, c, (mpfr_ptr)0);
    mpfr_sin_cos(s, c, in[6], MPFR_RNDN);
    vec v = unit(vector(in, 0)), m = vector(in, 3), none = {number(0.0), number(0.0), number(0.0)};
    vec t = {c, s, none.x}, b = {minus(none.x, s), c, none.x}, n = {none.x, none.x, number(1.0)};
    num m_t = dot(m, t), m_n = m.z, r = square_root(plus(square(m_t), square(m_n)));
    num off = over(times(dot(v, b), dot(m, b)), r);
    num half = minus(minus(number(1.0), square(dot(v, b))), square(off));
    half = square_root(most_of(none.x, half));
    /* Along the straight line b.L changes as that of m x L does: by L_t m_n - L_n m_t. */
    vec across = scaled(over(number(1.0), r), sum(scaled(m_t, t), scaled(m_n, n)));
    vec along = scaled(over(number(1.0), r), difference(scaled(m_n, t), scaled(m_t, n)));
    vec v_in = sum(scaled(dot(v, t), t), scaled(dot(v, n), n));
    for (size_t up = 0; up < 2; up++) {
        vec l = sum(scaled(off, across), scaled(up ? half : minus(none.x, half), along));
        vec h = sum(v_in, l), d = difference(v_in, l);
        if (mpfr_cmp(length(h), length(d)) < 0)
            h = sum(scaled(minus(none.x, dot(d, n)), t), scaled(dot(d, t), n));
        h = unit(h);
        bool below = sign_of(h.z) < 0;
        give(out[2 * up], below ? minus(none.x, dot(h, t)) : dot(h, t));
        give(out[2 * up + 1], size_of(h.z));
    }
    mpfr_clears(s, c, (mpfr_ptr)0);
}
