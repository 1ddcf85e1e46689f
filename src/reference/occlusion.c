/* Cuts lines at silhouettes and asks rays (see occlusion.h). */
#include "reference/occlusion.h"

#include <math.h>
#include <stdlib.h>

#include "reference/axes.h"

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
    rl_vec3 V = v3_normalize(rl_frame_components(&o->frame, surface->V));
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
    rl_vec3 p = rl_frame_components(&o->frame, a), along = rl_frame_components(&o->frame, v3_sub(b, a));
    rl_vec3 m = v3_normalize(v3_cross(p, along)), start = v3_normalize(p);
    /* Seen end-on it borders nothing. */
    if (!(v3_dot(m, m) > 0.0))
        return true;
    rl_vec3 end = v3_normalize(rl_frame_components(&o->frame, b));
    o->edge[o->n_edges] = (struct rl_shadow_edge){rl_edge_between(o->v_x, o->v_y, m, start, end), doubt};
    o->n_edges++;
    return true;
}

/* The microfacet normal where the line crosses the great circle. */
static struct rl_angle cross(const struct rl_axes *x, rl_vec3 m, bool up)
{
    struct rl_on_line L = rl_axes_cross(x, m, up);
    return rl_axes_normal(x, L.t, L.n);
}

/* The crossings of a line with one edge: 0 to 2. */
static int cross_edge(struct rl_angle at[2], const struct rl_axes *x, const struct rl_edge *e)
{
    enum rl_meeting meeting = rl_axes_meet(x, e);
    if (meeting == RL_MEETS_NOT)
        return 0;
    at[0] = cross(x, e->m, meeting == RL_MEETS_UPWARDS);
    if (meeting != RL_MEETS_TWICE)
        return 1;
    at[1] = cross(x, e->m, true);
    return 2;
}

/* The cuts of the line between two angles, in order. */
static size_t find_cuts(struct rl_occlusion *o, const struct rl_axes *x, struct rl_angle from,
                        struct rl_angle to)
{
    size_t n = 0;
    for (size_t i = 0; i < o->n_edges; i++) {
        struct rl_angle at[2];
        int crossings = cross_edge(at, x, &o->edge[i].arc);
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
static rl_vec3 middle(const struct rl_axes *x, struct rl_angle from, struct rl_angle to)
{
    struct rl_on_line L = rl_axes_mirror(x, rl_angle_middle(from, to));
    return v3(x->cos_theta * L.t + x->sin_theta * x->v_b, x->sin_theta * L.t - x->cos_theta * x->v_b, L.n);
}

/* Whether direction L lies too near to the edge for a ray to know its side. */
static bool too_near(const struct rl_cut *cut, rl_vec3 L)
{
    return cut && fabs(v3_dot(cut->edge->arc.m, L)) < cut->edge->doubt;
}

/* One ray for the part between two cuts (NULL: an end of the stretch). */
static void decide(struct rl_part *part, struct rl_occlusion *o, const struct rl_lines *lines,
                   const struct rl_axes *x, const struct rl_cut *before, const struct rl_cut *after)
{
    rl_vec3 L = middle(x, part->from, part->to);
    double nearness = rl_lines_nearness(lines, L);
    rl_vec3 world = v3_madd(v3_scale(L.x, o->frame.T), L.y, o->frame.B);
    /* On the very edge of the light there may be no polygon to be found. */
    bool found = nearness > 0.0;
    part->doubtful = !found || too_near(before, L) || too_near(after, L);
    part->visible = !found || !o->ray(o->user, v3_madd(world, L.z, o->frame.N), 1.0 / nearness);
    o->rays += found;
    o->hidden += !part->visible;
}

size_t rl_occlusion_split(struct rl_occlusion *o, const struct rl_lines *lines, double cos_theta,
                          double sin_theta, struct rl_angle from, struct rl_angle to)
{
    const struct rl_axes x = rl_axes_make(lines, cos_theta, sin_theta);
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
