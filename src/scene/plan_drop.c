/* What cannot matter in this scene, and why (see plan_build.h). Nothing is dropped that could change a pixel by a bit: every test leaves room
 * for rounding in single precision, and doubt keeps. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

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

/* A light for this purpose: a sphere, or a direction. */
struct body {
    rl_vec3 at;
    double radius;
    bool parallel;
};

static rl_vec3 position(const struct rl_mesh *mesh, size_t vertex)
{
    return v3(mesh->position[vertex][0], mesh->position[vertex][1], mesh->position[vertex][2]);
}

/* N.(x - P) < 0 for every x of the body. `sine`: of the angle below the horizon that is asked for. */
static bool below(const struct body *body, rl_vec3 P, rl_vec3 N, double sine)
{
    if (body->parallel)
        return v3_dot(N, body->at) <= -sine;
    rl_vec3 d = v3_sub(body->at, P);
    return v3_dot(N, d) + body->radius <= -sine * (v3_length(d) + body->radius);
}

/* Whether the body is below the horizon everywhere on the mesh. Between vertices normal and point are weighted means of those at a
 * triangle's corners, N = sum a_i N_i (before it is made a unit vector) and P = sum a_j P_j, so that N.(x - P) is a mean of
 * N_i.(x - P_j). `centre`: the same as seen from the centre, by an angle of this sine, for what is seen from there; negative: nothing is. */
static bool behind(const struct body *body, const struct rl_object *object, double centre)
{
    const struct rl_mesh *mesh = &object->mesh;
    for (size_t t = 0; t < mesh->n_triangles; t++)
        for (int i = 0; i < 3; i++) {
            const float *n = mesh->normal[mesh->triangle[t][i]];
            rl_vec3 N = v3_normalize(v3(n[0], n[1], n[2]));
            if (centre >= 0.0 && !below(body, object->centre, N, centre))
                return false;
            for (int j = 0; j < 3; j++)
                if (!below(body, position(mesh, mesh->triangle[t][j]), N, SLACK))
                    return false;
        }
    return true;
}

/* The same of triangles that are shaded as a whole: the normals of their planes are no means of those at their corners. */
static bool behind_facets(const struct body *body, const struct rl_mesh *mesh)
{
    for (size_t t = 0; t < mesh->n_triangles; t++) {
        rl_vec3 P, N;
        rl_mesh_facet(mesh, t, &P, &N);
        if (!below(body, P, N, SLACK))
            return false;
    }
    return true;
}

static bool dark(const double strength[3])
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
                   const struct body *body, unsigned sees)
{
    const struct rl_plan_material *m = rl_plan_of_object(plan, scene, object);
    if (!uses(m, sees))
        return true;
    /* A surface that is seen from both sides has no light behind it. */
    return plan->settings.culling && !looks_below(plan, m, sees) &&
           behind(body, &scene->object[object], centre_of(plan, m, sees)) &&
           (m->interpolation != RL_INTERPOLATION_CONSTANT ||
            behind_facets(body, &scene->object[object].mesh));
}

static bool unseen_by_all(const struct rl_plan *plan, const struct rl_scene *scene, const struct body *body,
                          unsigned sees)
{
    for (size_t i = 0; i < scene->n_objects; i++)
        if (plan->object[i].drawn && !unseen(plan, scene, i, body, sees))
            return false;
    return true;
}

static struct body body_of_light(const struct rl_light *light)
{
    return (struct body){.at = light->centre, .radius = light->radius};
}

/* Which objects some shaped light that shines is in front of. */
static void find_highlit(struct rl_plan *plan, const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++) {
        bool lit = false;
        for (size_t k = 0; k < plan->n_lights && plan->object[i].drawn && !lit; k++) {
            const struct rl_light *light = &scene->light[plan->light[k]];
            struct body body = body_of_light(light);
            lit = !dark(light->radiance) &&
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
        struct body body = body_of_light(light);
        bool nothing = dark(light->radiance) && !hide;
        if (!nothing && !unseen_by_all(plan, scene, &body, RL_SEES_CENTROIDS | RL_SEES_POLYGONS))
            plan->light[n++] = plan->light[i];
    }
    plan->n_lights = n;
    n = plan->n_points = 0;
    for (size_t i = 0; i < plan->n_sources; i++) {
        const struct rl_source *source = &scene->source[plan->source[i]];
        const struct body body = {.at = source->at, .parallel = source->parallel};
        if (dark(source->strength) || unseen_by_all(plan, scene, &body, RL_SEES_SOURCES))
            continue;
        plan->source[n++] = plan->source[i];
        plan->n_points += !source->parallel;
    }
    plan->n_sources = n;
}

/* ---- Reasons ---- */

static int add(struct rl_plan *plan, struct rl_error *error, const char *kind, const char *name,
               const char *reason, ...) __attribute__((format(printf, 5, 6)));

static int add(struct rl_plan *plan, struct rl_error *error, const char *kind, const char *name,
               const char *reason, ...)
{
    struct rl_plan_drop *more = realloc(plan->drop, (plan->n_drops + 1) * sizeof *more);
    if (!more)
        return rl_fail_memory(error, "a plan");
    plan->drop = more;
    struct rl_plan_drop *drop = &more[plan->n_drops++];
    va_list values;
    va_start(values, reason);
    drop->kind = kind;
    snprintf(drop->name, sizeof drop->name, "%s", name ? name : "?");
    vsnprintf(drop->reason, sizeof drop->reason, reason, values);
    va_end(values);
    return RL_OK;
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
        const char *name = scene->object[i].name;
        if (!plan->object[i].drawn)
            status = add(plan, error, "object", name, "%s",
                         plan->shadows ? "outside the view; its shadow is not" : "outside the view");
        else if (m->method && !m->method->shade && !plan->object[i].highlit)
            status =
                add(plan, error, "highlight of object", name, "every shaped light is behind its surface");
    }
    for (size_t i = 0; i < scene->n_materials && status == RL_OK; i++) {
        size_t worn = 0, drawn = 0;
        for (size_t k = 0; k < scene->n_objects; k++) {
            worn += scene->object[k].material == (int)i;
            drawn += scene->object[k].material == (int)i && plan->object[k].drawn;
        }
        if (drawn == 0 && plan->settings.drop)
            status = add(plan, error, "material", scene->material[i].name, "%s",
                         worn ? "every object that wears it is outside the view" : "no object wears it");
    }
    return status;
}

/* Why a light was dropped; what sees such lights is asked of the scene, for the plan's materials have lost sight of them. */
static const char *why_light(const struct rl_plan *plan, const struct rl_scene *scene, unsigned sees)
{
    for (size_t i = 0; i < plan->n_materials; i++) {
        const struct rl_material *m = &scene->material[plan->material[i].material];
        if (sees & RL_SEES_CENTROIDS && m->method && !dark(m->specular) && !rl_plan_zero_factor(m))
            return "behind every surface that has a use for it";
        for (size_t row = 0; row < rl_n_effects; row++)
            if (rl_effects[row]->sees & sees && rl_effect_wanted(m, rl_effects[row]))
                return "behind every surface that has a use for it";
    }
    return "no effect or highlight sees such lights";
}

static int list_lights(struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    int status = RL_OK;
    /* A dark one may hide another, and is dropped where it does not. */
    const char *shaped = why_light(plan, scene, RL_SEES_CENTROIDS | RL_SEES_POLYGONS);
    const char *source = why_light(plan, scene, RL_SEES_SOURCES);
    for (size_t i = 0; i < scene->n_lights && status == RL_OK; i++)
        if (!kept(plan->light, plan->n_lights, i))
            status = add(plan, error, "light", scene->light[i].name, "%s",
                         dark(scene->light[i].radiance) ? "its radiance is 0" : shaped);
    for (size_t i = 0; i < scene->n_sources && status == RL_OK; i++)
        if (!kept(plan->source, plan->n_sources, i))
            status = add(plan, error, "light", scene->source[i].name, "%s",
                         dark(scene->source[i].strength) ? "its strength is 0" : source);
    return status;
}

static bool all_dark(const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_lights; i++)
        if (!dark(scene->light[i].radiance))
            return false;
    return true;
}

static int list_effects(struct rl_plan *plan, const struct rl_scene *scene, const struct rl_plan_material *m,
                        struct rl_error *error)
{
    const struct rl_material *material = &scene->material[m->material];
    int status = RL_OK;
    for (size_t row = 0; row < rl_n_effects && status == RL_OK; row++) {
        bool planned = false;
        for (size_t i = 0; i < m->n_effects; i++)
            planned = planned || m->effect[i] == rl_effects[row];
        if (planned || !rl_effect_given(material, rl_effects[row]))
            continue;
        status = add(plan, error, "effect", rl_effects[row]->name, "material %s: %s", material->name,
                     !rl_effect_wanted(material, rl_effects[row]) ? "its coefficients are 0"
                     : rl_effects[row]->factor                    ? "no highlight to be a factor of"
                                                                  : "no light for it");
    }
    if (status != RL_OK || !material->method || m->method)
        return status;
    const struct rl_effect *zero = rl_plan_zero_factor(material);
    char reason[80];
    snprintf(reason, sizeof reason, "its factor %.60s is 0", zero ? zero->name : "");
    return add(plan, error, "highlight", material->method, "material %s: %s", material->name,
               dark(material->specular) ? "specular is 0"
               : zero                   ? reason
               : !scene->n_lights       ? "no shaped light"
               : all_dark(scene)        ? "the radiance of every shaped light is 0"
                                        : "every shaped light is behind what wears it");
}

/* An object never hides a light from itself. */
const char *rl_plan_no_shadows(const struct rl_plan *plan, const struct rl_scene *scene)
{
    bool lit = plan->sees != 0;
    for (size_t i = 0; i < plan->n_materials; i++)
        lit = lit || plan->material[i].method;
    if (scene->n_objects < 2)
        return "a single object, which hides nothing from itself";
    return lit ? NULL : "no light that could be hidden";
}

/* Settings that were asked for and find nothing to act on. */
static int list_settings(struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error)
{
    const struct rl_settings *s = &plan->settings;
    bool own_pass = false, sphere = false;
    for (size_t i = 0; i < plan->n_materials; i++) {
        own_pass = own_pass || plan->material[i].highlight_program >= 0;
        sphere = sphere || plan->material[i].sphere_program >= 0;
    }
    int status = RL_OK;
    if (s->margin_kind != RL_MARGIN_OFF && !sphere)
        status = add(plan, error, "effect", "sphere", "%s",
                     own_pass ? "no sphere is large enough for so rough a surface"
                              : "no highlight that has a pass of its own");
    if (status == RL_OK && s->shadows && !plan->shadows)
        status = add(plan, error, "effect", "shadows", "%s", rl_plan_no_shadows(plan, scene));
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
