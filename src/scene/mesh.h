/* Triangle meshes: positions and unit normals per vertex, three indices per triangle, counter-clockwise
 * from outside. */
#ifndef RL_SCENE_MESH_H
#define RL_SCENE_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "model/vec3.h"

struct rl_mesh {
    size_t n_vertices, n_triangles;
    float (*position)[3];
    float (*normal)[3];
    uint32_t (*triangle)[3];
};

/* Frees what the mesh owns and leaves it empty. */
void rl_mesh_clear(struct rl_mesh *mesh);

/* Empty arrays of these sizes. */
int rl_mesh_allocate(struct rl_mesh *mesh, size_t n_vertices, size_t n_triangles, struct rl_error *error);

/* Box of all positions; the centre is the box's, the radius reaches the farthest vertex from it. */
void rl_mesh_bounds(const struct rl_mesh *mesh, rl_vec3 *low, rl_vec3 *high, rl_vec3 *centre, double *radius);

/* How many triangles turn their back or their edge to the eye. */
size_t rl_mesh_back_faces(const struct rl_mesh *mesh, rl_vec3 eye);

/* Whether the mesh has no edge that a surface ends at: every edge of a triangle is another one's, run through the other way, vertices at
 * one position being one. Triangles without area do not count. (mesh_closed.c) */
int rl_mesh_closed(bool *closed, const struct rl_mesh *mesh, struct rl_error *error);

/* Where a triangle is shaded as a whole: the centroid of its corners and the unit normal of its plane, counter-clockwise seen from its
 * tip; 0 of one without area. */
void rl_mesh_facet(const struct rl_mesh *mesh, size_t triangle, rl_vec3 *centroid, rl_vec3 *normal);

/* The same triangles so that the last corner of each is no other's last (OpenGL's provoking vertex, which `flat` outputs are taken from):
 * turned where that is enough, else with a copy of it. So hardly more vertices are evaluated than there are triangles. *n_twins: how many
 * copies; `twin`: vertex n_vertices + i is a copy of vertex twin[i]. `triangle` and `twin` have room for n_triangles each; NULL: only
 * counted. (mesh_facets.c) */
int rl_mesh_own_last(size_t *n_twins, uint32_t (*triangle)[3], uint32_t *twin, const struct rl_mesh *mesh,
                     struct rl_error *error);

/* Loads any file that assimp knows (OBJ, PLY, glTF/GLB, ...), all its meshes joined and node transforms
 * applied. Normals missing from the file are made, smooth. RL_ERR_INPUT, naming the file: unreadable, no
 * triangles, non-finite vertices, truncated, or a file that assimp crashes on or does not finish: it runs
 * in a process of its own. *hash, where not NULL, takes in the bytes of every file that was read (a glTF
 * file names others). (mesh_file.c) */
int rl_mesh_load(struct rl_mesh *mesh, uint64_t *hash, const char *path, struct rl_error *error);

#endif
