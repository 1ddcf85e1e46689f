/* The panels of the contact sheet (see fur.h). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "image/srgb.h"
#include "studies/fur.h"
#include "studies/scene_check.h"

/* A panel's pixel is the mean of FINER^2 of its picture's: outlines would be steps. */
enum { PANELS_MAX = 32, FINER = 4 };

/* What stands behind an object: dark rims and bright ones show against it. */
static const double backdrop = 0.12;

static int ascending(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* One for all panels: of their brightest channels 199 in 200 stay within full scale. */
static int choose_exposure(double *exposure, const struct rl_image *image, size_t n, struct rl_error *error)
{
    size_t pixels = (size_t)image[0].width * (size_t)image[0].height, found = 0;
    float *brightest = malloc(n * pixels * sizeof *brightest);
    if (!brightest)
        return rl_fail_memory(error, "an exposure");
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < pixels; k++) {
            const float *p = image[i].data + 4 * k;
            if (p[3] > 0.0f)
                brightest[found++] = fmaxf(p[0], fmaxf(p[1], p[2]));
        }
    qsort(brightest, found, sizeof *brightest, ascending);
    double top = found > 0 ? brightest[(size_t)(0.995 * (double)(found - 1))] : 1.0;
    *exposure = top > 0.0 ? 1.0 / top : 1.0;
    free(brightest);
    return RL_OK;
}

/* Coverage is a channel as others are: colours are multiplied by it. */
static int shrink(struct rl_image *small, const struct rl_image *large, struct rl_error *error)
{
    int status = rl_image_allocate(small, large->width / FINER, large->height / FINER, 4, error);
    for (int y = 0; status == RL_OK && y < small->height * FINER; y++)
        for (int x = 0; x < small->width * FINER; x++)
            for (int c = 0; c < 4; c++)
                rl_image_pixel(small, x / FINER, y / FINER)[c] +=
                    rl_image_pixel(large, x, y)[c] / (float)(FINER * FINER);
    return status;
}

static int draw(struct rl_image *panel, struct rl_bench *bench, const struct rl_scene *scene,
                const char *parameters, struct rl_error *error)
{
    char size[64];
    struct rl_image large = {0};
    snprintf(size, sizeof size, "width=%g height=%g", FINER * rl_parameter_number(parameters, "width"),
             FINER * rl_parameter_number(parameters, "height"));
    int status = rl_fur_picture(&large, bench, scene, parameters, size, error);
    if (status == RL_OK)
        status = rl_foreground_check(&large, error);
    if (status == RL_OK)
        status = shrink(panel, &large, error);
    rl_image_clear(&large);
    return status;
}

static double eight_bits(double linear)
{
    return round(255.0 * rl_srgb_encode(fmin(fmax(linear, 0.0), 1.0)));
}

static int add(struct rl_record *r, const char *name, double value, struct rl_error *error)
{
    return rl_record_add_exact(r, name, value, "1", error);
}

/* A value holds a pixel of the upper half and that as far down in the lower one, so that either half is one picture to draw. */
static int add_panel(struct rl_record *r, const struct rl_image *image, double exposure,
                     struct rl_error *error)
{
    size_t pixels = (size_t)image->width * (size_t)image->height, foreground = 0, above = 0, below = 0;
    size_t half = (size_t)image->width * (size_t)((image->height + 1) / 2);
    double *packed = calloc(half, sizeof *packed);
    if (!packed)
        return rl_fail_memory(error, "a panel");
    for (size_t i = 0; i < pixels; i++) {
        const float *p = image->data + 4 * i;
        double colour = 0.0;
        bool over = false, under = false;
        for (int c = 0; c < 3; c++) {
            double x = exposure * p[c];
            over = over || x > 1.0;
            under = under || x < 0.0;
            colour = 256.0 * colour + eight_bits(x + (1.0 - p[3]) * backdrop);
        }
        foreground += p[3] > 0.0f;
        above += p[3] > 0.0f && over;
        below += p[3] > 0.0f && under;
        packed[i % half] += i >= half ? ldexp(colour, 24) : colour;
    }
    int status = rl_record_series_add(r, "pixels", packed, half, error);
    free(packed);
    if (status == RL_OK)
        status = add(r, "exposure", exposure, error);
    if (status == RL_OK)
        status = add(r, "clipped", (double)above / (double)foreground, error);
    return status == RL_OK ? add(r, "negative", (double)below / (double)foreground, error) : status;
}

int rl_fur_measure_sheet(struct rl_record *records, size_t n, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error)
{
    struct rl_image image[PANELS_MAX] = {0};
    double exposure = 1.0;
    int status = n <= PANELS_MAX ? RL_OK
                                 : rl_fail(error, RL_ERR_INPUT, "a sheet of %zu panels, at most %d make one",
                                           n, PANELS_MAX);
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = draw(&image[i], bench, scene, records[i].parameters, error);
    if (status == RL_OK)
        status = choose_exposure(&exposure, image, n, error);
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = add_panel(&records[i], &image[i], exposure, error);
    for (size_t i = 0; i < PANELS_MAX; i++)
        rl_image_clear(&image[i]);
    return status;
}
