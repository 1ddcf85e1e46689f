/* Lambert's diffuse reflection of each light shrunk to its centroid:
 *
 *     (k_d / pi) sum over lights of  radiance A |cos(light)| max(0, N.L) / r^2
 *
 * the point-light law k_d I/r^2 cos(alpha) with I = radiance A |cos(light)|, exact for a light far away compared with its
 * size. A light at the point itself (r = 0) has no direction and gives nothing. */
#include "effects/effect.h"

static bool wanted(const struct rl_material *m)
{
    return m->diffuse[0] > 0.0 || m->diffuse[1] > 0.0 || m->diffuse[2] > 0.0;
}

static void pack(const struct rl_material *m, double params[][4])
{
    for (int i = 0; i < 3; i++)
        params[0][i] = m->diffuse[i] / RL_PI;
    params[0][3] = 0.0;
}

static void shade(const struct rl_surface *s, const struct rl_point_light *lights, size_t n_lights,
                  double params[][4], double rgb[3])
{
    double sum[3] = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < n_lights; i++) {
        rl_vec3 d = v3_sub(lights[i].position, s->P);
        double rr = v3_dot(d, d);
        double n_d = v3_dot(s->N, d);
        if (!(n_d > 0.0) || !(rr > 0.0))
            continue;
        double facing =
            v3_dot(lights[i].normal, lights[i].normal) > 0.0 ? fabs(v3_dot(lights[i].normal, d)) : sqrt(rr);
        double factor = lights[i].area * n_d * facing / (rr * rr);
        for (int c = 0; c < 3; c++)
            sum[c] += factor * lights[i].radiance[c];
    }
    for (int c = 0; c < 3; c++)
        rgb[c] = params[0][c] * sum[c];
}

const struct rl_effect rl_effect_diffuse = {
    .name = "diffuse",
    .summary = "k_d: Lambert's law, each light shrunk to a point at its centroid",
    .n_params = 1,
    .needs_lights = true,
    .wanted = wanted,
    .pack = pack,
    .shade = shade,
};
