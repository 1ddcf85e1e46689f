/* Highlight methods: ways to estimate
 *
 *     L_o = (1/pi) integral over theta in [0,pi), delta in [-pi/2,pi/2] of D(delta) G L_e(P, L) d delta d theta.
 *
 * Each is src/methods/NAME.c here <-> shaders/methods/NAME.glsl on the GPU, one descriptor, one row of rl_methods (table.c).
 * The GLSL module defines
 *
 *     vec3 highlight(Surface s);             L_o, without the material's colour
 *
 * and may use what its descriptor asks for: `normal_map` (random normals baked into a texture), `pattern` (a fixed table of
 * normals and weights), `environment` (the lights seen from the object, a cube map), `point_lights`.
 */
#ifndef RL_METHODS_METHOD_H
#define RL_METHODS_METHOD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "effects/effect.h"
#include "model/ellipsoid.h"

enum { RL_SAMPLES_MAX = 1024 };

/* A microfacet normal about (1, 0, 0) and its share of the estimate. */
struct rl_microfacet {
    double x, y, z; /* cos(delta), sin(delta) cos(theta), sin(delta) sin(theta) */
    double weight;  /* the weights of a pattern sum to 1 */
};

struct rl_method {
    const char *name;
    const char *summary;
    bool on_gpu, on_cpu;
    bool sampled; /* takes --samples */
    int default_samples;
    bool needs_environment, needs_normal_map, needs_pattern, needs_point_lights;
    bool orthonormal_only; /* takes no other tangent frame */
    /* How many vec4 of its own it takes as uniform vec4 NAME_params[K], and how they follow from the distribution. */
    int n_params;
    void (*pack)(const struct rl_ellipsoid *e, double params[][4]);
    /* needs_pattern: fills n microfacets. */
    void (*pattern)(const struct rl_ellipsoid *e, int n, struct rl_microfacet *microfacets);
    /* needs_normal_map: the normal of texel `index` of the map of this seed. */
    struct rl_microfacet (*texel)(const struct rl_ellipsoid *e, uint64_t seed, uint64_t index);
    /* Methods whose value needs nothing but point lights: the same function as the GLSL, in double precision. */
    void (*shade)(const struct rl_surface *s, const struct rl_point_light *lights, size_t n_lights,
                  double params[][4], double rgb[3]);
};

extern const struct rl_method *const rl_methods[];
extern const size_t rl_n_methods;

/* NULL if there is none of that name. */
const struct rl_method *rl_method_find(const char *name);

#endif
