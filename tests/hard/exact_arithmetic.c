/* See exact_arithmetic.h. */
#include "exact_arithmetic.h"

#include <stdlib.h>

enum { POOL = 4096 };

static mpfr_t pool[POOL];
static size_t used, made;

void exact_begin(void)
{
    used = 0;
}

static mpfr_ptr fresh(void)
{
    if (used == POOL)
        abort();
    if (used == made)
        mpfr_init2(pool[made++], EXACT_BITS);
    return pool[used++];
}

void give(mpfr_t to, num a)
{
    mpfr_set(to, a, MPFR_RNDN);
}

num number(double x)
{
    mpfr_ptr r = fresh();
    mpfr_set_d(r, x, MPFR_RNDN);
    return r;
}

num pi(void)
{
    mpfr_ptr r = fresh();
    mpfr_const_pi(r, MPFR_RNDN);
    return r;
}

/* clang-format off */
#define OF_ONE(name, function) \
    num name(num a) { mpfr_ptr r = fresh(); function(r, a, MPFR_RNDN); return r; }
#define OF_TWO(name, function) \
    num name(num a, num b) { mpfr_ptr r = fresh(); function(r, a, b, MPFR_RNDN); return r; }
/* clang-format on */

OF_TWO(plus, mpfr_add)
OF_TWO(minus, mpfr_sub)
OF_TWO(times, mpfr_mul)
OF_TWO(over, mpfr_div)
OF_TWO(least_of, mpfr_min)
OF_TWO(most_of, mpfr_max)
OF_TWO(power, mpfr_pow)
OF_TWO(angle, mpfr_atan2)
OF_ONE(square, mpfr_sqr)
OF_ONE(square_root, mpfr_sqrt)
OF_ONE(size_of, mpfr_abs)
OF_ONE(exponential, mpfr_exp)

int sign_of(num a)
{
    return mpfr_sgn(a);
}

/* ---- Vectors ---- */

vec vector(mpfr_t in[], size_t first)
{
    return (vec){in[first], in[first + 1], in[first + 2]};
}

vec sum(vec a, vec b)
{
    return (vec){plus(a.x, b.x), plus(a.y, b.y), plus(a.z, b.z)};
}

vec difference(vec a, vec b)
{
    return (vec){minus(a.x, b.x), minus(a.y, b.y), minus(a.z, b.z)};
}

vec scaled(num s, vec a)
{
    return (vec){times(s, a.x), times(s, a.y), times(s, a.z)};
}

num dot(vec a, vec b)
{
    return plus(plus(times(a.x, b.x), times(a.y, b.y)), times(a.z, b.z));
}

static num minor(num a, num b, num c, num d)
{
    return minus(times(a, b), times(c, d));
}

vec cross(vec a, vec b)
{
    return (vec){minor(a.y, b.z, a.z, b.y), minor(a.z, b.x, a.x, b.z), minor(a.x, b.y, a.y, b.x)};
}

num length(vec a)
{
    return square_root(dot(a, a));
}

vec unit(vec a)
{
    num l = length(a);
    return (vec){over(a.x, l), over(a.y, l), over(a.z, l)};
}

/* ---- Complex numbers ---- */

complex_num complex_of(num re, num im)
{
    return (complex_num){re, im};
}

complex_num complex_plus(complex_num a, complex_num b)
{
    return complex_of(plus(a.re, b.re), plus(a.im, b.im));
}

complex_num complex_minus(complex_num a, complex_num b)
{
    return complex_of(minus(a.re, b.re), minus(a.im, b.im));
}

complex_num complex_times(complex_num a, complex_num b)
{
    return complex_of(minor(a.re, b.re, a.im, b.im), plus(times(a.re, b.im), times(a.im, b.re)));
}

complex_num complex_root(complex_num a)
{
    /* re^2 - im^2 = a.re and re^2 + im^2 = |a| */
    num size = square_root(norm(a)), half = number(0.5), none = number(0.0);
    num re = square_root(most_of(none, times(half, plus(size, a.re))));
    num im = square_root(most_of(none, times(half, minus(size, a.re))));
    return complex_of(re, sign_of(a.im) < 0 ? minus(none, im) : im);
}

num norm(complex_num a)
{
    return plus(square(a.re), square(a.im));
}
