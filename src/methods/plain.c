/* `plain`: a highlight that knows nothing of the light's shape, the paper's "normal rendering". Phong's lobe about the
 * mirror direction, from each light's centroid:
 *
 *     sum over lights of  radiance max(0, R.L)^n,   N.L > 0
 *
 * n is chosen so that the lobe falls to half its peak where D does relative to its own: k sin(delta) = 1, gamma = 2 delta,
 * n = ln(1/2)/ln(cos 2 delta). The peak is the light's radiance, as in a mirror. */
#include <math.h>

#include "methods/method.h"

static void pack(const struct rl_ellipsoid *e, double params[][4])
{
    /* cos 2 delta = 1 - 2/k^2; from k^2 = 4 down n would be below 1, a lobe that ends at a hard edge: it stays 1. */
    double kk = e->rr > 1.0 ? e->k * e->k : 0.0;
    double n = kk > 2.0 ? log(0.5) / log1p(-2.0 / kk) : 1.0;
    params[0][0] = fmax(1.0, n);
    params[0][1] = params[0][2] = params[0][3] = 0.0;
}

static void shade(const struct rl_surface *s, const struct rl_point_light *lights, size_t n_lights,
                  double params[][4], double rgb[3])
{
    rgb[0] = rgb[1] = rgb[2] = 0.0;
    rl_vec3 mirror = v3_reflect(s->V, s->N);
    for (size_t i = 0; i < n_lights; i++) {
        rl_vec3 L = v3_normalize(v3_sub(lights[i].position, s->P));
        double r_l = v3_dot(mirror, L);
        if (!(v3_dot(s->N, L) > 0.0) || !(r_l > 0.0))
            continue;
        /* Rounded a little above 1, a cosine to the power of a narrow lobe's n is infinite. */
        double lobe = pow(fmin(r_l, 1.0), params[0][0]);
        for (int c = 0; c < 3; c++)
            rgb[c] += lobe * lights[i].radiance[c];
    }
}

const struct rl_method rl_method_plain = {
    .name = "plain",
    .summary = "Phong highlight of each light's centroid: no light shape (the paper's normal rendering)",
    .on_gpu = true,
    .on_cpu = true,
    .default_samples = 1,
    .needs_point_lights = true,
    .n_params = 1,
    .pack = pack,
    .shade = shade,
};
