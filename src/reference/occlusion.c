/* Cuts lines at silhouettes and asks rays (see occlusion.h). */
#include "reference/occlusion.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static rl_vec3 to_frame(const struct rl_frame *f, rl_vec3 a)
{
    return v3(v3_dot(f->T, a), v3_dot(f->B, a), v3_dot(f->N, a));
}

/* The memory in its new size; what it was, and *room false, if there is none. */
static void *grow(void *memory, size_t bytes, bool *room)
{
    void *more = realloc(memory, bytes);
    if (more)
        return more;
    *room = false;
    return memory;
}

/* Room for one edge more. An edge meets a line at most twice, and n cuts make n + 1 parts. */
static bool reserve(struct rl_occlusion *o)
{
    if (o->n_edges < o->capacity)
        return true;
    size_t capacity = o->capacity > 0 ? 2 * o->capacity : 64;
    bool room = true;
    o->edge = grow(o->edge, capacity * sizeof *o->edge, &room);
    o->turn = grow(o->turn, 2 * capacity * sizeof *o->turn, &room);
    o->cut = grow(o->cut, 2 * capacity * sizeof *o->cut, &room);
    o->part = grow(o->part, (2 * capacity + 1) * sizeof *o->part, &room);
    o->capacity = room ? capacity : o->capacity;
    return room;
}

/* The same frame as rl_lines_make has. */
bool rl_occlusion_begin(struct rl_occlusion *o, const struct rl_surface *surface)
{
    o->frame = rl_frame_make(RL_FRAME_ORTHONORMAL, v3_normalize(surface->N));
    rl_vec3 V = v3_normalize(to_frame(&o->frame, surface->V));
    o->v_x = V.x;
    o->v_y = V.y;
    o->n_edges = 0;
    return reserve(o);
}

void rl_occlusion_clear(struct rl_occlusion *o)
{
    free(o->edge);
    free(o->cut);
    free(o->part);
    free(o->turn);
    *o = (struct rl_occlusion){0};
}

bool rl_occlusion_add(struct rl_occlusion *o, rl_vec3 a, rl_vec3 b, double doubt)
{
    if (!reserve(o))
        return false;
    rl_vec3 p = to_frame(&o->frame, a), along = to_frame(&o->frame, v3_sub(b, a));
    rl_vec3 m = v3_normalize(v3_cross(p, along)), start = v3_normalize(p);
    /* Seen end-on it borders nothing. */
    if (!(v3_dot(m, m) > 0.0))
        return true;
    rl_vec3 end = v3_normalize(to_frame(&o->frame, b)), from = v3_cross(m, start), to = v3_cross(m, end);
    o->edge[o->n_edges] = (struct rl_shadow_edge){
        .arc = {.m = m,
                .start = start,
                .end = end,
                .next_x = o->v_x + end.x,
                .next_y = o->v_y + end.y,
                .q_x = o->v_x + start.x,
                .q_y = o->v_y + start.y,
                .from_x = from.x,
                .from_y = from.y,
                .to_x = to.x,
                .to_y = to.y},
        .doubt = doubt,
    };
    o->n_edges++;
    return true;
}

/* A line's own axes: t = (c, s), b = (-s, c). */
struct axes {
    double c, s, v_t, v_b, v_n;
};

/* The microfacet normal of direction L: along V + L, and perpendicular to V - L where that nearly vanishes. */
static struct rl_angle normal_of(const struct axes *x, double l_t, double l_n)
{
    double h_t = x->v_t + l_t, h_n = x->v_n + l_n, hh = h_t * h_t + h_n * h_n;
    if (hh < 0.25 * (x->v_t * x->v_t + x->v_n * x->v_n)) {
        h_t = l_n - x->v_n;
        h_n = x->v_t - l_t;
        hh = h_t * h_t + h_n * h_n;
    }
    double scale = (h_n < 0.0 ? -1.0 : 1.0) / sqrt(fmax(DBL_MIN, hh));
    return (struct rl_angle){h_t * scale, h_n * scale};
}

/* Where the line crosses the edge's great circle, upwards or downwards (see lines.h). */
static struct rl_angle cross(const struct axes *x, rl_vec3 m, bool up)
{
    double m_t = x->c * m.x + x->s * m.y, m_b = x->c * m.y - x->s * m.x;
    double rr = fmax(DBL_MIN, m_t * m_t + m.z * m.z);
    double d = sqrt(fmax(0.0, rr - x->v_b * x->v_b));
    d = up ? d : -d;
    double along = x->v_b * m_b;
    return normal_of(x, (along * m_t + d * m.z) / rr, (along * m.z - d * m_t) / rr);
}

/* The crossings of a line with one edge: 0 to 2. */
static int cross_edge(struct rl_angle at[2], const struct axes *x, const struct rl_shadow_edge *e)
{
    bool side_a = x->c * e->arc.q_y - x->s * e->arc.q_x >= 0.0,
         side_b = x->c * e->arc.next_y - x->s * e->arc.next_x >= 0.0;
    if (side_a != side_b) {
        at[0] = cross(x, e->arc.m, side_b);
        return 1;
    }
    double from = x->c * e->arc.from_y - x->s * e->arc.from_x, to = x->c * e->arc.to_y - x->s * e->arc.to_x;
    double m_t = x->c * e->arc.m.x + x->s * e->arc.m.y;
    bool reaches = side_a ? from < 0.0 && to > 0.0 && x->v_b > 0.0 : from > 0.0 && to < 0.0 && x->v_b < 0.0;
    if (!reaches || !(m_t * m_t + e->arc.m.z * e->arc.m.z > x->v_b * x->v_b))
        return 0;
    at[0] = cross(x, e->arc.m, false);
    at[1] = cross(x, e->arc.m, true);
    return 2;
}

/* The cuts of the line between two angles, in order. */
static size_t find_cuts(struct rl_occlusion *o, const struct axes *x, struct rl_angle from,
                        struct rl_angle to)
{
    size_t n = 0;
    for (size_t i = 0; i < o->n_edges; i++) {
        struct rl_angle at[2];
        int crossings = cross_edge(at, x, &o->edge[i]);
        for (int j = 0; j < crossings; j++) {
            if (!(at[j].s > from.s && at[j].s < to.s))
                continue;
            size_t place = n++;
            for (; place > 0 && o->cut[place - 1].at.s > at[j].s; place--)
                o->cut[place] = o->cut[place - 1];
            o->cut[place] = (struct rl_cut){at[j], &o->edge[i]};
        }
    }
    return n;
}

/* The direction in the middle of a part, in the frame. */
static rl_vec3 middle(const struct axes *x, struct rl_angle from, struct rl_angle to)
{
    double s = from.s + to.s, c = from.c + to.c, length = sqrt(s * s + c * c);
    s = length > 0.0 ? s / length : 0.0;
    c = length > 0.0 ? c / length : 1.0;
    double twice = 2.0 * (x->v_t * s + x->v_n * c);
    double l_t = twice * s - x->v_t, l_n = twice * c - x->v_n;
    return v3(x->c * l_t + x->s * x->v_b, x->s * l_t - x->c * x->v_b, l_n);
}

/* Whether direction L lies too near to the edge for a ray to know its side. */
static bool too_near(const struct rl_cut *cut, rl_vec3 L)
{
    return cut && fabs(v3_dot(cut->edge->arc.m, L)) < cut->edge->doubt;
}

/* One ray for the part between two cuts (NULL: an end of the stretch). */
static void decide(struct rl_part *part, struct rl_occlusion *o, const struct rl_lines *lines,
                   const struct axes *x, const struct rl_cut *before, const struct rl_cut *after)
{
    rl_vec3 L = middle(x, part->from, part->to);
    double nearness = rl_lines_nearness(lines, L);
    rl_vec3 world = v3_madd(v3_scale(L.x, o->frame.T), L.y, o->frame.B);
    /* On the very edge of the light there may be no polygon to be found. */
    bool found = nearness > 0.0;
    part->doubtful = !found || too_near(before, L) || too_near(after, L);
    part->visible = !found || !o->ray(o->user, v3_madd(world, L.z, o->frame.N), 1.0 / nearness);
    o->rays += found;
}

size_t rl_occlusion_split(struct rl_occlusion *o, const struct rl_lines *lines, double cos_theta,
                          double sin_theta, struct rl_angle from, struct rl_angle to)
{
    const struct axes x = {cos_theta, sin_theta, cos_theta * lines->v_x + sin_theta * lines->v_y,
                           cos_theta * lines->v_y - sin_theta * lines->v_x, lines->v_n};
    size_t n_cuts = find_cuts(o, &x, from, to), n = 0;
    for (size_t i = 0; i <= n_cuts; i++) {
        struct rl_part part = {.from = i > 0 ? o->cut[i - 1].at : from, .to = i < n_cuts ? o->cut[i].at : to};
        decide(&part, o, lines, &x, i > 0 ? &o->cut[i - 1] : NULL, i < n_cuts ? &o->cut[i] : NULL);
        struct rl_part *last = n > 0 ? &o->part[n - 1] : NULL;
        if (last && last->visible == part.visible && last->doubtful == part.doubtful)
            last->to = part.to;
        else
            o->part[n++] = part;
    }
    return n;
}

static void add_break(struct rl_break *breaks, size_t *n, double theta, enum rl_break_kind kind)
{
    if (*n < RL_OCCLUSION_BREAKS)
        breaks[(*n)++] = (struct rl_break){.theta = theta, .kind = kind};
}

static int by_theta(const void *a, const void *b)
{
    double x = ((const struct rl_turn *)a)->theta, y = ((const struct rl_turn *)b)->theta;
    return (x > y) - (x < y);
}

/* Where silhouettes begin and end as theta turns. Along a silhouette one edge takes over from another at a corner, to the last bit
 * of its azimuth; where both lie on the same side of it, the silhouette turns back. */
static void add_turns(struct rl_break *breaks, size_t *n_breaks, const struct rl_occlusion *o)
{
    size_t n = 0;
    for (size_t i = 0; i < o->n_edges; i++) {
        const struct rl_shadow_edge *e = &o->edge[i];
        double a = rl_line_azimuth(e->arc.q_x, e->arc.q_y), b = rl_line_azimuth(e->arc.next_x, e->arc.next_y);
        /* theta is a circle; an edge goes the short way. */
        int forward = (b > a) == (fabs(b - a) < 0.5 * RL_PI) ? 1 : -1;
        o->turn[n++] = (struct rl_turn){a, forward};
        o->turn[n++] = (struct rl_turn){b, -forward};
    }
    qsort(o->turn, n, sizeof *o->turn, by_theta);
    for (size_t i = 0, next; i < n; i = next) {
        int change = 0;
        for (next = i; next < n && o->turn[next].theta == o->turn[i].theta; next++)
            change += o->turn[next].change;
        if (change != 0)
            add_break(breaks, n_breaks, o->turn[i].theta, RL_BREAK_TOUCH);
    }
}

/* Where two arcs cross. */
static void add_meeting(struct rl_break *breaks, size_t *n, const struct rl_occlusion *o,
                        const struct rl_shadow_edge *e, rl_vec3 m, rl_vec3 a, rl_vec3 b)
{
    double e_a = v3_dot(e->arc.m, a), e_b = v3_dot(e->arc.m, b), m_a = v3_dot(m, e->arc.start),
           m_b = v3_dot(m, e->arc.end);
    if (!(e_a * e_b < 0.0) || !(m_a * m_b < 0.0))
        return;
    rl_vec3 p = v3_normalize(v3_cross(e->arc.m, m));
    if (v3_dot(p, v3_add(a, b)) < 0.0)
        p = v3_scale(-1.0, p);
    if (v3_dot(p, v3_add(e->arc.start, e->arc.end)) > 0.0)
        add_break(breaks, n, rl_line_azimuth(o->v_x + p.x, o->v_y + p.y), RL_BREAK_KINK);
}

size_t rl_occlusion_breaks(struct rl_break *breaks, const struct rl_occlusion *o,
                           const struct rl_lines *lines)
{
    bool few = o->n_edges <= RL_OCCLUSION_FEW;
    size_t n = 0;
    for (size_t i = 0; i < o->n_edges && few; i++) {
        const struct rl_shadow_edge *e = &o->edge[i];
        n += rl_breaks_of_edge(breaks + n, lines, &e->arc);
        add_break(breaks, &n, rl_line_azimuth(e->arc.next_x, e->arc.next_y), RL_BREAK_KINK);
    }
    if (!few)
        add_turns(breaks, &n, o);
    for (size_t p = 0; p < lines->n_polygons; p++) {
        const struct rl_seen_polygon *polygon = &lines->polygon[p];
        const struct rl_edge *edge = &lines->edge[polygon->first];
        for (size_t i = 0; i < polygon->n; i++)
            for (size_t j = 0; j < o->n_edges; j++)
                add_meeting(breaks, &n, o, &o->edge[j], edge[i].m, edge[i].start, edge[i].end);
    }
    for (size_t i = 0; i < o->n_edges && few; i++)
        for (size_t j = 0; j < i; j++)
            add_meeting(breaks, &n, o, &o->edge[i], o->edge[j].arc.m, o->edge[j].arc.start,
                        o->edge[j].arc.end);
    return n;
}
