/* The study `fur`: the models side by side, where the glow comes from in the middle of a ball that is shaded as a widely copied listing has
 * it, and what each model costs at vertices and at pixels. */
#include "studies/fur.h"

#include <stdio.h>
#include <string.h>

#include "studies/effects.h"

/* Lists end with -1 (angles in degrees) or 0. */
struct grid {
    double beta[32];
    int tessellation[16], timed[8];
    int column, panel, width, height; /* pixels */
    int frames, timed_width, timed_height;
    double seconds; /* cap of a group's times */
};

static const struct grid grids[] = {
    [RL_GRID_QUICK] = {.beta = {0, 30, 150, -1},
                       .tessellation = {8, 16, 32},
                       .timed = {16},
                       .column = 160,
                       .panel = 40,
                       .width = 80,
                       .height = 60,
                       .frames = 6,
                       .timed_width = 160,
                       .timed_height = 120,
                       .seconds = 0.5},
    [RL_GRID_DEFAULT] = {.beta = {0, 15, 30, 45, 60, 75, 90, 120, 150, -1},
                         .tessellation = {4, 8, 16, 32, 64},
                         .timed = {16, 64},
                         .column = 240,
                         .panel = 64,
                         .width = 160,
                         .height = 120,
                         .frames = 20,
                         .timed_width = 320,
                         .timed_height = 240,
                         .seconds = 2.0},
    [RL_GRID_FULL] = {.beta = {0,  7.5,  15, 22.5, 30,  37.5, 45,  52.5, 60,  67.5,
                               75, 82.5, 90, 105,  120, 135,  150, 165,  180, -1},
                      .tessellation = {4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128},
                      .timed = {4, 8, 16, 32, 64, 128},
                      .column = 480,
                      .panel = 160,
                      .width = 640,
                      .height = 480,
                      .frames = 60,
                      .timed_width = 640,
                      .timed_height = 480,
                      .seconds = 60.0},
};

/* FINE: of the ball whose pictures are held against closed forms. SHOWN: of the ball on the sheet. */
enum { EXPONENT = 8, POINTS = 20000, FINE = 96, SHOWN = 64 };

/* What the sheet shows, in its order; of a scene's objects, in the scene's light, those of the first beta. */
static const struct {
    const char *effect;
    double beta;
    const char *monochrome;
} panels[] = {
    {"kajiya-printed", 30, "off"},   {"kajiya", 30, "off"},
    {"goldman-printed", 30, "off"},  {"goldman", 30, "off"},
    {"kajiya-printed", 150, "off"},  {"kajiya", 150, "off"},
    {"goldman-printed", 150, "off"}, {"goldman", 150, "off"},
    {"lambert", 30, "off"},          {"phong", 30, "off"},
    {"lengyel", 30, "off"},          {"kajiya", 30, "on"},
};
enum { PANELS = sizeof panels / sizeof panels[0] };

struct point {
    struct rl_run *run;
    const struct rl_place *place;
    const struct grid *grid;
    int group;
    struct rl_error *error;
    bool own; /* the study's ball, and not a scene's objects */
};

#define ADD(p, ...) rl_run_add((p)->run, (p)->place, (p)->group, (p)->error, __VA_ARGS__)

/* Whether a figure shows the line. */
static const char *line_of(double beta, const char *effect)
{
    bool kajiya = strncmp(effect, "kajiya", 6) == 0, goldman = strncmp(effect, "goldman", 7) == 0;
    return (beta == 0.0 && (kajiya || goldman)) || (beta == 30.0 && kajiya) || (beta == 150.0 && goldman)
               ? "on"
               : "off";
}

static bool add_terms(struct point *p)
{
    bool ok = ADD(p, "series=terms points=%d", POINTS);
    p->group++;
    for (const double *b = p->grid->beta; *b >= 0.0; b++, p->group++)
        for (int i = 0; i < 4 && ok; i++)
            ok = ADD(p, "series=form beta=%g exponent=%d sines=%s sign=%s line=%s", *b, EXPONENT,
                     i / 2 ? "plus" : "minus", i % 2 ? "kept" : "lost", line_of(*b, "kajiya"));
    return ok;
}

static bool add_profiles(struct point *p)
{
    bool ok = true;
    for (const double *b = p->grid->beta; *b >= 0.0; b++, p->group++)
        for (const char *const *e = rl_fur_models; *e && ok; e++)
            ok = ADD(p,
                     "series=profile beta=%g effect=%s exponent=%d tessellation=%d width=9 height=%d line=%s",
                     *b, *e, EXPONENT, FINE, p->grid->column, line_of(*b, *e));
    return ok;
}

static bool add_sheet(struct point *p)
{
    bool ok = true;
    int width = p->grid->panel, height = p->own ? width : width * 3 / 4;
    for (int i = 0; i < PANELS && ok; i++) {
        char ball[64] = "";
        if (p->own)
            snprintf(ball, sizeof ball, " beta=%g tessellation=%d", panels[i].beta, SHOWN);
        else if (panels[i].beta != panels[0].beta)
            continue;
        ok = ADD(p, "series=panel effect=%s%s monochrome=%s exponent=%d width=%d height=%d", panels[i].effect,
                 ball, panels[i].monochrome, EXPONENT, width, height);
    }
    p->group++;
    return ok;
}

/* What of a ball belongs to a case: its light and its mesh. */
static const char *ball(char text[64], const struct point *p, int tessellation)
{
    text[0] = '\0';
    if (p->own)
        snprintf(text, 64, " beta=30 tessellation=%d", tessellation);
    return text;
}

static bool add_pairs(struct point *p)
{
    static const int of_scene[] = {1, 0};
    char text[64];
    bool ok = true;
    for (const char *const *e = rl_fur_models; *e; e++) {
        for (const int *t = p->own ? p->grid->tessellation : of_scene; *t > 0 && ok; t++)
            ok = ADD(p, "series=vertex effect=%s%s exponent=%d width=%d height=%d", *e, ball(text, p, *t),
                     EXPONENT, p->grid->width, p->grid->height);
        p->group++;
        ok = ok && ADD(p, "series=mono effect=%s%s exponent=%d width=%d height=%d", *e, ball(text, p, SHOWN),
                       EXPONENT, p->grid->width, p->grid->height);
        p->group++;
    }
    return ok;
}

static bool add_arm(struct point *p, const char *effect, const char *interpolation, const char *monochrome,
                    const char *arm, int tessellation)
{
    const struct grid *g = p->grid;
    char text[64];
    return ADD(p,
               "series=time effect=%s%s exponent=%d interpolation=%s monochrome=%s arm=%s width=%d height=%d "
               "frames=%d seconds=%g",
               effect, ball(text, p, tessellation), EXPONENT, interpolation, monochrome, arm, g->timed_width,
               g->timed_height, g->frames, g->seconds);
}

/* All models, per pixel and per vertex, by turns. */
static bool add_times(struct point *p, int tessellation)
{
    static const char *const others[] = {"lambert", "phong", NULL};
    bool ok = add_arm(p, "none", "phong", "off", "frame", tessellation);
    for (int i = 0; i < 2; i++)
        for (const char *const *e = i ? rl_fur_models : others; *e && ok; e++)
            ok = add_arm(p, *e, "phong", "off", "frame", tessellation) &&
                 add_arm(p, *e, "gouraud", "off", "frame", tessellation);
    ok = ok && add_arm(p, "kajiya", "phong", "on", "frame", tessellation) &&
         add_arm(p, "goldman", "phong", "on", "frame", tessellation) &&
         add_arm(p, "kajiya", "phong", "off", "again", tessellation);
    p->group++;
    return ok;
}

static int plan_alone(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                      struct rl_error *error)
{
    struct point p = {run, place, &grids[grid], group, error, true};
    bool ok = add_terms(&p) && add_profiles(&p) && add_sheet(&p) && add_pairs(&p);
    for (const int *t = p.grid->timed; *t > 0 && ok; t++)
        ok = add_times(&p, *t);
    return ok ? RL_OK : RL_ERR_SYSTEM;
}

static int plan(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                struct rl_error *error)
{
    struct point p = {run, place, &grids[grid], group, error, false};
    return add_sheet(&p) && add_pairs(&p) && add_times(&p, 0) ? RL_OK : RL_ERR_SYSTEM;
}

/* ---- Tables ---- */

static const struct rl_column term_columns[] = {
    {"points", RL_COLUMN_NUMBER, "points"},      {"wrong", RL_COLUMN_VALUE, "wrong"},
    {"right", RL_COLUMN_VALUE, "right"},         {"direction", RL_COLUMN_VALUE, "direction"},
    {"inputs", RL_COLUMN_VALUE, "inputs"},       {"undefined_listing", RL_COLUMN_VALUE, "undefined_listing"},
    {"undefined", RL_COLUMN_VALUE, "undefined"},
};

static const struct rl_column form_columns[] = {
    {"beta_degrees", RL_COLUMN_NUMBER, "beta"}, {"exponent", RL_COLUMN_NUMBER, "exponent"},
    {"sines", RL_COLUMN_TEXT, "sines"},         {"sign", RL_COLUMN_TEXT, "sign"},
    {"middle", RL_COLUMN_VALUE, "middle"},      {"rim", RL_COLUMN_VALUE, "rim"},
    {"least", RL_COLUMN_VALUE, "least"},
};

static const struct rl_column profile_columns[] = {
    {"beta_degrees", RL_COLUMN_NUMBER, "beta"},
    {"effect", RL_COLUMN_TEXT, "effect"},
    {"exponent", RL_COLUMN_NUMBER, "exponent"},
    RL_COLUMNS_WITH_INTERVAL("middle"),
    RL_COLUMNS_WITH_INTERVAL("rim"),
    RL_COLUMNS_WITH_INTERVAL("least"),
    {"off", RL_COLUMN_VALUE, "off"},
};

#define COLUMNS_OF_A_PICTURE                                                                                 \
    {"scene", RL_COLUMN_SCENE, NULL}, {"effect", RL_COLUMN_TEXT, "effect"},                                  \
        {"exponent", RL_COLUMN_NUMBER, "exponent"}, {"width_px", RL_COLUMN_NUMBER, "width"},                 \
    {                                                                                                        \
        "height_px", RL_COLUMN_NUMBER, "height"                                                              \
    }

static const struct rl_column sheet_columns[] = {
    COLUMNS_OF_A_PICTURE,
    {"beta_degrees", RL_COLUMN_NUMBER, "beta"},
    {"monochrome", RL_COLUMN_TEXT, "monochrome"},
    {"exposure", RL_COLUMN_VALUE, "exposure"},
    {"clipped", RL_COLUMN_VALUE, "clipped"},
    {"negative", RL_COLUMN_VALUE, "negative"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_column vertex_columns[] = {
    COLUMNS_OF_A_PICTURE,
    {"tessellation", RL_COLUMN_NUMBER, "tessellation"},
    {"triangles", RL_COLUMN_VALUE, "triangles"},
    {"rmse", RL_COLUMN_VALUE, "rmse"},
    {"max", RL_COLUMN_VALUE, "max"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_column mono_columns[] = {
    COLUMNS_OF_A_PICTURE,
    {"rmse", RL_COLUMN_VALUE, "rmse"},
    {"max", RL_COLUMN_VALUE, "max"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

static const struct rl_column time_columns[] = {
    COLUMNS_OF_A_PICTURE,
    {"interpolation", RL_COLUMN_TEXT, "interpolation"},
    {"monochrome", RL_COLUMN_TEXT, "monochrome"},
    {"arm", RL_COLUMN_TEXT, "arm"},
    {"tessellation", RL_COLUMN_NUMBER, "tessellation"},
    {"draws", RL_COLUMN_VALUE, "draws"},
    {"triangles", RL_COLUMN_VALUE, "triangles"},
    RL_COLUMNS_WITH_INTERVAL("frame_ms"),
    RL_COLUMNS_WITH_INTERVAL("above_baseline_ms"),
    RL_COLUMNS_WITH_INTERVAL("time_to_pixel"),
    {"frames", RL_COLUMN_VALUE, "frames"},
    {"time_precision", RL_COLUMN_VALUE, "time_precision"},
    {"time_capped", RL_COLUMN_VALUE, "time_capped"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

#define TABLE(name, summary, pattern, columns)                                                               \
    {                                                                                                        \
        name, summary, pattern, columns, sizeof(columns) / sizeof((columns)[0])                              \
    }

static const struct rl_table tables[] = {
    TABLE("fur_terms", "Identities of the models, as listed and right, and inputs without a kappa",
          "series=terms", term_columns),
    TABLE("fur_form", "Kajiya's highlight with either, both or none of the listing's faults", "series=form",
          form_columns),
    TABLE("fur_profile", "Radiance along the ball's middle column, against the closed form", "series=profile",
          profile_columns),
    TABLE("fur_sheet", "The panels of the contact sheet", "series=panel", sheet_columns),
    TABLE("fur_vertex", "Fur evaluated at vertices against fur evaluated at pixels", "series=vertex",
          vertex_columns),
    TABLE("fur_mono", "Fur in shades of grey against fur in colour", "series=mono", mono_columns),
    TABLE("fur_time", "Frames of each model, per pixel and per vertex", "series=time", time_columns),
};

static const struct rl_figure figures_alone[] = {
    {"sheet",
     "The models on a ball, seen along the fibre in its middle, in one light and one exposure; as printed "
     "and "
     "corrected side by side. Light from 30 degrees above the eye; back-lit: from 150 degrees."},
    {"causes",
     "Which fault makes the middle glow: the highlight alone, by the angle between fibre and eye, for both "
     "faults of the listing together (the wrong sign of the sines, the lost sign of the cosine), one by one, "
     "and for neither. With the sign kept the middle is dark, whatever the sines' sign."},
    {"kajiya", "Radiance of Kajiya's fur along the ball's middle column, of pictures (marks) and in closed "
               "form (lines)."},
    {"goldman", "The same of Goldman's: as listed, Lambert's term goes from -1 to 3."},
    {"glow", "Radiance in the middle of the ball, where the fibre points at the eye, against the angle "
             "between light and eye: of pictures (marks), and k_d sin beta + k_s cos^p beta and its like "
             "(lines)."},
    {"vertex",
     "Error of fur at the vertices against fur at each pixel, over the triangles of the ball. Grey: 1/255."},
    {"time",
     "What each model adds to the frame of a ball in ambient light, per pixel and per vertex, with "
     "95 % intervals. Grey: two arms of the same work differ by as much. The fewest triangles timed."},
    {"time-many", "The same of the most triangles timed."},
};

static const struct rl_figure figures[] = {
    {"sheet", "The scene's objects in each model of fur, as printed and corrected, in the scene's light and "
              "one exposure."},
    {"error", "Error of fur at the vertices of the scene's meshes against fur at each pixel. Grey: 1/255."},
    {"time", "What each model adds to the frame of the scene in ambient light, per pixel and per vertex, "
             "with 95 % intervals. Grey: two arms of the same work differ by as much."},
};

static const struct rl_sweep sweeps[] = {
    {.name = "beta", .kind = RL_SWEEP_REAL, .low = 0, .high = 180},
    {.name = "exponent", .kind = RL_SWEEP_REAL, .low = 1, .high = 1000},
    {.name = "points", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 1000000},
    {.name = "tessellation",
     .of = "series=vertex",
     .kind = RL_SWEEP_WHOLE,
     .low = 1,
     .high = 512,
     .together = 30},
    {.name = "tessellation", .of = "series=time", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 512},
    RL_SWEEP_PIXELS("width", "series=panel"),
    RL_SWEEP_PIXELS("width", "series=vertex"),
    RL_SWEEP_PIXELS("width", "series=mono"),
    RL_SWEEP_PIXELS("width", "series=time"),
    RL_SWEEP_PIXELS("height", NULL),
    {.name = "frames", .of = "series=time", .kind = RL_SWEEP_WHOLE, .low = 6, .high = 100000},
};

static const char *const scenes[] = {"lamps", NULL};

static const struct rl_cost costs[] = {{.pattern = "series=time", .picture = 0.001, .pixel = 0.04},
                                       {.pattern = "series=form", .group = 0.0001},
                                       {.pattern = "", .group = 0.035}};

const struct rl_study rl_study_fur = {
    .name = "fur",
    .summary = "models of fur side by side, printed and corrected; where the glow comes from; cost per "
               "vertex and per pixel",
    .text = "A ball in fur whose fibres stand along its normals, by Kajiya, Goldman and Lengyel, as a widely "
            "copied vertex shader lists them and corrected, beside Lambert's and Phong's surface. Profiles "
            "of its pictures are held against closed forms; the two faults of the listed highlight are taken "
            "one by one. Fur at the vertices, as listed, is held against fur at each pixel: the error, and "
            "the time of frames that take turns with a ball in ambient light alone and with a second arm of "
            "the same work. On a scene all of its objects wear the fur.",
    .scenes = scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures = figures,
    .n_figures = sizeof figures / sizeof figures[0],
    .figures_alone = figures_alone,
    .n_figures_alone = sizeof figures_alone / sizeof figures_alone[0],
    .fits = rl_effects_fits,
    .plan = plan,
    .plan_alone = plan_alone,
    .sweeps = {sweeps, sizeof sweeps / sizeof sweeps[0]},
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_fur_measure,
    .judge = rl_fur_judge,
};
