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
    if (!a->attribute || !a->triangle)
        return rl_fail_memory(error, "vertices");
    for (size_t i = 0; i < mesh->n_vertices; i++)
        copy_vertex(a, i, mesh, i);
    memcpy(a->triangle, mesh->triangle, mesh->n_triangles * sizeof *a->triangle);
    return RL_OK;
}

static int make_facets(struct arrays *a, const struct rl_mesh *mesh, struct rl_error *error)
{
    size_t n_twins = 0;
    uint32_t *twin = malloc((mesh->n_triangles + 1) * sizeof *twin);
    if (!twin)
        return rl_fail_memory(error, "vertices");
    int status = allocate(a, mesh, ATTRIBUTES, mesh->n_vertices + mesh->n_triangles, error);
    if (status == RL_OK)
        status = rl_mesh_own_last(&n_twins, a->triangle, twin, mesh, error);
    for (size_t i = 0; i < n_twins; i++)
        copy_vertex(a, a->n_vertices++, mesh, twin[i]);
    for (size_t t = 0; t < mesh->n_triangles && status == RL_OK; t++) {
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
    free(twin);
    return status;
}

/* Those of one part stand in the buffer of it, vertex by vertex. */
static const enum rl_mesh_part part_of[ATTRIBUTES] = {
    [POSITION] = RL_MESH_POSITIONS,
    [NORMAL] = RL_MESH_NORMALS,
    [FACET_CENTRE] = RL_MESH_POSITIONS,
    [FACET_NORMAL] = RL_MESH_POSITIONS,
};

static size_t attributes_of(const struct arrays *a, enum rl_mesh_part part)
{
    size_t n = 0;
    for (size_t i = 0; i < a->n_attributes; i++)
        n += part_of[i] == part;
    return n;
}

static int upload_vectors(GLuint buffer, struct rl_gl *gl, const struct arrays *a, enum rl_mesh_part part,
                          size_t *bytes, struct rl_error *error)
{
    size_t size = a->n_vertices * attributes_of(a, part) * sizeof *a->attribute, n = 0;
    float(*vector)[3] = malloc(size);
    if (!vector)
        return rl_fail_memory(error, "vertices");
    for (size_t v = 0; v < a->n_vertices; v++)
        for (size_t i = 0; i < a->n_attributes; i++)
            if (part_of[i] == part)
                memcpy(vector[n++], attribute(a, v, i), sizeof *vector);
    gl->BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)size, vector, GL_STATIC_DRAW);
    *bytes += size;
    free(vector);
    return RL_OK;
}

static void upload_triangles(GLuint buffer, struct rl_gl *gl, const struct arrays *a, size_t *bytes)
{
    size_t size = a->n_triangles * sizeof *a->triangle;
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)size, a->triangle, GL_STATIC_DRAW);
    *bytes += size;
}

static void point_to(const struct rl_gpu_object *object, const struct rl_gl *gl, const struct arrays *a)
{
    size_t before[RL_MESH_PARTS] = {0};
    for (size_t i = 0; i < a->n_attributes; i++) {
        enum rl_mesh_part part = part_of[i];
        gl->BindBuffer(GL_ARRAY_BUFFER, object->part[part]);
        gl->EnableVertexAttribArray((GLuint)i);
        gl->VertexAttribPointer((GLuint)i, 3, GL_FLOAT, GL_FALSE,
                                (GLsizei)(attributes_of(a, part) * sizeof *a->attribute),
                                (const void *)(before[part]++ * sizeof *a->attribute));
    }
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, object->part[RL_MESH_TRIANGLES]);
}

static int upload(struct rl_gpu_object *object, struct rl_gl *gl, const struct arrays *a, size_t *bytes,
                  struct rl_error *error)
{
    int status = RL_OK;
    gl->GenVertexArrays(1, &object->vertex_array);
    gl->BindVertexArray(object->vertex_array);
    for (int k = 0; k < RL_MESH_PARTS && status == RL_OK; k++) {
        if (object->part[k])
            continue;
        gl->GenBuffers(1, &object->part[k]);
        if (k == RL_MESH_TRIANGLES)
            upload_triangles(object->part[k], gl, a, bytes);
        else
            status = upload_vectors(object->part[k], gl, a, (enum rl_mesh_part)k, bytes, error);
    }
    if (status != RL_OK)
        return status;
    point_to(object, gl, a);
    object->n_indices = (GLsizei)(3 * a->n_triangles);
    return rl_gl_check(gl, "uploading a mesh", error);
}

int rl_mesh_upload(struct rl_gpu_object *object, struct rl_gl *gl, const struct rl_mesh *mesh, bool facets,
                   size_t *bytes, struct rl_error *error)
{
    struct arrays a = {0};
    int status = facets ? make_facets(&a, mesh, error)
                        : allocate(&a, mesh, ATTRIBUTES_SMOOTH, mesh->n_vertices, error);
    if (status == RL_OK)
        status = upload(object, gl, &a, bytes, error);
    clear(&a);
    return status;
}
