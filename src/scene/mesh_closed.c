/* Whether a mesh is closed (see mesh.h): its edges, sorted, pair off. */
#include <stdlib.h>
#include <string.h>

#include "scene/mesh.h"

/* Numbers for vertices, the same for those at one position. */
struct place {
    float at[3];
    uint32_t vertex;
};

/* From the lower of two numbers to the higher: +1, the other way: -1. */
struct edge {
    uint32_t low, high;
    int way;
};

static int compare_places(const void *a, const void *b)
{
    const struct place *p = a, *q = b;
    for (int c = 0; c < 3; c++)
        if (p->at[c] != q->at[c])
            return p->at[c] < q->at[c] ? -1 : 1;
    return 0;
}

static int compare_edges(const void *a, const void *b)
{
    const struct edge *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    return p->high < q->high ? -1 : p->high > q->high;
}

static void number_vertices(uint32_t *number, struct place *place, const struct rl_mesh *mesh)
{
    for (size_t i = 0; i < mesh->n_vertices; i++) {
        place[i].vertex = (uint32_t)i;
        memcpy(place[i].at, mesh->position[i], sizeof place[i].at);
    }
    qsort(place, mesh->n_vertices, sizeof *place, compare_places);
    uint32_t n = 0;
    for (size_t i = 0; i < mesh->n_vertices; i++) {
        n += i > 0 && compare_places(&place[i - 1], &place[i]) != 0;
        number[place[i].vertex] = n;
    }
}

static size_t list_edges(struct edge *edge, const uint32_t *number, const struct rl_mesh *mesh)
{
    size_t n = 0;
    for (size_t t = 0; t < mesh->n_triangles; t++) {
        uint32_t v[3];
        for (int k = 0; k < 3; k++)
            v[k] = number[mesh->triangle[t][k]];
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
            continue;
        for (int k = 0; k < 3; k++) {
            uint32_t a = v[k], b = v[(k + 1) % 3];
            edge[n++] = a < b ? (struct edge){a, b, 1} : (struct edge){b, a, -1};
        }
    }
    qsort(edge, n, sizeof *edge, compare_edges);
    return n;
}

int rl_mesh_closed(bool *closed, const struct rl_mesh *mesh, struct rl_error *error)
{
    uint32_t *number = calloc(mesh->n_vertices + 1, sizeof *number);
    struct place *place = calloc(mesh->n_vertices + 1, sizeof *place);
    struct edge *edge = calloc(3 * mesh->n_triangles + 1, sizeof *edge);
    int status = number && place && edge ? RL_OK : rl_fail_memory(error, "a mesh's edges");
    if (status == RL_OK) {
        number_vertices(number, place, mesh);
        size_t n = list_edges(edge, number, mesh);
        *closed = n > 0;
        for (size_t i = 0, end; i < n; i = end) {
            int ways = 0;
            for (end = i; end < n && compare_edges(&edge[i], &edge[end]) == 0; end++)
                ways += edge[end].way;
            *closed = *closed && ways == 0;
        }
    }
    free(number);
    free(place);
    free(edge);
    return status;
}
