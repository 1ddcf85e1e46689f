/* The study `budget`: where the error comes from. Each approximation of the paper alone, and all of them together. */
#include "studies/budget.h"

/* R_r end with 0. `samples`, `env_size`: of the base, from which each arm departs in one thing. */
static const struct grid {
    int width, height, samples, env_size, seeds;
    double tolerance, rr[8];
} grids[] = {
    [RL_GRID_QUICK] = {80, 60, 128, 512, 4, 1e-4, {30}},
    [RL_GRID_DEFAULT] = {96, 72, 256, 1024, 5, 1e-4, {30, 300}},
    [RL_GRID_FULL] = {320, 240, 1024, 2048, 16, 1e-5, {3, 10, 30, 100, 300, 1000}},
};

/* Settings that differ from the base's; the first of equal keys counts. */
static const struct {
    const char *arm, *settings;
} arms[] = {
    {"base", ""},
    {"sampling", "samples=4 "},
    {"normals", "normal_bits=8 "},
    {"map", "env_size=256 "},
    {"format", "env_format=rgba8 "},
    {"parallax", ""},
    {"sphere", "margin=auto "},
    {"frame", "frame=printed "},
    {"bits", ""},
    {"all", "samples=4 normal_bits=8 env_size=256 env_format=rgba8 margin=auto frame=printed "},
};

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    for (int r = 0; g->rr[r] > 0.0; r++)
        for (size_t i = 0; i < sizeof arms / sizeof arms[0]; i++)
            if (!rl_run_add(run, place, group + r, error,
                            "arm=%s rr=%g %smethod=random samples=%d normal_bits=float env_size=%d "
                            "env_format=rgba16f margin=off frame=orthonormal seeds=%d width=%d height=%d "
                            "tolerance=%g",
                            arms[i].arm, g->rr[r], arms[i].settings, g->samples, g->env_size, g->seeds,
                            g->width, g->height, g->tolerance))
                return RL_ERR_SYSTEM;
    return RL_OK;
}

static const struct rl_column columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"arm", RL_COLUMN_TEXT, "arm"},
    {"rr", RL_COLUMN_NUMBER, "rr"},
    {"samples", RL_COLUMN_NUMBER, "samples"},
    {"normal_bits", RL_COLUMN_TEXT, "normal_bits"},
    {"env_size_px", RL_COLUMN_NUMBER, "env_size"},
    {"env_format", RL_COLUMN_TEXT, "env_format"},
    {"margin", RL_COLUMN_TEXT, "margin"},
    {"frame", RL_COLUMN_TEXT, "frame"},
    {"seeds", RL_COLUMN_NUMBER, "seeds"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    RL_COLUMNS_WITH_INTERVAL("mse"),
    RL_COLUMNS_WITH_INTERVAL("rmse"),
    RL_COLUMNS_WITH_INTERVAL("bias"),
    RL_COLUMNS_WITH_INTERVAL("share"),
    RL_COLUMNS_WITH_INTERVAL("interaction"),
    RL_COLUMNS_WITH_INTERVAL("interaction_share"),
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_table tables[] = {
    {"budget",
     "Each approximation alone and all together: squared error, bias, share, and the interaction left over",
     "", columns, sizeof columns / sizeof columns[0]},
};

static const struct rl_figure figures[] = {
    {"sources",
     "Where the squared error comes from, in parts of that of all together: each approximation "
     "alone, and the interaction, which is what their sum leaves of the whole (to the left of 0: "
     "the sum is more). Bars: 95 % intervals. base: what is left in the pictures from which the "
     "single ones depart, no part of the sum. One step of an 8-bit frame buffer is an RMSE of 0.0039."},
    {"smoother",
     "The RMSE of each over R_r: smoother surfaces have less noise, and show more of what the map "
     "and the normals' bits do. Marks of one R_r stand side by side. Bars: 95 % intervals. Grey: "
     "1/255, one step of an 8-bit frame buffer." RL_CAPTION_EDGE},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    RL_SWEEP_RR(NULL),
    RL_SWEEP_SEEDS(NULL),
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
    RL_SWEEP_TOLERANCE(NULL),
};

static const char *const scenes[] = {"teapot-star", "sphere-quad", "three-lights", NULL};

static const struct rl_cost costs[] = {{.pattern = "", .group = 0.03, .sample = 0.03}};

const struct rl_study rl_study_budget = {
    .name = "budget",
    .summary = "each approximation alone and all together: where the error comes from",
    .text = "From a base that is nearly exact (many random float normals, a large half-float map) each "
            "approximation is "
            "switched on alone: 4 normals a pixel (sampling), an 8-bit normal map (normals), 256 texels a "
            "face edge "
            "(map), 8-bit texels (format), bounding spheres with margin auto (sphere), the tangent frame as "
            "printed "
            "(frame); each against base pictures of the same seeds, so that their noise drops out. The map's "
            "single "
            "position (parallax) and an 8-bit frame buffer (bits) are taken exactly, on the reference. All "
            "together is "
            "held against the reference. Errors are over the foreground; what the sum of single squared "
            "errors leaves of "
            "the whole is the interaction.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .plan = plan,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_budget_measure,
    .judge = rl_budget_judge,
};
