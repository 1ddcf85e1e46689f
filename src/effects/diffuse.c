/* Lambert's diffuse reflection, of each light from one direction L:
 *
 *     (k_d / pi) E max(0, N.L)
 *
 * with E the irradiance on a plane perpendicular to L. k_d is the reflectance: all of a white surface's (k_d = 1) irradiance comes back,
 * with radiance E N.L / pi in every direction. Lecture notes that write k_d I cos(alpha) have pi in their k_d.
 *
 * A shaped light is shrunk to its centroid, E = radiance A |cos(light)| / r^2: exact for a light far away compared with its size. */
#include "effects/effect.h"

static void pack(const double *value, double params[][4])
{
    for (int i = 0; i < 3; i++)
        params[0][i] = value[i] / RL_PI;
    params[0][3] = 0.0;
}

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    double n_l = fmax(0.0, v3_dot(s->N, L));
    for (int c = 0; c < 3; c++)
        rgb[c] = params[0][c] * n_l;
}

static const struct rl_effect_param param[] = {
    {.help = "k_d, the reflectance", .kind = RL_EFFECT_COLOUR, .high = 1.0, .coefficient = true},
    {0},
};

const struct rl_effect rl_effect_diffuse = {
    .name = "diffuse",
    .summary = "k_d: Lambert's law, shaped lights shrunk to points at their centroids",
    .sees = RL_SEES_SOURCES | RL_SEES_CENTROIDS,
    .roles = RL_ROLE_DIFFUSE,
    .param = param,
    .n_params = 1,
    .pack = pack,
    .reflect = reflect,
    .absolute = 1e-7,
};
