/* Plans a study's cases (see planner.h). */
#include "studies/planner.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/paths.h"
#include "studies/scene_check.h"

/* A study draws a scene in many sizes, the widest 16:9: the planes are to hold what any of them shows. */
static int load(struct rl_scene *scene, const char *path, struct rl_error *error)
{
    int status = rl_scene_load(scene, path, error);
    if (status == RL_OK && scene->width * 9 < scene->height * 16)
        rl_scene_fit_planes(scene, 16, 9);
    return status;
}

int rl_study_scene_load(struct rl_scene *scene, const char *name, struct rl_error *error)
{
    if (access(name, F_OK) == 0 || strchr(name, '/') || strchr(name, '.'))
        return load(scene, name, error);
    char relative[NAME_MAX + 32], path[PATH_MAX];
    /* In the source tree, or as installed. */
    snprintf(relative, sizeof relative, "studies/scenes/%.200s.yaml", name);
    if (rl_path_data(path, sizeof path, relative, NULL) != RL_OK) {
        snprintf(relative, sizeof relative, "scenes/%.200s.yaml", name);
        if (rl_path_data(path, sizeof path, relative, NULL) != RL_OK)
            return rl_fail(error, RL_ERR_INPUT,
                           "%s: no file of that name, and no scene shipped with roughlight", name);
    }
    return load(scene, path, error);
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

size_t rl_group_end(const struct rl_run *run, size_t first)
{
    size_t end = first + 1;
    while (end < run->n_records && run->record[end].group == run->record[first].group)
        end++;
    return end;
}

/* The finaliser of MurmurHash3 (Appleby, 2011): FNV's low bits alone are too regular to be dealt out by. */
static uint64_t mix(uint64_t x)
{
    x = (x ^ (x >> 33)) * UINT64_C(0xff51afd7ed558ccd);
    x = (x ^ (x >> 33)) * UINT64_C(0xc4ceb9fe1a85ec53);
    return x ^ (x >> 33);
}

bool rl_group_wanted(const struct rl_run *run, size_t first, const struct rl_run_options *options)
{
    if (options->n_shards < 2)
        return true;
    uint64_t sum = 0;
    for (size_t i = first; i < rl_group_end(run, first); i++)
        sum += mix(rl_record_key(&run->record[i]));
    return mix(sum) % (uint64_t)options->n_shards == (uint64_t)(options->shard - 1);
}

const struct rl_scene *rl_planned_scene(const struct rl_planned *p, const struct rl_record *r)
{
    if (strcmp(r->scene, RL_NO_SCENE) == 0)
        return NULL;
    uint64_t hash = strtoull(r->scene_hash, NULL, 16);
    size_t i = 0;
    while (p->scene[i].hash != hash)
        i++;
    return &p->scene[i];
}

static int next_group(const struct rl_run *run)
{
    return run->n_records ? run->record[run->n_records - 1].group + 1 : 0;
}

static int plan_alone(struct rl_planned *p, enum rl_grid grid, struct rl_error *error)
{
    const struct rl_place place = {p->study->name, RL_NO_SCENE, "", 0};
    return p->study->plan_alone(&p->run, &place, grid, next_group(&p->run), error);
}

static int plan_scene(struct rl_planned *p, const char *path, enum rl_grid grid, struct rl_error *error)
{
    if (p->n_scenes == RL_PLANNED_SCENES_MAX)
        return rl_fail(error, RL_ERR_INPUT, "--scene: more than %d scenes", RL_PLANNED_SCENES_MAX);
    struct rl_scene *scene = &p->scene[p->n_scenes];
    int status = rl_study_scene_load(scene, path, error);
    if (status != RL_OK)
        return status;
    p->n_scenes++;
    status = p->study->fits ? p->study->fits(scene, error) : rl_scene_check(scene, error);
    if (status != RL_OK)
        return status;
    char name[RL_NAME_MAX];
    scene_name(name, path);
    if (strcmp(name, RL_NO_SCENE) == 0)
        return rl_fail(error, RL_ERR_INPUT,
                       "--scene: %s: '%s' stands for no scene, expected a file of another name", path, name);
    for (size_t i = 0; i < p->run.n_records; i++)
        if (strcmp(p->run.record[i].scene, name) == 0)
            return rl_fail(error, RL_ERR_INPUT, "--scene: %s: a scene called '%s' was given before", path,
                           name);
    struct rl_place place = {p->study->name, name, path, scene->hash};
    return p->study->plan(&p->run, &place, grid, next_group(&p->run), error);
}

/* "quick --axis rr=1,2": what comes after `study run NAME` to get this grid again. */
static int name_grid(struct rl_run *run, const struct rl_run_options *options, struct rl_error *error)
{
    size_t used = (size_t)snprintf(run->grid, sizeof run->grid, "%s", rl_grid_name(options->grid));
    for (size_t i = 0; i < options->n_axes && used < sizeof run->grid; i++)
        used +=
            (size_t)snprintf(run->grid + used, sizeof run->grid - used, " --axis %s", options->axes[i].text);
    if (used < sizeof run->grid)
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "--axis: %zu bytes in all, at most %zu are kept with the results",
                   used, sizeof run->grid - 1);
}

/* Of the cases that axes made, those that their scene has no room for. */
static int check_scenes(const struct rl_planned *p, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < p->run.n_records && status == RL_OK; i++) {
        const struct rl_record *r = &p->run.record[i];
        const struct rl_scene *scene = rl_planned_scene(p, r);
        status = scene ? p->study->check_scene(r->parameters, scene, error) : RL_OK;
        if (status != RL_OK)
            rl_fail_prefix(error, "--axis: %s", r->scene);
    }
    return status;
}

static int plan(struct rl_planned *p, const struct rl_run_options *o, struct rl_error *error)
{
    if (o->n_scenes > 0 && !p->study->plan)
        return rl_fail(error, RL_ERR_INPUT, "--scene: found '%.80s', but the study %s takes no scene",
                       o->scenes[0], p->study->name);
    int status = p->study->plan_alone ? plan_alone(p, o->grid, error) : RL_OK;
    for (size_t i = 0; i < o->n_scenes && status == RL_OK; i++)
        status = plan_scene(p, o->scenes[i], o->grid, error);
    for (size_t i = 0; !o->n_scenes && p->study->scenes[i] && status == RL_OK; i++)
        status = plan_scene(p, p->study->scenes[i], o->grid, error);
    if (status == RL_OK)
        status = rl_axes_apply(&p->run, o->axes, o->n_axes, &p->study->sweeps, p->study->check, error);
    if (status == RL_OK && o->n_axes > 0 && p->study->check_scene)
        status = check_scenes(p, error);
    return status == RL_OK ? name_grid(&p->run, o, error) : status;
}

int rl_planned_make(struct rl_planned **out, const struct rl_study *study,
                    const struct rl_run_options *options, const struct rl_provenance *provenance,
                    struct rl_error *error)
{
    *out = NULL;
    struct rl_planned *p = calloc(1, sizeof *p);
    if (!p)
        return rl_fail_memory(error, study->name);
    p->study = study;
    p->run.provenance = *provenance;
    snprintf(p->run.study, sizeof p->run.study, "%s", study->name);
    rl_provenance_now(p->run.started);
    int status = plan(p, options, error);
    if (status != RL_OK) {
        rl_planned_free(p);
        return status;
    }
    char environment[RL_HASH_TEXT];
    rl_provenance_environment(provenance, environment);
    rl_run_identify(&p->run, environment);
    *out = p;
    return RL_OK;
}

void rl_planned_free(struct rl_planned *p)
{
    if (!p)
        return;
    for (size_t i = 0; i < p->n_scenes; i++)
        rl_scene_clear(&p->scene[i]);
    rl_run_clear(&p->run);
    free(p);
}
