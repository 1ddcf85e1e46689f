/* Where the integral along lines breaks as theta runs over [0, pi) (see breaks.h). */
#include "reference/breaks.h"

double rl_line_azimuth(double x, double y)
{
    double theta = atan2(y, x);
    if (theta < 0.0)
        theta += RL_PI;
    return theta < RL_PI ? theta : 0.0;
}

/* Whether the circle of the line at theta, known to touch the edge's great circle, touches it between the edge's ends, or so near to one
 * that rounding may have it either way. */
static bool touches(const struct rl_lines *lines, const struct rl_edge *edge, double theta)
{
    static const double slack = 1e-7;
    double x, y;
    sincos(theta, &y, &x);
    double from = -y * edge->from_x + x * edge->from_y, to = -y * edge->to_x + x * edge->to_y;
    double v_b = -y * lines->v_x + x * lines->v_y;
    /* Between the ends b.p has a maximum r or a minimum -r; it is -v_b that it must equal. */
    return (from > -slack && to < slack && v_b <= slack) || (from < slack && to > -slack && v_b >= -slack);
}

/* d^2 = 0: a c^2 + 2 h s c + b s^2 = 0 for t = (c, s), with a = 1 - m_y^2 - v_y^2, h = m_x m_y + v_x v_y, b = 1 - m_x^2 - v_x^2. The
 * discriminant h^2 - a b is -(m.M)(m.V), M being the mirror direction: where the great circle passes M or -V, through which all lines
 * go, both roots are one. The line's two crossings change places there, and a derivative jumps; passing near to it, quickly. */
size_t rl_touch_breaks(struct rl_break *breaks, const struct rl_lines *lines, rl_vec3 m)
{
    static const double one = 1e-10, near = -1e-2;
    double a = 1.0 - m.y * m.y - lines->v_y * lines->v_y;
    double half = m.x * m.y + lines->v_x * lines->v_y;
    double b = 1.0 - m.x * m.x - lines->v_x * lines->v_x;
    double across = m.x * lines->v_x + m.y * lines->v_y, along = m.z * lines->v_n;
    double discriminant = (across - along) * (across + along);
    size_t n = 0;
    if (discriminant < one && discriminant > near) {
        double x = fabs(a) > fabs(b) ? -half : b, y = fabs(a) > fabs(b) ? a : -half;
        breaks[n++] = (struct rl_break){.theta = rl_line_azimuth(x, y), .kind = RL_BREAK_KINK};
    }
    if (!(discriminant > 0.0))
        return n;
    double w = -(half + copysign(sqrt(discriminant), half));
    const double x[2] = {w, b}, y[2] = {a, w};
    for (int i = 0; i < 2; i++)
        if (x[i] != 0.0 || y[i] != 0.0)
            breaks[n++] = (struct rl_break){.theta = rl_line_azimuth(x[i], y[i]), .kind = RL_BREAK_ROOT};
    return n;
}

static size_t edge_touches(struct rl_break *breaks, const struct rl_lines *lines, const struct rl_edge *edge)
{
    size_t n = rl_touch_breaks(breaks, lines, edge->m);
    for (size_t i = 0; i < n; i++)
        if (breaks[i].kind == RL_BREAK_ROOT && touches(lines, edge, breaks[i].theta))
            breaks[i].kind = RL_BREAK_TOUCH;
    return n;
}

/* The arc of an edge: L(alpha) = cos(alpha) start + sin(alpha) across, from alpha = 0 to where L is (cos, sin) = end. */
struct arc {
    rl_vec3 start, across;
    struct rl_angle end;
};

static struct arc arc_of(const struct rl_edge *edge)
{
    struct arc arc = {.start = edge->start, .across = v3_cross(edge->m, edge->start)};
    arc.end = (struct rl_angle){v3_dot(edge->end, arc.across), v3_dot(edge->end, arc.start)};
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
    return (struct rl_break){
        .theta = rl_line_azimuth(lines->v_x + L.x, lines->v_y + L.y),
        .kind = RL_BREAK_KINK,
    };
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

/* Along an arc L(alpha): how far shadowing is above 1, and its derivative. */
struct shadowing {
    const struct rl_lines *lines;
    const struct arc *arc;
};

static double shadowing_at(const struct shadowing *f, struct rl_angle alpha)
{
    rl_vec3 L = arc_point(f->arc, alpha.c, alpha.s);
    return margin(f->lines, L, L.z);
}

static double shadowing_slope(const struct shadowing *f, struct rl_angle alpha)
{
    const struct rl_lines *lines = f->lines;
    rl_vec3 L = arc_point(f->arc, alpha.c, alpha.s), D = arc_point(f->arc, -alpha.s, alpha.c);
    return 4.0 * D.z * (lines->v_n + 2.0 * L.z) -
           2.0 * (lines->v_x * D.x + lines->v_y * D.y + lines->v_n * D.z);
}

/* The zero of g between a and b, where its signs differ: regula falsi in the Illinois form, an end that stays having its value
 * halved. Steps are taken along the chord, which is the arc for all that matters once it is short. */
static struct rl_angle zero_between(double (*g)(const struct shadowing *, struct rl_angle),
                                    const struct shadowing *f, struct rl_angle a, struct rl_angle b)
{
    enum { STEPS = 60 };
    double g_a = g(f, a), g_b = g(f, b);
    for (int step = 0; step < STEPS && g_b != 0.0; step++) {
        double share = g_b / (g_b - g_a), s = b.s + share * (a.s - b.s), c = b.c + share * (a.c - b.c);
        double scale = 1.0 / sqrt(s * s + c * c);
        struct rl_angle next = {s * scale, c * scale};
        double g_next = g(f, next), moved = fabs(next.s - b.s) + fabs(next.c - b.c);
        if ((g_next > 0.0) != (g_b > 0.0)) {
            a = b;
            g_a = g_b;
        } else {
            g_a *= 0.5;
        }
        b = next;
        g_b = g_next;
        if (moved < 1e-15)
            break;
    }
    return b;
}

/* A place where shadowing reaches 1 counts where it is the lesser of the two. */
static size_t shadowing_break(struct rl_break *breaks, const struct shadowing *f, struct rl_angle a,
                              struct rl_angle b)
{
    struct rl_angle alpha = zero_between(shadowing_at, f, a, b);
    rl_vec3 L = arc_point(f->arc, alpha.c, alpha.s);
    if (!(L.z > 0.0 && L.z < f->lines->v_n))
        return 0;
    breaks[0] = break_at(f->lines, L);
    return 1;
}

/* Where shadowing reaches 1 on the arc: a trigonometric polynomial of degree two in alpha, so up to four places. Between samples
 * it has one zero where its sign changes, and two where it does not but an extremum reaches over. */
static size_t shadowing_breaks(struct rl_break *breaks, const struct rl_lines *lines, const struct arc *arc)
{
    enum { SAMPLES = 8, MOST = 4 };
    const struct shadowing f = {lines, arc};
    double step = atan2(arc->end.s, arc->end.c) / SAMPLES, sin_step, cos_step;
    sincos(step, &sin_step, &cos_step);
    struct rl_angle from = {0.0, 1.0};
    double f_from = shadowing_at(&f, from), slope_from = shadowing_slope(&f, from);
    size_t n = 0;
    for (int i = 1; i <= SAMPLES && n < MOST; i++) {
        struct rl_angle to = {from.s * cos_step + from.c * sin_step, from.c * cos_step - from.s * sin_step};
        double f_to = shadowing_at(&f, to), slope_to = shadowing_slope(&f, to);
        if ((f_from > 0.0) != (f_to > 0.0)) {
            n += shadowing_break(breaks + n, &f, from, to);
        } else if ((slope_from > 0.0) != (slope_to > 0.0) && (slope_to > 0.0) == (f_to > 0.0)) {
            struct rl_angle extreme = zero_between(shadowing_slope, &f, from, to);
            if ((shadowing_at(&f, extreme) > 0.0) != (f_to > 0.0)) {
                n += shadowing_break(breaks + n, &f, from, extreme);
                n += shadowing_break(breaks + n, &f, extreme, to);
            }
        }
        from = to;
        f_from = f_to;
        slope_from = slope_to;
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
    breaks[0].theta = rl_line_azimuth(cos(azimuth + aside), sin(azimuth + aside));
    breaks[1].theta = rl_line_azimuth(cos(azimuth - aside), sin(azimuth - aside));
    breaks[0].kind = breaks[1].kind = RL_BREAK_KINK;
    return 2;
}

static bool always(const struct rl_lines *lines, rl_vec3 L)
{
    (void)lines, (void)L;
    return true;
}

/* Without attenuation lights shine from below the horizon too, where a crossing may leave the line at one end, delta = pi/2, and come
 * back at the other. Both are at N.L = -N.V. D is 0 there, so that the second derivative jumps. */
static size_t end_breaks(struct rl_break *breaks, const struct rl_lines *lines, const struct rl_edge *edge)
{
    static const double near = 1e-7;
    struct arc arc = arc_of(edge);
    size_t n = plane_breaks(breaks, lines, &arc, v3(0.0, 0.0, 1.0), -lines->v_n, always);
    /* A crossing at -V, where all lines go, does so where V has no part along the line. */
    rl_vec3 V = v3(lines->v_x, lines->v_y, lines->v_n);
    if (fabs(v3_dot(edge->m, V)) < near && v3_dot(v3_add(edge->start, edge->end), V) < near)
        breaks[n++] = (struct rl_break){
            .theta = rl_line_azimuth(-lines->v_y, lines->v_x),
            .kind = RL_BREAK_KINK,
        };
    return n;
}

static size_t kink_breaks(struct rl_break *breaks, const struct rl_lines *lines, const struct rl_edge *edge)
{
    struct arc arc = arc_of(edge);
    double v_n = lines->v_n;
    size_t n = plane_breaks(breaks, lines, &arc, v3(0.0, 0.0, 1.0), v_n, masked);
    n += plane_breaks(breaks + n, lines, &arc, v3(-2.0 * lines->v_x, -2.0 * lines->v_y, 2.0 * v_n),
                      2.0 - 4.0 * v_n * v_n, masking_rules);
    return n + shadowing_breaks(breaks + n, lines, &arc);
}

size_t rl_breaks_of_edge(struct rl_break *breaks, const struct rl_lines *lines, const struct rl_edge *edge)
{
    size_t n = 0;
    if (edge->q_x != 0.0 || edge->q_y != 0.0)
        breaks[n++] = (struct rl_break){
            .theta = rl_line_azimuth(edge->q_x, edge->q_y),
            .kind = RL_BREAK_KINK,
        };
    n += edge_touches(breaks + n, lines, edge);
    return n + (lines->attenuation ? kink_breaks : end_breaks)(breaks + n, lines, edge);
}

size_t rl_breaks_most(const struct rl_light_set *set)
{
    return 2 + RL_BREAKS_OF_EDGE * rl_lines_edges_most(set) + rl_overlap_breaks_most(set);
}

size_t rl_breaks_find(struct rl_break *breaks, bool *complete, const struct rl_lines *lines)
{
    size_t n = lines->attenuation ? zone_breaks(breaks, lines) : 0;
    for (size_t i = 0; i < lines->n_polygons; i++) {
        const struct rl_edge *edge = &lines->edge[lines->polygon[i].first];
        for (size_t j = 0; j < lines->polygon[i].n; j++)
            n += rl_breaks_of_edge(breaks + n, lines, &edge[j]);
    }
    *complete = true;
    return lines->set->n_polygons > 1 ? n + rl_overlap_breaks(breaks + n, complete, lines) : n;
}
