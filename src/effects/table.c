/* The table of effects: one row each, in the order in which their sum is formed. */
#include "effects/effect.h"

/* clang-format off */
#define EFFECTS(X)     \
    X(ambient)         \
    X(diffuse)         \
    X(diffuse_area)    \
    X(phong)           \
    X(blinn)           \
    X(cook_torrance)   \
    X(fresnel)         \
    X(kajiya)          \
    X(kajiya_printed)  \
    X(goldman)         \
    X(goldman_printed) \
    X(lengyel)
/* clang-format on */

#define DECLARE(name) extern const struct rl_effect rl_effect_##name;
EFFECTS(DECLARE)

#define ROW(name) &rl_effect_##name,
const struct rl_effect *const rl_effects[] = {EFFECTS(ROW)};

const size_t rl_n_effects = sizeof rl_effects / sizeof rl_effects[0];
