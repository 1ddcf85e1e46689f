/* Lobes about a direction, from their papers.
 *
 *     W(alpha) cos^n(gamma)    Phong 1975: gamma between the mirror direction of the eye and the light, alpha of incidence; N.L > 0
 *     W(beta) cos^n(delta)     Blinn 1977: delta between N and the half vector, beta between it and the light; N.L > 0 and N.V > 0
 *
 * W = k_s + g (1 - k_s)(1 - cos)^5 (Schlick 1994).
 */
#include "exact_arithmetic.h"

#include <math.h>

static void give_lobe(mpfr_t out[], mpfr_t in[], num cosine, num incidence)
{
    num one = number(1.0), lobe = power(most_of(number(0.0), cosine), in[13]);
    num away = most_of(number(0.0), minus(one, incidence));
    num grazing = times(in[12], power(away, number(5.0)));
    for (int c = 0; c < 3; c++)
        give(out[c], times(lobe, plus(in[9 + c], times(grazing, minus(one, in[9 + c])))));
}

void exact_phong(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    vec N = unit(vector(in, 0)), V = unit(vector(in, 3)), L = unit(vector(in, 6));
    num n_l = dot(N, L);
    vec R = difference(scaled(times(number(2.0), dot(N, V)), N), V);
    give_lobe(out, in, sign_of(n_l) > 0 ? dot(R, L) : number(0.0), n_l);
}

void exact_blinn(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    vec N = unit(vector(in, 0)), V = unit(vector(in, 3)), L = unit(vector(in, 6));
    num none = number(0.0);
    if (sign_of(dot(N, L)) <= 0 || sign_of(dot(N, V)) <= 0) {
        give_lobe(out, in, none, none);
        return;
    }
    vec H = unit(sum(L, V));
    give_lobe(out, in, dot(N, H), dot(L, H));
}

/* A dot product of vectors made unit is off by some eight units in the last place of each term. */
static bool level(mpfr_t in[], size_t a, size_t b, int bits)
{
    exact_begin();
    num terms = number(0.0);
    for (size_t c = 0; c < 3; c++)
        terms = plus(terms, size_of(times(in[a + c], in[b + c])));
    num most = times(number(ldexp(16.0, -bits)), terms);
    return mpfr_cmp(size_of(dot(vector(in, a), vector(in, b))), most) < 0;
}

bool exact_light_level(mpfr_t in[], int bits)
{
    return level(in, 0, 6, bits);
}

bool exact_either_level(mpfr_t in[], int bits)
{
    return level(in, 0, 6, bits) || level(in, 0, 3, bits);
}
