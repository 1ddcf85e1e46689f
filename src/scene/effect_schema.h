/* The keys of effects in scene files: their part of the schema, made from the table of effects, and what materials take from it. */
#ifndef RL_SCENE_EFFECT_SCHEMA_H
#define RL_SCENE_EFFECT_SCHEMA_H

#include <cyaml/cyaml.h>

#include "effects/effect.h"
#include "scene/scene_build.h"

/* Keys of a material: its own few, and one an effect. */
enum { RL_MATERIAL_FIELDS_MAX = RL_MATERIAL_EFFECTS_MAX + 8 };

/* What the fields point to; keep it as long as them, and where it is. */
struct rl_effect_schema {
    cyaml_schema_field_t param[RL_MATERIAL_EFFECTS_MAX][RL_EFFECT_KEYS_MAX + 1];
    cyaml_strval_t choice[RL_MATERIAL_EFFECTS_MAX][RL_EFFECT_KEYS_MAX][RL_EFFECT_CHOICES_MAX];
};

/* Fills the fields of struct rl_raw_material that are effects, and the end of the list: at most n. */
void rl_effect_schema_make(struct rl_effect_schema *schema, cyaml_schema_field_t *field, size_t n);

/* Takes the effects of materials[i]. RL_ERR_INPUT: a value out of range, a key that is missed, effects that do not go together. */
int rl_build_effects(const struct rl_scene_builder *b, size_t i);

#endif
