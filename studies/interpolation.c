/* The study `interpolation`: constant, Gouraud and Phong shading of the same surface. How far off is each at a given number of triangles,
 * how fast does that fall, where do the bands come from that Mach saw, and what does each cost? */
#include "studies/interpolation.h"

/* Lists end with 0. */
struct grid {
    int sphere[16], teapot[16]; /* tessellations of the errors */
    int timed_sphere[8], timed_teapot[8];
    int width, height; /* of the errors */
    int line;          /* pixels of the bands' line */
    int frames, timed_width, timed_height;
    double seconds; /* cap of a group's times */
};

static const struct grid grids[] = {
    /* As fine as constant shading needs for an RMSE of 1/255, so that what claims compare is there. */
    [RL_GRID_QUICK] = {.sphere = {4, 8, 16, 32, 64, 96},
                       .teapot = {2, 4, 8, 16, 24, 32, 48, 64},
                       .timed_sphere = {16},
                       .timed_teapot = {8},
                       .width = 80,
                       .height = 60,
                       .line = 400,
                       .frames = 6,
                       .timed_width = 160,
                       .timed_height = 120,
                       .seconds = 0.3},
    [RL_GRID_DEFAULT] = {.sphere = {2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96},
                         .teapot = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48},
                         .timed_sphere = {4, 16, 64},
                         .timed_teapot = {16},
                         .width = 160,
                         .height = 120,
                         .line = 800,
                         .frames = 20,
                         .timed_width = 320,
                         .timed_height = 240,
                         .seconds = 0.6},
    [RL_GRID_FULL] = {.sphere = {2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256},
                      .teapot = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128},
                      .timed_sphere = {4, 8, 16, 32, 64, 128},
                      .timed_teapot = {2, 4, 8, 16, 32, 64},
                      .width = 640,
                      .height = 480,
                      .line = 800,
                      .frames = 60,
                      .timed_width = 640,
                      .timed_height = 480,
                      .seconds = 20.0},
};

/* Where the bands are looked for: triangles of some tens of pixels. The exact surface is found by way of a fine mesh. */
static const struct {
    const char *object;
    int tessellation, fine;
} lines[] = {{"sphere", 8, 128}, {"teapot", 6, 64}};

enum { EXPONENT = 20, OBJECTS = 2 };

struct point {
    struct rl_run *run;
    const struct rl_place *place;
    const struct grid *grid;
    int group;
    struct rl_error *error;
};

static const char *name(int interpolation)
{
    return rl_interpolation_name((enum rl_interpolation)interpolation);
}

static bool add_errors(struct point *p, const char *object, const int *tessellation)
{
    static const char *const light[] = {"eye", "side"};
    bool ok = true;
    for (int l = 0; l < 2; l++, p->group++)
        for (const int *t = tessellation; *t > 0; t++)
            for (int i = 0; i < RL_INTERPOLATIONS && ok; i++)
                ok =
                    rl_run_add(p->run, p->place, p->group, p->error,
                               "series=error object=%s light=%s exponent=%d tessellation=%d interpolation=%s "
                               "width=%d height=%d",
                               object, light[l], EXPONENT, *t, name(i), p->grid->width, p->grid->height);
    return ok;
}

static bool add_line(struct point *p, int o, const char *surface, int tessellation, int interpolation)
{
    return rl_run_add(p->run, p->place, p->group, p->error,
                      "series=bands object=%s light=eye exponent=%d surface=%s tessellation=%d "
                      "interpolation=%s width=%d height=%d",
                      lines[o].object, EXPONENT, surface, tessellation, name(interpolation), p->grid->line,
                      p->grid->line * 3 / 4);
}

static bool add_lines(struct point *p)
{
    bool ok = true;
    for (int o = 0; o < OBJECTS; o++, p->group++) {
        for (int i = 0; i < RL_INTERPOLATIONS && ok; i++)
            ok = add_line(p, o, "mesh", lines[o].tessellation, i);
        ok = ok && add_line(p, o, "exact", lines[o].fine, RL_INTERPOLATION_PHONG);
    }
    return ok;
}

static bool add_arm(struct point *p, const char *object, int tessellation, int interpolation, const char *arm)
{
    const struct grid *g = p->grid;
    return rl_run_add(p->run, p->place, p->group, p->error,
                      "series=time object=%s light=side exponent=%d tessellation=%d interpolation=%s arm=%s "
                      "width=%d height=%d frames=%d seconds=%g",
                      object, EXPONENT, tessellation, name(interpolation), arm, g->timed_width,
                      g->timed_height, g->frames, g->seconds);
}

static bool add_times(struct point *p, const char *object, const int *tessellation)
{
    bool ok = true;
    for (; *tessellation > 0 && ok; tessellation++, p->group++) {
        for (int i = 0; i < RL_INTERPOLATIONS && ok; i++)
            ok = add_arm(p, object, *tessellation, i, "frame");
        ok = ok && add_arm(p, object, *tessellation, RL_INTERPOLATION_PHONG, "again");
    }
    return ok;
}

static int plan_alone(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                      struct rl_error *error)
{
    const struct grid *g = &grids[grid];
    struct point p = {run, place, g, group, error};
    bool ok = add_errors(&p, "sphere", g->sphere) && add_errors(&p, "teapot", g->teapot) && add_lines(&p) &&
              add_times(&p, "sphere", g->timed_sphere) && add_times(&p, "teapot", g->timed_teapot);
    return ok ? RL_OK : RL_ERR_SYSTEM;
}

#define COLUMNS_OF_A_CASE                                                                                    \
    {"object", RL_COLUMN_TEXT, "object"}, {"light", RL_COLUMN_TEXT, "light"},                                \
        {"interpolation", RL_COLUMN_TEXT, "interpolation"},                                                  \
    {                                                                                                        \
        "tessellation", RL_COLUMN_NUMBER, "tessellation"                                                     \
    }

static const struct rl_column error_columns[] = {
    COLUMNS_OF_A_CASE,
    {"exponent", RL_COLUMN_NUMBER, "exponent"},
    {"triangles", RL_COLUMN_VALUE, "triangles"},
    {"points", RL_COLUMN_VALUE, "points"},
    {"rmse", RL_COLUMN_VALUE, "rmse"},
    {"max", RL_COLUMN_VALUE, "max"},
};

static const struct rl_column band_columns[] = {
    COLUMNS_OF_A_CASE,
    {"surface", RL_COLUMN_TEXT, "surface"},
    {"line_px", RL_COLUMN_NUMBER, "width"},
    {"step", RL_COLUMN_VALUE, "step"},
    {"bend", RL_COLUMN_VALUE, "bend"},
    {"slope", RL_COLUMN_VALUE, "slope"},
    {"jump", RL_COLUMN_VALUE, "jump"},
};

static const struct rl_column time_columns[] = {
    COLUMNS_OF_A_CASE,
    {"arm", RL_COLUMN_TEXT, "arm"},
    {"width_px", RL_COLUMN_NUMBER, "width"},
    {"height_px", RL_COLUMN_NUMBER, "height"},
    {"triangles", RL_COLUMN_VALUE, "triangles"},
    RL_COLUMNS_WITH_INTERVAL("frame_ms"),
    RL_COLUMNS_WITH_INTERVAL("time_to_phong"),
    {"frames", RL_COLUMN_VALUE, "frames"},
    {"time_precision", RL_COLUMN_VALUE, "time_precision"},
    {"time_capped", RL_COLUMN_VALUE, "time_capped"},
};

static const struct rl_column rate_columns[] = {
    {"object", RL_COLUMN_TEXT, "object"},
    {"light", RL_COLUMN_TEXT, "light"},
    {"interpolation", RL_COLUMN_TEXT, "interpolation"},
    RL_COLUMNS_WITH_INTERVAL("rate"),
    {"fitted", RL_COLUMN_VALUE, "fitted"},
    {"from_tessellation", RL_COLUMN_VALUE, "from_tessellation"},
    RL_COLUMNS_WITH_INTERVAL("triangles_for_step"),
};

#define TABLE(name, summary, pattern, columns)                                                               \
    {                                                                                                        \
        name, summary, pattern, columns, sizeof(columns) / sizeof((columns)[0])                              \
    }

static const struct rl_table tables[] = {
    TABLE("interpolation", "Radiance by the mesh against the exact surface's", "series=error", error_columns),
    TABLE("interpolation_bands", "Steps and changes of slope along one line of the picture", "series=bands",
          band_columns),
    TABLE("interpolation_time", "Frames of the same object under each interpolation", "series=time",
          time_columns),
};

static const struct rl_table derived_tables[] = {
    TABLE("interpolation_rates",
          "The power of h = 1/tessellation that the RMSE falls with, and the triangles for an RMSE of 1/255",
          "", rate_columns),
};

static const struct rl_figure figures_alone[] = {
    {"sphere", "Error against the number of triangles: the sphere, lit from the eye (filled) and from the "
               "side, with the terminator in view (open). "
               "Grey: 1/255, and the slopes of h and h², h being the edge of a triangle."},
    {"teapot", "The same of the teapot."},
    {"bands", "Mach bands of a sphere of 8 segments a quarter circle: radiance along a line of the picture, "
              "and how its slope changes from one pixel "
              "to the next, as the eye sees it. Constant shading leaves the scale: it jumps itself."},
    {"teapot-bands", "The same across the teapot, of 6 segments an edge of a patch."},
    {"time",
     "Time of a frame against the number of triangles; medians of interleaved frames with 95 % intervals."},
};

static const struct rl_sweep sweeps[] = {
    {.name = "tessellation",
     .of = "series=error",
     .kind = RL_SWEEP_WHOLE,
     .low = 1,
     .high = 512,
     .together = 30},
    {.name = "tessellation", .of = "series=time", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 512},
    {.name = "exponent", .of = NULL, .kind = RL_SWEEP_REAL, .low = 1, .high = 1000},
    RL_SWEEP_PIXELS("width", NULL),
    RL_SWEEP_PIXELS("height", NULL),
    {.name = "frames", .of = "series=time", .kind = RL_SWEEP_WHOLE, .low = 6, .high = 100000},
};

static const char *const no_scenes[] = {NULL};

static const struct rl_cost costs[] = {{.pattern = "series=time", .picture = 0.001, .pixel = 0.038},
                                       {.pattern = "", .group = 0.06, .picture = 0.0073}};

const struct rl_study rl_study_interpolation = {
    .name = "interpolation",
    .summary = "constant, Gouraud and Phong shading: error against triangles, Mach bands, time",
    .text = "A sphere and the teapot, diffuse with a Phong highlight of cos^20, as meshes of more and more "
            "triangles. At the points of the "
            "exact surface that the pixels show, the radiance that the mesh gives is held against that of "
            "the surface itself, with its own "
            "point and normal: nothing but rounding stands between it and the limit of all meshes. A mesh "
            "has a point of the sphere where "
            "the ray from the centre meets it, one of the teapot where its patch has the same u and v. All "
            "of that is in double precision; "
            "times are of the GPU's frames.",
    .scenes = no_scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .derived_tables = derived_tables,
    .n_derived_tables = sizeof derived_tables / sizeof derived_tables[0],
    .figures_alone = figures_alone,
    .n_figures_alone = sizeof figures_alone / sizeof figures_alone[0],
    .plan_alone = plan_alone,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_interpolation_measure,
    .derive = rl_interpolation_derive,
    .judge = rl_interpolation_judge,
};
