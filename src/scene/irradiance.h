/* What a scene's lights give at a point, each alone and without shadows.
 *
 *     double (*rgb)[3] = calloc(scene.n_lights + scene.n_sources, sizeof *rgb);
 *     status = rl_scene_irradiance(rgb, &scene, P, N, &error);      first the shaped lights, then the sources
 */
#ifndef RL_SCENE_IRRADIANCE_H
#define RL_SCENE_IRRADIANCE_H

#include "scene/scene.h"

/* The irradiance of a surface at P with the unit normal N by each light, W/m^2; in a photometric scene illuminance in lx (of RGB with the
 * luminance as its weight, so that rl_luminance of it is the illuminance). Exact of polygons (Lambert's edge sum, cut at the horizon; effect
 * diffuse-area), of closed, convex meshes, and of open ones where no triangle hides another from P, as none of a flat one does. RL_ERR_INPUT: a point light at P, where its irradiance has no bound. */
int rl_scene_irradiance(double rgb[][3], const struct rl_scene *scene, rl_vec3 P, rl_vec3 N,
                        struct rl_error *error);

#endif
