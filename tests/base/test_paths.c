/* Where data and plug-ins are found: in the build tree, in an installation, and where the environment says. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "base/files.h"
#include "base/paths.h"
#include "support/check.h"
#include "support/run.h"
#include "support/temporary.h"

static struct rl_error error;

static void test_build_tree(void **state)
{
    (void)state;
    char path[PATH_MAX];
    char expected[PATH_MAX];
    unsetenv("ROUGHLIGHT_DATA");
    /* Tests run in the repository's root. */
    assert_non_null(realpath("src/base/paths.h", expected));
    check_ok(rl_path_data(path, sizeof path, "src/base/paths.h", &error), &error);
    assert_string_equal(path, expected);
    check_fails(rl_path_data(path, sizeof path, "no/such/file", &error), &error, RL_ERR_UNAVAILABLE,
                "ROUGHLIGHT_DATA");
    check_fails(rl_path_plugin(path, sizeof path, "no-such.so", &error), &error, RL_ERR_UNAVAILABLE,
                "no-such.so");
    check_fails(rl_path_data(path, 5, "src/base/paths.h", &error), &error, RL_ERR_UNAVAILABLE, "not found");
}

static void test_environment(void **state)
{
    (void)state;
    struct temporary folder = {0};
    char file[PATH_MAX];
    char path[PATH_MAX];
    temporary_make(&folder);
    temporary_path(&folder, file, "data.txt");
    check_ok(rl_file_write(file, "", 0, &error), &error);
    setenv("ROUGHLIGHT_DATA", folder.folder, 1);
    check_ok(rl_path_data(path, sizeof path, "data.txt", &error), &error);
    assert_string_equal(path, file);
    /* What is chosen is chosen: nothing is looked for elsewhere. */
    check_fails(rl_path_data(path, sizeof path, "src/base/paths.h", &error), &error, RL_ERR_UNAVAILABLE,
                folder.folder);
    setenv("ROUGHLIGHT_DATA", "", 1);
    check_ok(rl_path_data(path, sizeof path, "src/base/paths.h", &error), &error);
    unsetenv("ROUGHLIGHT_DATA");
    temporary_remove(&folder);
}

static void put(const struct temporary *folder, const char *name, const char *text, size_t size)
{
    char path[PATH_MAX];
    temporary_path(folder, path, name);
    *strrchr(path, '/') = '\0';
    check_ok(rl_directory_create(path, &error), &error);
    temporary_path(folder, path, name);
    check_ok(rl_file_write(path, text, size, &error), &error);
}

/* A copy of this program in PREFIX/bin says what it finds. */
static void test_installation(void **state)
{
    (void)state;
    struct temporary prefix = {0};
    temporary_make(&prefix);
    char *bytes = NULL;
    size_t size = 0;
    check_ok(rl_file_read(&bytes, &size, "/proc/self/exe", &error), &error);
    put(&prefix, "bin/program", bytes, size);
    free(bytes);
    put(&prefix, "share/roughlight/data.txt", "", 0);
    put(&prefix, "lib/roughlight/plugin.so", "", 0);

    char program[PATH_MAX];
    char output[3 * PATH_MAX];
    temporary_path(&prefix, program, "bin/program");
    assert_int_equal(chmod(program, 0755), 0);
    assert_int_equal(run(output, sizeof output, program, "--find"), 0);
    char expected[3 * PATH_MAX];
    snprintf(expected, sizeof expected, "%s/share/roughlight/data.txt\n%s/lib/roughlight/plugin.so\n",
             prefix.folder, prefix.folder);
    assert_string_equal(output, expected);
    temporary_remove(&prefix);
}

static int find(void)
{
    char path[PATH_MAX];
    if (rl_path_data(path, sizeof path, "data.txt", NULL) != RL_OK)
        return 1;
    puts(path);
    if (rl_path_plugin(path, sizeof path, "plugin.so", NULL) != RL_OK)
        return 1;
    puts(path);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--find") == 0)
        return find();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_build_tree),
        cmocka_unit_test(test_environment),
        cmocka_unit_test(test_installation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
