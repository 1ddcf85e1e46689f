/* The lights as seen from one point, and the inner integral along one line of fixed azimuth theta.
 *
 * In the frame (T, B, N) of the point, with t = (cos theta, sin theta), b perpendicular to it: as delta runs over [-pi/2, pi/2], the
 * reflected direction L runs once round the circle of unit vectors with L.b = -v_b. All these circles pass through the mirror
 * direction and through -V; seen along N they are straight, the line of direction theta through -V's foot. So:
 *
 *   - a vertex in unit direction p lies on the line whose azimuth is that of q = (V + p) projected on the tangent plane, and on one
 *     side of the line theta or the other as b.q is > 0 or < 0;
 *   - an edge is an arc of a great circle with unit normal m; in the line's own axes (t, b, N) the two crossings are
 *
 *         L_t = (v_b m_b m_t +- d m_N)/r^2,  L_N = (v_b m_b m_N -+ d m_t)/r^2,  r^2 = m_t^2 + m_N^2,
 *         d^2 = r^2 - v_b^2 = (v_t^2 + v_N^2) - m_b^2
 *
 *     the upper sign where b.q rises along the edge. Ends on different sides: one crossing, and its sign is known; ends on the same
 *     side: two or none. The side of a vertex is decided once for both its edges, so crossings always pair up;
 *   - the circle touches the edge where d = 0: a quadratic in tan(theta).
 *
 * Loops run so that the light lies where m.L > 0. With attenuation on, polygons are cut at the horizon first.
 */
#ifndef RL_REFERENCE_LINES_H
#define RL_REFERENCE_LINES_H

#include <stdbool.h>
#include <stddef.h>

#include "reference/inner.h"
#include "reference/light_set.h"

struct rl_edge {
    rl_vec3 m;             /* unit normal of the edge's great circle */
    rl_vec3 start, end;    /* unit directions p of its vertices */
    double q_x, q_y;       /* V + p at its start, projected */
    double next_x, next_y; /* and at its end */
    double from_x, from_y; /* m x p at its start: the tangent along the edge */
    double to_x, to_y;     /* and at its end */
    double reach;          /* how far the start is from P */
    bool inner;            /* between two polygons that are seen as one */
};

/* A polygon; or, where all lights have one radiance and it does not matter which of them is nearest, all polygons together. Of those,
 * edges between two that face the same way are left out: what remains of a mesh is its outline. */
struct rl_seen_polygon {
    size_t first, n;     /* edges; their ends form closed loops */
    size_t radiance;     /* index in the set */
    rl_vec3 nearness;    /* of a single polygon: 1/distance in direction L is nearness.L */
    int mirror_winding;  /* how many polygons the mirror direction hits; only without attenuation */
    bool mirror_on_edge; /* it lies so near to an edge that this is rounding */
    int winding;         /* scratch of a line */
};

/* What a place on a line is the crossing of, whatever line it is: the great circle m, upwards (+1: b.L grows along m x L) or downwards
 * (-1); or 0: an end of the line, m being (0, 0, -1) at delta = -pi/2 and (0, 0, 1) at pi/2. */
struct rl_limit {
    rl_vec3 m;
    double way;
};

/* A place on a line. */
struct rl_crossing {
    struct rl_angle normal; /* the microfacet normal there */
    struct rl_angle delta;  /* and where the density takes it: differs in the printed frame only */
    double l_t, l_n;        /* L */
    bool full;              /* G = 1 */
    int sign;               /* +1: enters the polygon as delta grows; -1: leaves */
    struct rl_limit limit;
    struct rl_seen_polygon *polygon;
};

/* Light of one radiance is seen from one limit to the other, on every line of a panel. */
struct rl_stretch {
    struct rl_limit from, to;
    size_t radiance; /* index in the set */
};

/* Between which x the directions of an edge or a polygon lie. */
struct rl_extent {
    double low, high;
    size_t index;
};

struct rl_lines {
    const struct rl_ellipsoid *e;
    const struct rl_light_set *set;
    bool attenuation, irradiance;
    double stretch;       /* see inner.h */
    double v_x, v_y, v_n; /* V in the frame */
    size_t n_edges, n_polygons;
    bool merged; /* the one seen polygon is all of them */
    struct rl_edge *edge;
    struct rl_seen_polygon *polygon;
    struct rl_crossing *crossing;    /* scratch of a line */
    struct rl_seen_polygon **active; /* scratch of a line */
    struct rl_extent *extent;        /* scratch of the breaks */
    signed char *facing;             /* of each of the set's polygons: 1 front, -1 back, 0 edge-on */
    struct rl_occlusion *occlusion;  /* NULL: nothing hides the lights */
};

/* Most edges that a view of this set may have. */
size_t rl_lines_edges_most(const struct rl_light_set *set);

/* Bytes of memory that rl_lines_make wants for this set, aligned as malloc aligns. */
size_t rl_lines_size(const struct rl_light_set *set);

/* Sees the lights from the surface point; surface N and V unit vectors, V.N > 0. Keeps `memory`, `e` and `set`. */
void rl_lines_make(struct rl_lines *lines, void *memory, const struct rl_surface *surface,
                   const struct rl_ellipsoid *e, const struct rl_light_set *set,
                   const struct rl_integrate_options *options);

/* The edge along the great circle m from one unit direction to another, in the frame; V's components there. */
struct rl_edge rl_edge_between(double v_x, double v_y, rl_vec3 m, rl_vec3 start, rl_vec3 end);

/* Whether direction L, in the frame, hits this polygon; not for several in one. */
bool rl_lines_hit(const struct rl_lines *lines, const struct rl_seen_polygon *polygon, rl_vec3 L);

/* 1/distance to the light hit first in direction L, in the frame; 0 if none is. */
double rl_lines_nearness(const struct rl_lines *lines, rl_vec3 L);

/* value[0..2]: integral over delta of D G L_e (irradiance: over the angle from N, of L_e times sine and cosine), RGB; value[3]: what rounding may have done to it. Returns whether the line meets any
 * light. Uses the scratch inside `lines`. */
bool rl_lines_integrate(double value[4], const struct rl_lines *lines, double theta);

/* The stretches of the line, in order; returns how many, of which no more than `room` are written. Uses the scratch too. */
size_t rl_lines_trace(struct rl_stretch *stretch, size_t room, const struct rl_lines *lines, double theta);

#endif
