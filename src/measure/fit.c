/* Weighted least squares, and intervals by drawing rounds again (see fit.h). */
#include "measure/fit.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_multifit.h>
#include <gsl/gsl_statistics_double.h>

#include "model/random.h"

static const struct rl_interval unknown = {.value = NAN, .low = NAN, .high = NAN};

static struct rl_fit nothing(void)
{
    struct rl_fit fit = {.r2 = NAN, .residual = NAN, .worst = unknown, .refused_y = NAN};
    for (int k = 0; k < RL_FIT_TERMS_MAX; k++)
        fit.coefficient[k] = unknown;
    return fit;
}

/* Terms of one design, scaled so that each one's largest value is 1: pixels in millions beside a constant of 1 would cost digits. */
struct design {
    size_t n, p;
    gsl_matrix *x, *covariance;
    gsl_vector *weight, *y, *c;
    gsl_multifit_linear_workspace *work;
    double scale[RL_FIT_TERMS_MAX];
};

static void design_clear(struct design *d)
{
    gsl_matrix_free(d->x);
    gsl_matrix_free(d->covariance);
    gsl_vector_free(d->weight);
    gsl_vector_free(d->y);
    gsl_vector_free(d->c);
    gsl_multifit_linear_free(d->work);
}

/* false: no answer, nothing to clear. Everything is checked before GSL sees it, since its errors end the process. */
static bool design_make(struct design *d, const double *x, const double *weight, size_t n, int n_terms)
{
    if (n_terms < 1 || n_terms > RL_FIT_TERMS_MAX || n <= (size_t)n_terms)
        return false;
    *d = (struct design){.n = n, .p = (size_t)n_terms};
    for (size_t i = 0; i < n; i++) {
        if (weight && !(weight[i] > 0.0 && isfinite(weight[i])))
            return false;
        for (size_t k = 0; k < d->p; k++) {
            if (!isfinite(x[i * d->p + k]))
                return false;
            d->scale[k] = fmax(d->scale[k], fabs(x[i * d->p + k]));
        }
    }
    for (size_t k = 0; k < d->p; k++)
        if (d->scale[k] == 0.0)
            return false;
    d->x = gsl_matrix_alloc(n, d->p);
    d->covariance = gsl_matrix_alloc(d->p, d->p);
    d->weight = gsl_vector_alloc(n);
    d->y = gsl_vector_alloc(n);
    d->c = gsl_vector_alloc(d->p);
    d->work = gsl_multifit_linear_alloc(n, d->p);
    for (size_t i = 0; i < n; i++) {
        gsl_vector_set(d->weight, i, weight ? weight[i] : 1.0);
        for (size_t k = 0; k < d->p; k++)
            gsl_matrix_set(d->x, i, k, x[i * d->p + k] / d->scale[k]);
    }
    return true;
}

/* c and, unless NULL, the variances of unit weight; false if the terms are not independent. */
static bool solve(struct design *d, const double *y, double c[], double variance[])
{
    double chi_square;
    for (size_t i = 0; i < d->n; i++)
        gsl_vector_set(d->y, i, y[i]);
    gsl_multifit_wlinear(d->x, d->weight, d->y, d->c, d->covariance, &chi_square, d->work);
    if (gsl_multifit_linear_rank(100.0 * DBL_EPSILON, d->work) < d->p)
        return false;
    for (size_t k = 0; k < d->p; k++) {
        c[k] = gsl_vector_get(d->c, k) / d->scale[k];
        if (variance)
            variance[k] = gsl_matrix_get(d->covariance, k, k) / (d->scale[k] * d->scale[k]);
    }
    return true;
}

static double model(const double *x, const double c[], size_t p)
{
    double sum = 0.0;
    for (size_t k = 0; k < p; k++)
        sum += c[k] * x[k];
    return sum;
}

/* The largest |y - model|/|y|, and where. */
static double worst_residual(size_t *where, const double *x, const double *y, const double c[], size_t n,
                             size_t p)
{
    double worst = 0.0;
    *where = 0;
    for (size_t i = 0; i < n; i++) {
        double residual = fabs((y[i] - model(x + i * p, c, p)) / y[i]);
        if (residual > worst) {
            worst = residual;
            *where = i;
        }
    }
    return worst;
}

/* What the residuals say; returns the weighted sum of their squares. */
static double judge_fit(struct rl_fit *fit, const double *x, const double *y, const double *weight,
                        const double c[], size_t n, size_t p)
{
    double total = 0.0, mean = 0.0, left = 0.0, about = 0.0, relative = 0.0;
    for (size_t i = 0; i < n; i++) {
        total += weight ? weight[i] : 1.0;
        mean += (weight ? weight[i] : 1.0) * y[i];
    }
    mean /= total;
    for (size_t i = 0; i < n; i++) {
        double w = weight ? weight[i] : 1.0, residual = y[i] - model(x + i * p, c, p);
        left += w * residual * residual;
        about += w * (y[i] - mean) * (y[i] - mean);
        relative += residual * residual / (y[i] * y[i]);
    }
    fit->r2 = 1.0 - left / about;
    fit->residual = sqrt(relative / (double)(n - p));
    fit->worst.value = worst_residual(&fit->worst_point, x, y, c, n, p);
    return left;
}

struct rl_fit rl_fit_least_squares(const double *x, const double *y, const double *weight, size_t n,
                                   int n_terms, double level)
{
    struct rl_fit fit = nothing();
    struct design d;
    for (size_t i = 0; i < n; i++)
        if (!isfinite(y[i]))
            return fit;
    if (!(level > 0.0 && level < 1.0) || !design_make(&d, x, weight, n, n_terms))
        return fit;
    double c[RL_FIT_TERMS_MAX], variance[RL_FIT_TERMS_MAX];
    if (solve(&d, y, c, variance)) {
        double freedom = (double)(n - d.p);
        double unit = judge_fit(&fit, x, y, weight, c, n, d.p) / freedom;
        for (size_t k = 0; k < d.p; k++) {
            double half = rl_student_factor(level, freedom) * sqrt(unit * variance[k]);
            fit.coefficient[k] = (struct rl_interval){c[k], c[k] - half, c[k] + half};
        }
    }
    design_clear(&d);
    return fit;
}

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Points at work: room for one draw, and for what all draws gave. */
struct rounds {
    const struct rl_fit_point *point;
    size_t n, p, most; /* most rounds of a point */
    uint64_t seed;
    double *x, *y, *weight, *scratch; /* n x p, n, n, most */
    double *inverse;                  /* p x n: coefficients are this times y */
    double *drawn;                    /* (p + 1) x resamples: coefficients, worst residuals */
};

/* The median of a point's rounds, drawn again if draw > 0. */
static double median(struct rounds *r, size_t i, int draw)
{
    const struct rl_fit_point *p = &r->point[i];
    for (size_t k = 0; k < p->n; k++) {
        uint64_t index = ((uint64_t)draw * 65536 + (uint64_t)p->block) * r->most + k;
        size_t from = draw > 0 ? (size_t)(rl_random_uniform(r->seed, index) * (double)p->n) : k;
        r->scratch[k] = p->sample[from] - (p->minus ? p->minus[from] : 0.0);
    }
    qsort(r->scratch, p->n, sizeof *r->scratch, compare_doubles);
    return 0.5 * (r->scratch[(p->n - 1) / 2] + r->scratch[p->n / 2]);
}

static bool rounds_make(struct rounds *r, const struct rl_fit_point *point, size_t n, int n_terms,
                        int resamples, uint64_t seed)
{
    *r = (struct rounds){.point = point, .n = n, .p = (size_t)n_terms, .seed = seed};
    for (size_t i = 0; i < n; i++)
        r->most = point[i].n > r->most ? point[i].n : r->most;
    r->x = malloc(n * r->p * sizeof *r->x);
    r->y = malloc(n * sizeof *r->y);
    r->weight = malloc(n * sizeof *r->weight);
    r->scratch = malloc((r->most + 1) * sizeof *r->scratch);
    r->inverse = malloc(n * r->p * sizeof *r->inverse);
    r->drawn = malloc((r->p + 1) * (size_t)resamples * sizeof *r->drawn);
    return r->x && r->y && r->weight && r->scratch && r->inverse && r->drawn;
}

static void rounds_clear(struct rounds *r)
{
    free(r->x);
    free(r->y);
    free(r->weight);
    free(r->scratch);
    free(r->inverse);
    free(r->drawn);
}

/* The points' x, y and weights; what is wrong with the first that is not fit for it is said in `fit`. */
static bool take_points(struct rounds *r, struct rl_fit *fit)
{
    for (size_t i = 0; i < r->n; i++) {
        bool finite = r->point[i].n > 0;
        for (size_t k = 0; k < r->point[i].n && finite; k++)
            finite = isfinite(r->point[i].sample[k] - (r->point[i].minus ? r->point[i].minus[k] : 0.0));
        for (size_t k = 0; k < r->p && finite; k++)
            finite = isfinite(r->point[i].x[k]);
        memcpy(r->x + i * r->p, r->point[i].x, r->p * sizeof *r->x);
        r->y[i] = finite ? median(r, i, 0) : NAN;
        if (!(r->y[i] > 0.0)) {
            fit->refusal = finite ? RL_FIT_NOT_POSITIVE : RL_FIT_NOT_FINITE;
            fit->refused_point = i;
            fit->refused_y = r->y[i];
            return false;
        }
        r->weight[i] = 1.0 / (r->y[i] * r->y[i]);
    }
    return true;
}

static bool invert(struct rounds *r)
{
    struct design d;
    if (!design_make(&d, r->x, r->weight, r->n, (int)r->p))
        return false;
    double *unit = calloc(r->n, sizeof *unit), c[RL_FIT_TERMS_MAX] = {0.0};
    bool ok = unit != NULL;
    for (size_t i = 0; i < r->n && ok; i++) {
        unit[i] = 1.0;
        ok = solve(&d, unit, c, NULL);
        unit[i] = 0.0;
        for (size_t k = 0; k < r->p && ok; k++)
            r->inverse[k * r->n + i] = c[k];
    }
    free(unit);
    design_clear(&d);
    return ok;
}

static void coefficients(double c[], const struct rounds *r)
{
    for (size_t k = 0; k < r->p; k++) {
        c[k] = 0.0;
        for (size_t i = 0; i < r->n; i++)
            c[k] += r->inverse[k * r->n + i] * r->y[i];
    }
}

/* The middle `level` of what the draws gave, widened to hold the value: draws of the worst residual are all worse where the fit is close. */
static void middle(struct rl_interval *interval, double *drawn, int resamples, double level)
{
    qsort(drawn, (size_t)resamples, sizeof *drawn, compare_doubles);
    double low = gsl_stats_quantile_from_sorted_data(drawn, 1, (size_t)resamples, 0.5 - 0.5 * level);
    double high = gsl_stats_quantile_from_sorted_data(drawn, 1, (size_t)resamples, 0.5 + 0.5 * level);
    interval->low = fmin(low, interval->value);
    interval->high = fmax(high, interval->value);
}

static void fit_points(struct rl_fit *fit, struct rounds *r, int resamples, double level)
{
    double c[RL_FIT_TERMS_MAX];
    size_t where;
    coefficients(c, r);
    judge_fit(fit, r->x, r->y, r->weight, c, r->n, r->p);
    for (size_t k = 0; k < r->p; k++)
        fit->coefficient[k].value = c[k];
    for (int b = 0; b < resamples; b++) {
        for (size_t i = 0; i < r->n; i++)
            r->y[i] = median(r, i, b + 1);
        coefficients(c, r);
        for (size_t k = 0; k < r->p; k++)
            r->drawn[k * (size_t)resamples + (size_t)b] = c[k];
        r->drawn[r->p * (size_t)resamples + (size_t)b] = worst_residual(&where, r->x, r->y, c, r->n, r->p);
    }
    for (size_t k = 0; k <= r->p; k++)
        middle(k < r->p ? &fit->coefficient[k] : &fit->worst, r->drawn + k * (size_t)resamples, resamples,
               level);
}

struct rl_fit rl_fit_rounds(const struct rl_fit_point *point, size_t n, int n_terms, double level,
                            int resamples, uint64_t seed)
{
    struct rl_fit fit = nothing();
    fit.refusal = RL_FIT_INVALID;
    if (n_terms < 1 || n_terms > RL_FIT_TERMS_MAX || resamples < 1 || !(level > 0.0 && level < 1.0))
        return fit;
    fit.refusal = RL_FIT_FEW_POINTS;
    if (n <= (size_t)n_terms)
        return fit;
    struct rounds r;
    fit.refusal = RL_FIT_INVALID;
    if (rounds_make(&r, point, n, n_terms, resamples, seed) && take_points(&r, &fit)) {
        fit.refusal = invert(&r) ? RL_FIT_DONE : RL_FIT_DEPENDENT;
        if (fit.refusal == RL_FIT_DONE)
            fit_points(&fit, &r, resamples, level);
    }
    rounds_clear(&r);
    return fit;
}
