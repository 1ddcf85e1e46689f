/* Sets up scenes on the GPU as cases ask (see bench.h). */
#include "studies/bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/method.h"
#include "results/record.h"

static bool ask_owner(void *user)
{
    return rl_progress_cancelled(user);
}

static void tell_owner(void *user, const char *text)
{
    rl_progress_note(user, text);
}

int rl_bench_open(struct rl_bench *bench, const char *backend, int threads, const char *cache,
                  const struct rl_progress *progress, struct rl_error *error)
{
    *bench = (struct rl_bench){.threads = threads, .cache = cache};
    rl_spent_begin(&bench->spent, RL_SPENT_SETUP);
    /* The callbacks' `user` is not const, but it is only asked and told. */
    bench->quiet = (struct rl_progress){.cancelled = ask_owner, .note = tell_owner, .user = (void *)progress};
    int status = rl_gpu_open(&bench->gpu, backend, error);
    if (status != RL_OK)
        return status;
    const struct rl_gpu_info *info = rl_gpu_describe(bench->gpu);
    rl_provenance_fill(&bench->provenance, threads, info->backend, info->renderer, info->version);
    /* Mesa's own knob for the software renderer: times with it are not comparable with times without. */
    const char *mesa_threads = getenv("LP_NUM_THREADS");
    size_t used = strlen(bench->provenance.renderer);
    if (mesa_threads)
        snprintf(bench->provenance.renderer + used, sizeof bench->provenance.renderer - used,
                 ", LP_NUM_THREADS=%.8s", mesa_threads);
    rl_spent_on(&bench->spent, RL_SPENT_HARNESS);
    return RL_OK;
}

void rl_bench_close(struct rl_bench *bench)
{
    rl_image_clear(&bench->reference[RL_LIGHT_FROM_POINT]);
    rl_image_clear(&bench->reference[RL_LIGHT_FROM_OBJECT]);
    rl_gpu_close(bench->gpu);
    *bench = (struct rl_bench){0};
}

static int take_method(struct rl_settings *settings, const char *name, struct rl_error *error)
{
    if (strcmp(name, "none") == 0)
        return RL_OK;
    const struct rl_method *method = rl_method_find(name);
    if (!method)
        return rl_fail(error, RL_ERR_INPUT, "method=%s: there is no such method", name);
    settings->method = method->name;
    return RL_OK;
}

static int take_integer(int *value, const char *parameters, const char *key, struct rl_error *error)
{
    double x = rl_parameter_number(parameters, key);
    if (isnan(x))
        return RL_OK;
    if (x != floor(x) || fabs(x) > 1e9)
        return rl_fail(error, RL_ERR_INPUT, "%s=%g: expected a whole number", key, x);
    *value = (int)x;
    return RL_OK;
}

static int take_switch(bool *on, const char *parameters, const char *key, struct rl_error *error)
{
    char text[RL_NAME_MAX];
    if (!rl_parameter(parameters, key, text, sizeof text))
        return RL_OK;
    *on = strcmp(text, "on") == 0;
    if (!*on && strcmp(text, "off") != 0)
        return rl_fail(error, RL_ERR_INPUT, "%s=%s: expected on or off", key, text);
    return RL_OK;
}

int rl_bench_settings(struct rl_settings *settings, const char *parameters, struct rl_error *error)
{
    *settings = RL_SETTINGS_DEFAULT;
    char text[RL_NAME_MAX];
    int status = RL_OK;
    if (rl_parameter(parameters, "method", text, sizeof text))
        status = take_method(settings, text, error);
    if (status == RL_OK && rl_parameter(parameters, "normal_bits", text, sizeof text))
        status = rl_parse_normal_bits(&settings->normal_bits, text, "normal_bits", error);
    if (status == RL_OK && rl_parameter(parameters, "env_format", text, sizeof text))
        status = rl_parse_texel_format(&settings->env_format, text, "env_format", error);
    if (status == RL_OK && rl_parameter(parameters, "frame", text, sizeof text))
        status = rl_parse_frame(&settings->frame, text, "frame", error);
    if (status == RL_OK && rl_parameter(parameters, "interpolation", text, sizeof text))
        status = rl_parse_interpolation(&settings->interpolation, text, "interpolation", error);
    if (status == RL_OK && rl_parameter(parameters, "margin", text, sizeof text))
        status = rl_parse_margin(settings, text, "margin", error);
    const struct {
        const char *key;
        int *value;
    } integer[] = {
        {"samples", &settings->samples},   {"normal_size", &settings->normal_size},
        {"env_size", &settings->env_size}, {"width", &settings->width},
        {"height", &settings->height},     {"depth_bits", &settings->depth_bits},
    };
    for (size_t i = 0; i < sizeof integer / sizeof integer[0] && status == RL_OK; i++)
        status = take_integer(integer[i].value, parameters, integer[i].key, error);
    if (status == RL_OK)
        status = take_switch(&settings->culling, parameters, "culling", error);
    if (status == RL_OK)
        status = take_switch(&settings->reversed_depth, parameters, "reversed_depth", error);
    double rr = rl_parameter_number(parameters, "rr");
    if (!isnan(rr))
        settings->rr = rr;
    double tolerance = rl_parameter_number(parameters, "tolerance");
    if (!isnan(tolerance))
        settings->tolerance = tolerance;
    return status == RL_OK ? rl_settings_check(settings, error) : status;
}

/* The caller's scene with materials of its own, so that their highlights can be taken away. */
static int copy_scene(struct rl_bench_scene *set, const struct rl_scene *scene, const char *parameters,
                      struct rl_error *error)
{
    set->scene = *scene;
    set->scene.material = malloc(scene->n_materials * sizeof *scene->material);
    if (!set->scene.material)
        return rl_fail_memory(error, "a scene's materials");
    memcpy(set->scene.material, scene->material, scene->n_materials * sizeof *scene->material);
    if (rl_parameters_match(parameters, "method=none"))
        for (size_t i = 0; i < scene->n_materials; i++)
            set->scene.material[i].method = NULL;
    return RL_OK;
}

static int make_scene(struct rl_bench_scene **out, struct rl_bench *bench, const struct rl_scene *scene,
                      const char *parameters, uint64_t seed, struct rl_error *error)
{
    *out = NULL;
    struct rl_bench_scene *set = calloc(1, sizeof *set);
    if (!set) {
        rl_error_set(error, RL_ERR_SYSTEM, "out of memory for a scene");
        return RL_ERR_SYSTEM;
    }
    set->bench = bench;
    struct rl_settings settings;
    int status = rl_bench_settings(&settings, parameters, error);
    settings.seed = seed;
    if (status == RL_OK)
        status = copy_scene(set, scene, parameters, error);
    if (status == RL_OK)
        status = rl_plan_make(&set->plan, &set->scene, &settings, error);
    if (status == RL_OK)
        status = rl_gpu_scene_make(&set->gpu_scene, bench->gpu, &set->scene, &set->plan, error);
    if (status == RL_OK)
        status = rl_gpu_scene_warm_up(set->gpu_scene, error);
    if (status != RL_OK) {
        rl_bench_scene_free(set);
        return status;
    }
    *out = set;
    return RL_OK;
}

int rl_bench_scene_make(struct rl_bench_scene **out, struct rl_bench *bench, const struct rl_scene *scene,
                        const char *parameters, uint64_t seed, struct rl_error *error)
{
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_SETUP);
    int status = make_scene(out, bench, scene, parameters, seed, error);
    rl_spent_on(&bench->spent, outer);
    return status;
}

void rl_bench_scene_free(struct rl_bench_scene *set)
{
    if (!set)
        return;
    enum rl_spent_kind outer = rl_spent_on(&set->bench->spent, RL_SPENT_SETUP);
    rl_gpu_scene_free(set->gpu_scene);
    rl_plan_clear(&set->plan);
    free(set->scene.material);
    rl_spent_on(&set->bench->spent, outer);
    free(set);
}

int rl_bench_draw(struct rl_image *image, struct rl_bench *bench, struct rl_bench_scene *set,
                  struct rl_error *error)
{
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    double seconds = 0.0;
    int status = rl_gpu_scene_frame(set->gpu_scene, &seconds, error);
    if (status == RL_OK)
        status = rl_gpu_scene_read(set->gpu_scene, image, error);
    rl_spent_on(&bench->spent, outer);
    return status;
}

int rl_bench_picture(struct rl_image *image, struct rl_bench *bench, const struct rl_scene *scene,
                     const char *parameters, uint64_t seed, struct rl_error *error)
{
    struct rl_bench_scene *set;
    int status = rl_bench_scene_make(&set, bench, scene, parameters, seed, error);
    if (status == RL_OK)
        status = rl_bench_draw(image, bench, set, error);
    rl_bench_scene_free(set);
    return status;
}
