/* The ellipsoid distribution (see ellipsoid.h for the formulas and how they are kept accurate). */
#include "model/ellipsoid.h"

#include <math.h>

#include "model/vec3.h"

bool rl_ellipsoid_valid(double rr)
{
    return rr >= RL_RR_MIN && rr <= RL_RR_MAX;
}

struct rl_ellipsoid rl_ellipsoid_make(double rr)
{
    struct rl_ellipsoid e = {.rr = rr};
    e.k = sqrt(fabs(rr - 1.0) * (rr + 1.0));
    if (e.k == 0.0) {
        e.norm = 0.5;
        return e;
    }
    /* atanh(h) = log((1 + h)/R) because (1 - h)(1 + h) = R^2; atanh itself loses digits once h rounds to 1. */
    if (rr >= 1.0)
        e.half_range = atan(e.k);
    else
        e.half_range = rr > 0.5 ? atanh(e.k) : log((1.0 + e.k) / rr);
    e.norm = e.k / (2.0 * e.half_range);
    return e;
}

double rl_ellipsoid_pdf_sincos(const struct rl_ellipsoid *e, double sin_delta, double cos_delta)
{
    double rs = e->rr * sin_delta;
    return e->norm * cos_delta / (cos_delta * cos_delta + rs * rs);
}

double rl_ellipsoid_pdf(const struct rl_ellipsoid *e, double delta)
{
    return rl_ellipsoid_pdf_sincos(e, sin(delta), cos(delta));
}

/* U for sin_delta <= 0, from s = |sin delta| and t = 1 - s. */
static double lower_cdf(const struct rl_ellipsoid *e, double s, double t)
{
    if (e->k == 0.0)
        return 0.5 * t;
    double kk = e->k * e->k;
    if (e->rr >= 1.0)
        return atan(e->k * t / (1.0 + kk * s)) / (2.0 * e->half_range);
    /* Nothing cancels here, and U(0) is 1/2 to the bit, as U(-delta) = 1 - U(delta) has it. */
    if (s <= 0.5)
        return 0.5 - 0.5 * atanh(e->k * s) / e->half_range;
    /* atanh(k) - atanh(k s) = atanh(k t/d), d = 1 - k^2 s = t + R^2 s; atanh(x/d) = log1p(2x/(d - x))/2, where
     * d - x = t (1 - k) + R^2 s and 1 - k = R^2/(1 + k): sums of positive terms only. */
    double r2 = e->rr * e->rr;
    double below = t * r2 / (1.0 + e->k) + r2 * s;
    double x = e->k * t;
    return 0.5 * log1p(2.0 * x / below) / (2.0 * e->half_range);
}

double rl_ellipsoid_cdf_sincos(const struct rl_ellipsoid *e, double sin_delta, double cos_delta)
{
    double s = fabs(sin_delta);
    double t = s > 0.5 ? cos_delta * cos_delta / (1.0 + s) : 1.0 - s;
    double lower = lower_cdf(e, s, t);
    return sin_delta <= 0.0 ? lower : 1.0 - lower;
}

double rl_ellipsoid_cdf(const struct rl_ellipsoid *e, double delta)
{
    return rl_ellipsoid_cdf_sincos(e, sin(delta), cos(delta));
}

/* sin(x)/x or sinh(x)/x, for x >= 0. Below 1e-8 it is 1 to the last digit, and x may be 0 or have lost digits as a denormal number. */
static double over_argument(double function, double x)
{
    return x > 1e-8 ? function / x : 1.0;
}

/* s = sin|delta|, and t/u for t = 1 - s, of the tail probability u in [0, 1/2].
 *
 * With A = atan k, x = 2 u A and y = A - x: s = tan(y)/k and, as cos A = 1/R and sin A = k/R,
 *
 *     s = R sin(y)/(k d),  t = R^2 sin(x)/(k d),  d = R cos(y) = cos x + k sin x
 *
 * For R < 1, A = atanh k and the same in hyperbolic functions, with cosh A = 1/R. Nothing cancels, so s and t are both
 * accurate relative to themselves. t is proportional to sin(x)/k = (sin(x)/x) u/norm: its quotient by u has no part that underflows. */
static void upper_sine(const struct rl_ellipsoid *e, double u, double *s, double *t_over_u)
{
    double middle = 1.0 - 2.0 * u;
    if (e->k == 0.0) {
        *s = middle;
        *t_over_u = 2.0;
        return;
    }
    double x = 2.0 * u * e->half_range;
    double y = middle * e->half_range;
    if (e->rr >= 1.0) {
        double d = cos(x) + e->k * sin(x);
        *s = e->rr * sin(y) / (e->k * d);
        *t_over_u = e->rr * e->rr * over_argument(sin(x), x) / (e->norm * d);
    } else {
        *s = sinh(y) / (e->k * cosh(y));
        *t_over_u = e->rr * over_argument(sinh(x), x) / (e->norm * cosh(y));
    }
}

struct rl_delta rl_ellipsoid_inverse(const struct rl_ellipsoid *e, double u)
{
    u = fmin(1.0, fmax(0.0, u));
    double tail = u <= 0.5 ? u : 1.0 - u;
    double s = 0.0;
    double t_over_u = 0.0;
    upper_sine(e, tail, &s, &t_over_u);
    double t = t_over_u * tail;
    /* The smaller of the two is the more accurate one in absolute terms; the other follows from it, so that
     * sin^2 + cos^2 = 1. */
    if (s > 0.5)
        s = 1.0 - t;
    else
        t = 1.0 - s;
    double c = sqrt(t * (2.0 - t));
    /* As a denormal number t would have lost digits; its root has not. */
    if (tail < 0x1p-900)
        c = 0x1p-200 * sqrt(2.0 * t_over_u * (tail * 0x1p400));
    /* atan2 keeps the digits at both ends, where asin or acos alone would lose half of them. */
    double delta = atan2(s, c);
    double sign = u <= 0.5 ? -1.0 : 1.0;
    return (struct rl_delta){.delta = sign * delta, .sin_delta = sign * s, .cos_delta = c};
}
