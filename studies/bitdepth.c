/* The study `bitdepth`: how many bits does a normal map need, and the environment map, and the frame buffer?
 *
 * Each is held against full precision with the same random numbers, so that the noise cancels and what the bits do is seen alone. No
 * reference is needed: the question is what changes, not what is true. */
#include "studies/bitdepth.h"

#include <stdbool.h>
#include <string.h>

/* Lists end with 0. */
struct grid {
    int width, height, normal_size;
    double rr[14];
    int samples[5]; /* of the normal maps; the rest at 4 alone */
    int seeds;
    int time_width, time_height, time_map, rounds;
};

static const struct grid grids[] = {
    [RL_GRID_QUICK] = {.width = 64,
                       .height = 48,
                       .normal_size = 64,
                       .rr = {10, 1000},
                       .samples = {4},
                       .seeds = 4,
                       .time_width = 64,
                       .time_height = 48,
                       .time_map = 64,
                       .rounds = 10},
    [RL_GRID_DEFAULT] = {.width = 64,
                         .height = 48,
                         .normal_size = 64,
                         .rr = {3, 10, 30, 100, 300, 1000},
                         .samples = {4, 16},
                         .seeds = 8,
                         .time_width = 320,
                         .time_height = 240,
                         .time_map = 512,
                         .rounds = 30},
    [RL_GRID_FULL] = {.width = 640,
                      .height = 480,
                      .normal_size = 512,
                      .rr = {1, 1.8, 3.2, 5.6, 10, 18, 30, 56, 100, 180, 320, 560, 1000},
                      .samples = {1, 4, 16, 64},
                      .seeds = 16,
                      .time_width = 640,
                      .time_height = 480,
                      .time_map = 512,
                      .rounds = 100},
};

/* Full precision first. */
static const char *const bits[] = {"float", "4", "5", "6", "8", "10", "12", "16", "half"};
static const char *const formats[] = {"rgba32f", "rgba8", "rgb10a2", "r11g11b10f", "rgba16", "rgba16f"};
/* Against 8; "8 again" is the same work, "none" a frame without a highlight. */
static const struct {
    const char *arm, *method, *bits;
} timed[] = {{"8", "random", "8"},       {"8-again", "random", "8"},  {"none", "none", "8"},
             {"4", "random", "4"},       {"10", "random", "10"},      {"16", "random", "16"},
             {"half", "random", "half"}, {"float", "random", "float"}};

enum {
    N_BITS = sizeof bits / sizeof bits[0],
    N_FORMATS = sizeof formats / sizeof formats[0],
    N_TIMED = sizeof timed / sizeof timed[0]
};

/* What the cases of one group have in common. */
struct point {
    struct rl_run *run;
    const struct rl_place *place;
    const struct grid *grid;
    double rr;
    int samples, group;
    struct rl_error *error;
};

static bool add(const struct point *p, const char *series, const char *method, int samples,
                const char *normal_bits, const char *env_format, const char *frame_format)
{
    const struct grid *g = p->grid;
    return rl_run_add(p->run, p->place, p->group, p->error,
                      "series=%s method=%s samples=%d rr=%g normal_bits=%s normal_size=%d env_size=256 "
                      "env_format=%s frame_format=%s seeds=%d width=%d height=%d",
                      series, method, samples, p->rr, normal_bits, g->normal_size, env_format, frame_format,
                      strcmp(method, "random") == 0 ? g->seeds : 1, g->width, g->height) != NULL;
}

static bool add_group(const struct point *p)
{
    bool ok = true;
    for (int i = 0; ok && i < N_BITS; i++)
        ok = add(p, "normals", "random", p->samples, bits[i], "rgba8", "rgba32f");
    if (p->samples != 4)
        return ok;
    for (int i = 0; ok && i < N_FORMATS; i++)
        ok = add(p, "environment", "random", p->samples, "float", formats[i], "rgba32f");
    for (int i = 0; ok && i < N_FORMATS; i++)
        ok = add(p, "frame", "random", p->samples, "float", "rgba8", formats[i]);
    for (int i = 0; ok && i < N_BITS; i++)
        ok = add(p, "regular", "regular", 13, bits[i], "rgba8", "rgba32f");
    return ok;
}

static bool add_time(const struct point *p)
{
    const struct grid *g = p->grid;
    for (int i = 0; i < N_TIMED; i++)
        if (!rl_run_add(p->run, p->place, p->group, p->error,
                        "series=time arm=%s method=%s samples=4 rr=30 normal_bits=%s normal_size=%d "
                        "env_size=256 env_format=rgba8 rounds=%d width=%d height=%d",
                        timed[i].arm, timed[i].method, timed[i].bits, g->time_map, g->rounds, g->time_width,
                        g->time_height))
            return false;
    return true;
}

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    struct point p = {run, place, g, 0.0, 0, group, error};
    bool ok = true;
    for (int i = 0; g->rr[i] > 0.0; i++)
        for (int k = 0; ok && g->samples[k] > 0; k++, p.group++) {
            p.rr = g->rr[i];
            p.samples = g->samples[k];
            ok = add_group(&p);
        }
    return ok && add_time(&p) ? RL_OK : RL_ERR_SYSTEM;
}

static const struct rl_column columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"series", RL_COLUMN_TEXT, "series"},
    {"method", RL_COLUMN_TEXT, "method"},
    {"samples", RL_COLUMN_NUMBER, "samples"},
    {"rr", RL_COLUMN_NUMBER, "rr"},
    {"normal_bits", RL_COLUMN_TEXT, "normal_bits"},
    {"env_format", RL_COLUMN_TEXT, "env_format"},
    {"frame_format", RL_COLUMN_TEXT, "frame_format"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    {"seeds", RL_COLUMN_NUMBER, "seeds"},
    RL_COLUMNS_WITH_INTERVAL("bias"),
    RL_COLUMNS_WITH_INTERVAL("change"),
    RL_COLUMNS_WITH_INTERVAL("difference"),
    RL_COLUMNS_WITH_INTERVAL("noise_4"),
    RL_COLUMNS_WITH_INTERVAL("bias_of_noise"),
    RL_COLUMNS_WITH_INTERVAL("change_of_noise"),
    {"clipped", RL_COLUMN_VALUE, "clipped"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_column time_columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"arm", RL_COLUMN_TEXT, "arm"},
    {"normal_bits", RL_COLUMN_TEXT, "normal_bits"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    RL_COLUMNS_WITH_INTERVAL("frame_ms"),
    RL_COLUMNS_WITH_INTERVAL("time_to_8"),
    RL_COLUMNS_WITH_INTERVAL("above_baseline_ms"),
    {"frames", RL_COLUMN_VALUE, "frames"},
    {"time_precision", RL_COLUMN_VALUE, "time_precision"},
    {"time_capped", RL_COLUMN_VALUE, "time_capped"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

/* The first of each series is what the others are held against; its rows hold zeros and the noise. */
static const struct rl_table tables[] = {
    {"bitdepth_normals", "Normal maps of few bits against one of floats, random normals", "series=normals",
     columns, sizeof columns / sizeof columns[0]},
    {"bitdepth_regular", "The pattern of 13 regular normals rounded like a normal map's texels",
     "series=regular", columns, sizeof columns / sizeof columns[0]},
    {"bitdepth_environment", "Environment maps of each format against one of floats", "series=environment",
     columns, sizeof columns / sizeof columns[0]},
    {"bitdepth_frame", "Frame buffers of each format against one of floats", "series=frame", columns,
     sizeof columns / sizeof columns[0]},
    {"bitdepth_time", "Frame time of 4 random normals by the bits of the normal map", "series=time",
     time_columns, sizeof time_columns / sizeof time_columns[0]},
};

static const struct rl_figure figures[] = {
    {"normals", "What the bits of the normal map do to the expected picture: RMS bias of 4 random normals "
                "against the same random numbers in floats. Thick grey: a tenth of the noise of 4 normals; "
                "dashed: 1/255. Below both, the bits make almost no difference. Bars: 95 % intervals over "
                "seeds." RL_CAPTION_EDGE},
    {"regular", "8 and 10 bits for random normals and for a fixed pattern of 13, rounded the same way (the "
                "shaders get the pattern as floats: this is what a texture would do to it). Random errors "
                "are dithered by the normals' own spread; those of a pattern are not." RL_CAPTION_EDGE},
    {"rounding",
     "What the bits change of the picture, noise of other texels included, at one R_r and the most normals "
     "measured. At 8 bits it is to be below the dashed line: sqrt(2) times the geometric mean of 6 and 10 "
     "bits; a map of 7 bits would lie above." RL_CAPTION_EDGE},
    {"formats",
     "Environment maps (in full) and frame buffers (in dashes) of each format: RMS change in a picture of 4 "
     "random normals. Frame buffers are rounded to nearest after the surface and after the highlight are "
     "written. Thick grey: a tenth of the noise of 4 normals." RL_CAPTION_EDGE},
    {"time", "Frame time of 4 random normals by the bits of their map, relative to 8 bits in the same round; "
             "95 % intervals of the median. Grey: what two arms of the same work differ by."},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    RL_SWEEP_RR(NULL),
    {.name = "samples", .of = "series=normals", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 1024},
    RL_SWEEP_NORMAL_SIZE(NULL),
    RL_SWEEP_SEEDS("method=random"),
    {.name = "rounds", .of = "series=time", .kind = RL_SWEEP_WHOLE, .low = 6, .high = 100000},
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
};

static const char *const scenes[] = {"teapot-star", "sphere-quad", "three-lights", NULL};

static const struct rl_cost costs[] = {{.pattern = "series=time", .picture = 0.0014, .pixel = 0.086},
                                       {.pattern = "", .picture = 0.0022, .sample = 0.048}};

const struct rl_study rl_study_bitdepth = {
    .name = "bitdepth",
    .summary = "bits of normal map, environment map and frame buffer: bias, against the noise, and time",
    .text =
        "Pictures with few bits are compared with pictures of full precision that use the same random "
        "numbers: the noise cancels and what the bits do is left. Its part that every seed shares is "
        "bias, which no sample removes. It is held against a tenth of the noise of the paper's 4 normals "
        "and against 1/255 of full scale. Smooth surfaces keep so few directions that these fall on few of "
        "the environment map's texels, whose own error then no longer cancels: the bias is that of the bits "
        "together with the map of 256 texels, and less with a finer map (--axis env_size=256,2048 shows by "
        "how much). The regular method takes its pattern as floats and not from a "
        "map; what a map of few bits would do to it is modelled by rounding the pattern before it is "
        "uploaded. The pipeline's frame buffer holds floats; others are modelled by rounding to nearest "
        "as its two passes would.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .plan = plan,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_bitdepth_measure,
    .judge = rl_bitdepth_judge,
};
