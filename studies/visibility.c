/* The study `visibility`: which surface a pixel shows.
 *
 * Depth buffers of 16, 24 and 32 bits against the exact answer, over the ratio of the far plane's distance to the near one's. And back
 * faces: what culling them saves, and whether a pixel changes. */
#include "studies/visibility.h"

/* Lists end with 0. */
static const struct grid {
    int width, height, views;
    double ratio[12];
    int culling_width, culling_height, rounds;
} grids[] = {
    [RL_GRID_QUICK] = {.width = 128,
                       .height = 96,
                       .views = 2,
                       .ratio = {10, 1e3, 1e5, 1e7},
                       .culling_width = 160,
                       .culling_height = 120,
                       .rounds = 6},
    [RL_GRID_DEFAULT] = {.width = 160,
                         .height = 120,
                         .views = 6,
                         .ratio = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7},
                         .culling_width = 240,
                         .culling_height = 180,
                         .rounds = 10},
    [RL_GRID_FULL] = {.width = 640,
                      .height = 480,
                      .views = 8,
                      .ratio = {3e0, 1e1, 3e1, 1e2, 3e2, 1e3, 1e4, 1e5, 1e6, 1e7},
                      .culling_width = 640,
                      .culling_height = 480,
                      .rounds = 100},
};

/* The ratio at which a map is kept: of a near plane that is just put close. */
static const double map_ratio = 1e3;

static int plan_depth(struct rl_run *run, const struct rl_place *place, const struct grid *g, double ratio,
                      int group, struct rl_error *error)
{
    static const struct {
        const char *reversed;
        int bits;
        bool map;
    } arm[] = {{"off", 16, true}, {"off", 24, true}, {"off", 32, false}, {"on", 32, false}};
    for (size_t i = 0; i < sizeof arm / sizeof arm[0]; i++)
        if (!rl_run_add(run, place, group, error,
                        "series=depth ratio=%g depth_bits=%d reversed_depth=%s method=none views=%d width=%d "
                        "height=%d map=%s",
                        ratio, arm[i].bits, arm[i].reversed, g->views, g->width, g->height,
                        arm[i].map && ratio == map_ratio ? "on" : "off"))
            return RL_ERR_SYSTEM;
    return RL_OK;
}

static int plan_culling(struct rl_run *run, const struct rl_place *place, const struct grid *g, int group,
                        struct rl_error *error)
{
    /* 16 bits have no stencil, which sampled highlights need. */
    static const struct {
        const char *method;
        int bits;
        bool timed;
    } kind[] = {{"none", 16, false}, {"none", 24, true}, {"none", 32, false}, {"random", 24, true}};
    static const struct {
        const char *arm, *culling;
    } arm[] = {{"on", "on"}, {"again", "on"}, {"off", "off"}};
    for (size_t k = 0; k < sizeof kind / sizeof kind[0]; k++)
        for (size_t i = 0; i < sizeof arm / sizeof arm[0]; i++)
            if (!rl_run_add(
                    run, place, group + (int)k, error,
                    "series=culling arm=%s culling=%s method=%s samples=4 depth_bits=%d views=%d rounds=%d "
                    "width=%d height=%d",
                    arm[i].arm, arm[i].culling, kind[k].method, kind[k].bits, g->views,
                    kind[k].timed ? g->rounds : 0, g->culling_width, g->culling_height))
                return RL_ERR_SYSTEM;
    return RL_OK;
}

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    int status = RL_OK;
    for (int i = 0; g->ratio[i] > 0.0 && status == RL_OK; i++)
        status = plan_depth(run, place, g, g->ratio[i], group++, error);
    return status == RL_OK ? plan_culling(run, place, g, group, error) : status;
}

static const struct rl_column depth_columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"ratio", RL_COLUMN_NUMBER, "ratio"},
    {"depth_bits", RL_COLUMN_NUMBER, "depth_bits"},
    {"reversed_depth", RL_COLUMN_TEXT, "reversed_depth"},
    {"views", RL_COLUMN_NUMBER, "views"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    RL_COLUMNS_WITH_INTERVAL("sure"),
    RL_COLUMNS_WITH_INTERVAL("wrong"),
    RL_COLUMNS_WITH_INTERVAL("ideal"),
    {"worst", RL_COLUMN_VALUE, "worst"},
    {"wrong_pixels", RL_COLUMN_VALUE, "wrong_pixels"},
    {"missing", RL_COLUMN_VALUE, "missing"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_column culling_columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"arm", RL_COLUMN_TEXT, "arm"},
    {"method", RL_COLUMN_TEXT, "method"},
    {"depth_bits", RL_COLUMN_NUMBER, "depth_bits"},
    {"views", RL_COLUMN_NUMBER, "views"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    {"closed", RL_COLUMN_VALUE, "closed"},
    {"triangles", RL_COLUMN_VALUE, "triangles"},
    {"back_faces", RL_COLUMN_VALUE, "back_faces"},
    {"pixels", RL_COLUMN_VALUE, "pixels"},
    {"changed", RL_COLUMN_VALUE, "changed"},
    {"sure_pixels", RL_COLUMN_VALUE, "sure_pixels"},
    {"changed_sure", RL_COLUMN_VALUE, "changed_sure"},
    RL_COLUMNS_WITH_INTERVAL("frame_ms"),
    RL_COLUMNS_WITH_INTERVAL("time_to_on"),
    RL_COLUMNS_WITH_INTERVAL("above_on_ms"),
    {"frames", RL_COLUMN_VALUE, "frames"},
    {"time_precision", RL_COLUMN_VALUE, "time_precision"},
    {"time_capped", RL_COLUMN_VALUE, "time_capped"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_table tables[] = {
    {"visibility_depth",
     "Depth buffers: the share of pixels that show the wrong surface, by the ratio far/near", "series=depth",
     depth_columns, sizeof depth_columns / sizeof depth_columns[0]},
    {"visibility_culling", "Back faces culled or drawn: triangles, pixels that change, the frame's time",
     "series=culling", culling_columns, sizeof culling_columns / sizeof culling_columns[0]},
};

static const struct rl_figure figures[] = {
    {"wrong", "Share of pixels that show a surface behind the right one, or none, by the distance of the far "
              "plane over that of the "
              "near one, with 95 % intervals over views. Lines: what an ideal depth buffer of so many bits "
              "gets wrong. "
              "Grey: one pixel in a thousand." RL_CAPTION_EDGE},
    {"worst", "How far behind the right surface a wrong one lies at most, in steps of the depth buffer "
              "there, which are "
              "z^2/(near 2^b) of whole numbers. Grey: one step, what an ideal one may be off."},
    {"map", "Where the wrong surface shows with 16 and with 24 bits, far/near 1000. Grey: not judged, for "
            "the nearest surface is another "
            "one within 1/64 of a pixel."},
    {"culling",
     "Frame time over that with back faces culled, with 95 % intervals: drawn, and culled once more (A/A)."},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    {.name = "ratio", .of = "series=depth", .kind = RL_SWEEP_REAL, .low = 1.01, .high = 1e12},
    {.name = "views", .of = NULL, .kind = RL_SWEEP_WHOLE, .low = 1, .high = 64},
    {.name = "samples", .of = "series=culling", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 1024},
    {.name = "rounds", .of = "series=culling", .kind = RL_SWEEP_WHOLE, .low = 0, .high = 100000},
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
};

/* Neither lights nor highlights are asked for: whether anything is in view shows when it is measured. */
static int fits(const struct rl_scene *scene, struct rl_error *error)
{
    (void)scene;
    (void)error;
    return RL_OK;
}

static const char *const scenes[] = {"layers", "three-lights", "lamps", NULL};

static const struct rl_cost costs[] = {{.pattern = "", .group = 0.028, .picture = 0.0055, .pixel = 0.033}};

const struct rl_study rl_study_visibility = {
    .name = "visibility",
    .summary =
        "depth buffers of 16, 24 and 32 bits over near/far: pixels that show the wrong surface; what culling "
        "back faces saves",
    .text =
        "Which triangle each pixel shows, read from the GPU, against the exact one in double precision. "
        "Pixels whose "
        "nearest triangle is another one 1/64 of a pixel off their centre, diagonally either way, are not "
        "judged: there coverage decides, not depth. The far plane is the scene's, the near one is moved "
        "towards the "
        "eye. The exact answer is also rounded as an ideal depth buffer of so many bits would: what is wrong "
        "beyond "
        "that comes from single precision in transforming and interpolating. Back faces: frames with and "
        "without "
        "culling take turns, and their pictures are compared bit by bit. Each view is from a place of its "
        "own "
        "beside the camera's.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .fits = fits,
    .plan = plan,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_visibility_measure,
    .judge = rl_visibility_judge,
};
