/* From the effects and the method of a material: programs with their modules, textures, passes. What is equal is shared. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scene/margin.h"
#include "scene/plan_build.h"

static void add_module(struct rl_plan_program *program, const char *folder, const char *name)
{
    snprintf(program->module[program->n_modules++], RL_PLAN_MODULE_NAME, "%s/%s", folder, name);
}

void rl_plan_add_module(struct rl_plan_program *program, const char *module)
{
    for (size_t i = program->n_vertex; i < program->n_modules; i++)
        if (strcmp(program->module[i], module) == 0)
            return;
    snprintf(program->module[program->n_modules++], RL_PLAN_MODULE_NAME, "%s", module);
}

/* The last module, which holds main(), of the vertex shader. */
static void end_vertex_shader(struct rl_plan_program *program, const char *name)
{
    add_module(program, "passes", name);
    program->n_vertex = program->n_modules;
}

static void add_visible_modules(struct rl_plan_program *program, const struct rl_plan *plan)
{
    add_module(program, "common", "surface");
    add_module(program, "common", plan->settings.culling ? "visible" : "visible_both");
}

/* What every program begins with that shades each pixel of an object. */
static void add_object_modules(struct rl_plan_program *program, const struct rl_plan *plan)
{
    end_vertex_shader(program, "object_vertex");
    add_visible_modules(program, plan);
}

void rl_plan_add_effect(struct rl_plan_program *program, const struct rl_effect *effect, const double *value)
{
    char name[32];
    rl_effect_identifier(name, effect);
    for (size_t i = 0; i < RL_EFFECT_MODULES_MAX && effect->modules[i]; i++)
        rl_plan_add_module(program, effect->modules[i]);
    for (size_t i = 0; effect->param[i].help; i++) {
        const char *module = rl_effect_module(effect, value, i);
        if (module)
            rl_plan_add_module(program, module);
    }
    add_module(program, "effects", name);
}

/* The last module names the pass, so equal modules are of one pass. */
static bool same_program(const struct rl_plan_program *a, const struct rl_plan_program *b)
{
    if (a->n_modules != b->n_modules || a->n_vertex != b->n_vertex || a->samples != b->samples)
        return false;
    for (size_t i = 0; i < a->n_modules; i++)
        if (strcmp(a->module[i], b->module[i]) != 0)
            return false;
    return true;
}

/* The index of this program in the plan, where an equal one may be already. There is room for all. */
static int add_program(struct rl_plan *plan, const struct rl_plan_program *program)
{
    for (size_t i = 0; i < plan->n_programs; i++)
        if (same_program(&plan->program[i], program))
            return (int)i;
    plan->program[plan->n_programs] = *program;
    return (int)plan->n_programs++;
}

/* A highlight that needs no more than point lights is drawn together with the surface. */
static bool has_own_pass(const struct rl_method *method)
{
    return method->sampled || method->needs_environment || method->needs_normal_map || method->needs_pattern;
}

/* `gives`: which of them, enum rl_effect_gives. */
static void add_effects(struct rl_plan_program *program, const struct rl_scene *scene,
                        const struct rl_plan_material *m, unsigned gives)
{
    for (size_t i = 0; i < m->n_effects; i++)
        if (gives & rl_effect_gives(m->effect[i]))
            rl_plan_add_effect(program, m->effect[i],
                               rl_effect_given(&scene->material[m->material], m->effect[i]));
}

/* The effects that give radiance, or the part of them that is asked for, and the lights that they see. */
static void add_shading(struct rl_plan_program *program, const struct rl_scene *scene,
                        const struct rl_plan_material *m, bool point_lights, unsigned gives)
{
    if (point_lights)
        add_module(program, "common", "lights");
    if (m->sees & (RL_SEES_SOURCES | RL_SEES_CENTROIDS))
        add_module(program, "common", "incident");
    if (m->sees & RL_SEES_SOURCES)
        add_module(program, "common", "sources");
    if (m->n_points > 0)
        add_module(program, "common", "point_sources");
    if (m->n_parallels > 0)
        add_module(program, "common", "parallel_sources");
    if (m->sees & RL_SEES_CENTROIDS)
        add_module(program, "common", "centroids");
    if (m->sees & RL_SEES_POLYGONS)
        add_module(program, "common", "polygons");
    add_effects(program, scene, m, gives);
}

/* By interpolation, and whether back faces are seen too, which have a shading of their own. */
static const struct {
    const char *vertex[2], *between[2];
} interpolated[RL_INTERPOLATIONS] = {
    [RL_INTERPOLATION_GOURAUD] = {{"gouraud_vertex", "gouraud_vertex_both"},
                                  {"radiance_smooth", "radiance_smooth_both"}},
    [RL_INTERPOLATION_CONSTANT] = {{"constant_vertex", "constant_vertex_both"},
                                   {"radiance_flat", "radiance_flat_both"}},
};

/* The effects in the vertex shader; in the fragment shader those that are the same everywhere, which would not come through the
 * interpolation as they are, and the highlight, if it is drawn together with them. */
static void add_interpolated(struct rl_plan_program *program, const struct rl_plan *plan,
                             const struct rl_scene *scene, const struct rl_plan_material *m, bool fused)
{
    bool both = !plan->settings.culling;
    add_module(program, "common", "surface");
    add_shading(program, scene, m, m->sees & RL_SEES_CENTROIDS, RL_GIVES_REFLECTED);
    end_vertex_shader(program, interpolated[m->interpolation].vertex[both]);
    add_module(program, "common", interpolated[m->interpolation].between[both]);
    add_effects(program, scene, m, RL_GIVES_CONSTANT);
    if (fused) {
        add_visible_modules(program, plan);
        if (m->method->needs_point_lights)
            add_module(program, "common", "lights");
        add_effects(program, scene, m, RL_GIVES_FACTOR);
        add_module(program, "methods", m->method->name);
    }
    add_module(program, "passes", fused ? "interpolated_highlight" : "interpolated");
}

static int surface_program(struct rl_plan *plan, const struct rl_scene *scene,
                           const struct rl_plan_material *m)
{
    struct rl_plan_program program = {.pass = "surface"};
    bool fused = m->method && !has_own_pass(m->method);
    if (m->interpolation != RL_INTERPOLATION_PHONG) {
        add_interpolated(&program, plan, scene, m, fused);
        return add_program(plan, &program);
    }
    add_object_modules(&program, plan);
    add_shading(&program, scene, m, m->n_point_lights > 0, RL_GIVES_CONSTANT | RL_GIVES_REFLECTED);
    if (fused)
        add_effects(&program, scene, m, RL_GIVES_FACTOR);
    if (fused)
        add_module(&program, "methods", m->method->name);
    add_module(&program, "passes", "surface");
    return add_program(plan, &program);
}

static int sphere_program(struct rl_plan *plan)
{
    struct rl_plan_program program = {.pass = "sphere"};
    add_object_modules(&program, plan);
    add_module(&program, "passes", "sphere");
    return add_program(plan, &program);
}

static int highlight_program(struct rl_plan *plan, const struct rl_scene *scene,
                             const struct rl_plan_material *m)
{
    struct rl_plan_program program = {.pass = "highlight", .samples = m->samples};
    add_object_modules(&program, plan);
    add_module(&program, "common", plan->settings.frame == RL_FRAME_PRINTED ? "frame_printed" : "frame");
    add_module(&program, "common", plan->settings.attenuation ? "attenuation" : "attenuation_off");
    if (m->method->needs_point_lights)
        add_module(&program, "common", "lights");
    if (m->method->needs_environment)
        add_module(&program, "common", "environment");
    if (m->method->needs_normal_map)
        add_module(&program, "common", "normal_map");
    if (m->method->needs_pattern)
        add_module(&program, "common", "pattern");
    add_effects(&program, scene, m, RL_GIVES_FACTOR);
    add_module(&program, "methods", m->method->name);
    add_module(&program, "passes", "highlight");
    return add_program(plan, &program);
}

int rl_plan_environment_program(struct rl_plan *plan)
{
    struct rl_plan_program program = {.pass = "environment"};
    end_vertex_shader(&program, "environment_vertex");
    add_module(&program, "passes", "environment");
    return add_program(plan, &program);
}

static int normal_map(struct rl_plan *plan, const struct rl_plan_material *m)
{
    for (size_t i = 0; i < plan->n_normal_maps; i++)
        if (plan->normal_map[i].rr == m->rr && plan->normal_map[i].method == m->method)
            return (int)i;
    plan->normal_map[plan->n_normal_maps] = (struct rl_plan_normal_map){m->rr, m->method};
    return (int)plan->n_normal_maps++;
}

static int pattern(struct rl_plan *plan, const struct rl_plan_material *m)
{
    for (size_t i = 0; i < plan->n_patterns; i++)
        if (plan->pattern[i].rr == m->rr && plan->pattern[i].samples == m->samples &&
            plan->pattern[i].method == m->method)
            return (int)i;
    plan->pattern[plan->n_patterns] = (struct rl_plan_pattern){m->rr, m->samples, m->method};
    return (int)plan->n_patterns++;
}

static void plan_sphere(struct rl_plan *plan, const struct rl_scene *scene, struct rl_plan_material *m)
{
    const struct rl_settings *s = &plan->settings;
    if (s->margin_kind == RL_MARGIN_OFF)
        return;
    m->margin = s->margin_kind == RL_MARGIN_AUTO ? rl_margin_auto(scene, m, s, s->margin_bound) : s->margin;
    if (isfinite(m->margin))
        m->sphere_program = sphere_program(plan);
}

void rl_plan_passes(struct rl_plan *plan, const struct rl_scene *scene, struct rl_plan_material *m)
{
    m->surface_program = surface_program(plan, scene, m);
    if (!m->method || !has_own_pass(m->method))
        return;
    plan_sphere(plan, scene, m);
    if (m->method->needs_normal_map)
        m->normal_map = normal_map(plan, m);
    if (m->method->needs_pattern)
        m->pattern = pattern(plan, m);
    m->highlight_program = highlight_program(plan, scene, m);
}
