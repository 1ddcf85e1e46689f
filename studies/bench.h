/* The bench that cases are measured on: a GPU context, references kept from case to case, and scenes set up as a case's
 * parameters say.
 *
 *     struct rl_bench_scene *set;
 *     rl_bench_scene_make(&set, bench, &scene, "method=random samples=4 rr=30 width=320 height=240", 1, &error);
 *     rl_gpu_scene_frame(set->gpu_scene, &seconds, &error);
 *     rl_bench_scene_free(set);
 *     rl_bench_reference(&truth, bench, &scene, "rr=30 width=320 height=240", RL_LIGHT_FROM_POINT, &error);
 */
#ifndef RL_STUDIES_BENCH_H
#define RL_STUDIES_BENCH_H

#include <stdint.h>

#include "base/error.h"
#include "base/progress.h"
#include "gpu/gpu.h"
#include "image/image.h"
#include "results/provenance.h"
#include "scene/plan.h"
#include "scene/scene.h"
#include "studies/spent.h"

struct rl_bench {
    struct rl_gpu *gpu;
    struct rl_provenance provenance;
    int threads;           /* of the CPU renderer; 0: as many as the process may use */
    const char *cache;     /* folder where references are kept; made when first needed */
    struct rl_spent spent; /* where the time goes; the functions here note what they do themselves */
    struct rl_progress
        quiet; /* asks the owner's progress whether to stop, and hands on notes, but reports no steps */
    /* References kept in memory, one of each kind (enum rl_light_from), with their keys; key 0: none. */
    uint64_t reference_key[2];
    struct rl_image reference[2];
};

/* Opens the backend (rl_gpu_open) and notes the provenance. */
int rl_bench_open(struct rl_bench *bench, const char *backend, int threads, const char *cache,
                  const struct rl_progress *progress, struct rl_error *error);
void rl_bench_close(struct rl_bench *bench);

/* A scene on the GPU with the settings of a case. */
struct rl_bench_scene {
    struct rl_bench *bench;
    struct rl_scene scene; /* a view of the caller's: only `material` is a copy */
    struct rl_plan plan;
    struct rl_gpu_scene *gpu_scene;
};

/* Settings that `parameters` name, over the paper's defaults (RL_SETTINGS_DEFAULT; the scene's own render block does not count, so
 * that a case's parameters say all). Keys: method, interpolation, samples, rr, frame, normal_bits, normal_size, env_size, env_format,
 * margin, width, height, seed, tolerance, culling, depth_bits, reversed_depth. method=none is left to rl_bench_scene_make. */
int rl_bench_settings(struct rl_settings *settings, const char *parameters, struct rl_error *error);

/* `scene` must outlive it. method=none takes every material's highlight away. `seed` replaces that of the parameters. */
int rl_bench_scene_make(struct rl_bench_scene **out, struct rl_bench *bench, const struct rl_scene *scene,
                        const char *parameters, uint64_t seed, struct rl_error *error);
/* NULL is fine. */
void rl_bench_scene_free(struct rl_bench_scene *set);

/* Draws a frame and reads it, on the clock of what is measured. */
int rl_bench_draw(struct rl_image *image, struct rl_bench *bench, struct rl_bench_scene *set,
                  struct rl_error *error);

/* One picture: made, drawn, read. */
int rl_bench_picture(struct rl_image *image, struct rl_bench *bench, const struct rl_scene *scene,
                     const char *parameters, uint64_t seed, struct rl_error *error);

/* The reference image for a case: from memory, from the cache, or computed and then kept in both. What determines it, the program
 * included, is its key, which its file holds: where a file has the right name and another key, or is damaged, the image is computed
 * again, with a note to the owner's progress. A `frame` counts only beside method=reference: else the truth is orthonormal. The image
 * belongs to the bench and is valid until the next call for the same `from`. From the object's centre (RL_LIGHT_FROM_OBJECT) lights
 * are seen as environment maps see them: truth but for their parallax. RL_ERR_INPUT: it shows nothing but background. */
int rl_bench_reference(const struct rl_image **image, struct rl_bench *bench, const struct rl_scene *scene,
                       const char *parameters, enum rl_light_from from, struct rl_error *error);

#endif
