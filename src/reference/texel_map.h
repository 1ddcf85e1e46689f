/* L_o by every texel of an environment map: "sample every pixel", the paper's own idea of exact.
 *
 *     L_o = sum over texels of  L_e(texel) w(L) d omega,   w = D(delta) G / (4 pi (V.H) |sin delta|)
 *
 * L is the direction of the texel's centre, d omega its exact solid angle, H along V + L: d omega_L = 4 (V.H) d omega_H and
 * d omega_H = |sin delta| d delta d theta. Without attenuation H stands for the one of +-H that is above the surface, so that each L
 * counts once. A black texel adds 0: only the others are listed and evaluated.
 *
 * w has two poles, which integrate to something finite: the mirror direction (sin delta = 0) and L = -V (V.H = 0; below the horizon,
 * where G = 0). At both the tangential part y of V + L vanishes, and w is 1/|y| times something smooth. Texels nearer than
 * |y| = 8 texels therefore get their integral instead of their centre's value: the smooth factor at the centre, times d omega, times
 * the mean of 1/|y| over the texel's image in the plane of y, a closed form; they are divided first where the lobe of D is narrower than
 * they are.
 *
 * What is left is the map's: texels are lit or not as their centres are. h = 2/size being their edge, the error of L_o falls
 *
 *   as h^(3/2) for light edges across the grid, in the mean square over where and how they lie: the errors of N ~ 1/h texels, h^2
 *              each, add up as if their signs were drawn by lot (Kendall 1948 for ovals);
 *   as h       for edges along the grid, which err all to one side;
 *   as h^2     from the curvature of w, but as h from the texels about a pole: w'' ~ 1/|y|^3, and the sum of h^2 w''/24 over all that lies
 *              farther than 8 h is as h.
 */
#ifndef RL_REFERENCE_TEXEL_MAP_H
#define RL_REFERENCE_TEXEL_MAP_H

#include "reference/cube_map.h"

struct rl_texel_map;

/* The lights of `set` as seen from a point, by size x size texels a face. Needs the set no longer. */
int rl_texel_map_make(struct rl_texel_map **map, const struct rl_light_set *set, rl_vec3 from, int size,
                      struct rl_error *error);
void rl_texel_map_free(struct rl_texel_map *map);

const struct rl_cube_map *rl_texel_map_cube(const struct rl_texel_map *map);

/* L_o, RGB, at a surface point; its position does not enter. N and V unit vectors; N.V <= 0 gives 0. Returns how many texels were
 * evaluated. Thread-safe. */
size_t rl_texel_map_integrate(double value[3], const struct rl_texel_map *map,
                              const struct rl_surface *surface, const struct rl_ellipsoid *e,
                              bool attenuation);

#endif
