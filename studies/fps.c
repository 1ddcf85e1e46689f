/* The study `fps`: the paper's Table 1 again. Plain highlight, 13 regular normals, 4 random normals, at 640x480 with an
 * environment map of 256 texels a face: 530, 28 and 38 frames a second on a GeForce FX 5200.
 *
 * All arms take turns frame by frame in random order; every frame is finished before the clock stops. Beside the paper's three
 * there are an arm without highlight (what a frame costs anyway), random 4 once more (A/A: how much two arms of the
 * same work differ, below which no difference counts) and the environment map's own pass. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "measure/statistics.h"
#include "measure/timing.h"
#include "studies/fps.h"

/* `paper_fps`: as Table 1 has it, or 0. */
static const struct arm {
    const char *name, *method;
    int samples;
    double paper_fps;
} arms[] = {
    {"none", "none", 0, 0.0},
    {"plain", "plain", 0, RL_PAPER_PLAIN_FPS},
    {"regular-13", "regular", 13, RL_PAPER_REGULAR_FPS},
    {"random-4", "random", 4, RL_PAPER_RANDOM_FPS},
    {"random-4-again", "random", 4, 0.0},
    {"environment", "random", 4, 0.0},
};

enum { ARMS = sizeof arms / sizeof arms[0] };

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    static const struct {
        int width, height, rounds;
    } size[] = {[RL_GRID_QUICK] = {160, 120, 10},
                [RL_GRID_DEFAULT] = {640, 480, 60},
                [RL_GRID_FULL] = {640, 480, 300}};
    for (int i = 0; i < ARMS; i++)
        if (!rl_run_add(run, place, group, error,
                        "arm=%s method=%s samples=%d normal_bits=8 env_size=256 env_format=rgba8 rounds=%d "
                        "width=%d height=%d",
                        arms[i].name, arms[i].method, arms[i].samples, size[grid].rounds, size[grid].width,
                        size[grid].height))
            return RL_ERR_SYSTEM;
    return RL_OK;
}

static int draw_frame(void *user, double *seconds, struct rl_error *error)
{
    const struct rl_bench_scene *set = user;
    return rl_gpu_scene_frame(set->gpu_scene, seconds, error);
}

static int draw_environment(void *user, double *seconds, struct rl_error *error)
{
    const struct rl_bench_scene *set = user;
    return rl_gpu_scene_environment(set->gpu_scene, seconds, error);
}

static int add(struct rl_record *r, const char *name, struct rl_interval x, const char *unit,
               struct rl_error *error)
{
    return rl_record_metric_add(r, name, x.value, x.low, x.high, unit, error);
}

/* The arm among the n records of a group, or -1. */
static long find_arm(const struct rl_record *records, size_t n, const char *name)
{
    char pattern[64];
    snprintf(pattern, sizeof pattern, "arm=%s", name);
    for (size_t i = 0; i < n; i++)
        if (rl_parameters_match(records[i].parameters, pattern))
            return (long)i;
    return -1;
}

/* An arm's time, its rate, and both against the other arms, paired by round. */
static int add_figures(struct rl_record *r, const struct rl_timing *t, size_t i, long baseline, long random,
                       struct rl_error *error)
{
    struct rl_interval ms = rl_median_interval(t->ms[i], t->n_rounds, 0.95);
    struct rl_interval fps = {1000.0 / ms.value, 1000.0 / ms.high, 1000.0 / ms.low};
    double frames = (double)t->n_rounds;
    int status = add(r, "frame_ms", ms, "ms", error);
    if (status == RL_OK)
        status = add(r, "fps", fps, "1/s", error);
    if (status == RL_OK)
        status = add(r, "frames", (struct rl_interval){frames, frames, frames}, "1", error);
    if (status == RL_OK && baseline >= 0)
        status = add(r, "above_baseline_ms",
                     rl_difference_interval(t->ms[i], t->ms[baseline], t->n_rounds, 0.95), "ms", error);
    if (status == RL_OK && random >= 0)
        status = add(r, "time_to_random4", rl_ratio_interval(t->ms[i], t->ms[random], t->n_rounds, 0.95), "1",
                     error);
    char name[RL_NAME_MAX];
    rl_parameter(r->parameters, "arm", name, sizeof name);
    for (int k = 0; k < ARMS && status == RL_OK; k++)
        if (arms[k].paper_fps > 0.0 && strcmp(arms[k].name, name) == 0) {
            double f = arms[k].paper_fps;
            status = add(r, "paper_fps", (struct rl_interval){f, f, f}, "1/s", error);
        }
    if (status == RL_OK)
        status = rl_record_series_add(r, "frame_ms", t->ms[i], t->n_rounds, error);
    return status;
}

static int time_arms(struct rl_record *records, struct rl_bench_scene **set, size_t n, struct rl_bench *bench,
                     struct rl_error *error)
{
    struct rl_timing_arm arm[ARMS];
    for (size_t i = 0; i < n; i++) {
        bool environment = rl_parameters_match(records[i].parameters, "arm=environment");
        arm[i] = (struct rl_timing_arm){records[i].parameters, environment ? draw_environment : draw_frame,
                                        set[i]};
    }
    int rounds = (int)rl_parameter_number(records[0].parameters, "rounds");
    struct rl_timing_options options = RL_TIMING_DEFAULT;
    options.warm_up = 3;
    options.min_rounds = rounds;
    options.max_rounds = 3 * rounds;
    struct rl_timing timing;
    int status = rl_timing_run(&timing, arm, n, &options, &bench->quiet, error);
    if (status != RL_OK)
        return status;
    long baseline = find_arm(records, n, "none"), random = find_arm(records, n, "random-4");
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = add_figures(&records[i], &timing, i, baseline, random, error);
    rl_timing_clear(&timing);
    return status;
}

static int measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                   struct rl_error *error)
{
    if (n > ARMS)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, expected at most %d", n, ARMS);
    struct rl_bench_scene *set[ARMS] = {NULL};
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = rl_bench_scene_make(&set[i], bench, scene, records[i].parameters, 1, error);
    if (status == RL_OK)
        status = time_arms(records, set, n, bench, error);
    for (size_t i = 0; i < n; i++)
        rl_bench_scene_free(set[i]);
    return status;
}

static const struct rl_column columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"arm", RL_COLUMN_TEXT, "arm"},
    {"method", RL_COLUMN_TEXT, "method"},
    {"samples", RL_COLUMN_NUMBER, "samples"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    {"env_size_px", RL_COLUMN_NUMBER, "env_size"},
    {"frames", RL_COLUMN_VALUE, "frames"},
    RL_COLUMNS_WITH_INTERVAL("frame_ms"),
    RL_COLUMNS_WITH_INTERVAL("fps"),
    {"paper_fps", RL_COLUMN_VALUE, "paper_fps"},
    RL_COLUMNS_WITH_INTERVAL("above_baseline_ms"),
    RL_COLUMNS_WITH_INTERVAL("time_to_random4"),
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_table tables[] = {
    {"fps", "Every arm: median frame time and rate, the paper's rate, time above the frame without highlight",
     "", columns, sizeof columns / sizeof columns[0]},
};

static const struct rl_figure figures[] = {
    {"rate", "Frames a second, measured here and as the paper's Table 1 has them (GeForce FX 5200). Bars: 95 "
             "% intervals of the "
             "median, mostly smaller than the mark. Grey: 24 and 30 frames a second."},
    {"frames", "Every frame's time in the order of the rounds: drift, outliers, and the noise floor (random "
               "4 against itself)."},
};

static const char *const scenes[] = {"teapot-star", "sphere-quad", NULL};

const struct rl_study rl_study_fps = {
    .name = "fps",
    .summary = "frames a second of plain, regular 13 and random 4: the paper's Table 1",
    .text = "The three highlights of the paper's Table 1, beside a frame without highlight (none), a second "
            "arm of the same random 4 "
            "(A/A) and the pass that renders the environment map. The arms take turns frame by frame in "
            "random order and every "
            "frame is finished before the clock stops.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .plan = plan,
    .measure = measure,
    .judge = rl_fps_judge,
};
