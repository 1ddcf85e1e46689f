/* The study `hard`: how far are the model's functions, in C and in GLSL, from exact answers, at the catalogue's hard cases
 * (tests/hard) and over maps of their arguments? */
#include "studies/hard.h"

#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "base/hash.h"

const char *rl_hard_backend(enum rl_catalogue_backend backend)
{
    static const char *const name[] = {[RL_CATALOGUE_CPU] = "cpu", [RL_CATALOGUE_GPU] = "gpu"};
    return name[backend];
}

/* The files of the catalogue, or of its maps. */
static int list_files(char ***paths, size_t *n, bool maps, struct rl_error *error)
{
    char folder[4096];
    *paths = NULL;
    *n = 0;
    int status = maps ? rl_map_folder(folder, sizeof folder, error)
                      : rl_catalogue_folder(folder, sizeof folder, error);
    return status == RL_OK ? rl_catalogue_list(paths, n, folder, error) : status;
}

/* A file's name without folder and ending. */
static void name_of(char name[], size_t size, const char *path)
{
    const char *base = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    snprintf(name, size, "%.*s", (int)(strlen(base) - strlen(".tsv")), base);
}

/* Both backends of one file make a group. */
static int plan_file(struct rl_run *run, const struct rl_place *place, const char *path, bool map, int group,
                     struct rl_error *error)
{
    struct rl_probe probe;
    char name[RL_NAME_MAX], *data, hash[RL_HASH_TEXT];
    size_t size;
    int status = rl_catalogue_find_probe(&probe, path, error);
    if (status == RL_OK)
        status = rl_file_read(&data, &size, path, error);
    if (status != RL_OK)
        return status;
    rl_hash_text(hash, rl_hash_bytes(RL_HASH_START, data, size));
    free(data);
    name_of(name, sizeof name, path);
    for (int b = 0; b < RL_CATALOGUE_BACKENDS && status == RL_OK; b++) {
        const char *backend = rl_hard_backend((enum rl_catalogue_backend)b);
        if (b == RL_CATALOGUE_GPU && rl_probe_check_gpu(&probe, NULL) != RL_OK)
            continue;
        const struct rl_record *r =
            map ? rl_run_add(run, place, group, error, "series=map map=%s function=%s backend=%s data=%s",
                             name, probe.name, backend, hash)
                : rl_run_add(run, place, group, error, "series=rows function=%s backend=%s data=%s",
                             probe.name, backend, hash);
        status = r ? RL_OK : RL_ERR_SYSTEM;
    }
    return status;
}

static int plan_alone(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int group,
                      struct rl_error *error)
{
    (void)grid; /* every grid is all of it: it takes a second */
    int status = RL_OK;
    for (int maps = 0; maps < 2 && status == RL_OK; maps++) {
        char **paths;
        size_t n;
        status = list_files(&paths, &n, maps != 0, error);
        for (size_t i = 0; i < n && status == RL_OK; i++)
            status = plan_file(run, place, paths[i], maps != 0, group++, error);
        rl_catalogue_list_free(paths, n);
    }
    return status;
}

static const struct rl_column row_columns[] = {
    {"function", RL_COLUMN_TEXT, "function"},    {"backend", RL_COLUMN_TEXT, "backend"},
    {"rows", RL_COLUMN_VALUE, "rows"},           {"failed", RL_COLUMN_VALUE, "failed"},
    {"worst_ulp", RL_COLUMN_VALUE, "worst_ulp"}, {"worst_share", RL_COLUMN_VALUE, "worst_share"},
    {"error", RL_COLUMN_VALUE, "error"},         {"bound", RL_COLUMN_VALUE, "bound"},
    {"line", RL_COLUMN_VALUE, "line"},           {"why", RL_COLUMN_REMARK, NULL},
};

static const struct rl_column map_columns[] = {
    {"map", RL_COLUMN_TEXT, "map"},
    {"backend", RL_COLUMN_TEXT, "backend"},
    {"points", RL_COLUMN_VALUE, "points"},
    {"worst_ulp", RL_COLUMN_VALUE, "worst_ulp"},
    {"median_ulp", RL_COLUMN_VALUE, "median_ulp"},
    {"worst_share", RL_COLUMN_VALUE, "worst_share"},
    {"beyond", RL_COLUMN_VALUE, "beyond"},
    {"conditioned_points", RL_COLUMN_VALUE, "conditioned_points"},
};

static const struct rl_table tables[] = {
    {"hard_rows",
     "The catalogue of hard cases: each function's worst error by backend; the line of its file that takes "
     "the "
     "largest share of its bound, which result, and why it is hard",
     "series=rows", row_columns, sizeof row_columns / sizeof row_columns[0]},
    {"hard_maps",
     "Maps of arguments: errors of their points in units in the last place, and shares of bounds",
     "series=map", map_columns, sizeof map_columns / sizeof map_columns[0]},
};

/* How all maps are read. */
#define MAP_KEY                                                                                              \
    " Left in C, in units in the last place of double precision, right in GLSL, in those of single (of "     \
    "answers "                                                                                               \
    "below 0.1 in those of 0.1, for there the bound is absolute). White: right to within 1/16 of a unit, "   \
    "zero "                                                                                                  \
    "included; the scale has marks where the bounds are, 8 units and 1e-5. Dots: above that, by no more "    \
    "than "                                                                                                  \
    "rounding the arguments moves the answer. Orange squares: beyond the bound."

static const struct rl_figure figures_alone[] = {
    {"rows",
     "The worst row of each function, as a share of its bound: 8 ulp in C, 1e-5 of the answer or 1e-6 in "
     "GLSL, or what the arguments' rounding does." RL_CAPTION_EDGE},
    {"ellipsoid-pdf",
     "D(delta) over R_r and delta, spaced evenly by how near they are to 1, 0 and +-pi/2." MAP_KEY},
    {"ellipsoid-cdf", "U(delta), likewise." MAP_KEY},
    {"ellipsoid-inverse", "delta(U) and its cosine, the worse of both, over R_r and U." MAP_KEY},
    {"attenuation", "G over N.V and N.L, for N.H = 3/4 and V.H = 1/2: grazing directions have more room than "
                    "others." MAP_KEY},
    {"cook-torrance",
     "Cook and Torrance's reflection over N.V and N.L; V and L are 127 degrees of azimuth apart." MAP_KEY},
    {"frame",
     "The tangent frame over the sphere of N, fine at the poles and at +-x: the worst of six components, in "
     "the last place of 1." MAP_KEY},
    {"frame-printed",
     "The same of the frame as printed, against what is printed: where it collapses (+-x) it does so "
     "exactly." MAP_KEY},
};

static const struct rl_cost costs[] = {{.pattern = "", .group = 0.02}};

static const char *const no_scenes[] = {NULL};

const struct rl_study rl_study_hard = {
    .name = "hard",
    .summary = "hard cases: functions of the model in C and in GLSL against exact answers, at the "
               "catalogue's rows and "
               "over maps of their arguments",
    .text =
        "Every function that `roughlight probe` knows is held against exact answers that a program of MPFR "
        "(400 bits) wrote, at rows chosen since they are hard (tests/hard), as `make hard` does, and the "
        "central "
        "ones over maps of their arguments. Bounds: 8 units in the last place in C, and in GLSL 1e-5 of the "
        "answer, or 1e-6 where it is near 0; where the arguments' own rounding moves the answer by more, "
        "twice "
        "that. Nothing here is random: intervals are values.",
    .scenes = no_scenes,
    .tables = tables,
    .n_tables = sizeof tables / sizeof tables[0],
    .figures_alone = figures_alone,
    .n_figures_alone = sizeof figures_alone / sizeof figures_alone[0],
    .plan_alone = plan_alone,
    .costs = costs,
    .n_costs = sizeof costs / sizeof costs[0],
    .measure = rl_hard_measure,
    .judge = rl_hard_judge,
};
