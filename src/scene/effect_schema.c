/* Effects in scene files (see effect_schema.h). */
#include "scene/effect_schema.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- The schema ---- */

static const cyaml_schema_value_t number = {CYAML_VALUE_FLOAT(CYAML_FLAG_DEFAULT, double)};

/* What is off or on in C is a switch in scene files, and takes what the others there take. */
static uint32_t fill_choice(cyaml_strval_t *to, const struct rl_effect_choice *choice)
{
    static const cyaml_strval_t switches[] = {{"on", 1}, {"off", 0}, {"true", 1}, {"false", 0}};
    static_assert(sizeof switches / sizeof switches[0] <= RL_EFFECT_CHOICES_MAX, "room for a switch");
    if (strcmp(choice[0].name, "off") == 0 && strcmp(choice[1].name, "on") == 0) {
        memcpy(to, switches, sizeof switches);
        return sizeof switches / sizeof switches[0];
    }
    uint32_t n = 0;
    for (; n < RL_EFFECT_CHOICES_MAX && choice[n].name; n++)
        to[n] = (cyaml_strval_t){choice[n].name, n};
    return n;
}

/* Missed keys are noticed later, where messages can say what they are. */
static cyaml_schema_value_t value_schema(const struct rl_effect_param *param, cyaml_strval_t *choice)
{
    enum cyaml_flag flags = CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL;
    switch (param->kind) {
    case RL_EFFECT_COLOUR:
        return (cyaml_schema_value_t){CYAML_VALUE_SEQUENCE_FIXED(flags, double, &number, 3)};
    case RL_EFFECT_CHOICE:
        return (cyaml_schema_value_t){CYAML_VALUE_ENUM((enum cyaml_flag)(flags | CYAML_FLAG_STRICT), int,
                                                       choice, fill_choice(choice, param->choice))};
    default:
        return (cyaml_schema_value_t){CYAML_VALUE_FLOAT(flags, double)};
    }
}

void rl_effect_schema_make(struct rl_effect_schema *schema, cyaml_schema_field_t *field, size_t n)
{
    assert(rl_n_effects <= RL_MATERIAL_EFFECTS_MAX && rl_n_effects < n);
    for (size_t i = 0; i < rl_n_effects; i++) {
        const struct rl_effect *effect = rl_effects[i];
        field[i] = (cyaml_schema_field_t){
            .key = effect->name,
            .data_offset = (uint32_t)(offsetof(struct rl_raw_material, effect) + i * sizeof(void *))};
        if (!effect->param[0].key) {
            field[i].value = value_schema(&effect->param[0], schema->choice[i][0]);
            continue;
        }
        for (size_t k = 0; effect->param[k].help; k++)
            schema->param[i][k] = (cyaml_schema_field_t){
                .key = effect->param[k].key,
                .data_offset = (uint32_t)(offsetof(struct rl_raw_effect, value) + k * sizeof(void *)),
                .value = value_schema(&effect->param[k], schema->choice[i][k])};
        field[i].value = (cyaml_schema_value_t){CYAML_VALUE_MAPPING(CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL,
                                                                    struct rl_raw_effect, schema->param[i])};
    }
    field[rl_n_effects] = (cyaml_schema_field_t)CYAML_FIELD_END;
}

/* ---- Materials ---- */

/* `key` is the value's own, "materials[0].phong.exponent". */
static int take_value(const struct rl_scene_builder *b, double *to, const struct rl_effect_param *param,
                      const void *raw, const char *key)
{
    int status;
    if (!raw)
        return param->required ? rl_yaml_fail_value(b->tree, b->error, key, "%s", param->help) : RL_OK;
    switch (param->kind) {
    case RL_EFFECT_COLOUR:
        memcpy(to, raw, 3 * sizeof *to);
        status = rl_build_triple(b, key, to, param->low, param->high);
        for (int c = 0; c < 3 && param->radiance && b->scene->white > 0.0; c++)
            to[c] /= b->scene->white;
        return status;
    case RL_EFFECT_CHOICE:
        *to = *(const int *)raw;
        return RL_OK;
    default:
        *to = *(const double *)raw;
        return rl_build_range(b, key, *to, param->low, param->high);
    }
}

static int take_effect(const struct rl_scene_builder *b, size_t material, size_t row)
{
    const struct rl_effect *effect = rl_effects[row];
    const void *raw = b->raw->materials[material].effect[row];
    char key[RL_YAML_KEY_MAX], path[RL_YAML_KEY_MAX];
    snprintf(key, sizeof key, "materials[%zu].%s", material, effect->name);
    double *value = rl_effect_give(&b->scene->material[material], effect);
    if (!effect->param[0].key)
        return take_value(b, value, &effect->param[0], raw, key);
    for (size_t i = 0; effect->param[i].help; i++) {
        rl_yaml_key(path, key, effect->param[i].key);
        int status = take_value(b, value + rl_effect_value_of(effect, i), &effect->param[i],
                                ((const struct rl_raw_effect *)raw)->value[i], path);
        if (status != RL_OK)
            return status;
    }
    const char *at = NULL, *expected = effect->check ? effect->check(value, &at) : NULL;
    if (!expected)
        return RL_OK;
    rl_yaml_key(path, key, at);
    return rl_yaml_fail_value(b->tree, b->error, path, "%s", expected);
}

static const char *role_name(unsigned roles)
{
    if (roles & RL_ROLE_DIFFUSE)
        return "diffuse reflection";
    return roles & RL_ROLE_SPECULAR ? "the highlight of point and parallel lights"
                                    : "the highlight of shaped lights";
}

/* Two models of one thing: the effect with the earlier ones and with the highlight's method. */
static int check_roles(const struct rl_scene_builder *b, size_t material, size_t row)
{
    const struct rl_material *m = &b->scene->material[material];
    unsigned roles = rl_effects[row]->roles;
    char key[RL_YAML_KEY_MAX];
    snprintf(key, sizeof key, "materials[%zu].%s", material, rl_effects[row]->name);
    for (size_t i = 0; i < row; i++)
        if (m->effect[i].given && rl_effects[i]->roles & roles)
            return rl_yaml_fail(b->tree, b->error, key, "found %s and %s, expected one model of %s",
                                rl_effects[i]->name, rl_effects[row]->name,
                                role_name(rl_effects[i]->roles & roles));
    if (m->method && roles & RL_ROLE_HIGHLIGHT)
        return rl_yaml_fail(b->tree, b->error, key, "found the highlight %s and %s, expected one model of %s",
                            m->method, rl_effects[row]->name, role_name(RL_ROLE_HIGHLIGHT));
    return RL_OK;
}

int rl_build_effects(const struct rl_scene_builder *b, size_t i)
{
    int status = RL_OK;
    for (size_t row = 0; row < rl_n_effects && status == RL_OK; row++) {
        if (!b->raw->materials[i].effect[row])
            continue;
        status = take_effect(b, i, row);
        if (status == RL_OK)
            status = check_roles(b, i, row);
    }
    return status;
}
