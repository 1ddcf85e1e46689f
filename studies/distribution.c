/* The study `distribution`: do the normals follow the distribution that the paper draws them from, and what do random numbers baked
 * into a map do in place of a generator in the shader?
 *
 * Every texel of normal maps, read back from the GPU, over R_r, bits and size, against D: chi-square in delta and theta, the
 * distance of the cdf, the direction of the mean, the width. Then a small model of one highlight's edge, where the numbers come from a
 * generator restarted at every pixel, from a map, or from a hash (distribution_generators.c). */
#include "studies/distribution.h"

#include <string.h>

/* Lists end with 0 or NULL. */
struct maps {
    double rr[16];
    const char *bits[16];
    int size[8];
};

struct grid {
    struct maps maps[4]; /* each crossed in itself; no map in two of them */
    int samples[8];
    int seeds, size; /* of the generators' points */
};

#define EVERY_RR                                                                                             \
    {                                                                                                        \
        1, 2, 3, 5, 10, 30, 100, 300, 1000                                                                   \
    }
#define EVERY_FORMAT                                                                                         \
    {                                                                                                        \
        "4", "5", "6", "8", "10", "12", "16", "half", "float"                                                \
    }

/* The largest float map sees an R_r that is 1 % off; the largest of 16 bits places a cdf that is nearly 0.01 off. */
static const struct grid grids[] = {
    [RL_GRID_QUICK] = {.maps = {{{1, 30, 1000}, {"8", "16", "half", "float"}, {128}}},
                       .samples = {1, 4, 16},
                       .seeds = 8,
                       .size = 32},
    [RL_GRID_DEFAULT] = {.maps = {{EVERY_RR, EVERY_FORMAT, {512}},
                                  {{30}, {"8", "float"}, {64, 128, 256, 1024}},
                                  {{1000}, {"16"}, {1024}},
                                  {{30}, {"float"}, {2048}}},
                         .samples = {1, 4, 16},
                         .seeds = 16,
                         .size = 64},
    [RL_GRID_FULL] = {.maps = {{EVERY_RR, EVERY_FORMAT, {512, 64, 128, 256, 1024, 2048}}},
                      .samples = {1, 4, 16, 64, 256},
                      .seeds = 32,
                      .size = 64},
};

static const double point_rr = 30.0;

/* A generator that is restarted at every pixel gives one error a seed: its mean square needs many. */
static const int restarted_seeds = 64;

/* All formats of one R_r and size are one group, soon done. Histograms are kept of the first size. */
static int plan_maps(struct rl_run *run, const struct rl_place *place, const struct maps *m, bool keep,
                     int *group, struct rl_error *error)
{
    for (int s = 0; m->size[s] > 0; s++)
        for (int r = 0; m->rr[r] > 0.0; r++, ++*group)
            for (int b = 0; m->bits[b]; b++)
                if (!rl_run_add(run, place, *group, error,
                                "series=map rr=%g normal_bits=%s normal_size=%d keep=%d", m->rr[r],
                                m->bits[b], m->size[s], keep && s == 0))
                    return RL_ERR_SYSTEM;
    return RL_OK;
}

static const struct {
    const char *generator, *bits;
} arm[] = {{"lcg", "float"}, {"baked", "8"}, {"baked", "float"}, {"hash", "float"}};

enum { ARMS = sizeof arm / sizeof arm[0] };

static int plan_generators(struct rl_run *run, const struct rl_place *place, const struct grid *g, int *group,
                           struct rl_error *error)
{
    for (int n = 0; g->samples[n] > 0; n++, ++*group)
        for (int a = 0; a < ARMS; a++)
            if (!rl_run_add(
                    run, place, *group, error,
                    "series=point generator=%s normal_bits=%s samples=%d rr=%g normal_size=256 size=%d "
                    "step=0 seeds=%d",
                    arm[a].generator, arm[a].bits, g->samples[n], point_rr, g->size,
                    strcmp(arm[a].generator, "lcg") == 0 ? restarted_seeds : g->seeds))
                return RL_ERR_SYSTEM;
    static const char *const picture[] = {"reference", "lcg", "baked", "hash"};
    for (size_t a = 0; a < sizeof picture / sizeof picture[0]; a++)
        if (!rl_run_add(run, place, *group, error,
                        "series=patch generator=%s normal_bits=float samples=4 rr=%g normal_size=256 size=48 "
                        "step=%g",
                        picture[a], point_rr, 1.8 / 48))
            return RL_ERR_SYSTEM;
    return RL_OK;
}

static int plan_alone(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                      struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    int status = RL_OK;
    for (size_t k = 0; k < sizeof g->maps / sizeof g->maps[0] && g->maps[k].size[0] > 0 && status == RL_OK;
         k++)
        status = plan_maps(run, place, &g->maps[k], k == 0, &group, error);
    return status == RL_OK ? plan_generators(run, place, g, &group, error) : status;
}

static int measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                   struct rl_error *error)
{
    (void)scene;
    if (rl_parameters_match(records[0].parameters, "series=map"))
        return rl_distribution_measure_maps(records, n, bench, error);
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = rl_distribution_measure_generator(&records[i], bench, error);
    return status;
}

static const struct rl_column map_columns[] = {
    {"rr", RL_COLUMN_NUMBER, "rr"},
    {"normal_bits", RL_COLUMN_TEXT, "normal_bits"},
    {"normal_size_px", RL_COLUMN_NUMBER, "normal_size"},
    {"texels", RL_COLUMN_VALUE, "texels"},
    {"freedom", RL_COLUMN_VALUE, "freedom"},
    {"chi2_delta", RL_COLUMN_VALUE, "chi2_delta"},
    {"p_delta", RL_COLUMN_VALUE, "p_delta"},
    {"phi2_delta", RL_COLUMN_VALUE, "phi2_delta"},
    {"chi2_theta", RL_COLUMN_VALUE, "chi2_theta"},
    {"p_theta", RL_COLUMN_VALUE, "p_theta"},
    {"phi2_theta", RL_COLUMN_VALUE, "phi2_theta"},
    RL_COLUMNS_WITH_INTERVAL("misfit_delta"),
    RL_COLUMNS_WITH_INTERVAL("misfit_theta"),
    RL_COLUMNS_WITH_INTERVAL("kolmogorov"),
    RL_COLUMNS_WITH_INTERVAL("mean_u"),
    {"mean_tilt_rad", RL_COLUMN_VALUE, "mean_tilt"},
    {"mean_tilt_rad_low", RL_COLUMN_LOW, "mean_tilt"},
    {"mean_tilt_rad_high", RL_COLUMN_HIGH, "mean_tilt"},
    {"tilt_rad", RL_COLUMN_VALUE, "tilt"},
    {"tilt_rad_low", RL_COLUMN_LOW, "tilt"},
    {"tilt_rad_high", RL_COLUMN_HIGH, "tilt"},
    RL_COLUMNS_WITH_INTERVAL("width"),
    {"d_median_rad", RL_COLUMN_VALUE, "d_median"},
    {"d_rms_sine", RL_COLUMN_VALUE, "d_rms_sine"},
};

static const struct rl_column point_columns[] = {
    {"generator", RL_COLUMN_TEXT, "generator"}, {"normal_bits", RL_COLUMN_TEXT, "normal_bits"},
    {"samples", RL_COLUMN_NUMBER, "samples"},   {"rr", RL_COLUMN_NUMBER, "rr"},
    {"size_px", RL_COLUMN_NUMBER, "size"},      {"seeds", RL_COLUMN_NUMBER, "seeds"},
    RL_COLUMNS_WITH_INTERVAL("truth"),          RL_COLUMNS_WITH_INTERVAL("bias"),
    RL_COLUMNS_WITH_INTERVAL("bias2"),          RL_COLUMNS_WITH_INTERVAL("variance"),
    RL_COLUMNS_WITH_INTERVAL("floor"),          RL_COLUMNS_WITH_INTERVAL("noise"),
};

static const struct rl_table tables[] = {
    {"distribution",
     "Every normal map, as the GPU has it, against the distribution its normals were drawn from",
     "series=map", map_columns, sizeof map_columns / sizeof map_columns[0]},
    {"generators", "One surface point at the edge of a highlight, by each generator: bias and noise apart",
     "series=point", point_columns, sizeof point_columns / sizeof point_columns[0]},
};

static const struct rl_figure figures[] = {
    {"fit",
     "How far the cdf of a map's normals is from that of D, at its worst (Kolmogorov distance), against R_r. "
     "Grey: what a map of "
     "this many unrounded random normals stays below in 95 % of cases. Above it the format shows."},
    {"misfit", "How far 64 bins of equal probability are from being filled as D would, root mean square over "
               "the bins; of delta or of theta, "
               "whichever is worse. Grey: what claims allow. Bars: 95 % intervals." RL_CAPTION_EDGE},
    {"histogram",
     "Counts in 64 bins of equal probability over what D lets one expect, bins being numbered along "
     "delta: 1 is perfect, grey: "
     "95 % of bins by chance. 8 bits leave too few directions for smooth surfaces; bins without any "
     "are at 0."},
    {"width",
     "The lobe that a map holds: median |delta| of its normals over that of D. A lobe cannot be narrower "
     "than the format's step; "
     "where two levels stand on either side of N, it is wider instead."},
    {"tilt", "How far storing the normals turns their mean away from N, a panel for each format, beside "
             "their own random error (grey, of float "
             "maps). Dashed: what the claims about 8 bits and half floats allow. Bars: 95 % "
             "intervals." RL_CAPTION_EDGE},
    {"generators", "One surface point at a highlight's edge: bias (what is the same at every pixel, full "
                   "marks) and noise (what differs, open "
                   "marks) against N. A generator restarted at every pixel has no noise and all its error as "
                   "bias." RL_CAPTION_EDGE},
    {"pictures",
     "A highlight on a plane, 4 normals a pixel, by the same estimate and three sources of random "
     "numbers. Restarted at every "
     "pixel, the same four normals are drawn everywhere: four copies of the light's mirror image in "
     "place of its blur."},
};

/* What tells arms apart is not among them. */
static const struct rl_sweep sweeps[] = {
    RL_SWEEP_RR("series=map"),
    {.name = "normal_bits",
     .of = "series=map",
     .kind = RL_SWEEP_WORD,
     .words = rl_sweep_normal_bits,
     .together = 15},
    RL_SWEEP_NORMAL_SIZE("series=map"),
    {.name = "samples", .of = "series=point", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 1024},
    {.name = "size", .of = "series=point", .kind = RL_SWEEP_WHOLE, .low = 2, .high = 256},
    {.name = "seeds", .of = "series=point", .kind = RL_SWEEP_WHOLE, .low = 2, .high = 64},
};

static const char *const scenes[] = {NULL};

static const struct rl_cost costs[] = {{.pattern = "series=map", .group = 0.009, .texel = 0.14},
                                       {.pattern = "series=point", .group = 0.16, .sample = 0.075},
                                       {.pattern = "", .group = 0.02}};

const struct rl_study rl_study_distribution = {
    .name = "distribution",
    .summary = "normals of the normal map against D, by R_r, bits and size; baked random numbers against "
               "a restarted generator and a hash",
    .text =
        "Normals are drawn by the inverse cdf and stored in a texture, random numbers and all. Every texel "
        "of such "
        "maps, read "
        "back from the GPU and decoded as shaders do, is held against the ellipsoid distribution, which is "
        "integrated from its "
        "density, apart from all that draws normals. What is off is judged by its size, with an interval, "
        "against a stated bound; "
        "p of chi-square, corrected for all tests of the run (Sidak), is in the notes. The generators "
        "are compared on a model: a plane, a far eye, a square light, whose mirror image has its edge at the "
        "point; the truth is "
        "the reference's.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures_alone = figures,
    .n_figures_alone = sizeof figures / sizeof figures[0],
    .plan_alone = plan_alone,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = measure,
    .judge = rl_distribution_judge,
};
