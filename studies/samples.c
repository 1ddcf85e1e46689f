/* The study `samples`: what do more samples buy, in error and in time, and what can they not buy?
 *
 * Methods regular and random over N against the reference, at several R_r, with the paper's settings (8-bit normal map,
 * environment map of 256 texels) and with fine ones (float normals, a large float map). Random with several seeds, so that
 * noise and bias come apart. Then N is held large and the environment map's size varied: what is left is the floor that
 * samples cannot remove, at first the map's texels, at last its single position. */
#include "studies/samples.h"

#include <stdbool.h>

/* The three grids: lists end with 0. */
struct grid {
    int samples[13];
    double rr[8];
    int floor_env[12];
    int floor_samples, floor_seeds;
    int seeds, rounds, width, height;
    double tolerance;
    bool fine; /* also with fine settings, at R_r = fine_rr; full: at every R_r */
    bool fine_everywhere;
    int fine_env;
};

static const struct grid grids[] = {
    [RL_GRID_QUICK] = {.samples = {1, 4, 13, 32, 64},
                       .rr = {3, 30},
                       .floor_env = {16, 64, 256, 512},
                       .floor_samples = 64,
                       .floor_seeds = 4,
                       .seeds = 4,
                       .rounds = 6,
                       .width = 160,
                       .height = 120,
                       .tolerance = 1e-4},
    [RL_GRID_DEFAULT] = {.samples = {1, 2, 4, 8, 13, 16, 32, 64, 128, 256, 512, 1024},
                         .rr = {3, 30, 300},
                         .floor_env = {8, 16, 32, 64, 128, 256, 512, 1024, 2048},
                         .floor_samples = 1024,
                         .floor_seeds = 4,
                         .seeds = 8,
                         .rounds = 7,
                         .width = 320,
                         .height = 240,
                         .tolerance = 1e-4,
                         .fine = true,
                         .fine_env = 2048},
    [RL_GRID_FULL] = {.samples = {1, 2, 4, 8, 13, 16, 32, 64, 128, 256, 512, 1024},
                      .rr = {1, 3, 10, 30, 100, 300, 1000},
                      .floor_env = {8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096},
                      .floor_samples = 1024,
                      .floor_seeds = 8,
                      .seeds = 16,
                      .rounds = 30,
                      .width = 640,
                      .height = 480,
                      .tolerance = 1e-5,
                      .fine = true,
                      .fine_everywhere = true,
                      .fine_env = 2048},
};

static const double fine_rr = 30.0;

/* One group: N normals by both methods. Timed only where the time is shown. */
static int plan_group(struct rl_run *run, const struct rl_place *place, const struct grid *g, int group,
                      bool fine, int samples, double rr, struct rl_error *error)
{
    static const char *const method[] = {"regular", "random"};
    bool timed = rr == fine_rr;
    for (int m = 0; m < 2; m++)
        if (!rl_run_add(run, place, group, error,
                        "series=methods setting=%s method=%s samples=%d rr=%g normal_bits=%s env_size=%d "
                        "env_format=%s "
                        "seeds=%d rounds=%d width=%d height=%d tolerance=%g",
                        fine ? "fine" : "paper", method[m], samples, rr, fine ? "float" : "8",
                        fine ? g->fine_env : 256, fine ? "rgba32f" : "rgba8", m ? g->seeds : 1,
                        timed ? g->rounds : 0, g->width, g->height, g->tolerance))
            return RL_ERR_SYSTEM;
    return RL_OK;
}

/* One group of all map sizes: the same normals meet each map, so that what the maps differ by is not lost in noise. */
static int plan_floor(struct rl_run *run, const struct rl_place *place, const struct grid *g, int group,
                      struct rl_error *error)
{
    for (int e = 0; g->floor_env[e] > 0; e++)
        if (!rl_run_add(
                run, place, group, error,
                "series=floor setting=floor method=random samples=%d rr=%g normal_bits=float env_size=%d "
                "env_format=rgba16f seeds=%d rounds=0 width=%d height=%d tolerance=%g",
                g->floor_samples, fine_rr, g->floor_env[e], g->floor_seeds, g->width, g->height,
                g->tolerance))
            return RL_ERR_SYSTEM;
    return RL_OK;
}

/* R_r outermost: all cases of one reference together. */
static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    int status = RL_OK;
    for (int r = 0; g->rr[r] > 0.0; r++) {
        bool fine = g->fine && (g->fine_everywhere || g->rr[r] == fine_rr);
        for (int f = 0; f <= (fine ? 1 : 0); f++)
            for (int n = 0; g->samples[n] > 0 && status == RL_OK; n++)
                status = plan_group(run, place, g, group++, f > 0, g->samples[n], g->rr[r], error);
    }
    return status == RL_OK ? plan_floor(run, place, g, group, error) : status;
}

#define WITH_INTERVAL(name)                                                                                  \
    {name, RL_COLUMN_VALUE, name}, {name "_low", RL_COLUMN_LOW, name},                                       \
    {                                                                                                        \
        name "_high", RL_COLUMN_HIGH, name                                                                   \
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
    WITH_INTERVAL("rmse"),
    WITH_INTERVAL("noise"),
    WITH_INTERVAL("floor"),
    WITH_INTERVAL("texel_error"),
    WITH_INTERVAL("bias"),
    WITH_INTERVAL("mae"),
    WITH_INTERVAL("relmse"),
    {"max", RL_COLUMN_VALUE, "max"},
    WITH_INTERVAL("bias2"),
    WITH_INTERVAL("variance"),
    WITH_INTERVAL("frame_ms"),
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
    {"split", "Random sampling taken apart at R_r = 30: noise (what more samples remove) and floor (what "
              "they do not), with the "
              "paper's settings and with fine ones."},
    {"floor", "What no sample removes, against the environment map's size, at large N and with float "
              "normals. Texel error: the "
              "difference to the largest map, with the same normals. The floor stops falling where the texel "
              "error has become small beside "
              "the map's other fault, its single position: it is taken at the object's centre, not at each "
              "point (parallax)."},
    {"time", "Error against time: down and left is better. Each point is a number of samples; times are "
             "medians of interleaved "
             "frames."},
};

static const char *const scenes[] = {"teapot-star", NULL};

const struct rl_study rl_study_samples = {
    .name = "samples",
    .summary = "method x number of samples against error and time; noise and bias apart",
    .text = "The highlight by fixed patterns (regular) and by random normals from a baked normal map "
            "(random) is compared with the "
            "reference, which integrates the same highlight on the true polygons in double precision. Errors "
            "are of linear "
            "radiance over the object's pixels, 1 being full scale. With several seeds the squared error "
            "splits into variance "
            "(noise) and bias squared (floor).",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .plan = plan,
    .measure = rl_samples_measure,
    .judge = rl_samples_judge,
};
