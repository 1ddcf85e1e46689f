/* Effects: what a material can ask for beside its highlight. Each is src/effects/NAME.c here <-> shaders/effects/NAME.glsl on
 * the GPU, one descriptor, one row of rl_effects (table.c).
 *
 * An effect is a function of the surface point, the lights and up to RL_EFFECT_PARAMS vec4 of its own, which `pack` takes from
 * the material. The GLSL module NAME.glsl defines
 *
 *     uniform vec4 NAME_params[K];                         K = n_params
 *     vec3 effect_NAME(Surface s);                         RGB radiance towards the eye
 *
 * and `shade` is the same function in double precision.
 */
#ifndef RL_EFFECTS_EFFECT_H
#define RL_EFFECTS_EFFECT_H

#include <stdbool.h>
#include <stddef.h>

#include "model/material.h"
#include "model/vec3.h"

enum { RL_EFFECT_PARAMS = 4 };

/* A visible point: position, unit shading normal on the eye's side, unit direction to the eye. */
struct rl_surface {
    rl_vec3 P, N, V;
};

/* A shaped light shrunk to a point at its centroid, for effects that do not see its shape: a one-sided patch would have
 * radiance x area / r^2 x cosine; lights shine from both sides, so the cosine enters as |cos|. */
struct rl_point_light {
    rl_vec3 position;
    rl_vec3 normal; /* unit; zero for a light of many faces: no cosine at the light */
    double area;
    double radiance[3];
};

struct rl_effect {
    const char *name;
    const char *summary; /* one line for --help and plan */
    int n_params;
    bool needs_lights;
    /* Whether this material asks for the effect at all. */
    bool (*wanted)(const struct rl_material *material);
    void (*pack)(const struct rl_material *material, double params[][4]);
    void (*shade)(const struct rl_surface *s, const struct rl_point_light *lights, size_t n_lights,
                  double params[][4], double rgb[3]);
};

extern const struct rl_effect *const rl_effects[];
extern const size_t rl_n_effects;

#endif
