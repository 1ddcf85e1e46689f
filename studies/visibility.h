/* Within the study `visibility`: plan and tables (visibility.c), the exact answer (visibility_truth.c), measuring (visibility_measure.c,
 * visibility_culling.c) and claims (visibility_claims.c). */
#ifndef RL_STUDIES_VISIBILITY_H
#define RL_STUDIES_VISIBILITY_H

#include "reference/raster.h"
#include "studies/study.h"

/* "series=depth", a group for each ratio of the far plane's distance to the near one's, a case for each depth buffer, over `views` from places
 * beside the camera's. Metrics: sure, the share of the surface's pixels whose answer no rounding of coverage can change; of these, wrong,
 * the share that shows another triangle than the exact one, and ideal, what an ideal depth buffer of so many bits would get wrong; worst,
 * how far behind the right surface a wrong one lies at most, in steps of the depth buffer there; wrong_pixels, and of them missing, which show
 * background. Series wrong and ideal, by view; with map=on a series map: width and height, then row by row what pixels show, 0
 * background, 1 the right triangle, 2 a wrong one, 3 not judged: RL_VISIBILITY_PACKED of them a value, the first in its last two bits.
 * "series=culling", a group for each method and depth buffer: arms on, again (the same) and off. Metrics: triangles and back_faces, both of
 * one frame's surface pass, closed (1: every mesh is), pixels (of the surface), changed (with other bits than arm=on), sure_pixels (whose answer no rounding of
 * coverage can change) and of them changed_sure, all over all views; with
 * rounds > 0 those of timing_arms.h, of the first view. */
enum { RL_VISIBILITY_PACKED = 24 };
int rl_visibility_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                          const struct rl_scene *scene, struct rl_error *error);
int rl_visibility_measure_culling(struct rl_record *records, size_t n, struct rl_bench *bench,
                                  const struct rl_scene *scene, struct rl_error *error);

/* The scene seen from the index-th place: 0 is its own camera's, the others are beside it by up to 1/500 of the far plane's distance in each
 * coordinate. Shares everything but the camera with `scene`. */
void rl_visibility_view(struct rl_scene *view, const struct rl_scene *scene, int index);

/* What a view shows exactly: at each pixel's centre, and at four places about it. */
enum { RL_VISIBILITY_PLACES = 5 };
struct rl_visibility_truth {
    size_t n;
    struct rl_raster_pixel *at[RL_VISIBILITY_PLACES]; /* the pixels' centres first */
    bool *sure;               /* some surface, and no rounding of coverage can change which triangle */
    size_t n_surface, n_sure; /* pixels that show something; those of them that are sure */
};

/* Room for n pixels. */
int rl_visibility_truth_make(struct rl_visibility_truth *t, size_t n, struct rl_error *error);
void rl_visibility_truth_clear(struct rl_visibility_truth *t);
/* Fills it for this view, with the size, the culling and whatever camera these have; n = width x height. */
void rl_visibility_truth_find(struct rl_visibility_truth *t, const struct rl_scene *view,
                              const struct rl_raster_options *options, struct rl_spent *spent);

int rl_visibility_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
