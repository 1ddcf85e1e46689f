/* What the camera sees at a pixel's centre, found by Embree on the scene's meshes with the GPU's rules: back faces are culled or, without
 * culling, shaded with -N; the nearest face between the camera's planes wins, in double precision, normals are interpolated.
 */
#ifndef RL_REFERENCE_VISIBLE_H
#define RL_REFERENCE_VISIBLE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "effects/effect.h"
#include "scene/scene.h"

struct rl_visible;

/* `scene` must outlive it. drawn: of each object, whether any ray may see it, or NULL: all. Left out it changes nothing that the rays see. */
int rl_visible_make(struct rl_visible **out, const struct rl_scene *scene, const bool *drawn, bool culling,
                    struct rl_error *error);
void rl_visible_free(struct rl_visible *visible);

/* Where a ray met: the object, which of its triangles, and the weights of that one's corners, which sum to 1. */
struct rl_visible_hit {
    size_t object, triangle;
    double weight[3];
    bool
        from_behind; /* without culling: the triangle turns its back to the eye, and the point's normal is turned */
};

/* The surface point on the ray from the camera in this direction (unit) and where it is; false: background. May be
 * called by several threads at once. */
bool rl_visible_point(struct rl_surface *surface, struct rl_visible_hit *hit,
                      const struct rl_visible *visible, rl_vec3 direction);

#endif
