/* Breaks that pairs of polygons make (see breaks.h): where, seen from P, their edges cross, and where one passes through the other. */
#include "reference/breaks.h"

#include <stdlib.h>

enum { MORE = 64 };

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

static void arcs_cross(struct rl_break *breaks, size_t *n, const struct rl_lines *lines, const struct arc *a,
                       const struct arc *b)
{
    if (!parted(a->m, b) || !parted(b->m, a) || joined(a, b))
        return;
    rl_vec3 L = meeting(a->m, b);
    if (v3_dot(L, v3_add(a->from, a->to)) > 0.0)
        add(breaks, n, lines, L);
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
    struct rl_break touch[RL_TOUCHES_MOST];
    size_t n_touch = rl_touch_breaks(touch, lines, m);
    for (size_t i = 0; i < n_touch && *n < rl_overlap_breaks_most(lines->set); i++)
        breaks[(*n)++] = (struct rl_break){
            .theta = touch[i].theta,
            .kind = touch[i].kind == RL_BREAK_ROOT ? RL_BREAK_TOUCH : touch[i].kind,
        };
}

static void polygons_cross(struct rl_break *breaks, size_t *n, const struct rl_lines *lines,
                           const struct rl_seen_polygon *a, const struct rl_seen_polygon *b)
{
    for (size_t i = 0; i < a->n; i++) {
        struct arc one = arc_of(lines, a, i);
        for (size_t j = 0; j < b->n; j++) {
            struct arc other = arc_of(lines, b, j);
            arcs_cross(breaks, n, lines, &one, &other);
        }
    }
    planes_cross(breaks, n, lines, a, b);
}

/* Of edges i0 .. i0 + n - 1: between which x their directions lie. An arc bulges over its chord c by 1 - sqrt(1 - c^2/4) <= c^2/4 at
 * most, and no point inside of a polygon is further out than that for its diameter. */
static struct rl_extent extent_of(const struct rl_edge *edge, size_t n, size_t index)
{
    struct rl_extent extent = {.low = 1.0, .high = -1.0, .index = index};
    double across = 0.0;
    for (size_t i = 0; i < n; i++) {
        extent.low = fmin(extent.low, fmin(edge[i].start.x, edge[i].end.x));
        extent.high = fmax(extent.high, fmax(edge[i].start.x, edge[i].end.x));
        across = fmax(across, v3_length(v3_sub(edge[i].end, edge[0].start)));
    }
    extent.low -= across * across;
    extent.high += across * across;
    return extent;
}

static int by_low(const void *a, const void *b)
{
    double x = ((const struct rl_extent *)a)->low, y = ((const struct rl_extent *)b)->low;
    return (x > y) - (x < y);
}

/* Every pair whose extents in x overlap, which of a mesh's small pieces are few. */
size_t rl_overlap_breaks(struct rl_break *breaks, const struct rl_lines *lines)
{
    if (lines->set->n_polygons < 2)
        return 0;
    struct rl_extent *extent = lines->extent;
    const struct rl_seen_polygon *polygon = lines->polygon;
    size_t n = 0, n_items = lines->merged ? lines->n_edges : lines->n_polygons;
    for (size_t i = 0; i < n_items; i++)
        extent[i] = lines->merged ? extent_of(&lines->edge[i], 1, i)
                                  : extent_of(&lines->edge[polygon[i].first], polygon[i].n, i);
    qsort(extent, n_items, sizeof *extent, by_low);
    for (size_t i = 0; i < n_items; i++)
        for (size_t j = i + 1; j < n_items && extent[j].low <= extent[i].high; j++)
            if (lines->merged) {
                struct arc a = arc_of(lines, polygon, extent[i].index),
                           b = arc_of(lines, polygon, extent[j].index);
                arcs_cross(breaks, &n, lines, &a, &b);
            } else {
                polygons_cross(breaks, &n, lines, &polygon[extent[i].index], &polygon[extent[j].index]);
            }
    return n;
}
