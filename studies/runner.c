/* Plans, skips, measures and stores (see runner.h). */
#include "studies/runner.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/paths.h"
#include "results/database.h"

enum { SCENES_MAX = 64 };

/* One study at work. */
struct work {
    const struct rl_study *study;
    const struct rl_run_options *options;
    struct rl_bench *bench;
    struct rl_database *database;
    struct rl_run_outcome *outcome;
    size_t n_scenes;
    struct rl_scene scene[SCENES_MAX];
    struct rl_run run;
};

int rl_study_scene_load(struct rl_scene *scene, const char *name, struct rl_error *error)
{
    if (access(name, F_OK) == 0 || strchr(name, '/') || strchr(name, '.'))
        return rl_scene_load(scene, name, error);
    char relative[NAME_MAX + 32], path[PATH_MAX];
    /* In the source tree, or as installed. */
    snprintf(relative, sizeof relative, "studies/scenes/%.200s.yaml", name);
    if (rl_path_data(path, sizeof path, relative, NULL) != RL_OK) {
        snprintf(relative, sizeof relative, "scenes/%.200s.yaml", name);
        if (rl_path_data(path, sizeof path, relative, NULL) != RL_OK)
            return rl_fail(error, RL_ERR_INPUT,
                           "%s: no file of that name, and no scene shipped with roughlight", name);
    }
    return rl_scene_load(scene, path, error);
}

/* The file's name without folder and ending. */
static void scene_name(char name[RL_NAME_MAX], const char *path)
{
    const char *slash = strrchr(path, '/');
    snprintf(name, RL_NAME_MAX, "%s", slash ? slash + 1 : path);
    char *dot = strrchr(name, '.');
    if (dot && dot > name)
        *dot = '\0';
}

static int next_group(const struct work *w)
{
    return w->run.n_records ? w->run.record[w->run.n_records - 1].group + 1 : 0;
}

static int plan_alone(struct work *w, struct rl_error *error)
{
    const struct rl_place place = {w->study->name, RL_NO_SCENE, "", 0};
    return w->study->plan_alone(&w->run, &place, w->options->grid, next_group(w), error);
}

static int plan_scene(struct work *w, const char *path, struct rl_error *error)
{
    if (w->n_scenes == SCENES_MAX)
        return rl_fail(error, RL_ERR_INPUT, "--scene: more than %d scenes", SCENES_MAX);
    struct rl_scene *scene = &w->scene[w->n_scenes];
    int status = rl_study_scene_load(scene, path, error);
    if (status != RL_OK)
        return status;
    w->n_scenes++;
    char name[RL_NAME_MAX];
    scene_name(name, path);
    if (strcmp(name, RL_NO_SCENE) == 0)
        return rl_fail(error, RL_ERR_INPUT,
                       "--scene: %s: '%s' stands for no scene, expected a file of another name", path, name);
    for (size_t i = 0; i < w->run.n_records; i++)
        if (strcmp(w->run.record[i].scene, name) == 0)
            return rl_fail(error, RL_ERR_INPUT, "--scene: %s: a scene called '%s' was given before", path,
                           name);
    struct rl_place place = {w->study->name, name, path, scene->hash};
    return w->study->plan(&w->run, &place, w->options->grid, next_group(w), error);
}

static int plan(struct work *w, struct rl_error *error)
{
    w->run.provenance = w->bench->provenance;
    snprintf(w->run.study, sizeof w->run.study, "%s", w->study->name);
    snprintf(w->run.grid, sizeof w->run.grid, "%s", rl_grid_name(w->options->grid));
    rl_provenance_now(w->run.started);
    int status = w->study->plan_alone ? plan_alone(w, error) : RL_OK;
    for (size_t i = 0; i < w->options->n_scenes && status == RL_OK; i++)
        status = plan_scene(w, w->options->scenes[i], error);
    for (size_t i = 0; !w->options->n_scenes && w->study->scenes[i] && status == RL_OK; i++)
        status = plan_scene(w, w->study->scenes[i], error);
    if (status != RL_OK)
        return status;
    char environment[RL_HASH_TEXT];
    rl_provenance_environment(&w->bench->provenance, environment);
    rl_run_identify(&w->run, environment);
    return rl_database_begin_run(w->database, &w->run, error);
}

static size_t group_end(const struct rl_run *run, size_t first)
{
    size_t end = first + 1;
    while (end < run->n_records && run->record[end].group == run->record[first].group)
        end++;
    return end;
}

static int group_done(struct work *w, size_t first, size_t end, bool *done, struct rl_error *error)
{
    *done = true;
    int status = RL_OK;
    for (size_t i = first; i < end && *done && status == RL_OK; i++)
        status = rl_database_done(w->database, w->run.record[i].identity, done, error);
    return status;
}

/* NULL for a case without one. */
static const struct rl_scene *scene_of(const struct work *w, const struct rl_record *r)
{
    if (strcmp(r->scene, RL_NO_SCENE) == 0)
        return NULL;
    uint64_t hash = strtoull(r->scene_hash, NULL, 16);
    size_t i = 0;
    while (w->scene[i].hash != hash)
        i++;
    return &w->scene[i];
}

static int measure_group(struct work *w, size_t first, size_t end, struct rl_error *error)
{
    struct rl_record *r = &w->run.record[first];
    double start = rl_clock_seconds();
    struct rl_error why = {0};
    int status = w->study->measure(r, end - first, w->bench, scene_of(w, r), &why);
    if (status == RL_ERR_CANCELLED) {
        if (error)
            *error = why;
        return status;
    }
    for (size_t i = first; i < end; i++) {
        struct rl_record *each = &w->run.record[i];
        each->seconds = rl_clock_seconds() - start;
        each->status = status == RL_OK ? RL_RECORD_OK : RL_RECORD_FAILED;
        if (status != RL_OK) {
            rl_record_reset(each);
            snprintf(each->message, sizeof each->message, "%.*s", (int)sizeof each->message - 1, why.message);
        }
    }
    *(status == RL_OK ? &w->outcome->measured : &w->outcome->failed) += end - first;
    return rl_database_store(w->database, &w->run, first, end - first, error);
}

/* How many groups are to be measured; what is done is counted as skipped. */
static int count_pending(struct work *w, size_t *pending, struct rl_error *error)
{
    int status = RL_OK;
    *pending = 0;
    for (size_t first = 0, end; first < w->run.n_records && status == RL_OK; first = end) {
        bool done = false;
        end = group_end(&w->run, first);
        status = group_done(w, first, end, &done, error);
        *pending += !done;
        w->outcome->skipped += done ? end - first : 0;
    }
    return status;
}

/* Measures what is not done. */
static int measure(struct work *w, const struct rl_progress *progress, struct rl_error *error)
{
    size_t pending, finished = 0;
    int status = count_pending(w, &pending, error);
    for (size_t first = 0, end; first < w->run.n_records && status == RL_OK; first = end) {
        bool done = false;
        end = group_end(&w->run, first);
        status = group_done(w, first, end, &done, error);
        if (status != RL_OK || done)
            continue;
        if (rl_progress_cancelled(progress))
            return rl_fail(error, RL_ERR_CANCELLED, "interrupted; what was finished is kept");
        status = measure_group(w, first, end, error);
        if (status == RL_OK)
            rl_progress_update(progress, w->study->name, ++finished, pending);
    }
    return status;
}

static int run_study(struct rl_run_outcome *outcome, const struct rl_study *study, struct rl_bench *bench,
                     struct rl_database *database, const struct rl_run_options *options,
                     const struct rl_progress *progress, struct rl_error *error)
{
    struct work *w = calloc(1, sizeof *w);
    if (!w)
        return rl_fail_memory(error, study->name);
    w->study = study;
    w->options = options;
    w->bench = bench;
    w->database = database;
    w->outcome = outcome;
    int status = plan(w, error);
    outcome->planned += w->run.n_records;
    if (status == RL_OK)
        status = measure(w, progress, error);
    for (size_t i = 0; i < w->n_scenes; i++)
        rl_scene_clear(&w->scene[i]);
    rl_run_clear(&w->run);
    free(w);
    return status;
}

int rl_studies_run(struct rl_run_outcome *outcome, const struct rl_study *const *studies, size_t n_studies,
                   const struct rl_run_options *options, const struct rl_progress *progress,
                   struct rl_error *error)
{
    *outcome = (struct rl_run_outcome){0};
    struct rl_bench bench = {0};
    struct rl_database *database = NULL;
    int status = rl_database_open(&database, options->database, RL_DATABASE_WRITE, error);
    if (status == RL_OK)
        status = rl_bench_open(&bench, options->backend, options->threads, options->cache, progress, error);
    for (size_t i = 0; i < n_studies && status == RL_OK; i++)
        status = run_study(outcome, studies[i], &bench, database, options, progress, error);
    rl_bench_close(&bench);
    rl_database_close(database);
    return status;
}
