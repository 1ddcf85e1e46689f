/* The CPU renderer: tiles of pixels on all cores (see renderer.h). A pixel depends on nothing but itself, so the image is the
 * same for every number of threads. */
#include "reference/renderer.h"

#include <embree3/rtcore.h>
#include <float.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "base/machine.h"
#include "reference/render_job.h"

enum { TILE_PX = 16 };

/* Once over all pixels that are not done. */
struct pass {
    struct rl_integrate_options options;
    bool last;
    double deadline;    /* on the monotonic clock; INFINITY: none */
    size_t done, total; /* tiles, of all passes */
};

/* What was evaluated. */
struct count {
    size_t lines, texels;
};

/* The integral where other objects may hide the lights. A round body's silhouette has more corners than can all be told as breaks:
 * past a number of lines the error is left as it is. */
static void integrate_shadowed(struct rl_estimate *estimate, const struct rl_render_job *job,
                               const struct rl_render_shader *s, const struct rl_surface *surface,
                               size_t object, const struct pass *pass)
{
    enum { LINES_MOST = 2000 };
    struct rl_integrate_options options = pass->options;
    struct rl_occluders_view *view = &job->view[omp_get_thread_num()];
    switch (rl_occluders_see(view, job->occluders, surface, object, options.attenuation)) {
    case RL_OCCLUDERS_SOME:
        options.occlusion = &view->occlusion;
        options.max_evaluations = LINES_MOST;
        break;
    case RL_OCCLUDERS_NO_MEMORY:
        *estimate = (struct rl_estimate){.error = {INFINITY, INFINITY, INFINITY}};
        return;
    case RL_OCCLUDERS_NONE:
        break;
    }
    rl_integrate_lines(estimate, surface, &s->ellipsoid, job->lights, &options);
}

/* L_o, its error where the integral gives one, and whether that is within the tolerance. */
static void highlight(struct rl_estimate *estimate, struct count *count, const struct rl_render_job *job,
                      const struct rl_render_shader *s, const struct rl_surface *surface, size_t object,
                      const struct pass *pass)
{
    *estimate = (struct rl_estimate){.converged = true};
    /* A normal that faces away from the eye, which interpolation makes at silhouettes, has no highlight. */
    if (!s->plan->method || !(v3_dot(surface->N, surface->V) > 0.0))
        return;
    if (s->integrates && !job->plan->object[object].highlit)
        return;
    if (!s->integrates) {
        s->plan->method->shade(surface, job->seen.point, job->seen.n_points, (double(*)[4])s->method_params,
                               estimate->value);
        return;
    }
    const int environment = job->plan->environment[object];
    if (environment >= 0) {
        count->texels += rl_texel_map_integrate(estimate->value, job->environment[environment], surface,
                                                &s->ellipsoid, pass->options.attenuation);
        return;
    }
    struct rl_surface seen = *surface;
    if (job->plan->settings.light_from == RL_LIGHT_FROM_OBJECT)
        seen.P = job->scene->object[object].centre;
    if (job->occluders)
        integrate_shadowed(estimate, job, s, &seen, object, pass);
    else
        rl_integrate_lines(estimate, &seen, &s->ellipsoid, job->lights, &pass->options);
    count->lines += estimate->evaluations;
}

/* In single precision. What is beyond it, near a light, is stored as its largest number, so that no pixel is infinite: then a value is a bound
 * of what there is, and so is its error. NaN stays. */
static float stored(double value)
{
    if (fabs(value) > (double)FLT_MAX)
        return copysignf(FLT_MAX, (float)value);
    return (float)value;
}

/* Writes a value, and how far off it may be: rounding to float is off by half a unit in the last place of either. */
static void set_pixel(const struct rl_render_job *job, int x, int y, const double rgb[3],
                      const double error[3])
{
    float *pixel = rl_image_pixel(job->image, x, y);
    for (int c = 0; c < 3; c++)
        pixel[c] = stored(rgb[c]);
    pixel[3] = 1.0f;
    if (!job->errors)
        return;
    float *off = rl_image_pixel(job->errors, x, y);
    for (int c = 0; c < 3; c++)
        off[c] = stored((1.0 + FLT_EPSILON) * (error[c] + 0.5 * FLT_EPSILON * fabs(rgb[c])));
    off[3] = 1.0f;
}

/* The sum of the effects at the pixel's point, or what its triangle has of it; and how far off shadows may have it. */
static void shade(double rgb[3], double error[3], const struct rl_render_job *job,
                  const struct rl_render_shader *s, const struct rl_surface *surface,
                  const struct rl_visible_hit *hit)
{
    if (s->plan->interpolation != RL_INTERPOLATION_PHONG) {
        const struct rl_interpolated *interpolated = &job->interpolated[hit->object];
        rl_interpolated_at(rgb, interpolated, hit->triangle, hit->weight, hit->from_behind);
        memcpy(error, interpolated->error, sizeof interpolated->error);
        return;
    }
    struct rl_lights lights = job->seen;
    if (job->shadows)
        lights.visibility =
            rl_shadows_see(&job->shadow_view[omp_get_thread_num()], job->shadows, hit->object);
    rl_effects_shade_within(s->plan->effect, s->plan->n_effects,
                            (double(*)[RL_EFFECT_PARAMS][4])s->effect_params, surface, &lights, rgb, error);
}

static void draw_pixel(const struct rl_render_job *job, struct count *count, int x, int y,
                       const struct pass *pass)
{
    struct rl_accuracy *reached = &job->reached[(size_t)y * (size_t)job->image->width + (size_t)x];
    if (reached->done)
        return;
    struct rl_surface surface;
    struct rl_visible_hit hit;
    rl_vec3 direction = rl_camera_ray(&job->scene->camera, job->image->width, job->image->height, x, y);
    if (!rl_visible_point(&surface, &hit, job->visible, direction)) {
        reached->done = true;
        return;
    }
    const struct rl_render_shader *s = rl_render_shader_of(job, hit.object);
    struct rl_estimate estimate;
    highlight(&estimate, count, job, s, &surface, hit.object, pass);
    double wanted = job->plan->settings.tolerance * job->lights->brightest;
    if (rl_accuracy_improve(reached, &estimate, wanted, pass->last)) {
        double rgb[3], error[3], factor[3];
        shade(rgb, error, job, s, &surface, &hit);
        rl_effects_factor(s->plan->effect, s->plan->n_effects,
                          (double(*)[RL_EFFECT_PARAMS][4])s->effect_params, &surface, factor);
        for (int c = 0; c < 3; c++) {
            rgb[c] += s->material->specular[c] * factor[c] * estimate.value[c];
            error[c] += s->material->specular[c] * factor[c] * estimate.error[c];
        }
        set_pixel(job, x, y, rgb, error);
    }
}

/* As far as the deadline lets it. */
static void draw_tile(const struct rl_render_job *job, struct count *count, int tile, const struct pass *pass)
{
    int across = (job->image->width + TILE_PX - 1) / TILE_PX;
    int x0 = tile % across * TILE_PX;
    int y0 = tile / across * TILE_PX;
    for (int y = y0; y < y0 + TILE_PX && y < job->image->height; y++)
        for (int x = x0; x < x0 + TILE_PX && x < job->image->width; x++) {
            if (pass->deadline < INFINITY && rl_clock_seconds() > pass->deadline)
                return;
            draw_pixel(job, count, x, y, pass);
        }
}

static int n_tiles(const struct rl_image *image)
{
    return (image->width + TILE_PX - 1) / TILE_PX * ((image->height + TILE_PX - 1) / TILE_PX);
}

static void draw_tiles(struct rl_render_stats *stats, const struct rl_render_job *job, struct pass *pass,
                       const struct rl_progress *progress)
{
    int tiles = n_tiles(job->image);
    size_t lines = 0, texels = 0;
#pragma omp parallel for schedule(dynamic) num_threads(stats->threads) reduction(+ : lines, texels)
    for (int tile = 0; tile < tiles; tile++) {
        if (rl_progress_cancelled(progress))
            continue;
        struct count count = {0};
        draw_tile(job, &count, tile, pass);
        lines += count.lines;
        texels += count.texels;
#pragma omp critical(rl_render_progress)
        rl_progress_update(progress, "reference: tiles", ++pass->done, pass->total);
    }
    stats->evaluations += lines;
    stats->texels += texels;
}

static void draw_passes(struct rl_render_stats *stats, const struct rl_render_job *job, double start,
                        double deadline, const struct rl_progress *progress)
{
    const struct rl_settings *settings = &job->plan->settings;
    double tolerance[RL_PASSES_MAX] = {settings->tolerance};
    stats->passes = deadline < INFINITY ? rl_accuracy_passes(tolerance, settings->tolerance) : 1;
    struct pass pass = {
        .options = {.attenuation = settings->attenuation, .frame = settings->frame, .simd = rl_simd_best()},
        .deadline = INFINITY,
        .total = (size_t)stats->passes * (size_t)n_tiles(job->image)};
    for (int i = 0; i < stats->passes && !rl_progress_cancelled(progress); i++) {
        if (i > 0 && rl_clock_seconds() > deadline)
            return;
        pass.options.tolerance = tolerance[i];
        pass.last = i == stats->passes - 1;
        pass.deadline = i > 0 ? deadline : INFINITY;
        draw_tiles(stats, job, &pass, progress);
        double now = rl_clock_seconds();
        stats->passes_completed += i == 0 || now <= deadline;
        if (i == 0)
            stats->first_seconds = now - start;
    }
}

static int draw(const struct rl_render_job *job, struct rl_render_stats *stats, double start, double deadline,
                const struct rl_progress *progress, struct rl_error *error)
{
    draw_passes(stats, job, start, deadline, progress);
    if (rl_progress_cancelled(progress))
        return rl_fail(error, RL_ERR_CANCELLED, "interrupted");
    struct rl_accuracy_summary summary;
    rl_accuracy_summarise(&summary, job->reached, job->image);
    if (summary.nonfinite > 0)
        return rl_fail(error, RL_ERR_CHECK, "%zu values of the image are not finite", summary.nonfinite);
    stats->foreground = summary.foreground;
    stats->unconverged = summary.foreground - summary.within;
    stats->worst_error = summary.worst_error;
    stats->rms_error = summary.rms_error;
    stats->mean_error = summary.mean_error;
    return RL_OK;
}

int rl_reference_render_within(struct rl_image *image, struct rl_render_stats *stats,
                               const struct rl_scene *scene, const struct rl_plan *plan,
                               const struct rl_render_limits *limits, const struct rl_progress *progress,
                               struct rl_error *error)
{
    double start = rl_clock_seconds();
    double deadline = limits->max_seconds > 0.0 ? start + limits->max_seconds : INFINITY;
    struct rl_render_job job = {0};
    int width = plan->settings.width, height = plan->settings.height;
    *stats =
        (struct rl_render_stats){.threads = limits->threads > 0 ? limits->threads : rl_machine_threads()};
    int status = rl_image_allocate(image, width, height, 4, error);
    if (status == RL_OK && limits->errors)
        status = rl_image_allocate(limits->errors, width, height, 4, error);
    if (status == RL_OK)
        status = rl_render_job_make(&job, scene, plan, image, limits->errors, stats->threads, error);
    if (status == RL_OK) {
        status = draw(&job, stats, start, deadline, progress, error);
        rl_render_job_clear(&job);
    }
    stats->seconds = rl_clock_seconds() - start;
    if (status != RL_OK) {
        rl_image_clear(image);
        if (limits->errors)
            rl_image_clear(limits->errors);
    }
    return status;
}

int rl_reference_render(struct rl_image *image, struct rl_render_stats *stats, const struct rl_scene *scene,
                        const struct rl_plan *plan, int threads, const struct rl_progress *progress,
                        struct rl_error *error)
{
    const struct rl_render_limits limits = {.threads = threads};
    return rl_reference_render_within(image, stats, scene, plan, &limits, progress, error);
}

void rl_reference_library(char version[64])
{
    snprintf(version, 64, "%s", RTC_VERSION_STRING);
}
