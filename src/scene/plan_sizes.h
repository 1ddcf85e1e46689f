/* How large what a plan lists is: its textures, buffers and render buffers, and how often its programs draw. What the GL layer allocates and
 * uploads follows from the same plan; its counters say the same (tests/gpu/test_plan_sizes.c). Nothing here is of a plan for the CPU.
 */
#ifndef RL_SCENE_PLAN_SIZES_H
#define RL_SCENE_PLAN_SIZES_H

#include "scene/plan.h"

/* Bytes of one element of the buffers that hold lights, as shaders lay them out (std140, std430). */
enum {
    RL_BYTES_LIGHT_VERTEX = 24, /* of triangles: position and radiance */
    RL_BYTES_LIGHT_POINT = 48,
    RL_BYTES_LIGHT_SPHERE = 16,
    RL_BYTES_LIGHT_SOURCE = 32,
    RL_BYTES_LIGHT_POLYGON = 32,
    RL_BYTES_LIGHT_CORNER = 16, /* of polygons */
    RL_BYTES_MICROFACET = 16    /* of a pattern */
};

struct rl_plan_size {
    const char *format; /* of a texel or pixel, "rgba8"; of a buffer what it is made of, "float3" */
    int width, height;  /* texels or pixels; 0: a buffer */
    size_t count;       /* images of that size (a cube map has six), or elements of a buffer */
    /* As the format is laid out, pixels of depth in whole words; drivers may take more. `uploaded`: what is sent there by the CPU, 0 of what
     * the GPU draws itself, and more than `bytes` of halves, which are sent as floats. */
    size_t bytes, uploaded;
};

/* Textures: any normal map, any environment map. */
struct rl_plan_size rl_plan_size_normal_map(const struct rl_settings *settings);
struct rl_plan_size rl_plan_size_environment(const struct rl_settings *settings);

/* Buffers. Of polygons `count` is that of polygons, and their corners are in `bytes`, too. Of an object's mesh what is its own: parts that are
 * another's are all 0. RL_ERR_MEMORY. */
struct rl_plan_size rl_plan_size_pattern(const struct rl_plan_pattern *pattern);
struct rl_plan_size rl_plan_size_lights(const struct rl_plan *plan, const struct rl_scene *scene,
                                        enum rl_plan_buffer buffer);
int rl_plan_size_mesh(struct rl_plan_size size[RL_MESH_PARTS], const struct rl_plan *plan,
                      const struct rl_scene *scene, size_t object, struct rl_error *error);

/* Render buffers: of the picture, the depth with the stencil where the plan has one; and the depth of environment maps, one for all. */
struct rl_plan_size rl_plan_size_colour(const struct rl_plan *plan);
struct rl_plan_size rl_plan_size_depth(const struct rl_plan *plan);
struct rl_plan_size rl_plan_size_environment_depth(const struct rl_plan *plan);

/* Whether the object is drawn, or its environment map, by this program; and how many draws the program has in its pass: in each frame, or,
 * of environment maps, once. */
bool rl_plan_runs(const struct rl_plan *plan, const struct rl_scene *scene, size_t program, size_t object);
size_t rl_plan_draws(const struct rl_plan *plan, const struct rl_scene *scene, size_t program);

#endif
