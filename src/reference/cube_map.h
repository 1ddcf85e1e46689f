/* A cube map of the lights as seen from one point: for each texel the light that its centre sees, the nearest of them.
 *
 * Texels are those of the GPU's environment map (OpenGL 4.5, table 8.19): texel (x, y) of a face has its centre at
 * s = 2 (x + 1/2)/size - 1, t likewise, row 0 at t = -1, in direction s S + t T + W of the face's axes. The map holds indices of the
 * set's radiances, so that nothing is rounded.
 */
#ifndef RL_REFERENCE_CUBE_MAP_H
#define RL_REFERENCE_CUBE_MAP_H

#include <stddef.h>
#include <stdint.h>

#include "reference/light_set.h"

enum { RL_CUBE_FACES = 6 };

/* Columns [0] and rows [1] of a face, each from..to - 1; from >= to: none. */
struct rl_cube_box {
    int from[2], to[2];
};

struct rl_cube_map {
    int size;       /* texels along a face's edge */
    uint16_t *seen; /* 6 x size x size, face by face, row by row: 1 + index of the radiance, 0: no light */
    struct rl_cube_box lit[RL_CUBE_FACES]; /* what encloses the texels that see a light */
};

/* RL_ERR_INPUT: more than 65534 radiances. size >= 1. */
int rl_cube_map_make(struct rl_cube_map *map, const struct rl_light_set *set, rl_vec3 from, int size,
                     struct rl_error *error);
void rl_cube_map_clear(struct rl_cube_map *map);

/* The direction of (s, t) on a face, not normalised: its component along the face's outward axis is 1. */
rl_vec3 rl_cube_direction(int face, double s, double t);

/* A vector's components along the face's s, t and outward axes. */
rl_vec3 rl_cube_on_face(int face, rl_vec3 v);

/* The solid angle of the square s +- half, t +- half of any face, exact for every size: two triangles after Van Oosterom and
 * Strackee 1983, whose numerator, the determinant of the corners, is the square's area and needs no subtraction. */
double rl_cube_solid_angle(double s, double t, double half);

#endif
