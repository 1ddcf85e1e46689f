/* Built-in shapes as meshes with exact normals, about the origin, y up.
 *
 *     sphere   radius 1                                    torus  radii 1 (ring) and `minor`, around y
 *     plane    square [-1, 1]^2 at y = 0, facing +y        disc   radius 1 at y = 0, facing +y
 *     teapot   Newell's 28 Bezier patches, as published without a bottom, standing on y = 0: 0.85 high, the
 *              body 1.14 across, 1.83 from the handle (-x) to the spout (+x)
 */
#ifndef RL_SCENE_SHAPES_H
#define RL_SCENE_SHAPES_H

#include "scene/mesh.h"

enum rl_shape {
    RL_SHAPE_SPHERE,
    RL_SHAPE_TORUS,
    RL_SHAPE_PLANE,
    RL_SHAPE_DISC,
    RL_SHAPE_TEAPOT,
    RL_SHAPE_MESH
};

enum { RL_TESSELLATION_MIN = 1, RL_TESSELLATION_MAX = 512 };

/* `tessellation`: segments along a quarter of the sphere's and the torus's circles, along the plane's edge
 * and a quarter of the disc's rim, and along each edge of a teapot patch. `minor`, in (0, 1), is the
 * torus's only. RL_ERR_INPUT: out of range, or RL_SHAPE_MESH, which has no form of its own. */
int rl_shape_build(struct rl_mesh *mesh, enum rl_shape shape, int tessellation, double minor,
                   struct rl_error *error);

/* The name as scene files have it, or NULL. */
const char *rl_shape_name(enum rl_shape shape);

#endif
