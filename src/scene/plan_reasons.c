/* What a plan leaves out, row by row, and the reason of each: in words, and as a code that does not change. */
#include <stdio.h>
#include <stdlib.h>

#include "scene/plan_build.h"

static const struct {
    const char *code, *words;
} reasons[RL_WHYS] = {
    [RL_WHY_NONE] = {"none", ""},
    [RL_WHY_OUTSIDE_VIEW] = {"outside-view", "outside the view"},
    [RL_WHY_ONLY_SHADOW] = {"only-its-shadow", "outside the view; its shadow is not"},
    [RL_WHY_LIGHTS_BEHIND_OBJECT] = {"lights-behind", "every shaped light is behind its surface"},
    [RL_WHY_LIGHTS_BEHIND_WEARERS] = {"lights-behind", "every shaped light is behind what wears it"},
    [RL_WHY_WEARERS_OUTSIDE_VIEW] = {"wearers-outside-view",
                                     "every object that wears it is outside the view"},
    [RL_WHY_NOT_WORN] = {"not-worn", "no object wears it"},
    [RL_WHY_NO_RADIANCE] = {"dark", "its radiance is 0"},
    [RL_WHY_NO_STRENGTH] = {"dark", "its strength is 0"},
    [RL_WHY_BEHIND_SURFACES] = {"behind-surfaces", "behind every surface that has a use for it"},
    [RL_WHY_UNSEEN] = {"unseen", "no effect or highlight sees such lights"},
    [RL_WHY_ZERO_COEFFICIENTS] = {"zero-coefficients", "its coefficients are 0"},
    [RL_WHY_NO_HIGHLIGHT] = {"no-highlight", "no highlight to be a factor of"},
    [RL_WHY_NO_LIGHT] = {"no-light", "no light for it"},
    [RL_WHY_ZERO_SPECULAR] = {"zero-specular", "specular is 0"},
    [RL_WHY_ZERO_FACTOR] = {"zero-factor", "its factor is 0"},
    [RL_WHY_NO_SHAPED_LIGHT] = {"no-shaped-light", "no shaped light"},
    [RL_WHY_LIGHTS_DARK] = {"lights-dark", "the radiance of every shaped light is 0"},
    [RL_WHY_TOO_ROUGH] = {"too-rough", "no sphere is large enough for so rough a surface"},
    [RL_WHY_NO_PASS] = {"no-highlight-pass", "no highlight that has a pass of its own"},
    [RL_WHY_SINGLE_OBJECT] = {"single-object", "a single object, which hides nothing from itself"},
    [RL_WHY_NOTHING_TO_HIDE] = {"no-light", "no light that could be hidden"},
};

const char *rl_plan_reason_code(enum rl_plan_reason why)
{
    return reasons[why].code;
}

/* A row: `drop` says what and why, `words` why where the reason's own do not. */
static int add(struct rl_plan *plan, struct rl_plan_drop drop, const char *name, const char *words,
               struct rl_error *error)
{
    struct rl_plan_drop *more = realloc(plan->drop, (plan->n_drops + 1) * sizeof *more);
    if (!more)
        return rl_fail_memory(error, "a plan");
    plan->drop = more;
    snprintf(drop.name, sizeof drop.name, "%s", name ? name : "?");
    snprintf(drop.reason, sizeof drop.reason, "%s", words ? words : reasons[drop.why].words);
    more[plan->n_drops++] = drop;
    return RL_OK;
}

/* An effect or a highlight of a material. */
static int add_of_material(struct rl_plan *plan, const struct rl_scene *scene, struct rl_plan_drop drop,
                           const char *name, const char *words, struct rl_error *error)
{
    char reason[sizeof drop.reason];
    snprintf(reason, sizeof reason, "material %s: %s", scene->material[drop.material].name,
             words ? words : reasons[drop.why].words);
    drop.object = -1;
    return add(plan, drop, name, reason, error);
}

static bool kept(const size_t *list, size_t n, size_t i)
{
    for (size_t k = 0; k < n; k++)
        if (list[k] == i)
            return true;
    return false;
}

static int list_objects(struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < scene->n_objects && status == RL_OK; i++) {
        const struct rl_plan_material *m = rl_plan_of_object(plan, scene, i);
        struct rl_plan_drop drop = {.material = scene->object[i].material, .object = (int)i};
        if (!plan->object[i].drawn) {
            drop.kind = "object";
            drop.why = plan->shadows ? RL_WHY_ONLY_SHADOW : RL_WHY_OUTSIDE_VIEW;
        } else if (m->method && !m->method->shade && !plan->object[i].highlit) {
            drop.kind = "highlight of object";
            drop.why = RL_WHY_LIGHTS_BEHIND_OBJECT;
        }
        if (drop.kind)
            status = add(plan, drop, scene->object[i].name, NULL, error);
    }
    for (size_t i = 0; i < scene->n_materials && status == RL_OK; i++) {
        size_t worn = 0, drawn = 0;
        for (size_t k = 0; k < scene->n_objects; k++) {
            worn += scene->object[k].material == (int)i;
            drawn += scene->object[k].material == (int)i && plan->object[k].drawn;
        }
        struct rl_plan_drop drop = {.kind = "material",
                                    .why = worn ? RL_WHY_WEARERS_OUTSIDE_VIEW : RL_WHY_NOT_WORN,
                                    .material = (int)i,
                                    .object = -1};
        if (drawn == 0 && plan->settings.drop)
            status = add(plan, drop, scene->material[i].name, NULL, error);
    }
    return status;
}

/* Why a light was dropped; what sees such lights is asked of the scene, for the plan's materials have lost sight of them. */
static enum rl_plan_reason why_light(const struct rl_plan *plan, const struct rl_scene *scene, unsigned sees)
{
    for (size_t i = 0; i < plan->n_materials; i++) {
        const struct rl_material *m = &scene->material[plan->material[i].material];
        if (sees & RL_SEES_CENTROIDS && m->method && !rl_plan_dark(m->specular) && !rl_plan_zero_factor(m))
            return RL_WHY_BEHIND_SURFACES;
        for (size_t row = 0; row < rl_n_effects; row++)
            if (rl_effects[row]->sees & sees && rl_effect_wanted(m, rl_effects[row]))
                return RL_WHY_BEHIND_SURFACES;
    }
    return RL_WHY_UNSEEN;
}

static int add_light(struct rl_plan *plan, const char *name, enum rl_plan_reason why, struct rl_error *error)
{
    struct rl_plan_drop drop = {.kind = "light", .why = why, .material = -1, .object = -1};
    return add(plan, drop, name, NULL, error);
}

static int list_lights(struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    int status = RL_OK;
    /* A dark one may hide another, and is dropped where it does not. */
    enum rl_plan_reason shaped = why_light(plan, scene, RL_SEES_CENTROIDS | RL_SEES_POLYGONS);
    enum rl_plan_reason source = why_light(plan, scene, RL_SEES_SOURCES);
    for (size_t i = 0; i < scene->n_lights && status == RL_OK; i++)
        if (!kept(plan->light, plan->n_lights, i))
            status = add_light(plan, scene->light[i].name,
                               rl_plan_dark(scene->light[i].radiance) ? RL_WHY_NO_RADIANCE : shaped, error);
    for (size_t i = 0; i < scene->n_sources && status == RL_OK; i++)
        if (!kept(plan->source, plan->n_sources, i))
            status = add_light(plan, scene->source[i].name,
                               rl_plan_dark(scene->source[i].strength) ? RL_WHY_NO_STRENGTH : source, error);
    return status;
}

static bool all_dark(const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_lights; i++)
        if (!rl_plan_dark(scene->light[i].radiance))
            return false;
    return true;
}

static enum rl_plan_reason why_no_method(const struct rl_scene *scene, const struct rl_material *material)
{
    return rl_plan_dark(material->specular) ? RL_WHY_ZERO_SPECULAR
           : rl_plan_zero_factor(material)  ? RL_WHY_ZERO_FACTOR
           : !scene->n_lights               ? RL_WHY_NO_SHAPED_LIGHT
           : all_dark(scene)                ? RL_WHY_LIGHTS_DARK
                                            : RL_WHY_LIGHTS_BEHIND_WEARERS;
}

static int list_effects(struct rl_plan *plan, const struct rl_scene *scene, const struct rl_plan_material *m,
                        struct rl_error *error)
{
    const struct rl_material *material = &scene->material[m->material];
    struct rl_plan_drop drop = {.kind = "effect", .material = m->material};
    int status = RL_OK;
    for (size_t row = 0; row < rl_n_effects && status == RL_OK; row++) {
        bool planned = false;
        for (size_t i = 0; i < m->n_effects; i++)
            planned = planned || m->effect[i] == rl_effects[row];
        if (planned || !rl_effect_given(material, rl_effects[row]))
            continue;
        drop.why = !rl_effect_wanted(material, rl_effects[row]) ? RL_WHY_ZERO_COEFFICIENTS
                   : rl_effects[row]->factor                    ? RL_WHY_NO_HIGHLIGHT
                                                                : RL_WHY_NO_LIGHT;
        status = add_of_material(plan, scene, drop, rl_effects[row]->name, NULL, error);
    }
    if (status != RL_OK || !material->method || m->method)
        return status;
    char factor[80];
    drop.kind = "highlight";
    drop.why = why_no_method(scene, material);
    if (drop.why == RL_WHY_ZERO_FACTOR)
        snprintf(factor, sizeof factor, "its factor %.60s is 0", rl_plan_zero_factor(material)->name);
    return add_of_material(plan, scene, drop, material->method,
                           drop.why == RL_WHY_ZERO_FACTOR ? factor : NULL, error);
}

/* An object never hides a light from itself. */
enum rl_plan_reason rl_plan_no_shadows(const struct rl_plan *plan, const struct rl_scene *scene)
{
    bool lit = plan->sees != 0;
    for (size_t i = 0; i < plan->n_materials; i++)
        lit = lit || plan->material[i].method;
    if (scene->n_objects < 2)
        return RL_WHY_SINGLE_OBJECT;
    return lit ? RL_WHY_NONE : RL_WHY_NOTHING_TO_HIDE;
}

/* Settings that were asked for and find nothing to act on. */
static int list_settings(struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    const struct rl_settings *s = &plan->settings;
    struct rl_plan_drop drop = {.kind = "effect", .material = -1, .object = -1};
    bool own_pass = false, sphere = false;
    for (size_t i = 0; i < plan->n_materials; i++) {
        own_pass = own_pass || plan->material[i].highlight_program >= 0;
        sphere = sphere || plan->material[i].sphere_program >= 0;
    }
    int status = RL_OK;
    drop.why = own_pass ? RL_WHY_TOO_ROUGH : RL_WHY_NO_PASS;
    if (s->margin_kind != RL_MARGIN_OFF && !sphere)
        status = add(plan, drop, "sphere", NULL, error);
    drop.why = rl_plan_no_shadows(plan, scene);
    if (status == RL_OK && s->shadows && !plan->shadows)
        status = add(plan, drop, "shadows", NULL, error);
    return status;
}

int rl_plan_list_drops(struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    int status = list_objects(plan, scene, error);
    if (status == RL_OK)
        status = list_lights(plan, scene, error);
    for (size_t i = 0; i < plan->n_materials && status == RL_OK; i++)
        status = list_effects(plan, scene, &plan->material[i], error);
    return status == RL_OK ? list_settings(plan, scene, error) : status;
}
