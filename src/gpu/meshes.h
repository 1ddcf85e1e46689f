/* Meshes in the GPU's memory. */
#ifndef RL_GPU_MESHES_H
#define RL_GPU_MESHES_H

#include "gpu/scene.h"

/* Makes the object's vertex array, of position and normal, out of the parts that object->part has already and those that it does not have yet,
 * which are uploaded. `facets`: of the centroid and the normal of a triangle, too, in the last of its
 * vertices, which is no other triangle's last (OpenGL's provoking vertex, which `flat` outputs are taken from); vertices are added and
 * triangles turned where that needs it, and no position changes. *bytes: what was uploaded is added. */
int rl_mesh_upload(struct rl_gpu_object *object, struct rl_gl *gl, const struct rl_mesh *mesh, bool facets,
                   size_t *bytes, struct rl_error *error);

#endif
