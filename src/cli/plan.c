/* `plan`: what a scene calls for, in the order in which it happens. */
#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "cli/plan_rows.h"
#include "cli/render_options.h"
#include "scene/plan_sizes.h"

struct rl_json *rl_plan_row(struct rl_plan_rows *p, const char *kind, const char *name, const char *detail)
{
    rl_rows_text(&p->rows, kind);
    rl_rows_text(&p->rows, name);
    rl_rows_text(&p->rows, detail);
    return rl_rows_more(&p->rows);
}

/* Where the effects of a material are evaluated, unless that is each pixel. */
static const char *const evaluated[RL_INTERPOLATIONS] = {
    [RL_INTERPOLATION_PHONG] = "",
    [RL_INTERPOLATION_GOURAUD] = ", gouraud: at each vertex",
    [RL_INTERPOLATION_CONSTANT] = ", constant: once a triangle",
};

static void material_rows(struct rl_plan_rows *p, const struct rl_plan_material *m)
{
    char detail[512];
    const char *name = p->scene->material[m->material].name;
    for (size_t j = 0; j < m->n_effects; j++) {
        bool lit = m->effect[j]->sees;
        snprintf(detail, sizeof detail, "material %s%s", name, lit ? evaluated[m->interpolation] : "");
        struct rl_json *json = rl_plan_row(p, "effect", m->effect[j]->name, detail);
        rl_json_text(json, "material", name);
        rl_json_text(json, "interpolation", lit ? rl_interpolation_name(m->interpolation) : NULL);
    }
    if (!m->method)
        return;
    size_t used = (size_t)snprintf(detail, sizeof detail, "material %s", name);
    if (m->method->sampled)
        snprintf(detail + used, sizeof detail - used, ", R_r %g, %d samples", m->rr, m->samples);
    else
        snprintf(detail + used, sizeof detail - used, ", R_r %g", m->rr);
    struct rl_json *json = rl_plan_row(p, "highlight", m->method->name, detail);
    rl_json_text(json, "material", name);
    rl_json_number(json, "rr", m->rr);
    if (m->method->sampled)
        rl_json_integer(json, "samples", m->samples);
    else
        rl_json_text(json, "samples", NULL);
}

static void effect_rows(struct rl_plan_rows *p)
{
    for (size_t i = 0; i < p->plan->n_materials; i++)
        material_rows(p, &p->plan->material[i]);
    if (!p->plan->shadows)
        return;
    struct rl_json *json =
        rl_plan_row(p, "effect", "shadows",
                    "of every effect and highlight: lights hidden by other objects, seen or not; rays in "
                    "double precision, lines cut at silhouettes");
    rl_json_text(json, "material", NULL);
    rl_json_text(json, "interpolation", NULL);
}

/* The bounding spheres' size, and what it is chosen for. */
static void sphere_rows(struct rl_plan_rows *p)
{
    const struct rl_settings *s = &p->plan->settings;
    char name[128], detail[192], bound[128] = "";
    bool is_auto = s->margin_kind == RL_MARGIN_AUTO;
    if (is_auto)
        snprintf(bound, sizeof bound, "; auto: no pixel loses more than %g of the brightest light's radiance",
                 s->margin_bound);
    for (size_t i = 0; i < p->plan->n_materials; i++) {
        const struct rl_plan_material *m = &p->plan->material[i];
        if (m->sphere_program < 0)
            continue;
        snprintf(name, sizeof name, "material %s", p->scene->material[m->material].name);
        snprintf(detail, sizeof detail, "margin %.4g%s", m->margin, bound);
        struct rl_json *json = rl_plan_row(p, "sphere", name, detail);
        rl_json_text(json, "material", p->scene->material[m->material].name);
        rl_json_number(json, "margin", m->margin);
        if (is_auto)
            rl_json_number(json, "bound", s->margin_bound);
        else
            rl_json_text(json, "bound", NULL);
    }
}

static void culling_row(struct rl_plan_rows *p)
{
    char detail[128];
    size_t all = 0, back = 0;
    for (size_t i = 0; i < p->scene->n_objects; i++)
        if (p->plan->object[i].drawn) {
            all += p->scene->object[i].mesh.n_triangles;
            back += rl_mesh_back_faces(&p->scene->object[i].mesh, p->scene->camera.position);
        }
    snprintf(detail, sizeof detail, "%zu of %zu triangles are back faces", back, all);
    if (!p->plan->settings.culling)
        return;
    struct rl_json *json = rl_plan_row(p, "culling", "back faces", detail);
    rl_json_integer(json, "back_faces", (long long)back);
    rl_json_integer(json, "triangles", (long long)all);
}

/* ---- Passes ---- */

/* The objects whose material runs program `index` in its pass, as "objects a, b". */
static void users(char detail[], size_t size, const struct rl_plan_rows *p, size_t index)
{
    size_t used = (size_t)snprintf(detail, size, "objects");
    for (size_t i = 0; i < p->scene->n_objects && used < size; i++)
        if (rl_plan_runs(p->plan, p->scene, index, i))
            used += (size_t)snprintf(detail + used, size - used, " %s", p->scene->object[i].name);
}

static void add_pass(struct rl_json *json, const struct rl_plan_rows *p, size_t index)
{
    const struct rl_plan_program *program = &p->plan->program[index];
    rl_json_text(json, "pass", program->pass);
    rl_json_integer(json, "program", (long long)index);
    rl_json_integer(json, "draws", (long long)rl_plan_draws(p->plan, p->scene, index));
    rl_json_text(json, "each", (int)index == p->plan->environment_program ? "scene" : "frame");
    if (program->samples > 0)
        rl_json_integer(json, "samples", program->samples);
    else
        rl_json_text(json, "samples", NULL);
    rl_json_open(json, "objects", '[');
    for (size_t i = 0; i < p->scene->n_objects; i++)
        if (rl_plan_runs(p->plan, p->scene, index, i))
            rl_json_text(json, NULL, p->scene->object[i].name);
    rl_json_close(json, ']');
}

static void program_rows(struct rl_plan_rows *p, const char *pass)
{
    char name[64], detail[1024];
    for (size_t i = 0; i < p->plan->n_programs; i++) {
        const struct rl_plan_program *program = &p->plan->program[i];
        if (strcmp(program->pass, pass) != 0)
            continue;
        snprintf(name, sizeof name, "%s, program %zu", program->pass, i);
        users(detail, sizeof detail, p, i);
        add_pass(rl_plan_row(p, "pass", name, detail), p, i);
        for (size_t j = 0; j < program->n_modules; j++) {
            bool vertex = j < program->n_vertex;
            snprintf(detail, sizeof detail, "program %zu%s", i, vertex ? ", vertex shader" : "");
            struct rl_json *json = rl_plan_row(p, "module", program->module[j], detail);
            rl_json_integer(json, "program", (long long)i);
            rl_json_text(json, "stage", vertex ? "vertex" : "fragment");
        }
    }
}

/* On the CPU there is one, without programs and draws. */
static void cpu_row(struct rl_plan_rows *p)
{
    struct rl_json *json = rl_plan_row(
        p, "pass", "cpu",
        "Embree finds each pixel's point; effects and highlight are evaluated in double precision");
    rl_json_text(json, "pass", "cpu");
    rl_json_text(json, "program", NULL);
    rl_json_text(json, "draws", NULL);
    rl_json_text(json, "each", "frame");
    rl_json_text(json, "samples", NULL);
    rl_json_open(json, "objects", '[');
    for (size_t i = 0; i < p->scene->n_objects; i++)
        if (p->plan->object[i].drawn)
            rl_json_text(json, NULL, p->scene->object[i].name);
    rl_json_close(json, ']');
}

static void pass_rows(struct rl_plan_rows *p)
{
    static const char *const passes[] = {"environment", "surface", "sphere", "highlight"};
    if (p->plan->on_cpu)
        cpu_row(p);
    for (size_t i = 0; i < sizeof passes / sizeof passes[0]; i++)
        program_rows(p, passes[i]);
}

/* ---- What is left out ---- */

/* The method of the highlight that is left out; NULL: it is no highlight. */
static const struct rl_method *dropped_method(const struct rl_plan_rows *p, const struct rl_plan_drop *drop)
{
    const char *asked = p->plan->settings.method;
    if (strncmp(drop->kind, "highlight", strlen("highlight")) != 0)
        return NULL;
    return rl_method_find(asked ? asked : p->scene->material[drop->material].method);
}

static void drop_rows(struct rl_plan_rows *p)
{
    char name[96];
    for (size_t i = 0; i < p->plan->n_drops; i++) {
        const struct rl_plan_drop *drop = &p->plan->drop[i];
        const struct rl_method *method = dropped_method(p, drop);
        snprintf(name, sizeof name, "%s %s", drop->kind, drop->name);
        struct rl_json *json = rl_plan_row(p, "dropped", name, drop->reason);
        rl_json_text(json, "dropped", method ? "highlight" : drop->kind);
        rl_json_text(json, "dropped_name", method ? method->name : drop->name);
        rl_json_text(json, "material", drop->material < 0 ? NULL : p->scene->material[drop->material].name);
        rl_json_text(json, "object", drop->object < 0 ? NULL : p->scene->object[drop->object].name);
        rl_json_text(json, "reason", rl_plan_reason_code(drop->why));
        if (method)
            rl_json_boolean(json, "environment_map", method->needs_environment);
    }
}

/* ---- The whole ---- */

static int print_rows(struct rl_plan_rows *p, enum rl_output format, struct rl_error *error)
{
    rl_rows_begin(&p->rows, format, (const char *const[]){"kind", "name", "detail", NULL});
    effect_rows(p);
    sphere_rows(p);
    rl_plan_texture_rows(p);
    int status = rl_plan_buffer_rows(p, error);
    if (status != RL_OK)
        return status;
    culling_row(p);
    pass_rows(p);
    drop_rows(p);
    rl_rows_end(&p->rows);
    return RL_OK;
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
    struct rl_plan_rows rows = {.scene = scene, .plan = &plan};
    status = print_rows(&rows, format, error);
    rl_plan_clear(&plan);
    return status;
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
        "but cannot\n"
        "change a pixel, and why. Objects of one centre share an environment map, and parts of meshes that "
        "are the same byte\n"
        "for byte a buffer: their rows say whose. A scene with shadows, or whose method is exhaustive or "
        "reference, is\n"
        "drawn on the CPU: one pass, cpu, without buffers, programs and modules.\n\n"
        "With --format json a row has fields of its own beside these:\n"
        "  effect, highlight  material; interpolation (null: of no light); rr, samples (null: none are "
        "taken)\n"
        "  sphere             material, margin, bound (of margin auto)\n"
        "  texture, buffer    resource (texture, renderbuffer, buffer), format, width, height, count (images "
        "of "
        "that size, or\n"
        "                     elements), bytes, uploaded_bytes (0: the GPU draws it); null where there is "
        "none. "
        "Environment\n"
        "                     maps: object, shared_by. Meshes: object, vertices, triangles, parts (part, "
        "shared_from, ...)\n"
        "  culling            back_faces, triangles\n"
        "  pass               pass, program, draws, each (in each frame, or once a scene), samples, objects\n"
        "  module             program, stage (vertex, fragment)\n"
        "  dropped            dropped (object, material, light, effect, highlight), dropped_name, material, "
        "object, reason (a\n"
        "                     code, such as outside-view); of highlights environment_map: whether it needs "
        "one\n\n"
        "  roughlight plan studies/scenes/teapot-star.yaml\n"
        "  roughlight plan studies/scenes/teapot-star.yaml --method plain        what one pass alone needs\n"
        "  roughlight plan studies/scenes/two-roughness.yaml --margin 0.2 --format json",
    .options = (const struct rl_option *const[]){rl_options_render, rl_options_format, NULL},
    .run = run,
};
