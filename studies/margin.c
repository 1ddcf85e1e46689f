/* The study `margin`: what the bounding spheres save and what they lose.
 *
 * Random 4 with the paper's settings, R_r by R_r, with spheres of several margins, with `margin auto`, with one so large that it
 * lets everything through, and without. What is lost is measured twice: in frames of the same random numbers with and
 * without the pass, and without chance on the integral over the pixels that were skipped. Clocks run side by side on larger frames. */
#include "studies/margin.h"

#include <stdio.h>

#include "scene/margin.h"

/* Lists of R_r and of losses end with 0, margins with -1. */
static const struct grid {
    int width, height, timed_width, timed_height, seeds, rounds;
    double tolerance, rr[12], timed_rr[12], margin[10], loss[6];
} grids[] = {
    [RL_GRID_QUICK] = {.width = 80,
                       .height = 60,
                       .timed_width = 160,
                       .timed_height = 120,
                       .seeds = 3,
                       .rounds = 8,
                       .tolerance = 1e-4,
                       .rr = {3, 30, 300},
                       .timed_rr = {300},
                       .margin = {0, 0.5, -1},
                       .loss = {0.1}},
    [RL_GRID_DEFAULT] = {.width = 120,
                         .height = 90,
                         .timed_width = 160,
                         .timed_height = 120,
                         .seeds = 12,
                         .rounds = 30,
                         .tolerance = 1e-5,
                         .rr = {3, 30, 100, 300},
                         .timed_rr = {30, 300},
                         .margin = {0, 0.1, 0.25, 0.5, 1, -1},
                         .loss = {0.1, 0.05, 0.01, 0.005}},
    [RL_GRID_FULL] = {.width = 320,
                      .height = 240,
                      .timed_width = 640,
                      .timed_height = 480,
                      .seeds = 16,
                      .rounds = 60,
                      .tolerance = 1e-5,
                      .rr = {1, 3, 5, 10, 20, 30, 50, 100, 200, 300, 1000},
                      .timed_rr = {1, 3, 5, 10, 20, 30, 50, 100, 200, 300, 1000},
                      .margin = {0, 0.05, 0.1, 0.25, 0.5, 1, 2, 4, -1},
                      .loss = {0.2, 0.1, 0.05, 0.01, 0.005}},
};

/* Frames of each arm: none where the R_r is not among those that are timed. */
static int rounds_at(const struct grid *g, double rr)
{
    for (int i = 0; g->timed_rr[i] > 0.0; i++)
        if (g->timed_rr[i] == rr)
            return g->rounds;
    return 0;
}

static const char paper[] = "samples=4 normal_bits=8 env_size=256 env_format=rgba8";

static int add_arm(struct rl_run *run, const struct rl_place *place, const struct grid *g, double rr,
                   int group, const char *arm, const char *margin, const char *method, struct rl_error *error)
{
    return rl_run_add(
               run, place, group, error,
               "series=margin arm=%s rr=%g margin=%s method=%s %s seeds=%d rounds=%d width=%d height=%d "
               "timed_width=%d timed_height=%d tolerance=%g",
               arm, rr, margin, method, paper, g->seeds, rounds_at(g, rr), g->width, g->height,
               g->timed_width, g->timed_height, g->tolerance)
               ? RL_OK
               : RL_ERR_SYSTEM;
}

static int plan_margins(struct rl_run *run, const struct rl_place *place, const struct grid *g, double rr,
                        int group, struct rl_error *error)
{
    static const struct {
        const char *arm, *margin, *method;
    } fixed[] = {{"off", "off", "random"},
                 {"again", "off", "random"},
                 {"none", "off", "none"},
                 {"huge", "1e6", "random"},
                 {"auto", "auto", "random"}};
    int status = RL_OK;
    for (size_t i = 0; i < sizeof fixed / sizeof fixed[0] && status == RL_OK; i++)
        status = add_arm(run, place, g, rr, group, fixed[i].arm, fixed[i].margin, fixed[i].method, error);
    for (int i = 0; g->margin[i] >= 0.0 && status == RL_OK; i++) {
        char margin[32];
        snprintf(margin, sizeof margin, "%g", g->margin[i]);
        status = add_arm(run, place, g, rr, group, margin, margin, "random", error);
    }
    return status;
}

static int plan_bounds(struct rl_run *run, const struct rl_place *place, const struct grid *g, double rr,
                       int group, struct rl_error *error)
{
    for (int i = 0; g->loss[i] > 0.0; i++)
        if (!rl_run_add(run, place, group, error,
                        "series=bound loss=%g rr=%g method=random %s seeds=1 rounds=0 width=%d height=%d "
                        "tolerance=%g",
                        g->loss[i], rr, paper, g->width, g->height, g->tolerance))
            return RL_ERR_SYSTEM;
    return RL_OK;
}

static int add_filled(struct rl_run *run, const struct rl_place *place, double rr, double loss, int group,
                      struct rl_error *error)
{
    return rl_run_add(run, place, group, error, "series=filled loss=%g rr=%g", loss, rr) ? RL_OK
                                                                                         : RL_ERR_SYSTEM;
}

/* The closed form knows no scene: what lights made for it lose is the same beside any. */
static int plan_alone(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                      struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    int status = RL_OK;
    for (int r = 0; g->rr[r] > 0.0 && status == RL_OK; r++, group++) {
        status = add_filled(run, place, g->rr[r], RL_MARGIN_BOUND, group, error);
        for (int i = 0; g->loss[i] > 0.0 && status == RL_OK; i++)
            status = add_filled(run, place, g->rr[r], g->loss[i], group, error);
    }
    return status;
}

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    int status = RL_OK;
    for (int r = 0; g->rr[r] > 0.0 && status == RL_OK; r++) {
        status = plan_margins(run, place, g, g->rr[r], group++, error);
        if (status == RL_OK)
            status = plan_bounds(run, place, g, g->rr[r], group++, error);
    }
    return status;
}

static const struct rl_column columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"series", RL_COLUMN_TEXT, "series"},
    {"arm", RL_COLUMN_TEXT, "arm"},
    {"loss", RL_COLUMN_NUMBER, "loss"},
    {"rr", RL_COLUMN_NUMBER, "rr"},
    {"seeds", RL_COLUMN_NUMBER, "seeds"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    {"timed_width_px", RL_COLUMN_NUMBER, "timed_width"},
    {"timed_height_px", RL_COLUMN_NUMBER, "timed_height"},
    {"spheres", RL_COLUMN_VALUE, "spheres"},
    {"margin", RL_COLUMN_VALUE, "margin"},
    {"bound", RL_COLUMN_VALUE, "bound"},
    {"filled", RL_COLUMN_VALUE, "filled"},
    {"due", RL_COLUMN_VALUE, "due"},
    {"from_rr", RL_COLUMN_VALUE, "from_rr"},
    {"skipped", RL_COLUMN_VALUE, "skipped"},
    RL_COLUMNS_WITH_INTERVAL("missed"),
    {"worst", RL_COLUMN_VALUE, "worst"},
    RL_COLUMNS_WITH_INTERVAL("missed_exact"),
    RL_COLUMNS_WITH_INTERVAL("worst_exact"),
    RL_COLUMNS_WITH_INTERVAL("loss_exact"),
    RL_COLUMNS_WITH_INTERVAL("frame_ms"),
    RL_COLUMNS_WITH_INTERVAL("time_to_off"),
    RL_COLUMNS_WITH_INTERVAL("above_off_ms"),
    RL_COLUMNS_WITH_INTERVAL("above_baseline_ms"),
    {"frames", RL_COLUMN_VALUE, "frames"},
    {"time_precision", RL_COLUMN_VALUE, "time_precision"},
    {"time_capped", RL_COLUMN_VALUE, "time_capped"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_table tables[] = {
    {"margin",
     "Every margin at every R_r: what is skipped, what of the highlight is lost, the frame's time against "
     "that without the pass",
     "", columns, sizeof columns / sizeof columns[0]},
};

static const struct rl_figure figures[] = {
    {"missed",
     "Share of the highlight's energy that the pass takes away, by margin: frames of 4 random "
     "normals with and "
     "without the pass, of the same seeds, with 95 % intervals. Rings: auto, with its R_r, where it has a "
     "sphere. Grey: 1 %." RL_CAPTION_EDGE},
    {"trade",
     "What a sphere saves against what it loses: frame time over that without the pass, and the share "
     "of the highlight "
     "missed. Down and left is better. Above 1 the pass costs more than it saves. Numbers are "
     "margins, at rings R_r." RL_CAPTION_EDGE},
    {"cost",
     "Frame time over that without the pass, paired by round, 95 % intervals of the median: with a margin so "
     "large that the pass lets every pixel through, which is what it costs by itself, and with auto. Beside "
     "it two arms without the pass, which differ by noise alone."},
    {"bound",
     "The proof at work: the most that any skipped pixel loses of the integral, against the bound that "
     "the closed-form margin was asked to keep. Marks below the grey diagonal keep it. "
     "Where a mark is missing the closed form has no sphere." RL_CAPTION_EDGE},
    {"mean",
     "The same of all pixels skipped: what they lose of the integral in the mean, which is their energy "
     "over bound x radiance x pixels where the grey diagonal is 1." RL_CAPTION_EDGE},
};

static const struct rl_figure figures_alone[] = {
    {"filled",
     "Is the closed form as large as it must be? What two lights lose of its bound together, on "
     "opposite sides of the mirror direction, just outside of their spheres, at the size at which "
     "that is most. Dotted: what they would lose beside spheres just as large as the proof asks; marks "
     "off it are of a margin that is too small (above) or wastes time (below). Large lights lose "
     "half of the bound or somewhat more, which is the grey; small ones, the only ones that have a "
     "sphere where R_r or the bound is small, lose less."},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    RL_SWEEP_RR(NULL),
    {.name = "margin",
     .of = "series=margin",
     .kind = RL_SWEEP_REAL,
     .low = 0,
     .high = 1e5,
     .together = 16,
     .named_by = "arm"},
    {.name = "loss",
     .of = "series=filled",
     .kind = RL_SWEEP_REAL,
     .low = 1e-6,
     .high = 0.999,
     .together = 24},
    {.name = "loss", .of = "series=bound", .kind = RL_SWEEP_REAL, .low = 1e-6, .high = 0.999, .together = 24},
    {.name = "samples", .of = NULL, .kind = RL_SWEEP_WHOLE, .low = 1, .high = 1024},
    {.name = "normal_bits", .of = NULL, .kind = RL_SWEEP_WORD, .words = rl_sweep_normal_bits},
    RL_SWEEP_ENV_SIZE(NULL),
    {.name = "env_format", .of = NULL, .kind = RL_SWEEP_WORD, .words = rl_sweep_env_formats},
    RL_SWEEP_SEEDS("series=margin"),
    {.name = "rounds", .of = "series=margin", .kind = RL_SWEEP_WHOLE, .low = 0, .high = 100000},
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
    RL_SWEEP_PIXELS("timed_width", NULL),
    RL_SWEEP_PIXELS("timed_height", NULL),
    RL_SWEEP_TOLERANCE(NULL),
};

static const char *const scenes[] = {"teapot-star", "sphere-quad", "three-lights", NULL};

static const struct rl_cost costs[] = {{.pattern = "series=filled", .picture = 0.001},
                                       {.pattern = "", .group = 0.044, .picture = 0.0025, .pixel = 0.15}};

const struct rl_study rl_study_margin = {
    .name = "margin",
    .summary =
        "bounding-sphere margin x R_r: highlight missed, pixels skipped, time saved; margin auto and its "
        "bound",
    .text =
        "Pixels whose mirror direction misses every light's bounding sphere, enlarged by a margin, are left "
        "without highlight. The share of the highlight's energy that is lost so is measured in frames of 4 "
        "random normals with the same seeds with and without the pass; and on the integral itself, seen from "
        "the object's centre as an environment map sees it, over the pixels that were skipped. The margin "
        "auto "
        "follows from R_r in closed form and keeps each pixel's loss at or below 2 % of the light's "
        "radiance.",
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
    .measure = rl_margin_measure,
    .judge = rl_margin_judge,
};
