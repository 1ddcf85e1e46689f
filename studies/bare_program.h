/* A program in bare OpenGL for one kind of scene and no other, as one would write it by hand: the yardstick for what the general pipeline
 * costs. Nothing of plans, modules or generated code is in it; only the context, the meshes and the camera are shared.
 *
 *     struct rl_bare *bare;
 *     rl_bare_make(&bare, gpu, &scene, 640, 480, RL_BARE_UNIFORMS, &error);
 *     rl_bare_frame(bare, &seconds, &error);
 *     rl_bare_free(bare);
 */
#ifndef RL_STUDIES_BARE_PROGRAM_H
#define RL_STUDIES_BARE_PROGRAM_H

#include "base/error.h"
#include "gpu/gpu.h"
#include "image/image.h"
#include "scene/scene.h"

struct rl_bare;

/* How the shader gets the numbers of material, lights and eye: as uniforms, so that they may change, or as literals. */
enum rl_bare_numbers { RL_BARE_UNIFORMS, RL_BARE_LITERALS };

/* RL_ERR_INPUT and what was expected, where it is not a scene of one object with `diffuse` and `phong` (no other effect, grazing 0), one point
 * light and one parallel light. */
int rl_bare_check(const struct rl_scene *scene, struct rl_error *error);

/* The same frame buffer as the pipeline's, but for the stencil bits that the scene has no use for. `scene` is not needed after it. */
int rl_bare_make(struct rl_bare **out, struct rl_gpu *gpu, const struct rl_scene *scene, int width,
                 int height, enum rl_bare_numbers numbers, struct rl_error *error);
/* NULL is fine. */
void rl_bare_free(struct rl_bare *bare);

/* For rl_timing_arm.frame: one frame of the struct rl_bare that is its `user`, finished. */
int rl_bare_frame(void *user, double *seconds, struct rl_error *error);

/* The last frame as R, G, B, A float. Allocates `image`. */
int rl_bare_read(struct rl_bare *bare, struct rl_image *image, struct rl_error *error);

#endif
