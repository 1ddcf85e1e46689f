/* The table of effects: one row each, in the order in which their sum is formed. */
#include "effects/effect.h"

extern const struct rl_effect rl_effect_ambient;
extern const struct rl_effect rl_effect_diffuse;
extern const struct rl_effect rl_effect_phong;
extern const struct rl_effect rl_effect_blinn;
extern const struct rl_effect rl_effect_cook_torrance;

const struct rl_effect *const rl_effects[] = {
    &rl_effect_ambient, &rl_effect_diffuse, &rl_effect_phong, &rl_effect_blinn, &rl_effect_cook_torrance,
};

const size_t rl_n_effects = sizeof rl_effects / sizeof rl_effects[0];
