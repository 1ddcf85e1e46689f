/* The study `environment`: what the environment map leaves out. Its texels (size), their format, its single position (parallax),
 * and whether a light that lies across an edge or a corner of the cube is worse off than one in the middle of a face. */
#include "studies/environment.h"

#include <stdio.h>

/* Lists end with 0; the first map size is the base of its series. */
static const struct grid {
    int width, height, samples, seeds;
    double tolerance, rr;
    int size[10], seam_size[4], seam_seeds;
    double away[8];
} grids[] = {
    [RL_GRID_QUICK] = {80, 60, 64, 3, 1e-4, 30, {512, 16, 32, 64, 256}, {256, 32}, 3, {1, 4, 16}},
    [RL_GRID_DEFAULT] =
        {120, 90, 128, 4, 1e-4, 30, {1024, 16, 32, 64, 128, 256, 512}, {1024, 32, 128}, 6, {1, 2, 4, 8, 16}},
    [RL_GRID_FULL] = {320,
                      240,
                      1024,
                      8,
                      1e-5,
                      30,
                      {2048, 16, 32, 64, 128, 256, 512, 1024},
                      {2048, 32, 128},
                      16,
                      {1, 2, 4, 8, 16, 32, 64}},
};

static const char *const formats[] = {"rgba32f", "rgba8", "rgb10a2", "r11g11b10f", "rgba16", "rgba16f"};
static const char *const places[] = {"middle", "edge", "corner"};

static int plan_map(struct rl_run *run, const struct rl_place *place, const struct grid *g, int group,
                    const char *head, int size, const char *format, int seeds, struct rl_error *error)
{
    return rl_run_add(
               run, place, group, error,
               "%s env_size=%d env_format=%s rr=%g method=random samples=%d normal_bits=float seeds=%d "
               "width=%d height=%d tolerance=%g",
               head, size, format, g->rr, g->samples, seeds, g->width, g->height, g->tolerance)
               ? RL_OK
               : RL_ERR_SYSTEM;
}

static int plan_maps(struct rl_run *run, const struct rl_place *place, const struct grid *g, int *group,
                     struct rl_error *error)
{
    int status = RL_OK;
    for (int i = 0; g->size[i] > 0 && status == RL_OK; i++)
        status = plan_map(run, place, g, *group, i ? "series=size base=0" : "series=size base=1", g->size[i],
                          "rgba16f", g->seeds, error);
    ++*group;
    for (size_t i = 0; i < sizeof formats / sizeof formats[0] && status == RL_OK; i++)
        status = plan_map(run, place, g, *group, i ? "series=format base=0" : "series=format base=1", 256,
                          formats[i], g->seeds, error);
    ++*group;
    return status;
}

static int plan_seams(struct rl_run *run, const struct rl_place *place, const struct grid *g, int *group,
                      struct rl_error *error)
{
    int status = RL_OK;
    for (size_t p = 0; p < sizeof places / sizeof places[0]; p++) {
        for (int i = 0; g->seam_size[i] > 0 && status == RL_OK; i++) {
            char head[64];
            snprintf(head, sizeof head, "series=seam base=%d place=%s", i == 0, places[p]);
            status = plan_map(run, place, g, *group, head, g->seam_size[i], "rgba16f", g->seam_seeds, error);
        }
        ++*group;
    }
    return status;
}

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    int status = plan_maps(run, place, g, &group, error);
    if (status == RL_OK)
        status = plan_seams(run, place, g, &group, error);
    for (int i = 0; g->away[i] > 0.0 && status == RL_OK; i++)
        if (!rl_run_add(run, place, group++, error,
                        "series=parallax away=%g rr=%g width=%d height=%d tolerance=%g", g->away[i], g->rr,
                        g->width, g->height, g->tolerance))
            status = RL_ERR_SYSTEM;
    return status;
}

static const struct rl_column columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"series", RL_COLUMN_TEXT, "series"},
    {"base", RL_COLUMN_NUMBER, "base"},
    {"place", RL_COLUMN_TEXT, "place"},
    {"env_size_px", RL_COLUMN_NUMBER, "env_size"},
    {"env_format", RL_COLUMN_TEXT, "env_format"},
    {"away", RL_COLUMN_NUMBER, "away"},
    {"rr", RL_COLUMN_NUMBER, "rr"},
    {"samples", RL_COLUMN_NUMBER, "samples"},
    {"seeds", RL_COLUMN_NUMBER, "seeds"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    RL_COLUMNS_WITH_INTERVAL("rmse_map"),
    RL_COLUMNS_WITH_INTERVAL("floor_map"),
    RL_COLUMNS_WITH_INTERVAL("floor_centre"),
    RL_COLUMNS_WITH_INTERVAL("parallax"),
    {"size", RL_COLUMN_VALUE, "size"},
    {"highlight", RL_COLUMN_VALUE, "highlight"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_table tables[] = {
    {"environment",
     "The environment map's size, format and place of the light in it against larger maps; parallax by the "
     "object's size over the light's distance",
     "", columns, sizeof columns / sizeof columns[0]},
};

static const struct rl_figure figures[] = {
    {"size", "Error by the map's texels, float normals: against pictures of the same seeds by the "
             "largest map, and "
             "against the reference that sees the lights from the object's centre, noise taken out. Bars: 95 "
             "% intervals "
             "over seeds. Grey: 1/255, and a fall in proportion to the texel's size and to its 1.5th "
             "power." RL_CAPTION_EDGE},
    {"format", "Error by the texels' format at 256 texels a face edge, against 32-bit floats. A white "
               "light is exact in every format." RL_CAPTION_EDGE},
    {"parallax",
     "Error by the map's single position, exactly: reference against reference, the lights moved away "
     "and "
     "enlarged so that from the object's centre nothing changes. Grey: 1/255, and a rise in "
     "proportion to the object's size, through the smallest."},
    {"seam",
     "The scene turned so that its first light lies in the middle of a cube's face, across an edge, or "
     "across a corner: error against the largest map."},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    RL_SWEEP_RR(NULL),
    {.name = "away", .of = "series=parallax", .kind = RL_SWEEP_REAL, .low = 0.001, .high = 1e6},
    {.name = "env_size",
     .of = "series=size base=0",
     .kind = RL_SWEEP_WHOLE,
     .low = 8,
     .high = 256,
     .together = 32},
    {.name = "env_size",
     .of = "series=seam base=0",
     .kind = RL_SWEEP_WHOLE,
     .low = 8,
     .high = 256,
     .together = 32},
    {.name = "samples", .of = NULL, .kind = RL_SWEEP_WHOLE, .low = 1, .high = 1024},
    RL_SWEEP_SEEDS(NULL),
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
    RL_SWEEP_TOLERANCE(NULL),
};

static const char *const scenes[] = {"teapot-star", "sphere-quad", "three-lights", NULL};

static const struct rl_cost costs[] = {{.pattern = "series=parallax", .group = 0.008, .pixel = 5.5},
                                       {.pattern = "", .group = 0.009, .pixel = 1.2, .sample = 0.011}};

const struct rl_study rl_study_environment = {
    .name = "environment",
    .summary = "environment map: size, format, parallax, seams and corners of the cube",
    .text =
        "What is lost where lights are looked up in a cube map taken at the object's centre. Texels and "
        "formats "
        "are held against a finer map by pairs of pictures with the same random normals, so that noise drops "
        "out; parallax is taken on the reference, which can see the lights from the centre too. Highlights "
        "only: "
        "the scenes' ambient and diffuse light cannot hide an error, for parallax and seams it is switched "
        "off.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .plan = plan,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .check_scene = rl_environment_check,
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_environment_measure,
    .judge = rl_environment_judge,
};
