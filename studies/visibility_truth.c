/* The exact answer of a view, and where it is beyond doubt (see visibility.h). */
#include <stdlib.h>

#include "model/random.h"
#include "studies/visibility.h"

/* Coverage: OpenGL places corners on a grid of at least 1/16 of a pixel (OpenGL 4.5, SUBPIXEL_BITS), Mesa and today's GPUs on one of 1/256. A
 * pixel whose nearest surface is another one at a corner of a square about its centre is not judged: a straight edge that passes nearer to the
 * centre than half the square's side cuts off a corner. This is half its side. */
static const double place_px = 1.0 / 64.0;

/* Two surfaces nearer to each other than double precision is sure of, relative to z. */
static const double same_z = 1e-12;

/* How far the eye moves from view to view, as a share of the far plane's distance. */
static const double moved = 0.002;

void rl_visibility_view(struct rl_scene *view, const struct rl_scene *scene, int index)
{
    *view = *scene;
    struct rl_camera *c = &view->camera;
    double off[3] = {0.0, 0.0, 0.0};
    for (uint64_t k = 0; k < 3 && index > 0; k++)
        off[k] = moved * c->far_plane * (2.0 * rl_random_uniform(1, 3 * (uint64_t)index + k) - 1.0);
    c->position = v3_add(c->position, v3(off[0], off[1], off[2]));
}

int rl_visibility_truth_make(struct rl_visibility_truth *t, size_t n, struct rl_error *error)
{
    *t = (struct rl_visibility_truth){.n = n, .sure = calloc(n, sizeof *t->sure)};
    bool all = t->sure != NULL;
    for (int k = 0; k < RL_VISIBILITY_PLACES; k++) {
        t->at[k] = calloc(n, sizeof *t->at[k]);
        all = all && t->at[k];
    }
    if (all)
        return RL_OK;
    rl_visibility_truth_clear(t);
    return rl_fail_memory(error, "a picture's triangles");
}

void rl_visibility_truth_clear(struct rl_visibility_truth *t)
{
    for (int k = 0; k < RL_VISIBILITY_PLACES; k++)
        free(t->at[k]);
    free(t->sure);
    *t = (struct rl_visibility_truth){0};
}

void rl_visibility_truth_find(struct rl_visibility_truth *t, const struct rl_scene *view,
                              const struct rl_raster_options *options, struct rl_spent *spent)
{
    enum rl_spent_kind outer = rl_spent_on(spent, RL_SPENT_REFERENCE);
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < RL_VISIBILITY_PLACES; k++) {
        struct rl_raster_options o = *options;
        o.dx = k == 0 ? 0.0 : k % 2 ? place_px : -place_px;
        o.dy = k == 0 ? 0.0 : k > 2 ? place_px : -place_px;
        o.depth_bits = 0;
        rl_raster_draw(t->at[k], view, &o);
    }
    t->n_surface = t->n_sure = 0;
    for (size_t i = 0; i < t->n; i++) {
        const struct rl_raster_pixel *p = &t->at[0][i];
        bool sure = p->object != 0 && p->gap > same_z * p->z;
        for (int k = 1; k < RL_VISIBILITY_PLACES; k++)
            sure = sure && t->at[k][i].object == p->object && t->at[k][i].triangle == p->triangle;
        t->sure[i] = sure;
        t->n_surface += p->object != 0;
        t->n_sure += sure;
    }
    rl_spent_on(spent, outer);
}
