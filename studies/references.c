/* Reference images: computed once for each scene, size, R_r and tolerance, and kept as EXR by the hash of what determines them
 * (see bench.h). */
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/files.h"
#include "base/hash.h"
#include "reference/renderer.h"
#include "results/record.h"
#include "results/stamp.h"
#include "studies/bench.h"
#include "studies/scene_check.h"

/* What a reference is known by: everything that it depends on, as text, and the text's hash, which names the file. The file holds the
 * text itself, so that it is known by more than its name. */
struct key {
    char text[384];
    uint64_t hash;
};

static void make_key(struct key *key, const struct rl_bench *bench, const struct rl_scene *scene,
                     const struct rl_settings *s)
{
    char program[RL_HASH_TEXT];
    rl_provenance_program(&bench->provenance, program);
    int n =
        snprintf(key->text, sizeof key->text,
                 "%016" PRIx64
                 " %s %dx%d rr=%.17g tolerance=%.17g attenuation=%d frame=%s from=%d shadows=%d culling=%d "
                 "interpolation=%d",
                 scene->hash, program, s->width, s->height, s->rr, s->tolerance, s->attenuation,
                 rl_frame_name(s->frame), (int)s->light_from, s->shadows, s->culling, s->interpolation);
    key->hash = rl_hash_bytes(RL_HASH_START, key->text, (size_t)n);
}

static int compute(struct rl_image *image, struct rl_bench *bench, const struct rl_scene *scene,
                   const struct rl_settings *settings, struct rl_error *error)
{
    struct rl_plan plan;
    int status = rl_plan_make(&plan, scene, settings, error);
    if (status != RL_OK)
        return status;
    struct rl_render_stats stats = {0};
    status = rl_reference_render(image, &stats, scene, &plan, bench->threads, &bench->quiet, error);
    /* What is not true must not be taken for truth. */
    if (status == RL_OK && stats.unconverged > 0)
        status = rl_fail(error, RL_ERR_CHECK,
                         "the reference: %zu pixels stayed above the tolerance %g, largest error %g",
                         stats.unconverged, settings->tolerance, stats.worst_error);
    char library[64], renderer[96];
    rl_reference_library(library);
    snprintf(renderer, sizeof renderer, "CPU, %s", library);
    if (status == RL_OK)
        status = rl_stamp_image(image, scene, &plan, renderer, stats.threads, stats.seconds, error);
    if (status == RL_OK)
        status = rl_image_set_number(image, "roughlight:worst_error", stats.worst_error, error);
    rl_plan_clear(&plan);
    return status;
}

/* Reads what the cache has under that name; RL_ERR_CHECK: it is another reference, or none. Nothing is in `image` then. */
static int take_cached(struct rl_image *image, const char *path, const struct rl_settings *settings,
                       const struct key *key, struct rl_error *error)
{
    int status = rl_image_read(image, path, error);
    if (status != RL_OK)
        return status;
    struct rl_image_census census;
    rl_image_census(&census, image);
    if (census.nonfinite > 0)
        status = rl_fail(error, RL_ERR_CHECK, "%s: %zu values are NaN or infinite", path, census.nonfinite);
    else if (!rl_stamp_has_key(image, key->text))
        status = rl_fail(error, RL_ERR_CHECK, "%s: not the reference of that name", path);
    else if (image->width != settings->width || image->height != settings->height)
        status = rl_fail(error, RL_ERR_CHECK, "%s: found %dx%d pixels, expected %dx%d", path, image->width,
                         image->height, settings->width, settings->height);
    if (status != RL_OK)
        rl_image_clear(image);
    return status;
}

/* The image that becomes the bench's: read if the cache has a good one, else computed and put there. */
static int find(struct rl_image *image, struct rl_bench *bench, const struct rl_scene *scene,
                const struct rl_settings *settings, const struct key *key, struct rl_error *error)
{
    char name[RL_HASH_TEXT], path[PATH_MAX];
    rl_hash_text(name, key->hash);
    snprintf(path, sizeof path, "%s/reference-%s.exr", bench->cache, name);
    if (access(path, R_OK) == 0) {
        struct rl_error why = {0};
        char line[sizeof why.message + 32];
        if (take_cached(image, path, settings, key, &why) == RL_OK)
            return RL_OK;
        snprintf(line, sizeof line, "%s; computed again", why.message);
        rl_progress_note(&bench->quiet, line);
    }
    int status = rl_directory_create(bench->cache, error);
    if (status == RL_OK)
        status = compute(image, bench, scene, settings, error);
    if (status == RL_OK)
        status = rl_foreground_check(image, error);
    if (status == RL_OK)
        status = rl_stamp_key(image, key->text, error);
    struct rl_write_report report;
    if (status == RL_OK)
        status = rl_image_write(image, path, &report, error);
    return status;
}

int rl_bench_reference(const struct rl_image **out, struct rl_bench *bench, const struct rl_scene *scene,
                       const char *parameters, enum rl_light_from from, struct rl_error *error)
{
    struct rl_settings settings;
    int status = rl_bench_settings(&settings, parameters, error);
    if (status != RL_OK)
        return status;
    settings.method = "reference";
    settings.samples = 0;
    settings.light_from = from;
    /* The printed frame is one of the approximations that are measured, so the truth does without, unless it is asked about itself. */
    if (!rl_parameters_match(parameters, "method=reference"))
        settings.frame = RL_FRAME_ORTHONORMAL;
    if (settings.width == 0 || settings.height == 0) {
        settings.width = scene->width;
        settings.height = scene->height;
    }
    struct key key = {0};
    make_key(&key, bench, scene, &settings);
    if (bench->reference_key[from] != key.hash) {
        rl_image_clear(&bench->reference[from]);
        bench->reference_key[from] = 0;
        struct rl_image image = {0};
        enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_REFERENCE);
        status = find(&image, bench, scene, &settings, &key, error);
        rl_spent_on(&bench->spent, outer);
        if (status != RL_OK) {
            rl_image_clear(&image);
            return rl_fail_prefix(error, "reference");
        }
        bench->reference[from] = image;
        bench->reference_key[from] = key.hash;
    }
    *out = &bench->reference[from];
    return RL_OK;
}
