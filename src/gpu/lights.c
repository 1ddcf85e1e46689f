/* Buffers with the lights as shaders want them: triangles for environment maps, points, spheres, sources and polygons. Only those that the
 * plan has a use for are made. */
#include <stdlib.h>
#include <string.h>

#include "gpu/scene.h"
#include "gpu/textures.h"
#include "scene/plan_sizes.h"

static void store(float to[3], rl_vec3 v)
{
    to[0] = (float)v.x;
    to[1] = (float)v.y;
    to[2] = (float)v.z;
}

static void store_rgb(float to[3], const double rgb[3])
{
    for (int c = 0; c < 3; c++)
        to[c] = (float)rgb[c];
}

/* Into the buffer, which is made the first time; frees `data`. NULL: there was no memory for it. */
static int upload(struct rl_gpu_scene *gs, GLenum target, GLuint *buffer, void *data, size_t bytes,
                  struct rl_error *error)
{
    struct rl_gl *gl = &gs->gpu->gl;
    if (!data)
        return rl_fail_memory(error, "the lights");
    if (!*buffer)
        gl->GenBuffers(1, buffer);
    gl->BindBuffer(target, *buffer);
    gl->BufferData(target, (GLsizeiptr)bytes, data, GL_STATIC_DRAW);
    gs->counters.bytes_uploaded += bytes;
    free(data);
    return rl_gl_check(gl, "uploading the lights", error);
}

/* ---- Triangles, for environment maps ---- */

struct light_vertex {
    float position[3], radiance[3];
};
_Static_assert(sizeof(struct light_vertex) == RL_BYTES_LIGHT_VERTEX, "as the plan has it");

/* The i-th light of the plan. */
static const struct rl_light *light_of(const struct rl_gpu_scene *gs, size_t i)
{
    return &gs->scene->light[gs->plan->light[i]];
}

static size_t count_vertices(const struct rl_gpu_scene *gs)
{
    size_t n = 0;
    for (size_t i = 0; i < gs->plan->n_lights; i++)
        for (size_t j = 0; j < light_of(gs, i)->n_polygons; j++)
            n += 3 * (size_t)(light_of(gs, i)->polygon[j].n - 2);
    return n;
}

static size_t fill_triangle_fan(struct light_vertex *to, const struct rl_polygon *p, const float texel[3])
{
    size_t n = 0;
    for (int t = 0; t < p->n - 2; t++)
        for (int k = 0; k < 3; k++, n++) {
            store(to[n].position, p->vertex[p->triangle[t][k]]);
            memcpy(to[n].radiance, texel, sizeof to[n].radiance);
        }
    return n;
}

static int fill_triangles(struct rl_gpu_scene *gs, struct rl_error *error)
{
    size_t count = count_vertices(gs), n = 0;
    struct light_vertex *vertex = malloc((count + 1) * sizeof *vertex);
    for (size_t i = 0; i < gs->plan->n_lights && vertex; i++) {
        const struct rl_light *light = light_of(gs, i);
        float texel[3];
        for (int c = 0; c < 3; c++)
            texel[c] =
                rl_texel_nearest(gs->plan->settings.env_format, c, light->radiance[c] / gs->environment_unit);
        for (size_t j = 0; j < light->n_polygons; j++)
            n += fill_triangle_fan(vertex + n, &light->polygon[j], texel);
    }
    gs->lights.n_vertices = (GLsizei)n;
    return upload(gs, GL_ARRAY_BUFFER, &gs->lights.vertex_buffer, vertex, n * sizeof *vertex, error);
}

/* ---- Blocks, as the shaders lay them out (std140, std430) ---- */

struct point_block {
    float position[4], normal[4], radiance[4];
};
struct source_block {
    float at[4], strength[4];
};
struct polygon_block {
    float radiance[4];
    GLint range[4];
};
_Static_assert(sizeof(struct point_block) == RL_BYTES_LIGHT_POINT, "as the plan has it");
_Static_assert(sizeof(struct source_block) == RL_BYTES_LIGHT_SOURCE, "as the plan has it");
_Static_assert(sizeof(struct polygon_block) == RL_BYTES_LIGHT_POLYGON, "as the plan has it");

static int fill_points(struct rl_gpu_scene *gs, struct rl_error *error)
{
    size_t n = gs->plan->n_lights;
    struct point_block *point = calloc(n + 1, sizeof *point);
    for (size_t i = 0; i < n && point; i++) {
        struct rl_point_light p = rl_light_as_point(light_of(gs, i));
        store(point[i].position, p.position);
        point[i].position[3] = (float)p.area;
        store(point[i].normal, p.normal);
        store_rgb(point[i].radiance, p.radiance);
    }
    return upload(gs, GL_UNIFORM_BUFFER, &gs->lights.points, point, n * sizeof *point, error);
}

static int fill_spheres(struct rl_gpu_scene *gs, struct rl_error *error)
{
    size_t n = gs->plan->n_lights;
    float(*sphere)[4] = calloc(n + 1, sizeof *sphere);
    for (size_t i = 0; i < n && sphere; i++) {
        store(sphere[i], light_of(gs, i)->centre);
        sphere[i][3] = (float)light_of(gs, i)->radius;
    }
    return upload(gs, GL_UNIFORM_BUFFER, &gs->lights.spheres, sphere, n * sizeof *sphere, error);
}

static int fill_sources(struct rl_gpu_scene *gs, struct rl_error *error)
{
    size_t n = gs->plan->n_sources;
    struct source_block *block = calloc(n + 1, sizeof *block);
    for (size_t i = 0; i < n && block; i++) {
        const struct rl_source *source = &gs->scene->source[gs->plan->source[i]];
        store(block[i].at, source->at);
        store_rgb(block[i].strength, source->strength);
    }
    return upload(gs, GL_UNIFORM_BUFFER, &gs->lights.sources, block, n * sizeof *block, error);
}

static int fill_polygons(struct rl_gpu_scene *gs, struct rl_error *error)
{
    struct rl_lights seen;
    int status = rl_plan_lights_make(&seen, gs->plan, gs->scene, error);
    size_t n = seen.n_areas, n_vertices = 0;
    for (size_t i = 0; i < n; i++)
        n_vertices += (size_t)seen.area[i].n;
    struct polygon_block *polygon = calloc(n + 1, sizeof *polygon);
    float(*vertex)[4] = calloc(n_vertices + 1, sizeof *vertex);
    size_t first = 0;
    for (size_t i = 0; i < n && polygon && vertex; i++) {
        store_rgb(polygon[i].radiance, seen.area[i].radiance);
        polygon[i].range[0] = (GLint)first;
        polygon[i].range[1] = seen.area[i].n;
        for (int k = 0; k < seen.area[i].n; k++)
            store(vertex[first++], seen.area[i].vertex[k]);
    }
    if (status == RL_OK)
        status =
            upload(gs, GL_SHADER_STORAGE_BUFFER, &gs->lights.polygons, polygon, n * sizeof *polygon, error);
    else
        free(polygon);
    if (status == RL_OK)
        status = upload(gs, GL_SHADER_STORAGE_BUFFER, &gs->lights.polygon_vertices, vertex,
                        n_vertices * sizeof *vertex, error);
    else
        free(vertex);
    rl_scene_lights_clear(&seen);
    return status;
}

/* ---- The whole ---- */

static int (*const fill[RL_BUFFERS])(struct rl_gpu_scene *gs, struct rl_error *error) = {
    [RL_BUFFER_TRIANGLES] = fill_triangles, [RL_BUFFER_POINTS] = fill_points,
    [RL_BUFFER_SPHERES] = fill_spheres,     [RL_BUFFER_SOURCES] = fill_sources,
    [RL_BUFFER_POLYGONS] = fill_polygons,
};

int rl_lights_fill(struct rl_gpu_scene *gs, struct rl_error *error)
{
    int status = RL_OK;
    for (int i = 0; i < RL_BUFFERS && status == RL_OK; i++)
        if (rl_plan_needs(gs->plan, (enum rl_plan_buffer)i))
            status = fill[i](gs, error);
    return status;
}

static int check_number(size_t n, GLint block_bytes, size_t size, const char *what, struct rl_error *error)
{
    size_t limit = (size_t)block_bytes / size;
    return n <= limit
               ? RL_OK
               : rl_fail(error, RL_ERR_INPUT, "%zu %s: the GPU pipeline takes up to %zu", n, what, limit);
}

int rl_lights_make(struct rl_gpu_scene *gs, struct rl_error *error)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    GLint largest = 0;
    gl->GetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &largest);
    int status = RL_OK;
    if (rl_plan_needs(gs->plan, RL_BUFFER_POINTS) || rl_plan_needs(gs->plan, RL_BUFFER_SPHERES))
        status = check_number(gs->plan->n_lights, largest, sizeof(struct point_block),
                              "lights (a mesh is one light)", error);
    if (status == RL_OK && rl_plan_needs(gs->plan, RL_BUFFER_SOURCES))
        status = check_number(gs->plan->n_sources, largest, sizeof(struct source_block),
                              "point and parallel lights", error);
    if (status != RL_OK || !rl_plan_needs(gs->plan, RL_BUFFER_TRIANGLES))
        return status;
    gl->GenVertexArrays(1, &gs->lights.vertex_array);
    gl->GenBuffers(1, &gs->lights.vertex_buffer);
    gl->BindVertexArray(gs->lights.vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, gs->lights.vertex_buffer);
    for (GLuint i = 0; i < 2; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(struct light_vertex),
                                (const void *)(i * sizeof(float[3])));
    }
    return RL_OK;
}

void rl_lights_free(struct rl_gpu_scene *gs)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    struct rl_gpu_lights *l = &gs->lights;
    const GLuint all[] = {l->vertex_buffer, l->points,   l->spheres,
                          l->sources,       l->polygons, l->polygon_vertices};
    gl->DeleteVertexArrays(1, &l->vertex_array);
    gl->DeleteBuffers(sizeof all / sizeof all[0], all);
}

void rl_lights_bind(const struct rl_gpu_scene *gs)
{
    const struct {
        GLenum target;
        GLuint binding, buffer;
    } all[] = {
        {GL_UNIFORM_BUFFER, RL_BLOCK_LIGHTS, gs->lights.points},
        {GL_UNIFORM_BUFFER, RL_BLOCK_SPHERES, gs->lights.spheres},
        {GL_UNIFORM_BUFFER, RL_BLOCK_SOURCES, gs->lights.sources},
        {GL_SHADER_STORAGE_BUFFER, RL_STORE_POLYGONS, gs->lights.polygons},
        {GL_SHADER_STORAGE_BUFFER, RL_STORE_POLYGON_VERTICES, gs->lights.polygon_vertices},
    };
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
        if (all[i].buffer)
            gs->gpu->gl.BindBufferBase(all[i].target, all[i].binding, all[i].buffer);
}
