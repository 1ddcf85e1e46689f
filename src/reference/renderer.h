/* The CPU renderer: Embree finds the visible point of each pixel's centre, effects are evaluated in double precision, the
 * highlight by the material's method if that is one of the CPU (`plain`, `exhaustive`, `reference`). OpenMP over tiles.
 *
 * With a budget of time the image is drawn in passes of decreasing tolerance (accuracy.h). The first, loosest one is always
 * completed, however long it takes; a later one stops where the time is up, and each pixel keeps the best result it has had.
 * With time enough every pixel is within the tolerance, as without a budget.
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
    /* Error estimates of L_o over all pixels and channels of the foreground: largest, root mean square, mean. */
    double worst_error, rms_error, mean_error;
    size_t evaluations; /* lines, of all passes */
    size_t texels;      /* texel-normals: texels evaluated, one shading point each */
    int threads;
    int passes, passes_completed; /* planned, and not cut short */
    double first_seconds;         /* when the first pass was completed */
};

struct rl_render_limits {
    int threads;             /* <= 0: as many as the process may use */
    double max_seconds;      /* from the call on; 0: no limit, one pass */
    struct rl_image *errors; /* NULL, or allocated and filled: see rl_reference_render_within */
};

/* Allocates `image` (R, G, B, A). threads <= 0: as many as the process may use. RL_ERR_CANCELLED leaves no image. */
int rl_reference_render(struct rl_image *image, struct rl_render_stats *stats, const struct rl_scene *scene,
                        const struct rl_plan *plan, int threads, const struct rl_progress *progress,
                        struct rl_error *error);

/* The same within limits. `errors` gets R, G, B and A as `image` has them: how far off each value of the image may be, the
 * material's factor and the rounding to float included. */
int rl_reference_render_within(struct rl_image *image, struct rl_render_stats *stats,
                               const struct rl_scene *scene, const struct rl_plan *plan,
                               const struct rl_render_limits *limits, const struct rl_progress *progress,
                               struct rl_error *error);

/* Embree's version as text. */
void rl_reference_library(char version[64]);

#endif
