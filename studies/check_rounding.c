/* The check's cases of texel formats: how far what is stored lies from what it stands for, of values that have nothing to do with the
 * model. A bit too few doubles both figures, and so does cutting off; a bit too many halves them, which is as wrong where a study asks
 * what few bits do: they have to be the same. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "gpu/gpu.h"
#include "gpu/textures.h"
#include "methods/method.h"
#include "studies/check_parts.h"

/* 64 x 64 texels: the largest error of 16 bits is within 1 % of half a step. */
enum { SIZE = 64, TEXELS = SIZE * SIZE };

static const char *const tolerance_from =
    "4 ulp of single precision: a component is 2 t - 1, t within one in each program";
static const double tolerance = 4.0 * FLT_EPSILON;

struct errors {
    double squares, largest;
    size_t n;
};

static void add_error(struct errors *e, double stored, double exact)
{
    double error = fabs(stored - exact);
    e->squares += error * error;
    e->largest = fmax(e->largest, error);
    e->n++;
}

static void add_rows(struct rl_check_rows *rows, const struct errors *e, bool drawn)
{
    rl_check_fixed(rows, "rounding", RL_BEST_SAME, sqrt(e->squares / (double)e->n), tolerance, tolerance_from,
                   drawn);
    rl_check_fixed(rows, "rounding_max", RL_BEST_SAME, e->largest, tolerance, tolerance_from, drawn);
}

/* Normals of the half sphere about x, evenly: x in equal steps, azimuths by the golden angle. */
static struct rl_microfacet spiral(const struct rl_ellipsoid *e, uint64_t seed, uint64_t index)
{
    (void)e, (void)seed;
    double x = ((double)index + 0.5) / TEXELS, radius = sqrt(1.0 - x * x);
    double azimuth = fmod((double)index * 0.6180339887498949, 1.0) * 6.283185307179586;
    return (struct rl_microfacet){x, radius * cos(azimuth), radius * sin(azimuth), 1.0};
}

static int map(struct rl_check_rows *rows, const char *parameters, struct rl_check_context *context)
{
    static const struct rl_method method = {
        .name = "spiral", .summary = "normals of the half sphere, evenly", .texel = spiral};
    const struct rl_plan_normal_map planned = {.rr = 1.0, .method = &method};
    struct rl_settings settings;
    float *texels = NULL;
    int status = rl_bench_settings(&settings, parameters, rows->error);
    if (status != RL_OK)
        return status;
    settings.normal_size = SIZE;
    status = rl_gpu_normal_map_read(&texels, context->bench->gpu, &planned, &settings, rows->error);
    if (status != RL_OK)
        return status;
    struct errors errors = {0};
    for (size_t i = 0; i < TEXELS; i++) {
        struct rl_microfacet h = spiral(NULL, 0, i);
        const double exact[] = {h.x, h.y, h.z};
        for (size_t c = 0; c < 3; c++)
            add_error(&errors, 2.0 * texels[4 * i + c] - 1.0, exact[c]);
    }
    free(texels);
    add_rows(rows, &errors, true);
    return RL_OK;
}

/* Radiances of 0 to 1, all three components, as they are drawn into the environment map: in unsigned formats a quarter of a step above
 * what the map then holds. */
static int environment(struct rl_check_rows *rows, const char *parameters)
{
    struct rl_settings settings;
    int status = rl_bench_settings(&settings, parameters, rows->error);
    if (status != RL_OK)
        return status;
    struct errors errors = {0};
    for (int i = 0; i < TEXELS; i++)
        for (int c = 0; c < 3; c++) {
            double exact = (i + 0.25 * (c + 1)) / TEXELS;
            add_error(&errors, rl_texel_nearest(settings.env_format, c, exact), exact);
        }
    add_rows(rows, &errors, false);
    return RL_OK;
}

int rl_check_rounding(struct rl_check_rows *rows, const struct rl_check_case *c,
                      struct rl_check_context *context)
{
    int status = rl_parameters_match(c->parameters, "rounding=environment")
                     ? environment(rows, c->parameters)
                     : map(rows, c->parameters, context);
    return status == RL_OK ? rows->status : status;
}
