/* Exact answers of a row in both precisions, and their bounds by the rule that exact.c states. */
#include "exact.h"

#include <float.h>
#include <math.h>

/* Rounding leaves an argument in its range: the last number inside takes the place of what is beyond an end. */
static float within(const struct exact_range *range, float x)
{
    if (range && range->low < range->high && (double)x > range->high)
        return nextafterf(x, -INFINITY);
    if (range && range->low < range->high && (double)x < range->low)
        return nextafterf(x, INFINITY);
    return x;
}

/* An argument of the row, as that precision has it. */
void exact_argument(mpfr_t to, const struct exact_function *f, size_t i, double x, int bits)
{
    if (bits == EXACT_DOUBLE) {
        mpfr_set_d(to, x, MPFR_RNDN);
    } else if (i < 3 * f->n_directions) {
        /* Of any size: what is evaluated gets the direction scaled to about 1. */
        mpfr_set_d(to, x, MPFR_RNDN);
        mpfr_prec_round(to, EXACT_SINGLE, MPFR_RNDN);
        mpfr_prec_round(to, EXACT_BITS, MPFR_RNDN);
    } else {
        float single = fabs(x) > (double)FLT_MAX ? copysignf(FLT_MAX, (float)x) : (float)x;
        mpfr_set_flt(to, within(i < EXACT_RANGES ? &f->range[i] : NULL, single), MPFR_RNDN);
    }
}

/* x moved by one unit in the last place of that precision, up or down. */
static void step(mpfr_t to, mpfr_t x, int bits, bool up)
{
    mpfr_set(to, x, MPFR_RNDN);
    mpfr_prec_round(to, bits, MPFR_RNDN);
    if (up)
        mpfr_nextabove(to);
    else
        mpfr_nextbelow(to);
    mpfr_prec_round(to, EXACT_BITS, MPFR_RNDN);
}

/* What the results move by when each argument does; an argument of 0, or one left out, stays. */
static void add_moves(const struct exact_function *f, mpfr_t in[], mpfr_t out[], mpfr_t moves[], int bits)
{
    mpfr_t there[EXACT_OUT_MAX], kept;
    mpfr_init(kept);
    for (size_t k = 0; k < f->n_out; k++) {
        mpfr_init(there[k]);
        mpfr_set_zero(moves[k], 1);
    }
    for (size_t i = 0; i < 2 * f->n_in && !f->whole_numbers; i++) {
        mpfr_ptr x = in[i / 2];
        if (mpfr_nan_p(x) || mpfr_zero_p(x))
            continue;
        mpfr_set(kept, x, MPFR_RNDN);
        step(x, kept, bits, i % 2 != 0);
        f->evaluate(there, in);
        mpfr_set(x, kept, MPFR_RNDN);
        for (size_t k = 0; k < f->n_out; k++) {
            /* Both ways are added up, and halved below. */
            mpfr_sub(there[k], there[k], out[k], MPFR_RNDN);
            mpfr_abs(there[k], there[k], MPFR_RNDN);
            mpfr_add(moves[k], moves[k], there[k], MPFR_RNDN);
        }
    }
    for (size_t k = 0; k < f->n_out; k++) {
        mpfr_div_2ui(moves[k], moves[k], 1, MPFR_RNDN);
        mpfr_clear(there[k]);
    }
    mpfr_clear(kept);
}

/* The unit in the last place, down to that of denormal numbers; single precision has a wider bound there. */
static double unit_of(double value, int bits)
{
    return value > 0.0 ? fmax(ldexp(1.0, ilogb(value) + 1 - bits), DBL_TRUE_MIN) : DBL_TRUE_MIN;
}

/* Of the answer y whose arguments move it by `moves`. */
static double bound(double whole, mpfr_t y, mpfr_t moves, int bits)
{
    double value = fabs(mpfr_get_d(y, MPFR_RNDN)), moved = 2.0 * mpfr_get_d(moves, MPFR_RNDU);
    double least = bits == EXACT_SINGLE ? fmax(1e-5 * value, 1e-6) : unit_of(whole, bits);
    return fmax(fmax(8.0 * unit_of(value, bits), least), moved);
}

void exact_answer_init(struct exact_answer *a, const struct exact_function *f)
{
    a->strict = false;
    for (size_t i = 0; i < f->n_in; i++)
        mpfr_init(a->in[i]);
    for (size_t k = 0; k < f->n_out; k++)
        for (int p = 0; p < 2; p++)
            mpfr_inits(a->out[p][k], a->moves[p][k], (mpfr_ptr)0);
}

void exact_answer_clear(struct exact_answer *a, const struct exact_function *f)
{
    for (size_t i = 0; i < f->n_in; i++)
        mpfr_clear(a->in[i]);
    for (size_t k = 0; k < f->n_out; k++)
        for (int p = 0; p < 2; p++)
            mpfr_clears(a->out[p][k], a->moves[p][k], (mpfr_ptr)0);
}

bool exact_answer_make(struct exact_answer *a, const struct exact_function *f, const double *row)
{
    static const int bits[] = {EXACT_DOUBLE, EXACT_SINGLE};
    for (int p = 0; p < 2; p++) {
        for (size_t i = 0; i < f->n_in; i++)
            exact_argument(a->in[i], f, i, row[i], bits[p]);
        exact_unit = ldexp(1.0, 1 - bits[p]);
        f->evaluate(a->out[p], a->in);
        add_moves(f, a->in, a->out[p], a->moves[p], bits[p]);
    }
    for (size_t i = 0; i < f->n_in; i++)
        exact_argument(a->in[i], f, i, row[i], EXACT_DOUBLE);
    double whole = f->whole ? f->whole(a->in) : 0.0;
    for (size_t k = 0; k < f->n_out; k++) {
        for (int p = 0; p < 2; p++) {
            if (!mpfr_number_p(a->out[p][k]))
                return false;
            /* Without the sign of zero, which no bound asks for. */
            if (mpfr_zero_p(a->out[p][k]))
                mpfr_set_zero(a->out[p][k], 1);
            if (a->strict)
                mpfr_set_zero(a->moves[p][k], 1);
            a->bound[p][k] = f->whole_answers ? 0.0 : bound(whole, a->out[p][k], a->moves[p][k], bits[p]);
        }
    }
    return true;
}
