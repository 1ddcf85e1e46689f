/* Derives a plan from a scene: which effects are in use, and from that programs, textures and passes (see
 * plan.h). */
#include "scene/plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/plan_build.h"

/* Whether the material's highlight, if it has one, is black: by its colour, or by a factor. */
static bool is_matt(const struct rl_material *material)
{
    const double *k_s = material->specular;
    bool matt = !(k_s[0] > 0.0 || k_s[1] > 0.0 || k_s[2] > 0.0);
    return matt || rl_plan_zero_factor(material);
}

/* With `drop` off what does nothing is planned all the same, where it can be. */
static bool plans_effect(const struct rl_plan *plan, const struct rl_plan_material *m,
                         const struct rl_material *material, const struct rl_effect *effect, unsigned there)
{
    if ((effect->factor && !m->method) || (effect->sees && !(effect->sees & there)))
        return false;
    return plan->settings.drop ? rl_effect_wanted(material, effect)
                               : rl_effect_given(material, effect) != NULL;
}

/* What the material itself says, with the settings' overrides. */
static void plan_material(struct rl_plan_material *m, const struct rl_plan *plan,
                          const struct rl_scene *scene, int index)
{
    const struct rl_material *material = &scene->material[index];
    const struct rl_settings *settings = &plan->settings;
    *m = (struct rl_plan_material){
        .material = index,
        .rr = settings->rr > 0.0 ? settings->rr : material->rr,
        .surface_program = -1,
        .highlight_program = -1,
        .sphere_program = -1,
        .normal_map = -1,
        .pattern = -1,
    };
    bool highlit = false;
    for (size_t i = 0; i < scene->n_objects; i++)
        highlit = highlit ||
                  (scene->object[i].material == index && plan->object[i].drawn && plan->object[i].highlit);
    if (plan->n_lights > 0 && highlit && material->method && !(settings->drop && is_matt(material)))
        m->method = rl_method_find(settings->method ? settings->method : material->method);
    if (m->method)
        m->samples =
            m->method->sampled && settings->samples > 0 ? settings->samples : m->method->default_samples;
    unsigned there = (plan->n_lights > 0 ? RL_SEES_CENTROIDS | RL_SEES_POLYGONS : 0) |
                     (plan->n_sources > 0 ? RL_SEES_SOURCES : 0);
    for (size_t i = 0; i < rl_n_effects; i++) {
        const struct rl_effect *effect = rl_effects[i];
        if (!plans_effect(plan, m, material, effect, there))
            continue;
        m->effect[m->n_effects++] = effect;
        m->sees |= effect->sees & there;
    }
    /* What sees no light is the pixel's: constants, and factors on the highlight. */
    if (m->sees)
        m->interpolation = settings->interpolation == RL_INTERPOLATION_OF_MATERIAL
                               ? material->interpolation
                               : (enum rl_interpolation)settings->interpolation;
    bool lit = m->sees & RL_SEES_CENTROIDS || (m->method && m->method->needs_point_lights);
    m->n_point_lights = lit ? (int)plan->n_lights : 0;
    if (m->sees & RL_SEES_SOURCES) {
        m->n_points = (int)plan->n_points;
        m->n_parallels = (int)(plan->n_sources - plan->n_points);
    }
}

/* Fills the materials that some object in view wears. */
static void plan_materials(struct rl_plan *plan, const struct rl_scene *scene)
{
    plan->n_materials = 0;
    plan->sees = 0;
    for (size_t i = 0; i < scene->n_materials; i++) {
        bool worn = !plan->settings.drop;
        for (size_t j = 0; j < scene->n_objects; j++)
            worn = worn || (plan->object[j].drawn && scene->object[j].material == (int)i);
        if (!worn)
            continue;
        plan_material(&plan->material[plan->n_materials], plan, scene, (int)i);
        plan->sees |= plan->material[plan->n_materials++].sees;
    }
}

/* False if some materials' methods run on the CPU alone and others' on the GPU. */
static bool choose_side(struct rl_plan *plan)
{
    size_t on_gpu = 0;
    /* Asked for a method of the CPU alone, or for shadows, a scene without any highlight is drawn there, too: the effects in double
     * precision. */
    const struct rl_method *asked = rl_method_find(plan->settings.method);
    plan->on_cpu = asked && !asked->on_gpu;
    for (size_t i = 0; i < plan->n_materials; i++) {
        const struct rl_method *method = plan->material[i].method;
        plan->on_cpu = plan->on_cpu || (method && !method->on_gpu);
        on_gpu += method && !method->on_cpu;
    }
    bool one_side = !plan->on_cpu || on_gpu == 0;
    plan->on_cpu = plan->on_cpu || plan->settings.shadows;
    return one_side;
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

/* Shadows take the integral itself, for which each part of a light is there or not; without a highlight, the CPU's effects. A method that is
 * asked for by name and has no highlight to draw is refused as well, for what it asks for is a GPU. */
static int check_shadows(const struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    for (size_t i = 0; i <= plan->n_materials && plan->settings.shadows; i++) {
        const struct rl_method *method =
            i < plan->n_materials ? plan->material[i].method : rl_method_find(plan->settings.method);
        if (method && (!method->on_cpu || method->shade || method->needs_environment))
            return rl_fail(error, RL_ERR_INPUT,
                           "%s: shadows are on, which the method %s cannot draw, expected a method that "
                           "integrates on the CPU: --method reference, or --shadows off",
                           scene->path, method->name);
    }
    return RL_OK;
}

/* OpenGL packs 8 bits of stencil with 24 or 32 of depth; a stencil buffer apart from the depth buffer is a frame buffer that drivers may
 * refuse (OpenGL 4.5, 9.4.2), and Mesa does. */
static int check_depth(const struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    for (size_t i = 0; i < plan->n_materials && plan->settings.depth_bits == 16; i++)
        if (plan->material[i].highlight_program >= 0)
            return rl_fail(
                error, RL_ERR_INPUT,
                "%s: a depth buffer of 16 bits, which has no stencil beside it, and the method %s, "
                "whose pass needs one, expected --depth-bits 24 or 32, or a method drawn with the "
                "surface: --method plain",
                scene->path, plan->material[i].method->name);
    return RL_OK;
}

static void plan_environments(struct rl_plan *plan, const struct rl_scene *scene)
{
    rl_plan_share_environments(plan, scene);
    plan->environment_program =
        plan->n_environments > 0 && !plan->on_cpu ? rl_plan_environment_program(plan) : -1;
}

static int allocate(struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    size_t n = scene->n_materials + 1;
    plan->material = calloc(n, sizeof *plan->material);
    plan->program = calloc(n * RL_PROGRAMS_PER_MATERIAL + 1, sizeof *plan->program);
    plan->normal_map = calloc(n, sizeof *plan->normal_map);
    plan->pattern = calloc(n, sizeof *plan->pattern);
    plan->environment = calloc(scene->n_objects + 1, sizeof *plan->environment);
    plan->object = calloc(scene->n_objects + 1, sizeof *plan->object);
    plan->light = calloc(scene->n_lights + 1, sizeof *plan->light);
    plan->source = calloc(scene->n_sources + 1, sizeof *plan->source);
    if (plan->material && plan->program && plan->normal_map && plan->pattern && plan->environment &&
        plan->object && plan->light && plan->source)
        return RL_OK;
    rl_plan_clear(plan);
    return rl_fail_memory(error, "a plan");
}

/* All of the scene, but for what the camera does not see. */
static void begin(struct rl_plan *plan, const struct rl_scene *scene)
{
    if (plan->settings.width == 0 || plan->settings.height == 0) {
        plan->settings.width = scene->width;
        plan->settings.height = scene->height;
    }
    plan->n_lights = scene->n_lights;
    for (size_t i = 0; i < scene->n_lights; i++)
        plan->light[i] = i;
    for (int parallel = 0; parallel < 2; parallel++)
        for (size_t i = 0; i < scene->n_sources; i++)
            if (scene->source[i].parallel == (parallel == 1)) {
                plan->source[plan->n_sources++] = i;
                plan->n_points += !parallel;
            }
    rl_plan_drop_objects(plan, scene);
    for (size_t i = 0; i < scene->n_objects; i++)
        plan->object[i].highlit = true;
}

static int check(struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    if (!choose_side(plan))
        return rl_fail(error, RL_ERR_INPUT,
                       "%s: the method %s runs on the CPU alone and %s on the GPU alone, expected one side "
                       "for all materials; "
                       "--method makes them one",
                       scene->path, method_only(plan, false), method_only(plan, true));
    int status = check_frame(plan, scene, error);
    return status == RL_OK ? check_shadows(plan, scene, error) : status;
}

/* Over all lights, dropped or not: dropping leaves texels as they are. */
static void scale_radiance(struct rl_plan *plan, const struct rl_scene *scene)
{
    double brightest = 0.0;
    for (size_t i = 0; i < scene->n_lights; i++)
        for (int c = 0; c < 3; c++)
            brightest = fmax(brightest, scene->light[i].radiance[c]);
    if (brightest > 0.0)
        plan->radiance_scale = (float)brightest;
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
    begin(plan, scene);
    plan_materials(plan, scene);
    status = check(plan, scene, error);
    if (status == RL_OK) {
        if (settings->drop) {
            rl_plan_drop_lights(plan, scene);
            plan_materials(plan, scene);
        }
        scale_radiance(plan, scene);
        for (size_t i = 0; i < plan->n_materials && !plan->on_cpu; i++) {
            rl_plan_passes(plan, scene, &plan->material[i]);
            plan->stencil = plan->stencil || plan->material[i].highlight_program >= 0;
        }
        plan_environments(plan, scene);
        plan->shadows = settings->shadows && (!settings->drop || !rl_plan_no_shadows(plan, scene));
        rl_plan_share_meshes(plan, scene);
        status = check_depth(plan, scene, error);
        if (status == RL_OK)
            status = rl_plan_list_drops(plan, scene, error);
    }
    if (status != RL_OK)
        rl_plan_clear(plan);
    return status;
}

void rl_plan_clear(struct rl_plan *plan)
{
    free(plan->material);
    free(plan->program);
    free(plan->normal_map);
    free(plan->pattern);
    free(plan->environment);
    free(plan->object);
    free(plan->light);
    free(plan->source);
    free(plan->drop);
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
