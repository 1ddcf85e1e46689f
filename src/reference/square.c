/* The integrand over the unit square (see square.h). */
#include "reference/square.h"

#include <gsl/gsl_cdf.h>

#include "model/attenuation.h"
#include "model/random.h"

int rl_square_make(struct rl_square *square, const struct rl_surface *surface, const struct rl_ellipsoid *e,
                   const struct rl_light_set *set, const struct rl_integrate_options *options,
                   struct rl_error *error)
{
    *square = (struct rl_square){.e = e,
                                 .set = set,
                                 .V = surface->V,
                                 .attenuation = options->attenuation,
                                 .frame = rl_frame_make(options->frame, surface->N)};
    return rl_cast_make(&square->cast, surface->P, set, error);
}

void rl_square_free(struct rl_square *square)
{
    rl_cast_free(&square->cast);
}

double rl_square_sample(size_t *radiance, const struct rl_square *square, double u, double w)
{
    *radiance = RL_CAST_MISS;
    struct rl_delta d = rl_ellipsoid_inverse(square->e, u);
    rl_vec3 H = rl_frame_microfacet_normal(&square->frame, d.sin_delta, d.cos_delta, RL_PI * w);
    H = v3_normalize(H); /* the printed frame's is not unit */
    double v_h = v3_dot(square->V, H);
    rl_vec3 L = v3_sub(v3_scale(2.0 * v_h, H), square->V), N = square->frame.N;
    double G =
        square->attenuation ? rl_attenuation(v3_dot(N, H), v3_dot(N, square->V), v3_dot(N, L), v_h) : 1.0;
    if (G == 0.0)
        return 0.0;
    size_t hit = rl_cast_nearest(&square->cast, L);
    if (hit == RL_CAST_MISS)
        return 0.0;
    *radiance = square->set->polygon[hit].radiance;
    return G;
}

double rl_square_quantile(const struct rl_integrate_options *options)
{
    double confidence = options->confidence > 0.0 ? options->confidence : 0.99;
    return gsl_cdf_ugaussian_Qinv(0.5 * (1.0 - confidence));
}

unsigned long rl_square_seed(uint64_t seed)
{
    return (uint32_t)(seed + 1) ^ (uint32_t)rl_random_mix(seed >> 32);
}
