/* Lambert's diffuse reflection, of each light from one direction L:
 *
 *     (k_d / pi) E max(0, N.L)
 *
 * with E the irradiance on a plane perpendicular to L. k_d is the reflectance: all of a white surface's (k_d = 1) irradiance comes back,
 * with radiance E N.L / pi in every direction. Lecture notes that write k_d I cos(alpha) have pi in their k_d.
 *
 * A shaped light is shrunk to its centroid, E = radiance A |cos(light)| / r^2: exact for a light far away compared with its size. */
#include "effects/lambert.h"

const struct rl_effect rl_effect_diffuse = {
    .name = "diffuse",
    .summary = "k_d: Lambert's law, shaped lights shrunk to points at their centroids",
    .sees = RL_SEES_SOURCES | RL_SEES_CENTROIDS,
    .roles = RL_ROLE_DIFFUSE,
    .param = rl_lambert_param,
    .n_params = 1,
    .pack = rl_lambert_pack,
    .reflect = rl_lambert_reflect,
    .absolute = 1e-7,
    .relative = 5e-7, /* of normals and directions that GLSL normalizes */
};
