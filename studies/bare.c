/* The study `bare`: what the general pipeline costs where a scene asks for next to nothing. A scene of diffuse and phong, point and
 * parallel light, drawn by its plan and by a program in bare OpenGL that is written for it and nothing else, frame by frame in turn. */
#include "studies/bare.h"

static const struct grid {
    int size[4][2]; /* ends with 0 */
    int rounds;
} grids[] = {
    [RL_GRID_QUICK] = {{{160, 120}}, 15},
    [RL_GRID_DEFAULT] = {{{640, 480}}, 150},
    [RL_GRID_FULL] = {{{320, 240}, {640, 480}, {1280, 960}}, 1000},
};

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    static const char *const arms[] = {"plan", "uniforms", "again", "literals"};
    const struct grid *g = &grids[grid];
    for (int s = 0; g->size[s][0] > 0; s++, group++)
        for (size_t i = 0; i < sizeof arms / sizeof arms[0]; i++)
            if (!rl_run_add(run, place, group, error, "arm=%s width=%d height=%d rounds=%d", arms[i],
                            g->size[s][0], g->size[s][1], g->rounds))
                return RL_ERR_SYSTEM;
    return RL_OK;
}

static const struct rl_column columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"arm", RL_COLUMN_TEXT, "arm"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    {"rounds", RL_COLUMN_NUMBER, "rounds"},
    RL_COLUMNS_WITH_INTERVAL("frame_ms"),
    RL_COLUMNS_WITH_INTERVAL("time_to_uniforms"),
    RL_COLUMNS_WITH_INTERVAL("time_to_literals"),
    {"frames", RL_COLUMN_VALUE, "frames"},
    {"time_precision", RL_COLUMN_VALUE, "time_precision"},
    {"time_capped", RL_COLUMN_VALUE, "time_capped"},
    {"worst", RL_COLUMN_VALUE, "worst"},
    {"draws", RL_COLUMN_VALUE, "draws"},
    {"programs", RL_COLUMN_VALUE, "programs"},
    {"textures", RL_COLUMN_VALUE, "textures"},
    {"stencil", RL_COLUMN_VALUE, "stencil"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_table tables[] = {
    {"bare",
     "A scene of diffuse and phong by its plan and by programs in bare OpenGL: time, and the work done", "",
     columns, sizeof columns / sizeof columns[0]},
};

static const struct rl_figure figures[] = {
    {"ratio",
     "Frame time over that of the bare program with uniforms, paired by round, 95 % intervals. uniforms "
     "again: the same program once more, so what it differs by is chance. Grey: what the plan may take. "
     "Below, the plan's time over that of the program with literals: what is above 1 there is what baking a "
     "scene's constants into the shader would gain."},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
    {.name = "rounds", .kind = RL_SWEEP_WHOLE, .low = 6, .high = 100000},
};

static const char *const scenes[] = {"lamps", NULL};

static const struct rl_cost costs[] = {{.pattern = "", .picture = 0.004, .pixel = 0.014}};

const struct rl_study rl_study_bare = {
    .name = "bare",
    .summary = "a scene of diffuse and phong by its plan against a program in bare OpenGL written for it",
    .text = "What does it cost that a scene may ask for anything? The scene, with no effects left but "
            "diffuse and "
            "phong, is drawn as its plan says, and by a program written by hand for that scene alone: one "
            "shader, its own buffers, a frame buffer of the same format, numbers of material and lights as "
            "uniforms. A second program has these numbers as literals: what a compiler makes of them is what "
            "writing a scene into its shader would gain. Arms take turns in random order, frame by frame.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .fits = rl_bare_fits,
    .plan = plan,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_bare_measure,
    .judge = rl_bare_judge,
};
