/* The study `samples`: what do more samples buy, in error and in time, and what can they not buy?
 *
 * Methods regular and random over N against the reference, at several R_r, with the paper's settings (8-bit normal map,
 * environment map of 256 texels) and with fine ones (float normals, a large float map). Random with several seeds, so that
 * noise and bias come apart. Then N is held large and the environment map's size varied: what is left is the floor that
 * samples cannot remove, at first the map's texels, at last its single position. */
#include "studies/samples.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "measure/metrics.h"
#include "measure/statistics.h"
#include "measure/timing.h"

enum { SEEDS_MAX = 64, ARMS_MAX = 2 };

/* The three grids: lists end with 0. */
struct grid {
    int samples[13];
    double rr[8];
    int floor_env[8];
    int floor_samples;
    int seeds, rounds, width, height;
    double tolerance;
    bool fine; /* also with fine settings, at R_r = fine_rr; full: at every R_r */
    bool fine_everywhere;
    int fine_env;
};

static const struct grid grids[] = {
    [RL_GRID_QUICK] = {.samples = {1, 4, 13, 32, 64},
                       .rr = {3, 30},
                       .floor_env = {32, 128, 256, 512},
                       .floor_samples = 64,
                       .seeds = 4,
                       .rounds = 6,
                       .width = 160,
                       .height = 120,
                       .tolerance = 1e-4},
    [RL_GRID_DEFAULT] = {.samples = {1, 2, 4, 8, 13, 16, 32, 64, 128, 256, 512, 1024},
                         .rr = {3, 30, 300},
                         .floor_env = {64, 128, 256, 512, 1024, 2048},
                         .floor_samples = 1024,
                         .seeds = 8,
                         .rounds = 7,
                         .width = 320,
                         .height = 240,
                         .tolerance = 1e-4,
                         .fine = true,
                         .fine_env = 2048},
    [RL_GRID_FULL] = {.samples = {1, 2, 4, 8, 13, 16, 32, 64, 128, 256, 512, 1024},
                      .rr = {1, 3, 10, 30, 100, 300, 1000},
                      .floor_env = {64, 128, 256, 512, 1024, 2048, 4096},
                      .floor_samples = 1024,
                      .seeds = 16,
                      .rounds = 30,
                      .width = 640,
                      .height = 480,
                      .tolerance = 1e-5,
                      .fine = true,
                      .fine_everywhere = true,
                      .fine_env = 2048},
};

static const double fine_rr = 30.0;

/* One group: N normals by both methods. Timed only where the time is shown. */
static int plan_group(struct rl_run *run, const struct rl_place *place, const struct grid *g, int group,
                      bool fine, int samples, double rr, struct rl_error *error)
{
    static const char *const method[] = {"regular", "random"};
    bool timed = rr == fine_rr;
    for (int m = 0; m < 2; m++)
        if (!rl_run_add(run, place, group, error,
                        "series=methods setting=%s method=%s samples=%d rr=%g normal_bits=%s env_size=%d "
                        "env_format=%s "
                        "seeds=%d rounds=%d width=%d height=%d tolerance=%g",
                        fine ? "fine" : "paper", method[m], samples, rr, fine ? "float" : "8",
                        fine ? g->fine_env : 256, fine ? "rgba32f" : "rgba8", m ? g->seeds : 1,
                        timed ? g->rounds : 0, g->width, g->height, g->tolerance))
            return RL_ERR_SYSTEM;
    return RL_OK;
}

static int plan_floor(struct rl_run *run, const struct rl_place *place, const struct grid *g, int group,
                      int env_size, struct rl_error *error)
{
    return rl_run_add(
               run, place, group, error,
               "series=floor setting=floor method=random samples=%d rr=%g normal_bits=float env_size=%d "
               "env_format=rgba16f seeds=%d rounds=0 width=%d height=%d tolerance=%g",
               g->floor_samples, fine_rr, env_size, g->seeds, g->width, g->height, g->tolerance)
               ? RL_OK
               : RL_ERR_SYSTEM;
}

/* R_r outermost: all cases of one reference together. */
static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    int status = RL_OK;
    for (int r = 0; g->rr[r] > 0.0; r++) {
        bool fine = g->fine && (g->fine_everywhere || g->rr[r] == fine_rr);
        for (int f = 0; f <= (fine ? 1 : 0); f++)
            for (int n = 0; g->samples[n] > 0 && status == RL_OK; n++)
                status = plan_group(run, place, g, group++, f > 0, g->samples[n], g->rr[r], error);
    }
    for (int e = 0; g->floor_env[e] > 0 && status == RL_OK; e++)
        status = plan_floor(run, place, g, group++, g->floor_env[e], error);
    return status;
}

/* Adds metrics until one fails; later calls do nothing. */
struct adder {
    struct rl_record *record;
    struct rl_error *error;
    int status;
};

static void add(struct adder *a, const char *name, double value, double low, double high, const char *unit)
{
    if (a->status == RL_OK)
        a->status = rl_record_metric_add(a->record, name, value, low, high, unit, a->error);
}

/* The mean over seeds, with its interval where there are several. */
static struct rl_interval over_seeds(const double *value, size_t n)
{
    if (n == 1)
        return (struct rl_interval){value[0], value[0], value[0]};
    return rl_mean_interval(value, n, 0.95);
}

static double root(double x)
{
    return sqrt(fmax(x, 0.0));
}

/* RMSE, bias and so on of each seed's picture, and their mean. */
static int add_metrics(struct adder *a, const struct rl_image *image, size_t n,
                       const struct rl_image *reference)
{
    double mse[SEEDS_MAX], mae[SEEDS_MAX], bias[SEEDS_MAX], relmse[SEEDS_MAX], largest = 0.0;
    struct rl_metrics m = {0};
    for (size_t k = 0; k < n; k++) {
        int status = rl_metrics_compute(&m, &image[k], reference, a->error);
        if (status != RL_OK)
            return status;
        if (m.nonfinite > 0)
            return rl_fail(a->error, RL_ERR_CHECK, "%zu values are not finite", m.nonfinite);
        mse[k] = m.rmse * m.rmse;
        mae[k] = m.mae;
        bias[k] = m.bias;
        relmse[k] = m.relmse;
        largest = fmax(largest, m.max);
    }
    struct rl_interval i = over_seeds(mse, n);
    add(a, "rmse", root(i.value), root(i.low), root(i.high), "1");
    i = over_seeds(mae, n);
    add(a, "mae", i.value, i.low, i.high, "1");
    i = over_seeds(bias, n);
    add(a, "bias", i.value, i.low, i.high, "1");
    i = over_seeds(relmse, n);
    add(a, "relmse", i.value, i.low, i.high, "1");
    add(a, "max", largest, largest, largest, "1");
    add(a, "pixels", (double)m.pixels, (double)m.pixels, (double)m.pixels, "px");
    add(a, "mismatched", (double)m.mismatched, (double)m.mismatched, (double)m.mismatched, "px");
    return a->status;
}

/* Noise and floor: what more seeds would average out and what they would not. One picture of a fixed pattern has no noise. */
static int add_split(struct adder *a, const struct rl_image *image, size_t n,
                     const struct rl_image *reference)
{
    struct rl_bias_variance s = {0};
    if (n == 1) {
        const struct rl_metric *rmse = rl_record_metric(a->record, "rmse");
        s.mse = s.bias2 = s.bias2_low = s.bias2_high = rmse->value * rmse->value;
    } else {
        const struct rl_image *pointer[SEEDS_MAX];
        for (size_t k = 0; k < n; k++)
            pointer[k] = &image[k];
        int status = rl_bias_variance_compute(&s, pointer, n, reference, a->error);
        if (status != RL_OK)
            return status;
    }
    add(a, "bias2", s.bias2, s.bias2_low, s.bias2_high, "1");
    add(a, "variance", s.variance, s.variance_low, s.variance_high, "1");
    add(a, "floor", root(s.bias2), root(s.bias2_low), root(s.bias2_high), "1");
    add(a, "noise", root(s.variance), root(s.variance_low), root(s.variance_high), "1");
    return a->status;
}

/* Draws the pictures of all seeds; the scene of the last one is handed on to be timed. */
static int draw_seeds(struct rl_image *image, size_t n, struct rl_bench_scene **last, struct rl_bench *bench,
                      const struct rl_scene *scene, const struct rl_record *r, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t k = 0; k < n && status == RL_OK; k++) {
        if (rl_progress_cancelled(&bench->quiet))
            return rl_fail(error, RL_ERR_CANCELLED, "interrupted; what was finished is kept");
        rl_bench_scene_free(*last);
        double seconds = 0.0;
        status = rl_bench_scene_make(last, bench, scene, r->parameters, k + 1, error);
        if (status == RL_OK)
            status = rl_gpu_scene_frame((*last)->gpu_scene, &seconds, error);
        if (status == RL_OK)
            status = rl_gpu_scene_read((*last)->gpu_scene, &image[k], error);
    }
    return status;
}

static int measure_error(struct rl_record *r, struct rl_bench_scene **last, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error)
{
    size_t n = (size_t)rl_parameter_number(r->parameters, "seeds");
    if (n < 1 || n > SEEDS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "seeds=%zu: expected 1 to %d", n, SEEDS_MAX);
    const struct rl_image *reference;
    int status = rl_bench_reference(&reference, bench, scene, r->parameters, error);
    if (status != RL_OK)
        return status;
    struct rl_image image[SEEDS_MAX] = {0};
    status = draw_seeds(image, n, last, bench, scene, r, error);
    struct adder a = {r, error, RL_OK};
    if (status == RL_OK)
        status = add_metrics(&a, image, n, reference);
    if (status == RL_OK)
        status = add_split(&a, image, n, reference);
    for (size_t k = 0; k < n; k++)
        rl_image_clear(&image[k]);
    return status;
}

static int frame(void *user, double *seconds, struct rl_error *error)
{
    const struct rl_bench_scene *set = user;
    return rl_gpu_scene_frame(set->gpu_scene, seconds, error);
}

/* The arms of a group against each other. The first frame of each has been drawn already. */
static int measure_time(struct rl_record *records, struct rl_bench_scene **set, size_t n,
                        struct rl_bench *bench, struct rl_error *error)
{
    int rounds = (int)rl_parameter_number(records[0].parameters, "rounds");
    if (rounds < 1)
        return RL_OK;
    struct rl_timing_options options = RL_TIMING_DEFAULT;
    options.warm_up = 1;
    options.min_rounds = rounds;
    options.max_rounds = 4 * rounds;
    options.max_seconds = 0.05 * rounds;
    struct rl_timing_arm arm[ARMS_MAX];
    for (size_t i = 0; i < n; i++)
        arm[i] = (struct rl_timing_arm){records[i].parameters, frame, set[i]};
    struct rl_timing timing;
    int status = rl_timing_run(&timing, arm, n, &options, &bench->quiet, error);
    if (status != RL_OK)
        return status;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        struct rl_interval ms = rl_median_interval(timing.ms[i], timing.n_rounds, 0.95);
        status = rl_record_metric_add(&records[i], "frame_ms", ms.value, ms.low, ms.high, "ms", error);
        if (status == RL_OK)
            status = rl_record_series_add(&records[i], "frame_ms", timing.ms[i], timing.n_rounds, error);
    }
    rl_timing_clear(&timing);
    return status;
}

static int measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                   struct rl_error *error)
{
    if (n > ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, at most %d are timed together", n,
                       ARMS_MAX);
    struct rl_bench_scene *set[ARMS_MAX] = {NULL};
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = measure_error(&records[i], &set[i], bench, scene, error);
    if (status == RL_OK)
        status = measure_time(records, set, n, bench, error);
    for (size_t i = 0; i < n; i++)
        rl_bench_scene_free(set[i]);
    return status;
}

#define WITH_INTERVAL(name)                                                                                  \
    {name, RL_COLUMN_VALUE, name}, {name "_low", RL_COLUMN_LOW, name},                                       \
    {                                                                                                        \
        name "_high", RL_COLUMN_HIGH, name                                                                   \
    }

static const struct rl_column columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"series", RL_COLUMN_TEXT, "series"},
    {"setting", RL_COLUMN_TEXT, "setting"},
    {"method", RL_COLUMN_TEXT, "method"},
    {"samples", RL_COLUMN_NUMBER, "samples"},
    {"rr", RL_COLUMN_NUMBER, "rr"},
    {"normal_bits", RL_COLUMN_TEXT, "normal_bits"},
    {"env_size_px", RL_COLUMN_NUMBER, "env_size"},
    {"env_format", RL_COLUMN_TEXT, "env_format"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    {"seeds", RL_COLUMN_NUMBER, "seeds"},
    WITH_INTERVAL("rmse"),
    WITH_INTERVAL("noise"),
    WITH_INTERVAL("floor"),
    WITH_INTERVAL("bias"),
    WITH_INTERVAL("mae"),
    WITH_INTERVAL("relmse"),
    {"max", RL_COLUMN_VALUE, "max"},
    WITH_INTERVAL("bias2"),
    WITH_INTERVAL("variance"),
    WITH_INTERVAL("frame_ms"),
    {"pixels_px", RL_COLUMN_VALUE, "pixels"},
    {"mismatched_px", RL_COLUMN_VALUE, "mismatched"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_table tables[] = {
    {"samples", "Every case: error against the reference, noise and floor apart, median frame time", "",
     columns, sizeof columns / sizeof columns[0]},
};

static const struct rl_figure figures[] = {
    {"error",
     "Error against the number of samples, with the paper's settings. Bars: 95 % intervals over seeds "
     "(regular has no "
     "seed). Grey: slope -1/2, the fall of pure noise, and 1/255, one step of an 8-bit frame buffer."},
    {"split", "Random sampling taken apart at R_r = 30: noise (what more samples remove) and floor (what "
              "they do not), with the "
              "paper's settings and with fine ones."},
    {"floor", "The floor against the environment map's size, at large N and with float normals. It falls "
              "while texels matter and "
              "stops where the map's single position does: the map is taken at the object's centre, not at "
              "each point."},
    {"time", "Error against time: down and left is better. Each point is a number of samples; times are "
             "medians of interleaved "
             "frames."},
};

static const char *const scenes[] = {"teapot-star", NULL};

const struct rl_study rl_study_samples = {
    .name = "samples",
    .summary = "method x number of samples against error and time; noise and bias apart",
    .text = "The highlight by fixed patterns (regular) and by random normals from a baked normal map "
            "(random) is compared with the "
            "reference, which integrates the same highlight on the true polygons in double precision. Errors "
            "are of linear "
            "radiance over the object's pixels, 1 being full scale. With several seeds the squared error "
            "splits into variance "
            "(noise) and bias squared (floor).",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .plan = plan,
    .measure = measure,
    .judge = rl_samples_judge,
};
