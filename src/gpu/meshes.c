/* Meshes on the GPU: vertices and indices as they are, or, for triangles that are shaded as a whole, with a last vertex of its own for each
 * triangle, which carries what is shaded. */
#include "gpu/meshes.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Attributes of a vertex, in the order of the shaders' locations; the last two are of facets alone. */
enum { POSITION, NORMAL, FACET_CENTRE, FACET_NORMAL, ATTRIBUTES_SMOOTH = 2, ATTRIBUTES = 4 };

/* What is uploaded: `n_attributes` vectors a vertex, three indices a triangle. */
struct arrays {
    float (*attribute)[3];
    uint32_t (*triangle)[3];
    size_t n_attributes, n_vertices, n_triangles;
};

static void clear(struct arrays *a)
{
    free(a->attribute);
    free(a->triangle);
}

static float *attribute(const struct arrays *a, size_t vertex, size_t which)
{
    return a->attribute[vertex * a->n_attributes + which];
}

static void copy_vertex(struct arrays *a, size_t to, const struct rl_mesh *mesh, size_t from)
{
    memcpy(attribute(a, to, POSITION), mesh->position[from], sizeof mesh->position[from]);
    memcpy(attribute(a, to, NORMAL), mesh->normal[from], sizeof mesh->normal[from]);
}

static int allocate(struct arrays *a, const struct rl_mesh *mesh, size_t n_attributes, size_t most_vertices,
                    struct rl_error *error)
{
    *a = (struct arrays){.n_attributes = n_attributes,
                         .n_vertices = mesh->n_vertices,
                         .n_triangles = mesh->n_triangles,
                         .attribute = calloc(most_vertices * n_attributes, sizeof *a->attribute),
                         .triangle = malloc(mesh->n_triangles * sizeof *a->triangle)};
    if (!a->attribute || !a->triangle) {
        clear(a);
        return rl_fail_memory(error, "vertices");
    }
    for (size_t i = 0; i < mesh->n_vertices; i++)
        copy_vertex(a, i, mesh, i);
    memcpy(a->triangle, mesh->triangle, mesh->n_triangles * sizeof *a->triangle);
    return RL_OK;
}

/* Turns the triangle, if that lets its last vertex be one that is no other's last yet; else that vertex is doubled. So hardly more vertices
 * are evaluated than there are triangles. */
static void own_last_vertex(struct arrays *a, bool *taken, const struct rl_mesh *mesh, size_t triangle)
{
    const uint32_t *corner = mesh->triangle[triangle];
    uint32_t *turned = a->triangle[triangle];
    for (int i = 2; i < 5; i++) {
        if (taken[corner[i % 3]])
            continue;
        for (int k = 0; k < 3; k++)
            turned[k] = corner[(i + 1 + k) % 3];
        taken[turned[2]] = true;
        return;
    }
    copy_vertex(a, a->n_vertices, mesh, turned[2]);
    turned[2] = (uint32_t)a->n_vertices++;
}

static int make_facets(struct arrays *a, const struct rl_mesh *mesh, struct rl_error *error)
{
    bool *taken = calloc(mesh->n_vertices, sizeof *taken);
    if (!taken)
        return rl_fail_memory(error, "vertices");
    int status = allocate(a, mesh, ATTRIBUTES, mesh->n_vertices + mesh->n_triangles, error);
    for (size_t t = 0; t < mesh->n_triangles && status == RL_OK; t++) {
        own_last_vertex(a, taken, mesh, t);
        rl_vec3 centroid, normal;
        rl_mesh_facet(mesh, t, &centroid, &normal);
        const rl_vec3 from[2] = {centroid, normal};
        for (size_t k = 0; k < 2; k++) {
            float *to = attribute(a, a->triangle[t][2], FACET_CENTRE + k);
            to[0] = (float)from[k].x;
            to[1] = (float)from[k].y;
            to[2] = (float)from[k].z;
        }
    }
    free(taken);
    return status;
}

static int upload(struct rl_gpu_object *object, struct rl_gl *gl, const struct arrays *a, size_t *bytes,
                  struct rl_error *error)
{
    const size_t stride = a->n_attributes * sizeof *a->attribute;
    const size_t vertex_bytes = a->n_vertices * stride, index_bytes = a->n_triangles * sizeof *a->triangle;
    gl->GenVertexArrays(1, &object->vertex_array);
    gl->GenBuffers(1, &object->vertex_buffer);
    gl->GenBuffers(1, &object->index_buffer);
    gl->BindVertexArray(object->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, object->vertex_buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)vertex_bytes, a->attribute, GL_STATIC_DRAW);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, object->index_buffer);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)index_bytes, a->triangle, GL_STATIC_DRAW);
    for (GLuint i = 0; i < a->n_attributes; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, (GLsizei)stride,
                                (const void *)(i * sizeof *a->attribute));
    }
    object->n_indices = (GLsizei)(3 * a->n_triangles);
    *bytes += vertex_bytes + index_bytes;
    return rl_gl_check(gl, "uploading a mesh", error);
}

int rl_mesh_upload(struct rl_gpu_object *object, struct rl_gl *gl, const struct rl_mesh *mesh, bool facets,
                   size_t *bytes, struct rl_error *error)
{
    struct arrays a = {0};
    int status = facets ? make_facets(&a, mesh, error)
                        : allocate(&a, mesh, ATTRIBUTES_SMOOTH, mesh->n_vertices, error);
    if (status != RL_OK)
        return status;
    status = upload(object, gl, &a, bytes, error);
    clear(&a);
    return status;
}
