/* What hides the lights from one point: where along a line that can change, and what rays say in between.
 *
 * What is hidden can change at the silhouettes of the occluders alone. Their edges meet a line in closed form as the lights' own
 * edges do (lines.h), so a lit stretch is cut there, in double precision, and one ray through the middle of each part decides for
 * all of it: no search, and nothing thin is missed. Where a ray passes so near to an edge that rounding may have it on the other
 * side, its answer is doubted, and the part counts as error.
 *
 * Over theta the integrand breaks at the silhouette's corners too. Those of simple silhouettes are told in advance. The many of a
 * round body are weak but for those where it begins and ends as theta turns, and looks like the square root that a smooth body
 * has there: only these are told.
 */
#ifndef RL_REFERENCE_OCCLUSION_H
#define RL_REFERENCE_OCCLUSION_H

#include <stdbool.h>
#include <stddef.h>

#include "effects/effect.h"
#include "model/frame.h"
#include "reference/breaks.h"
#include "reference/lines.h"

/* Whether something lies in direction L (unit, world) nearer than this distance. */
typedef bool rl_occlusion_ray(void *user, rl_vec3 L, double distance);

/* An edge at which something may begin or end to hide: an arc of the great circle m, in the frame of the point. */
struct rl_shadow_edge {
    struct rl_edge arc;
    double doubt; /* nearer than this angle a ray may be on the wrong side */
};

/* Part of a line, as angles of the microfacet normal. */
struct rl_part {
    struct rl_angle from, to;
    bool visible, doubtful;
};

/* Where a line meets an edge. */
struct rl_cut {
    struct rl_angle at;
    const struct rl_shadow_edge *edge;
};

/* An end of an edge as theta turns: +1 where it begins, -1 where it ends. */
struct rl_turn {
    double theta;
    int change;
};

struct rl_occlusion {
    rl_occlusion_ray *ray;
    void *user;
    struct rl_frame frame;
    double v_x, v_y; /* V in the frame */
    size_t n_edges, capacity;
    struct rl_shadow_edge *edge;
    struct rl_turn *turn; /* scratch of rl_occlusion_breaks */
    struct rl_cut *cut;   /* scratch of a line */
    struct rl_part *part; /* scratch of a line */
    size_t rays, hidden;  /* asked so far, and how many of them met something */
};

/* Starts a view from this surface point, without edges. What was allocated before is kept for the next view. False: out of
 * memory, as for all that return a bool here. */
bool rl_occlusion_begin(struct rl_occlusion *o, const struct rl_surface *surface);
void rl_occlusion_clear(struct rl_occlusion *o);

/* An edge from a to b (world, relative to the point). */
bool rl_occlusion_add(struct rl_occlusion *o, rl_vec3 a, rl_vec3 b, double doubt);

/* Cuts a lit stretch of the line at azimuth theta and asks for each part. The parts lie in o->part, in order, neighbours alike
 * joined; returns how many. */
size_t rl_occlusion_split(struct rl_occlusion *o, const struct rl_lines *lines, double cos_theta,
                          double sin_theta, struct rl_angle from, struct rl_angle to);

/* Silhouettes of so many edges have all their breaks told. */
enum { RL_OCCLUSION_FEW = 24, RL_OCCLUSION_BREAKS = RL_OCCLUSION_FEW * (RL_BREAKS_OF_EDGE + 1) + 128 };

/* Azimuths at which what is hidden breaks: at most RL_OCCLUSION_BREAKS. Returns how many. */
size_t rl_occlusion_breaks(struct rl_break *breaks, const struct rl_occlusion *o,
                           const struct rl_lines *lines);

#endif
