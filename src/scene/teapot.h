/* Newell's teapot as data and as a surface: what shapes.c tessellates and the tests take derivatives of. */
#ifndef RL_SCENE_TEAPOT_H
#define RL_SCENE_TEAPOT_H

#include "model/vec3.h"
#include "scene/mesh.h"

enum { RL_TEAPOT_POINTS = 269, RL_TEAPOT_PATCHES = 28 };

extern const double rl_teapot_point[RL_TEAPOT_POINTS][3];
extern const unsigned short rl_teapot_patch[RL_TEAPOT_PATCHES][16];

/* The point and the unit normal, outwards, of a patch at (u, v) in [0, 1]^2; u runs along a row of control
 * points. At the lid's tip, where a whole edge of the patch is one point, the normal is its limit. */
void rl_teapot_evaluate(int patch, double u, double v, rl_vec3 *position, rl_vec3 *normal);

/* Every patch as `tessellation` x `tessellation` quads of two triangles. Vertices on common edges are not
 * merged. */
int rl_teapot_build(struct rl_mesh *mesh, int tessellation, struct rl_error *error);

#endif
