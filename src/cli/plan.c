/* `plan`: what a scene calls for, in the order in which it happens. */
#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "cli/output.h"
#include "cli/render_options.h"
#include "scene/plan.h"

static void row(struct rl_rows *rows, const char *kind, const char *name, const char *detail)
{
    rl_rows_text(rows, kind);
    rl_rows_text(rows, name);
    rl_rows_text(rows, detail);
}

/* Where the effects of a material are evaluated, unless that is each pixel. */
static const char *const evaluated[RL_INTERPOLATIONS] = {
    [RL_INTERPOLATION_PHONG] = "",
    [RL_INTERPOLATION_GOURAUD] = ", gouraud: at each vertex",
    [RL_INTERPOLATION_CONSTANT] = ", constant: once a triangle",
};

static void effect_rows(struct rl_rows *rows, const struct rl_scene *scene, const struct rl_plan *plan)
{
    char detail[512];
    for (size_t i = 0; i < plan->n_materials; i++) {
        const struct rl_plan_material *m = &plan->material[i];
        const char *name = scene->material[m->material].name;
        for (size_t j = 0; j < m->n_effects; j++) {
            snprintf(detail, sizeof detail, "material %s%s", name,
                     m->effect[j]->sees ? evaluated[m->interpolation] : "");
            row(rows, "effect", m->effect[j]->name, detail);
        }
        snprintf(detail, sizeof detail, "material %s", name);
        if (!m->method)
            continue;
        size_t used = strlen(detail);
        if (m->method->sampled)
            snprintf(detail + used, sizeof detail - used, ", R_r %g, %d samples", m->rr, m->samples);
        else
            snprintf(detail + used, sizeof detail - used, ", R_r %g", m->rr);
        row(rows, "highlight", m->method->name, detail);
    }
}

/* The bounding spheres' size, and what it is chosen for. */
static void sphere_rows(struct rl_rows *rows, const struct rl_scene *scene, const struct rl_plan *plan)
{
    const struct rl_settings *s = &plan->settings;
    char name[128], detail[192], bound[128] = "";
    if (s->margin_kind == RL_MARGIN_AUTO)
        snprintf(bound, sizeof bound, "; auto: no pixel loses more than %g of the brightest light's radiance",
                 s->margin_bound);
    for (size_t i = 0; i < plan->n_materials; i++) {
        const struct rl_plan_material *m = &plan->material[i];
        if (m->sphere_program < 0)
            continue;
        snprintf(name, sizeof name, "material %s", scene->material[m->material].name);
        snprintf(detail, sizeof detail, "margin %.4g%s", m->margin, bound);
        row(rows, "sphere", name, detail);
    }
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

/* Which parts of an object's mesh are another's. */
static void add_mesh_sharing(char detail[], size_t size, const struct rl_scene *scene,
                             const struct rl_plan *plan, size_t object)
{
    static const char *const names[RL_MESH_PARTS] = {"triangles", "normals", "positions"};
    size_t used = strlen(detail);
    bool shared = false;
    for (int part = 0; part < RL_MESH_PARTS && used < size; part++) {
        size_t from = plan->object[object].mesh_from[part];
        if (from == object)
            continue;
        used += (size_t)snprintf(detail + used, size - used, "%s %s of %s",
                                 shared ? "," : "; shared:", names[part], scene->object[from].name);
        shared = true;
    }
    if (shared && used < size)
        snprintf(detail + used, size - used, ", the same byte for byte");
}

static void texture_rows(struct rl_rows *rows, const struct rl_scene *scene, const struct rl_plan *plan)
{
    char name[64];
    char detail[512];
    char bits[16];
    const struct rl_settings *s = &plan->settings;
    rl_normal_bits_name(bits, s->normal_bits);
    for (size_t i = 0; i < plan->n_normal_maps; i++) {
        snprintf(name, sizeof name, "normal map %zu", i);
        snprintf(detail, sizeof detail, "%dx%d, %s bits a component, R_r %g, seed %llu; baked on the CPU",
                 s->normal_size, s->normal_size, bits, plan->normal_map[i].rr, (unsigned long long)s->seed);
        row(rows, "texture", name, detail);
    }
    int n_maps = 0;
    for (size_t i = 0; i < scene->n_objects; i++) {
        if (plan->environment[i] != n_maps)
            continue;
        snprintf(name, sizeof name, "environment map %d", n_maps++);
        snprintf(detail, sizeof detail, "6x%dx%d %s, seen from object %s", s->env_size, s->env_size,
                 plan->on_cpu ? "exact radiance" : rl_texel_format_name(s->env_format),
                 scene->object[i].name);
        add_map_sharers(detail, sizeof detail, scene, plan, i);
        row(rows, "texture", name, detail);
    }
    for (size_t i = 0; i < plan->n_patterns; i++) {
        snprintf(name, sizeof name, "pattern %zu", i);
        snprintf(detail, sizeof detail, "%d normals, R_r %g", plan->pattern[i].samples, plan->pattern[i].rr);
        row(rows, "buffer", name, detail);
    }
}

/* Meshes, and the lights for those who read them. */
static void buffer_rows(struct rl_rows *rows, const struct rl_scene *scene, const struct rl_plan *plan)
{
    char name[128];
    char detail[512];
    for (size_t i = 0; i < scene->n_objects && !plan->on_cpu; i++) {
        const struct rl_mesh *mesh = &scene->object[i].mesh;
        if (!plan->object[i].drawn)
            continue;
        snprintf(name, sizeof name, "mesh of %s", scene->object[i].name);
        snprintf(detail, sizeof detail, "%zu vertices, %zu triangles", mesh->n_vertices, mesh->n_triangles);
        add_mesh_sharing(detail, sizeof detail, scene, plan, i);
        row(rows, "buffer", name, detail);
    }
    for (int i = 0; i < RL_BUFFERS; i++) {
        if (!rl_plan_needs(plan, (enum rl_plan_buffer)i))
            continue;
        size_t n = i == RL_BUFFER_SOURCES ? plan->n_sources : plan->n_lights;
        snprintf(detail, sizeof detail, "of %zu light%s", n, n == 1 ? "" : "s");
        row(rows, "buffer", rl_plan_buffer_name((enum rl_plan_buffer)i), detail);
    }
}

/* What decides which surface a pixel shows. */
static void visibility_rows(struct rl_rows *rows, const struct rl_scene *scene, const struct rl_plan *plan)
{
    char detail[128];
    const struct rl_settings *s = &plan->settings;
    size_t all = 0, back = 0;
    for (size_t i = 0; i < scene->n_objects; i++)
        if (plan->object[i].drawn) {
            all += scene->object[i].mesh.n_triangles;
            back += rl_mesh_back_faces(&scene->object[i].mesh, scene->camera.position);
        }
    if (!plan->on_cpu) {
        snprintf(detail, sizeof detail, "%dx%d rgba32f", s->width, s->height);
        row(rows, "buffer", "colour", detail);
        snprintf(detail, sizeof detail, "%d bits%s, %dx%d, from %g at %g to %g at %g", s->depth_bits,
                 s->depth_bits == 32 ? ", float" : "", s->width, s->height, s->reversed_depth ? 1.0 : 0.0,
                 scene->camera.near_plane, s->reversed_depth ? 0.0 : 1.0, scene->camera.far_plane);
        row(rows, "buffer", "depth", detail);
    }
    if (plan->stencil)
        row(rows, "buffer", "stencil", "8 bits, beside the depth, for the passes after the surface's");
    if (!plan->on_cpu && plan->n_environments > 0) {
        snprintf(detail, sizeof detail, "32 bits, float, %dx%d, one for all faces of all maps", s->env_size,
                 s->env_size);
        row(rows, "buffer", "environment depth", detail);
    }
    snprintf(detail, sizeof detail, "%zu of %zu triangles are back faces", back, all);
    if (s->culling)
        row(rows, "culling", "back faces", detail);
}

/* The objects whose material runs program `index` in its pass, as "objects a, b". */
static void users(char detail[], size_t size, const struct rl_scene *scene, const struct rl_plan *plan,
                  int index)
{
    size_t used = (size_t)snprintf(detail, size, "objects");
    for (size_t i = 0; i < scene->n_objects && used < size; i++) {
        const struct rl_plan_material *m = rl_plan_of_object(plan, scene, i);
        if (!plan->object[i].drawn)
            continue;
        bool environment = index == plan->environment_program && plan->environment[i] >= 0;
        bool highlight =
            plan->object[i].highlit && (m->highlight_program == index || m->sphere_program == index);
        if (environment || highlight || m->surface_program == index)
            used += (size_t)snprintf(detail + used, size - used, " %s", scene->object[i].name);
    }
}

static void program_rows(struct rl_rows *rows, const struct rl_scene *scene, const struct rl_plan *plan,
                         const char *pass)
{
    char name[64];
    char detail[1024];
    for (size_t i = 0; i < plan->n_programs; i++) {
        const struct rl_plan_program *p = &plan->program[i];
        if (strcmp(p->pass, pass) != 0)
            continue;
        snprintf(name, sizeof name, "%s, program %zu", p->pass, i);
        users(detail, sizeof detail, scene, plan, (int)i);
        row(rows, "pass", name, detail);
        for (size_t j = 0; j < p->n_modules; j++) {
            snprintf(detail, sizeof detail, "program %zu%s", i, j < p->n_vertex ? ", vertex shader" : "");
            row(rows, "module", p->module[j], detail);
        }
    }
}

static int print(struct rl_scene *scene, const struct rl_arguments *a, struct rl_error *error)
{
    struct rl_settings settings = scene->settings;
    struct rl_plan plan = {0};
    enum rl_output format;
    int status = rl_argument_output(a, &format, error);
    if (status == RL_OK)
        status = rl_argument_settings(&settings, a, error);
    if (status == RL_OK)
        status = rl_argument_check_effect(a, scene, &settings, error);
    if (status == RL_OK && settings.width > 0)
        rl_scene_fit_planes(scene, settings.width, settings.height);
    if (status == RL_OK)
        status = rl_plan_make(&plan, scene, &settings, error);
    if (status != RL_OK)
        return status;
    struct rl_rows rows;
    rl_rows_begin(&rows, format, (const char *const[]){"kind", "name", "detail", NULL});
    effect_rows(&rows, scene, &plan);
    if (plan.shadows)
        row(&rows, "effect", "shadows",
            "of every effect and highlight: lights hidden by other objects, seen or not; rays in double "
            "precision, lines cut at silhouettes");
    sphere_rows(&rows, scene, &plan);
    texture_rows(&rows, scene, &plan);
    buffer_rows(&rows, scene, &plan);
    visibility_rows(&rows, scene, &plan);
    if (plan.on_cpu)
        row(&rows, "pass", "cpu",
            "Embree finds each pixel's point; effects and highlight are evaluated in double precision");
    static const char *const passes[] = {"environment", "surface", "sphere", "highlight"};
    for (size_t i = 0; i < sizeof passes / sizeof passes[0]; i++)
        program_rows(&rows, scene, &plan, passes[i]);
    for (size_t i = 0; i < plan.n_drops; i++) {
        char name[96];
        snprintf(name, sizeof name, "%s %s", plan.drop[i].kind, plan.drop[i].name);
        row(&rows, "dropped", name, plan.drop[i].reason);
    }
    rl_rows_end(&rows);
    rl_plan_clear(&plan);
    return RL_OK;
}

static int run(const struct rl_arguments *a, struct rl_error *error)
{
    struct rl_scene scene;
    int status = rl_scene_load(&scene, a->positional[0], error);
    if (status != RL_OK)
        return rl_exit_of(status);
    status = print(&scene, a, error);
    rl_scene_clear(&scene);
    return rl_exit_of(status);
}

const struct rl_command rl_command_plan = {
    .name = "plan",
    .arguments = "SCENE [options]",
    .min_positionals = 1,
    .max_positionals = 1,
    .summary = "what a scene calls for: effects, textures, passes and shader modules",
    .description =
        "Prints, in order, the effects that the scene's materials ask for and the textures, passes and "
        "shader modules that\n"
        "follow from them. What is not listed is not allocated, compiled or drawn. Rows: kind, name, detail; "
        "kinds are\n"
        "effect, highlight, sphere, texture, buffer, culling, pass, module; and dropped: what the scene has "
        "but "
        "cannot change "
        "a "
        "pixel, and why.\n\n"
        "  roughlight plan studies/scenes/teapot-star.yaml\n"
        "  roughlight plan studies/scenes/teapot-star.yaml --method plain        what one pass alone needs\n"
        "  roughlight plan studies/scenes/two-roughness.yaml --margin 0.2 --format json",
    .options = (const struct rl_option *const[]){rl_options_render, rl_options_format, NULL},
    .run = run,
};
