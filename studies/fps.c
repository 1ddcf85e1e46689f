/* The study `fps`: the paper's Table 1 again. Plain highlight, 13 regular normals, 4 random normals, at 640x480 with an
 * environment map of 256 texels a face: 530, 28 and 38 frames a second on a GeForce FX 5200. And what else costs how much: pixels,
 * samples, the environment map's size, objects, roughnesses, and the exhaustive way.
 *
 * All arms of a series take turns frame by frame in random order; every frame is finished before the clock stops. Beside the paper's
 * methods there are an arm without highlight (what a frame costs anyway) and random 4 once more (A/A: how much two arms of the
 * same work differ, below which no difference counts). */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/fps.h"

struct size {
    int width, height;
};

/* Least rounds of a series, six for there to be an interval at all, and the cap of their seconds. Frames of the default grid are at least 30; making maps and exhaustive, on
 * the CPU, take so much longer and scatter so much less that they have fewer, which their claims' notes say. Where the picture's
 * size is not what is studied (environment, objects, roughness, exhaustive) it is small. */
struct effort {
    int rounds;
    double seconds;
};

/* Lists end with 0. At `heavy` of the sizes, from the smallest on, regular 13 is measured too, which would take longest. */
static const struct grid {
    struct size table_size;
    bool every_scene; /* the other series too; else they are measured on a run's first scene */
    struct effort table, sizes, environments, many, maps, all_texels;
    struct size size[10];
    int heavy;
    struct size scene; /* of environment, objects and roughness */
    int env_size[8], objects[10], roughnesses[8], normal_size;
    struct {
        struct size size;
        int env_size;
    } exhaustive[10];
} grids[] = {
    [RL_GRID_QUICK] = {.table_size = {160, 120},
                       .table = {10, 1.0},
                       .sizes = {6, 0.3},
                       .environments = {6, 0.3},
                       .many = {6, 0.3},
                       .maps = {6, 0.3},
                       .all_texels = {6, 0.3},
                       .size = {{40, 30}, {80, 60}, {160, 120}},
                       .heavy = 2,
                       .scene = {80, 60},
                       .env_size = {32, 64, 128},
                       .objects = {1, 2, 3},
                       .roughnesses = {1, 2, 4},
                       .normal_size = 64,
                       .exhaustive = {{{40, 30}, 16}, {{40, 30}, 64}, {{80, 60}, 16}, {{80, 60}, 32}}},
    [RL_GRID_DEFAULT] = {.table_size = {640, 480},
                         .table = {30, 2.5},
                         .sizes = {30, 1.5},
                         .environments = {30, 1.0},
                         .many = {30, 1.0},
                         .maps = {15, 0.5},
                         .all_texels = {12, 1.0},
                         .size = {{320, 240}, {640, 480}, {1920, 1080}},
                         .heavy = 2,
                         .scene = {160, 120},
                         .env_size = {64, 256, 1024},
                         .objects = {1, 3, 6},
                         .roughnesses = {1, 2, 4},
                         .normal_size = 512,
                         .exhaustive = {{{80, 60}, 32},
                                        {{80, 60}, 128},
                                        {{80, 60}, 256},
                                        {{160, 120}, 32},
                                        {{160, 120}, 256}}},
    [RL_GRID_FULL] = {.table_size = {640, 480},
                      .every_scene = true,
                      .table = {300, 120.0},
                      .sizes = {30, 60.0},
                      .environments = {30, 60.0},
                      .many = {30, 60.0},
                      .maps = {30, 60.0},
                      .all_texels = {30, 60.0},
                      .size = {{320, 240}, {640, 480}, {800, 600}, {1024, 768}, {1280, 960}, {1920, 1080}},
                      .heavy = 6,
                      .scene = {640, 480},
                      .env_size = {64, 128, 256, 512, 1024},
                      .objects = {1, 2, 3, 4, 5, 6, 8, 10},
                      .roughnesses = {1, 2, 3, 4},
                      .normal_size = 512,
                      .exhaustive = {{{160, 120}, 32},
                                     {{160, 120}, 128},
                                     {{160, 120}, 256},
                                     {{320, 240}, 32},
                                     {{320, 240}, 128},
                                     {{320, 240}, 256},
                                     {{640, 480}, 64}}},
};

enum { TABLE_ENV_SIZE = 256 };

/* Cases at work. */
struct planning {
    struct rl_run *run;
    const struct rl_place *place;
    const struct grid *grid;
    const char *series;
    const struct effort *effort;
    int group;
    struct rl_error *error;
    int status;
};

/* `extra`: "" or " key=value". */
static void add_case(struct planning *p, const char *arm, const char *method, int samples, int env_size,
                     const char *extra, struct size size)
{
    if (p->status == RL_OK &&
        !rl_run_add(p->run, p->place, p->group, p->error,
                    "arm=%s series=%s method=%s samples=%d normal_bits=8 env_size=%d env_format=rgba8%s "
                    "rounds=%d seconds=%g width=%d height=%d",
                    arm, p->series, method, samples, env_size, extra, p->effort->rounds, p->effort->seconds,
                    size.width, size.height))
        p->status = RL_ERR_SYSTEM;
}

static void begin(struct planning *p, const char *series, const struct effort *effort)
{
    p->series = series;
    p->effort = effort;
    p->group++;
}

static void plan_table(struct planning *p)
{
    struct size size = p->grid->table_size;
    begin(p, "table1", &p->grid->table);
    add_case(p, "none", "none", 0, TABLE_ENV_SIZE, "", size);
    add_case(p, "plain", "plain", 0, TABLE_ENV_SIZE, "", size);
    add_case(p, "regular-13", "regular", 13, TABLE_ENV_SIZE, "", size);
    add_case(p, "random-4", "random", 4, TABLE_ENV_SIZE, "", size);
    add_case(p, "random-4-again", "random", 4, TABLE_ENV_SIZE, "", size);
    add_case(p, "environment", "random", 4, TABLE_ENV_SIZE, "", size);
}

/* Other sample counts than the paper's at the smallest size, or at all of the full grid: a sample and what a pixel costs anyway are
 * told apart by them. */
static void plan_sizes(struct planning *p)
{
    const struct grid *g = p->grid;
    begin(p, "size", &g->sizes);
    for (int i = 0; g->size[i].width > 0; i++) {
        struct size size = g->size[i];
        add_case(p, "none", "none", 0, TABLE_ENV_SIZE, "", size);
        add_case(p, "plain", "plain", 0, TABLE_ENV_SIZE, "", size);
        add_case(p, "random-4", "random", 4, TABLE_ENV_SIZE, "", size);
        if (i == 0)
            add_case(p, "random-4-again", "random", 4, TABLE_ENV_SIZE, "", size);
        if (i < g->heavy)
            add_case(p, "regular-13", "regular", 13, TABLE_ENV_SIZE, "", size);
        if (i == 0 || g->every_scene) {
            add_case(p, "random-1", "random", 1, TABLE_ENV_SIZE, "", size);
            add_case(p, "random-16", "random", 16, TABLE_ENV_SIZE, "", size);
            add_case(p, "regular-4", "regular", 4, TABLE_ENV_SIZE, "", size);
            add_case(p, "regular-25", "regular", 25, TABLE_ENV_SIZE, "", size);
        }
    }
}

static void plan_environments(struct planning *p)
{
    const struct grid *g = p->grid;
    begin(p, "environment", &g->environments);
    add_case(p, "none", "none", 0, g->env_size[0], "", g->scene);
    for (int i = 0; g->env_size[i] > 0; i++) {
        add_case(p, "random-4", "random", 4, g->env_size[i], "", g->scene);
        add_case(p, "environment", "random", 4, g->env_size[i], "", g->scene);
    }
    add_case(p, "random-4-again", "random", 4, g->env_size[0], "", g->scene);
}

static void plan_objects(struct planning *p)
{
    const struct grid *g = p->grid;
    char extra[64];
    begin(p, "objects", &g->many);
    for (int i = 0; g->objects[i] > 0; i++) {
        snprintf(extra, sizeof extra, " objects=%d", g->objects[i]);
        add_case(p, "none", "none", 0, TABLE_ENV_SIZE, extra, g->scene);
        add_case(p, "random-4", "random", 4, TABLE_ENV_SIZE, extra, g->scene);
        add_case(p, "environment", "random", 4, TABLE_ENV_SIZE, extra, g->scene);
        if (i == 0)
            add_case(p, "random-4-again", "random", 4, TABLE_ENV_SIZE, extra, g->scene);
    }
}

static void plan_roughnesses(struct planning *p)
{
    const struct grid *g = p->grid;
    char extra[64], margin[80];
    begin(p, "roughness", &g->many);
    for (int i = 0; g->roughnesses[i] > 0; i++) {
        snprintf(extra, sizeof extra, " roughnesses=%d", g->roughnesses[i]);
        snprintf(margin, sizeof margin, "%s margin=0.5", extra);
        if (i == 0) {
            add_case(p, "none", "none", 0, TABLE_ENV_SIZE, extra, g->scene);
            add_case(p, "random-4-again", "random", 4, TABLE_ENV_SIZE, extra, g->scene);
        }
        add_case(p, "random-4", "random", 4, TABLE_ENV_SIZE, extra, g->scene);
        add_case(p, "random-4-margin", "random", 4, TABLE_ENV_SIZE, margin, g->scene);
    }
}

/* Apart from the frames, since baking takes far longer than a frame. The picture's size does not enter. */
static void plan_maps(struct planning *p)
{
    const struct grid *g = p->grid;
    char extra[80];
    begin(p, "maps", &g->maps);
    for (int i = 0; g->roughnesses[i] > 0; i++) {
        snprintf(extra, sizeof extra, " roughnesses=%d normal_size=%d", g->roughnesses[i], g->normal_size);
        add_case(p, "normal-maps", "random", 4, TABLE_ENV_SIZE, extra, g->scene);
    }
}

static void plan_exhaustive(struct planning *p)
{
    const struct grid *g = p->grid;
    begin(p, "exhaustive", &g->all_texels);
    for (int i = 0; g->exhaustive[i].env_size > 0; i++) {
        struct size size = g->exhaustive[i].size;
        if (i == 0 || size.width != g->exhaustive[i - 1].size.width) {
            add_case(p, "none", "none", 0, TABLE_ENV_SIZE, "", size);
            add_case(p, "random-4", "random", 4, TABLE_ENV_SIZE, "", size);
        }
        add_case(p, "exhaustive", "exhaustive", 1, g->exhaustive[i].env_size, "", size);
    }
}

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    struct planning p = {.run = run,
                         .place = place,
                         .grid = &grids[grid],
                         .group = group - 1,
                         .error = error,
                         .status = RL_OK};
    plan_table(&p);
    if (group == 0 || p.grid->every_scene) {
        plan_sizes(&p);
        plan_environments(&p);
        plan_objects(&p);
        plan_roughnesses(&p);
        plan_maps(&p);
        plan_exhaustive(&p);
    }
    return p.status;
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
    {"series", RL_COLUMN_TEXT, "series"},
    {"objects", RL_COLUMN_NUMBER, "objects"},
    {"roughnesses", RL_COLUMN_NUMBER, "roughnesses"},
    {"rounds", RL_COLUMN_NUMBER, "rounds"},
    {"cap_s", RL_COLUMN_NUMBER, "seconds"},
    {"time_precision", RL_COLUMN_VALUE, "time_precision"},
    {"time_precise", RL_COLUMN_VALUE, "time_precise"},
    {"time_capped", RL_COLUMN_VALUE, "time_capped"},
    {"drawn_px", RL_COLUMN_VALUE, "drawn_px"},
    {"env_maps", RL_COLUMN_VALUE, "env_maps"},
    {"normal_maps", RL_COLUMN_VALUE, "normal_maps"},
    {"normal_size_px", RL_COLUMN_NUMBER, "normal_size"},
    {"texel_normals", RL_COLUMN_VALUE, "texel_normals"},
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
    {"scaling",
     "Time above the frame without highlight by what the highlight pass draws: pixels times normals, for all "
     "picture sizes and sample counts. Lines: a + b x pixels x samples, fitted to each method; where a mark "
     "is off its line, pixels cost beside their samples." RL_CAPTION_EDGE},
    {"environment",
     "The environment map's size: the pass that draws the map, with its fitted a + b x texels, and the frame "
     "of random 4 that looks it up."},
    {"objects",
     "Objects of as many pixels together, each with an environment map of its own: the frame without "
     "highlight, what random 4 adds to it (it draws the objects once more), and the pass that draws all "
     "maps. Bars: 95 % "
     "intervals. Lines: a + b x objects; of what random 4 adds, a x pixels x samples + b x objects."},
    {"roughness", "Roughnesses among four objects, a normal map each: what random 4 adds to the frame "
                  "without highlight, and the same "
                  "with bounding spheres of margin 0.5. Bars: 95 % intervals. Lines: a + b x roughnesses."},
    {"maps", "Normal maps, one a roughness: time to bake and upload them all, once, when a scene is set up. "
             "Line: a + b x "
             "roughnesses."},
    {"exhaustive", "Every texel of the map at every pixel, on the CPU: time of a frame by texel-normals, one "
                   "line for each picture "
                   "size: a + b x pixels + c x texel-normals (sizes between have no line). Beyond the marks "
                   "it is extrapolation."},
};

static const char *const figure_patterns[] = {
    "series=table1",  "series=table1",    "series=size", "series=environment",
    "series=objects", "series=roughness", "series=maps", "series=exhaustive",
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    {.name = "objects",
     .of = "series=objects",
     .kind = RL_SWEEP_WHOLE,
     .low = 1,
     .high = 1000,
     .together = 16},
    {.name = "roughnesses",
     .of = "series=roughness",
     .kind = RL_SWEEP_WHOLE,
     .low = 1,
     .high = 1000,
     .together = 16},
    {.name = "env_size",
     .of = "series=environment",
     .kind = RL_SWEEP_WHOLE,
     .low = 8,
     .high = 4096,
     .together = 16},
    {.name = "normal_bits", .of = NULL, .kind = RL_SWEEP_WORD, .words = rl_sweep_normal_bits},
    {.name = "rounds", .of = NULL, .kind = RL_SWEEP_WHOLE, .low = 6, .high = 100000},
    {.name = "seconds", .of = NULL, .kind = RL_SWEEP_REAL, .low = 0.001, .high = 1e5},
    RL_SWEEP_PIXELS("width", "series=table1"),
    RL_SWEEP_PIXELS("height", "series=table1"),
};

static const char *const scenes[] = {"teapot-star", "sphere-quad", "three-lights", NULL};

static const struct rl_cost costs[] = {
    {.pattern = "series=exhaustive", .group = 0.36, .picture = 0.0022, .pixel = 0.54},
    {.pattern = "", .picture = 0.0035, .sample = 0.0027, .second = 0.06}};

const struct rl_study rl_study_fps = {
    .name = "fps",
    .summary = "frames a second of plain, regular 13 and random 4: the paper's Table 1; what costs how much",
    .text =
        "The three highlights of the paper's Table 1, beside a frame without highlight (none), a second "
        "arm of the same random 4 (A/A) and the pass that renders the environment map; then cost models by "
        "picture size and samples, the map's size, objects, roughnesses, and texels of the exhaustive "
        "method: on the first scene, or on all of them with --full. The arms of a series take turns frame "
        "by frame in random order and every frame is finished before the clock stops; rounds go on until "
        "every median is within 2 %, three times the least number of rounds, or a cap of seconds is reached "
        "(time_precise says which). A difference below that of two equal arms decides nothing.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .derived_tables = &rl_fps_model_table,
    .n_derived_tables = 1,
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .figure_patterns = figure_patterns,
    .plan = plan,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .check = rl_fps_check,
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_fps_measure,
    .derive = rl_fps_derive,
    .judge = rl_fps_judge,
};
