/* The values of effects' parameters in a material (see effect.h). */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "effects/effect.h"

const struct rl_effect *rl_effect_find(const char *name)
{
    for (size_t i = 0; i < rl_n_effects; i++)
        if (strcmp(rl_effects[i]->name, name) == 0)
            return rl_effects[i];
    return NULL;
}

void rl_effect_identifier(char identifier[32], const struct rl_effect *effect)
{
    snprintf(identifier, 32, "%s", effect->name);
    for (char *c = identifier; *c; c++)
        if (*c == '-')
            *c = '_';
}

size_t rl_effect_row(const struct rl_effect *effect)
{
    size_t row = 0;
    while (row < rl_n_effects && rl_effects[row] != effect)
        row++;
    assert(row < rl_n_effects && row < RL_MATERIAL_EFFECTS_MAX);
    return row;
}

static size_t size_of(const struct rl_effect_param *param)
{
    return param->kind == RL_EFFECT_COLOUR ? 3 : 1;
}

size_t rl_effect_value_of(const struct rl_effect *effect, size_t param)
{
    size_t n = 0;
    for (size_t i = 0; i < param && effect->param[i].help; i++)
        n += size_of(&effect->param[i]);
    return n;
}

size_t rl_effect_values(const struct rl_effect *effect)
{
    return rl_effect_value_of(effect, RL_EFFECT_KEYS_MAX);
}

const char *rl_effect_module(const struct rl_effect *effect, const double *value, size_t param)
{
    const struct rl_effect_param *p = &effect->param[param];
    double x = value[rl_effect_value_of(effect, param)];
    if (!p->choice)
        return NULL;
    return p->choice[p->kind == RL_EFFECT_CHOICE ? (int)x : x != 0.0].module;
}

double *rl_effect_give(struct rl_material *material, const struct rl_effect *effect)
{
    size_t row = rl_effect_row(effect);
    double *value = material->effect[row].value;
    material->effect[row].given = true;
    for (size_t i = 0, n = 0; effect->param[i].help; i++)
        for (size_t c = 0; c < size_of(&effect->param[i]); c++)
            value[n++] = effect->param[i].absent[c];
    return value;
}

void rl_effect_give_colour(struct rl_material *material, const char *name, double r, double g, double b)
{
    double *value = rl_effect_give(material, rl_effect_find(name));
    value[0] = r;
    value[1] = g;
    value[2] = b;
}

const double *rl_effect_given(const struct rl_material *material, const struct rl_effect *effect)
{
    size_t row = rl_effect_row(effect);
    return material->effect[row].given ? material->effect[row].value : NULL;
}

bool rl_effect_wanted(const struct rl_material *material, const struct rl_effect *effect)
{
    const double *value = rl_effect_given(material, effect);
    for (size_t i = 0, n = 0; value && effect->param[i].help; i++)
        for (size_t c = 0; c < size_of(&effect->param[i]); c++, n++)
            if (effect->param[i].coefficient && !isnan(value[n]) && value[n] != 0.0)
                return true;
    return false;
}
