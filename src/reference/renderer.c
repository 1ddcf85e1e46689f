/* The CPU renderer: tiles of pixels on all cores (see renderer.h). A pixel depends on nothing but itself, so the image is the
 * same for every number of threads. */
#include "reference/renderer.h"

#include <embree3/rtcore.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/machine.h"
#include "reference/integrator.h"
#include "reference/texel_map.h"
#include "reference/visible.h"

enum { TILE_PX = 16 };

/* A material as the loop over pixels wants it: everything that does not depend on the pixel is worked out. */
struct shader {
    const struct rl_plan_material *plan;
    const struct rl_material *material;
    struct rl_ellipsoid ellipsoid;
    double effect_params[RL_PLAN_EFFECTS_MAX][RL_EFFECT_PARAMS][4];
    double method_params[RL_EFFECT_PARAMS][4];
    bool integrates; /* the highlight is the integral itself */
};

struct job {
    const struct rl_scene *scene;
    const struct rl_plan *plan;
    struct rl_image *image;
    struct rl_visible *visible;
    struct rl_light_set *lights;
    struct rl_point_light *point_light;
    struct shader *shader;             /* per plan material */
    struct rl_texel_map **environment; /* per object; NULL: its method needs none */
    struct rl_integrate_options options;
};

/* What one thread found; added up at the end. */
struct tally {
    size_t foreground, unconverged, evaluations, texels, nonfinite;
    double worst_error;
};

static void make_shader(struct shader *s, const struct rl_scene *scene, const struct rl_plan_material *m)
{
    s->plan = m;
    s->material = &scene->material[m->material];
    s->ellipsoid = rl_ellipsoid_make(m->rr);
    for (size_t i = 0; i < m->n_effects; i++)
        m->effect[i]->pack(s->material, s->effect_params[i]);
    s->integrates = m->method && !m->method->shade;
    if (m->method && m->method->pack)
        m->method->pack(&s->ellipsoid, s->method_params);
}

static void job_clear(struct job *job)
{
    rl_visible_free(job->visible);
    rl_light_set_free(job->lights);
    free(job->point_light);
    free(job->shader);
    for (size_t i = 0; i < job->scene->n_objects && job->environment; i++)
        rl_texel_map_free(job->environment[i]);
    free(job->environment);
}

static int make_environments(struct job *job, struct rl_error *error)
{
    const struct rl_plan *plan = job->plan;
    int status = RL_OK;
    for (size_t i = 0; i < job->scene->n_objects && status == RL_OK; i++)
        if (plan->environment[i] >= 0)
            status = rl_texel_map_make(&job->environment[i], job->lights, job->scene->object[i].centre,
                                       plan->settings.env_size, error);
    return status;
}

static int job_make(struct job *job, const struct rl_scene *scene, const struct rl_plan *plan,
                    struct rl_image *image, struct rl_error *error)
{
    *job = (struct job){.scene = scene, .plan = plan, .image = image};
    job->options = (struct rl_integrate_options){
        .attenuation = plan->settings.attenuation,
        .frame = plan->settings.frame,
        .tolerance = plan->settings.tolerance,
        .simd = rl_simd_best(),
    };
    job->shader = calloc(plan->n_materials + 1, sizeof *job->shader);
    job->point_light = calloc(scene->n_lights + 1, sizeof *job->point_light);
    job->environment = calloc(scene->n_objects + 1, sizeof(struct rl_texel_map *));
    if (!job->shader || !job->point_light || !job->environment) {
        job_clear(job);
        return rl_fail_memory(error, "the CPU renderer");
    }
    for (size_t i = 0; i < plan->n_materials; i++)
        make_shader(&job->shader[i], scene, &plan->material[i]);
    for (size_t i = 0; i < scene->n_lights; i++)
        job->point_light[i] = rl_light_as_point(&scene->light[i]);
    int status = rl_light_set_make(&job->lights, scene->light, scene->n_lights, error);
    if (status == RL_OK)
        status = rl_visible_make(&job->visible, scene, error);
    if (status == RL_OK)
        status = make_environments(job, error);
    if (status != RL_OK)
        job_clear(job);
    return status;
}

static const struct shader *shader_of(const struct job *job, size_t object)
{
    const struct rl_plan_material *m = rl_plan_of_object(job->plan, job->scene, object);
    return &job->shader[m - job->plan->material];
}

/* L_o times k_s, added to rgb. */
static void add_highlight(double rgb[3], const struct job *job, const struct shader *s,
                          const struct rl_surface *surface, size_t object, struct tally *tally)
{
    double L_o[3] = {0.0, 0.0, 0.0};
    if (!s->integrates) {
        s->plan->method->shade(surface, job->point_light, job->scene->n_lights,
                               (double(*)[4])s->method_params, L_o);
    } else if (job->environment[object]) {
        tally->texels += rl_texel_map_integrate(L_o, job->environment[object], surface, &s->ellipsoid,
                                                job->options.attenuation);
    } else {
        struct rl_surface seen = *surface;
        if (job->plan->settings.light_from == RL_LIGHT_FROM_OBJECT)
            seen.P = job->scene->object[object].centre;
        struct rl_estimate estimate;
        rl_integrate_lines(&estimate, &seen, &s->ellipsoid, job->lights, &job->options);
        tally->evaluations += estimate.evaluations;
        tally->unconverged += !estimate.converged;
        for (int c = 0; c < 3; c++) {
            L_o[c] = estimate.value[c];
            tally->worst_error = fmax(tally->worst_error, estimate.error[c]);
        }
    }
    for (int c = 0; c < 3; c++)
        rgb[c] += s->material->specular[c] * L_o[c];
}

static void draw_pixel(const struct job *job, int x, int y, struct tally *tally)
{
    struct rl_surface surface;
    size_t object;
    rl_vec3 direction = rl_camera_ray(&job->scene->camera, job->image->width, job->image->height, x, y);
    if (!rl_visible_point(&surface, &object, job->visible, direction))
        return;
    const struct shader *s = shader_of(job, object);
    double rgb[3] = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < s->plan->n_effects; i++) {
        double part[3];
        s->plan->effect[i]->shade(&surface, job->point_light, job->scene->n_lights,
                                  (double(*)[4])s->effect_params[i], part);
        for (int c = 0; c < 3; c++)
            rgb[c] += part[c];
    }
    /* A normal that faces away from the eye, which interpolation makes at silhouettes, has no highlight. */
    if (s->plan->method && v3_dot(surface.N, surface.V) > 0.0)
        add_highlight(rgb, job, s, &surface, object, tally);
    float *pixel = rl_image_pixel(job->image, x, y);
    for (int c = 0; c < 3; c++) {
        pixel[c] = (float)rgb[c];
        tally->nonfinite += !isfinite(pixel[c]);
    }
    pixel[3] = 1.0f;
    tally->foreground++;
}

static void draw_tile(const struct job *job, int tile, struct tally *tally)
{
    int across = (job->image->width + TILE_PX - 1) / TILE_PX;
    int x0 = tile % across * TILE_PX;
    int y0 = tile / across * TILE_PX;
    for (int y = y0; y < y0 + TILE_PX && y < job->image->height; y++)
        for (int x = x0; x < x0 + TILE_PX && x < job->image->width; x++)
            draw_pixel(job, x, y, tally);
}

static struct tally draw_tiles(const struct job *job, int threads, const struct rl_progress *progress)
{
    int across = (job->image->width + TILE_PX - 1) / TILE_PX;
    int down = (job->image->height + TILE_PX - 1) / TILE_PX;
    int n_tiles = across * down;
    size_t done = 0;
    struct tally total = {0};
#pragma omp parallel num_threads(threads)
    {
        struct tally mine = {0};
#pragma omp for schedule(dynamic)
        for (int tile = 0; tile < n_tiles; tile++) {
            if (rl_progress_cancelled(progress))
                continue;
            draw_tile(job, tile, &mine);
#pragma omp critical(rl_render_progress)
            rl_progress_update(progress, "reference: tiles", ++done, (size_t)n_tiles);
        }
#pragma omp critical(rl_render_tally)
        {
            total.foreground += mine.foreground;
            total.unconverged += mine.unconverged;
            total.evaluations += mine.evaluations;
            total.texels += mine.texels;
            total.nonfinite += mine.nonfinite;
            total.worst_error = fmax(total.worst_error, mine.worst_error);
        }
    }
    return total;
}

int rl_reference_render(struct rl_image *image, struct rl_render_stats *stats, const struct rl_scene *scene,
                        const struct rl_plan *plan, int threads, const struct rl_progress *progress,
                        struct rl_error *error)
{
    double start = rl_clock_seconds();
    struct job job;
    int status = rl_image_allocate(image, plan->settings.width, plan->settings.height, 4, error);
    if (status == RL_OK)
        status = job_make(&job, scene, plan, image, error);
    if (status != RL_OK) {
        rl_image_clear(image);
        return status;
    }
    if (threads <= 0)
        threads = rl_machine_threads();
    struct tally tally = draw_tiles(&job, threads, progress);
    job_clear(&job);
    *stats = (struct rl_render_stats){
        .seconds = rl_clock_seconds() - start,
        .foreground = tally.foreground,
        .unconverged = tally.unconverged,
        .worst_error = tally.worst_error,
        .evaluations = tally.evaluations,
        .texels = tally.texels,
        .threads = threads,
    };
    if (rl_progress_cancelled(progress))
        status = rl_fail(error, RL_ERR_CANCELLED, "interrupted");
    else if (tally.nonfinite > 0)
        status = rl_fail(error, RL_ERR_CHECK, "%zu values of the image are not finite", tally.nonfinite);
    if (status != RL_OK)
        rl_image_clear(image);
    return status;
}

void rl_reference_library(char version[64])
{
    snprintf(version, 64, "%s", RTC_VERSION_STRING);
}
