/* What a plan is to make and to draw, item by item, with what the GL layer should count for each; and that it does. Of scenes whose shaped light is
 * one of four corners, with a point and a parallel light. */
#ifndef RL_TESTS_GPU_INVENTORY_H
#define RL_TESTS_GPU_INVENTORY_H

#include "gpu/context.h"
#include "gpu/fixture.h"
#include "studies/features.h"

enum { ITEMS_MAX = 512, ITEM_NAME = 1024 };

/* One thing, and what the GL layer counts for it: `made` when the scene is prepared, `frame` in every frame. */
struct item {
    char name[ITEM_NAME];
    struct rl_gpu_counters made, frame;
};

struct inventory {
    size_t n;
    struct item item[ITEMS_MAX];
};

static inline struct item *inventory_add(struct inventory *list, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static inline struct item *inventory_add(struct inventory *list, const char *format, ...)
{
    assert_true(list->n < ITEMS_MAX);
    struct item *item = &list->item[list->n++];
    va_list values;
    va_start(values, format);
    *item = (struct item){.made = {0}};
    assert_in_range(vsnprintf(item->name, sizeof item->name, format, values), 1, ITEM_NAME - 1);
    va_end(values);
    return item;
}

static inline bool inventory_has(const struct inventory *list, const char *name)
{
    for (size_t i = 0; i < list->n; i++)
        if (strcmp(list->item[i].name, name) == 0)
            return true;
    return false;
}

static inline void inventory_add_programs(struct inventory *list, const struct rl_plan *plan)
{
    for (size_t i = 0; i < plan->n_programs; i++) {
        const struct rl_plan_program *p = &plan->program[i];
        char modules[ITEM_NAME];
        size_t used = 0;
        for (size_t k = 0; k < p->n_modules; k++)
            used += (size_t)snprintf(modules + used, sizeof modules - used, " %s", p->module[k]);
        struct item *item = inventory_add(list, "program:%s", modules);
        item->made.programs = 1;
        item->made.modules = p->n_modules;
    }
}

static inline void inventory_add_buffers(struct inventory *list, const struct rl_plan *plan)
{
    inventory_add(list, "colour buffer")->made.renderbuffers = 1;
    inventory_add(list, "depth buffer")->made.renderbuffers = 1;
    if (plan->n_environments > 0)
        inventory_add(list, "environment depth buffer")->made.renderbuffers = 1;
}

static inline void inventory_add_textures(struct inventory *list, const struct rl_plan *plan,
                                          const struct rl_scene *scene)
{
    for (size_t i = 0; i < plan->n_normal_maps; i++) {
        struct item *item = inventory_add(list, "normal map: %s R_r %g", plan->normal_map[i].method->name,
                                          plan->normal_map[i].rr);
        item->made.textures = 1;
        item->made.bytes_uploaded =
            (size_t)plan->settings.normal_size * (size_t)plan->settings.normal_size * 4;
    }
    for (size_t i = 0; i < plan->n_patterns; i++)
        inventory_add(list, "pattern: R_r %g, %d", plan->pattern[i].rr, plan->pattern[i].samples)
            ->made.bytes_uploaded = 16 * (size_t)plan->pattern[i].samples;
    if (plan->stencil)
        inventory_add(list, "stencil buffer");
    int n_maps = 0;
    for (size_t i = 0; i < scene->n_objects; i++)
        if (plan->environment[i] == n_maps) {
            n_maps++;
            struct item *item = inventory_add(list, "environment map: object %zu", i);
            item->made.textures = 1;
            item->made.draws = 6;
            item->made.triangles = 12; /* a light of four corners, on six faces */
        }
}

/* Buffers of the lights: one of four corners, a point and a parallel one. */
static inline void inventory_add_lights(struct inventory *list, const struct rl_plan *plan)
{
    bool points = false, spheres = false;
    assert_true(plan->n_lights <= 1 && plan->n_sources == (plan->sees & RL_SEES_SOURCES ? 2 : 0));
    for (size_t i = 0; i < plan->n_materials; i++) {
        const struct rl_plan_material *m = &plan->material[i];
        points = points || m->sees & RL_SEES_CENTROIDS || (m->method && m->method->needs_point_lights);
        spheres = spheres || m->sphere_program >= 0;
    }
    if (plan->n_environments > 0)
        inventory_add(list, "lights: triangles")->made.bytes_uploaded = (size_t)6 * 24;
    if (points)
        inventory_add(list, "lights: points")->made.bytes_uploaded = 48;
    if (spheres)
        inventory_add(list, "lights: spheres")->made.bytes_uploaded = 16;
    if (plan->sees & RL_SEES_SOURCES)
        inventory_add(list, "lights: sources")->made.bytes_uploaded = (size_t)2 * 32;
    if (plan->sees & RL_SEES_POLYGONS)
        inventory_add(list, "lights: polygons")->made.bytes_uploaded = 32 + (size_t)4 * 16;
}

static inline void inventory_add_draw(struct inventory *list, const char *pass, size_t object,
                                      const struct rl_plan *plan, const struct rl_scene *scene)
{
    const struct rl_mesh *mesh = &scene->object[object].mesh;
    struct item *item = inventory_add(list, "draw: %s of object %zu", pass, object);
    item->frame.draws = 1;
    item->frame.triangles = mesh->n_triangles;
    if (plan->settings.culling)
        item->frame.triangles_culled = rl_mesh_back_faces(mesh, scene->camera.position);
}

static inline void inventory_add_objects(struct inventory *list, const struct rl_plan *plan,
                                         const struct rl_scene *scene)
{
    static const char *const names[RL_MESH_PARTS] = {"triangles", "normals", "positions"};
    for (size_t i = 0; i < scene->n_objects; i++) {
        const struct rl_mesh *mesh = &scene->object[i].mesh;
        const struct rl_plan_material *m = rl_plan_of_object(plan, scene, i);
        for (int part = 0; part < RL_MESH_PARTS; part++)
            if (plan->object[i].mesh_from[part] == i)
                inventory_add(list, "mesh: %s of object %zu", names[part], i)->made.bytes_uploaded =
                    12 * (part == RL_MESH_TRIANGLES ? mesh->n_triangles : mesh->n_vertices);
        inventory_add_draw(list, "surface", i, plan, scene);
        if (m->sphere_program >= 0)
            inventory_add_draw(list, "sphere", i, plan, scene);
        if (m->highlight_program >= 0)
            inventory_add_draw(list, "highlight", i, plan, scene);
    }
}

static inline void inventory_sum(struct rl_gpu_counters *to, const struct rl_gpu_counters *from)
{
    to->draws += from->draws;
    to->triangles += from->triangles;
    to->triangles_culled += from->triangles_culled;
    to->programs += from->programs;
    to->modules += from->modules;
    to->textures += from->textures;
    to->renderbuffers += from->renderbuffers;
    to->bytes_uploaded += from->bytes_uploaded;
}

static inline void inventory_check_counters(const char *what, const struct rl_gpu_counters *found,
                                            const struct rl_gpu_counters *expected)
{
    if (memcmp(found, expected, sizeof *found) == 0)
        return;
    const struct rl_gpu_counters *both[] = {found, expected};
    for (int i = 0; i < 2; i++)
        print_error("%s, %s: draws %zu, triangles %zu, culled %zu, programs %zu, modules %zu, textures %zu, "
                    "render buffers %zu, bytes %zu\n",
                    what, i ? "expected" : "found", both[i]->draws, both[i]->triangles,
                    both[i]->triangles_culled, both[i]->programs, both[i]->modules, both[i]->textures,
                    both[i]->renderbuffers, both[i]->bytes_uploaded);
    fail();
}

/* ---- What OpenGL was asked for, whoever counts it ---- */

/* The functions that the calls go on to, and what came through since it was last cleared. Tests have one context at a time. */
static struct rl_gl inventory_gl;
static struct rl_gpu_counters inventory_calls;

static void APIENTRY inventory_draw_elements(GLenum mode, GLsizei n, GLenum type, const void *indices)
{
    inventory_calls.draws++;
    inventory_calls.triangles += (size_t)n / 3;
    inventory_gl.DrawElements(mode, n, type, indices);
}

static void APIENTRY inventory_draw_arrays(GLenum mode, GLint first, GLsizei n)
{
    inventory_calls.draws++;
    inventory_calls.triangles += (size_t)n / 3;
    inventory_gl.DrawArrays(mode, first, n);
}

static void APIENTRY inventory_link_program(GLuint program)
{
    inventory_calls.programs++;
    inventory_gl.LinkProgram(program);
}

static void APIENTRY inventory_tex_storage(GLenum target, GLsizei levels, GLenum format, GLsizei width,
                                           GLsizei height)
{
    inventory_calls.textures++;
    inventory_gl.TexStorage2D(target, levels, format, width, height);
}

/* Of 8 bits a component, as inventories are taken. */
static void APIENTRY inventory_tex_sub_image(GLenum target, GLint level, GLint x, GLint y, GLsizei width,
                                             GLsizei height, GLenum format, GLenum type, const void *texels)
{
    assert_true(format == GL_RGBA && type == GL_UNSIGNED_BYTE);
    inventory_calls.bytes_uploaded += (size_t)width * (size_t)height * 4;
    inventory_gl.TexSubImage2D(target, level, x, y, width, height, format, type, texels);
}

static void APIENTRY inventory_renderbuffer_storage(GLenum target, GLenum format, GLsizei width,
                                                    GLsizei height)
{
    inventory_calls.renderbuffers++;
    inventory_gl.RenderbufferStorage(target, format, width, height);
}

static void APIENTRY inventory_buffer_data(GLenum target, GLsizeiptr size, const void *data, GLenum usage)
{
    inventory_calls.bytes_uploaded += (size_t)size;
    inventory_gl.BufferData(target, size, data, usage);
}

static void APIENTRY inventory_buffer_sub_data(GLenum target, GLintptr offset, GLsizeiptr size,
                                               const void *data)
{
    inventory_calls.bytes_uploaded += (size_t)size;
    inventory_gl.BufferSubData(target, offset, size, data);
}

/* A test that failed may have left it listening. */
static inline void inventory_listen(struct rl_gpu *gpu)
{
    if (gpu->gl.DrawElements == inventory_draw_elements)
        return;
    inventory_gl = gpu->gl;
    gpu->gl.DrawElements = inventory_draw_elements;
    gpu->gl.DrawArrays = inventory_draw_arrays;
    gpu->gl.LinkProgram = inventory_link_program;
    gpu->gl.TexStorage2D = inventory_tex_storage;
    gpu->gl.TexSubImage2D = inventory_tex_sub_image;
    gpu->gl.RenderbufferStorage = inventory_renderbuffer_storage;
    gpu->gl.BufferData = inventory_buffer_data;
    gpu->gl.BufferSubData = inventory_buffer_sub_data;
}

static inline void inventory_stop_listening(struct rl_gpu *gpu)
{
#define RESTORE(type, name) gpu->gl.name = inventory_gl.name;
    RL_GL_FUNCTIONS(RESTORE)
#undef RESTORE
}

/* The counters of the GL layer against the calls, on a context that has kept nothing; culling and modules are not OpenGL's. */
static inline void inventory_check_calls(const char *what, const struct rl_gpu_counters *found)
{
    inventory_calls.triangles_culled = found->triangles_culled;
    inventory_calls.modules = found->modules;
    inventory_check_counters(what, found, &inventory_calls);
    inventory_calls = (struct rl_gpu_counters){0};
}

/* What the view's plan lists, which must be what is counted when it is carried out on a context that has kept nothing. */
static inline struct inventory *inventory_take(const char *what, struct rl_gpu *gpu,
                                               const struct rl_view *view)
{
    struct rl_error error;
    struct rl_plan plan;
    struct rl_gpu_scene *gs;
    struct rl_gpu_counters made = {0}, frame = {0}, found;
    double seconds;
    struct inventory *list = malloc(sizeof *list);
    assert_non_null(list);
    list->n = 0;
    check_ok(rl_plan_make(&plan, &view->scene, &view->settings, &error), &error);
    inventory_add_programs(list, &plan);
    inventory_add_buffers(list, &plan);
    inventory_add_textures(list, &plan, &view->scene);
    inventory_add_lights(list, &plan);
    inventory_add_objects(list, &plan, &view->scene);
    for (size_t i = 0; i < list->n; i++) {
        inventory_sum(&made, &list->item[i].made);
        inventory_sum(&frame, &list->item[i].frame);
    }
    rl_kept_clear(&gpu->kept, &gpu->gl);
    inventory_listen(gpu);
    inventory_calls = (struct rl_gpu_counters){0};
    check_ok(rl_gpu_scene_make(&gs, gpu, &view->scene, &plan, &error), &error);
    found = rl_gpu_scene_counters(gs);
    inventory_check_counters(what, &found, &made);
    inventory_check_calls(what, &found);
    rl_gpu_scene_reset_counters(gs);
    check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
    found = rl_gpu_scene_counters(gs);
    inventory_check_counters(what, &found, &frame);
    inventory_check_calls(what, &found);
    inventory_stop_listening(gpu);
    rl_gpu_scene_free(gs);
    rl_plan_clear(&plan);
    return list;
}

#endif
