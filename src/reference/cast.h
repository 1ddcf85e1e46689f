/* Rays from one point at the lights' polygons, in world space: which one is hit first.
 *
 * Each polygon is met with its plane, and the meeting point is looked for in the outline by winding number, any winding but 0 being
 * inside (Hormann and Agathos 2001). Vertices that lie off the plane by rounding are taken where they are seen from P. Of polygons
 * hit at the same distance the set's first counts; one seen edge-on is never hit.
 *
 *     struct rl_cast cast;
 *     status = rl_cast_make(&cast, P, set, &error);
 *     size_t i = rl_cast_nearest(&cast, L);                  RL_CAST_MISS, or an index into set->polygon
 *     rl_cast_free(&cast);
 */
#ifndef RL_REFERENCE_CAST_H
#define RL_REFERENCE_CAST_H

#include <stdbool.h>
#include <stdint.h>

#include "reference/light_set.h"

#define RL_CAST_MISS SIZE_MAX

struct rl_point2 {
    double x, y;
};

/* A polygon's plane with its own axes: the point origin + x T + y B, relative to P. */
struct rl_cast_polygon {
    rl_vec3 origin, T, B, normal;
    double distance; /* normal.origin; 0: seen edge-on */
    struct rl_point2 low, high;
    size_t n;
    const struct rl_point2 *vertex; /* the outline, in these axes */
};

struct rl_cast {
    size_t n_polygons;
    struct rl_cast_polygon *polygon; /* as many as the set has, in its order */
    struct rl_point2 *vertex;
};

int rl_cast_make(struct rl_cast *cast, rl_vec3 P, const struct rl_light_set *set, struct rl_error *error);
void rl_cast_free(struct rl_cast *cast);

/* L need not be unit length. */
size_t rl_cast_nearest(const struct rl_cast *cast, rl_vec3 L);

/* Whether L_o is 0 without looking: the eye behind the surface, no light, or a black one. */
bool rl_cast_needless(const struct rl_surface *surface, const struct rl_light_set *set);

/* All that is known of L_o where not a single evaluation is allowed: from 0 to the brightest radiance. Not converged. */
void rl_cast_unknown(struct rl_estimate *estimate, const struct rl_light_set *set);

/* The brightest radiance of a channel. */
double rl_cast_brightest(const struct rl_light_set *set, int channel);

#endif
