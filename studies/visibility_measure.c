/* Measures which surface depth buffers show against the exact one (see visibility.h). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "measure/statistics.h"
#include "studies/visibility.h"

enum { ARMS_MAX = 8, VIEWS_MAX = 64 };

/* What is gathered of one arm. */
struct tally {
    double wrong[VIEWS_MAX], ideal[VIEWS_MAX]; /* shares, by view */
    double worst;
    size_t wrong_pixels, missing;
};

static struct rl_raster_options options_of(const struct rl_settings *s)
{
    return (struct rl_raster_options){.width = s->width,
                                      .height = s->height,
                                      .culling = s->culling,
                                      .depth_bits = s->depth_bits,
                                      .reversed_depth = s->reversed_depth};
}

/* What the GPU shows, as objects and triangles, and the bits it does it with. */
static int draw(struct rl_image *identity, int *bits, struct rl_bench *bench, const struct rl_scene *view,
                const char *parameters, struct rl_error *error)
{
    struct rl_bench_scene *set;
    int stencil;
    int status = rl_bench_scene_make(&set, bench, view, parameters, 1, error);
    if (status != RL_OK)
        return status;
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    status = rl_gpu_scene_read_identity(set->gpu_scene, identity, error);
    rl_spent_on(&bench->spent, outer);
    rl_gpu_scene_depth(set->gpu_scene, bits, &stencil);
    rl_bench_scene_free(set);
    return status;
}

static bool shows(const float id[2], const struct rl_raster_pixel *p)
{
    return id[0] == (float)p->object && id[1] == (float)p->triangle;
}

/* 0: background, 1: right, 2: wrong, 3: not judged. */
static int kind_of(const struct rl_visibility_truth *t, const struct rl_image *identity, size_t i)
{
    const struct rl_raster_pixel *p = &t->at[0][i];
    if (p->object == 0)
        return 0;
    return !t->sure[i] ? 3 : shows(&identity->data[2 * i], p) ? 1 : 2;
}

static int add_map(struct rl_record *r, const struct rl_visibility_truth *t, const struct rl_image *identity,
                   struct rl_error *error)
{
    size_t n = 2 + (t->n + RL_VISIBILITY_PACKED - 1) / RL_VISIBILITY_PACKED;
    double *map = calloc(n, sizeof *map);
    if (!map)
        return rl_fail_memory(error, "a map of wrong pixels");
    map[0] = identity->width;
    map[1] = identity->height;
    for (size_t i = 0; i < t->n; i++)
        map[2 + i / RL_VISIBILITY_PACKED] +=
            ldexp(kind_of(t, identity, i), 2 * (int)(i % RL_VISIBILITY_PACKED));
    int status = rl_record_series_add(r, "map", map, n, error);
    free(map);
    return status;
}

/* Counts where the pictures differ from the truth, and how far behind it what they show lies, in steps. */
static void compare(struct tally *tally, int view_index, const struct rl_visibility_truth *t,
                    const struct rl_image *identity, const struct rl_raster_pixel *ideal,
                    const struct rl_scene *view, const struct rl_raster_options *o)
{
    size_t wrong = 0, of_ideal = 0;
    for (size_t i = 0; i < t->n; i++) {
        const struct rl_raster_pixel *p = &t->at[0][i];
        const float *id = &identity->data[2 * i];
        if (!t->sure[i])
            continue;
        of_ideal += ideal[i].object != p->object || ideal[i].triangle != p->triangle;
        if (shows(id, p))
            continue;
        wrong++;
        if (!(id[0] > 0.0f)) {
            tally->missing++;
            continue;
        }
        double z = rl_raster_depth(view, o, (uint32_t)id[0], (uint32_t)id[1], (int)(i % (size_t)o->width),
                                   (int)(i / (size_t)o->width));
        tally->worst = fmax(tally->worst, (z - p->z) / rl_raster_resolution(&view->camera, o, z));
    }
    double n = t->n_sure > 0 ? (double)t->n_sure : 1.0;
    tally->wrong[view_index] = (double)wrong / n;
    tally->ideal[view_index] = (double)of_ideal / n;
    tally->wrong_pixels += wrong;
}

static int measure_arm(struct rl_record *r, struct tally *tally, int index,
                       const struct rl_visibility_truth *t, const struct rl_scene *view,
                       struct rl_bench *bench, struct rl_error *error)
{
    struct rl_settings settings;
    struct rl_image identity = {0};
    int bits = 0;
    int status = rl_bench_settings(&settings, r->parameters, error);
    if (status != RL_OK)
        return status;
    const struct rl_raster_options o = options_of(&settings);
    struct rl_raster_pixel *ideal = malloc(t->n * sizeof *ideal);
    if (!ideal)
        return rl_fail_memory(error, "an ideal picture");
    status = draw(&identity, &bits, bench, view, r->parameters, error);
    if (status == RL_OK && bits != settings.depth_bits)
        status = rl_fail(error, RL_ERR_UNAVAILABLE, "OpenGL gave a depth buffer of %d bits in place of %d",
                         bits, settings.depth_bits);
    if (status == RL_OK) {
        enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_REFERENCE);
        rl_raster_draw(ideal, view, &o);
        rl_spent_on(&bench->spent, outer);
        compare(tally, index, t, &identity, ideal, view, &o);
    }
    if (status == RL_OK && index == 0 && rl_parameters_match(r->parameters, "map=on"))
        status = add_map(r, t, &identity, error);
    rl_image_clear(&identity);
    free(ideal);
    return status;
}

/* Of a single view the share is what it is. */
static struct rl_interval share(const double *x, size_t n)
{
    struct rl_interval mean = rl_mean_interval(x, n, 0.95);
    return n == 1 ? rl_exact_interval(x[0])
                  : (struct rl_interval){mean.value, fmax(mean.low, 0.0), fmin(mean.high, 1.0)};
}

static int add_tally(struct rl_record *r, const struct tally *tally, const double *sure, size_t views,
                     struct rl_error *error)
{
    const struct {
        const char *name;
        struct rl_interval x;
    } row[] = {
        {"sure", share(sure, views)},
        {"wrong", share(tally->wrong, views)},
        {"ideal", share(tally->ideal, views)},
        {"worst", rl_exact_interval(tally->worst)},
        {"wrong_pixels", rl_exact_interval((double)tally->wrong_pixels)},
        {"missing", rl_exact_interval((double)tally->missing)},
    };
    int status = RL_OK;
    for (size_t i = 0; i < sizeof row / sizeof row[0] && status == RL_OK; i++)
        status = rl_record_add(r, row[i].name, row[i].x, "1", error);
    if (status == RL_OK)
        status = rl_record_series_add(r, "wrong", tally->wrong, views, error);
    return status == RL_OK ? rl_record_series_add(r, "ideal", tally->ideal, views, error) : status;
}

static int measure_depth(struct rl_record *records, size_t n, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error)
{
    struct tally tally[ARMS_MAX] = {0};
    double sure[VIEWS_MAX];
    struct rl_settings settings;
    struct rl_visibility_truth truth;
    int views = (int)rl_parameter_number(records[0].parameters, "views");
    int status = rl_bench_settings(&settings, records[0].parameters, error);
    if (status == RL_OK && (views < 1 || views > VIEWS_MAX || n > ARMS_MAX))
        status = rl_fail(error, RL_ERR_INPUT, "views=%d, %zu cases: expected 1 to %d, at most %d", views, n,
                         VIEWS_MAX, ARMS_MAX);
    if (status == RL_OK)
        status = rl_visibility_truth_make(&truth, (size_t)settings.width * (size_t)settings.height, error);
    if (status != RL_OK)
        return status;
    const struct rl_raster_options options = options_of(&settings);
    for (int v = 0; v < views && status == RL_OK; v++) {
        struct rl_scene view;
        rl_visibility_view(&view, scene, v);
        view.camera.near_plane = view.camera.far_plane / rl_parameter_number(records[0].parameters, "ratio");
        rl_visibility_truth_find(&truth, &view, &options, &bench->spent);
        sure[v] = truth.n_surface > 0 ? (double)truth.n_sure / (double)truth.n_surface : 0.0;
        if (truth.n_sure == 0)
            status = rl_fail(error, RL_ERR_INPUT, "no pixel shows a surface for sure");
        for (size_t i = 0; i < n && status == RL_OK; i++)
            status = measure_arm(&records[i], &tally[i], v, &truth, &view, bench, error);
        if (status == RL_OK && rl_progress_cancelled(&bench->quiet))
            status = rl_fail(error, RL_ERR_CANCELLED, "interrupted");
    }
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = add_tally(&records[i], &tally[i], sure, (size_t)views, error);
    rl_visibility_truth_clear(&truth);
    return status;
}

int rl_visibility_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                          const struct rl_scene *scene, struct rl_error *error)
{
    if (rl_parameters_match(records[0].parameters, "series=culling"))
        return rl_visibility_measure_culling(records, n, bench, scene, error);
    return measure_depth(records, n, bench, scene, error);
}
