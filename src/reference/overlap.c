/* Breaks that pairs of polygons make (see breaks.h): where, seen from P, their edges cross, and where one passes through the other. */
#include "reference/breaks.h"

/* With more edges than this (a mesh), looking at every pair costs more than the integral, and the adaptive rule is left to find
 * these breaks. */
enum { EDGES_MOST = 512, MORE = 64 };

size_t rl_overlap_breaks_most(const struct rl_light_set *set)
{
    return set->n_polygons > 1 ? 4 * rl_lines_edges_most(set) + MORE : 0;
}

/* An edge as an arc between two unit directions, less than half a turn. */
struct arc {
    rl_vec3 m, from, to;
};

static struct arc arc_of(const struct rl_lines *lines, const struct rl_seen_polygon *polygon, size_t i)
{
    const struct rl_edge *edge = &lines->edge[polygon->first + i];
    return (struct arc){edge->m, edge->start, edge->end};
}

static bool parted(rl_vec3 m, const struct arc *arc)
{
    return (v3_dot(m, arc->from) > 0.0) != (v3_dot(m, arc->to) > 0.0);
}

/* Of the two directions where the great circle m crosses that of the arc, the one on the arc. */
static rl_vec3 meeting(rl_vec3 m, const struct arc *arc)
{
    rl_vec3 L = v3_normalize(v3_cross(m, arc->m));
    return v3_dot(L, v3_add(arc->from, arc->to)) < 0.0 ? v3_scale(-1.0, L) : L;
}

static void add(struct rl_break *breaks, size_t *n, const struct rl_lines *lines, rl_vec3 L)
{
    if (*n < rl_overlap_breaks_most(lines->set))
        breaks[(*n)++] = (struct rl_break){
            .theta = rl_line_azimuth(lines->v_x + L.x, lines->v_y + L.y),
            .kind = RL_BREAK_KINK,
        };
}

static bool same(rl_vec3 a, rl_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool joined(const struct arc *a, const struct arc *b)
{
    return same(a->from, b->from) || same(a->from, b->to) || same(a->to, b->from) || same(a->to, b->to);
}

/* a and b may be the same: several polygons in one. */
static void edges_cross(struct rl_break *breaks, size_t *n, const struct rl_lines *lines,
                        const struct rl_seen_polygon *a, const struct rl_seen_polygon *b)
{
    for (size_t i = 0; i < a->n; i++) {
        struct arc one = arc_of(lines, a, i);
        for (size_t j = a == b ? i + 1 : 0; j < b->n; j++) {
            struct arc other = arc_of(lines, b, j);
            if (!parted(one.m, &other) || !parted(other.m, &one) || joined(&one, &other))
                continue;
            rl_vec3 L = meeting(one.m, &other);
            if (v3_dot(L, v3_add(one.from, one.to)) > 0.0)
                add(breaks, n, lines, L);
        }
    }
}

/* Whether the great circle m has vertices of the polygon on both sides. */
static bool divides(const struct rl_lines *lines, rl_vec3 m, const struct rl_seen_polygon *polygon)
{
    for (size_t i = 0; i < polygon->n; i++) {
        struct arc arc = arc_of(lines, polygon, i);
        if (parted(m, &arc))
            return true;
    }
    return false;
}

/* On the great circle where both polygons are equally near they change places: where it meets an edge, and where a line touches it. */
static void planes_cross(struct rl_break *breaks, size_t *n, const struct rl_lines *lines,
                         const struct rl_seen_polygon *a, const struct rl_seen_polygon *b)
{
    const struct rl_seen_polygon *const both[] = {a, b};
    rl_vec3 m = v3_normalize(v3_sub(a->nearness, b->nearness));
    if (a->radiance == b->radiance || !divides(lines, m, a) || !divides(lines, m, b))
        return;
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < both[k]->n; i++) {
            struct arc arc = arc_of(lines, both[k], i);
            if (parted(m, &arc))
                add(breaks, n, lines, meeting(m, &arc));
        }
    struct rl_break touch[2];
    size_t n_touch = rl_touch_breaks(touch, lines, m);
    for (size_t i = 0; i < n_touch && *n < rl_overlap_breaks_most(lines->set); i++)
        breaks[(*n)++] = (struct rl_break){.theta = touch[i].theta, .kind = RL_BREAK_TOUCH};
}

size_t rl_overlap_breaks(struct rl_break *breaks, const struct rl_lines *lines)
{
    size_t n = 0;
    if (lines->n_edges > EDGES_MOST || lines->set->n_polygons < 2)
        return 0;
    if (lines->merged)
        edges_cross(breaks, &n, lines, &lines->polygon[0], &lines->polygon[0]);
    for (size_t i = 0; i < lines->n_polygons; i++)
        for (size_t j = i + 1; j < lines->n_polygons; j++) {
            edges_cross(breaks, &n, lines, &lines->polygon[i], &lines->polygon[j]);
            planes_cross(breaks, &n, lines, &lines->polygon[i], &lines->polygon[j]);
        }
    return n;
}
