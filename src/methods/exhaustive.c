/* `exhaustive`: every texel of the environment map, the paper's own idea of exact: "sample every pixel". The map is seen from the
 * object's centre, so that its parallax is in the result, as its texels are. On the CPU; src/reference carries it out. */
#include "methods/method.h"

const struct rl_method rl_method_exhaustive = {
    .name = "exhaustive",
    .summary =
        "every texel of the environment map, its solid angle exact, on the CPU (the paper's idea of exact)",
    .on_cpu = true,
    .default_samples = 1,
    .needs_environment = true,
    .orthonormal_only = true,
};
