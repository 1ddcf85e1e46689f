/* Pictures for the page, with what each is wrong by (see gallery.h). */
#include "studies/gallery.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/files.h"
#include "measure/metrics.h"
#include "results/html.h"
#include "results/plot.h"
#include "results/stamp.h"

static const struct shown {
    const char *file, *title, *method;
    int samples;
    bool
        sets_scale; /* whether its error counts when the scale is chosen: plain is wrong by so much that others would vanish */
} methods[] = {
    {"plain", "plain", "plain", 0, false},
    {"regular-13", "regular, 13 normals", "regular", 13, true},
    {"random-4", "random, 4 normals", "random", 4, true},
};

enum { METHODS = sizeof methods / sizeof methods[0] };

/* All pictures of one R_r. */
struct row {
    const struct rl_gallery *gallery;
    double rr, scale;
    const struct rl_image *reference;
    struct rl_image image[METHODS], error[METHODS];
    struct rl_metrics metrics[METHODS];
    size_t clipped[METHODS], reference_clipped;
};

static void path_of(char path[PATH_MAX], const struct row *row, const char *kind, const char *name,
                    const char *ending)
{
    snprintf(path, PATH_MAX, "%s/%s-rr%g-%s.%s", row->gallery->folder, kind, row->rr, name, ending);
}

/* As EXR, whole, and as PNG, where values above 1 do not fit: how many is told. */
static int write_both(const struct rl_image *image, const struct row *row, const char *name, size_t *clipped,
                      struct rl_error *error)
{
    char path[PATH_MAX];
    struct rl_write_report report = {0};
    path_of(path, row, "picture", name, "exr");
    int status = rl_image_write(image, path, &report, error);
    path_of(path, row, "picture", name, "png");
    if (status == RL_OK)
        status = rl_image_write(image, path, &report, error);
    *clipped = report.clipped;
    return status;
}

static void parameters_of(char text[256], const struct row *row, const char *method, int samples)
{
    const struct rl_gallery *g = row->gallery;
    snprintf(text, 256, "method=%s samples=%d rr=%g width=%d height=%d tolerance=%g", method, samples,
             row->rr, g->width, g->height, g->tolerance);
}

static int render(struct row *row, int m, struct rl_bench *bench, struct rl_error *error)
{
    char parameters[256];
    parameters_of(parameters, row, methods[m].method, methods[m].samples);
    struct rl_bench_scene *set;
    double seconds = 0.0;
    int status = rl_bench_scene_make(&set, bench, row->gallery->scene, parameters, 1, error);
    if (status == RL_OK)
        status = rl_gpu_scene_frame(set->gpu_scene, &seconds, error);
    if (status == RL_OK)
        status = rl_gpu_scene_read(set->gpu_scene, &row->image[m], error);
    if (status == RL_OK)
        status = rl_stamp_image(&row->image[m], row->gallery->scene, &set->plan, bench->provenance.renderer,
                                bench->provenance.threads, seconds, error);
    rl_bench_scene_free(set);
    if (status == RL_OK)
        status = write_both(&row->image[m], row, methods[m].file, &row->clipped[m], error);
    if (status == RL_OK)
        status = rl_metrics_compute(&row->metrics[m], &row->image[m], row->reference, error);
    if (status == RL_OK)
        status = rl_error_image(&row->error[m], &row->image[m], row->reference, error);
    return status;
}

static int compare_floats(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* The absolute error that one pixel in a hundred with any error exceeds, rounded up to 1, 2 or 5 times a power of ten: one
 * scale for a whole row. */
static int choose_scale(struct row *row, struct rl_error *error)
{
    size_t pixels = (size_t)row->gallery->width * (size_t)row->gallery->height, n = 0;
    float *value = malloc(METHODS * pixels * sizeof *value);
    if (!value)
        return rl_fail_memory(error, "an error scale");
    for (int m = 0; m < METHODS; m++)
        for (size_t i = 0; methods[m].sets_scale && i < pixels; i++)
            if (row->error[m].data[i] != 0.0f)
                value[n++] = fabsf(row->error[m].data[i]);
    qsort(value, n, sizeof *value, compare_floats);
    double percentile = n ? value[(size_t)(0.99 * (double)(n - 1))] : 1.0;
    free(value);
    double decade = pow(10.0, floor(log10(percentile)));
    double lead = percentile / decade;
    row->scale = decade * (lead <= 1.0 ? 1.0 : lead <= 2.0 ? 2.0 : lead <= 5.0 ? 5.0 : 10.0);
    return RL_OK;
}

static int plot_error(const struct row *row, int m, struct rl_error *error)
{
    char matrix[PATH_MAX], output[PATH_MAX], width[16], height[16], scale[32];
    const struct rl_image *image = &row->error[m];
    path_of(matrix, row, "error", methods[m].file, "raw");
    path_of(output, row, "error", methods[m].file, "png");
    snprintf(width, sizeof width, "%d", image->width);
    snprintf(height, sizeof height, "%d", image->height);
    snprintf(scale, sizeof scale, "%.12f", row->scale); /* gnuplot reads no exponent here */
    size_t bytes = (size_t)image->width * (size_t)image->height * sizeof *image->data;
    int status = rl_file_write(matrix, image->data, bytes, error);
    if (status != RL_OK)
        return status;
    const char *arguments[] = {matrix, output, width, height, scale, NULL};
    status = rl_plot("error.gp", arguments, error);
    unlink(matrix);
    return status;
}

static void add_picture(struct rl_buffer *page, const struct row *row, const char *file, const char *title,
                        size_t clipped)
{
    char png[160], exr[160], text[512];
    snprintf(png, sizeof png, "picture-rr%g-%s.png", row->rr, file);
    snprintf(exr, sizeof exr, "picture-rr%g-%s.exr", row->rr, file);
    char note[96] = "";
    if (clipped > 0)
        snprintf(note, sizeof note, "; %zu values above 1 are clipped in the PNG", clipped);
    snprintf(text, sizeof text, "%s%s.", title, note);
    const struct rl_html_link links[] = {{"EXR", exr}, {NULL, NULL}};
    rl_html_figure(page, png, title, text, links);
}

static void add_row(struct rl_buffer *page, const struct row *row)
{
    char text[512], source[160];
    snprintf(text, sizeof text, "R_r = %g", row->rr);
    rl_html_element(page, "h3", text);
    rl_buffer_add(page, "<div class=\"row\">\n");
    for (int m = 0; m < METHODS; m++)
        add_picture(page, row, methods[m].file, methods[m].title, row->clipped[m]);
    add_picture(page, row, "reference", "reference", row->reference_clipped);
    rl_buffer_add(page, "</div>\n<div class=\"row\">\n");
    for (int m = 0; m < METHODS; m++) {
        const struct rl_metrics *k = &row->metrics[m];
        snprintf(source, sizeof source, "error-rr%g-%s.png", row->rr, methods[m].file);
        snprintf(text, sizeof text, "Error of %s: RMSE %.3g, bias %+.2g, largest %.3g.", methods[m].title,
                 k->rmse, k->bias, k->max);
        rl_html_figure(page, source, text, text, NULL);
    }
    /* The fourth place of the row says how to read the other three. */
    snprintf(
        text, sizeof text,
        "Picture minus reference, mean of the colours: blue is too dark, orange too bright, white is right. "
        "Colours end at ±%g. However rough, a faint sharp image of the light remains: per solid angle the "
        "distribution is D/|sin delta|, unbounded at the mirror direction.",
        row->scale);
    rl_html_element(page, "p", text);
    rl_buffer_add(page, "</div>\n");
}

static int make_row(struct rl_buffer *page, struct row *row, struct rl_bench *bench, struct rl_error *error)
{
    char parameters[256];
    parameters_of(parameters, row, "reference", 0);
    int status = rl_bench_reference(&row->reference, bench, row->gallery->scene, parameters,
                                    RL_LIGHT_FROM_POINT, error);
    if (status == RL_OK)
        status = write_both(row->reference, row, "reference", &row->reference_clipped, error);
    for (int m = 0; m < METHODS && status == RL_OK; m++)
        status = render(row, m, bench, error);
    if (status == RL_OK)
        status = choose_scale(row, error);
    for (int m = 0; m < METHODS && status == RL_OK; m++)
        status = plot_error(row, m, error);
    if (status == RL_OK)
        add_row(page, row);
    for (int m = 0; m < METHODS; m++) {
        rl_image_clear(&row->image[m]);
        rl_image_clear(&row->error[m]);
    }
    return status;
}

int rl_gallery_make(struct rl_buffer *page, const struct rl_gallery *gallery, struct rl_bench *bench,
                    const struct rl_progress *progress, struct rl_error *error)
{
    char text[512];
    rl_buffer_add(page, "<h2 id=\"pictures\">Pictures</h2>\n");
    snprintf(text, sizeof text,
             "%.60s at %d x %d pixels with the paper's settings: 8-bit normal map, environment map of 256 "
             "texels a face.",
             gallery->scene_name, gallery->width, gallery->height);
    rl_html_element(page, "p", text);
    int status = RL_OK;
    for (size_t i = 0; i < gallery->n_rr && status == RL_OK; i++) {
        if (rl_progress_cancelled(progress))
            return rl_fail(error, RL_ERR_CANCELLED, "interrupted while the pictures were rendered");
        struct row row = {.gallery = gallery, .rr = gallery->rr[i]};
        status = make_row(page, &row, bench, error);
        rl_progress_update(progress, "pictures", i + 1, gallery->n_rr);
    }
    return status;
}
