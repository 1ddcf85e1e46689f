/* The batch of lines of batch.h for LANES of them side by side; axes.h and inner.c are the same thing for one, with the formulas and
 * their sources. Included by one file per instruction set, which defines vd, vm and what that set calls its functions.
 *
 * It is a second copy and stays one: where one line branches, lanes compute both sides and choose; their functions are SLEEF's, and not
 * equal to libm's in the last place; and the line alone is what marked lanes are done again by, and what tests/reference/test_batch.c holds
 * these against. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "reference/batch.h"

static inline vd all(double x)
{
    return x - (vd){0};
}
static inline vd choose(vm mask, vd yes, vd no)
{
    return (vd)((mask & (vm)yes) | (~mask & (vm)no));
}
static inline vd least(vd a, vd b)
{
    return choose(a < b, a, b);
}
static inline vd most(vd a, vd b)
{
    return choose(a > b, a, b);
}
static inline vd magnitude(vd x)
{
    return (vd)((vm)x & ~(vm)all(-0.0));
}
static inline vd root(vd x)
{
    return VECTOR_SQRT(x);
}
/* asinh to an absolute error of about 1e-16. */
static inline vd asinh_absolute(vd x)
{
    vd a = magnitude(x), y = VECTOR_LOG(a + root(1.0 + a * a));
    return choose(x < 0.0, -y, y);
}

/* Angles by sine and cosine, as rl_angle. */
struct angles {
    vd s, c;
};

struct places {
    struct angles at;
    vm full;
};

/* LANES lines' own axes, and their zones once they are needed. */
struct line_group {
    vd cos_theta, sin_theta, v_t, v_b;
    struct angles phi, bound[RL_ZONES + 1];
    const struct rl_lines *lines;
    bool has_zones;
};

static inline struct angles unit(vd s, vd c)
{
    vd scale = 1.0 / root(most(s * s + c * c, all(DBL_MIN)));
    return (struct angles){s * scale, c * scale};
}

/* rl_axes_normal, and what place() of line.c makes of it. */
static inline struct places place(const struct line_group *g, vd l_t, vd l_n)
{
    double v_n = g->lines->v_n;
    vd h_t = g->v_t + l_t, h_n = v_n + l_n, hh = h_t * h_t + h_n * h_n;
    struct places p;
    p.full = 4.0 * h_n * least(all(v_n), l_n) >= hh;
    if (!g->lines->attenuation)
        p.full = p.full | ~p.full;
    vm behind = hh < 0.25 * (g->v_t * g->v_t + v_n * v_n), down = h_n < 0.0;
    vm back = g->v_t < l_t;
    vd across_t = choose(back, v_n - l_n, l_n - v_n), across_n = choose(back, l_t - g->v_t, g->v_t - l_t);
    p.at = unit(choose(behind, across_t, choose(down, -h_t, h_t)),
                choose(behind, across_n, choose(down, -h_n, h_n)));
    return p;
}

/* rl_axes_cross. */
static inline struct places limit_place(const struct line_group *g, const struct rl_limit *limit)
{
    if (limit->way == 0.0) {
        struct places end = {.at = {all(limit->m.z), all(0.0)}};
        end.full = (vm){0};
        if (!g->lines->attenuation)
            end.full = ~end.full;
        return end;
    }
    rl_vec3 m = limit->m;
    vd m_t = g->cos_theta * m.x + g->sin_theta * m.y, m_b = g->cos_theta * m.y - g->sin_theta * m.x;
    vd rr = most(m_t * m_t + m.z * m.z, all(DBL_MIN));
    vd v_bb = g->v_b * g->v_b, v_n = all(g->lines->v_n);
    vd dd = choose(v_bb > 0.5, g->v_t * g->v_t + v_n * v_n - m_b * m_b, rr - v_bb);
    vd d = limit->way * root(most(dd, all(0.0)));
    vd along = g->v_b * m_b, scale = 1.0 / rr;
    return place(g, (along * m_t + d * m.z) * scale, (along * m.z - d * m_t) * scale);
}

static inline vd width(const struct rl_ellipsoid *e, struct angles d)
{
    return root(d.c * d.c + e->rr * e->rr * d.s * d.s);
}

/* A(R) of inner.c. */
static inline vd arctangent(const struct rl_ellipsoid *e, struct angles a, struct angles b)
{
    double k = e->k;
    if (k == 0.0)
        return b.s - a.s;
    return VECTOR(Sleef_atan2)(k * (b.s - a.s), 1.0 + k * k * a.s * b.s) / k;
}

/* W of inner.c. Near R = 1 the quotients by k need asinh accurate to its last digit. */
static inline vd cosine_part(const struct rl_ellipsoid *e, struct angles a, struct angles b)
{
    double k = e->k;
    if (k == 0.0)
        return b.c - a.c;
    vd x = k * b.c / width(e, b), y = k * a.c / width(e, a);
    vd difference = asinh_absolute(x) - asinh_absolute(y);
    if (k < 0.25)
        difference = (vd)VECTOR(Sleef_asinh)(x) - (vd)VECTOR(Sleef_asinh)(y);
    return difference / (k * e->rr);
}

/* J of inner.c. */
static inline vd gudermann(const struct line_group *g, struct angles d)
{
    return asinh_absolute((d.s * g->phi.c - d.c * g->phi.s) / (d.c * g->phi.c + d.s * g->phi.s));
}

static inline vd masking(const struct line_group *g, struct angles a, struct angles b)
{
    const struct rl_ellipsoid *e = g->lines->e;
    double rr = e->rr * e->rr;
    vd s = g->phi.s, c = g->phi.c;
    vd sum = c * rr * arctangent(e, a, b) + s * rr * cosine_part(e, a, b) +
             s * s * (gudermann(g, b) - gudermann(g, a));
    return e->norm * (2.0 * c / (s * s + rr * c * c)) * sum;
}

static inline vd cos_squared(const struct rl_ellipsoid *e, struct angles a, struct angles b)
{
    double rr = e->rr * e->rr, gap = (e->rr - 1.0) * (e->rr + 1.0);
    if (gap >= 0.03)
        return e->norm * (rr * arctangent(e, a, b) - (b.s - a.s)) / gap;
    vd sum = all(0.0), power_a = a.s, power_b = b.s, aa = a.s * a.s, bb = b.s * b.s;
    for (int n = 0; n < 12; n++) {
        sum += power_b * (1.0 / (2 * n + 1) - bb / (2 * n + 3)) -
               power_a * (1.0 / (2 * n + 1) - aa / (2 * n + 3));
        power_a *= -gap * aa;
        power_b *= -gap * bb;
    }
    return e->norm * sum;
}

/* rl_inner_line_make. */
static void make_zones(struct line_group *g)
{
    double v_n = g->lines->v_n;
    struct angles phi = unit(g->v_t, all(v_n));
    vd angle = VECTOR(Sleef_atan2)(phi.s, phi.c);
    VECTOR_PAIR low_pair = VECTOR(Sleef_sincos)((angle - 0.5 * RL_PI) / 3.0);
    VECTOR_PAIR high_pair = VECTOR(Sleef_sincos)((angle + 0.5 * RL_PI) / 3.0);
    struct angles low = {low_pair.x, low_pair.y}, high = {high_pair.x, high_pair.y};
    vm masked_low = -phi.s > phi.c, masked_high = phi.s > phi.c;
    g->phi = phi;
    g->bound[0] = unit(phi.s - 1.0, phi.c);
    g->bound[1] = (struct angles){choose(masked_low, phi.s, low.s), choose(masked_low, phi.c, low.c)};
    g->bound[2] = (struct angles){choose(masked_low, -phi.c, low.s), choose(masked_low, -phi.s, low.c)};
    g->bound[3] = (struct angles){choose(masked_high, phi.c, high.s), choose(masked_high, phi.s, high.c)};
    g->bound[4] = (struct angles){choose(masked_high, phi.s, high.s), choose(masked_high, phi.c, high.c)};
    g->bound[5] = unit(phi.s + 1.0, phi.c);
    g->has_zones = true;
}

/* rl_inner_attenuated. */
static vd attenuated(struct line_group *g, struct angles a, struct angles b)
{
    const struct rl_ellipsoid *e = g->lines->e;
    vd sum = all(0.0);
    if (!g->has_zones)
        make_zones(g);
    for (int zone = 0; zone < RL_ZONES; zone++) {
        const struct angles *low = &g->bound[zone], *high = &g->bound[zone + 1];
        vm above = low->s > a.s, below = high->s < b.s;
        struct angles from = {choose(above, low->s, a.s), choose(above, low->c, a.c)};
        struct angles to = {choose(below, high->s, b.s), choose(below, high->c, b.c)};
        vm some = from.s < to.s;
        if (VECTOR_BITS(some) == 0)
            continue;
        vd part;
        if (zone == 2)
            part = e->norm * arctangent(e, from, to);
        else if (zone == 1 || zone == 3)
            part = masking(g, from, to);
        else
            part = 4.0 * cos_squared(e, from, to) - masking(g, from, to);
        sum += choose(some, part, all(0.0));
    }
    return sum;
}

/* What rounding may have done: rounding() of line.c. */
static inline vd rounding(const struct rl_ellipsoid *e, struct angles d)
{
    vd density = e->norm * d.c / (d.c * d.c + e->rr * e->rr * d.s * d.s);
    return least(8.0 * DBL_EPSILON * density, all(1.0));
}

static inline vd inner_integral(struct line_group *g, const struct places *a, const struct places *b)
{
    vm full = a->full & b->full;
    if (VECTOR_BITS(~full) == 0)
        return g->lines->e->norm * arctangent(g->lines->e, a->at, b->at);
    return attenuated(g, a->at, b->at);
}

static inline vm doubtful(const struct rl_limit *limit, const struct places *p)
{
    return limit->way == 0.0 ? (vm){0} : p->at.c < 1e-7;
}

/* Lines i = 0 .. LANES - 1; returns a bit for each that is out of order. */
static unsigned integrate_group(double *value[4], const struct rl_lines *lines,
                                const struct rl_stretch *stretch, size_t n_stretches, const double *theta)
{
    const struct rl_light_set *set = lines->set;
    struct line_group g = {.lines = lines};
    vd at, sum[4] = {{0}}, before = all(-1.0);
    vm disorder = (vm){0};
    memcpy(&at, theta, sizeof at);
    VECTOR_PAIR pair = VECTOR(Sleef_sincos)(at);
    g.sin_theta = pair.x;
    g.cos_theta = pair.y;
    g.v_t = g.cos_theta * lines->v_x + g.sin_theta * lines->v_y;
    g.v_b = g.cos_theta * lines->v_y - g.sin_theta * lines->v_x;
    for (size_t i = 0; i < n_stretches; i++) {
        const double *radiance = set->radiance[stretch[i].radiance];
        struct places from = limit_place(&g, &stretch[i].from), to = limit_place(&g, &stretch[i].to);
        vd inner = inner_integral(&g, &from, &to);
        for (int c = 0; c < (set->grey ? 1 : 3); c++)
            sum[c] += inner * radiance[c];
        sum[3] += set->brightest * (rounding(lines->e, from.at) + rounding(lines->e, to.at));
        disorder = disorder | (from.at.s < before - 1e-12) | (to.at.s < from.at.s - 1e-12);
        if (!lines
                 ->attenuation) /* at an end of the line, rounding may take a crossing for one at the other */
            disorder = disorder | doubtful(&stretch[i].from, &from) | doubtful(&stretch[i].to, &to);
        before = to.at.s;
    }
    for (int c = 0; c < 4; c++)
        memcpy(value[c], &sum[c], sizeof sum[c]);
    return VECTOR_BITS(disorder);
}

unsigned BATCH_FUNCTION(double value[4][RL_RULE_BATCH], const struct rl_lines *lines,
                        const struct rl_stretch *stretch, size_t n_stretches,
                        const double theta[RL_RULE_BATCH])
{
    unsigned again = 0;
    for (int i = 0; i < RL_RULE_BATCH; i += LANES) {
        double *part[4] = {&value[0][i], &value[1][i], &value[2][i], &value[3][i]};
        again |= integrate_group(part, lines, stretch, n_stretches, theta + i) << i;
    }
    return again;
}
