/* The study `frame`: the tangent frame as Kimura and Tokoi print it has tangents of length sqrt(n_y^2 + n_z^2). How much does that
 * narrow a lobe, where on the sphere of normals, and what becomes of highlights? */
#include "studies/frame.h"

/* Lists end with 0 or, of scenes' R_r, with what the rest is. */
struct grid {
    double lobe_rr[8], light_rr[8], scene_rr[8];
    int lobe_points, lobe_samples, map_columns;
    int light_points;
    int width, height;
};

static const struct grid grids[] = {
    [RL_GRID_QUICK] = {.lobe_rr = {3, 30},
                       .light_rr = {3, 30},
                       .scene_rr = {30},
                       .lobe_points = 300,
                       .lobe_samples = 400,
                       .map_columns = 36,
                       .light_points = 100,
                       .width = 80,
                       .height = 60},
    [RL_GRID_DEFAULT] = {.lobe_rr = {1, 3, 30, 300},
                         .light_rr = {1, 3, 10, 30, 100},
                         .scene_rr = {3, 30, 300},
                         .lobe_points = 1000,
                         .lobe_samples = 1200,
                         .map_columns = 60,
                         .light_points = 400,
                         .width = 96,
                         .height = 72},
    [RL_GRID_FULL] = {.lobe_rr = {1, 3, 10, 30, 100, 300, 1000},
                      .light_rr = {1, 3, 10, 30, 100, 300, 1000},
                      .scene_rr = {1, 3, 10, 30, 100, 300, 1000},
                      .lobe_points = 4000,
                      .lobe_samples = 4000,
                      .map_columns = 144,
                      .light_points = 2000,
                      .width = 640,
                      .height = 480},
};

static const double map_rr = 30.0;

/* Where the mirror direction meets the light, whose edge is 0.245 radians from its middle. */
static const struct {
    const char *name;
    double beside_rad;
} place_of_light[] = {{"middle", 0.0}, {"inside", 0.2}, {"outside", 0.3}, {"far", 0.5}};

enum { PLACES = sizeof place_of_light / sizeof place_of_light[0] };

static int plan_alone(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                      struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    for (int r = 0; g->lobe_rr[r] > 0.0; r++)
        if (!rl_run_add(run, place, group++, error, "series=lobe rr=%g points=%d samples=%d columns=%d",
                        g->lobe_rr[r], g->lobe_points, g->lobe_samples,
                        g->lobe_rr[r] == map_rr ? g->map_columns : 0))
            return RL_ERR_SYSTEM;
    for (int r = 0; g->light_rr[r] > 0.0; r++, group++)
        for (int p = 0; p < PLACES; p++)
            if (!rl_run_add(run, place, group, error,
                            "series=light place=%s beside_rad=%g rr=%g points=%d tolerance=1e-06",
                            place_of_light[p].name, place_of_light[p].beside_rad, g->light_rr[r],
                            g->light_points))
                return RL_ERR_SYSTEM;
    return RL_OK;
}

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    for (int r = 0; g->scene_rr[r] > 0.0; r++)
        if (!rl_run_add(run, place, group++, error, "series=scene rr=%g width=%d height=%d tolerance=0.0001",
                        g->scene_rr[r], g->width, g->height))
            return RL_ERR_SYSTEM;
    return RL_OK;
}

static const struct rl_column lobe_columns[] = {
    {"rr", RL_COLUMN_NUMBER, "rr"},           {"points", RL_COLUMN_NUMBER, "points"},
    {"samples", RL_COLUMN_NUMBER, "samples"}, RL_COLUMNS_WITH_INTERVAL("width"),
    RL_COLUMNS_WITH_INTERVAL("width90"),      RL_COLUMNS_WITH_INTERVAL("against_formula"),
    {"worst", RL_COLUMN_VALUE, "worst"},      RL_COLUMNS_WITH_INTERVAL("half"),
};

static const struct rl_column light_columns[] = {
    {"rr", RL_COLUMN_NUMBER, "rr"},
    {"place", RL_COLUMN_TEXT, "place"},
    {"beside_rad", RL_COLUMN_NUMBER, "beside_rad"},
    {"points", RL_COLUMN_NUMBER, "points"},
    RL_COLUMNS_WITH_INTERVAL("orthonormal"),
    RL_COLUMNS_WITH_INTERVAL("spread"),
    RL_COLUMNS_WITH_INTERVAL("rms"),
    RL_COLUMNS_WITH_INTERVAL("max"),
    RL_COLUMNS_WITH_INTERVAL("mean"),
};

static const struct rl_column scene_columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},           {"rr", RL_COLUMN_NUMBER, "rr"},
    {"width_px", RL_COLUMN_NUMBER, "width"},    {"height_px", RL_COLUMN_NUMBER, "height"},
    RL_COLUMNS_WITH_INTERVAL("rmse"),           RL_COLUMNS_WITH_INTERVAL("max"),
    RL_COLUMNS_WITH_INTERVAL("mean"),           {"moved", RL_COLUMN_VALUE, "moved"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_table tables[] = {
    {"frame_lobe", "Width of the printed frame's lobe over the orthonormal one's, over the sphere of normals",
     "series=lobe", lobe_columns, sizeof lobe_columns / sizeof lobe_columns[0]},
    {"frame_light",
     "The highlight L_o of a square light that turns with the normal: how the printed frame changes it",
     "series=light", light_columns, sizeof light_columns / sizeof light_columns[0]},
    {"frame_scene", "Whole pictures by the reference: the printed frame against the orthonormal one",
     "series=scene", scene_columns, sizeof scene_columns / sizeof scene_columns[0]},
};

static const struct rl_figure figures_alone[] = {
    {"map",
     "Width of the lobe in the printed frame, 1 being right, over the sphere of normals: measured from "
     "sampled normals. "
     "Where N points along +-x the lobe collapses. Curves: widths of 3/4, 1/2 and 1/4 by the formula."},
    {"width",
     "The same against |n_x|: measured at every N of the map, and as tan(delta') = l tan(delta) has it."},
    {"highlight", "What that does to a highlight under a square light that turns with N: L_o in "
                  "the printed frame less L_o in "
                  "an orthonormal one, by where the mirror direction meets the light. Grey: 1/255."},
};

static const struct rl_figure figures[] = {
    {"scene",
     "The whole picture by the reference, printed frame against orthonormal, over R_r. Where few normals "
     "point along +-x the fault hides." RL_CAPTION_EDGE},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    RL_SWEEP_RR(NULL),
    {.name = "points", .of = NULL, .kind = RL_SWEEP_WHOLE, .low = 2, .high = 65536},
    {.name = "samples", .of = "series=lobe", .kind = RL_SWEEP_WHOLE, .low = 10, .high = 65536},
    {.name = "columns", .of = "series=lobe", .kind = RL_SWEEP_WHOLE, .low = 0, .high = 360},
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
    RL_SWEEP_TOLERANCE("series=scene"),
};

static const char *const scenes[] = {"sphere-quad", "teapot-star", "three-lights", NULL};

static const struct rl_cost costs[] = {{.pattern = "series=lobe", .pixel = 90.0, .sample = 0.18},
                                       {.pattern = "", .pixel = 16.0}};

const struct rl_study rl_study_frame = {
    .name = "frame",
    .summary = "the tangent frame as printed against an orthonormal one: width of the lobe, highlight, whole "
               "pictures",
    .text = "The rows that Kimura and Tokoi print for the tangent frame are orthogonal, but the last two "
            "have length "
            "l = sqrt(n_y^2 + n_z^2). Microfacet normals then stand at delta' with tan(delta') = l "
            "tan(delta): the "
            "lobe narrows as N "
            "turns to +-x. Widths are medians of |delta| of sampled normals, each frame's with random "
            "numbers of its own; "
            "highlights are the reference's.",
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
    .measure = rl_frame_measure,
    .judge = rl_frame_judge,
};
