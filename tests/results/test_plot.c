/* gnuplot as a process: a figure comes out, its complaints come back, a missing one is said to be missing. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
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
    /* Of the figure "nothing" a file is begun before it turns out that there is nothing to draw. */
    static const char maybe[] =
        "load ARG1\nset terminal svg\nset output ARG3\nif (ARG4 eq 'nothing') { exit status 3 }\n"
        "if (ARG4 eq 'broken') { plot 'no such file' }\nplot x\n";
    temporary_path(&folder, path, "plots/maybe.gp");
    rl_file_write(path, maybe, strlen(maybe), NULL);
    char *script;
    size_t size;
    if (rl_file_read(&script, &size, "plots/figure.gp", NULL) != RL_OK)
        return -1;
    temporary_path(&folder, path, "plots/figure.gp");
    rl_file_write(path, script, size, NULL);
    free(script);
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

/* n figures called f0, f1, ... of the script maybe.gp, which draws the name `odd` in another way. */
static void make_figures(struct rl_plot_figure *figure, size_t n, size_t place, const char *odd)
{
    for (size_t i = 0; i < n; i++) {
        figure[i] =
            (struct rl_plot_figure){.script = "maybe.gp", .tables = folder.folder, .name = "x", .scene = "s"};
        figure[i].name = i == place ? odd : "x";
        snprintf(figure[i].stem, sizeof figure[i].stem, "%.200s/%.10s%zu", folder.folder, odd, i);
    }
}

static bool all_drawn(const struct rl_plot_figure *figure)
{
    static const char *const ending[] = {"svg", "png", "small.png"};
    int found = 0;
    for (size_t k = 0; k < 3; k++) {
        char path[PATH_MAX + 16];
        struct stat info;
        snprintf(path, sizeof path, "%s.%s", figure->stem, ending[k]);
        found += stat(path, &info) == 0;
    }
    assert_true(found == 0 || found == 3);
    return found == 3;
}

enum { FIGURES = 5, ODD = 3 };

static void count_updates(void *user, const char *what, size_t done, size_t total)
{
    size_t *updates = user;
    assert_string_equal(what, "plots");
    assert_int_equal(total, FIGURES);
    assert_int_equal(done, ++*updates);
}

/* By any number of threads: all are drawn but that with nothing to draw, of which nothing is left. */
static void test_figures(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 8; threads += 7) {
        struct rl_plot_figure figure[FIGURES];
        struct rl_error error = {0};
        size_t updates = 0;
        const struct rl_progress progress = {.update = count_updates, .user = &updates};
        make_figures(figure, FIGURES, ODD, "nothing");
        if (rl_plot_figures(figure, FIGURES, threads, &progress, &error) != RL_OK)
            fail_msg("%s", error.message);
        assert_int_equal(updates, FIGURES);
        for (size_t i = 0; i < FIGURES; i++) {
            assert_int_equal(figure[i].missing, i == ODD);
            assert_int_equal(all_drawn(&figure[i]), i != ODD);
        }
    }
}

static bool always(void *user)
{
    (void)user;
    return true;
}

static void test_figure_fails(void **state)
{
    (void)state;
    struct rl_plot_figure figure[FIGURES];
    struct rl_error error = {0};
    make_figures(figure, FIGURES, 0, "broken");
    assert_int_equal(rl_plot_figures(figure, FIGURES, 1, NULL, &error), RL_ERR_SYSTEM);
    assert_non_null(strstr(error.message, "plots/maybe.gp: gnuplot failed"));
    assert_false(all_drawn(&figure[1])); /* it stopped */
    const struct rl_progress cancelled = {.cancelled = always};
    assert_int_equal(rl_plot_figures(figure + 1, FIGURES - 1, 2, &cancelled, &error), RL_ERR_CANCELLED);
    assert_false(all_drawn(&figure[1]));
    assert_int_equal(rl_plot_figures(NULL, 0, 0, NULL, &error), RL_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_draws),        cmocka_unit_test(test_fails),
        cmocka_unit_test(test_no_gnuplot),   cmocka_unit_test(test_figures),
        cmocka_unit_test(test_figure_fails),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
