/* Storage and bounds of triangle meshes (see mesh.h). */
#include "scene/mesh.h"

#include <stdlib.h>
#include <string.h>

void rl_mesh_clear(struct rl_mesh *mesh)
{
    free(mesh->position);
    free(mesh->normal);
    free(mesh->triangle);
    *mesh = (struct rl_mesh){0};
}

int rl_mesh_allocate(struct rl_mesh *mesh, size_t n_vertices, size_t n_triangles, struct rl_error *error)
{
    *mesh = (struct rl_mesh){
        .n_vertices = n_vertices,
        .n_triangles = n_triangles,
        .position = calloc(n_vertices ? n_vertices : 1, sizeof *mesh->position),
        .normal = calloc(n_vertices ? n_vertices : 1, sizeof *mesh->normal),
        .triangle = calloc(n_triangles ? n_triangles : 1, sizeof *mesh->triangle),
    };
    if (mesh->position && mesh->normal && mesh->triangle)
        return RL_OK;
    rl_mesh_clear(mesh);
    return rl_fail_memory(error, "a mesh");
}

static rl_vec3 vertex(const struct rl_mesh *mesh, size_t i)
{
    return v3(mesh->position[i][0], mesh->position[i][1], mesh->position[i][2]);
}

void rl_mesh_bounds(const struct rl_mesh *mesh, rl_vec3 *low, rl_vec3 *high, rl_vec3 *centre, double *radius)
{
    *low = *high = *centre = v3(0.0, 0.0, 0.0);
    *radius = 0.0;
    if (mesh->n_vertices == 0)
        return;
    float least[3], most[3];
    memcpy(least, mesh->position[0], sizeof least);
    memcpy(most, mesh->position[0], sizeof most);
    for (size_t i = 1; i < mesh->n_vertices; i++)
        for (int c = 0; c < 3; c++) { /* not fmin: that is a call for each */
            float x = mesh->position[i][c];
            least[c] = x < least[c] ? x : least[c];
            most[c] = x > most[c] ? x : most[c];
        }
    *low = v3(least[0], least[1], least[2]);
    *high = v3(most[0], most[1], most[2]);
    *centre = v3_scale(0.5, v3_add(*low, *high));
    double square = 0.0;
    for (size_t i = 0; i < mesh->n_vertices; i++) {
        rl_vec3 d = v3_sub(vertex(mesh, i), *centre);
        square = v3_dot(d, d) > square ? v3_dot(d, d) : square;
    }
    *radius = sqrt(square);
}

size_t rl_mesh_back_faces(const struct rl_mesh *mesh, rl_vec3 eye)
{
    size_t n = 0;
    for (size_t i = 0; i < mesh->n_triangles; i++) {
        rl_vec3 first = vertex(mesh, mesh->triangle[i][0]);
        rl_vec3 a = v3_sub(vertex(mesh, mesh->triangle[i][1]), first);
        rl_vec3 b = v3_sub(vertex(mesh, mesh->triangle[i][2]), first);
        n += !(v3_dot(v3_cross(a, b), v3_sub(eye, first)) > 0.0);
    }
    return n;
}

void rl_mesh_facet(const struct rl_mesh *mesh, size_t triangle, rl_vec3 *centroid, rl_vec3 *normal)
{
    const uint32_t *corner = mesh->triangle[triangle];
    const rl_vec3 a = vertex(mesh, corner[0]), b = vertex(mesh, corner[1]), c = vertex(mesh, corner[2]);
    *centroid = v3_scale(1.0 / 3.0, v3_add(a, v3_add(b, c)));
    *normal = v3_normalize(v3_cross(v3_sub(b, a), v3_sub(c, a)));
}
