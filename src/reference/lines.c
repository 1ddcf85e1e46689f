/* Sees the lights from a point: frame, horizon, edges (see lines.h). */
#include "reference/lines.h"

#include "model/frame.h"
#include "reference/side.h"

static size_t aligned(size_t bytes)
{
    return (bytes + 15) / 16 * 16;
}

/* Cutting at the horizon at most doubles a polygon's vertices; an edge has at most two crossings, and a line two ends. */
size_t rl_lines_edges_most(const struct rl_light_set *set)
{
    return 2 * set->n_vertices;
}
static size_t most_crossings(const struct rl_light_set *set)
{
    return 2 * rl_lines_edges_most(set) + 2;
}

size_t rl_lines_size(const struct rl_light_set *set)
{
    return aligned(rl_lines_edges_most(set) * sizeof(struct rl_edge)) +
           aligned(most_crossings(set) * sizeof(struct rl_crossing)) +
           aligned(set->n_polygons * sizeof(struct rl_seen_polygon)) +
           aligned(set->n_polygons * sizeof(struct rl_seen_polygon *)) + aligned(set->n_polygons) +
           aligned(rl_lines_edges_most(set) * sizeof(struct rl_extent));
}

static void lay_out(struct rl_lines *lines, char *memory)
{
    const struct rl_light_set *set = lines->set;
    lines->edge = (struct rl_edge *)memory;
    memory += aligned(rl_lines_edges_most(set) * sizeof(struct rl_edge));
    lines->crossing = (struct rl_crossing *)memory;
    memory += aligned(most_crossings(set) * sizeof(struct rl_crossing));
    lines->polygon = (struct rl_seen_polygon *)memory;
    memory += aligned(set->n_polygons * sizeof(struct rl_seen_polygon));
    lines->active = (struct rl_seen_polygon **)memory;
    memory += aligned(set->n_polygons * sizeof(struct rl_seen_polygon *));
    lines->facing = (signed char *)memory;
    memory += aligned(set->n_polygons);
    lines->extent = (struct rl_extent *)memory;
}

/* One vertex of a polygon in the order that puts the light where m.L > 0, and the edge that starts there. */
struct corner {
    rl_vec3 p, edge;
    bool inner; /* the edge lies between two polygons that are seen as one */
};

static bool inner_edge(const struct rl_lines *lines, size_t polygon, size_t edge)
{
    if (!lines->merged)
        return false;
    const struct rl_twin *twin = &lines->set->twin[edge];
    return twin->polygon != RL_NO_TWIN && lines->facing[twin->polygon] != 0 &&
           (lines->facing[polygon] == lines->facing[twin->polygon]) == twin->opposite;
}

static struct corner corner(const struct rl_lines *lines, size_t polygon, const struct rl_frame *frame,
                            rl_vec3 P, size_t i)
{
    const struct rl_light_set *set = lines->set;
    size_t first = set->polygon[polygon].first, n = set->polygon[polygon].n;
    bool reversed = lines->facing[polygon] < 0;
    size_t at = reversed ? n - 1 - i : i, edge = first + (reversed ? (at + n - 1) % n : at);
    return (struct corner){
        .p = rl_frame_components(frame, v3_sub(set->vertex[first + at], P)),
        .edge = rl_frame_components(frame, v3_scale(reversed ? -1.0 : 1.0, set->edge[edge])),
        .inner = inner_edge(lines, polygon, edge),
    };
}

/* An edge of great circle m that starts in direction p. m = 0 marks one along the horizon. */
static void start_edge(struct rl_lines *lines, rl_vec3 p, rl_vec3 m, bool inner)
{
    rl_vec3 start = v3_normalize(p);
    lines->edge[lines->n_edges++] = (struct rl_edge){.m = m,
                                                     .start = start,
                                                     .q_x = lines->v_x + start.x,
                                                     .q_y = lines->v_y + start.y,
                                                     .inner = inner,
                                                     .reach = v3_dot(start, p)};
}

/* Sutherland and Hodgman (1974) against the plane z = 0. A polygon that is cut into several parts stays one loop, joined along
 * the horizon there and back, which encloses nothing. */
static void cut_at_horizon(struct rl_lines *lines, struct corner from, struct corner to)
{
    bool from_up = !lines->attenuation || from.p.z > 0.0, to_up = !lines->attenuation || to.p.z > 0.0;
    if (!from_up && !to_up)
        return;
    rl_vec3 m = v3_normalize(v3_cross(from.p, from.edge));
    if (from_up)
        start_edge(lines, from.p, m, from.inner);
    if (from_up == to_up)
        return;
    rl_vec3 at = v3_madd(from.p, from.p.z / (from.p.z - to.p.z), from.edge);
    at.z = 0.0;
    start_edge(lines, at, from_up ? v3(0.0, 0.0, 0.0) : m, !from_up && from.inner);
}

/* Every edge ends where the next starts. */
static void close_loop(struct rl_edge *edge, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        struct rl_edge *it = &edge[i];
        const struct rl_edge *next = &edge[i + 1 < n ? i + 1 : 0];
        it->end = next->start;
        it->next_x = next->q_x;
        it->next_y = next->q_y;
        if (it->m.x == 0.0 && it->m.y == 0.0 && it->m.z == 0.0)
            it->m.z = it->start.x * it->end.y - it->start.y * it->end.x < 0.0 ? -1.0 : 1.0;
        rl_vec3 from = v3_cross(it->m, it->start), to = v3_cross(it->m, it->end);
        it->from_x = from.x;
        it->from_y = from.y;
        it->to_x = to.x;
        it->to_y = to.y;
    }
}

/* Whether direction L hits the polygon: point in polygon by crossing number, in the polygon's plane with one axis dropped. Corners are
 * where they are, and not where their directions hit the plane: P may lie so near to it that it is seen edge-on but for rounding. */
static bool hits(const struct rl_edge *edge, size_t n, rl_vec3 nearness, rl_vec3 L)
{
    double near = v3_dot(nearness, L);
    if (!(near > 0.0))
        return false;
    rl_vec3 a = v3(fabs(nearness.x), fabs(nearness.y), fabs(nearness.z));
    int drop = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    double x = (drop == 0 ? L.y : L.x) / near, y = (drop == 2 ? L.y : L.z) / near;
    bool inside = false;
    for (size_t i = 0; i < n; i++) {
        rl_vec3 p = v3_scale(edge[i].reach, edge[i].start),
                q = v3_scale(edge[i + 1 < n ? i + 1 : 0].reach, edge[i].end);
        double px = drop == 0 ? p.y : p.x, py = drop == 2 ? p.y : p.z;
        double qx = drop == 0 ? q.y : q.x, qy = drop == 2 ? q.y : q.z;
        if ((py > y) != (qy > y) && x < px + (qx - px) * (y - py) / (qy - py))
            inside = !inside;
    }
    return inside;
}

/* Whether L lies on an edge, other than one between two polygons that are seen as one, to within rounding and more. */
static bool on_edge(const struct rl_edge *edge, size_t n, rl_vec3 L)
{
    static const double near = 1e-7;
    for (size_t i = 0; i < n; i++) {
        const struct rl_edge *it = &edge[i];
        if (!it->inner && fabs(v3_dot(it->m, L)) < near && v3_dot(v3_cross(it->m, it->start), L) > -near &&
            v3_dot(v3_cross(it->m, it->end), L) < near && v3_dot(v3_add(it->start, it->end), L) > 0.0)
            return true;
    }
    return false;
}

/* Adds the polygon's loop of edges to what is seen. */
static void see_loop(struct rl_lines *lines, struct rl_seen_polygon *seen, const struct rl_frame *frame,
                     rl_vec3 P, size_t polygon)
{
    size_t first = lines->n_edges;
    struct corner start = corner(lines, polygon, frame, P, 0), from = start;
    for (size_t i = 1; i <= lines->set->polygon[polygon].n; i++) {
        struct corner to = i < lines->set->polygon[polygon].n ? corner(lines, polygon, frame, P, i) : start;
        cut_at_horizon(lines, from, to);
        from = to;
    }
    struct rl_edge *edge = &lines->edge[first];
    size_t n = lines->n_edges - first;
    close_loop(edge, n);
    if (!lines->attenuation) {
        rl_vec3 mirror = v3(-lines->v_x, -lines->v_y, lines->v_n);
        seen->mirror_on_edge = seen->mirror_on_edge || on_edge(edge, n, mirror);
        /* Of several polygons none may be counted twice, nor missed, where the mirror direction lies on an edge between two: a
         * direction beside it lies on none, and tells the same as long as the outline is further off. */
        if (lines->merged)
            mirror = v3_normalize(v3_madd(mirror, 1e-8, v3(0.6180, 0.3319, -0.7123)));
        seen->mirror_winding += hits(edge, n, seen->nearness, mirror);
    }
    if (lines->merged) {
        lines->n_edges = first;
        for (size_t i = 0; i < n; i++)
            if (!edge[i].inner)
                lines->edge[lines->n_edges++] = edge[i];
    }
}

static void see_polygon(struct rl_lines *lines, const struct rl_frame *frame, rl_vec3 P, size_t polygon)
{
    const struct rl_light_set *set = lines->set;
    const struct rl_set_polygon *it = &set->polygon[polygon];
    if (lines->facing[polygon] == 0)
        return;
    struct rl_seen_polygon *seen = &lines->polygon[lines->merged ? 0 : lines->n_polygons];
    if (!lines->merged || lines->n_polygons == 0)
        *seen = (struct rl_seen_polygon){.first = lines->n_edges, .radiance = it->radiance};
    double distance = rl_side_distance(set, it, P);
    seen->nearness = v3_scale(1.0 / distance, rl_frame_components(frame, it->normal));
    see_loop(lines, seen, frame, P, polygon);
    seen->n = lines->n_edges - seen->first;
    if (seen->n > 0 || seen->mirror_winding > 0)
        lines->n_polygons = lines->merged ? 1 : lines->n_polygons + 1;
}

void rl_lines_make(struct rl_lines *lines, void *memory, const struct rl_surface *surface,
                   const struct rl_ellipsoid *e, const struct rl_light_set *set,
                   const struct rl_integrate_options *options)
{
    rl_vec3 N = v3_normalize(surface->N);
    struct rl_frame frame = rl_frame_make(RL_FRAME_ORTHONORMAL, N);
    rl_vec3 V = v3_normalize(rl_frame_components(&frame, surface->V));
    /* Every azimuth counts the same, so of the printed frame only its length matters. */
    double stretch = options->frame == RL_FRAME_PRINTED ? fmin(1.0, sqrt(N.y * N.y + N.z * N.z)) : 1.0;
    *lines = (struct rl_lines){
        .e = e,
        .set = set,
        .attenuation = options->attenuation,
        .irradiance = options->irradiance,
        .merged = set->twin != NULL && !options->occlusion,
        .stretch = stretch,
        .v_x = V.x,
        .v_y = V.y,
        .v_n = V.z,
        .occlusion = options->occlusion,
    };
    lay_out(lines, memory);
    for (size_t i = 0; i < set->n_polygons; i++) {
        double distance = rl_side_distance(set, &set->polygon[i], surface->P);
        lines->facing[i] = (signed char)((distance > 0.0) - (distance < 0.0));
    }
    for (size_t i = 0; i < set->n_polygons; i++)
        see_polygon(lines, &frame, surface->P, i);
}

struct rl_edge rl_edge_between(double v_x, double v_y, rl_vec3 m, rl_vec3 start, rl_vec3 end)
{
    rl_vec3 from = v3_cross(m, start), to = v3_cross(m, end);
    return (struct rl_edge){
        .m = m,
        .start = start,
        .end = end,
        .q_x = v_x + start.x,
        .q_y = v_y + start.y,
        .next_x = v_x + end.x,
        .next_y = v_y + end.y,
        .from_x = from.x,
        .from_y = from.y,
        .to_x = to.x,
        .to_y = to.y,
    };
}

bool rl_lines_hit(const struct rl_lines *lines, const struct rl_seen_polygon *polygon, rl_vec3 L)
{
    return hits(&lines->edge[polygon->first], polygon->n, polygon->nearness, L);
}

double rl_lines_nearness(const struct rl_lines *lines, rl_vec3 L)
{
    double most = 0.0;
    for (size_t i = 0; i < lines->n_polygons; i++) {
        const struct rl_seen_polygon *polygon = &lines->polygon[i];
        if (rl_lines_hit(lines, polygon, L))
            most = fmax(most, v3_dot(polygon->nearness, L));
    }
    return most;
}
