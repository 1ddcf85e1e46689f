/* Closed forms of the inner integral (see inner.h for the zones).
 *
 * Everything is built from four antiderivatives in delta, with s = sin(delta), c = cos(delta):
 *
 *     A(R)  = int dx / (sqrt(1+x^2) (1 + R^2 x^2))     atan(k s)/k;  R < 1: asinh(h s / w)/h,  h^2 = 1 - R^2
 *     W     = int -x dx / (the same)                   asinh(k c / w)/(k R);  R < 1: atan(h c / R)/(h R)
 *     J     = int d delta / cos(delta - phi')          asinh(tan(delta - phi')),  tan(phi') = l tan(phi)
 *     A(l)  = A with l for R
 *
 * where w^2 = c^2 + R^2 s^2. Writing the logarithms as asinh of such quotients leaves no cancellation for any R. Then
 *
 *     int D masking   = norm (2 cos(phi)/q) [cos(phi) R^2 A(R) + sin^2(phi) l^2 J/root + sin(phi) R^2 l W]
 *     int D cos^2     = norm [R^2 A(R) - l^2 A(l)] / (R^2 - l^2)
 *
 * q = l^2 sin^2(phi) + R^2 cos^2(phi), root^2 = cos^2(phi) + l^2 sin^2(phi).
 */
#include "reference/inner.h"

#include <math.h>

#include "model/vec3.h"
#include "reference/rule.h"

/* Unit vector along (s, c); (0, 0) stands for delta = 0. */
static struct rl_angle angle(double s, double c)
{
    double r = sqrt(s * s + c * c);
    if (!(r > 0.0))
        return (struct rl_angle){0.0, 1.0};
    return (struct rl_angle){s / r, c / r};
}

struct rl_angle rl_inner_unstretch(struct rl_angle normal, double stretch)
{
    return angle(normal.s, stretch * normal.c);
}

static double width(const struct rl_ellipsoid *e, struct rl_angle d)
{
    return sqrt(d.c * d.c + e->rr * e->rr * d.s * d.s);
}

/* A(R) from a to b. */
static double arctangent(const struct rl_ellipsoid *e, struct rl_angle a, struct rl_angle b)
{
    double k = e->k;
    if (k == 0.0)
        return b.s - a.s;
    if (e->rr > 1.0) /* the difference of two arctangents as one: exact for stretches of any smallness */
        return atan2(k * (b.s - a.s), 1.0 + k * k * a.s * b.s) / k;
    return (asinh(k * b.s / width(e, b)) - asinh(k * a.s / width(e, a))) / k;
}

/* W from a to b. */
static double cosine_part(const struct rl_ellipsoid *e, struct rl_angle a, struct rl_angle b)
{
    double k = e->k;
    if (k == 0.0)
        return b.c - a.c;
    if (e->rr > 1.0)
        return (asinh(k * b.c / width(e, b)) - asinh(k * a.c / width(e, a))) / (k * e->rr);
    return (atan(k * b.c / e->rr) - atan(k * a.c / e->rr)) / (k * e->rr);
}

/* J at d. */
static double gudermann(const struct rl_inner_line *line, double stretch, struct rl_angle d)
{
    double s = stretch * line->sin_phi, c = line->cos_phi;
    return asinh((d.s * c - d.c * s) / (d.c * c + d.s * s));
}

double rl_inner_mass(const struct rl_ellipsoid *e, struct rl_angle a, struct rl_angle b)
{
    return e->norm * arctangent(e, a, b);
}

static double masking(const struct rl_inner_line *line, const struct rl_ellipsoid *e, double stretch,
                      struct rl_angle a, struct rl_angle b)
{
    double s = line->sin_phi, c = line->cos_phi, rr = e->rr * e->rr;
    double sum = c * rr * arctangent(e, a, b) + s * rr * stretch * cosine_part(e, a, b);
    if (stretch > 0.0)
        sum += s * s * stretch * stretch / line->root *
               (gudermann(line, stretch, b) - gudermann(line, stretch, a));
    return e->norm * (2.0 * c / line->q) * sum;
}

/* int (1 - s^2)/(1 + k^2 s^2) ds as a power series: l = 1 and R so near 1 that the closed form cancels. */
static double cos_squared_series(const struct rl_ellipsoid *e, double s)
{
    double kk = (e->rr - 1.0) * (e->rr + 1.0), ss = s * s, power = s, sum = 0.0;
    for (int n = 0; n < 12; n++) {
        sum += power * (1.0 / (2 * n + 1) - ss / (2 * n + 3));
        power *= -kk * ss;
    }
    return sum;
}

/* int cos^2(delta') dU by quadrature over U: R near l < 1, where the closed form cancels. The integrand is entire in U's
 * hyperbolic angle; pieces of at most 2 in that angle keep 15 nodes far below rounding. */
static double cos_squared_sampled(const struct rl_ellipsoid *e, double stretch, struct rl_angle a,
                                  struct rl_angle b)
{
    double from = rl_ellipsoid_cdf_sincos(e, a.s, a.c), to = rl_ellipsoid_cdf_sincos(e, b.s, b.c);
    int pieces = 1 + (int)((to - from) * e->half_range);
    double step = (to - from) / pieces, sum = 0.0;
    for (int i = 0; i < pieces; i++)
        for (int j = 0; j < RL_RULE_NODES; j++) {
            struct rl_delta d = rl_ellipsoid_inverse(e, from + (i + 0.5 + 0.5 * rl_rule_node(j)) * step);
            double c = d.cos_delta, ls = stretch * d.sin_delta;
            sum += 0.5 * step * rl_rule_weight(j) * c * c / (c * c + ls * ls);
        }
    return sum;
}

/* int D cos^2(delta'). */
static double cos_squared(const struct rl_ellipsoid *e, double stretch, struct rl_angle a, struct rl_angle b)
{
    double rr = e->rr * e->rr, ll = stretch * stretch;
    double gap = (e->rr - stretch) * (e->rr + stretch);
    if (stretch == 1.0 && fabs(gap) < 0.03)
        return e->norm * (cos_squared_series(e, b.s) - cos_squared_series(e, a.s));
    if (fabs(gap) < 0.01 * rr)
        return cos_squared_sampled(e, stretch, a, b);
    double own = b.s - a.s; /* A(l) */
    double h = sqrt((1.0 - stretch) * (1.0 + stretch));
    if (h > 0.0 && stretch > 0.0)
        own = (asinh(h * b.s / sqrt(b.c * b.c + ll * b.s * b.s)) -
               asinh(h * a.s / sqrt(a.c * a.c + ll * a.s * a.s))) /
              h;
    return e->norm * (rr * arctangent(e, a, b) - ll * own) / gap;
}

void rl_inner_line_make(struct rl_inner_line *line, const struct rl_ellipsoid *e, double stretch, double v_t,
                        double v_n)
{
    double rho = sqrt(v_t * v_t + v_n * v_n);
    double s = v_t / rho, c = v_n / rho;
    double phi = atan2(s, c), quarter = 0.5 * RL_PI;
    line->sin_phi = s;
    line->cos_phi = c;
    line->q = stretch * stretch * s * s + e->rr * e->rr * c * c;
    line->root = sqrt(c * c + stretch * stretch * s * s);

    /* Where G reaches 1, and where masking and shadowing swap: that is at delta = phi, so both zones end there. */
    struct rl_angle low = {sin((phi - quarter) / 3.0), cos((phi - quarter) / 3.0)};
    struct rl_angle high = {sin((phi + quarter) / 3.0), cos((phi + quarter) / 3.0)};
    struct rl_angle low_swap = low, high_swap = high;
    if (-s > c) {
        low_swap = (struct rl_angle){s, c};
        low = (struct rl_angle){-c, -s};
    } else if (s > c) {
        high = (struct rl_angle){c, s};
        high_swap = (struct rl_angle){s, c};
    }
    const struct rl_angle bound[RL_ZONES + 1] = {
        angle(s - 1.0, c), low_swap, low, high, high_swap, angle(s + 1.0, c),
    };
    for (int i = 0; i <= RL_ZONES; i++)
        line->bound[i] = stretch == 1.0 ? bound[i] : rl_inner_unstretch(bound[i], stretch);
}

double rl_inner_attenuated(const struct rl_inner_line *line, const struct rl_ellipsoid *e, double stretch,
                           struct rl_angle a, struct rl_angle b)
{
    double sum = 0.0;
    for (int zone = 0; zone < RL_ZONES; zone++) {
        struct rl_angle from = line->bound[zone].s > a.s ? line->bound[zone] : a;
        struct rl_angle to = line->bound[zone + 1].s < b.s ? line->bound[zone + 1] : b;
        if (!(from.s < to.s))
            continue;
        if (zone == 2)
            sum += rl_inner_mass(e, from, to);
        else if (zone == 1 || zone == 3)
            sum += masking(line, e, stretch, from, to);
        else
            sum += 4.0 * cos_squared(e, stretch, from, to) - masking(line, e, stretch, from, to);
    }
    return sum;
}
