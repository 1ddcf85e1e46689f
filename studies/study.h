/* Studies: what is measured, on what grid, and which claims follow. Each is studies/NAME.c here <-> plots/NAME.gp, one descriptor,
 * one row of rl_studies (table.c).
 *
 * A study plans cases (records with parameters, see results/record.h), measures them group by group, and judges the run that
 * the database gives back. It never prints and never skips: runner.c does what is common to all, so that a killed run goes on
 * where it was, and report.c turns the descriptor's tables, figures and claims into the page.
 *
 * To add one: write studies/NAME.c with a descriptor `rl_study_NAME` and plots/NAME.gp with its figures, and add its row.
 */
#ifndef RL_STUDIES_STUDY_H
#define RL_STUDIES_STUDY_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "results/claims.h"
#include "results/export.h"
#include "results/record.h"
#include "scene/scene.h"
#include "studies/axis.h"
#include "studies/bench.h"
#include "studies/cost.h"

/* How much of a study's grid is measured. */
enum rl_grid {
    RL_GRID_QUICK,   /* seconds: to see that all works */
    RL_GRID_DEFAULT, /* a few minutes with all other studies */
    RL_GRID_FULL     /* as long as it takes */
};

/* "quick", "default", "full" */
const char *rl_grid_name(enum rl_grid grid);

/* In a record's place: cases that no scene enters into. */
#define RL_NO_SCENE "none"

/* A picture that plots/NAME.gp draws: `name` is handed to the script and is part of the file's name, NAME-name.svg. */
struct rl_figure {
    const char *name;
    const char *caption; /* what is shown and how to read it */
};

/* Ends the caption of a figure with a logarithmic axis that has no place for what was measured (plots/style.gp). */
#define RL_CAPTION_EDGE                                                                                      \
    " A mark with an arrow to the frame is at or below the edge there, zero included; a bar that ends at "   \
    "the frame goes on below it."

struct rl_study {
    const char *name;
    const char *summary; /* one line for lists */
    const char *text;    /* a paragraph for the page: what is measured and how */
    const char *const
        *scenes; /* names of shipped scenes, NULL at the end: what it runs on if none is given */
    const struct rl_table *tables;
    size_t n_tables;
    const struct rl_table *derived_tables; /* of what `derive` makes */
    size_t n_derived_tables;
    const struct rl_figure *figures; /* of each scene */
    size_t n_figures;
    /* Beside `figures`: each is drawn for scenes that have a measured case which matches; NULL: for all. */
    const char *const *figure_patterns;
    const struct rl_figure *figures_alone; /* of the cases without a scene */
    size_t n_figures_alone;
    /* Whether a scene is one that it can run on, asked before anything is planned (RL_ERR_INPUT: why not); NULL: any with a shaped light and
     * a highlight in view (scene_check.h). */
    int (*fits)(const struct rl_scene *scene, struct rl_error *error);
    /* Adds the cases of one scene to `run`. Groups are numbered from `first_group` on. NULL: it takes no scene, and being given one is
     * an error; `scenes` is empty then, and there is plan_alone. */
    int (*plan)(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int first_group,
                struct rl_error *error);
    /* The same for the cases that no scene enters into, planned before any scene's; NULL: there are none. */
    int (*plan_alone)(struct rl_run *run, const struct rl_place *place, enum rl_grid grid, int first_group,
                      struct rl_error *error);
    /* The parameters of its cases that `study run --axis` may replace. */
    struct rl_sweeps sweeps;
    /* What of swept cases only this study can tell, and whether the scene allows for it (RL_ERR_INPUT: why not); either NULL: nothing. */
    rl_parameters_check *check;
    int (*check_scene)(const char *parameters, const struct rl_scene *scene, struct rl_error *error);
    /* What its groups take, where nothing is known of them yet; none: that is not known either. */
    const struct rl_cost *costs;
    size_t n_costs;
    /* Measures the n records of one group: fills metrics and series. An error makes the group's cases failed ones. `scene` is NULL
     * for those of plan_alone. */
    int (*measure)(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                   struct rl_error *error);
    /* Figures that follow from many rows together, such as fitted models: records made from a run's, for derived_tables. NULL: none.
     * Nothing of it is kept in the database. On an error there is nothing to clear. */
    int (*derive)(struct rl_run *derived, const struct rl_run *run, struct rl_error *error);
    /* Judges what was measured, scene by scene; a claim whose cases are missing is inconclusive. A claim is begun before the figures it
     * rests on are read: so it is known which cases it comes from (results/trace.h). */
    int (*judge)(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);
};

extern const struct rl_study *const rl_studies[];
extern const size_t rl_n_studies;

/* NULL if there is none of that name. */
const struct rl_study *rl_study_find(const char *name);

/* The options that give the run's grid again: "", " --quick", " --axis rr=1,2". */
void rl_run_arguments(char text[], size_t size, const struct rl_run *run);

/* The command that measures the run's cases of n scenes, RL_NO_SCENE among them or not: "roughlight study run NAME --scene A --scene B
 * --quick", words quoted for a shell; n = 0: those of the study's own scenes. */
void rl_run_command(char text[], size_t size, const struct rl_run *run, const char *const *scenes, size_t n);

/* Whether a run's scenes are those that the study runs on if none is given. */
bool rl_run_has_own_scenes(const struct rl_run *run);

/* Writes "roughlight study run NAME --scene SCENE" (without --scene for RL_NO_SCENE) with the run's grid into a claim, and the names of study and scene. */
void rl_claim_source(struct rl_claim *claim, const struct rl_run *run, const char *scene);

/* The i-th different scene among a run's records, by name, RL_NO_SCENE included; NULL past the last. */
const char *rl_run_scene(const struct rl_run *run, size_t i);

#endif
