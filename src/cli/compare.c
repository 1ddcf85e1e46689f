/* `compare`: error metrics of an image against a reference, one row. */
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "cli/command.h"
#include "cli/output.h"
#include "image/image.h"
#include "measure/metrics.h"

static const struct rl_option options_compare[] = {
    {0, "max-rmse", "E", "fail (exit 1) if the RMSE is above E"},
    {0, "max-mismatched", "N", "fail (exit 1) if more than N pixels are covered in one image only"},
    {'o', "error-image", "FILE", "also write the signed error per pixel (.exr)"},
    {0},
};

static void print_row(const struct rl_metrics *m, enum rl_output format)
{
    static const char *const columns[] = {"rmse",    "mae",       "max",    "bias",       "relmse",
                                          "psnr_db", "nonfinite", "pixels", "mismatched", NULL};
    struct rl_rows rows;
    rl_rows_begin(&rows, format, columns);
    rl_rows_number(&rows, m->rmse);
    rl_rows_number(&rows, m->mae);
    rl_rows_number(&rows, m->max);
    rl_rows_number(&rows, m->bias);
    rl_rows_number(&rows, m->relmse);
    rl_rows_number(&rows, m->psnr);
    rl_rows_integer(&rows, (long long)m->nonfinite);
    rl_rows_integer(&rows, (long long)m->pixels);
    rl_rows_integer(&rows, (long long)m->mismatched);
    rl_rows_end(&rows);
}

static int write_error_image(const char *path, const struct rl_image *image, const struct rl_image *reference,
                             struct rl_error *error)
{
    struct rl_image difference = {0};
    struct rl_write_report report;
    int status = rl_error_image(&difference, image, reference, error);
    if (status == RL_OK)
        status = rl_image_write(&difference, path, &report, error);
    rl_image_clear(&difference);
    return status;
}

/* What was asked for beside the row. */
struct request {
    double most_rmse;
    long long most_mismatched;
    const char *error_image;
    enum rl_output format;
};

/* Under whatever name. */
static bool is_same_file(const char *a, const char *b)
{
    struct stat of_a, of_b;
    return stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev &&
           of_a.st_ino == of_b.st_ino;
}

/* A signed error has no place in a PNG. */
static int check_error_image(const char *path, const struct rl_arguments *a, struct rl_error *error)
{
    const char *dot = strrchr(path, '.');
    if (!dot || strcmp(dot, ".exr") != 0)
        return rl_fail(error, RL_ERR_INPUT, "--error-image: found '%s', expected a file name ending in .exr",
                       path);
    if (is_same_file(path, a->positional[0]) || is_same_file(path, a->positional[1]))
        return rl_fail(error, RL_ERR_INPUT,
                       "--error-image: found '%s', expected another file than the images", path);
    return rl_output_file_check(path, error);
}

static int take_request(struct request *request, const struct rl_arguments *a, struct rl_error *error)
{
    *request = (struct request){INFINITY, LLONG_MAX, rl_argument(a, "error-image"), RL_OUTPUT_TSV};
    int status = rl_argument_number(a, "max-rmse", 0.0, 1e300, &request->most_rmse, error);
    if (status == RL_OK)
        status = rl_argument_integer(a, "max-mismatched", 0, LLONG_MAX, &request->most_mismatched, error);
    if (status == RL_OK)
        status = rl_argument_output(a, &request->format, error);
    if (status == RL_OK && request->error_image)
        status = check_error_image(request->error_image, a, error);
    return status;
}

/* The cd/m^2 that 1 stands for; 0: the picture does not say. PNG holds numbers as text. */
static double white_of(const struct rl_image *image)
{
    const struct rl_attribute *a = rl_image_attribute(image, "whiteLuminance");
    double white = a ? a->number : 0.0;
    if (a && a->string && !rl_text_number(a->string, &white))
        return 0.0;
    return white;
}

/* To the seven digits that an EXR file keeps. */
static int check_white(const struct rl_image *image, const struct rl_image *reference, struct rl_error *error)
{
    double a = white_of(image), b = white_of(reference);
    if (!(a > 0.0) || !(b > 0.0) || fabs(a - b) <= 1e-6 * b)
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "found 1 to be %g and %g cd/m2 (whiteLuminance), expected one white",
                   a, b);
}

static int compare(const struct rl_image *image, const struct rl_image *reference,
                   const struct request *request, struct rl_error *error)
{
    struct rl_metrics metrics;
    int status = check_white(image, reference, error);
    if (status == RL_OK)
        status = rl_metrics_compute(&metrics, image, reference, error);
    if (status != RL_OK)
        return status;
    print_row(&metrics, request->format);
    if (metrics.nonfinite > 0)
        return rl_fail(error, RL_ERR_CHECK, "%zu values are not finite", metrics.nonfinite);
    if (request->error_image &&
        (status = write_error_image(request->error_image, image, reference, error)) != RL_OK)
        return status;
    if (metrics.rmse > request->most_rmse)
        return rl_fail(error, RL_ERR_CHECK, "RMSE %g is above %g", metrics.rmse, request->most_rmse);
    if ((long long)metrics.mismatched > request->most_mismatched)
        return rl_fail(error, RL_ERR_CHECK, "%zu pixels are covered in one image only, more than %lld",
                       metrics.mismatched, request->most_mismatched);
    return RL_OK;
}

/* What would otherwise hide in the figures: one line a file, if it has any of it. */
static void tell_census(const char *path, const struct rl_image *image)
{
    struct rl_image_census c;
    const struct rl_attribute *clipped = rl_image_attribute(image, "roughlight:clipped");
    rl_image_census(&c, image);
    if (c.nonfinite + c.negative + c.large > 0)
        fprintf(
            stderr,
            "compare: %s: of %zu values %zu are NaN or infinite, %zu negative (least %g), %zu above 65504, "
            "the largest half (most %g)\n",
            path, c.values, c.nonfinite, c.negative, c.least, c.large, c.most);
    if (clipped && clipped->string)
        fprintf(stderr, "compare: %s: %s of its values were clipped when it was written\n", path,
                clipped->string);
}

static int run(const struct rl_arguments *a, struct rl_error *error)
{
    struct rl_image image = {0};
    struct rl_image reference = {0};
    struct request request;
    int status = take_request(&request, a, error);
    if (status == RL_OK)
        status = rl_image_read(&image, a->positional[0], error);
    if (status == RL_OK)
        status = rl_image_read(&reference, a->positional[1], error);
    if (status == RL_OK) {
        tell_census(a->positional[0], &image);
        tell_census(a->positional[1], &reference);
        status = compare(&image, &reference, &request, error);
        if (status == RL_ERR_INPUT) /* sizes, channels or coverage: say of which files */
            rl_fail_prefix(error, "%s against %s", a->positional[0], a->positional[1]);
    }
    rl_image_clear(&image);
    rl_image_clear(&reference);
    return rl_exit_of(status);
}

const struct rl_command rl_command_compare = {
    .name = "compare",
    .arguments = "IMAGE REFERENCE [options]",
    .min_positionals = 2,
    .max_positionals = 2,
    .summary = "error metrics of an image against a reference",
    .description =
        "Prints one row of metrics of e = IMAGE - REFERENCE over the foreground (where both have "
        "alpha >= 1/2):\n\n"
        "  rmse  sqrt(mean e^2)     mae   mean |e|      max  largest |e|     bias  mean e "
        "(brightness gained or lost)\n"
        "  relmse  mean(e^2/(|reference| + 0.01)^2)     psnr_db  peak max(1, largest reference)\n"
        "  nonfinite  NaN or infinite values: any fails the comparison (exit 1)\n"
        "  pixels  compared         mismatched  covered in one image only, left out\n\n"
        "Values that are NaN, infinite, negative or above the largest half are counted on stderr, and so "
        "are\n"
        "those that a PNG by `render` says were clipped.\n\n"
        "Values are linear light; 8-bit files are decoded from sRGB first. Of photometric scenes they "
        "are\nluminance over white: pictures of two whites are refused.\n\n"
        "  roughlight compare a.exr reference.exr\n"
        "  roughlight compare a.exr reference.exr --max-rmse 0.004 || echo too far off",
    .options = (const struct rl_option *const[]){options_compare, rl_options_format, NULL},
    .run = run,
};
