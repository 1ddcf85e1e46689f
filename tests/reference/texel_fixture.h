/* What the tests of `exhaustive` share. Include after cmocka.h. */
#ifndef TESTS_REFERENCE_TEXEL_FIXTURE_H
#define TESTS_REFERENCE_TEXEL_FIXTURE_H

#include "reference/fixture.h"
#include "reference/texel_map.h"
#include "support/check.h"

/* L_o of lights of radiance 1 by a map rendered from the point itself: no parallax. */
static inline double map_value(const struct rl_surface *s, double rr, const struct rl_light_set *set,
                               bool attenuation, int size)
{
    struct rl_texel_map *map;
    struct rl_error error;
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    double value[3];
    check_ok(rl_texel_map_make(&map, set, s->P, size, &error), &error);
    rl_texel_map_integrate(value, map, s, &e, attenuation);
    rl_texel_map_free(map);
    return value[0];
}

/* Six walls about the origin, each a little larger than the cube's face. */
static inline struct rl_light_set *furnace(void)
{
    struct shape wall[6];
    for (int i = 0; i < 6; i++) {
        wall[i].n = 4;
        for (int k = 0; k < 4; k++)
            wall[i].vertex[k] = rl_cube_direction(i, k == 0 || k == 3 ? -1.01 : 1.01, k < 2 ? -1.01 : 1.01);
    }
    return set_of(wall, 6);
}

#endif
