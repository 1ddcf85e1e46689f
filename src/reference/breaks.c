/* Where the integral along lines breaks as theta runs over [0, pi) (see breaks.h). */
#include "reference/breaks.h"

/* The azimuth in [0, pi) of the undirected line along (x, y). */
static double line_azimuth(double x, double y)
{
    double theta = atan2(y, x);
    if (theta < 0.0)
        theta += RL_PI;
    return theta < RL_PI ? theta : 0.0;
}

/* Whether the circle of the line along (x, y), known to touch the edge's great circle, touches it between the edge's ends. */
static bool touches(const struct rl_lines *lines, const struct rl_edge *edge, double x, double y)
{
    double from = -y * edge->from_x + x * edge->from_y, to = -y * edge->to_x + x * edge->to_y;
    double v_b = -y * lines->v_x + x * lines->v_y;
    /* Between the ends b.p has a maximum r or a minimum -r; it is -v_b that it must equal. */
    return (from > 0.0 && to < 0.0 && v_b <= 0.0) || (from < 0.0 && to > 0.0 && v_b >= 0.0);
}

/* d^2 = 0: c^2 (1 - m_y^2 - v_y^2) + 2 s c (m_x m_y + v_x v_y) + s^2 (1 - m_x^2 - v_x^2) = 0 for t = (c, s). */
static size_t touch_breaks(struct rl_break *breaks, const struct rl_lines *lines, const struct rl_edge *edge)
{
    double a = 1.0 - edge->m.y * edge->m.y - lines->v_y * lines->v_y;
    double half = edge->m.x * edge->m.y + lines->v_x * lines->v_y;
    double b = 1.0 - edge->m.x * edge->m.x - lines->v_x * lines->v_x;
    double discriminant = half * half - a * b;
    if (!(discriminant >= 0.0))
        return 0;
    double w = -(half + copysign(sqrt(discriminant), half));
    const double x[2] = {w, b}, y[2] = {a, w};
    size_t n = 0;
    for (int i = 0; i < 2; i++)
        if ((x[i] != 0.0 || y[i] != 0.0) && touches(lines, edge, x[i], y[i]))
            breaks[n++] = (struct rl_break){.theta = line_azimuth(x[i], y[i]), .touch = true};
    return n;
}

/* The arc of an edge: L(alpha) = cos(alpha) start + sin(alpha) across, from alpha = 0 to where L is (cos, sin) = end. */
struct arc {
    rl_vec3 start, across;
    struct rl_angle end;
};

static struct arc arc_of(const struct rl_edge *edge, const struct rl_edge *next)
{
    struct arc arc = {.start = edge->start, .across = v3_cross(edge->m, edge->start)};
    arc.end = (struct rl_angle){v3_dot(next->start, arc.across), v3_dot(next->start, arc.start)};
    return arc;
}

static bool within(const struct arc *arc, double c, double s)
{
    return s > 0.0 && arc->end.s * c - arc->end.c * s > 0.0;
}

static rl_vec3 arc_point(const struct arc *arc, double c, double s)
{
    return v3_madd(v3_scale(c, arc->start), s, arc->across);
}

static struct rl_break break_at(const struct rl_lines *lines, rl_vec3 L)
{
    return (struct rl_break){.theta = line_azimuth(lines->v_x + L.x, lines->v_y + L.y)};
}

/* 4 V.H N.H (N.V or N.L) - 2 (V.H)^2 in terms of L: G = 1 where this is positive for the lesser of N.V and N.L. */
static double margin(const struct rl_lines *lines, rl_vec3 L, double least)
{
    return 4.0 * least * (lines->v_n + L.z) - 2.0 -
           2.0 * (lines->v_x * L.x + lines->v_y * L.y + lines->v_n * L.z);
}

/* Where the arc meets the plane w.L = h, kept where `keep` says that G has a kink there. */
static size_t plane_breaks(struct rl_break *breaks, const struct rl_lines *lines, const struct arc *arc,
                           rl_vec3 w, double h, bool (*keep)(const struct rl_lines *lines, rl_vec3 L))
{
    double a = v3_dot(w, arc->start), b = v3_dot(w, arc->across), rr = a * a + b * b;
    if (!(rr > h * h))
        return 0;
    double d = sqrt(rr - h * h);
    size_t n = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        double c = (h * a - sign * d * b) / rr, s = (h * b + sign * d * a) / rr;
        rl_vec3 L = arc_point(arc, c, s);
        if (within(arc, c, s) && keep(lines, L))
            breaks[n++] = break_at(lines, L);
    }
    return n;
}

static bool masked(const struct rl_lines *lines, rl_vec3 L)
{
    return margin(lines, L, lines->v_n) < 0.0;
}
static bool masking_rules(const struct rl_lines *lines, rl_vec3 L)
{
    return L.z > lines->v_n;
}

/* Where shadowing reaches 1 on the arc: of degree two in L, so up to four places; found between samples, exact by bisection and
 * the secant. A pair between two samples is missed: there G only just dips, and the adaptive rule sees to it. */
static size_t shadowing_breaks(struct rl_break *breaks, const struct rl_lines *lines, const struct arc *arc)
{
    enum { SAMPLES = 8, MOST = 4, STEPS = 60 };
    double whole = atan2(arc->end.s, arc->end.c), from = 0.0;
    rl_vec3 L = arc->start;
    double f_from = margin(lines, L, L.z);
    size_t n = 0;
    for (int i = 1; i <= SAMPLES && n < MOST; i++) {
        double to = whole * i / SAMPLES;
        L = arc_point(arc, cos(to), sin(to));
        double f_to = margin(lines, L, L.z), next = to, f_next = f_to;
        if ((f_from > 0.0) != (f_to > 0.0)) {
            /* Regula falsi in the Illinois form: an end that stays has its value halved. */
            double a = from, f_a = f_from, b = to, f_b = f_to;
            for (int step = 0; step < STEPS && fabs(b - a) > 1e-15; step++) {
                double x = b - f_b * (b - a) / (f_b - f_a);
                L = arc_point(arc, cos(x), sin(x));
                double f = margin(lines, L, L.z);
                if ((f > 0.0) != (f_b > 0.0)) {
                    a = b;
                    f_a = f_b;
                } else {
                    f_a *= 0.5;
                }
                b = x;
                f_b = f;
                if (f == 0.0)
                    break;
            }
            if (L.z > 0.0 && L.z < lines->v_n)
                breaks[n++] = break_at(lines, L);
        }
        from = next;
        f_from = f_next;
    }
    return n;
}

/* |v_t| = v_N: a line's masking zone opens. */
static size_t zone_breaks(struct rl_break *breaks, const struct rl_lines *lines)
{
    double v = sqrt(lines->v_x * lines->v_x + lines->v_y * lines->v_y);
    if (!(v > lines->v_n))
        return 0;
    double azimuth = atan2(lines->v_y, lines->v_x), aside = acos(lines->v_n / v);
    breaks[0].theta = line_azimuth(cos(azimuth + aside), sin(azimuth + aside));
    breaks[1].theta = line_azimuth(cos(azimuth - aside), sin(azimuth - aside));
    breaks[0].touch = breaks[1].touch = false;
    return 2;
}

static size_t kink_breaks(struct rl_break *breaks, const struct rl_lines *lines, const struct rl_edge *edge,
                          const struct rl_edge *next)
{
    struct arc arc = arc_of(edge, next);
    double v_n = lines->v_n;
    size_t n = plane_breaks(breaks, lines, &arc, v3(0.0, 0.0, 1.0), v_n, masked);
    n += plane_breaks(breaks + n, lines, &arc, v3(-2.0 * lines->v_x, -2.0 * lines->v_y, 2.0 * v_n),
                      2.0 - 4.0 * v_n * v_n, masking_rules);
    return n + shadowing_breaks(breaks + n, lines, &arc);
}

size_t rl_breaks_most(const struct rl_light_set *set)
{
    return 2 + 11 * rl_lines_edges_most(set);
}

size_t rl_breaks_find(struct rl_break *breaks, const struct rl_lines *lines)
{
    size_t n = lines->attenuation ? zone_breaks(breaks, lines) : 0;
    for (size_t i = 0; i < lines->n_polygons; i++) {
        const struct rl_edge *edge = &lines->edge[lines->polygon[i].first];
        for (size_t j = 0; j < lines->polygon[i].n; j++) {
            if (edge[j].q_x != 0.0 || edge[j].q_y != 0.0)
                breaks[n++] = (struct rl_break){.theta = line_azimuth(edge[j].q_x, edge[j].q_y)};
            n += touch_breaks(breaks + n, lines, &edge[j]);
            if (lines->attenuation)
                n += kink_breaks(breaks + n, lines, &edge[j], &edge[j + 1 < lines->polygon[i].n ? j + 1 : 0]);
        }
    }
    return n;
}
