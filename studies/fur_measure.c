/* Measures fur at vertices against pixels, monochrome against colours, and what each model costs (see fur.h). */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "measure/metrics.h"
#include "measure/statistics.h"
#include "studies/fur.h"
#include "studies/scene_check.h"
#include "studies/timing_arms.h"

static int add(struct rl_record *r, const char *name, double value, struct rl_error *error)
{
    return rl_record_add_exact(r, name, value, "1", error);
}

/* ---- Two pictures of one mesh ---- */

/* The case's picture but for what `less` says, against that but for what `more` says. */
static int compare(struct rl_record *r, struct rl_bench *bench, const struct rl_scene *scene,
                   const char *less, const char *more, struct rl_error *error)
{
    struct rl_image a = {0}, b = {0};
    struct rl_metrics m = {0};
    int status = rl_fur_picture(&a, bench, scene, r->parameters, less, error);
    if (status == RL_OK)
        status = rl_fur_picture(&b, bench, scene, r->parameters, more, error);
    if (status == RL_OK)
        status = rl_foreground_check(&b, error);
    if (status == RL_OK)
        status = rl_metrics_compute(&m, &a, &b, error);
    if (status == RL_OK && m.nonfinite > 0)
        status = rl_fail(error, RL_ERR_CHECK, "%zu values are not finite", m.nonfinite);
    rl_image_clear(&a);
    rl_image_clear(&b);
    if (status == RL_OK)
        status = add(r, "rmse", m.rmse, error);
    return status == RL_OK ? add(r, "max", m.max, error) : status;
}

static int add_triangles(struct rl_record *r, const struct rl_scene *scene, struct rl_error *error)
{
    struct rl_fur_scene s;
    double triangles = 0.0;
    int status = rl_fur_scene_make(&s, scene, r->parameters, error);
    for (size_t i = 0; i < s.scene.n_objects && status == RL_OK; i++)
        triangles += (double)s.scene.object[i].mesh.n_triangles;
    rl_fur_scene_clear(&s);
    return status == RL_OK ? add(r, "triangles", triangles, error) : status;
}

static int measure_vertex(struct rl_record *r, struct rl_bench *bench, const struct rl_scene *scene,
                          struct rl_error *error)
{
    int status = compare(r, bench, scene, "interpolation=gouraud", "interpolation=phong", error);
    return status == RL_OK ? add_triangles(r, scene, error) : status;
}

/* ---- Times ---- */

enum { ARMS_MAX = RL_TIMING_ARMS_MAX };

struct arms {
    size_t n;
    struct rl_fur_scene scene[ARMS_MAX];
    struct rl_bench_scene *set[ARMS_MAX];
    struct rl_timing_arm arm[ARMS_MAX];
};

static int begin_arm(struct arms *arms, struct rl_record *r, struct rl_bench *bench,
                     const struct rl_scene *scene, struct rl_error *error)
{
    size_t i = arms->n;
    double seconds;
    int status = rl_fur_scene_make(&arms->scene[i], scene, r->parameters, error);
    arms->n++;
    if (status == RL_OK)
        status = rl_bench_scene_make(&arms->set[i], bench, &arms->scene[i].scene, r->parameters, 1, error);
    if (status != RL_OK)
        return status;
    struct rl_gpu_scene *gpu_scene = arms->set[i]->gpu_scene;
    arms->arm[i] = (struct rl_timing_arm){r->parameters, rl_arms_frame, arms->set[i]};
    status = rl_gpu_scene_warm_up(gpu_scene, error);
    rl_gpu_scene_reset_counters(gpu_scene);
    if (status == RL_OK)
        status = rl_gpu_scene_frame(gpu_scene, &seconds, error);
    struct rl_gpu_counters frame = rl_gpu_scene_counters(gpu_scene);
    if (status == RL_OK)
        status = add(r, "draws", (double)frame.draws, error);
    return status == RL_OK ? add(r, "triangles", (double)frame.triangles, error) : status;
}

/* The arm of the same effect per pixel in colour, over which its time is taken, round by round. */
static int add_ratio(struct rl_record *r, struct rl_record *records, size_t n, struct rl_error *error)
{
    char effect[RL_NAME_MAX], pattern[160];
    rl_parameter(r->parameters, "effect", effect, sizeof effect);
    snprintf(pattern, sizeof pattern, "effect=%s interpolation=phong monochrome=off arm=frame", effect);
    size_t k = 0;
    while (k < n && !rl_parameters_match(records[k].parameters, pattern))
        k++;
    const struct rl_series *a = rl_record_series(r, "frame_ms");
    const struct rl_series *b = k < n ? rl_record_series(&records[k], "frame_ms") : NULL;
    if (!a || !b)
        return rl_fail(error, RL_ERR_INPUT, "no arm '%s' among those timed together", pattern);
    return rl_record_add(r, "time_to_pixel",
                         rl_interval_from_0(rl_ratio_interval(a->value, b->value, a->n, 0.95)), "1", error);
}

static int measure_time(struct rl_record *records, size_t n, struct rl_bench *bench,
                        const struct rl_scene *scene, struct rl_error *error)
{
    struct arms arms = {0};
    int frames = (int)rl_parameter_number(records[0].parameters, "frames"), status = RL_OK;
    if (n > ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, at most %d are timed together", n,
                       ARMS_MAX);
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = begin_arm(&arms, &records[i], bench, scene, error);
    const struct rl_arms_options options = {.frames = frames,
                                            .most_frames = 3 * frames,
                                            .most_seconds =
                                                rl_parameter_number(records[0].parameters, "seconds"),
                                            .baseline = "effect=none"};
    if (status == RL_OK)
        status = rl_arms_time(records, arms.arm, n, bench, &options, error);
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = add_ratio(&records[i], records, n, error);
    for (size_t i = 0; i < arms.n; i++) {
        rl_bench_scene_free(arms.set[i]);
        rl_fur_scene_clear(&arms.scene[i]);
    }
    return status;
}

/* ---- All ---- */

static int measure_one(struct rl_record *r, struct rl_bench *bench, const struct rl_scene *scene,
                       struct rl_error *error)
{
    const char *p = r->parameters;
    if (rl_parameters_match(p, "series=terms"))
        return rl_fur_measure_terms(r, error);
    if (rl_parameters_match(p, "series=form"))
        return rl_fur_measure_form(r, error);
    if (rl_parameters_match(p, "series=profile"))
        return rl_fur_measure_profile(r, bench, error);
    if (rl_parameters_match(p, "series=mono"))
        return compare(r, bench, scene, "monochrome=on", "monochrome=off", error);
    return measure_vertex(r, bench, scene, error);
}

int rl_fur_measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                   struct rl_error *error)
{
    if (rl_parameters_match(records[0].parameters, "series=panel"))
        return rl_fur_measure_sheet(records, n, bench, scene, error);
    if (rl_parameters_match(records[0].parameters, "series=time"))
        return measure_time(records, n, bench, scene, error);
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = measure_one(&records[i], bench, scene, error);
    rl_spent_on(&bench->spent, outer);
    return status;
}
