/* Scene files with something wrong, and what is said of it: the sound scene with lines replaced. */
#ifndef RL_TESTS_SCENE_WRONG_H
#define RL_TESTS_SCENE_WRONG_H

#include "scene/fixture.h"

static struct temporary folder;
static struct rl_error error;

static int set_up(void **state)
{
    (void)state;
    temporary_make(&folder);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

struct wrong {
    int first, last; /* lines replaced */
    const char *text;
    int line; /* of the message */
    const char *message;
};

/* One line replaced, which is also the one that the message names. */
/* clang-format off */
#define AT(line, text, message) {line, line, text, line, message}
/* clang-format on */

static void check_all(const struct wrong *wrong, size_t n)
{
    char path[PATH_MAX], expected[PATH_MAX + 512];
    temporary_path(&folder, path, "scene.yaml");
    for (size_t i = 0; i < n; i++) {
        write_scene(path, wrong[i].first, wrong[i].last, wrong[i].text);
        struct rl_scene scene;
        error.message[0] = '\0';
        int status = rl_scene_load(&scene, path, &error);
        snprintf(expected, sizeof expected, "%s:%d: %s", path, wrong[i].line, wrong[i].message);
        if (strncmp(error.message, expected, strlen(expected)) != 0)
            print_error("case %zu (%s)\n  expected %s\n  got      %s\n", i, wrong[i].text, expected,
                        error.message);
        assert_int_equal(status, RL_ERR_INPUT);
        assert_int_equal(strncmp(error.message, expected, strlen(expected)), 0);
        assert_null(strpbrk(error.message, "\r\n"));
        assert_null(scene.object);
        assert_int_equal(rl_scene_load(&scene, path, NULL), RL_ERR_INPUT);
    }
}
#define CHECK_ALL(table) check_all(table, sizeof(table) / sizeof((table)[0]))

#endif
