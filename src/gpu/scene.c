/* Prepares a scene on the GPU according to its plan, frees it, and reads its picture back. */
#include "gpu/scene.h"

#include <inttypes.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "gpu/meshes.h"
#include "gpu/textures.h"

static GLenum depth_format(const struct rl_plan *plan)
{
    switch (plan->settings.depth_bits) {
    case 16:
        return GL_DEPTH_COMPONENT16;
    case 32:
        return plan->stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
    default:
        return plan->stencil ? GL_DEPTH24_STENCIL8 : GL_DEPTH_COMPONENT24;
    }
}

static int make_framebuffer(struct rl_gpu_scene *gs, struct rl_error *error)
{
    struct rl_gl *gl = &gs->gpu->gl;
    GLint largest = 0;
    gl->GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (gs->width > largest || gs->height > largest)
        return rl_fail(error, RL_ERR_UNAVAILABLE, "image of %d x %d pixels: this OpenGL allows up to %d x %d",
                       gs->width, gs->height, (int)largest, (int)largest);
    char what[64];
    snprintf(what, sizeof what, "an image of %d x %d pixels", gs->width, gs->height);
    gl->GenFramebuffers(1, &gs->framebuffer);
    size_t *count = &gs->counters.renderbuffers;
    rl_gl_renderbuffer(&gs->colour, gl, GL_RGBA32F, gs->width, gs->height, count);
    rl_gl_renderbuffer(&gs->depth, gl, depth_format(gs->plan), gs->width, gs->height, count);
    int status = rl_gl_check(gl, what, error);
    if (status != RL_OK)
        return status;
    gl->BindFramebuffer(GL_FRAMEBUFFER, gs->framebuffer);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, gs->colour);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER,
                                gs->plan->stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                                GL_RENDERBUFFER, gs->depth);
    return rl_gl_check_framebuffer(gl, what, error);
}

static int make_programs(struct rl_gpu_scene *gs, struct rl_error *error)
{
    for (size_t i = 0; i < gs->plan->n_programs; i++) {
        int status = rl_program_make(&gs->program[i], gs->gpu, gs->plan, i, gs->scene, error);
        if (status != RL_OK)
            return status;
        gs->counters.programs++;
        gs->counters.modules += gs->program[i].n_modules;
        gs->counters.programs_kept += gs->program[i].kept;
    }
    return RL_OK;
}

/* What a normal map's texels follow from. The method is one of a few constants: its name stands for it. */
static uint64_t normal_map_key(const struct rl_plan_normal_map *map, const struct rl_settings *s)
{
    char text[160];
    int n = snprintf(text, sizeof text, "%.64s %.17g %d %d %" PRIu64, map->method->name, map->rr,
                     s->normal_bits, s->normal_size, s->seed);
    return rl_hash_bytes(RL_HASH_START, text, (size_t)n);
}

static int make_normal_map(GLuint *texture, struct rl_gpu_scene *gs, const struct rl_plan_normal_map *map,
                           const struct rl_settings *settings, struct rl_error *error)
{
    struct rl_gpu *gpu = gs->gpu;
    uint64_t key = normal_map_key(map, settings);
    *texture = rl_kept_take(&gpu->kept, RL_KEPT_TEXTURE, key);
    if (*texture) {
        gs->counters.textures_kept++;
        gs->counters.bytes_kept += rl_kept_bytes(&gpu->kept, RL_KEPT_TEXTURE, *texture);
        return RL_OK;
    }
    size_t bytes = 0;
    int status = rl_normal_map_make(texture, &gpu->gl, map, settings, &bytes, error);
    gs->counters.bytes_uploaded += bytes;
    if (status == RL_OK)
        return rl_kept_add(&gpu->kept, &gpu->gl, RL_KEPT_TEXTURE, key, *texture, bytes, error);
    gpu->gl.DeleteTextures(1, texture);
    *texture = 0;
    return status;
}

static int make_normal_maps(struct rl_gpu_scene *gs, const struct rl_settings *settings,
                            struct rl_error *error)
{
    const struct rl_plan *plan = gs->plan;
    int status = RL_OK;
    for (size_t i = 0; i < plan->n_normal_maps && status == RL_OK; i++) {
        status = make_normal_map(&gs->normal_map[i], gs, &plan->normal_map[i], settings, error);
        gs->counters.textures++;
    }
    return status;
}

static void free_normal_maps(struct rl_gpu_scene *gs)
{
    for (size_t i = 0; i < gs->plan->n_normal_maps; i++) {
        rl_kept_release(&gs->gpu->kept, &gs->gpu->gl, RL_KEPT_TEXTURE, gs->normal_map[i]);
        gs->normal_map[i] = 0;
    }
}

int rl_gpu_scene_reseed(struct rl_gpu_scene *gs, uint64_t seed, struct rl_error *error)
{
    struct rl_settings settings = gs->plan->settings;
    settings.seed = seed;
    free_normal_maps(gs);
    return make_normal_maps(gs, &settings, error);
}

static int make_tables(struct rl_gpu_scene *gs, struct rl_error *error)
{
    const struct rl_plan *plan = gs->plan;
    struct rl_gl *gl = &gs->gpu->gl;
    size_t *bytes = &gs->counters.bytes_uploaded;
    int status = make_normal_maps(gs, &plan->settings, error);
    for (size_t i = 0; i < plan->n_patterns && status == RL_OK; i++)
        status = rl_pattern_make(&gs->pattern[i], gl, &plan->pattern[i], bytes, error);
    return status;
}

static void pack_vec4(float to[RL_EFFECT_PARAMS][4], double from[RL_EFFECT_PARAMS][4], int n)
{
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 4; c++)
            to[i][c] = (float)from[i][c];
}

static void pack_materials(struct rl_gpu_scene *gs)
{
    for (size_t i = 0; i < gs->plan->n_materials; i++) {
        const struct rl_plan_material *m = &gs->plan->material[i];
        const struct rl_material *material = &gs->scene->material[m->material];
        struct rl_gpu_material *values = &gs->material[i];
        double params[RL_EFFECT_PARAMS][4] = {{0.0}};
        for (int c = 0; c < 3; c++)
            values->specular[c] = (float)material->specular[c];
        for (size_t j = 0; j < m->n_effects; j++) {
            m->effect[j]->pack(rl_effect_given(material, m->effect[j]), params);
            pack_vec4(values->effect_params[j], params, m->effect[j]->n_params);
        }
        if (m->method && m->method->pack) {
            struct rl_ellipsoid e = rl_ellipsoid_make(m->rr);
            m->method->pack(&e, params);
            pack_vec4(values->method_params, params, m->method->n_params);
        }
    }
}

static int make_objects(struct rl_gpu_scene *gs, struct rl_error *error)
{
    for (size_t i = 0; i < gs->scene->n_objects; i++) {
        struct rl_gpu_object *object = &gs->object[i];
        const struct rl_mesh *mesh = &gs->scene->object[i].mesh;
        int environment = gs->plan->environment[i];
        if (!gs->plan->object[i].drawn)
            continue;
        if (mesh->n_triangles > INT_MAX / 3)
            return rl_fail(error, RL_ERR_INPUT,
                           "object %zu: %zu triangles are more than OpenGL draws at once", i,
                           mesh->n_triangles);
        object->material = rl_plan_of_object(gs->plan, gs->scene, i);
        object->environment = environment >= 0 ? gs->environment[environment] : 0;
        object->n_back_faces = rl_mesh_back_faces(mesh, gs->scene->camera.position);
        bool facets = rl_plan_facets(gs->plan, gs->scene, i);
        for (int k = 0; k < RL_MESH_PARTS; k++)
            object->part[k] = gs->object[gs->plan->object[i].mesh_from[k]].part[k];
        int status = rl_mesh_upload(object, &gs->gpu->gl, mesh, facets, &gs->counters.bytes_uploaded, error);
        if (status != RL_OK)
            return rl_fail_prefix(error, "object %s",
                                  gs->scene->object[i].name ? gs->scene->object[i].name : "?");
    }
    return RL_OK;
}

static int allocate(struct rl_gpu_scene *gs, struct rl_error *error)
{
    const struct rl_plan *plan = gs->plan;
    gs->program = calloc(plan->n_programs + 1, sizeof *gs->program);
    gs->material = calloc(plan->n_materials + 1, sizeof *gs->material);
    gs->object = calloc(gs->scene->n_objects + 1, sizeof *gs->object);
    gs->normal_map = calloc(plan->n_normal_maps + 1, sizeof *gs->normal_map);
    gs->pattern = calloc(plan->n_patterns + 1, sizeof *gs->pattern);
    gs->environment = calloc(plan->n_environments + 1, sizeof *gs->environment);
    if (!gs->program || !gs->material || !gs->object || !gs->normal_map || !gs->pattern || !gs->environment)
        return rl_fail_memory(error, "the scene on the GPU");
    return RL_OK;
}

static int prepare(struct rl_gpu_scene *gs, struct rl_error *error)
{
    int (*const steps[])(struct rl_gpu_scene *, struct rl_error *) = {
        allocate,       make_framebuffer, make_programs, make_tables, rl_environments_make,
        rl_lights_make, make_objects,
    };
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        int status = steps[i](gs, error);
        if (status != RL_OK)
            return status;
    }
    pack_materials(gs);
    double seconds;
    return rl_gpu_scene_environment(gs, &seconds, error);
}

int rl_gpu_scene_make(struct rl_gpu_scene **out, struct rl_gpu *gpu, const struct rl_scene *scene,
                      const struct rl_plan *plan, struct rl_error *error)
{
    *out = NULL;
    if (plan->on_cpu)
        return rl_fail(error, RL_ERR_INPUT,
                       "the plan is for the CPU: some material's method does not run on the GPU");
    struct rl_gpu_scene *gs = calloc(1, sizeof *gs);
    if (!gs)
        return rl_fail_memory(error, "the scene on the GPU");
    gs->gpu = gpu;
    gs->scene = scene;
    gs->plan = plan;
    gs->width = plan->settings.width;
    gs->height = plan->settings.height;
    int status = prepare(gs, error);
    if (status != RL_OK) {
        rl_gpu_scene_free(gs);
        return status;
    }
    *out = gs;
    return RL_OK;
}

void rl_gpu_scene_free(struct rl_gpu_scene *gs)
{
    if (!gs)
        return;
    const struct rl_gl *gl = &gs->gpu->gl;
    for (size_t i = 0; gs->program && i < gs->plan->n_programs; i++)
        rl_program_free(&gs->program[i], gs->gpu);
    for (size_t i = 0; gs->object && i < gs->scene->n_objects; i++) {
        gl->DeleteVertexArrays(1, &gs->object[i].vertex_array);
        for (int k = 0; k < RL_MESH_PARTS; k++)
            if (gs->plan->object[i].mesh_from[k] == i)
                gl->DeleteBuffers(1, &gs->object[i].part[k]);
    }
    if (gs->normal_map)
        free_normal_maps(gs);
    if (gs->pattern)
        gl->DeleteBuffers((GLsizei)gs->plan->n_patterns, gs->pattern);
    rl_environments_free(gs);
    rl_lights_free(gs);
    gl->DeleteFramebuffers(1, &gs->framebuffer);
    gl->DeleteRenderbuffers(1, &gs->colour);
    gl->DeleteRenderbuffers(1, &gs->depth);
    free(gs->program);
    free(gs->material);
    free(gs->object);
    free(gs->normal_map);
    free(gs->pattern);
    free(gs);
}

int rl_gpu_scene_read(struct rl_gpu_scene *gs, struct rl_image *image, struct rl_error *error)
{
    struct rl_gl *gl = &gs->gpu->gl;
    int status = rl_image_allocate(image, gs->width, gs->height, 4, error);
    if (status != RL_OK)
        return status;
    gl->BindFramebuffer(GL_FRAMEBUFFER, gs->framebuffer);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    /* OpenGL's rows begin at the bottom. */
    for (int y = 0; y < gs->height; y++)
        gl->ReadPixels(0, gs->height - 1 - y, gs->width, 1, GL_RGBA, GL_FLOAT, rl_image_pixel(image, 0, y));
    status = rl_gl_check(gl, "reading the picture", error);
    if (status != RL_OK)
        rl_image_clear(image);
    return status;
}

int rl_gpu_scene_read_drawn(struct rl_gpu_scene *gs, struct rl_image *image, struct rl_error *error)
{
    struct rl_gl *gl = &gs->gpu->gl;
    if (!gs->plan->stencil) /* no pass but the surface's */
        return rl_image_allocate(image, gs->width, gs->height, 1, error);
    uint8_t *row = malloc((size_t)gs->width);
    if (!row)
        return rl_fail_memory(error, "a row of the stencil buffer");
    int status = rl_image_allocate(image, gs->width, gs->height, 1, error);
    gl->BindFramebuffer(GL_FRAMEBUFFER, gs->framebuffer);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int y = 0; y < gs->height && status == RL_OK; y++) {
        gl->ReadPixels(0, gs->height - 1 - y, gs->width, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, row);
        /* The sphere pass leaves 1 and the highlight pass counts one up: 0 is what neither touched. */
        for (int x = 0; x < gs->width; x++)
            rl_image_pixel(image, x, y)[0] = row[x] ? 1.0f : 0.0f;
    }
    free(row);
    if (status == RL_OK)
        status = rl_gl_check(gl, "reading the stencil buffer", error);
    if (status != RL_OK)
        rl_image_clear(image);
    return status;
}

void rl_gpu_scene_depth(const struct rl_gpu_scene *gs, int *depth_bits, int *stencil_bits)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    GLint depth = 0, stencil = 0;
    gl->BindRenderbuffer(GL_RENDERBUFFER, gs->depth);
    gl->GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &depth);
    gl->GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_STENCIL_SIZE, &stencil);
    *depth_bits = depth;
    *stencil_bits = stencil;
}

struct rl_gpu_counters rl_gpu_scene_counters(const struct rl_gpu_scene *gs)
{
    return gs->counters;
}

void rl_gpu_scene_reset_counters(struct rl_gpu_scene *gs)
{
    gs->counters = (struct rl_gpu_counters){0};
}
