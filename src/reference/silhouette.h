/* The silhouette of a triangle mesh: the edges at which what it covers, seen from a point, may begin or end.
 *
 * Where two triangles that share an edge face the point alike, what one covers goes on in the other. So the border of what a mesh
 * covers runs along edges whose triangles face differently, and edges that one triangle has alone or more than two share. They
 * are known exactly; nothing thin can slip through between samples.
 */
#ifndef RL_REFERENCE_SILHOUETTE_H
#define RL_REFERENCE_SILHOUETTE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "scene/mesh.h"

struct rl_mesh_edge {
    uint32_t a, b;    /* vertices */
    uint32_t face[2]; /* the same twice: a border, or shared by more than two */
};

struct rl_mesh_edges {
    const struct rl_mesh *mesh; /* must outlive it */
    size_t n_edges, n_borders;  /* borders come first */
    struct rl_mesh_edge *edge;
    double *plane
        [4]; /* of each triangle: P lies in front where x, y, z of P times the first three exceed the fourth */
};

int rl_mesh_edges_make(struct rl_mesh_edges *edges, const struct rl_mesh *mesh, struct rl_error *error);
void rl_mesh_edges_clear(struct rl_mesh_edges *edges);

/* The indices of the edges on the silhouette from P; room for n_edges in `found` and for the mesh's triangles in `facing`, which
 * is scratch. Returns how many. */
size_t rl_mesh_silhouette(uint32_t *found, unsigned char *facing, const struct rl_mesh_edges *edges,
                          rl_vec3 P);

#endif
