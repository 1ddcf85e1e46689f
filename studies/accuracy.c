/* The study `accuracy`: what a true digit costs.
 *
 * Three parts. Points: every integrator of the highlight at one point, over its tolerances, on the fixed points of points.h: time
 * and true error. Images: whole images by the reference, over tolerances and threads. Kernel: the inner loop of exhaustive. Only
 * images have a scene. */
#include "studies/accuracy.h"

#include <math.h>

#include "base/machine.h"
#include "base/simd.h"
#include "studies/points.h"

enum { TOLERANCES_MAX = 12 };

/* An integrator's tolerances, ascending in cost; 0 ends the list. It stops where it would by itself (max_evaluations=0). */
struct row {
    const char *integrator;
    double tolerance[TOLERANCES_MAX];
    bool quads_only;
    int points; /* the first of all; 0: all */
};

struct grid {
    int points;
    struct row row[12]; /* one without a name ends the list */
    int width, height;
    double tolerance[8]; /* of images; 0 ends the list */
    int rounds;
    int width_of_speed_up, height_of_speed_up, rounds_of_speed_up;
    int rounds_of_bar; /* of an image of 640x480 to 1e-6, where the scene has a bar; 0: it is among the others */
    double kernel_seconds;
    int kernel_rounds;
};

/* The slow ones have rows of their own for the tolerances at which they take millions of evaluations, and fewer points. */
static const struct grid grids[] = {
    [RL_GRID_QUICK] = {.points = 10,
                       .row = {{"reference", {1e-2, 1e-5, 1e-6, 1e-10, 1e-12}, false, 0},
                               {"cubature", {1e-2, 1e-6, 1e-9}, false, 0},
                               {"montecarlo", {1e-2, 3e-3, 1e-3}, false, 0},
                               {"vegas", {1e-3}, false, 0},
                               {"cubature-uv", {1e-2, 1e-3, 1e-4}, false, 0},
                               {"cubature-uv", {1e-5}, true, 0}},
                       .width = 160,
                       .height = 120,
                       .tolerance = {1e-3, 1e-8},
                       .rounds = 6,
                       .width_of_speed_up = 160,
                       .height_of_speed_up = 120,
                       .rounds_of_speed_up = 14,
                       .rounds_of_bar = 0,
                       .kernel_seconds = 0.02,
                       .kernel_rounds = 6},
    [RL_GRID_DEFAULT] = {.points = 100,
                         .row = {{"reference",
                                  {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12},
                                  false,
                                  0},
                                 {"cubature", {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}, false, 0},
                                 {"cubature", {1e-9}, false, 50},
                                 {"montecarlo", {1e-1, 3e-2, 1e-2, 3e-3}, false, 0},
                                 {"montecarlo", {1e-3}, true, 50},
                                 {"vegas", {1e-3}, false, 50},
                                 {"vegas", {3e-4}, true, 25},
                                 {"cubature-uv", {1e-2, 1e-3, 1e-4}, false, 0},
                                 {"cubature-uv", {1e-5}, true, 0}},
                         .width = 640,
                         .height = 480,
                         .tolerance = {1e-3, 1e-6, 1e-8},
                         .rounds = 6,
                         .width_of_speed_up = 320,
                         .height_of_speed_up = 240,
                         .rounds_of_speed_up = 12,
                         .kernel_seconds = 0.05,
                         .kernel_rounds = 6},
    [RL_GRID_FULL] = {.points = 1000,
                      .row = {{"reference",
                               {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12},
                               false,
                               0},
                              {"cubature", {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}, false, 0},
                              {"montecarlo", {1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4}, false, 0},
                              {"vegas", {1e-3, 3e-4, 1e-4, 3e-5}, false, 0},
                              {"cubature-uv", {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}, false, 0}},
                      .width = 640,
                      .height = 480,
                      .tolerance = {1e-2, 1e-3, 1e-4, 1e-5, 1e-7, 1e-8, 1e-10},
                      .rounds = 10,
                      .width_of_speed_up = 640,
                      .height_of_speed_up = 480,
                      .rounds_of_speed_up = 20,
                      .kernel_seconds = 0.5,
                      .kernel_rounds = 20},
};

static int threads_most(void)
{
    return rl_machine_threads() < 2 ? 1 : 2;
}

static int plan_row(struct rl_run *run, const struct rl_place *place, const struct grid *g,
                    const struct row *row, enum rl_point_light_kind kind, int group, struct rl_error *error)
{
    for (int t = 0; t < TOLERANCES_MAX && row->tolerance[t] > 0.0; t++)
        if (!rl_run_add(run, place, group, error,
                        "part=points integrator=%s tolerance=%g light=%s points=%d max_evaluations=0",
                        row->integrator, row->tolerance[t], rl_point_light_name(kind),
                        row->points ? row->points : g->points))
            return RL_ERR_SYSTEM;
    return RL_OK;
}

static int plan_points(struct rl_run *run, const struct rl_place *place, const struct grid *g,
                       enum rl_point_light_kind kind, int group, struct rl_error *error)
{
    int status = RL_OK;
    for (const struct row *row = g->row; row->integrator && status == RL_OK; row++)
        if (kind == RL_POINT_QUAD || !row->quads_only)
            status = plan_row(run, place, g, row, kind, group, error);
    return status;
}

static int plan_kernel(struct rl_run *run, const struct rl_place *place, const struct grid *g, int group,
                       struct rl_error *error)
{
    for (int simd = 0; simd <= (int)rl_simd_best(); simd++)
        for (int threads = 1; threads <= threads_most(); threads++)
            if (!rl_run_add(run, place, group, error,
                            "part=kernel simd=%s threads=%d size=128 seconds=%g rounds=%d",
                            rl_simd_name((enum rl_simd)simd), threads, g->kernel_seconds, g->kernel_rounds))
                return RL_ERR_SYSTEM;
    return RL_OK;
}

static int plan_alone(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                      struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    int status = RL_OK;
    for (int kind = 0; kind < RL_POINT_KINDS && status == RL_OK; kind++)
        status = plan_points(run, place, g, (enum rl_point_light_kind)kind, group++, error);
    return status == RL_OK ? plan_kernel(run, place, g, group, error) : status;
}

static struct rl_record *plan_image(struct rl_run *run, const struct rl_place *place, const struct grid *g,
                                    const char *method, double tolerance, int group, struct rl_error *error)
{
    return rl_run_add(
        run, place, group, error,
        "part=images method=%s tolerance=%g threads=%d width=%d height=%d env_size=256 rounds=%d", method,
        tolerance, threads_most(), g->width, g->height, g->rounds);
}

static struct rl_record *plan_speed_up(struct rl_run *run, const struct rl_place *place, const struct grid *g,
                                       int threads, int group, struct rl_error *error)
{
    return rl_run_add(run, place, group, error,
                      "part=images method=reference tolerance=1e-06 threads=%d width=%d height=%d "
                      "env_size=256 rounds=%d",
                      threads, g->width_of_speed_up, g->height_of_speed_up, g->rounds_of_speed_up);
}

static bool plan_bar(struct rl_run *run, const struct rl_place *place, const struct grid *g, int group,
                     struct rl_error *error)
{
    if (g->rounds_of_bar == 0 || isnan(rl_accuracy_bar(place->scene)))
        return true;
    return rl_run_add(run, place, group, error,
                      "part=images method=reference tolerance=1e-06 threads=%d width=640 height=480 "
                      "env_size=256 rounds=%d",
                      threads_most(), g->rounds_of_bar);
}

/* Three groups, or four: at 1e-6 on one thread and two, in turns; tolerances, on as many threads as there may be; exhaustive, since a
 * case that fails takes its group with it; and the image that there is a bar for. */
static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    for (int threads = 1; threads <= threads_most(); threads++)
        if (!plan_speed_up(run, place, g, threads, group, error))
            return RL_ERR_SYSTEM;
    group++;
    for (int t = 0; g->tolerance[t] > 0.0; t++)
        if (!plan_image(run, place, g, "reference", g->tolerance[t], group, error))
            return RL_ERR_SYSTEM;
    bool ok = plan_image(run, place, g, "exhaustive", 1e-6, group + 1, error) &&
              plan_bar(run, place, g, group + 2, error);
    return ok ? RL_OK : RL_ERR_SYSTEM;
}

static int measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                   struct rl_error *error)
{
    if (rl_parameters_match(records[0].parameters, "part=points"))
        return rl_accuracy_measure_points(records, n, bench, error);
    if (rl_parameters_match(records[0].parameters, "part=kernel"))
        return rl_accuracy_measure_kernel(records, n, bench, error);
    return rl_accuracy_measure_images(records, n, bench, scene, error);
}

static const struct rl_column point_columns[] = {
    {"integrator", RL_COLUMN_TEXT, "integrator"},
    {"light", RL_COLUMN_TEXT, "light"},
    {"tolerance", RL_COLUMN_NUMBER, "tolerance"},
    {"points", RL_COLUMN_NUMBER, "points"},
    RL_COLUMNS_WITH_INTERVAL("time_us"),
    RL_COLUMNS_WITH_INTERVAL("true_error"),
    {"error_p90", RL_COLUMN_VALUE, "error_p90"},
    {"error_max", RL_COLUMN_VALUE, "error_max"},
    {"bounded", RL_COLUMN_VALUE, "bounded"},
    {"within", RL_COLUMN_VALUE, "within"},
    {"converged", RL_COLUMN_VALUE, "converged"},
    RL_COLUMNS_WITH_INTERVAL("evaluations"),
    {"max_evaluations", RL_COLUMN_NUMBER, "max_evaluations"},
};

static const struct rl_column image_columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"method", RL_COLUMN_TEXT, "method"},
    {"tolerance", RL_COLUMN_NUMBER, "tolerance"},
    {"threads", RL_COLUMN_NUMBER, "threads"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    {"rounds", RL_COLUMN_NUMBER, "rounds"},
    RL_COLUMNS_WITH_INTERVAL("seconds"),
    {"worst_error", RL_COLUMN_VALUE, "worst_error"},
    {"unconverged_px", RL_COLUMN_VALUE, "unconverged"},
    {"lines", RL_COLUMN_VALUE, "lines"},
    RL_COLUMNS_WITH_INTERVAL("texel_normals"),
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_column kernel_columns[] = {
    {"simd", RL_COLUMN_TEXT, "simd"},
    {"threads", RL_COLUMN_NUMBER, "threads"},
    {"rounds", RL_COLUMN_NUMBER, "rounds"},
    RL_COLUMNS_WITH_INTERVAL("texel_normals"),
};

static const struct rl_table tables[] = {
    {"accuracy_points",
     "Points: median time, true error, how often the stated error bounds it, how often the integrator "
     "converged",
     "part=points", point_columns, sizeof point_columns / sizeof point_columns[0]},
    {"accuracy_images", "Images: median seconds by tolerance and threads", "part=images", image_columns,
     sizeof image_columns / sizeof image_columns[0]},
    {"accuracy_kernel", "Exhaustive's inner loop: texel-normals per second by instruction set and threads",
     "part=kernel", kernel_columns, sizeof kernel_columns / sizeof kernel_columns[0]},
};

#define POINT_CAPTION                                                                                        \
    " Each mark is a tolerance: across, the median time of a point with its 95 % interval; up, the "         \
    "true error that nine points in ten stay below, its bar from the median to the largest. Down and left "  \
    "is better." RL_CAPTION_EDGE

static const struct rl_figure figures_alone[] = {
    {"quad",
     "Error against time, one quad light; the line stands at the bar of 20 us for 1e-6." POINT_CAPTION},
    {"star", "Error against time, a star of ten edges." POINT_CAPTION},
    {"bounded",
     "At how many points the stated error bounds the true one, by integrator, light and tolerance (from "
     "coarse "
     "at the left to fine); first, at how many the reference is within the tolerance asked for. Lines: all "
     "cases of an integrator together, which the claims are about. Reference and cubature over the lights' "
     "area are to bound it always, Monte Carlo and VEGAS in 99 % of cases to within 2 % (grey), and cubature "
     "over (U, V), if it were a ground truth, at 9 points in 10 or more."},
    {"kernel", "Exhaustive's inner loop: texel-normals per second, 95 % intervals of the median, mostly "
               "smaller than the mark. Line: the bar of 1e9 on two threads."},
};

static const struct rl_figure figures[] = {
    {"seconds", "Seconds an image against the tolerance asked for, median of rounds in turns with its 95 % "
                "interval (of fewer than six rounds none of 95 % is known)."},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    {.name = "points", .of = "part=points", .kind = RL_SWEEP_WHOLE, .low = 2, .high = 100000},
    {.name = "rounds", .of = "part=images", .kind = RL_SWEEP_WHOLE, .low = 2, .high = 64},
    {.name = "rounds", .of = "part=kernel", .kind = RL_SWEEP_WHOLE, .low = 6, .high = 100000},
    {.name = "seconds", .of = "part=kernel", .kind = RL_SWEEP_REAL, .low = 0.001, .high = 1e4},
    RL_SWEEP_PIXELS("width", "part=images"),
    RL_SWEEP_PIXELS("height", "part=images"),
};

static const char *const scenes[] = {"sphere-quad", "teapot-star", NULL};

static const struct rl_cost costs[] = {{.pattern = "part=images", .picture = 0.044, .pixel = 1.1},
                                       {.pattern = "part=kernel", .group = 0.5, .second = 2.7},
                                       {.pattern = "part=points", .picture = 0.014, .pixel = 2500.0}};

const struct rl_study rl_study_accuracy = {
    .name = "accuracy",
    .summary = "integrators: time and true error against tolerance; images a second; exhaustive's rate",
    .text =
        "Every integrator of the highlight at one point takes its turn at fixed points (R_r 1 to 300, N.V "
        "down "
        "to 0.05, attenuation on, one light near the mirror direction), at every tolerance. Truth is the "
        "reference at 1e-13, itself held against the others by the tests. Times are of the thread's own "
        "clock, "
        "after a warm-up where that makes a difference. Vegas stops after a fixed number of samples, whether "
        "or not it has converged. Whole images are timed by the clock on the wall, threads in turns.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .figures_alone = figures_alone,
    .n_figures_alone = sizeof figures_alone / sizeof figures_alone[0],
    .plan = plan,
    .plan_alone = plan_alone,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = measure,
    .judge = rl_accuracy_judge,
};
