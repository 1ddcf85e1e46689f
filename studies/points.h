/* Fixed points for benchmarks of integrators: a surface point, its roughness, and one light near its mirror direction.
 *
 * Point `index` of a kind is a function of nothing but the two: R_r log-uniform in [1, 300], N.V uniform in [0.05, 1], a light of
 * apparent half-size 0.1 to 0.9 radians, 0.5 to 8 away, tilted by up to 60 degrees, whose centre is above the horizon and no
 * farther from the mirror direction than its own size and the lobe's width together, so that there is a highlight to integrate.
 *
 *     struct rl_point p;
 *     rl_point_make(&p, RL_POINT_QUAD, 17);
 *     const rl_vec3 *vertices = p.vertex;
 *     rl_light_set_from_polygons(&set, &vertices, &p.n_vertices, 1, &error);
 */
#ifndef RL_STUDIES_POINTS_H
#define RL_STUDIES_POINTS_H

#include <stddef.h>

#include "effects/effect.h"
#include "model/ellipsoid.h"

enum rl_point_light_kind {
    RL_POINT_QUAD, /* a convex quadrilateral */
    RL_POINT_STAR, /* the five-pointed star of ten edges of teapot-star */
    RL_POINT_KINDS
};

enum { RL_POINT_VERTICES_MAX = 10 };

struct rl_point {
    struct rl_surface surface;
    struct rl_ellipsoid e;
    size_t n_vertices;
    rl_vec3 vertex[RL_POINT_VERTICES_MAX];
};

void rl_point_make(struct rl_point *point, enum rl_point_light_kind kind, size_t index);

/* "quad", "star" */
const char *rl_point_light_name(enum rl_point_light_kind kind);

#endif
