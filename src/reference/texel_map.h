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
 * |y| = 4 texels therefore get their integral instead of their centre's value: the smooth factor at the centre, times d omega, times
 * the mean of 1/|y| over the texel's image in the plane of y, a closed form; they are divided first where the lobe of D is narrower than
 * they are.
 *
 * What is left is the map's: texels are lit or not as their centres are. h = 2/size being their edge, the error of L_o falls as
 * h^(3/2) for light edges across the grid (the texels' errors are as random signs, N ~ 1/h of them of size h^2 each), as h
 * for edges along the grid, which err all to one side; h^2 from the curvature of w, but h near a pole, since the texels' errors
 * h^2 w''/24 there, each times h^2, with w'' ~ 1/y^3, add up to 1/(4 h) h^2 from |y| = 4 h on.
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
