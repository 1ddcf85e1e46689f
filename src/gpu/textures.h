/* The tables that methods look up on the GPU: normal map, pattern and the cube maps that will hold
 * environments. */
#ifndef RL_GPU_TEXTURES_H
#define RL_GPU_TEXTURES_H

#include <stddef.h>
#include <stdint.h>

#include "gpu/gl.h"
#include "methods/method.h"
#include "scene/plan.h"
#include "scene/settings.h"

/* OpenGL's name of a format of the environment map. */
GLenum rl_texel_internal_format(enum rl_texel_format format);

/* What radiance is divided by in texels of this format. The brightest light's own radiance in unsigned
 * formats, which then use all of their range; the power of two above it in floating-point ones, where this
 * loses nothing and no radiance overflows a half. */
float rl_texel_unit(enum rl_texel_format format, float radiance_scale);

/* The value >= 0 (in that unit) to draw so that component 0 to 2 of a texel becomes the nearest one to
 * `value` that the format has, whether OpenGL then rounds or cuts off: Mesa's llvmpipe cuts off in 10-bit
 * texels and in halves. */
float rl_texel_nearest(enum rl_texel_format format, int component, double value);

/* A normal's component v in [-1, 1] as a shader reads it from a normal map of `bits` (settings.normal_bits). */
double rl_normal_component(int bits, double v);

/* The texels of a normal map as they are uploaded: (H + 1)/2 of method->texel, rounded to `bits`
 * (settings.normal_bits). */
struct rl_normal_texels {
    void *data; /* free() */
    size_t bytes;
    GLenum internal_format, format, type;
};
int rl_normal_texels_make(struct rl_normal_texels *texels, const struct rl_plan_normal_map *map,
                          const struct rl_settings *settings, struct rl_error *error);

/* Textures and buffers on the GPU; *bytes counts what was uploaded. */
int rl_normal_map_make(GLuint *texture, struct rl_gl *gl, const struct rl_plan_normal_map *map,
                       const struct rl_settings *settings, size_t *bytes, struct rl_error *error);
int rl_pattern_make(GLuint *buffer, struct rl_gl *gl, const struct rl_plan_pattern *pattern, size_t *bytes,
                    struct rl_error *error);
int rl_cube_make(GLuint *texture, struct rl_gl *gl, const struct rl_settings *settings,
                 struct rl_error *error);

#endif
