/* Triangles that are shaded as a whole, as OpenGL draws them: each has a last vertex of its own, which carries what is shaded. */
#include <stdlib.h>

#include "scene/mesh.h"

/* Turns the triangle, if that lets its last vertex be one that is no other's last yet: whether it did. */
static bool turn(uint32_t turned[3], bool *taken, const uint32_t corner[3])
{
    for (int i = 2; i < 5; i++) {
        if (taken[corner[i % 3]])
            continue;
        for (int k = 0; k < 3; k++)
            turned[k] = corner[(i + 1 + k) % 3];
        taken[turned[2]] = true;
        return true;
    }
    return false;
}

int rl_mesh_own_last(size_t *n_twins, uint32_t (*triangle)[3], uint32_t *twin, const struct rl_mesh *mesh,
                     struct rl_error *error)
{
    bool *taken = calloc(mesh->n_vertices + 1, sizeof *taken);
    *n_twins = 0;
    if (!taken)
        return rl_fail_memory(error, "vertices");
    for (size_t t = 0; t < mesh->n_triangles; t++) {
        const uint32_t *corner = mesh->triangle[t];
        uint32_t turned[3] = {corner[0], corner[1], corner[2]};
        if (!turn(turned, taken, corner)) {
            if (twin)
                twin[*n_twins] = corner[2];
            turned[2] = (uint32_t)(mesh->n_vertices + (*n_twins)++);
        }
        for (int k = 0; triangle && k < 3; k++)
            triangle[t][k] = turned[k];
    }
    free(taken);
    return RL_OK;
}
