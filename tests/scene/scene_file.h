/* One scene file in a folder of the test's own, for tests of what sound files say. */
#ifndef RL_TESTS_SCENE_FILE_H
#define RL_TESTS_SCENE_FILE_H

#include "scene/fixture.h"

static struct temporary folder;
static struct rl_error error;
static char path[PATH_MAX];

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

static void load_with(struct rl_scene *scene, int first, int last, const char *text)
{
    write_scene(path, first, last, text);
    check_ok(rl_scene_load(scene, path, &error), &error);
}

static inline void check_vec3(rl_vec3 actual, double x, double y, double z, double tolerance)
{
    check_near(actual.x, x, tolerance);
    check_near(actual.y, y, tolerance);
    check_near(actual.z, z, tolerance);
}

#endif
