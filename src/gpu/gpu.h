/* The GPU pipeline: a context on one of the backends, and a scene prepared on it according to a plan.
 *
 *     rl_gpu_open(&gpu, "auto", &error);
 *     rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error);
 *     rl_gpu_scene_frame(gs, &seconds, &error);              one whole frame, finished
 *     rl_gpu_scene_read(gs, &image, &error);
 *     rl_gpu_scene_free(gs); rl_gpu_close(gpu);
 *
 * The GL libraries are loaded by rl_gpu_open with dlopen, not before. A context is current in the thread that
 * opened it; use it from there only, and close it before opening another: Mesa's libraries share the notion
 * of what is current. What Mesa reads from the environment (GALLIUM_DRIVER, LP_NUM_THREADS) counts at the
 * first open of a process. Several scenes may live on one context and be drawn in turn (interleaved timing).
 */
#ifndef RL_GPU_GPU_H
#define RL_GPU_GPU_H

#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "image/image.h"
#include "scene/plan.h"
#include "scene/scene.h"

struct rl_gpu;
struct rl_gpu_scene;

struct rl_gpu_info {
    const char *backend; /* "osmesa", "egl-surfaceless", "egl-device" */
    char renderer[128], vendor[128], version[128], glsl[64];
};

/* `backend`: "auto" (osmesa, then egl-surfaceless, then egl-device), "osmesa", "egl" (surfaceless, then
 * device), "egl-surfaceless" or "egl-device". RL_ERR_INPUT: no such name. RL_ERR_UNAVAILABLE: each rejected
 * one and why. Needs GL 4.5 core. GALLIUM_DRIVER is checked first: an unknown value would end the process. */
int rl_gpu_open(struct rl_gpu **gpu, const char *backend, struct rl_error *error);
void rl_gpu_close(struct rl_gpu *gpu);
const struct rl_gpu_info *rl_gpu_describe(const struct rl_gpu *gpu);

/* The names rl_gpu_open tries one by one; for `info`, which opens each. */
extern const char *const rl_gpu_backends[];
extern const size_t rl_n_gpu_backends;

/* What the GL layer counted since the scene was made or rl_gpu_scene_reset_counters. */
struct rl_gpu_counters {
    size_t draws, triangles; /* triangles: all that were drawn, culled or not */
    size_t
        triangles_culled; /* of these, back faces, as seen from where the camera was when the scene was made */
    size_t programs, modules, textures; /* in use; modules: of all programs, each as often as it is in one */
    size_t programs_kept,
        textures_kept;    /* of these, those that the context had from before and took no time or upload */
    size_t renderbuffers; /* allocated: colour and depth of the picture, and the depth of environment maps */
    size_t bytes_uploaded, bytes_kept; /* the latter: those of kept textures, which were uploaded before */
};

/* Compiles the plan's programs, uploads meshes, bakes and uploads normal maps and patterns, allocates the
 * environment maps and renders them once. A shader error names module and line. `scene` and `plan` must
 * outlive it. */
int rl_gpu_scene_make(struct rl_gpu_scene **out, struct rl_gpu *gpu, const struct rl_scene *scene,
                      const struct rl_plan *plan, struct rl_error *error);
void rl_gpu_scene_free(struct rl_gpu_scene *gs);

/* The normal map of these settings (normal_bits, normal_size, seed) as shaders get it: baked, uploaded, and read back as floats, four a
 * texel: (H + 1)/2 and alpha, row by row. free() them. Draws nothing and keeps nothing on the GPU. */
int rl_gpu_normal_map_read(float **texels, struct rl_gpu *gpu, const struct rl_plan_normal_map *map,
                           const struct rl_settings *settings, struct rl_error *error);

/* Draws one frame (surface, sphere and highlight passes) into the scene's frame buffer and waits until it is
 * finished; *seconds is its wall time. The environment maps are not drawn again: */
int rl_gpu_scene_frame(struct rl_gpu_scene *gs, double *seconds, struct rl_error *error);
/* Makes OpenGL compile what it compiles at the first frame, so that no frame takes longer than the next. Draws one pixel: the frame
 * buffer holds no picture after it. */
int rl_gpu_scene_warm_up(struct rl_gpu_scene *gs, struct rl_error *error);
/* Draws every environment map again, waits; for lights or objects that move. */
int rl_gpu_scene_environment(struct rl_gpu_scene *gs, double *seconds, struct rl_error *error);

/* Bakes the normal maps again, from this seed and otherwise as the plan's settings are now, whose normal_bits may have changed: the next
 * frame is that of a scene made so, at a fraction of the cost. Nothing to do where no method uses a map. */
int rl_gpu_scene_reseed(struct rl_gpu_scene *gs, uint64_t seed, struct rl_error *error);

/* The last frame as R, G, B, A float. Allocates `image`. */
int rl_gpu_scene_read(struct rl_gpu_scene *gs, struct rl_image *image, struct rl_error *error);

/* Where the last frame's highlight pass drew, as one channel of 1 and 0: what the sphere pass let through. Highlights drawn with the
 * surface (plain) are not in it. Allocates `image`. */
int rl_gpu_scene_read_drawn(struct rl_gpu_scene *gs, struct rl_image *image, struct rl_error *error);

/* Which object and triangle each pixel shows: as two channels, numbers from 1 on as the scene and the mesh count them; 0: background. Drawn
 * with the plan's depth buffer and culling by a program that is made for it; the frame buffer holds no picture after it. Allocates `image`.
 * RL_ERR_INPUT: a mesh of more than 2^24 triangles, which floats do not count. (identity.c) */
int rl_gpu_scene_read_identity(struct rl_gpu_scene *gs, struct rl_image *image, struct rl_error *error);

/* The bits that OpenGL gave the depth and the stencil buffer; 0: none. */
void rl_gpu_scene_depth(const struct rl_gpu_scene *gs, int *depth_bits, int *stencil_bits);

/* One environment map, six faces of size x size side by side in GL's order (+x -x +y -y +z -z), radiance RGB.
 * For tests and pictures. RL_ERR_INPUT if the object has none. */
int rl_gpu_scene_read_environment(struct rl_gpu_scene *gs, size_t object, struct rl_image *image,
                                  struct rl_error *error);

struct rl_gpu_counters rl_gpu_scene_counters(const struct rl_gpu_scene *gs);
void rl_gpu_scene_reset_counters(struct rl_gpu_scene *gs);

#endif
