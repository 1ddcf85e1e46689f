/* See features.h. */
#include "studies/features.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

size_t rl_features_list(struct rl_feature feature[RL_FEATURES_MAX])
{
    static const char *const switches[RL_SWITCHES] = {"attenuation", "sphere", "culling"};
    size_t n = 0;
    for (size_t i = 0; i < rl_n_effects; i++)
        feature[n++] = (struct rl_feature){
            .name = rl_effects[i]->name, .kind = RL_FEATURE_EFFECT, .effect = rl_effects[i]};
    for (size_t i = 0; i < rl_n_methods && n < RL_FEATURES_MAX - RL_SWITCHES; i++)
        if (rl_methods[i]->on_gpu)
            feature[n++] = (struct rl_feature){
                .name = rl_methods[i]->name, .kind = RL_FEATURE_HIGHLIGHT, .method = rl_methods[i]};
    for (int i = 0; i < RL_SWITCHES; i++)
        feature[n++] = (struct rl_feature){
            .name = switches[i], .kind = RL_FEATURE_SWITCH, .which = (enum rl_feature_switch)i};
    return n;
}

const char *rl_feature_kind_name(enum rl_feature_kind kind)
{
    static const char *const name[] = {"effect", "highlight", "switch"};
    return name[kind];
}

bool rl_feature_needs_highlight(const struct rl_feature *f)
{
    return (f->kind == RL_FEATURE_SWITCH && f->which != RL_SWITCH_CULLING) ||
           (f->kind == RL_FEATURE_EFFECT && f->effect->factor);
}

static bool is_worn(const struct rl_scene *scene, size_t material)
{
    for (size_t i = 0; i < scene->n_objects; i++)
        if (scene->object[i].material == (int)material)
            return true;
    return false;
}

static bool has(const struct rl_material *m, const struct rl_feature *f)
{
    if (f->kind == RL_FEATURE_EFFECT)
        return rl_effect_given(m, f->effect) != NULL;
    return f->kind == RL_FEATURE_HIGHLIGHT && m->method && rl_method_find(m->method) == f->method;
}

bool rl_feature_named(const struct rl_scene *scene, const struct rl_feature *f)
{
    bool named = f->kind == RL_FEATURE_SWITCH;
    for (size_t i = 0; i < scene->n_materials; i++)
        named = named || (is_worn(scene, i) && has(&scene->material[i], f));
    return named;
}

/* ---- Values ---- */

static size_t components(const struct rl_effect_param *p)
{
    return p->kind == RL_EFFECT_COLOUR ? 3 : 1;
}

/* Of a wide range by its logarithm. */
static double middle(const struct rl_effect_param *p)
{
    return p->low > 0.0 && p->high > 100.0 * p->low ? sqrt(p->low * p->high) : 0.5 * (p->low + p->high);
}

/* The key that the effect's own check misses, as the reflectance of one without n and k. */
static void complete(double *value, const struct rl_effect *e)
{
    const char *key = NULL;
    if (!e->check || !e->check(value, &key))
        return;
    for (size_t k = 0; e->param[k].help; k++)
        if (e->param[k].key && key && strcmp(e->param[k].key, key) == 0)
            for (size_t c = 0; c < components(&e->param[k]); c++)
                value[rl_effect_value_of(e, k) + c] = middle(&e->param[k]);
}

void rl_feature_give(struct rl_material *material, const struct rl_effect *e)
{
    double *values = rl_effect_give(material, e), *value = values;
    for (size_t k = 0; e->param[k].help; k++) {
        const struct rl_effect_param *p = &e->param[k];
        for (size_t c = 0; c < components(p); c++, value++)
            if (p->coefficient && !isnan(p->absent[c]))
                *value = fmin(0.5, p->high);
            else if (p->required && p->kind != RL_EFFECT_CHOICE)
                *value = middle(p);
    }
    complete(values, e);
}

/* ---- Views ---- */

static int copy_materials(struct rl_view *view, const struct rl_scene *scene, struct rl_error *error)
{
    view->scene = *scene;
    view->scene.material = malloc(scene->n_materials * sizeof *scene->material);
    if (!view->scene.material)
        return rl_fail_memory(error, "a scene's materials");
    memcpy(view->scene.material, scene->material, scene->n_materials * sizeof *scene->material);
    return RL_OK;
}

static void switch_on(struct rl_settings *settings, const struct rl_settings *from,
                      enum rl_feature_switch which)
{
    if (which == RL_SWITCH_ATTENUATION)
        settings->attenuation = true;
    if (which == RL_SWITCH_CULLING)
        settings->culling = true;
    if (which != RL_SWITCH_SPHERE)
        return;
    bool own = from->margin_kind != RL_MARGIN_OFF;
    settings->margin_kind = own ? from->margin_kind : RL_MARGIN_VALUE;
    settings->margin = own ? from->margin : 0.5;
    settings->margin_bound = from->margin_bound;
}

int rl_view_make(struct rl_view *view, const struct rl_scene *scene, const struct rl_settings *settings,
                 struct rl_error *error)
{
    view->settings = *settings;
    for (int i = 0; i < RL_SWITCHES; i++)
        switch_on(&view->settings, &scene->settings, (enum rl_feature_switch)i);
    return copy_materials(view, scene, error);
}

int rl_view_copy(struct rl_view *view, const struct rl_view *other, struct rl_error *error)
{
    view->settings = other->settings;
    return copy_materials(view, &other->scene, error);
}

void rl_view_clear(struct rl_view *view)
{
    free(view->scene.material);
    *view = (struct rl_view){.scene = {0}};
}

void rl_view_remove(struct rl_view *view, const struct rl_feature *f)
{
    if (f->kind == RL_FEATURE_SWITCH && f->which == RL_SWITCH_ATTENUATION)
        view->settings.attenuation = false;
    if (f->kind == RL_FEATURE_SWITCH && f->which == RL_SWITCH_SPHERE)
        view->settings.margin_kind = RL_MARGIN_OFF;
    if (f->kind == RL_FEATURE_SWITCH && f->which == RL_SWITCH_CULLING)
        view->settings.culling = false;
    for (size_t i = 0; i < view->scene.n_materials; i++) {
        struct rl_material *m = &view->scene.material[i];
        if (!has(m, f))
            continue;
        if (f->kind == RL_FEATURE_EFFECT)
            m->effect[rl_effect_row(f->effect)].given = false;
        else
            m->method = NULL;
    }
}

void rl_view_add(struct rl_view *view, const struct rl_view *from, const struct rl_feature *f)
{
    if (f->kind == RL_FEATURE_SWITCH)
        switch_on(&view->settings, &from->settings, f->which);
    for (size_t i = 0; i < view->scene.n_materials; i++) {
        struct rl_material *m = &view->scene.material[i];
        const struct rl_material *other = &from->scene.material[i];
        if (!has(other, f))
            continue;
        if (f->kind == RL_FEATURE_EFFECT)
            m->effect[rl_effect_row(f->effect)] = other->effect[rl_effect_row(f->effect)];
        else
            m->method = other->method;
        m->rr = other->rr;
    }
}

/* ---- Hosts ---- */

static unsigned roles_of(const struct rl_feature *f)
{
    return f->kind == RL_FEATURE_EFFECT ? f->effect->roles : RL_ROLE_HIGHLIGHT;
}

/* What the material has that is a model of the same thing; taken away or only counted. */
static size_t clashes(struct rl_material *m, unsigned roles, bool take)
{
    size_t n = 0;
    for (size_t row = 0; row < rl_n_effects; row++)
        if (m->effect[row].given && rl_effects[row]->roles & roles) {
            n++;
            m->effect[row].given = !take;
        }
    if (m->method && roles & RL_ROLE_HIGHLIGHT) {
        n++;
        m->method = take ? NULL : m->method;
    }
    return n;
}

/* A factor needs a highlight to act on, and goes where one is. */
static bool suits(struct rl_material *m, const struct rl_feature *f)
{
    return clashes(m, roles_of(f), false) == 0 && (!rl_feature_needs_highlight(f) || m->method);
}

void rl_view_host(struct rl_view *view, const struct rl_feature *f)
{
    size_t n = view->scene.n_materials, first = n, host = n;
    for (size_t i = 0; i < n; i++) {
        if (!is_worn(&view->scene, i))
            continue;
        first = first < n ? first : i;
        host = host == n && suits(&view->scene.material[i], f) ? i : host;
    }
    host = host < n ? host : first;
    if (host == n || f->kind == RL_FEATURE_SWITCH)
        return;
    struct rl_material *m = &view->scene.material[host];
    clashes(m, roles_of(f), true);
    if (f->kind == RL_FEATURE_EFFECT) {
        rl_feature_give(m, f->effect);
        return;
    }
    m->method = f->method->name;
    m->rr = m->rr > 0.0 ? m->rr : 30.0;
    for (int c = 0; c < 3; c++)
        m->specular[c] = m->specular[c] > 0.0 ? m->specular[c] : 1.0;
}
