/* The study `roughness`: how does every method's error depend on R_r, and how many random normals would be enough?
 *
 * Plain, regular, random and exhaustive against the reference over R_r = 1 to 1000 with the paper's settings, random with sixteen seeds and more, so
 * that noise and floor come apart. Random once more with float normals and a large float map. Noise is then extrapolated
 * to the N at which the error would be one step of an 8-bit frame buffer. */
#include "studies/roughness.h"

#include <stdbool.h>
#include <string.h>

/* Lists end with 0. */
struct grid {
    int width, height;
    double tolerance;
    double rr[14];
    int regular[4], random[6], fine[4]; /* N of each */
    int seeds, normal_size, fine_env_size;
    int texels; /* the map's edge for exhaustive, whose time grows with its square */
};

static const struct grid grids[] = {
    [RL_GRID_QUICK] = {.width = 64,
                       .height = 48,
                       .tolerance = 1e-4,
                       .rr = {10, 300},
                       .regular = {13},
                       .random = {4, 16},
                       .fine = {16},
                       .seeds = 16,
                       .normal_size = 64,
                       .fine_env_size = 256,
                       .texels = 32},
    [RL_GRID_DEFAULT] = {.width = 96,
                         .height = 72,
                         .tolerance = 1e-4,
                         .rr = {1, 3, 10, 30, 100, 300, 1000},
                         .regular = {4, 13, 64},
                         .random = {4, 16, 64},
                         .fine = {64},
                         .seeds = 16,
                         .normal_size = 128,
                         .fine_env_size = 1024,
                         .texels = 64},
    [RL_GRID_FULL] = {.width = 640,
                      .height = 480,
                      .tolerance = 1e-5,
                      .rr = {1, 1.8, 3.2, 5.6, 10, 18, 30, 56, 100, 180, 320, 560, 1000},
                      .regular = {4, 13, 64},
                      .random = {1, 4, 16, 64, 256},
                      .fine = {4, 16, 64},
                      .seeds = 32,
                      .normal_size = 512,
                      .fine_env_size = 2048,
                      .texels = 128},
};

/* What the cases of one R_r have in common. */
struct one_rr {
    struct rl_run *run;
    const struct rl_place *place;
    const struct grid *grid;
    double rr;
    int group;
    struct rl_error *error;
};

static bool add(const struct one_rr *c, const char *series, bool fine, const char *method, int samples)
{
    const struct grid *g = c->grid;
    int seeds = strcmp(method, "random") == 0 ? g->seeds : 1;
    int env_size = strcmp(method, "exhaustive") == 0 ? g->texels : fine ? g->fine_env_size : 256;
    return rl_run_add(c->run, c->place, c->group, c->error,
                      "series=%s setting=%s method=%s samples=%d rr=%g normal_bits=%s normal_size=%d "
                      "env_size=%d env_format=%s seeds=%d width=%d height=%d tolerance=%g",
                      series, fine ? "fine" : "paper", method, samples, c->rr, fine ? "float" : "8",
                      g->normal_size, env_size, fine ? "rgba16f" : "rgba8", seeds, g->width, g->height,
                      g->tolerance) != NULL;
}

static bool add_all(const struct one_rr *c)
{
    const struct grid *g = c->grid;
    bool ok = add(c, "methods", false, "plain", 0) && add(c, "methods", false, "exhaustive", 0);
    for (int i = 0; ok && g->regular[i] > 0; i++)
        ok = add(c, "methods", false, "regular", g->regular[i]);
    for (int i = 0; ok && g->random[i] > 0; i++)
        ok = add(c, "methods", false, "random", g->random[i]);
    ok = ok && add(c, "needed", false, "random", 0);
    for (int i = 0; ok && g->fine[i] > 0; i++)
        ok = add(c, "methods", true, "random", g->fine[i]);
    return ok && add(c, "needed", true, "random", 0);
}

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    for (int i = 0; g->rr[i] > 0.0; i++) {
        struct one_rr c = {run, place, g, g->rr[i], group++, error};
        if (!add_all(&c))
            return RL_ERR_SYSTEM;
    }
    return RL_OK;
}

/* clang-format off */
#define WHERE                                      \
    {"scene", RL_COLUMN_SCENE, NULL},              \
    {"setting", RL_COLUMN_TEXT, "setting"},        \
    {"method", RL_COLUMN_TEXT, "method"},          \
    {"rr", RL_COLUMN_NUMBER, "rr"},                \
    {"normal_bits", RL_COLUMN_TEXT, "normal_bits"},\
    {"env_size_px", RL_COLUMN_NUMBER, "env_size"}, \
    {"env_format", RL_COLUMN_TEXT, "env_format"},  \
    {"width_px", RL_COLUMN_NUMBER, "width"},       \
    {"height_px", RL_COLUMN_NUMBER, "height"},     \
    {"seeds", RL_COLUMN_NUMBER, "seeds"}
/* clang-format on */

static const struct rl_column columns[] = {
    WHERE,
    {"samples", RL_COLUMN_NUMBER, "samples"},
    RL_COLUMNS_WITH_INTERVAL("rmse"),
    RL_COLUMNS_WITH_INTERVAL("rmse_centre"),
    RL_COLUMNS_WITH_INTERVAL("noise"),
    RL_COLUMNS_WITH_INTERVAL("floor"),
    RL_COLUMNS_WITH_INTERVAL("floor_centre"),
    {"parallax", RL_COLUMN_VALUE, "parallax"},
    RL_COLUMNS_WITH_INTERVAL("bias"),
    RL_COLUMNS_WITH_INTERVAL("mae"),
    {"max", RL_COLUMN_VALUE, "max"},
    RL_COLUMNS_WITH_INTERVAL("variance"),
    {"pixels_px", RL_COLUMN_VALUE, "pixels"},
    {"mismatched_px", RL_COLUMN_VALUE, "mismatched"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_column needed_columns[] = {
    WHERE,
    RL_COLUMNS_WITH_INTERVAL("needed"),
    RL_COLUMNS_WITH_INTERVAL("needed_centre"),
    RL_COLUMNS_WITH_INTERVAL("variance_1"),
    RL_COLUMNS_WITH_INTERVAL("floor"),
    RL_COLUMNS_WITH_INTERVAL("floor_centre"),
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_table tables[] = {
    {"roughness", "Every method at every R_r: error against the reference, noise and floor apart",
     "series=methods", columns, sizeof columns / sizeof columns[0]},
    {"roughness_needed",
     "Random normals a pixel for an RMSE of 1/255, from the noise of one and the floor; inf: the floor alone "
     "is above 1/255",
     "series=needed", needed_columns, sizeof needed_columns / sizeof needed_columns[0]},
};

static const struct rl_figure figures[] = {
    {"error", "Error of every method against R_r, rough at the left, smooth at the right; the paper's "
              "settings. Bars: 95 % intervals over seeds (only random has seeds). Exhaustive sums over every "
              "texel of a smaller map (the table has its size). Grey: 1/255, one step of an 8-bit frame "
              "buffer."},
    {"centre", "The same but for parallax: against the reference that sees the lights from the object's "
               "centre, as the environment map does." RL_CAPTION_EDGE},
    {"split",
     "What the error of random normals is made of: noise, which more normals remove, and floors, which they "
     "do not. The floor is mostly parallax. Floor − parallax: against a reference that sees the lights from "
     "the object's centre, as the environment map does; the bits and texels of the maps are left. With "
     "the paper's settings (8-bit normals, map of 256 texels) or fine ones (float normals, large half-float "
     "map). Floors come from differences and may be zero or less by chance." RL_CAPTION_EDGE},
    {"needed",
     "Random normals a pixel for an RMSE of 1/255: noise falls as 1/N on top of the floor. An open mark at "
     "the upper edge: the floor alone is above 1/255 and no number suffices; a bar that reaches the edge: "
     "perhaps none. Against the reference, or (− parallax) one that sees the lights from the object's "
     "centre. Grey: the paper's 4, and 1024, the most that the shaders take."},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    RL_SWEEP_RR(NULL),
    {.name = "samples",
     .of = "series=methods method=random",
     .kind = RL_SWEEP_WHOLE,
     .low = 1,
     .high = 1024,
     .together = 32},
    RL_SWEEP_NORMAL_SIZE(NULL),
    RL_SWEEP_SEEDS("method=random"),
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
    RL_SWEEP_TOLERANCE(NULL),
};

static const char *const scenes[] = {"teapot-star", "sphere-quad", "three-lights", NULL};

static const struct rl_cost costs[] = {{.pattern = "", .picture = 0.0005, .pixel = 0.6, .texel = 0.3}};

const struct rl_study rl_study_roughness = {
    .name = "roughness",
    .summary = "error of every method over R_r = 1 to 1000; random normals needed for an RMSE of 1/255",
    .text = "Plain, regular, random and exhaustive highlights are compared with the reference from the "
            "roughest surface "
            "that the paper allows (R_r = 1) to a near mirror (1000). Errors are of linear radiance over all "
            "pixels of the foreground, 1 being full scale. Random is drawn with several seeds, so that its "
            "squared error splits into variance (noise) and bias squared (floor), and the number of normals "
            "that would bring the error to 1/255 follows from both. Settings paper: 8-bit normals, a map of "
            "256 texels; fine: float normals and a large half-float map.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .plan = plan,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_roughness_measure,
    .judge = rl_roughness_judge,
};
