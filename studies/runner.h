/* Runs studies: plans their cases, skips those the database already has, measures the rest group by group.
 *
 * A case that fails is kept with its message and does not stop the others; the next run tries it again. Each group is stored
 * as soon as it is measured, so that an interruption, however rude, loses at most the group that was being measured.
 */
#ifndef RL_STUDIES_RUNNER_H
#define RL_STUDIES_RUNNER_H

#include <stddef.h>

#include "base/error.h"
#include "base/progress.h"
#include "studies/study.h"

struct rl_run_options {
    const char *database; /* its file */
    const char *cache;    /* folder for references */
    const char *backend;
    int threads;
    enum rl_grid grid;
    const char *const *scenes; /* files or names of shipped scenes; n_scenes = 0: each study's own */
    size_t n_scenes;
};

struct rl_run_outcome {
    size_t planned, measured, skipped, failed; /* cases */
};

/* RL_OK even if cases failed: look at the outcome. RL_ERR_CANCELLED: what was finished is kept. */
int rl_studies_run(struct rl_run_outcome *outcome, const struct rl_study *const *studies, size_t n_studies,
                   const struct rl_run_options *options, const struct rl_progress *progress,
                   struct rl_error *error);

/* Loads a scene by file name, or a shipped one by its name ("teapot-star"). */
int rl_study_scene_load(struct rl_scene *scene, const char *name, struct rl_error *error);

#endif
