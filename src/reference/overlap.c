/* Breaks that pairs of polygons make (see breaks.h): where, seen from P, their edges cross, and where one passes through the other. */
#include "reference/breaks.h"

#include <stdlib.h>

enum { MORE = 128, SEAMS_MOST = 64, SEAM_ENDS_MOST = 64 };

size_t rl_overlap_breaks_most(const struct rl_light_set *set)
{
    return set->whole_polygons > 1 ? 16 * set->whole_vertices + MORE : 0;
}

/* Breaks as they are found; `complete` until there is no room for one. */
struct found {
    const struct rl_lines *lines;
    struct rl_break *breaks;
    size_t n, most;
    bool complete;
};

/* Where one polygon passes through another: an arc of the great circle on which both are equally near. */
struct seam {
    struct rl_edge edge;
    const struct rl_seen_polygon *a, *b;
};

struct seams {
    size_t n;
    struct seam seam[SEAMS_MOST];
};

static const struct rl_edge *edge_of(const struct rl_lines *lines, const struct rl_seen_polygon *polygon,
                                     size_t i)
{
    return &lines->edge[polygon->first + i];
}

static bool parted(rl_vec3 m, const struct rl_edge *arc)
{
    return (v3_dot(m, arc->start) > 0.0) != (v3_dot(m, arc->end) > 0.0);
}

/* Of the two directions where the great circle m crosses that of the arc, the one on the arc. */
static rl_vec3 meeting(rl_vec3 m, const struct rl_edge *arc)
{
    rl_vec3 L = v3_normalize(v3_cross(m, arc->m));
    return v3_dot(L, v3_add(arc->start, arc->end)) < 0.0 ? v3_scale(-1.0, L) : L;
}

static void add(struct found *found, rl_vec3 L)
{
    if (found->n < found->most)
        found->breaks[found->n++] = (struct rl_break){
            .theta = rl_line_azimuth(found->lines->v_x + L.x, found->lines->v_y + L.y),
            .kind = RL_BREAK_KINK,
        };
    else
        found->complete = false;
}

static bool same(rl_vec3 a, rl_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool joined(const struct rl_edge *a, const struct rl_edge *b)
{
    return same(a->start, b->start) || same(a->start, b->end) || same(a->end, b->start) ||
           same(a->end, b->end);
}

static void edges_cross(struct found *found, const struct rl_edge *a, const struct rl_edge *b)
{
    if (!parted(a->m, b) || !parted(b->m, a) || joined(a, b))
        return;
    rl_vec3 L = meeting(a->m, b);
    if (v3_dot(L, v3_add(a->start, a->end)) > 0.0)
        add(found, L);
}

/* Where the great circle m meets the polygon's edges. */
static size_t seam_ends(rl_vec3 end[], size_t n, const struct rl_lines *lines, rl_vec3 m,
                        const struct rl_seen_polygon *polygon)
{
    for (size_t i = 0; i < polygon->n && n < SEAM_ENDS_MOST; i++) {
        const struct rl_edge *edge = edge_of(lines, polygon, i);
        if (parted(m, edge))
            end[n++] = meeting(m, edge);
    }
    return n;
}

/* Sorts directions on the great circle m by their angle from the first; all lie within half a turn. */
static void sort_along(rl_vec3 end[], size_t n, rl_vec3 m)
{
    rl_vec3 across = v3_cross(m, end[0]), origin = end[0];
    for (size_t i = 1; i < n; i++) {
        rl_vec3 moved = end[i];
        double angle = atan2(v3_dot(moved, across), v3_dot(moved, origin));
        size_t at = i;
        for (; at > 0 && atan2(v3_dot(end[at - 1], across), v3_dot(end[at - 1], origin)) > angle; at--)
            end[at] = end[at - 1];
        end[at] = moved;
    }
}

/* Adds the seams of a pair: the parts of the circle of equal nearness that lie on both. */
static void find_seams(struct seams *seams, struct found *found, const struct rl_seen_polygon *a,
                       const struct rl_seen_polygon *b)
{
    const struct rl_lines *lines = found->lines;
    rl_vec3 m = v3_normalize(v3_sub(a->nearness, b->nearness)), end[SEAM_ENDS_MOST];
    if (a->radiance == b->radiance || !(v3_dot(m, m) > 0.0))
        return;
    size_t of_a = seam_ends(end, 0, lines, m, a), n = seam_ends(end, of_a, lines, m, b);
    if (of_a == 0 || of_a == n)
        return;
    found->complete = found->complete && n < SEAM_ENDS_MOST;
    sort_along(end, n, m);
    for (size_t i = 0; i + 1 < n; i++) {
        rl_vec3 middle = v3_normalize(v3_add(end[i], end[i + 1]));
        if (!rl_lines_hit(lines, a, middle) || !rl_lines_hit(lines, b, middle))
            continue;
        if (seams->n == SEAMS_MOST)
            found->complete = false;
        else
            seams->seam[seams->n++] =
                (struct seam){rl_edge_between(lines->v_x, lines->v_y, m, end[i], end[i + 1]), a, b};
    }
}

/* A seam breaks as an edge does; and where a third polygon's edge or another seam crosses it, what is in front changes. */
static void seam_breaks(struct found *found, const struct seams *seams, size_t index)
{
    const struct rl_lines *lines = found->lines;
    const struct seam *seam = &seams->seam[index];
    if (found->n + RL_BREAKS_OF_EDGE <= found->most)
        found->n += rl_breaks_of_edge(found->breaks + found->n, lines, &seam->edge);
    else
        found->complete = false;
    add(found, seam->edge.end);
    for (size_t p = 0; p < lines->n_polygons; p++)
        for (size_t i = 0; i < lines->polygon[p].n; i++) {
            if (&lines->polygon[p] != seam->a && &lines->polygon[p] != seam->b)
                edges_cross(found, &seam->edge, edge_of(lines, &lines->polygon[p], i));
        }
    for (size_t i = 0; i < index; i++)
        edges_cross(found, &seam->edge, &seams->seam[i].edge);
}

static void polygons_cross(struct found *found, struct seams *seams, const struct rl_seen_polygon *a,
                           const struct rl_seen_polygon *b)
{
    for (size_t i = 0; i < a->n; i++)
        for (size_t j = 0; j < b->n; j++)
            edges_cross(found, edge_of(found->lines, a, i), edge_of(found->lines, b, j));
    find_seams(seams, found, a, b);
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
size_t rl_overlap_breaks(struct rl_break *breaks, bool *complete, const struct rl_lines *lines)
{
    struct found found = {lines, breaks, 0, rl_overlap_breaks_most(lines->set), true};
    struct seams seams = {.n = 0};
    struct rl_extent *extent = lines->extent;
    const struct rl_seen_polygon *polygon = lines->polygon;
    size_t n_items = lines->merged ? lines->n_edges : lines->n_polygons;
    for (size_t i = 0; i < n_items; i++)
        extent[i] = lines->merged ? extent_of(&lines->edge[i], 1, i)
                                  : extent_of(&lines->edge[polygon[i].first], polygon[i].n, i);
    qsort(extent, n_items, sizeof *extent, by_low);
    for (size_t i = 0; i < n_items; i++)
        for (size_t j = i + 1; j < n_items && extent[j].low <= extent[i].high; j++)
            if (lines->merged) {
                edges_cross(&found, edge_of(lines, polygon, extent[i].index),
                            edge_of(lines, polygon, extent[j].index));
            } else {
                polygons_cross(&found, &seams, &polygon[extent[i].index], &polygon[extent[j].index]);
            }
    for (size_t i = 0; i < seams.n; i++)
        seam_breaks(&found, &seams, i);
    *complete = found.complete;
    return found.n;
}
