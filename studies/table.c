/* The table of studies, one row each, and what all descriptors share. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "studies/study.h"

extern const struct rl_study rl_study_distribution;
extern const struct rl_study rl_study_samples;
extern const struct rl_study rl_study_roughness;
extern const struct rl_study rl_study_bitdepth;
extern const struct rl_study rl_study_frame;
extern const struct rl_study rl_study_margin;
extern const struct rl_study rl_study_environment;
extern const struct rl_study rl_study_budget;
extern const struct rl_study rl_study_effects;
extern const struct rl_study rl_study_fps;
extern const struct rl_study rl_study_bare;
extern const struct rl_study rl_study_interpolation;
extern const struct rl_study rl_study_fur;
extern const struct rl_study rl_study_accuracy;
extern const struct rl_study rl_study_visibility;
extern const struct rl_study rl_study_hard;

/* One row each. */
/* clang-format off */
const struct rl_study *const rl_studies[] = {
    &rl_study_distribution,
    &rl_study_samples,
    &rl_study_roughness,
    &rl_study_bitdepth,
    &rl_study_frame,
    &rl_study_margin,
    &rl_study_environment,
    &rl_study_budget,
    &rl_study_effects,
    &rl_study_fps,
    &rl_study_bare,
    &rl_study_interpolation,
    &rl_study_fur,
    &rl_study_accuracy,
    &rl_study_visibility,
    &rl_study_hard,
};
/* clang-format on */

const size_t rl_n_studies = sizeof rl_studies / sizeof rl_studies[0];

const struct rl_study *rl_study_find(const char *name)
{
    for (size_t i = 0; i < rl_n_studies; i++)
        if (strcmp(rl_studies[i]->name, name) == 0)
            return rl_studies[i];
    return NULL;
}

const char *rl_grid_name(enum rl_grid grid)
{
    static const char *const name[] = {
        [RL_GRID_QUICK] = "quick", [RL_GRID_DEFAULT] = "default", [RL_GRID_FULL] = "full"};
    return name[grid];
}

/* Whether the record at `i` is the first of its scene. */
static bool first_of_scene(const struct rl_run *run, size_t i)
{
    for (size_t k = 0; k < i; k++)
        if (strcmp(run->record[k].scene, run->record[i].scene) == 0)
            return false;
    return true;
}

const char *rl_run_scene(const struct rl_run *run, size_t i)
{
    for (size_t k = 0; k < run->n_records; k++)
        if (first_of_scene(run, k) && i-- == 0)
            return run->record[k].scene;
    return NULL;
}

/* As a shell reads it: in single quotes where it has more than letters, digits and ./_- in it. */
static void quote_word(char text[], size_t size, const char *word)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789./_-";
    if (word[strspn(word, plain)] == '\0') {
        snprintf(text, size, "%s", word);
        return;
    }
    size_t n = 0;
    text[n++] = '\'';
    for (; *word && n + 6 < size; word++) {
        if (*word == '\'') /* ends the quotes, is escaped, begins them again */
            n += (size_t)snprintf(text + n, size - n, "'\\''");
        else
            text[n++] = *word;
    }
    text[n++] = '\'';
    text[n] = '\0';
}

void rl_run_arguments(char text[], size_t size, const struct rl_run *run)
{
    const char *axes = run->grid + strcspn(run->grid, " ");
    const char *name = rl_grid_name(RL_GRID_DEFAULT);
    bool is_default =
        (size_t)(axes - run->grid) == strlen(name) && strncmp(run->grid, name, strlen(name)) == 0;
    snprintf(text, size, "%s%s", is_default ? "" : " --", is_default ? axes : run->grid);
}

/* The scene's file as the user gave it. */
static const char *scene_path(const struct rl_run *run, const char *scene)
{
    const char *path = scene;
    for (size_t i = 0; i < run->n_records; i++)
        if (strcmp(run->record[i].scene, scene) == 0)
            path = run->record[i].scene_path;
    return path;
}

void rl_run_command(char text[], size_t size, const struct rl_run *run, const char *const *scenes, size_t n)
{
    char grid[RL_GRID_MAX + 4];
    rl_run_arguments(grid, sizeof grid, run);
    size_t used = (size_t)snprintf(text, size, "roughlight study run %.20s", run->study);
    for (size_t i = 0; i < n && used < size; i++) {
        char word[200];
        if (strcmp(scenes[i], RL_NO_SCENE) == 0)
            continue;
        quote_word(word, sizeof word, scene_path(run, scenes[i]));
        used += (size_t)snprintf(text + used, size - used, " --scene %s", word);
    }
    if (used < size)
        snprintf(text + used, size - used, "%s", grid);
}

void rl_claim_source(struct rl_claim *claim, const struct rl_run *run, const char *scene)
{
    snprintf(claim->study, sizeof claim->study, "%s", run->study);
    snprintf(claim->scene, sizeof claim->scene, "%s", scene);
    rl_run_command(claim->command, sizeof claim->command, run, &scene, 1);
}

bool rl_run_has_own_scenes(const struct rl_run *run)
{
    const struct rl_study *study = rl_study_find(run->study);
    size_t own = 0, found = 0;
    const char *scene;
    while (study && study->scenes[own])
        own++;
    for (size_t i = 0; (scene = rl_run_scene(run, i)); i++) {
        bool known = strcmp(scene, RL_NO_SCENE) == 0;
        for (size_t k = 0; k < own && !known; k++)
            if (strcmp(study->scenes[k], scene_path(run, scene)) == 0) {
                known = true;
                found++;
            }
        if (!known)
            return false;
    }
    return found == own;
}
