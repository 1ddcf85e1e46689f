/* Measures the cases of the study `fps`: scenes set up, arms timed against each other, what was drawn counted (see fps.h). */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "base/hash.h"
#include "measure/statistics.h"
#include "measure/timing.h"
#include "reference/renderer.h"
#include "studies/fps.h"

enum { ARMS_MAX = RL_TIMING_ARMS_MAX };

/* Half the width of a median's interval that is wanted, relative to it. */
static const double precision_wanted = 0.02;

/* What is timed: a scene on the GPU, or one for the CPU. */
struct subject {
    struct rl_bench *bench;
    struct rl_scene made; /* the case's own scene, where it has one */
    const struct rl_scene *scene;
    struct rl_bench_scene *set;
    struct rl_plan plan; /* of the CPU */
    size_t texel_normals, foreground;
    uint64_t seed; /* of the normal maps made last */
};

int rl_fps_check(const char *parameters, struct rl_error *error)
{
    static const char *const key[] = {"objects", "roughnesses"};
    for (int i = 0; i < 2; i++) {
        double x = rl_parameter_number(parameters, key[i]);
        if (!isnan(x) && (x < 1.0 || x > RL_FPS_OBJECTS_MAX || x != floor(x)))
            return rl_fail(error, RL_ERR_INPUT, "%s=%g: expected a whole number, 1 to %d", key[i], x,
                           RL_FPS_OBJECTS_MAX);
    }
    return RL_OK;
}

static bool on_cpu(const struct rl_record *r)
{
    return rl_parameters_match(r->parameters, "method=exhaustive");
}

static int draw_frame(void *user, double *seconds, struct rl_error *error)
{
    const struct subject *s = user;
    return rl_gpu_scene_frame(s->set->gpu_scene, seconds, error);
}

static int draw_environment(void *user, double *seconds, struct rl_error *error)
{
    const struct subject *s = user;
    return rl_gpu_scene_environment(s->set->gpu_scene, seconds, error);
}

/* Each time with a seed that nothing else has: what was made with it before is kept, and would be found again in no time. */
static int bake_normal_maps(void *user, double *seconds, struct rl_error *error)
{
    struct subject *s = user;
    double start = rl_clock_seconds();
    int status = rl_gpu_scene_reseed(s->set->gpu_scene, ++s->seed, error);
    *seconds = rl_clock_seconds() - start;
    return status;
}

static int draw_exhaustive(void *user, double *seconds, struct rl_error *error)
{
    struct subject *s = user;
    struct rl_image image;
    struct rl_render_stats stats;
    int status =
        rl_reference_render(&image, &stats, s->scene, &s->plan, s->bench->threads, &s->bench->quiet, error);
    if (status != RL_OK)
        return status;
    rl_image_clear(&image);
    *seconds = stats.seconds;
    s->texel_normals = stats.texels;
    s->foreground = stats.foreground;
    return RL_OK;
}

static int prepare(struct subject *s, const struct rl_record *r, struct rl_bench *bench,
                   const struct rl_scene *scene, struct rl_error *error)
{
    *s = (struct subject){.bench = bench, .scene = scene};
    s->seed = rl_hash_bytes(rl_hash_bytes(RL_HASH_START, r->scene_hash, strlen(r->scene_hash)), r->parameters,
                            strlen(r->parameters));
    double objects = rl_parameter_number(r->parameters, "objects");
    double roughnesses = rl_parameter_number(r->parameters, "roughnesses");
    int status = rl_fps_check(r->parameters, error);
    if (status == RL_OK && (!isnan(objects) || !isnan(roughnesses))) {
        int k = isnan(roughnesses) ? 1 : (int)roughnesses;
        int n = !isnan(objects) ? (int)objects : k > RL_FPS_OBJECTS ? k : RL_FPS_OBJECTS;
        status = rl_fps_scene_make(&s->made, scene, n, k, error);
        s->scene = &s->made;
    }
    if (status != RL_OK || !on_cpu(r))
        return status == RL_OK ? rl_bench_scene_make(&s->set, bench, s->scene, r->parameters, 1, error)
                               : status;
    struct rl_settings settings;
    status = rl_bench_settings(&settings, r->parameters, error);
    return status == RL_OK ? rl_plan_make(&s->plan, s->scene, &settings, error) : status;
}

static void clear(struct subject *s)
{
    rl_bench_scene_free(s->set);
    rl_plan_clear(&s->plan);
    rl_fps_scene_free(&s->made);
}

static double paper_fps(const struct rl_record *r)
{
    static const struct {
        const char *pattern;
        double fps;
    } paper[] = {{"series=table1 arm=plain", RL_PAPER_PLAIN_FPS},
                 {"series=table1 arm=regular-13", RL_PAPER_REGULAR_FPS},
                 {"series=table1 arm=random-4", RL_PAPER_RANDOM_FPS}};
    for (size_t i = 0; i < sizeof paper / sizeof paper[0]; i++)
        if (rl_parameters_match(r->parameters, paper[i].pattern))
            return paper[i].fps;
    return NAN;
}

/* An arm's time, its rate, how sure they are, and both against other arms, paired by round. */
static int add_times(struct rl_record *records, size_t n, const struct rl_timing *t, size_t i,
                     struct rl_error *error)
{
    struct rl_record *r = &records[i];
    struct rl_interval ms = rl_interval_from_0(rl_median_interval(t->ms[i], t->n_rounds, 0.95));
    struct rl_interval fps = {1000.0 / ms.value, 1000.0 / ms.high, 1000.0 / ms.low};
    double half = ms.value > 0.0 ? fmax(ms.high - ms.value, ms.value - ms.low) / ms.value : INFINITY;
    long baseline = rl_fps_arm(records, n, r, "none"), random = rl_fps_arm(records, n, r, "random-4");
    int status = rl_record_add(r, "frame_ms", ms, "ms", error);
    if (status == RL_OK)
        status = rl_record_add(r, "fps", fps, "1/s", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "frames", (double)t->n_rounds, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "time_precision", half, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "time_precise", half <= precision_wanted, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "time_capped", !(half <= precision_wanted), "1", error);
    if (status == RL_OK && baseline >= 0)
        status =
            rl_record_add(r, "above_baseline_ms",
                          rl_difference_interval(t->ms[i], t->ms[baseline], t->n_rounds, 0.95), "ms", error);
    if (status == RL_OK && random >= 0)
        status = rl_record_add(
            r, "time_to_random4",
            rl_interval_from_0(rl_ratio_interval(t->ms[i], t->ms[random], t->n_rounds, 0.95)), "1", error);
    if (status == RL_OK && !isnan(paper_fps(r)))
        status = rl_record_add_exact(r, "paper_fps", paper_fps(r), "1/s", error);
    return status == RL_OK ? rl_record_series_add(r, "frame_ms", t->ms[i], t->n_rounds, error) : status;
}

/* Pixels that the highlight pass drew. */
static int add_drawn(struct rl_record *r, const struct subject *s, struct rl_error *error)
{
    struct rl_image drawn;
    int status = rl_gpu_scene_read_drawn(s->set->gpu_scene, &drawn, error);
    if (status != RL_OK)
        return status;
    double sum = 0.0;
    for (size_t i = 0; i < (size_t)drawn.width * (size_t)drawn.height; i++)
        sum += drawn.data[i];
    rl_image_clear(&drawn);
    return rl_record_add_exact(r, "drawn_px", sum, "px", error);
}

/* How much there was to do. */
static int add_work(struct rl_record *r, const struct subject *s, struct rl_error *error)
{
    int status = RL_OK;
    if (on_cpu(r)) {
        status = rl_record_add_exact(r, "texel_normals", (double)s->texel_normals, "1", error);
        return status == RL_OK ? rl_record_add_exact(r, "drawn_px", (double)s->foreground, "px", error)
                               : status;
    }
    status = rl_record_add_exact(r, "env_maps", (double)s->set->plan.n_environments, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "normal_maps", (double)s->set->plan.n_normal_maps, "1", error);
    bool sampled = rl_parameters_match(r->parameters, "method=random") ||
                   rl_parameters_match(r->parameters, "method=regular");
    bool frame = !rl_parameters_match(r->parameters, "arm=environment") &&
                 !rl_parameters_match(r->parameters, "arm=normal-maps");
    return status == RL_OK && sampled && frame ? add_drawn(r, s, error) : status;
}

static int time_arms(struct rl_record *records, struct subject *subject, size_t n, struct rl_bench *bench,
                     struct rl_error *error)
{
    struct rl_timing_arm arm[ARMS_MAX];
    for (size_t i = 0; i < n; i++) {
        const char *p = records[i].parameters;
        bool environment = rl_parameters_match(p, "arm=environment");
        bool maps = rl_parameters_match(p, "arm=normal-maps");
        arm[i] = (struct rl_timing_arm){p,
                                        on_cpu(&records[i]) ? draw_exhaustive
                                        : environment       ? draw_environment
                                        : maps              ? bake_normal_maps
                                                            : draw_frame,
                                        &subject[i]};
    }
    double rounds = rl_parameter_number(records[0].parameters, "rounds");
    struct rl_timing_options options = {.warm_up = 1,
                                        .min_rounds = (int)rounds,
                                        .max_rounds = 3 * (int)rounds,
                                        .precision = precision_wanted,
                                        .max_seconds = rl_parameter_number(records[0].parameters, "seconds"),
                                        .seed = 1};
    struct rl_timing timing;
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    int status = rl_timing_run(&timing, arm, n, &options, &bench->quiet, error);
    rl_spent_on(&bench->spent, outer);
    if (status != RL_OK)
        return status;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        status = add_times(records, n, &timing, i, error);
        if (status == RL_OK)
            status = add_work(&records[i], &subject[i], error);
    }
    rl_timing_clear(&timing);
    return status;
}

int rl_fps_measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                   struct rl_error *error)
{
    if (n > ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, expected at most %d", n, ARMS_MAX);
    struct subject subject[ARMS_MAX];
    int status = RL_OK;
    size_t prepared = 0;
    while (prepared < n && status == RL_OK) {
        status = prepare(&subject[prepared], &records[prepared], bench, scene, error);
        prepared++;
    }
    if (status == RL_OK)
        status = time_arms(records, subject, n, bench, error);
    for (size_t i = 0; i < prepared; i++)
        clear(&subject[i]);
    return status;
}
