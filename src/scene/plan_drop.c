/* What cannot matter in this scene, and why (see plan_build.h). Nothing is dropped that could change a pixel by a bit: every test leaves room
 * for rounding in single precision, and doubt keeps. */
#include <math.h>

#include "scene/plan_build.h"

/* Room for rounding, in units of the lengths compared. */
#define SLACK RL_VIEW_SLACK

const struct rl_effect *rl_plan_zero_factor(const struct rl_material *material)
{
    for (size_t row = 0; row < rl_n_effects; row++)
        if (rl_effects[row]->factor && rl_effect_given(material, rl_effects[row]) &&
            !rl_effect_wanted(material, rl_effects[row]))
            return rl_effects[row];
    return NULL;
}

/* ---- Objects ---- */

/* Whether the object's sphere lies outside one of the six sides of what the camera sees. */
static bool out_of_view(const struct rl_plan *plan, const struct rl_scene *scene,
                        const struct rl_object *object)
{
    const struct rl_camera *c = &scene->camera;
    rl_vec3 d = v3_sub(object->centre, c->position);
    double z = v3_dot(d, c->forward), r = object->radius + SLACK * (v3_length(d) + object->radius);
    return z + r <= c->near_plane || z - r >= c->far_plane ||
           rl_camera_misses(c, plan->settings.width, plan->settings.height, object->centre, object->radius);
}

void rl_plan_drop_objects(struct rl_plan *plan, const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++)
        plan->object[i].drawn = !plan->settings.drop || !out_of_view(plan, scene, &scene->object[i]);
}

/* ---- Lights ---- */

bool rl_plan_dark(const double strength[3])
{
    return !(strength[0] > 0.0) && !(strength[1] > 0.0) && !(strength[2] > 0.0);
}

/* Whether a light can hide another: from the highlight of an object, in its environment map or in the integral itself. */
static bool lights_hide(const struct rl_plan *plan, const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++) {
        const struct rl_plan_material *m = rl_plan_of_object(plan, scene, i);
        if (plan->object[i].drawn && plan->object[i].highlit && m->method && !m->method->shade)
            return true;
    }
    return false;
}

/* Whether anything of the material sees such lights at all. */
static bool uses(const struct rl_plan_material *m, unsigned sees)
{
    return m->sees & sees || (sees & RL_SEES_CENTROIDS && m->method);
}

/* What of the light the material has a use for even where it is below the horizon. */
static bool looks_below(const struct rl_plan *plan, const struct rl_plan_material *m, unsigned sees)
{
    for (size_t i = 0; i < m->n_effects; i++)
        if (m->effect[i]->below && m->effect[i]->sees & sees)
            return true;
    if (!(sees & RL_SEES_CENTROIDS) || !m->method || m->method->shade)
        return false;
    /* The CPU adds the texels of a map up in groups: without those of a light it might round the others' sum otherwise. */
    return !plan->settings.attenuation || (m->method->needs_environment && plan->on_cpu);
}

/* From the object's centre highlights see the lights in an environment map, by two texels' width, or where that is asked for. */
static double centre_of(const struct rl_plan *plan, const struct rl_plan_material *m, unsigned sees)
{
    if (!(sees & RL_SEES_CENTROIDS) || !m->method)
        return -1.0;
    if (m->method->needs_environment)
        return SLACK + 4.0 / plan->settings.env_size;
    return plan->settings.light_from == RL_LIGHT_FROM_OBJECT ? SLACK : -1.0;
}

/* Whether this object has no use for the body, which the effects see in one of these ways. */
static bool unseen(const struct rl_plan *plan, const struct rl_scene *scene, size_t object,
                   const struct rl_plan_body *body, unsigned sees)
{
    const struct rl_plan_material *m = rl_plan_of_object(plan, scene, object);
    if (!uses(m, sees))
        return true;
    /* A surface that is seen from both sides has no light behind it. */
    return plan->settings.culling && !looks_below(plan, m, sees) &&
           rl_plan_behind(body, &scene->object[object], centre_of(plan, m, sees)) &&
           (m->interpolation != RL_INTERPOLATION_CONSTANT ||
            rl_plan_behind_facets(body, &scene->object[object].mesh));
}

static bool unseen_by_all(const struct rl_plan *plan, const struct rl_scene *scene,
                          const struct rl_plan_body *body, unsigned sees)
{
    for (size_t i = 0; i < scene->n_objects; i++)
        if (plan->object[i].drawn && !unseen(plan, scene, i, body, sees))
            return false;
    return true;
}

/* Which objects some shaped light that shines is in front of. */
static void find_highlit(struct rl_plan *plan, const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++) {
        bool lit = false;
        for (size_t k = 0; k < plan->n_lights && plan->object[i].drawn && !lit; k++) {
            const struct rl_light *light = &scene->light[plan->light[k]];
            struct rl_plan_body body = rl_plan_body_of_light(light);
            lit = !rl_plan_dark(light->radiance) &&
                  !unseen(plan, scene, i, &body, RL_SEES_CENTROIDS | RL_SEES_POLYGONS);
        }
        plan->object[i].highlit = lit;
    }
}

void rl_plan_drop_lights(struct rl_plan *plan, const struct rl_scene *scene)
{
    find_highlit(plan, scene);
    bool hide = lights_hide(plan, scene);
    size_t n = 0;
    for (size_t i = 0; i < plan->n_lights; i++) {
        const struct rl_light *light = &scene->light[plan->light[i]];
        struct rl_plan_body body = rl_plan_body_of_light(light);
        bool nothing = rl_plan_dark(light->radiance) && !hide;
        if (!nothing && !unseen_by_all(plan, scene, &body, RL_SEES_CENTROIDS | RL_SEES_POLYGONS))
            plan->light[n++] = plan->light[i];
    }
    plan->n_lights = n;
    n = plan->n_points = 0;
    for (size_t i = 0; i < plan->n_sources; i++) {
        const struct rl_source *source = &scene->source[plan->source[i]];
        const struct rl_plan_body body = {.at = source->at, .parallel = source->parallel};
        if (rl_plan_dark(source->strength) || unseen_by_all(plan, scene, &body, RL_SEES_SOURCES))
            continue;
        plan->source[n++] = plan->source[i];
        plan->n_points += !source->parallel;
    }
    plan->n_sources = n;
}
