/* Measures every feature of a scene, added and removed (see effects.h). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "measure/metrics.h"
#include "measure/statistics.h"
#include "measure/timing.h"
#include "studies/effects.h"
#include "studies/features.h"

/* ---- Arms ---- */

/* What of a scene's making and of its frame is counted. */
enum { DRAWS, TRIANGLES, BYTES, TEXTURES, PROGRAMS, MODULES, WORKS };
static const char *const work_name[WORKS] = {"draws",    "triangles", "bytes",
                                             "textures", "programs",  "modules"};

struct arm {
    struct rl_view view;
    struct rl_plan plan;
    struct rl_gpu_scene *gpu_scene;
    struct rl_image image;
    double work[WORKS];
};

/* Arms that a feature is held against come first. */
enum { FULL, AGAIN, BARE, SHINY, ZERO, BASES };

/* With a feature and without, in the bare scene and in the full one. */
struct pair {
    size_t bare_with, bare_without, full_with, full_without;
    bool named;
};

struct job {
    struct rl_bench *bench;
    struct rl_error *error;
    size_t n_features, n_arms;
    struct rl_feature feature[RL_FEATURES_MAX];
    struct pair pair[RL_FEATURES_MAX];
    struct arm *arm; /* RL_TIMING_ARMS_MAX */
};

static size_t count_modules(const struct rl_plan *plan)
{
    const char *seen[512];
    size_t n = 0;
    for (size_t i = 0; i < plan->n_programs; i++)
        for (size_t k = 0; k < plan->program[i].n_modules; k++) {
            const char *module = plan->program[i].module[k];
            size_t at = 0;
            while (at < n && strcmp(seen[at], module) != 0)
                at++;
            if (at == n && n < sizeof seen / sizeof seen[0])
                seen[n++] = module;
        }
    return n;
}

/* One frame is drawn and read; what it did and what was made for it is counted. */
static int draw(struct arm *a, struct rl_error *error)
{
    double seconds;
    struct rl_gpu_counters made = rl_gpu_scene_counters(a->gpu_scene);
    rl_gpu_scene_reset_counters(a->gpu_scene);
    int status = rl_gpu_scene_frame(a->gpu_scene, &seconds, error);
    struct rl_gpu_counters frame = rl_gpu_scene_counters(a->gpu_scene);
    a->work[DRAWS] = (double)frame.draws;
    a->work[TRIANGLES] = (double)frame.triangles;
    a->work[BYTES] = (double)(made.bytes_uploaded + made.bytes_kept);
    a->work[TEXTURES] = (double)made.textures;
    a->work[PROGRAMS] = (double)made.programs;
    a->work[MODULES] = (double)count_modules(&a->plan);
    return status == RL_OK ? rl_gpu_scene_read(a->gpu_scene, &a->image, error) : status;
}

static int prepare(struct job *job, struct arm *a)
{
    enum rl_spent_kind outer = rl_spent_on(&job->bench->spent, RL_SPENT_SETUP);
    int status = rl_plan_make(&a->plan, &a->view.scene, &a->view.settings, job->error);
    if (status == RL_OK)
        status = rl_gpu_scene_make(&a->gpu_scene, job->bench->gpu, &a->view.scene, &a->plan, job->error);
    if (status == RL_OK)
        status = rl_gpu_scene_warm_up(a->gpu_scene, job->error);
    rl_spent_on(&job->bench->spent, RL_SPENT_MEASURED);
    if (status == RL_OK)
        status = draw(a, job->error);
    rl_spent_on(&job->bench->spent, outer);
    return status;
}

/* A new arm with the view of another; NULL with job->error filled. */
static struct arm *begin_arm(struct job *job, const struct rl_view *view)
{
    if (job->n_arms == RL_TIMING_ARMS_MAX) {
        (void)rl_fail(job->error, RL_ERR_INPUT, "more than %d scenes to time, for %zu effects and methods",
                      RL_TIMING_ARMS_MAX, job->n_features);
        return NULL;
    }
    struct arm *a = &job->arm[job->n_arms++];
    return rl_view_copy(&a->view, view, job->error) == RL_OK ? a : NULL;
}

/* Culling is of every scene: without it each surface has its back drawn, too, and nothing would cost what it does in the full scene. */
static bool is_culling(const struct rl_feature *f)
{
    return f->kind == RL_FEATURE_SWITCH && f->which == RL_SWITCH_CULLING;
}

static void remove_all(struct job *job, struct rl_view *view)
{
    for (size_t i = 0; i < job->n_features; i++)
        if (!is_culling(&job->feature[i]))
            rl_view_remove(view, &job->feature[i]);
}

/* Every effect that a material does not name, and that does nothing with some values, with these. */
static void name_all(struct rl_view *view)
{
    for (size_t i = 0; i < view->scene.n_materials; i++)
        for (size_t row = 0; row < rl_n_effects; row++) {
            struct rl_material *m = &view->scene.material[i];
            const struct rl_effect *e = rl_effects[row];
            if (rl_effect_given(m, e) || e->factor)
                continue;
            rl_feature_give(m, e);
            double *value = m->effect[row].value;
            for (size_t k = 0; e->param[k].help; k++)
                for (size_t c = 0; c < (e->param[k].kind == RL_EFFECT_COLOUR ? 3 : 1); c++)
                    if (e->param[k].coefficient && !isnan(value[rl_effect_value_of(e, k) + c]))
                        value[rl_effect_value_of(e, k) + c] = 0.0;
            m->effect[row].given = !rl_effect_wanted(m, e);
        }
}

static int begin_bases(struct job *job, const struct rl_view *full)
{
    for (int i = 0; i < BASES; i++) {
        struct arm *a = begin_arm(job, full);
        if (!a)
            return RL_ERR_SYSTEM;
        if (i == BARE || i == SHINY)
            remove_all(job, &a->view);
        for (size_t k = 0; k < job->n_features && i == SHINY; k++)
            if (job->feature[k].kind == RL_FEATURE_HIGHLIGHT)
                rl_view_add(&a->view, full, &job->feature[k]);
        if (i == ZERO)
            name_all(&a->view);
    }
    return RL_OK;
}

/* The feature's scene is the full one, or, where that does not name it, one that hosts it. */
static int begin_pair(struct job *job, size_t i, const struct rl_view *full)
{
    const struct rl_feature *f = &job->feature[i];
    struct pair *p = &job->pair[i];
    struct arm *a;
    p->named = rl_feature_named(&full->scene, f);
    p->full_with = FULL;
    if (!p->named) {
        p->full_with = job->n_arms;
        if (!(a = begin_arm(job, full)))
            return RL_ERR_SYSTEM;
        rl_view_host(&a->view, f);
    }
    const struct rl_view *with = &job->arm[p->full_with].view;
    p->full_without = job->n_arms;
    if (!(a = begin_arm(job, with)))
        return RL_ERR_SYSTEM;
    rl_view_remove(&a->view, f);
    size_t base = rl_feature_needs_highlight(f) ? SHINY : BARE;
    bool culling = is_culling(f);
    p->bare_without = culling ? job->n_arms : base;
    p->bare_with = culling ? base : job->n_arms;
    if (!(a = begin_arm(job, &job->arm[base].view)))
        return RL_ERR_SYSTEM;
    if (culling)
        rl_view_remove(&a->view, f);
    else
        rl_view_add(&a->view, with, f);
    return RL_OK;
}

static int begin(struct job *job, const struct rl_scene *scene, const char *parameters)
{
    struct rl_view full;
    struct rl_settings settings;
    int status = rl_bench_settings(&settings, parameters, job->error);
    if (status != RL_OK)
        return status;
    status = rl_view_make(&full, scene, &settings, job->error);
    if (status == RL_OK)
        status = begin_bases(job, &full);
    for (size_t i = 0; i < job->n_features && status == RL_OK; i++)
        status = begin_pair(job, i, &full);
    rl_view_clear(&full);
    for (size_t i = 0; i < job->n_arms && status == RL_OK; i++)
        status = prepare(job, &job->arm[i]);
    return status;
}

static void end(struct job *job)
{
    enum rl_spent_kind outer = rl_spent_on(&job->bench->spent, RL_SPENT_SETUP);
    for (size_t i = 0; i < job->n_arms; i++) {
        rl_gpu_scene_free(job->arm[i].gpu_scene);
        rl_plan_clear(&job->arm[i].plan);
        rl_view_clear(&job->arm[i].view);
        rl_image_clear(&job->arm[i].image);
    }
    free(job->arm);
    rl_spent_on(&job->bench->spent, outer);
}

/* ---- Figures ---- */

/* How far from 0 the interval reaches. */
static double reach(struct rl_interval x)
{
    return fmax(fabs(x.low), fabs(x.high));
}

static int add_direction(struct rl_record *r, const char *direction, const struct job *job,
                         const struct rl_timing *t, size_t with, size_t without, double floor_ms)
{
    char name[RL_NAME_MAX];
    struct rl_interval ms = rl_difference_interval(t->ms[with], t->ms[without], t->n_rounds, 0.95);
    snprintf(name, sizeof name, "%s_ms", direction);
    int status = rl_record_add(r, name, ms, "ms", job->error);
    snprintf(name, sizeof name, "time_%s_clear", direction);
    if (status == RL_OK)
        status = rl_record_add_exact(r, name, ms.low > floor_ms || ms.high < -floor_ms, "1", job->error);
    for (int k = 0; k < WORKS && status == RL_OK; k++) {
        snprintf(name, sizeof name, "%s_%s", direction, work_name[k]);
        status =
            rl_record_add_exact(r, name, job->arm[with].work[k] - job->arm[without].work[k], "1", job->error);
    }
    return status;
}

/* The scene without the feature against the scene with it. */
static int add_benefit(struct rl_record *r, const struct rl_image *without, const struct rl_image *with,
                       struct rl_error *error)
{
    struct rl_metrics m;
    size_t changed = 0;
    int status = rl_metrics_compute(&m, without, with, error);
    if (status == RL_OK && m.nonfinite > 0)
        status = rl_fail(error, RL_ERR_CHECK, "%zu values are not finite", m.nonfinite);
    if (status != RL_OK)
        return status;
    for (size_t i = 0; i < (size_t)with->width * (size_t)with->height; i++) {
        const float *a = with->data + 4 * i, *b = without->data + 4 * i;
        changed += a[0] != b[0] || a[1] != b[1] || a[2] != b[2];
    }
    status = rl_record_add_exact(r, "rmse", m.rmse, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "max", m.max, "1", error);
    return status == RL_OK ? rl_record_add_exact(r, "share", (double)changed / (double)m.pixels, "1", error)
                           : status;
}

static int add_feature(struct rl_record *r, const struct job *job, size_t i, const struct rl_timing *t,
                       double floor_ms)
{
    const struct pair *p = &job->pair[i];
    int status = rl_record_add_exact(r, "row", (double)i, "1", job->error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "named", p->named, "1", job->error);
    if (status == RL_OK)
        status = add_direction(r, "added", job, t, p->bare_with, p->bare_without, floor_ms);
    if (status == RL_OK)
        status = add_direction(r, "removed", job, t, p->full_with, p->full_without, floor_ms);
    return status == RL_OK
               ? add_benefit(r, &job->arm[p->full_without].image, &job->arm[p->full_with].image, job->error)
               : status;
}

/* Bare frame and everything that is added to it, over the full frame, round by round. Of what is hosted the full frame has nothing. */
static int add_sum(struct rl_record *r, const struct job *job, const struct rl_timing *t)
{
    double *sum = calloc(t->n_rounds, sizeof *sum);
    if (!sum)
        return rl_fail_memory(job->error, "frame times");
    for (size_t k = 0; k < t->n_rounds; k++) {
        sum[k] = t->ms[BARE][k];
        for (size_t i = 0; i < job->n_features; i++)
            if (job->pair[i].named && !is_culling(&job->feature[i]))
                sum[k] += t->ms[job->pair[i].bare_with][k] - t->ms[job->pair[i].bare_without][k];
    }
    int status =
        rl_record_add(r, "time_sum", rl_ratio_interval(sum, t->ms[FULL], t->n_rounds, 0.95), "1", job->error);
    free(sum);
    return status;
}

static int add_all(struct rl_record *r, const struct job *job, const struct rl_timing *t, double floor_ms)
{
    double more = 0.0;
    for (int k = 0; k < WORKS; k++)
        more += fabs(job->arm[ZERO].work[k] - job->arm[FULL].work[k]);
    int status =
        rl_record_add(r, "full_ms", rl_interval_from_0(rl_median_interval(t->ms[FULL], t->n_rounds, 0.95)),
                      "ms", job->error);
    if (status == RL_OK)
        status = rl_record_add(r, "bare_ms",
                               rl_interval_from_0(rl_median_interval(t->ms[BARE], t->n_rounds, 0.95)), "ms",
                               job->error);
    if (status == RL_OK)
        status = rl_record_add(r, "floor_ms", (struct rl_interval){floor_ms, floor_ms, floor_ms}, "ms",
                               job->error);
    if (status == RL_OK)
        status =
            rl_record_add(r, "time_zero",
                          rl_interval_from_0(rl_ratio_interval(t->ms[ZERO], t->ms[FULL], t->n_rounds, 0.95)),
                          "1", job->error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "zero_work", more, "1", job->error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "frames", (double)t->n_rounds, "1", job->error);
    if (status == RL_OK)
        status = add_sum(r, job, t);
    return status == RL_OK ? rl_record_series_add(r, "frame_ms", t->ms[FULL], t->n_rounds, job->error)
                           : status;
}

/* ---- Measuring ---- */

static int frame(void *user, double *seconds, struct rl_error *error)
{
    const struct arm *a = user;
    return rl_gpu_scene_frame(a->gpu_scene, seconds, error);
}

static int time_arms(struct rl_timing *timing, struct job *job, int rounds)
{
    struct rl_timing_arm timed[RL_TIMING_ARMS_MAX];
    struct rl_timing_options options = RL_TIMING_DEFAULT;
    for (size_t i = 0; i < job->n_arms; i++)
        timed[i] = (struct rl_timing_arm){"a scene of the study effects", frame, &job->arm[i]};
    options.min_rounds = rounds;
    options.max_rounds = 2 * rounds;
    options.max_seconds = 0.25 * rounds;
    enum rl_spent_kind outer = rl_spent_on(&job->bench->spent, RL_SPENT_MEASURED);
    int status = rl_timing_run(timing, timed, job->n_arms, &options, &job->bench->quiet, job->error);
    rl_spent_on(&job->bench->spent, outer);
    return status;
}

int rl_effects_fits(const struct rl_scene *scene, struct rl_error *error)
{
    if (scene->n_lights + scene->n_sources > 0)
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "%s: found no light, expected at least one", scene->path);
}

int rl_effects_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                       const struct rl_scene *scene, struct rl_error *error)
{
    struct job job = {.bench = bench, .error = error};
    struct rl_timing timing = {0};
    job.n_features = rl_features_list(job.feature);
    if (n != job.n_features + 1)
        return rl_fail(error, RL_ERR_INPUT,
                       "a group of %zu cases, expected one each of %zu features and one more", n,
                       job.n_features);
    job.arm = calloc(RL_TIMING_ARMS_MAX, sizeof *job.arm);
    if (!job.arm)
        return rl_fail_memory(error, "scenes");
    int status = begin(&job, scene, records[0].parameters);
    if (status == RL_OK)
        status = time_arms(&timing, &job, (int)rl_parameter_number(records[0].parameters, "rounds"));
    double floor_ms = 0.0;
    if (status == RL_OK) {
        floor_ms = reach(rl_difference_interval(timing.ms[AGAIN], timing.ms[FULL], timing.n_rounds, 0.95));
        status = add_all(&records[0], &job, &timing, floor_ms);
    }
    for (size_t i = 0; i < job.n_features && status == RL_OK; i++)
        status = add_feature(&records[1 + i], &job, i, &timing, floor_ms);
    rl_timing_clear(&timing);
    end(&job);
    return status;
}
