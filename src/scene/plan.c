/* Derives a plan from a scene: which effects are in use, and from that programs, textures and passes (see
 * plan.h). */
#include "scene/plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/margin.h"

/* Programs a material can need: surface, sphere, highlight. */
enum { PROGRAMS_PER_MATERIAL = 3 };

static void add_module(struct rl_plan_program *program, const char *folder, const char *name)
{
    snprintf(program->module[program->n_modules++], RL_PLAN_MODULE_NAME, "%s/%s", folder, name);
}

void rl_plan_add_module(struct rl_plan_program *program, const char *module)
{
    for (size_t i = 0; i < program->n_modules; i++)
        if (strcmp(program->module[i], module) == 0)
            return;
    snprintf(program->module[program->n_modules++], RL_PLAN_MODULE_NAME, "%s", module);
}

/* What every program over objects begins with. */
static void add_object_modules(struct rl_plan_program *program)
{
    add_module(program, "passes", "object_vertex");
    add_module(program, "common", "surface");
    add_module(program, "common", "visible");
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
    if (a->n_modules != b->n_modules || a->samples != b->samples)
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

static int surface_program(struct rl_plan *plan, const struct rl_scene *scene,
                           const struct rl_plan_material *m)
{
    struct rl_plan_program program = {.pass = "surface"};
    bool fused = m->method && !has_own_pass(m->method);
    add_object_modules(&program);
    if (m->n_point_lights > 0)
        add_module(&program, "common", "lights");
    if (m->sees & (RL_SEES_SOURCES | RL_SEES_CENTROIDS))
        add_module(&program, "common", "incident");
    if (m->sees & RL_SEES_SOURCES)
        add_module(&program, "common", "sources");
    if (m->sees & RL_SEES_CENTROIDS)
        add_module(&program, "common", "centroids");
    if (m->sees & RL_SEES_POLYGONS)
        add_module(&program, "common", "polygons");
    for (size_t i = 0; i < m->n_effects; i++)
        rl_plan_add_effect(&program, m->effect[i],
                           rl_effect_given(&scene->material[m->material], m->effect[i]));
    if (fused)
        add_module(&program, "methods", m->method->name);
    add_module(&program, "passes", "surface");
    return add_program(plan, &program);
}

static int sphere_program(struct rl_plan *plan)
{
    struct rl_plan_program program = {.pass = "sphere"};
    add_object_modules(&program);
    add_module(&program, "passes", "sphere");
    return add_program(plan, &program);
}

static int highlight_program(struct rl_plan *plan, const struct rl_plan_material *m)
{
    struct rl_plan_program program = {.pass = "highlight", .samples = m->samples};
    add_object_modules(&program);
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
    add_module(&program, "methods", m->method->name);
    add_module(&program, "passes", "highlight");
    return add_program(plan, &program);
}

static int environment_program(struct rl_plan *plan)
{
    struct rl_plan_program program = {.pass = "environment"};
    add_module(&program, "passes", "environment_vertex");
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
    m->margin =
        s->margin_kind == RL_MARGIN_AUTO ? rl_margin_auto(scene, m, s, RL_MARGIN_AUTO_LOSS) : s->margin;
    if (isfinite(m->margin))
        m->sphere_program = sphere_program(plan);
}

/* What the material itself says, with the settings' overrides. */
static void plan_material(struct rl_plan_material *m, const struct rl_scene *scene, int index,
                          const struct rl_settings *settings)
{
    const struct rl_material *material = &scene->material[index];
    *m = (struct rl_plan_material){
        .material = index,
        .rr = settings->rr > 0.0 ? settings->rr : material->rr,
        .surface_program = -1,
        .highlight_program = -1,
        .sphere_program = -1,
        .normal_map = -1,
        .pattern = -1,
    };
    const double *k_s = material->specular;
    bool shiny = k_s[0] > 0.0 || k_s[1] > 0.0 || k_s[2] > 0.0;
    if (scene->n_lights > 0 && shiny && material->method)
        m->method = rl_method_find(settings->method ? settings->method : material->method);
    if (m->method)
        m->samples =
            m->method->sampled && settings->samples > 0 ? settings->samples : m->method->default_samples;
    unsigned there = (scene->n_lights > 0 ? RL_SEES_CENTROIDS | RL_SEES_POLYGONS : 0) |
                     (scene->n_sources > 0 ? RL_SEES_SOURCES : 0);
    for (size_t i = 0; i < rl_n_effects; i++) {
        const struct rl_effect *effect = rl_effects[i];
        if (!rl_effect_wanted(material, effect) || (effect->sees && !(effect->sees & there)))
            continue;
        m->effect[m->n_effects++] = effect;
        m->sees |= effect->sees & there;
    }
    bool lit = m->sees & RL_SEES_CENTROIDS || (m->method && m->method->needs_point_lights);
    m->n_point_lights = lit ? (int)scene->n_lights : 0;
}

static void plan_passes(struct rl_plan *plan, const struct rl_scene *scene, struct rl_plan_material *m)
{
    m->surface_program = surface_program(plan, scene, m);
    if (!m->method || !has_own_pass(m->method))
        return;
    plan_sphere(plan, scene, m);
    if (m->method->needs_normal_map)
        m->normal_map = normal_map(plan, m);
    if (m->method->needs_pattern)
        m->pattern = pattern(plan, m);
    m->highlight_program = highlight_program(plan, m);
}

/* Fills the materials that some object wears; false if some of their methods run on the CPU alone and
 * others on the GPU. */
static bool plan_materials(struct rl_plan *plan, const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_materials; i++) {
        bool worn = false;
        for (size_t j = 0; j < scene->n_objects; j++)
            worn = worn || scene->object[j].material == (int)i;
        if (!worn)
            continue;
        plan_material(&plan->material[plan->n_materials], scene, (int)i, &plan->settings);
        plan->sees |= plan->material[plan->n_materials++].sees;
    }
    size_t on_gpu = 0;
    /* Asked for a method of the CPU alone, a scene without any highlight is drawn there, too: the effects in double precision. */
    const struct rl_method *asked = rl_method_find(plan->settings.method);
    plan->on_cpu = asked && !asked->on_gpu;
    for (size_t i = 0; i < plan->n_materials; i++) {
        const struct rl_method *method = plan->material[i].method;
        plan->on_cpu = plan->on_cpu || (method && !method->on_gpu);
        on_gpu += method && !method->on_cpu;
    }
    return !plan->on_cpu || on_gpu == 0;
}

/* RL_ERR_INPUT: a method that takes no other frame than the orthonormal one is asked for another. */
static int check_frame(const struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    enum rl_frame_kind frame = plan->settings.frame;
    for (size_t i = 0; i < plan->n_materials && frame != RL_FRAME_ORTHONORMAL; i++) {
        const struct rl_method *method = plan->material[i].method;
        if (method && method->orthonormal_only)
            return rl_fail(error, RL_ERR_INPUT, "%s: the method %s with the frame %s, expected the frame %s",
                           scene->path, method->name, rl_frame_name(frame),
                           rl_frame_name(RL_FRAME_ORTHONORMAL));
    }
    return RL_OK;
}

/* The name of the first method that runs on the GPU (or on the CPU) alone. */
static const char *method_only(const struct rl_plan *plan, bool on_gpu)
{
    for (size_t i = 0; i < plan->n_materials; i++) {
        const struct rl_method *method = plan->material[i].method;
        if (method && (on_gpu ? !method->on_cpu : !method->on_gpu))
            return method->name;
    }
    return "";
}

/* Shadows take the integral itself, for which each part of a light is there or not. */
static int check_shadows(const struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    for (size_t i = 0; i < plan->n_materials && plan->settings.shadows; i++) {
        const struct rl_method *method = plan->material[i].method;
        if (method && (!method->on_cpu || method->shade || method->needs_environment))
            return rl_fail(error, RL_ERR_INPUT,
                           "%s: shadows are on, which the method %s cannot draw, expected a method that "
                           "integrates on the CPU: --method reference, or --shadows off",
                           scene->path, method->name);
    }
    return RL_OK;
}

static void plan_environments(struct rl_plan *plan, const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++) {
        const struct rl_plan_material *m = rl_plan_of_object(plan, scene, i);
        bool needed = m->method && m->method->needs_environment;
        plan->environment[i] = needed ? (int)plan->n_environments++ : -1;
    }
    plan->environment_program = plan->n_environments > 0 && !plan->on_cpu ? environment_program(plan) : -1;
}

static int allocate(struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    size_t n = scene->n_materials + 1;
    plan->material = calloc(n, sizeof *plan->material);
    plan->program = calloc(n * PROGRAMS_PER_MATERIAL + 1, sizeof *plan->program);
    plan->normal_map = calloc(n, sizeof *plan->normal_map);
    plan->pattern = calloc(n, sizeof *plan->pattern);
    plan->environment = calloc(scene->n_objects + 1, sizeof *plan->environment);
    if (plan->material && plan->program && plan->normal_map && plan->pattern && plan->environment)
        return RL_OK;
    rl_plan_clear(plan);
    return rl_fail_memory(error, "a plan");
}

int rl_plan_make(struct rl_plan *plan, const struct rl_scene *scene, const struct rl_settings *settings,
                 struct rl_error *error)
{
    *plan = (struct rl_plan){.settings = *settings, .environment_program = -1, .radiance_scale = 1.0f};
    int status = rl_settings_check(settings, error);
    if (status == RL_OK)
        status = allocate(plan, scene, error);
    if (status != RL_OK)
        return status;
    if (plan->settings.width == 0 || plan->settings.height == 0) {
        plan->settings.width = scene->width;
        plan->settings.height = scene->height;
    }
    if (!plan_materials(plan, scene)) {
        status = rl_fail(error, RL_ERR_INPUT,
                         "%s: the method %s runs on the CPU alone and %s on the GPU alone, expected one side "
                         "for all materials; "
                         "--method makes them one",
                         scene->path, method_only(plan, false), method_only(plan, true));
        rl_plan_clear(plan);
        return status;
    }
    status = check_frame(plan, scene, error);
    if (status == RL_OK)
        status = check_shadows(plan, scene, error);
    if (status != RL_OK) {
        rl_plan_clear(plan);
        return status;
    }
    double brightest = 0.0;
    for (size_t i = 0; i < scene->n_lights; i++)
        for (int c = 0; c < 3; c++)
            brightest = fmax(brightest, scene->light[i].radiance[c]);
    if (brightest > 0.0)
        plan->radiance_scale = (float)brightest;
    for (size_t i = 0; i < plan->n_materials && !plan->on_cpu; i++)
        plan_passes(plan, scene, &plan->material[i]);
    plan_environments(plan, scene);
    return RL_OK;
}

void rl_plan_clear(struct rl_plan *plan)
{
    free(plan->material);
    free(plan->program);
    free(plan->normal_map);
    free(plan->pattern);
    free(plan->environment);
    *plan = (struct rl_plan){0};
}

const struct rl_plan_material *rl_plan_of_object(const struct rl_plan *plan, const struct rl_scene *scene,
                                                 size_t object)
{
    for (size_t i = 0; i < plan->n_materials; i++)
        if (plan->material[i].material == scene->object[object].material)
            return &plan->material[i];
    return NULL;
}
