/* The CPU renderer: Embree finds the visible point of each pixel's centre, effects are evaluated in double precision, the
 * highlight by the material's method if that is one of the CPU (`plain`, `exhaustive`, `reference`). OpenMP over tiles.
 */
#ifndef RL_REFERENCE_RENDERER_H
#define RL_REFERENCE_RENDERER_H

#include "base/error.h"
#include "base/progress.h"
#include "image/image.h"
#include "scene/plan.h"
#include "scene/scene.h"

struct rl_render_stats {
    double seconds;
    size_t foreground;  /* pixels */
    size_t unconverged; /* pixels whose error estimate stayed above the tolerance */
    double worst_error; /* largest error estimate of any pixel and channel */
    size_t evaluations; /* lines */
    size_t texels;      /* texel-normals: texels evaluated, one shading point each */
    int threads;
};

/* Allocates `image` (R, G, B, A). threads <= 0: as many as the process may use. RL_ERR_CANCELLED leaves no image. */
int rl_reference_render(struct rl_image *image, struct rl_render_stats *stats, const struct rl_scene *scene,
                        const struct rl_plan *plan, int threads, const struct rl_progress *progress,
                        struct rl_error *error);

/* Embree's version as text. */
void rl_reference_library(char version[64]);

#endif
