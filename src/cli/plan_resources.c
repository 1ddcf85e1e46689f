/* Rows of `plan` about what is allocated: textures, buffers, render buffers; what objects share of them, and their bytes. */
#include <stdio.h>
#include <string.h>

#include "cli/plan_rows.h"
#include "scene/plan_sizes.h"

static void add_integer_or_null(struct rl_json *json, const char *key, bool there, size_t value)
{
    if (there)
        rl_json_integer(json, key, (long long)value);
    else
        rl_json_text(json, key, NULL);
}

/* The same keys for all. `resource`: what OpenGL makes, "texture", "renderbuffer" or "buffer"; NULL: nothing of its own, and no size. */
static void add_size(struct rl_json *json, const char *resource, struct rl_plan_size size)
{
    bool there = resource != NULL, image = there && size.width > 0;
    rl_json_text(json, "resource", resource);
    rl_json_text(json, "format", there ? size.format : NULL);
    add_integer_or_null(json, "width", image, (size_t)size.width);
    add_integer_or_null(json, "height", image, (size_t)size.height);
    add_integer_or_null(json, "count", there, size.count);
    add_integer_or_null(json, "bytes", there, size.bytes);
    add_integer_or_null(json, "uploaded_bytes", there, size.uploaded);
}

/* The other objects that have the environment map of this one. */
static void add_map_sharers(char detail[], size_t size, const struct rl_scene *scene,
                            const struct rl_plan *plan, size_t object)
{
    size_t used = strlen(detail);
    bool shared = false;
    for (size_t i = object + 1; i < scene->n_objects && used < size; i++)
        if (plan->environment[i] == plan->environment[object]) {
            used += (size_t)snprintf(detail + used, size - used, "%s %s", shared ? "," : "; shared by",
                                     scene->object[i].name);
            shared = true;
        }
    if (shared && used < size)
        snprintf(detail + used, size - used, ": one centre");
}

static const char *const part_name[RL_MESH_PARTS] = {"triangles", "normals", "positions"};

/* Which parts of an object's mesh are another's. */
static void add_mesh_sharing(char detail[], size_t size, const struct rl_scene *scene,
                             const struct rl_plan *plan, size_t object)
{
    size_t used = strlen(detail);
    bool shared = false;
    for (int part = 0; part < RL_MESH_PARTS && used < size; part++) {
        size_t from = plan->object[object].mesh_from[part];
        if (from == object)
            continue;
        used += (size_t)snprintf(detail + used, size - used, "%s %s of %s",
                                 shared ? "," : "; shared:", part_name[part], scene->object[from].name);
        shared = true;
    }
    if (shared && used < size)
        snprintf(detail + used, size - used, ", the same byte for byte");
}

static void normal_map_rows(struct rl_plan_rows *p)
{
    char name[64], detail[128], bits[16];
    const struct rl_settings *s = &p->plan->settings;
    rl_normal_bits_name(bits, s->normal_bits);
    for (size_t i = 0; i < p->plan->n_normal_maps; i++) {
        double rr = p->plan->normal_map[i].rr;
        snprintf(name, sizeof name, "normal map %zu", i);
        snprintf(detail, sizeof detail, "%dx%d, %s bits a component, R_r %g, seed %llu; baked on the CPU",
                 s->normal_size, s->normal_size, bits, rr, (unsigned long long)s->seed);
        struct rl_json *json = rl_plan_row(p, "texture", name, detail);
        add_size(json, "texture", rl_plan_size_normal_map(s));
        rl_json_number(json, "rr", rr);
        rl_json_text(json, "bits", bits);
    }
}

static void environment_rows(struct rl_plan_rows *p)
{
    char name[64], detail[512];
    const struct rl_settings *s = &p->plan->settings;
    int n_maps = 0;
    for (size_t i = 0; i < p->scene->n_objects; i++) {
        if (p->plan->environment[i] != n_maps)
            continue;
        snprintf(name, sizeof name, "environment map %d", n_maps);
        snprintf(detail, sizeof detail, "6x%dx%d %s, seen from object %s", s->env_size, s->env_size,
                 p->plan->on_cpu ? "exact radiance" : rl_texel_format_name(s->env_format),
                 p->scene->object[i].name);
        add_map_sharers(detail, sizeof detail, p->scene, p->plan, i);
        struct rl_json *json = rl_plan_row(p, "texture", name, detail);
        add_size(json, p->plan->on_cpu ? NULL : "texture", rl_plan_size_environment(s));
        rl_json_text(json, "object", p->scene->object[i].name);
        rl_json_open(json, "shared_by", '[');
        for (size_t k = i + 1; k < p->scene->n_objects; k++)
            if (p->plan->environment[k] == n_maps)
                rl_json_text(json, NULL, p->scene->object[k].name);
        rl_json_close(json, ']');
        n_maps++;
    }
}

static void pattern_rows(struct rl_plan_rows *p)
{
    char name[64], detail[64];
    for (size_t i = 0; i < p->plan->n_patterns; i++) {
        const struct rl_plan_pattern *pattern = &p->plan->pattern[i];
        snprintf(name, sizeof name, "pattern %zu", i);
        snprintf(detail, sizeof detail, "%d normals, R_r %g", pattern->samples, pattern->rr);
        struct rl_json *json = rl_plan_row(p, "buffer", name, detail);
        add_size(json, "buffer", rl_plan_size_pattern(pattern));
        rl_json_number(json, "rr", pattern->rr);
    }
}

void rl_plan_texture_rows(struct rl_plan_rows *p)
{
    normal_map_rows(p);
    environment_rows(p);
    pattern_rows(p);
}

/* The sum of the parts, which have formats and counts of their own. */
static void add_mesh(struct rl_json *json, const struct rl_plan_rows *p, size_t object,
                     const struct rl_plan_size part[RL_MESH_PARTS])
{
    size_t bytes = 0;
    for (int k = 0; k < RL_MESH_PARTS; k++)
        bytes += part[k].bytes;
    rl_json_text(json, "resource", "buffer");
    for (size_t k = 0; k < 4; k++)
        rl_json_text(json, (const char *const[]){"format", "width", "height", "count"}[k], NULL);
    rl_json_integer(json, "bytes", (long long)bytes);
    rl_json_integer(json, "uploaded_bytes", (long long)bytes);
    rl_json_text(json, "object", p->scene->object[object].name);
    rl_json_integer(json, "vertices", (long long)p->scene->object[object].mesh.n_vertices);
    rl_json_integer(json, "triangles", (long long)p->scene->object[object].mesh.n_triangles);
    rl_json_open(json, "parts", '[');
    for (int k = 0; k < RL_MESH_PARTS; k++) {
        size_t from = p->plan->object[object].mesh_from[k];
        rl_json_open(json, NULL, '{');
        rl_json_text(json, "part", part_name[k]);
        rl_json_text(json, "shared_from", from == object ? NULL : p->scene->object[from].name);
        rl_json_text(json, "format", part[k].format);
        rl_json_integer(json, "count", (long long)part[k].count);
        rl_json_integer(json, "bytes", (long long)part[k].bytes);
        rl_json_close(json, '}');
    }
    rl_json_close(json, ']');
}

static int mesh_rows(struct rl_plan_rows *p, struct rl_error *error)
{
    char name[128], detail[512];
    int status = RL_OK;
    for (size_t i = 0; i < p->scene->n_objects && !p->plan->on_cpu && status == RL_OK; i++) {
        const struct rl_mesh *mesh = &p->scene->object[i].mesh;
        struct rl_plan_size part[RL_MESH_PARTS];
        if (!p->plan->object[i].drawn)
            continue;
        snprintf(name, sizeof name, "mesh of %s", p->scene->object[i].name);
        snprintf(detail, sizeof detail, "%zu vertices, %zu triangles", mesh->n_vertices, mesh->n_triangles);
        add_mesh_sharing(detail, sizeof detail, p->scene, p->plan, i);
        status = rl_plan_size_mesh(part, p->plan, p->scene, i, error);
        if (status == RL_OK)
            add_mesh(rl_plan_row(p, "buffer", name, detail), p, i, part);
    }
    return status;
}

static void light_rows(struct rl_plan_rows *p)
{
    char detail[64];
    for (int i = 0; i < RL_BUFFERS; i++) {
        enum rl_plan_buffer buffer = (enum rl_plan_buffer)i;
        if (!rl_plan_needs(p->plan, buffer))
            continue;
        size_t n = buffer == RL_BUFFER_SOURCES ? p->plan->n_sources : p->plan->n_lights;
        snprintf(detail, sizeof detail, "of %zu light%s", n, n == 1 ? "" : "s");
        struct rl_json *json = rl_plan_row(p, "buffer", rl_plan_buffer_name(buffer), detail);
        add_size(json, "buffer", rl_plan_size_lights(p->plan, p->scene, buffer));
        rl_json_integer(json, "lights", (long long)n);
    }
}

static void depth_rows(struct rl_plan_rows *p)
{
    char detail[128];
    const struct rl_settings *s = &p->plan->settings;
    const struct rl_camera *camera = &p->scene->camera;
    snprintf(detail, sizeof detail, "%d bits%s, %dx%d, from %g at %g to %g at %g", s->depth_bits,
             s->depth_bits == 32 ? ", float" : "", s->width, s->height, s->reversed_depth ? 1.0 : 0.0,
             camera->near_plane, s->reversed_depth ? 0.0 : 1.0, camera->far_plane);
    struct rl_json *json = rl_plan_row(p, "buffer", "depth", detail);
    add_size(json, "renderbuffer", rl_plan_size_depth(p->plan));
    rl_json_integer(json, "bits", s->depth_bits);
    rl_json_number(json, "near", camera->near_plane);
    rl_json_number(json, "far", camera->far_plane);
    rl_json_boolean(json, "reversed", s->reversed_depth);
    if (!p->plan->stencil)
        return;
    json =
        rl_plan_row(p, "buffer", "stencil", "8 bits, beside the depth, for the passes after the surface's");
    add_size(json, NULL, (struct rl_plan_size){0});
    rl_json_integer(json, "bits", 8);
    rl_json_text(json, "part_of", "depth");
}

/* What decides which surface a pixel shows. */
static void visibility_rows(struct rl_plan_rows *p)
{
    char detail[128];
    const struct rl_settings *s = &p->plan->settings;
    if (!p->plan->on_cpu) {
        snprintf(detail, sizeof detail, "%dx%d rgba32f", s->width, s->height);
        add_size(rl_plan_row(p, "buffer", "colour", detail), "renderbuffer", rl_plan_size_colour(p->plan));
        depth_rows(p);
    }
    if (!p->plan->on_cpu && p->plan->n_environments > 0) {
        snprintf(detail, sizeof detail, "32 bits, float, %dx%d, one for all faces of all maps", s->env_size,
                 s->env_size);
        add_size(rl_plan_row(p, "buffer", "environment depth", detail), "renderbuffer",
                 rl_plan_size_environment_depth(p->plan));
    }
}

int rl_plan_buffer_rows(struct rl_plan_rows *p, struct rl_error *error)
{
    int status = mesh_rows(p, error);
    light_rows(p);
    visibility_rows(p);
    return status;
}
