/* `random`: N microfacet normals a pixel drawn from D, the random numbers baked into a normal map (Kimura and Tokoi). The
 * estimate (1/N) sum of G L_e is unbiased but for what the map's bits, the environment map's texels and its single position
 * do to it. */
#include <math.h>

#include "methods/method.h"
#include "model/random.h"

static struct rl_microfacet texel(const struct rl_ellipsoid *e, uint64_t seed, uint64_t index)
{
    struct rl_delta d = rl_ellipsoid_inverse(e, rl_random_uniform(seed, 2 * index));
    double theta = RL_PI * rl_random_uniform(seed, 2 * index + 1);
    return (struct rl_microfacet){
        .x = d.cos_delta,
        .y = d.sin_delta * cos(theta),
        .z = d.sin_delta * sin(theta),
        .weight = 1.0,
    };
}

const struct rl_method rl_method_random = {
    .name = "random",
    .summary = "N normals a pixel from a normal map with baked random numbers (the paper: 4)",
    .on_gpu = true,
    .sampled = true,
    .default_samples = 4,
    .needs_environment = true,
    .needs_normal_map = true,
    .texel = texel,
};
