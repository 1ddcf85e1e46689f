/* One line's own axes t, b, N, and where it crosses an edge: the closed forms of lines.h, for the lights' edges (line.c) and for those
 * of what hides them (occlusion.c). batch_kernel.h has them once more, for several lines side by side. */
#ifndef RL_REFERENCE_AXES_H
#define RL_REFERENCE_AXES_H

#include <float.h>
#include <math.h>

#include "reference/lines.h"

struct rl_axes {
    double cos_theta, sin_theta;
    double v_t, v_b, v_n; /* V */
};

static inline struct rl_axes rl_axes_make(const struct rl_lines *lines, double cos_theta, double sin_theta)
{
    return (struct rl_axes){.cos_theta = cos_theta,
                            .sin_theta = sin_theta,
                            .v_t = cos_theta * lines->v_x + sin_theta * lines->v_y,
                            .v_b = cos_theta * lines->v_y - sin_theta * lines->v_x,
                            .v_n = lines->v_n};
}

/* fmax of what is no NaN, which is one instruction. */
static inline double rl_most(double a, double b)
{
    return a > b ? a : b;
}

/* A direction L of the line; its third component is L.b = -v_b. */
struct rl_on_line {
    double t, n;
};

/* d^2 = r^2 - v_b^2 = (v_t^2 + v_N^2) - m_b^2, for V and m are unit vectors: the difference of what is smaller, so that where the circles nearly
 * touch it keeps the digits that V and m have. */
static inline double rl_axes_dd(const struct rl_axes *x, double rr, double m_b)
{
    double v_bb = x->v_b * x->v_b;
    return v_bb > 0.5 ? x->v_t * x->v_t + x->v_n * x->v_n - m_b * m_b : rr - v_bb;
}

/* Where the line's circle crosses the great circle of unit normal m: upwards (b.L growing along m x L) or downwards. */
static inline struct rl_on_line rl_axes_cross(const struct rl_axes *x, rl_vec3 m, bool up)
{
    double m_t = x->cos_theta * m.x + x->sin_theta * m.y, m_b = x->cos_theta * m.y - x->sin_theta * m.x;
    double rr = rl_most(DBL_MIN, m_t * m_t + m.z * m.z);
    double d = sqrt(rl_most(0.0, rl_axes_dd(x, rr, m_b)));
    d = up ? d : -d;
    double along = x->v_b * m_b;
    return (struct rl_on_line){(along * m_t + d * m.z) / rr, (along * m.z - d * m_t) / rr};
}

/* How the line crosses an edge; the side of each end decides, and so crossings of a loop pair up. */
enum rl_meeting { RL_MEETS_NOT, RL_MEETS_UPWARDS, RL_MEETS_DOWNWARDS, RL_MEETS_TWICE };

static inline enum rl_meeting rl_axes_meet(const struct rl_axes *x, const struct rl_edge *e)
{
    double c = x->cos_theta, s = x->sin_theta;
    bool side = c * e->q_y - s * e->q_x >= 0.0, next = c * e->next_y - s * e->next_x >= 0.0;
    if (side != next)
        return next ? RL_MEETS_UPWARDS : RL_MEETS_DOWNWARDS;
    /* Both ends on one side: the arc may reach over to the other in between, where b.p has its extremum. */
    double from = c * e->from_y - s * e->from_x, to = c * e->to_y - s * e->to_x;
    double m_t = c * e->m.x + s * e->m.y, m_b = c * e->m.y - s * e->m.x;
    bool over = side ? from < 0.0 && to > 0.0 && x->v_b > 0.0 : from > 0.0 && to < 0.0 && x->v_b < 0.0;
    return over && rl_axes_dd(x, m_t * m_t + e->m.z * e->m.z, m_b) > 0.0 ? RL_MEETS_TWICE : RL_MEETS_NOT;
}

/* The microfacet normal that mirrors L to the eye: along V + L; near L = -V that vanishes, but it is also perpendicular to V - L. */
static inline struct rl_angle rl_axes_normal(const struct rl_axes *x, double l_t, double l_n)
{
    double h_t = x->v_t + l_t, h_n = x->v_n + l_n, hh = h_t * h_t + h_n * h_n;
    if (hh < 0.25 * (x->v_t * x->v_t + x->v_n * x->v_n)) {
        h_t = l_n - x->v_n;
        h_n = x->v_t - l_t;
        hh = h_t * h_t + h_n * h_n;
    }
    double scale = (h_n < 0.0 ? -1.0 : 1.0) / sqrt(rl_most(DBL_MIN, hh));
    return (struct rl_angle){h_t * scale, h_n * scale};
}

/* The direction that a microfacet normal mirrors the eye to. */
static inline struct rl_on_line rl_axes_mirror(const struct rl_axes *x, struct rl_angle normal)
{
    double twice = 2.0 * (x->v_t * normal.s + x->v_n * normal.c);
    return (struct rl_on_line){twice * normal.s - x->v_t, twice * normal.c - x->v_n};
}

/* Halfway between two angles; of -pi/2 and pi/2: 0. */
static inline struct rl_angle rl_angle_middle(struct rl_angle a, struct rl_angle b)
{
    double s = a.s + b.s, c = a.c + b.c, length = sqrt(s * s + c * c);
    return length > 0.0 ? (struct rl_angle){s / length, c / length} : (struct rl_angle){0.0, 1.0};
}

#endif
