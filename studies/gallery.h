/* The report's pictures: one scene by every method beside the reference, and the error of each with a scale, at several R_r. */
#ifndef RL_STUDIES_GALLERY_H
#define RL_STUDIES_GALLERY_H

#include "base/error.h"
#include "base/progress.h"
#include "results/buffer.h"
#include "scene/scene.h"
#include "studies/bench.h"

struct rl_gallery {
    const char *scene_name; /* as the page calls it */
    const struct rl_scene *scene;
    int width, height; /* pixels */
    double tolerance;  /* of the reference */
    const double *rr;
    size_t n_rr;
    const char *folder; /* of the page: pictures are written beside it */
};

/* Renders, writes EXR and PNG, and adds the section to the page. Uses the paper's settings. */
int rl_gallery_make(struct rl_buffer *page, const struct rl_gallery *gallery, struct rl_bench *bench,
                    const struct rl_progress *progress, struct rl_error *error);

#endif
