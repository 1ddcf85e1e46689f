/* Arithmetic that reads as formulas do: numbers of EXACT_BITS bits from one pool, vectors and complex numbers of them.
 *
 *     exact_begin();                       all numbers made before are given up
 *     num c = dot(unit(N), unit(L));
 *     give(out[0], times(k_d, c));
 *
 * One row after another is evaluated, in one thread: the pool is a static array.
 */
#ifndef RL_TESTS_HARD_EXACT_ARITHMETIC_H
#define RL_TESTS_HARD_EXACT_ARITHMETIC_H

#include "exact.h"

typedef mpfr_srcptr num;

typedef struct vec {
    num x, y, z;
} vec;

typedef struct complex_num {
    num re, im;
} complex_num;

void exact_begin(void);
void give(mpfr_t to, num a);

num number(double x);
num pi(void);
num plus(num a, num b);
num minus(num a, num b);
num times(num a, num b);
num over(num a, num b);
num square(num a);
num square_root(num a);
num size_of(num a);
num least_of(num a, num b);
num most_of(num a, num b);
num exponential(num a);
num power(num a, num b); /* a >= 0 */
num angle(num y, num x); /* of the point x, y */
int sign_of(num a);

vec vector(mpfr_t in[], size_t first);
vec sum(vec a, vec b);
vec difference(vec a, vec b);
vec scaled(num s, vec a);
num dot(vec a, vec b);
vec cross(vec a, vec b);
num length(vec a);
vec unit(vec a);

complex_num complex_of(num re, num im);
complex_num complex_plus(complex_num a, complex_num b);
complex_num complex_minus(complex_num a, complex_num b);
complex_num complex_times(complex_num a, complex_num b);
complex_num complex_root(complex_num a); /* the one with re >= 0 */
num norm(complex_num a);                 /* |a|^2 */

/* exact_fresnel.c: F for the cosine c of the angle of incidence; and the index that reflects that part at normal incidence. */
num exact_fresnel_of(num n, num k, num c);
num exact_fresnel_index_of(num reflectance);

#endif
