/* The study `effects`: what each effect costs and what it is worth. Every effect of the table, every highlight of the GPU, attenuation, the
 * spheres and culling, one by one: added to a bare scene, removed from a full one. */
#include "studies/effects.h"

#include "studies/features.h"

static const struct grid {
    int width, height, rounds;
} grids[] = {
    [RL_GRID_QUICK] = {80, 60, 6},
    [RL_GRID_DEFAULT] = {240, 180, 30},
    [RL_GRID_FULL] = {640, 480, 300},
};

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    static const char format[] = "feature=%s kind=%s width=%d height=%d samples=0 rounds=%d";
    const struct grid *g = &grids[grid];
    struct rl_feature feature[RL_FEATURES_MAX];
    size_t n = rl_features_list(feature);
    if (!rl_run_add(run, place, group, error, format, "all", "base", g->width, g->height, g->rounds))
        return RL_ERR_SYSTEM;
    for (size_t i = 0; i < n; i++)
        if (!rl_run_add(run, place, group, error, format, feature[i].name,
                        rl_feature_kind_name(feature[i].kind), g->width, g->height, g->rounds))
            return RL_ERR_SYSTEM;
    return RL_OK;
}

/* clang-format off */
#define BOTH(what) \
    {"added_" what, RL_COLUMN_VALUE, "added_" what}, {"removed_" what, RL_COLUMN_VALUE, "removed_" what}
/* clang-format on */

static const struct rl_column columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"feature", RL_COLUMN_TEXT, "feature"},
    {"kind", RL_COLUMN_TEXT, "kind"},
    {"row", RL_COLUMN_VALUE, "row"},
    {"named", RL_COLUMN_VALUE, "named"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    {"samples", RL_COLUMN_NUMBER, "samples"},
    {"rounds", RL_COLUMN_NUMBER, "rounds"},
    RL_COLUMNS_WITH_INTERVAL("added_ms"),
    RL_COLUMNS_WITH_INTERVAL("removed_ms"),
    {"time_added_clear", RL_COLUMN_VALUE, "time_added_clear"},
    {"time_removed_clear", RL_COLUMN_VALUE, "time_removed_clear"},
    BOTH("draws"),
    BOTH("triangles"),
    BOTH("bytes"),
    BOTH("textures"),
    BOTH("programs"),
    BOTH("modules"),
    {"rmse", RL_COLUMN_VALUE, "rmse"},
    {"max", RL_COLUMN_VALUE, "max"},
    {"share", RL_COLUMN_VALUE, "share"},
    RL_COLUMNS_WITH_INTERVAL("full_ms"),
    RL_COLUMNS_WITH_INTERVAL("bare_ms"),
    {"floor_ms", RL_COLUMN_VALUE, "floor_ms"},
    RL_COLUMNS_WITH_INTERVAL("time_zero"),
    {"zero_work", RL_COLUMN_VALUE, "zero_work"},
    RL_COLUMNS_WITH_INTERVAL("time_sum"),
    {"frames", RL_COLUMN_VALUE, "frames"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_table tables[] = {
    {"effects",
     "Each effect, highlight and switch: what it adds to a bare scene and what its removal saves of the full "
     "one, "
     "and the error without it",
     "", columns, sizeof columns / sizeof columns[0]},
};

static const struct rl_figure figures[] = {
    {"price",
     "Price: what each adds to the frame of the bare scene (upper bar), and what its removal saves of the "
     "full one (lower bar), with 95 % intervals. Grey: two arms of the same work differ by as much. Below 0 "
     "it "
     "saves time. Benefit: the error of the full scene without it, RMSE and worst pixel over the "
     "foreground."},
};

/* What tells cases apart is not among them. */
static const struct rl_sweep sweeps[] = {
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
    {.name = "samples", .kind = RL_SWEEP_WHOLE, .low = 0, .high = 1024},
    {.name = "rounds", .kind = RL_SWEEP_WHOLE, .low = 6, .high = 100000},
};

static const char *const scenes[] = {"everything", NULL};

static const struct rl_cost costs[] = {{.pattern = "", .picture = 0.018, .pixel = 0.02}};

const struct rl_study rl_study_effects = {
    .name = "effects",
    .summary = "price and benefit of every effect, highlight, attenuation, spheres and culling, one by one",
    .text = "What does each effect cost, and what is it worth? It is added to the scene without any effect, "
            "and removed from "
            "the scene with all of them: the difference in draws, triangles, bytes, textures, programs, "
            "modules and "
            "milliseconds is its price. The error of the scene without it against the scene with it is its "
            "benefit. "
            "What acts on highlights (fresnel, attenuation, sphere) is added to a scene that has them. What "
            "the scene does "
            "not name is put on one of its materials, in the place of what it excludes. Arms take turns in "
            "random order, "
            "frame by frame; two arms of the same work tell what is chance.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .fits = rl_effects_fits,
    .plan = plan,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_effects_measure,
    .judge = rl_effects_judge,
};
