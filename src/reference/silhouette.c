/* Edges of a mesh and its silhouettes (see silhouette.h). */
#include "reference/silhouette.h"

#include <stdlib.h>
#include <string.h>

/* Vertices that lie at one place are one: meshes double them where normals or textures break. */
struct place {
    float position[3];
    uint32_t vertex;
};

static int by_place(const void *a, const void *b)
{
    const struct place *p = a, *q = b;
    for (int i = 0; i < 3; i++)
        if (p->position[i] != q->position[i])
            return p->position[i] < q->position[i] ? -1 : 1;
    return (p->vertex > q->vertex) - (p->vertex < q->vertex);
}

static bool same_place(const struct place *p, const struct place *q)
{
    return p->position[0] == q->position[0] && p->position[1] == q->position[1] &&
           p->position[2] == q->position[2];
}

/* first[v]: the first vertex at the place of v. */
static void weld(uint32_t *first, struct place *place, const struct rl_mesh *mesh)
{
    for (size_t i = 0; i < mesh->n_vertices; i++) {
        memcpy(place[i].position, mesh->position[i], sizeof place[i].position);
        place[i].vertex = (uint32_t)i;
    }
    qsort(place, mesh->n_vertices, sizeof *place, by_place);
    for (size_t i = 0, start = 0; i < mesh->n_vertices; i++) {
        if (!same_place(&place[i], &place[start]))
            start = i;
        first[place[i].vertex] = place[start].vertex;
    }
}

static int by_ends(const void *a, const void *b)
{
    const struct rl_mesh_edge *e = a, *f = b;
    if (e->a != f->a)
        return e->a < f->a ? -1 : 1;
    if (e->b != f->b)
        return e->b < f->b ? -1 : 1;
    return (e->face[0] > f->face[0]) - (e->face[0] < f->face[0]);
}

static int borders_first(const void *a, const void *b)
{
    const struct rl_mesh_edge *e = a, *f = b;
    int inner_e = e->face[0] != e->face[1], inner_f = f->face[0] != f->face[1];
    return inner_e != inner_f ? inner_e - inner_f : by_ends(a, b);
}

/* Every triangle's three edges, one each, but for triangles that two corners at one place have flattened. */
static size_t list_edges(struct rl_mesh_edge *edge, const struct rl_mesh *mesh, const uint32_t *first)
{
    size_t n = 0;
    for (size_t i = 0; i < mesh->n_triangles; i++) {
        uint32_t corner[3];
        for (int j = 0; j < 3; j++)
            corner[j] = first[mesh->triangle[i][j]];
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
            continue;
        for (int j = 0; j < 3; j++) {
            uint32_t a = corner[j], b = corner[(j + 1) % 3];
            edge[n++] = (struct rl_mesh_edge){a < b ? a : b, a < b ? b : a, {(uint32_t)i, (uint32_t)i}};
        }
    }
    return n;
}

/* Joins what two triangles share. */
static size_t join_edges(struct rl_mesh_edge *edge, size_t n)
{
    size_t kept = 0;
    qsort(edge, n, sizeof *edge, by_ends);
    for (size_t i = 0, next; i < n; i = next) {
        for (next = i + 1; next < n && edge[next].a == edge[i].a && edge[next].b == edge[i].b;)
            next++;
        struct rl_mesh_edge joined = edge[i];
        joined.face[1] = next - i == 2 ? edge[i + 1].face[0] : joined.face[0];
        edge[kept++] = joined;
    }
    qsort(edge, kept, sizeof *edge, borders_first);
    return kept;
}

static rl_vec3 vertex(const struct rl_mesh *mesh, uint32_t i)
{
    return v3(mesh->position[i][0], mesh->position[i][1], mesh->position[i][2]);
}

static void set_planes(struct rl_mesh_edges *edges)
{
    const struct rl_mesh *mesh = edges->mesh;
    for (size_t i = 0; i < mesh->n_triangles; i++) {
        const uint32_t *corner = mesh->triangle[i];
        rl_vec3 first = vertex(mesh, corner[0]);
        rl_vec3 normal =
            v3_cross(v3_sub(vertex(mesh, corner[1]), first), v3_sub(vertex(mesh, corner[2]), first));
        edges->plane[0][i] = normal.x;
        edges->plane[1][i] = normal.y;
        edges->plane[2][i] = normal.z;
        edges->plane[3][i] = v3_dot(normal, first);
    }
}

int rl_mesh_edges_make(struct rl_mesh_edges *edges, const struct rl_mesh *mesh, struct rl_error *error)
{
    size_t n = mesh->n_triangles;
    *edges = (struct rl_mesh_edges){.mesh = mesh};
    struct place *place = calloc(mesh->n_vertices + 1, sizeof *place);
    uint32_t *first = calloc(mesh->n_vertices + 1, sizeof *first);
    edges->edge = calloc(3 * n + 1, sizeof *edges->edge);
    edges->plane[0] = calloc(4 * n + 1, sizeof(double));
    if (!place || !first || !edges->edge || !edges->plane[0]) {
        free(place);
        free(first);
        rl_mesh_edges_clear(edges);
        return rl_fail_memory(error, "the edges of a mesh");
    }
    for (int i = 1; i < 4; i++)
        edges->plane[i] = edges->plane[0] + (size_t)i * n;
    weld(first, place, mesh);
    edges->n_edges = join_edges(edges->edge, list_edges(edges->edge, mesh, first));
    while (edges->n_borders < edges->n_edges &&
           edges->edge[edges->n_borders].face[0] == edges->edge[edges->n_borders].face[1])
        edges->n_borders++;
    set_planes(edges);
    free(place);
    free(first);
    return RL_OK;
}

void rl_mesh_edges_clear(struct rl_mesh_edges *edges)
{
    free(edges->edge);
    free(edges->plane[0]);
    *edges = (struct rl_mesh_edges){0};
}

size_t rl_mesh_silhouette(uint32_t *found, unsigned char *facing, const struct rl_mesh_edges *edges,
                          rl_vec3 P)
{
    const double *x = edges->plane[0], *y = edges->plane[1], *z = edges->plane[2], *w = edges->plane[3];
    for (size_t i = 0; i < edges->mesh->n_triangles; i++)
        facing[i] = x[i] * P.x + y[i] * P.y + z[i] * P.z > w[i];
    size_t n = 0;
    for (size_t i = 0; i < edges->n_borders; i++)
        found[n++] = (uint32_t)i;
    for (size_t i = edges->n_borders; i < edges->n_edges; i++) {
        found[n] = (uint32_t)i;
        n += facing[edges->edge[i].face[0]] != facing[edges->edge[i].face[1]];
    }
    return n;
}
