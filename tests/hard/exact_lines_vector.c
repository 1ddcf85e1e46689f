/* Vectors, and Gauss and Legendre's rule. */
#include "exact_lines.h"

void vector_init(vector a)
{
    for (int i = 0; i < 3; i++)
        mpfr_init(a[i]);
}

void vector_clear(vector a)
{
    for (int i = 0; i < 3; i++)
        mpfr_clear(a[i]);
}

void vector_set(vector to, vector a)
{
    for (int i = 0; i < 3; i++)
        mpfr_set(to[i], a[i], MPFR_RNDN);
}

void vector_cross(vector to, vector a, vector b)
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        mpfr_fmms(to[i], a[j], b[k], a[k], b[j], MPFR_RNDN);
    }
}

void vector_dot(mpfr_t to, vector a, vector b)
{
    mpfr_t sum;
    mpfr_init(sum);
    mpfr_fmma(sum, a[0], b[0], a[1], b[1], MPFR_RNDN);
    mpfr_fma(to, a[2], b[2], sum, MPFR_RNDN);
    mpfr_clear(sum);
}

void vector_unit(vector a)
{
    mpfr_t length;
    mpfr_init(length);
    vector_dot(length, a, a);
    mpfr_sqrt(length, length, MPFR_RNDN);
    for (int i = 0; i < 3; i++)
        mpfr_div(a[i], a[i], length, MPFR_RNDN);
    mpfr_clear(length);
}

/* P_n at x and its derivative, by the recurrence (j + 1) P_(j+1) = (2 j + 1) x P_j - j P_(j-1). */
static void legendre(mpfr_t value, mpfr_t slope, mpfr_t x, int n)
{
    mpfr_t before, next;
    mpfr_inits(before, next, (mpfr_ptr)0);
    mpfr_set_ui(before, 1, MPFR_RNDN);
    mpfr_set(value, x, MPFR_RNDN);
    for (int j = 1; j < n; j++) {
        mpfr_mul(next, x, value, MPFR_RNDN);
        mpfr_mul_ui(next, next, (unsigned long)(2 * j + 1), MPFR_RNDN);
        mpfr_mul_ui(before, before, (unsigned long)j, MPFR_RNDN);
        mpfr_sub(next, next, before, MPFR_RNDN);
        mpfr_div_ui(next, next, (unsigned long)(j + 1), MPFR_RNDN);
        mpfr_set(before, value, MPFR_RNDN);
        mpfr_set(value, next, MPFR_RNDN);
    }
    /* P_n' = n (x P_n - P_(n-1))/(x^2 - 1) */
    mpfr_fms(slope, x, value, before, MPFR_RNDN);
    mpfr_mul_ui(slope, slope, (unsigned long)n, MPFR_RNDN);
    mpfr_sqr(next, x, MPFR_RNDN);
    mpfr_sub_ui(next, next, 1, MPFR_RNDN);
    mpfr_div(slope, slope, next, MPFR_RNDN);
    mpfr_clears(before, next, (mpfr_ptr)0);
}

void rule_make(struct rule *rule, int n)
{
    enum { STEPS = 12 }; /* Newton's, each with twice the digits of the one before */
    mpfr_t value, slope, pi;
    mpfr_inits(value, slope, pi, (mpfr_ptr)0);
    mpfr_const_pi(pi, MPFR_RNDN);
    rule->n = n;
    for (int i = 0; i < n; i++) {
        mpfr_ptr x = rule->node[i], w = rule->weight[i];
        mpfr_inits(x, w, (mpfr_ptr)0);
        mpfr_mul_d(x, pi, (i + 0.75) / (n + 0.5), MPFR_RNDN);
        mpfr_cos(x, x, MPFR_RNDN);
        for (int step = 0; step < STEPS; step++) {
            legendre(value, slope, x, n);
            mpfr_div(value, value, slope, MPFR_RNDN);
            mpfr_sub(x, x, value, MPFR_RNDN);
        }
        legendre(value, slope, x, n);
        /* w = 2/((1 - x^2) P_n'^2) */
        mpfr_sqr(w, x, MPFR_RNDN);
        mpfr_ui_sub(w, 1, w, MPFR_RNDN);
        mpfr_sqr(slope, slope, MPFR_RNDN);
        mpfr_mul(w, w, slope, MPFR_RNDN);
        mpfr_ui_div(w, 2, w, MPFR_RNDN);
    }
    mpfr_clears(value, slope, pi, (mpfr_ptr)0);
}

void rule_clear(struct rule *rule)
{
    for (int i = 0; i < rule->n; i++)
        mpfr_clears(rule->node[i], rule->weight[i], (mpfr_ptr)0);
}
