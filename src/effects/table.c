/* The table of effects: one row each, in the order in which their sum is formed. */
#include "effects/effect.h"

extern const struct rl_effect rl_effect_ambient;
extern const struct rl_effect rl_effect_diffuse;

const struct rl_effect *const rl_effects[] = {
    &rl_effect_ambient,
    &rl_effect_diffuse,
};

const size_t rl_n_effects = sizeof rl_effects / sizeof rl_effects[0];
