/* Maps of hard cases: those that come with the program are within their bounds in C; what the reader makes of a file; faults are seen. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "probe/map.h"
#include "support/check.h"
#include "support/temporary.h"

static double *evaluate(const struct rl_map *m)
{
    struct rl_error error;
    double *results = malloc(m->catalogue.n_rows * m->catalogue.probe.n_out * sizeof *results);
    assert_non_null(results);
    check_ok(rl_catalogue_evaluate(&m->catalogue, NULL, results, &error), &error);
    return results;
}

/* In C; the study `hard` does the same on both backends. */
static void test_points(void **state)
{
    (void)state;
    struct rl_error error;
    char folder[PATH_MAX], **paths;
    size_t n, failed = 0;
    check_ok(rl_map_folder(folder, sizeof folder, &error), &error);
    check_ok(rl_catalogue_list(&paths, &n, folder, &error), &error);
    assert_int_equal(n, 7);
    for (size_t i = 0; i < n; i++) {
        struct rl_map m;
        check_ok(rl_map_load(&m, paths[i], &error), &error);
        double *results = evaluate(&m), worst = 0.0;
        for (size_t point = 0; point < m.catalogue.n_rows; point++) {
            double share = rl_map_point_of(&m, RL_CATALOGUE_CPU, results, point).share;
            worst = fmax(worst, share);
            failed += !(share <= 1.0);
        }
        print_message("%s: %zu points, worst %.3g of the bound\n", paths[i], m.catalogue.n_rows, worst);
        free(results);
        rl_map_free(&m);
    }
    rl_catalogue_list_free(paths, n);
    assert_int_equal(failed, 0);
}

static int load_text(struct rl_map *m, const char *name, const char *text, struct rl_error *error)
{
    struct temporary t = {0};
    char path[PATH_MAX];
    temporary_make(&t);
    temporary_path(&t, path, name);
    check_ok(rl_file_write(path, text, strlen(text), error), error);
    int status = rl_map_load(m, path, error);
    temporary_remove(&t);
    return status;
}

#define AXES                                                                                                 \
    "# G\nall\tn_h\t1\nacross\tn_v\t0.25\t0.5\nup\tn_l\t0.5\t0\t1\nup\tshown\t60\t90\t0\nall\tv_h\t1\n"
#define ONES "\t1\t1\n"

/* G = 2 min(N.V, N.L) at most 1. The second answer is 9 ulp too large, within the fourth's bound of 2 plain ones; that of 0 is a number. */
static void test_reading(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_map m;
    check_ok(load_text(&m, "attenuation.tsv",
                       AXES "ulp\tg\n0.5" ONES "1.000000000000001998402" ONES "0\t1e-16\t1e-6\n"
                            "1e-17\t2e300\t1\n0.500000000000000999201\t2\t1\n1" ONES,
                       &error),
             &error);
    assert_int_equal(m.catalogue.n_rows, 6);
    assert_int_equal(m.n[RL_MAP_ACROSS], 2);
    assert_int_equal(m.n[RL_MAP_UP], 3);
    check_near(m.shown[RL_MAP_ACROSS][1], 0.5, 0.0);
    check_near(m.shown[RL_MAP_UP][1], 90.0, 0.0);
    const double expected[] = {1.0, 0.5, 1.0, 1.0}; /* the last of 6 rows of 4 arguments */
    for (size_t i = 0; i < 4; i++)
        check_near(m.catalogue.rows[20 + i], expected[i], 0.0);
    check_near(m.catalogue.answers[0][RL_CATALOGUE_CPU].bound, 8.0 * DBL_EPSILON / 2.0, 1e-30);
    check_near(m.catalogue.answers[0][RL_CATALOGUE_GPU].bound, 5e-6, 1e-20);
    check_near(m.catalogue.answers[2][RL_CATALOGUE_CPU].bound, 1e-16, 1e-30);
    double *results = evaluate(&m);
    const struct rl_map_point beyond = rl_map_point_of(&m, RL_CATALOGUE_CPU, results, 1),
                              within = rl_map_point_of(&m, RL_CATALOGUE_CPU, results, 4);
    check_near(beyond.ulp, 9.0, 1e-2);
    check_near(beyond.share, 9.0 / 8.0, 1e-2);
    assert_false(beyond.widened);
    check_near(within.share, 9.0 / 16.0, 1e-2);
    assert_true(within.widened);
    results[1] = NAN;
    assert_true(isinf(rl_map_point_of(&m, RL_CATALOGUE_CPU, results, 1).share));
    free(results);
    rl_map_free(&m);
}

/* T.x of N = z is 1, and all its other components are 0: a unit in the last place of 1 is one in that of 0, too. */
static void test_absolute(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_map m;
    check_ok(
        load_text(&m, "frame.tsv",
                  "across\tnx\t0\nall\tny\t0\nup\tnz\t2\nabsolute\ttx\tty\n1\t1.3322676295501878485e-15\n",
                  &error),
        &error);
    double *results = evaluate(&m);
    const struct rl_map_point p = rl_map_point_of(&m, RL_CATALOGUE_CPU, results, 0);
    check_near(p.ulp, 6.0, 1e-9);
    check_near(p.share, 0.75, 1e-9);
    free(results);
    rl_map_free(&m);
}

static void test_bad_files(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text, *words;
    } cases[] = {
        {"nothing.tsv", AXES, "nothing.tsv: function 'nothing': expected one of ellipsoid-pdf"},
        {"attenuation.tsv", AXES, ".tsv: found 0 points, expected 0"},
        {"attenuation.tsv", AXES "sideways\t1\n", ".tsv:7: found 'sideways', expected across, up, all, ulp"},
        {"attenuation.tsv", AXES "all\tn_x\t1\n", ".tsv:7: found 'n_x', expected an argument of attenuation"},
        {"attenuation.tsv", AXES "all\tn_h\t1\n", ".tsv:7: found n_h twice"},
        {"attenuation.tsv", "all\tn_h\t1\t2\n", ".tsv:1: n_h: found 2 values, expected 1"},
        {"attenuation.tsv", "across\tn_h\t1\t2\nacross\tn_v\t1\n", ".tsv:2: n_v: found 1 values, expected 2"},
        {"attenuation.tsv", "across\tn_h\t1\t\n", ".tsv:1: found '', expected a finite number"},
        {"attenuation.tsv", "across\tn_h\t1\nulp\tg\n", ".tsv:2: found no argument up"},
        {"attenuation.tsv", "across\tn_h\t1\nup\tn_v\t3\nulp\tg\n",
         ".tsv:3: point 0: n_v: found 3, expected -1 to 1"},
        {"attenuation.tsv", AXES "ulp\n", ".tsv:7: found no results, expected some of attenuation"},
        {"attenuation.tsv", AXES "ulp\th\n", ".tsv:7: found 'h', expected a result of attenuation"},
        {"attenuation.tsv", AXES "ulp\tg\n0\t1\n", ".tsv:8: found too few columns"},
        {"attenuation.tsv", AXES "ulp\tg\n0\t1\t1\t1\n", ".tsv:8: found '1' after the last column"},
        {"attenuation.tsv", AXES "ulp\tg\n0\t1\tinf\n", ".tsv:8: found 'inf', expected a finite number"},
        {"attenuation.tsv", AXES "ulp\tg\n0" ONES, ".tsv: found 1 points, expected 6"},
        {"attenuation.tsv", AXES "absolute\tg\n0\n0\n0\n0\n0\n0\n0\n", ".tsv:14: found more points than 6"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct rl_error error;
        struct rl_map m;
        check_fails(load_text(&m, cases[i].name, cases[i].text, &error), &error, RL_ERR_INPUT,
                    cases[i].words);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_points),
        cmocka_unit_test(test_reading),
        cmocka_unit_test(test_absolute),
        cmocka_unit_test(test_bad_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
