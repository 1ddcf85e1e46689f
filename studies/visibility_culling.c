/* Measures what back-face culling saves, and whether a pixel changes (see visibility.h). */
#include <stdint.h>
#include <string.h>

#include "scene/mesh.h"
#include "studies/timing_arms.h"
#include "studies/visibility.h"

enum { ARMS = 3 };

/* Of one arm, over all views. */
struct tally {
    size_t pixels, changed, sure, changed_sure;
};

static bool same_bits(const float a[4], const float b[4])
{
    uint32_t p[4], q[4];
    memcpy(p, a, sizeof p);
    memcpy(q, b, sizeof q);
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2] && p[3] == q[3];
}

/* Adds what a view's pictures show, and what of it differs in any bit. */
static void count(struct tally *tally, const struct rl_image *with, const struct rl_image *image,
                  const struct rl_visibility_truth *truth)
{
    for (size_t i = 0; i < truth->n; i++) {
        const float *p = &with->data[4 * i], *q = &image->data[4 * i];
        bool changed = !same_bits(p, q);
        tally->pixels += p[3] > 0.0f || q[3] > 0.0f;
        tally->changed += changed;
        tally->sure += truth->sure[i];
        tally->changed_sure += truth->sure[i] && changed;
    }
}

/* Of all objects that are drawn. */
static int add_meshes(struct rl_record *r, const struct rl_bench_scene *set, struct rl_error *error)
{
    bool all_closed = true;
    size_t triangles = 0, back = 0;
    int status = RL_OK;
    for (size_t i = 0; i < set->scene.n_objects && status == RL_OK; i++) {
        const struct rl_mesh *mesh = &set->scene.object[i].mesh;
        bool closed = false;
        if (!set->plan.object[i].drawn)
            continue;
        status = rl_mesh_closed(&closed, mesh, error);
        all_closed = all_closed && closed;
        triangles += mesh->n_triangles;
        back += rl_mesh_back_faces(mesh, set->scene.camera.position);
    }
    if (status == RL_OK)
        status = rl_record_add_exact(r, "closed", all_closed, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "triangles", (double)triangles, "1", error);
    return status == RL_OK ? rl_record_add_exact(r, "back_faces", (double)back, "1", error) : status;
}

/* All arms, set up for one view. */
static int make_sets(struct rl_bench_scene *set[ARMS], const struct rl_record *records, size_t n,
                     struct rl_bench *bench, const struct rl_scene *view, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = rl_bench_scene_make(&set[i], bench, view, records[i].parameters, 1, error);
    return status;
}

static void free_sets(struct rl_bench_scene *set[ARMS], size_t n)
{
    for (size_t i = 0; i < n; i++) {
        rl_bench_scene_free(set[i]);
        set[i] = NULL;
    }
}

/* Adds one view's pixels to each arm's. */
static int compare_pictures(struct tally tally[ARMS], struct rl_bench_scene *const set[ARMS], size_t n,
                            struct rl_bench *bench, const struct rl_visibility_truth *truth,
                            struct rl_error *error)
{
    struct rl_image with = {0}, image = {0};
    int status = rl_bench_draw(&with, bench, set[0], error);
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        status = rl_bench_draw(&image, bench, set[i], error);
        if (status == RL_OK)
            count(&tally[i], &with, &image, truth);
        rl_image_clear(&image);
    }
    rl_image_clear(&with);
    return status;
}

static int add_tally(struct rl_record *r, const struct tally *tally, struct rl_error *error)
{
    int status = rl_record_add_exact(r, "pixels", (double)tally->pixels, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "changed", (double)tally->changed, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "sure_pixels", (double)tally->sure, "1", error);
    return status == RL_OK ? rl_record_add_exact(r, "changed_sure", (double)tally->changed_sure, "1", error)
                           : status;
}

static int measure_pictures(struct rl_record *records, size_t n, struct rl_bench *bench,
                            const struct rl_scene *scene, struct rl_error *error)
{
    const char *p = records[0].parameters;
    int views = (int)rl_parameter_number(p, "views");
    struct tally tally[ARMS] = {{0}};
    struct rl_bench_scene *set[ARMS] = {NULL};
    struct rl_visibility_truth truth;
    const struct rl_raster_options options = {.width = (int)rl_parameter_number(p, "width"),
                                              .height = (int)rl_parameter_number(p, "height"),
                                              .culling = true};
    int status = rl_visibility_truth_make(&truth, (size_t)options.width * (size_t)options.height, error);
    for (int v = 0; v < views && status == RL_OK; v++) {
        struct rl_scene view;
        rl_visibility_view(&view, scene, v);
        status = make_sets(set, records, n, bench, &view, error);
        rl_visibility_truth_find(&truth, &view, &options, &bench->spent);
        if (status == RL_OK)
            status = compare_pictures(tally, set, n, bench, &truth, error);
        for (size_t i = 0; i < n && status == RL_OK && v == 0; i++)
            status = add_meshes(&records[i], set[i], error);
        free_sets(set, n);
        if (status == RL_OK && rl_progress_cancelled(&bench->quiet))
            status = rl_fail(error, RL_ERR_CANCELLED, "interrupted");
    }
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = add_tally(&records[i], &tally[i], error);
    rl_visibility_truth_clear(&truth);
    return status;
}

static int measure_times(struct rl_record *records, size_t n, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error)
{
    int rounds = (int)rl_parameter_number(records[0].parameters, "rounds");
    if (rounds < 1)
        return RL_OK;
    struct rl_bench_scene *set[ARMS] = {NULL};
    struct rl_timing_arm arm[ARMS];
    const struct rl_arms_options options = {.frames = rounds,
                                            .most_frames = 4 * rounds,
                                            .most_seconds = 0.03 * rounds,
                                            .against = "arm=on",
                                            .ratio = "time_to_on",
                                            .difference = "above_on_ms"};
    int status = make_sets(set, records, n, bench, scene, error);
    for (size_t i = 0; i < n; i++)
        arm[i] = (struct rl_timing_arm){records[i].parameters, rl_arms_frame, set[i]};
    if (status == RL_OK)
        status = rl_arms_time(records, arm, n, bench, &options, error);
    free_sets(set, n);
    return status;
}

int rl_visibility_measure_culling(struct rl_record *records, size_t n, struct rl_bench *bench,
                                  const struct rl_scene *scene, struct rl_error *error)
{
    if (n > ARMS || !rl_parameters_match(records[0].parameters, "arm=on"))
        return rl_fail(error, RL_ERR_INPUT,
                       "a group of %zu cases of culling, expected arm=on and up to two others", n);
    int status = measure_pictures(records, n, bench, scene, error);
    return status == RL_OK ? measure_times(records, n, bench, scene, error) : status;
}
