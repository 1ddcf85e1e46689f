/* `render`: one image of a scene, by the GPU pipeline or the CPU renderer, whichever the methods need. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/machine.h"
#include "base/simd.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/output.h"
#include "cli/render_options.h"
#include "gpu/gpu.h"
#include "image/image.h"
#include "reference/renderer.h"
#include "results/stamp.h"
#include "scene/plan.h"

static const struct rl_option options_render[] = {
    {'o', "output", "FILE", "where to write: .exr (32-bit float) or .png (8-bit sRGB); needed"},
    {0, "max-seconds", "S",
     "reference: the best image in S seconds of drawing, with its error; the first, loosest pass is always "
     "completed"},
    {0, "errors", "FILE", "reference: where to write how far off each value of the image may be: .exr"},
    {0},
};

/* What was asked for beside the settings. */
struct request {
    const char *path, *errors_path;
    const char *backend;
    int threads;
    double max_seconds; /* 0: no limit */
};

struct drawing {
    struct rl_image image, errors;
    bool has_accuracy;
    struct rl_stamp_accuracy accuracy;
    char renderer[160];
    int threads;
    double seconds;
};

static int draw_on_gpu(struct drawing *d, const struct rl_scene *scene, const struct rl_plan *plan,
                       const struct request *request, struct rl_error *error)
{
    struct rl_gpu *gpu = NULL;
    struct rl_gpu_scene *gs = NULL;
    struct rl_console console;
    const struct rl_progress *progress = rl_console_begin(&console);
    int status = rl_gpu_open(&gpu, request->backend, error);
    if (status == RL_OK)
        status = rl_gpu_scene_make(&gs, gpu, scene, plan, error);
    /* The first frame compiles the shaders; the second is what a frame takes. A frame itself cannot be interrupted. */
    for (int frame = 0; frame < 2 && status == RL_OK; frame++) {
        status = rl_gpu_scene_frame(gs, &d->seconds, error);
        if (status == RL_OK && rl_progress_cancelled(progress))
            status = rl_fail(error, RL_ERR_CANCELLED, "interrupted");
    }
    rl_console_end(&console);
    if (status == RL_OK)
        status = rl_gpu_scene_read(gs, &d->image, error);
    if (status == RL_OK) {
        const struct rl_gpu_info *info = rl_gpu_describe(gpu);
        d->threads = request->threads > 0 ? request->threads : rl_machine_threads();
        snprintf(d->renderer, sizeof d->renderer, "%s on %s", info->renderer, info->backend);
        fprintf(stderr, "render: %.2f ms a frame, %s\n", 1e3 * d->seconds, d->renderer);
    }
    rl_gpu_scene_free(gs);
    rl_gpu_close(gpu);
    return status;
}

static void tell(const struct rl_render_stats *stats, const struct request *request, double tolerance)
{
    fprintf(stderr, "render: %.2f s, %zu foreground pixels", stats->seconds, stats->foreground);
    if (stats->evaluations > 0)
        fprintf(stderr, ", %zu lines, largest error estimate %.2g", stats->evaluations, stats->worst_error);
    if (stats->texels > 0)
        fprintf(stderr, ", %.3g texel-normals, %.3g a second (%s)", (double)stats->texels,
                (double)stats->texels / stats->seconds, rl_simd_name(rl_simd_best()));
    fputc('\n', stderr);
    if (request->max_seconds > 0.0)
        fprintf(stderr,
                "render: of %g s: %d of %d passes completed, %zu of %zu pixels within the tolerance %g, RMS "
                "error %.2g, mean %.2g\n",
                request->max_seconds, stats->passes_completed, stats->passes,
                stats->foreground - stats->unconverged, stats->foreground, tolerance, stats->rms_error,
                stats->mean_error);
    else if (stats->unconverged > 0)
        fprintf(stderr, "render: warning: %zu pixels stayed above the tolerance\n", stats->unconverged);
    if (request->max_seconds > 0.0 && stats->first_seconds > request->max_seconds)
        fprintf(stderr,
                "render: warning: the first pass, which is always completed, took longer than the %g s\n",
                request->max_seconds);
}

static int draw_on_cpu(struct drawing *d, const struct rl_scene *scene, const struct rl_plan *plan,
                       const struct request *request, struct rl_error *error)
{
    struct rl_console console;
    struct rl_render_stats stats;
    const struct rl_render_limits limits = {.threads = request->threads,
                                            .max_seconds = request->max_seconds,
                                            .errors = request->errors_path ? &d->errors : NULL};
    const struct rl_progress *progress = rl_console_begin(&console);
    int status = rl_reference_render_within(&d->image, &stats, scene, plan, &limits, progress, error);
    rl_console_end(&console);
    if (status != RL_OK)
        return status;
    char embree[64];
    rl_reference_library(embree);
    snprintf(d->renderer, sizeof d->renderer, "CPU, Embree %s", embree);
    d->seconds = stats.seconds;
    d->threads = stats.threads;
    /* Of the other methods of the CPU no error is known. */
    d->has_accuracy = stats.evaluations > 0;
    d->accuracy = (struct rl_stamp_accuracy){
        .foreground = stats.foreground,
        .within = stats.foreground - stats.unconverged,
        .worst_error = stats.worst_error,
        .rms_error = stats.rms_error,
        .mean_error = stats.mean_error,
        .max_seconds = request->max_seconds,
    };
    tell(&stats, request, plan->settings.tolerance);
    return RL_OK;
}

static int write_image(struct rl_image *image, const struct drawing *d, const struct rl_scene *scene,
                       const struct rl_plan *plan, const char *path, struct rl_error *error)
{
    struct rl_write_report report = {0};
    const char *dot = strrchr(path, '.');
    if (dot && strcmp(dot, ".png") == 0)
        rl_image_clipping(&report, image);
    int status = rl_stamp_image(image, scene, plan, d->renderer, d->threads, d->seconds, error);
    if (status == RL_OK && d->has_accuracy)
        status = rl_stamp_accuracy(image, &d->accuracy, error);
    if (status == RL_OK && report.clipped > 0)
        status = rl_image_set_number(image, "roughlight:clipped", (double)report.clipped, error);
    if (status == RL_OK)
        status = rl_image_write(image, path, &report, error);
    if (status == RL_OK && report.clipped > 0)
        fprintf(
            stderr,
            "render: warning: %zu values outside [0, 1] were clipped in %s: %zu above 1, %zu below 0, %zu "
            "without coverage; .exr keeps them\n",
            report.clipped, path, report.above, report.below, report.uncovered);
    if (status == RL_OK && report.clipped > 0 && scene->white > 0.0)
        fprintf(stderr, "render: 1 is camera.white, %g cd/m2; more would leave room for what is brighter\n",
                scene->white);
    return status;
}

/* Before any long work: that the file's kind is known and its folder can be written. */
static int check_output(const char *path, struct rl_error *error)
{
    if (!path)
        return rl_fail(error, RL_ERR_INPUT,
                       "--output is missing, expected a file name ending in .exr or .png");
    const char *dot = strrchr(path, '.');
    if (!dot || (strcmp(dot, ".exr") != 0 && strcmp(dot, ".png") != 0))
        return rl_fail(error, RL_ERR_INPUT,
                       "--output: found '%s', expected a file name ending in .exr or .png", path);
    return rl_output_file_check(path, error);
}

/* Errors go down to 1e-12: no PNG can show them. */
static int check_errors_output(const struct request *request, struct rl_error *error)
{
    const char *dot = request->errors_path ? strrchr(request->errors_path, '.') : NULL;
    if (!request->errors_path)
        return RL_OK;
    if (!dot || strcmp(dot, ".exr") != 0)
        return rl_fail(error, RL_ERR_INPUT, "--errors: found '%s', expected a file name ending in .exr",
                       request->errors_path);
    if (strcmp(request->errors_path, request->path) == 0)
        return rl_fail(error, RL_ERR_INPUT, "--errors: found '%s', expected another file than --output",
                       request->errors_path);
    return check_output(request->errors_path, error);
}

static int take_request(struct request *request, const struct rl_arguments *a, struct rl_error *error)
{
    *request = (struct request){.path = rl_argument(a, "output"),
                                .errors_path = rl_argument(a, "errors"),
                                .backend = rl_argument_backend(a)};
    int status = rl_argument_threads(a, &request->threads, error);
    if (status == RL_OK)
        status = rl_argument_number(a, "max-seconds", 1e-3, 1e6, &request->max_seconds, error);
    if (status == RL_OK)
        status = check_output(request->path, error);
    if (status == RL_OK)
        status = check_errors_output(request, error);
    return status;
}

/* What only a method with a stated error can do. */
static int check_method(const struct rl_plan *plan, const struct request *request, struct rl_error *error)
{
    if (!request->errors_path && !(request->max_seconds > 0.0))
        return RL_OK;
    const char *option = request->errors_path ? "errors" : "max-seconds";
    if (!plan->on_cpu)
        return rl_fail(error, RL_ERR_INPUT, "--%s: found a method of the GPU, expected --method reference",
                       option);
    for (size_t i = 0; i < plan->n_materials; i++) {
        const struct rl_method *method = plan->material[i].method;
        if (method && !rl_method_integrates(method))
            return rl_fail(error, RL_ERR_INPUT,
                           "--%s: found the method %s, which states no error, expected --method reference",
                           option, method->name);
    }
    return RL_OK;
}

static int render(struct rl_scene *scene, const struct rl_arguments *a, struct rl_error *error)
{
    struct rl_settings settings = scene->settings;
    struct rl_plan plan = {0};
    struct drawing drawing = {0};
    struct request request;
    int status = rl_argument_settings(&settings, a, error);
    if (status == RL_OK)
        status = rl_argument_check_effect(a, scene, &settings, error);
    if (status == RL_OK)
        status = take_request(&request, a, error);
    if (status == RL_OK && settings.width > 0)
        rl_scene_fit_planes(scene, settings.width, settings.height);
    if (status == RL_OK)
        status = rl_plan_make(&plan, scene, &settings, error);
    if (status == RL_OK)
        status = check_method(&plan, &request, error);
    if (status == RL_OK && plan.on_cpu)
        status = draw_on_cpu(&drawing, scene, &plan, &request, error);
    else if (status == RL_OK)
        status = draw_on_gpu(&drawing, scene, &plan, &request, error);
    if (status == RL_OK)
        status = write_image(&drawing.image, &drawing, scene, &plan, request.path, error);
    if (status == RL_OK && request.errors_path)
        status = write_image(&drawing.errors, &drawing, scene, &plan, request.errors_path, error);
    rl_image_clear(&drawing.image);
    rl_image_clear(&drawing.errors);
    rl_plan_clear(&plan);
    return status;
}

static int run(const struct rl_arguments *a, struct rl_error *error)
{
    struct rl_scene scene;
    int status = rl_scene_load(&scene, a->positional[0], error);
    if (status != RL_OK)
        return rl_exit_of(status);
    status = render(&scene, a, error);
    rl_scene_clear(&scene);
    return rl_exit_of(status);
}

const struct rl_command rl_command_render = {
    .name = "render",
    .arguments = "SCENE -o FILE [options]",
    .min_positionals = 1,
    .max_positionals = 1,
    .summary = "render a scene to an EXR or PNG",
    .description =
        "Renders a scene file on the GPU, or on the CPU if the method is `reference` or `exhaustive` or "
        "shadows "
        "are on. What\n"
        "an option does not say, the scene file's `render` block says, else the default in brackets. The "
        "image carries its "
        "provenance\n"
        "as attributes (iinfo -v shows them).\n\n"
        "  roughlight render studies/scenes/teapot-star.yaml --method random --samples 4 -o a.exr\n"
        "  roughlight render studies/scenes/teapot-star.yaml --method reference -o r.exr\n"
        "  roughlight render studies/scenes/teapot-star.yaml --method reference --max-seconds 3 --errors "
        "e.exr -o "
        "b.exr\n"
        "  roughlight compare a.exr r.exr",
    .options = (const struct rl_option *const[]){options_render, rl_options_render, rl_options_machine, NULL},
    .run = run,
};
