/* `reference`: the integral itself, on the true polygons in double precision; src/reference carries it out. Here is only its
 * row: it needs no table, no texture and no GPU. */
#include "methods/method.h"

const struct rl_method rl_method_reference = {
    .name = "reference",
    .summary = "the integral itself along lines on the true polygons, on the CPU in double precision",
    .on_cpu = true,
    .default_samples = 1,
};
