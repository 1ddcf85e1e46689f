/* gnuplot as a process: a figure comes out, its complaints come back, a missing one is said to be missing. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include <sys/stat.h>

#include "base/files.h"
#include "results/plot.h"
#include "support/temporary.h"

static struct temporary folder;

/* A data folder of the test's own with two scripts: one that draws, one that cannot. */
static int make_folder(void **state)
{
    (void)state;
    temporary_make(&folder);
    char path[PATH_MAX];
    temporary_path(&folder, path, "plots");
    rl_directory_create(path, NULL);
    static const char draws[] = "load ARG1\nset terminal svg\nset output ARG3\nplot width*x\n";
    static const char fails[] = "plot 'no such file'\n";
    temporary_path(&folder, path, "plots/style.gp");
    rl_file_write(path, "width = 2\n", 10, NULL);
    temporary_path(&folder, path, "plots/draws.gp");
    rl_file_write(path, draws, strlen(draws), NULL);
    temporary_path(&folder, path, "plots/fails.gp");
    rl_file_write(path, fails, strlen(fails), NULL);
    return setenv("ROUGHLIGHT_DATA", folder.folder, 1);
}

static int remove_folder(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

static void test_draws(void **state)
{
    (void)state;
    char path[PATH_MAX];
    temporary_path(&folder, path, "it's \"one\" $HOME.svg"); /* no shell sees it */
    const char *arguments[] = {folder.folder, path, NULL};
    struct rl_error error = {0};
    if (rl_plot("draws.gp", arguments, &error) != RL_OK)
        fail_msg("%s", error.message);
    struct stat info;
    assert_int_equal(stat(path, &info), 0);
    assert_true(info.st_size > 1000);
}

static void test_fails(void **state)
{
    (void)state;
    const char *arguments[] = {folder.folder, "out.svg", NULL};
    struct rl_error error = {0};
    assert_int_equal(rl_plot("fails.gp", arguments, &error), RL_ERR_SYSTEM);
    assert_non_null(strstr(error.message, "fails.gp"));
    assert_null(strchr(error.message, '\n'));
    assert_int_equal(rl_plot("missing.gp", arguments, &error), RL_ERR_UNAVAILABLE);
    assert_non_null(strstr(error.message, "plots/missing.gp"));
}

static void test_no_gnuplot(void **state)
{
    (void)state;
    const char *arguments[] = {folder.folder, "out.svg", NULL};
    struct rl_error error = {0};
    const char *path = getenv("PATH");
    char *kept = strdup(path ? path : "");
    assert_non_null(kept);
    setenv("PATH", folder.folder, 1);
    assert_int_equal(rl_plot("draws.gp", arguments, &error), RL_ERR_UNAVAILABLE);
    setenv("PATH", kept, 1);
    free(kept);
    assert_non_null(strstr(error.message, "gnuplot: not found"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_draws),
        cmocka_unit_test(test_fails),
        cmocka_unit_test(test_no_gnuplot),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
