/* The study `samples`: what do more samples buy, in error and in time, and what can they not buy?
 *
 * Methods regular and random over N against the reference, at several R_r, with the paper's settings (8-bit normal map,
 * environment map of 256 texels) and with fine ones (float normals, a large float map). Random with several seeds, so that
 * noise and bias come apart. Then N is held and the environment map's size varied: what is left is the floor that samples
 * cannot remove, and a second reference, which sees the lights from the object's centre, tells the map's texels from its single
 * position. */
#include "studies/samples.h"
#include "studies/seeds.h"

#include <stdbool.h>
#include <stdio.h>

/* Both methods at each R_r and N. Where there are rounds, all N of one R_r are one group, so that their clocks run side by
 * side, beside a frame without a highlight and random 4 once more; else each N is a group of its own, soon done. Lists end with 0. */
struct block {
    bool fine; /* settings: the paper's, or fine ones */
    double rr[8];
    int samples[16];
    int most_regular; /* N of the fixed patterns that are drawn: large ones are dear */
    int seeds, rounds;
};

struct grid {
    int width, height, seeds; /* seeds: of the floor */
    double tolerance;
    struct block block[6]; /* one without samples ends the list */
    int fine_env, floor_env[12], floor_samples;
};

#define EVERY_N                                                                                              \
    {                                                                                                        \
        1, 2, 3, 4, 5, 8, 13, 16, 32, 64, 128, 256, 512, 1024                                                \
    }

/* At R_r = 300 few pixels are bright, and their noise needs more seeds to be known as well. */
static const struct grid grids[] = {
    [RL_GRID_QUICK] = {.width = 160,
                       .height = 120,
                       .seeds = 4,
                       .tolerance = 1e-4,
                       .block = {{false, {3}, {1, 4, 13, 32, 64}, 64, 4, 0},
                                 {false, {30}, {1, 3, 4, 5, 13, 32, 64}, 64, 4, 6}},
                       .fine_env = 512,
                       .floor_env = {16, 64, 256, 512},
                       .floor_samples = 64},
    [RL_GRID_DEFAULT] =
        {.width = 96,
         .height = 72,
         .seeds = 16,
         .tolerance = 1e-4,
         .block = {{false, {3}, {1, 2, 4, 8, 13, 16, 32, 64, 256}, 64, 16, 0},
                   {false, {300}, {1, 2, 4, 8, 13, 16, 32, 64}, 64, 24, 0},
                   {false, {300}, {256}, 64, 16, 0},
                   {false, {30}, {1, 2, 3, 4, 5, 8, 13, 16, 32, 64}, 64, 16, 30},
                   {false, {30}, {256, 1024}, 64, 16, 0}, /* timed they would be most of the time */
                   {true, {30}, {1, 4, 16, 64, 256}, 64, 16, 0}},
         .fine_env = 1024,
         .floor_env = {16, 64, 256, 512, 2048},
         .floor_samples = 64},
    [RL_GRID_FULL] = {.width = 640,
                      .height = 480,
                      .seeds = 16,
                      .tolerance = 1e-5,
                      .block = {{false, {1, 3, 10, 30, 100, 300, 1000}, EVERY_N, 1024, 16, 30},
                                {true, {1, 3, 10, 30, 100, 300, 1000}, EVERY_N, 1024, 16, 0}},
                      .fine_env = 2048,
                      .floor_env = {8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096},
                      .floor_samples = 1024},
};

static const double floor_rr = 30.0;

/* What the cases of one group have in common. */
struct point {
    struct rl_run *run;
    const struct rl_place *place;
    const struct grid *grid;
    const struct block *block;
    double rr;
    int group;
    struct rl_error *error;
};

static bool add(const struct point *p, const char *series, const char *setting, const char *method,
                int samples, int seeds)
{
    const struct grid *g = p->grid;
    char maps[96];
    snprintf(maps, sizeof maps, "normal_bits=%s env_size=%d env_format=%s", p->block->fine ? "float" : "8",
             p->block->fine ? g->fine_env : 256, p->block->fine ? "rgba16f" : "rgba8");
    return rl_run_add(p->run, p->place, p->group, p->error,
                      "series=%s setting=%s method=%s samples=%d rr=%g %s seeds=%d rounds=%d width=%d "
                      "height=%d tolerance=%g",
                      series, setting, method, samples, p->rr, maps, seeds, p->block->rounds, g->width,
                      g->height, g->tolerance) != NULL;
}

/* N normals by both methods. */
static bool add_methods(const struct point *p, int samples)
{
    const char *setting = p->block->fine ? "fine" : "paper";
    bool ok = samples > p->block->most_regular || add(p, "methods", setting, "regular", samples, 1);
    return ok && add(p, "methods", setting, "random", samples, p->block->seeds);
}

static int plan_floor(struct rl_run *run, const struct rl_place *place, const struct grid *g, int group,
                      int env_size, struct rl_error *error)
{
    return rl_run_add(
               run, place, group, error,
               "series=floor setting=floor method=random samples=%d rr=%g normal_bits=float env_size=%d "
               "env_format=rgba16f seeds=%d rounds=0 width=%d height=%d tolerance=%g",
               g->floor_samples, floor_rr, env_size, g->seeds, g->width, g->height, g->tolerance)
               ? RL_OK
               : RL_ERR_SYSTEM;
}

/* R_r outermost: the cases of one reference together. */
static bool add_block(struct point *p)
{
    const struct block *b = p->block;
    bool ok = true;
    for (int r = 0; b->rr[r] > 0.0; r++) {
        p->rr = b->rr[r];
        for (int n = 0; b->samples[n] > 0 && ok; n++) {
            ok = add_methods(p, b->samples[n]);
            p->group += b->rounds == 0;
        }
        if (ok && b->rounds > 0)
            ok = add(p, "time", "none", "none", 0, 1) && add(p, "time", "again", "random", 4, 1);
        p->group += b->rounds > 0;
    }
    return ok;
}

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    const size_t n_blocks = sizeof g->block / sizeof g->block[0];
    struct point p = {.run = run, .place = place, .grid = g, .group = group, .error = error};
    bool ok = true;
    for (p.block = g->block; p.block < g->block + n_blocks && p.block->samples[0] > 0 && ok; p.block++)
        ok = add_block(&p);
    int status = ok ? RL_OK : RL_ERR_SYSTEM;
    for (int e = 0; g->floor_env[e] > 0 && status == RL_OK; e++)
        status = plan_floor(run, place, g, p.group++, g->floor_env[e], error);
    return status;
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
    RL_COLUMNS_WITH_INTERVAL("rmse"),
    RL_COLUMNS_WITH_INTERVAL("noise"),
    RL_COLUMNS_WITH_INTERVAL("floor"),
    RL_COLUMNS_WITH_INTERVAL("floor_centre"),
    {"parallax", RL_COLUMN_VALUE, "parallax"},
    RL_COLUMNS_WITH_INTERVAL("bias"),
    RL_COLUMNS_WITH_INTERVAL("mae"),
    RL_COLUMNS_WITH_INTERVAL("relmse"),
    {"max", RL_COLUMN_VALUE, "max"},
    RL_COLUMNS_WITH_INTERVAL("bias2"),
    RL_COLUMNS_WITH_INTERVAL("variance"),
    RL_COLUMNS_WITH_INTERVAL("frame_ms"),
    RL_COLUMNS_WITH_INTERVAL("above_baseline_ms"),
    RL_COLUMNS_WITH_INTERVAL("time_to_random4"),
    {"frames", RL_COLUMN_VALUE, "frames"},
    {"time_precision", RL_COLUMN_VALUE, "time_precision"},
    {"time_capped", RL_COLUMN_VALUE, "time_capped"},
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
    {"split",
     "Random sampling taken apart: noise (what more samples remove) and floor (what "
     "they do not). Floor − parallax: "
     "against a reference that sees the lights from the object's centre. The paper's settings: 8-bit "
     "normals, map of 256 "
     "texels; fine: float normals, large half-float map." RL_CAPTION_EDGE},
    {"floor", "What no sample removes, against the environment map's size, at large N and with float "
              "normals. The map has two faults: "
              "its texels, and its single position, the object's centre, from which the lights are seen for "
              "every point (parallax). "
              "Against a reference that sees the lights from there too, only the texels' error is left, and "
              "it falls." RL_CAPTION_EDGE},
    {"time", "Error against time: down and left is better. Each point is a number of samples; times are "
             "medians of interleaved "
             "frames. Bars: 95 % intervals, of the time and, of random, over seeds."},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    {.name = "samples",
     .of = "series=methods",
     .kind = RL_SWEEP_WHOLE,
     .low = 1,
     .high = 1024,
     .together = 28},
    {.name = "samples", .of = "series=floor", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 1024},
    RL_SWEEP_RR(NULL),
    RL_SWEEP_ENV_SIZE("series=floor"),
    RL_SWEEP_SEEDS("series=methods method=random"),
    RL_SWEEP_SEEDS("series=floor"),
    {.name = "rounds", .of = "series=methods", .kind = RL_SWEEP_WHOLE, .low = 0, .high = 100000},
    {.name = "rounds", .of = "series=time", .kind = RL_SWEEP_WHOLE, .low = 0, .high = 100000},
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
    RL_SWEEP_TOLERANCE(NULL),
};

static const char *const scenes[] = {"teapot-star", "sphere-quad", "three-lights", NULL};

static const struct rl_cost costs[] = {{.pattern = "", .picture = 0.0055, .sample = 0.023}};

const struct rl_study rl_study_samples = {
    .name = "samples",
    .summary = "method x number of samples against error and time; noise and bias apart",
    .text = "The highlight by fixed patterns (regular) and by random normals from a baked normal map "
            "(random) is compared with the "
            "reference, which integrates the same highlight on the true polygons in double precision. Errors "
            "are of linear "
            "radiance over all pixels of the foreground (in teapot-star the dull table too), 1 being full "
            "scale. With several seeds the squared error "
            "splits into variance "
            "(noise) and bias squared (floor).",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .plan = plan,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .check = rl_seeds_check,
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_samples_measure,
    .judge = rl_samples_judge,
};
