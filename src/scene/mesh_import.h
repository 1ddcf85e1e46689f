/* The two halves of loading a mesh that mesh_file.c puts together. */
#ifndef RL_SCENE_MESH_IMPORT_H
#define RL_SCENE_MESH_IMPORT_H

#include "scene/mesh.h"

/* Whether the bytes of a PLY file are whole: as many values as the header announces, indices in range.
 * assimp takes some cut files for smaller meshes and never returns from others. `data` ends in a NUL.
 * (ply_check.c) */
int rl_ply_check(const char *data, size_t size, const char *path, struct rl_error *error);

/* Imports through assimp, in this process. `data`, `size` are the bytes of `path`; assimp may open others
 * beside it. */
int rl_mesh_import(struct rl_mesh *mesh, uint64_t *hash, const char *path, const char *data, size_t size,
                   struct rl_error *error);

#endif
