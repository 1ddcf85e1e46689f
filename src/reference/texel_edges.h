/* The texels of a cube map that the edges of lights pass through: where a map that samples texels at their centres errs. */
#ifndef RL_REFERENCE_TEXEL_EDGES_H
#define RL_REFERENCE_TEXEL_EDGES_H

#include <stddef.h>
#include <stdint.h>

#include "reference/light_set.h"

/* One texel and one polygon whose outline passes through it. */
struct rl_texel_edge {
    uint32_t texel; /* index in rl_cube_map.seen */
    uint32_t polygon;
    double
        coverage; /* part of the texel's area on its face that the polygon covers; the same of its solid angle, but for O(h) */
};

struct rl_texel_edges {
    size_t n, capacity;
    struct rl_texel_edge *edge; /* in the order of polygons */
};

/* RL_ERR_SYSTEM: no memory. */
int rl_texel_edges_find(struct rl_texel_edges *edges, const struct rl_light_set *set, rl_vec3 from, int size,
                        struct rl_error *error);
void rl_texel_edges_clear(struct rl_texel_edges *edges);

#endif
