/* From an assimp scene to one mesh. assimp reads through the small file system below, which hashes what it
 * hands out. */
#include "scene/mesh_import.h"

#include <assimp/cfileio.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <float.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "base/hash.h"
#include "scene/assimp.h"

/* ---- Files for assimp ---- */

enum { FILES_MAX = 64 };

struct cached {
    char *path;
    const char *data;
    char *owned; /* NULL for the file that the caller read */
    size_t size;
};

/* Importers open a file once each to see whether it is theirs; it is read and hashed once. */
struct cache {
    struct cached file[FILES_MAX];
    size_t n;
    uint64_t hash;
};

struct cursor {
    const struct cached *file;
    size_t at;
};

static const struct cached *cache_add(struct cache *cache, const char *path, const char *data, char *owned,
                                      size_t size)
{
    char *name = strdup(path);
    if (!name || cache->n == FILES_MAX) {
        free(name);
        free(owned);
        return NULL;
    }
    cache->hash = rl_hash_bytes(cache->hash, data, size);
    cache->file[cache->n] = (struct cached){.path = name, .data = data, .owned = owned, .size = size};
    return &cache->file[cache->n++];
}

static const struct cached *cache_get(struct cache *cache, const char *path)
{
    for (size_t i = 0; i < cache->n; i++)
        if (strcmp(cache->file[i].path, path) == 0)
            return &cache->file[i];
    char *data;
    size_t size;
    return rl_file_read(&data, &size, path, NULL) == RL_OK ? cache_add(cache, path, data, data, size) : NULL;
}

static void cache_clear(struct cache *cache)
{
    for (size_t i = 0; i < cache->n; i++) {
        free(cache->file[i].path);
        free(cache->file[i].owned);
    }
}

static size_t file_read(struct aiFile *file, char *to, size_t size, size_t count)
{
    struct cursor *cursor = (struct cursor *)file->UserData;
    size_t left = size ? (cursor->file->size - cursor->at) / size : 0;
    size_t n = count < left ? count : left;
    memcpy(to, cursor->file->data + cursor->at, n * size);
    cursor->at += n * size;
    return n;
}

static size_t file_write(struct aiFile *file, const char *from, size_t size, size_t count)
{
    (void)file, (void)from, (void)size, (void)count;
    return 0;
}

static size_t file_tell(struct aiFile *file)
{
    return ((struct cursor *)file->UserData)->at;
}

static size_t file_size(struct aiFile *file)
{
    return ((struct cursor *)file->UserData)->file->size;
}

static aiReturn file_seek(struct aiFile *file, size_t offset, enum aiOrigin origin)
{
    struct cursor *cursor = (struct cursor *)file->UserData;
    size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? cursor->at : cursor->file->size;
    size_t at = base + offset; /* a negative offset wraps round to the right place */
    if (at > cursor->file->size)
        return aiReturn_FAILURE;
    cursor->at = at;
    return aiReturn_SUCCESS;
}

static void file_flush(struct aiFile *file)
{
    (void)file;
}

static struct aiFile *file_open(struct aiFileIO *io, const char *path, const char *mode)
{
    if (strpbrk(mode, "wa+"))
        return NULL;
    const struct cached *cached = cache_get((struct cache *)io->UserData, path);
    struct aiFile *file = cached ? malloc(sizeof *file) : NULL;
    struct cursor *cursor = file ? malloc(sizeof *cursor) : NULL;
    if (!cursor) {
        free(file);
        return NULL;
    }
    *cursor = (struct cursor){.file = cached};
    *file = (struct aiFile){
        .ReadProc = file_read,
        .WriteProc = file_write,
        .TellProc = file_tell,
        .FileSizeProc = file_size,
        .SeekProc = file_seek,
        .FlushProc = file_flush,
        .UserData = (aiUserData)cursor,
    };
    return file;
}

static void file_close(struct aiFileIO *io, struct aiFile *file)
{
    (void)io;
    free(file->UserData);
    free(file);
}

/* ---- Conversion ---- */

struct matrix {
    double m[3][4];
};

static struct matrix multiply(const struct matrix *parent, const struct aiMatrix4x4 *t)
{
    const double child[4][4] = {{t->a1, t->a2, t->a3, t->a4},
                                {t->b1, t->b2, t->b3, t->b4},
                                {t->c1, t->c2, t->c3, t->c4},
                                {0.0, 0.0, 0.0, 1.0}};
    struct matrix product = {0};
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 4; c++)
            for (int k = 0; k < 4; k++)
                product.m[r][c] += parent->m[r][k] * child[k][c];
    return product;
}

static void count(const struct aiScene *scene, const struct aiNode *node, size_t *n_vertices,
                  size_t *n_triangles)
{
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        const struct aiMesh *mesh = scene->mMeshes[node->mMeshes[i]];
        *n_vertices += mesh->mNumVertices;
        for (unsigned f = 0; f < mesh->mNumFaces; f++)
            *n_triangles += mesh->mFaces[f].mNumIndices == 3;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++)
        count(scene, node->mChildren[i], n_vertices, n_triangles);
}

static rl_vec3 row(const struct matrix *a, int r)
{
    return v3(a->m[r][0], a->m[r][1], a->m[r][2]);
}

static void store(float to[3], rl_vec3 from)
{
    to[0] = (float)from.x;
    to[1] = (float)from.y;
    to[2] = (float)from.z;
}

static int check_finite(size_t i, rl_vec3 p, struct rl_error *error)
{
    if (fabs(p.x) <= (double)FLT_MAX && fabs(p.y) <= (double)FLT_MAX && fabs(p.z) <= (double)FLT_MAX)
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "found vertex %zu at (%g, %g, %g), expected finite numbers", i, p.x,
                   p.y, p.z);
}

static int add_vertices(struct rl_mesh *to, const struct aiMesh *from, const struct matrix *a,
                        struct rl_error *error)
{
    /* Normals go with the cofactors, which are the inverse transpose times the determinant. */
    rl_vec3 c0 = v3_cross(row(a, 1), row(a, 2)), c1 = v3_cross(row(a, 2), row(a, 0)),
            c2 = v3_cross(row(a, 0), row(a, 1));
    double sign = v3_dot(row(a, 0), c0) < 0.0 ? -1.0 : 1.0;
    for (unsigned i = 0; i < from->mNumVertices; i++) {
        rl_vec3 p = v3(from->mVertices[i].x, from->mVertices[i].y, from->mVertices[i].z);
        rl_vec3 placed = v3(v3_dot(row(a, 0), p) + a->m[0][3], v3_dot(row(a, 1), p) + a->m[1][3],
                            v3_dot(row(a, 2), p) + a->m[2][3]);
        if (check_finite(i, p, error) != RL_OK || check_finite(i, placed, error) != RL_OK)
            return RL_ERR_INPUT;
        store(to->position[to->n_vertices + i], placed);
        if (from->mNormals) {
            rl_vec3 n = v3(from->mNormals[i].x, from->mNormals[i].y, from->mNormals[i].z);
            n = v3_scale(sign, v3(v3_dot(c0, n), v3_dot(c1, n), v3_dot(c2, n)));
            store(to->normal[to->n_vertices + i], v3_normalize(n));
        }
    }
    return RL_OK;
}

static int add_mesh(struct rl_mesh *to, const struct aiMesh *from, const struct matrix *a,
                    struct rl_error *error)
{
    bool mirrored = v3_dot(row(a, 0), v3_cross(row(a, 1), row(a, 2))) < 0.0;
    if (add_vertices(to, from, a, error) != RL_OK)
        return RL_ERR_INPUT;
    for (unsigned f = 0; f < from->mNumFaces; f++) {
        const struct aiFace *face = &from->mFaces[f];
        if (face->mNumIndices != 3)
            continue;
        for (int i = 0; i < 3; i++) {
            unsigned index = face->mIndices[mirrored ? 2 - i : i];
            if (index >= from->mNumVertices)
                return rl_fail(error, RL_ERR_INPUT,
                               "found the vertex index %u in a mesh of %u vertices, expected a smaller one",
                               index, from->mNumVertices);
            to->triangle[to->n_triangles][i] = (uint32_t)(to->n_vertices + index);
        }
        to->n_triangles++;
    }
    to->n_vertices += from->mNumVertices;
    return RL_OK;
}

static int add_node(struct rl_mesh *to, const struct aiScene *scene, const struct aiNode *node,
                    const struct matrix *parent, struct rl_error *error)
{
    struct matrix a = multiply(parent, &node->mTransformation);
    int status = RL_OK;
    for (unsigned i = 0; i < node->mNumMeshes && status == RL_OK; i++)
        status = add_mesh(to, scene->mMeshes[node->mMeshes[i]], &a, error);
    for (unsigned i = 0; i < node->mNumChildren && status == RL_OK; i++)
        status = add_node(to, scene, node->mChildren[i], &a, error);
    return status;
}

static bool usable(const float n[3])
{
    float square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    return square > 0.5f && square < 2.0f;
}

static rl_vec3 position(const struct rl_mesh *mesh, size_t triangle, int i)
{
    const float *p = mesh->position[mesh->triangle[triangle][i]];
    return v3(p[0], p[1], p[2]);
}

/* Normals that the file lacks, or has as 0 or nan, become the mean of the faces round the vertex, by area;
 * +y where there is none. */
static int complete_normals(struct rl_mesh *mesh, struct rl_error *error)
{
    rl_vec3 *sum = calloc(mesh->n_vertices, sizeof *sum);
    if (!sum)
        return rl_fail_memory(error, "normals");
    bool has_area = false;
    for (size_t t = 0; t < mesh->n_triangles; t++) {
        rl_vec3 a = position(mesh, t, 0);
        rl_vec3 n = v3_cross(v3_sub(position(mesh, t, 1), a), v3_sub(position(mesh, t, 2), a));
        has_area = has_area || v3_dot(n, n) > 0.0;
        for (int i = 0; i < 3; i++)
            sum[mesh->triangle[t][i]] = v3_add(sum[mesh->triangle[t][i]], n);
    }
    for (size_t i = 0; i < mesh->n_vertices; i++)
        if (!usable(mesh->normal[i])) {
            rl_vec3 n = v3_normalize(sum[i]);
            store(mesh->normal[i], v3_length(n) > 0.5 ? n : v3(0.0, 1.0, 0.0));
        }
    free(sum);
    return has_area ? RL_OK
                    : rl_fail(error, RL_ERR_INPUT, "found only triangles without area, expected a mesh");
}

static int convert(struct rl_mesh *mesh, const struct aiScene *scene, struct rl_error *error)
{
    static const struct matrix identity = {
        {{1.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}}};
    size_t n_vertices = 0, n_triangles = 0;
    if (scene->mRootNode)
        count(scene, scene->mRootNode, &n_vertices, &n_triangles);
    if (n_triangles == 0)
        return rl_fail(error, RL_ERR_INPUT, "found no triangles, expected a mesh");
    if (n_vertices > UINT32_MAX)
        return rl_fail(error, RL_ERR_INPUT, "found %zu vertices, expected less than 2^32", n_vertices);
    int status = rl_mesh_allocate(mesh, n_vertices, n_triangles, error);
    if (status != RL_OK)
        return status;
    mesh->n_vertices = mesh->n_triangles = 0; /* they count up again while the mesh is filled */
    status = add_node(mesh, scene, scene->mRootNode, &identity, error);
    if (status == RL_OK)
        status = complete_normals(mesh, error);
    if (status != RL_OK)
        rl_mesh_clear(mesh);
    return status;
}

/* What assimp could do about bad data is not asked for: it would drop it without a word. */
static const struct aiScene *import(const struct rl_assimp *assimp, struct aiFileIO *io, const char *path)
{
    unsigned flags = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_RemoveComponent |
                     aiProcess_JoinIdenticalVertices;
    struct aiPropertyStore *properties = assimp->create_properties();
    if (!properties)
        return NULL;
    assimp->set_integer(properties, AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    /* Vertices that differ in these alone are one vertex here. */
    assimp->set_integer(properties, AI_CONFIG_PP_RVC_FLAGS,
                        aiComponent_TEXCOORDS | aiComponent_COLORS | aiComponent_TANGENTS_AND_BITANGENTS |
                            aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS | aiComponent_TEXTURES |
                            aiComponent_LIGHTS | aiComponent_CAMERAS | aiComponent_MATERIALS);
    const struct aiScene *scene = assimp->import_file(path, flags, io, properties);
    assimp->release_properties(properties);
    return scene;
}

int rl_mesh_import(struct rl_mesh *mesh, uint64_t *hash, const char *path, const char *data, size_t size,
                   struct rl_error *error)
{
    *mesh = (struct rl_mesh){0};
    struct rl_assimp assimp;
    int status = rl_assimp_load(&assimp, error);
    if (status != RL_OK)
        return status;
    struct cache cache = {.hash = *hash};
    struct aiFileIO io = {.OpenProc = file_open, .CloseProc = file_close, .UserData = (aiUserData)&cache};
    if (!cache_add(&cache, path, data, NULL, size))
        return rl_fail_memory(error, path);
    const struct aiScene *scene = import(&assimp, &io, path);
    if (scene)
        status = convert(mesh, scene, error);
    else
        status = rl_fail(error, RL_ERR_INPUT, "found what assimp cannot read (%.300s), expected a mesh",
                         assimp.error_string());
    if (scene)
        assimp.release(scene);
    *hash = cache.hash;
    cache_clear(&cache);
    return status == RL_OK ? RL_OK : rl_fail_prefix(error, "%s", path);
}
