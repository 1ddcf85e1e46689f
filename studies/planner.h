/* Plans: the cases of one study on its scenes, with the axes asked for and every case's identity. Nothing is measured or written.
 *
 *     struct rl_planned *planned;
 *     rl_planned_make(&planned, study, &options, &bench.provenance, &error);
 *     for (size_t first = 0; first < planned->run.n_records; first = rl_group_end(&planned->run, first)) ...
 *     rl_planned_free(planned);
 */
#ifndef RL_STUDIES_PLANNER_H
#define RL_STUDIES_PLANNER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "studies/axis.h"
#include "studies/study.h"

/* What of the studies is wanted, and with what it is measured. */
struct rl_run_options {
    const char *database; /* its file */
    const char *cache;    /* folder for references */
    const char *backend;
    int threads;
    enum rl_grid grid;
    const char *const *scenes; /* files or names of shipped scenes; n_scenes = 0: each study's own */
    size_t n_scenes;
    const struct rl_axis *axes;
    size_t n_axes;
    bool retry;          /* measure failed cases again */
    bool again;          /* measure all cases again, done or failed */
    int shard, n_shards; /* measure this share of the groups only, 1 <= shard <= n_shards; 0, 0: all */
};

enum { RL_PLANNED_SCENES_MAX = 64 };

struct rl_planned {
    const struct rl_study *study;
    size_t n_scenes;
    struct rl_scene scene[RL_PLANNED_SCENES_MAX];
    struct rl_run run;
};

int rl_planned_make(struct rl_planned **planned, const struct rl_study *study,
                    const struct rl_run_options *options, const struct rl_provenance *provenance,
                    struct rl_error *error);
/* NULL is fine. */
void rl_planned_free(struct rl_planned *planned);

/* The scene of one of its records; NULL for a case without one. */
const struct rl_scene *rl_planned_scene(const struct rl_planned *planned, const struct rl_record *record);

/* One past the last record of the group that begins at `first`. */
size_t rl_group_end(const struct rl_run *run, size_t first);

/* Whether the group that begins at `first` is in the share asked for. A group's share follows from what its cases are, whatever their
 * order, the grid around them, and the machine. */
bool rl_group_wanted(const struct rl_run *run, size_t first, const struct rl_run_options *options);

/* Loads a scene by file name, or a shipped one by its name ("teapot-star"). */
int rl_study_scene_load(struct rl_scene *scene, const char *name, struct rl_error *error);

#endif
