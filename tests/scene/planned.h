/* The plan of the sound scene with some lines replaced. */
#ifndef RL_TESTS_SCENE_PLANNED_H
#define RL_TESTS_SCENE_PLANNED_H

#include "scene/fixture.h"
#include "scene/plan.h"

static struct temporary folder;
static struct rl_error error;
static char path[PATH_MAX];
static struct rl_scene scene;
static struct rl_plan plan;

static int set_up(void **state)
{
    (void)state;
    temporary_make(&folder);
    temporary_path(&folder, path, "scene.yaml");
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

/* The sound scene with some lines replaced: `shiny` (random) on a ball, `matt` (no highlight) on the
 * ground, two lights. */
static void load(int first, int last, const char *text)
{
    write_scene(path, first, last, text);
    check_ok(rl_scene_load(&scene, path, &error), &error);
}

static void make(const struct rl_settings *settings)
{
    check_ok(rl_plan_make(&plan, &scene, settings, &error), &error);
}

static void clear(void)
{
    rl_plan_clear(&plan);
    rl_scene_clear(&scene);
}

static bool has_module(int program, const char *module)
{
    assert_in_range(program, 0, plan.n_programs - 1);
    for (size_t i = 0; i < plan.program[program].n_modules; i++)
        if (strcmp(plan.program[program].module[i], module) == 0)
            return true;
    return false;
}

static bool any_module(const char *module)
{
    for (size_t i = 0; i < plan.n_programs; i++)
        if (has_module((int)i, module))
            return true;
    return false;
}

#endif
