/* Baselines: what is written is read again; every way a file can be wrong is told with its place; what cannot be compared is not. */
#include <limits.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "base/files.h"
#include "measure/goodness.h"
#include "measure/noise.h"
#include "results/baseline.h"
#include "results/reruns.h"
#include "support/check.h"
#include "support/temporary.h"

static struct temporary folder;
static struct rl_error error;

static const struct rl_baseline_row a_random_row = {.scene = "sphere-quad",
                                                    .parameters = "method=random samples=4 rr=3",
                                                    .metric = "rmse",
                                                    .unit = "1",
                                                    .kind = RL_METRIC_RANDOM,
                                                    .best = RL_BEST_LOWER,
                                                    .mean = {0.1, 0.01, 50},
                                                    .relevant = 0.02,
                                                    .tolerance_from = "-",
                                                    .scene_hash = "0123456789abcdef",
                                                    .commit = "abc",
                                                    .renderer = "llvmpipe (LLVM 15)"};
static const struct rl_baseline_row a_fixed_row = {.scene = "none",
                                                   .parameters = "function=pdf rr=3",
                                                   .metric = "value",
                                                   .unit = "1/rad",
                                                   .kind = RL_METRIC_FIXED,
                                                   .best = RL_BEST_SAME,
                                                   .mean = {1.0 / 3.0, 0.0, 1},
                                                   .tolerance = 0x1p-50,
                                                   .tolerance_from = "16 ulp: so it says",
                                                   .scene_hash = "-",
                                                   .commit = "abc",
                                                   .renderer = "llvmpipe (LLVM 15)"};

static void two_rows(struct rl_baseline *b)
{
    check_ok(rl_baseline_add(b, &a_random_row, &error), &error);
    check_ok(rl_baseline_add(b, &a_fixed_row, &error), &error);
}

static void written_and_read(void **state)
{
    (void)state;
    char path[PATH_MAX];
    struct rl_baseline b = {0}, again = {0};
    temporary_path(&folder, path, "round.tsv");
    two_rows(&b);
    check_ok(rl_baseline_write(&b, path, "one\ntwo\n", &error), &error);
    check_ok(rl_baseline_read(&again, path, &error), &error);
    assert_true(again.n == 2);
    for (size_t i = 0; i < 2; i++) {
        const struct rl_baseline_row *x = &b.row[i], *y = &again.row[i];
        assert_string_equal(x->scene, y->scene);
        assert_string_equal(x->parameters, y->parameters);
        assert_string_equal(x->metric, y->metric);
        assert_string_equal(x->unit, y->unit);
        assert_string_equal(x->tolerance_from, y->tolerance_from);
        assert_string_equal(x->scene_hash, y->scene_hash);
        assert_string_equal(x->commit, y->commit);
        assert_string_equal(x->renderer, y->renderer);
        assert_true(x->kind == y->kind && x->best == y->best && x->mean.n == y->mean.n);
        assert_true(x->mean.value == y->mean.value && x->mean.deviation == y->mean.deviation);
        assert_true(x->tolerance == y->tolerance && x->relevant == y->relevant);
    }
    b.row[0].mean.value = NAN;
    check_fails(rl_baseline_write(&b, path, NULL, &error), &error, RL_ERR_CHECK, "rmse");
    rl_baseline_clear(&b);
    rl_baseline_clear(&again);
}

#define HEADER                                                                                               \
    "scene\tparameters\tmetric\tkind\tbest\tunit\tvalue\tdeviation\tn\ttolerance\trelevant\ttolerance_"      \
    "from\t"                                                                                                 \
    "scene_hash\tcommit\trenderer\n"
#define ROW "s\tp=1\tm\trandom\tlower\t1\t0.5\t0.1\t8\t0\t0.1\t-\t-\tc\tr\n"

static void broken_files(void **state)
{
    (void)state;
    static const struct {
        const char *text, *words;
    } row[] = {
        {"", "found no rows"},
        {"# nothing\n", "found no rows"},
        {HEADER, "found no rows"},
        {"scene\tmetric\n", ":1: column 2: found 'metric', expected 'parameters'"},
        {"# c\nscene\n", ":2: column 2: found '', expected 'parameters'"},
        {"scene\tparameters\tmetric\tkind\tbest\tunit\tvalue\tdeviation\tn\ttolerance\trelevant\ttolerance_"
         "from\t"
         "scene_hash\tcommit\trenderer\tmore\n",
         "found the column 'more' after the last, 'renderer'"},
        {HEADER "s\tp\n", ":2: found 2 columns, expected 15"},
        {HEADER "s\tp=1\tm\trandom\tlower\t1\t0.5\t0.1\t8\t0\t0.1\t-\t-\tc\tr\tx\n", "found more than 15"},
        {HEADER "s\t\tm\trandom\tlower\t1\t0.5\t0.1\t8\t0\t0.1\t-\t-\tc\tr\n", "parameters: found ''"},
        {HEADER "s\tp=1\tm\tchance\tlower\t1\t0.5\t0.1\t8\t0\t0.1\t-\t-\tc\tr\n",
         "kind: found 'chance', expected random or fixed"},
        {HEADER "s\tp=1\tm\trandom\thigher\t1\t0.5\t0.1\t8\t0\t0.1\t-\t-\tc\tr\n",
         "best: found 'higher', expected lower, zero or same"},
        {HEADER "s\tp=1\tm\trandom\tlower\t1\t0.5x\t0.1\t8\t0\t0.1\t-\t-\tc\tr\n", "value: found '0.5x'"},
        {HEADER "s\tp=1\tm\trandom\tlower\t1\tnan\t0.1\t8\t0\t0.1\t-\t-\tc\tr\n", "value: found 'nan'"},
        {HEADER "s\tp=1\tm\trandom\tlower\t1\t0.5\t-1\t8\t0\t0.1\t-\t-\tc\tr\n",
         "deviation: found '-1', expected a number >= 0"},
        {HEADER "s\tp=1\tm\trandom\tlower\t1\t0.5\t0.1\t8.5\t0\t0.1\t-\t-\tc\tr\n", "n: found '8.5'"},
        {HEADER "s\tp=1\tm\trandom\tlower\t1\t0.5\t0.1\t1\t0\t0.1\t-\t-\tc\tr\n",
         "n: found '1', expected at least 2"},
        {HEADER "s\tp=1\tm\tfixed\tlower\t1\t0.5\t0\t8\t0\t0\tx\t-\tc\tr\n", "n: found '8', expected 1"},
        {HEADER "s\tp=1\tm\trandom\tlower\t1\t0.5\t0.1\t8\t0\t0\t-\t-\tc\tr\n", "relevant: found '0'"},
        {HEADER "s\tp=1\tm\trandom\tlower\t1\t0.5\t0.1\t8\tinf\t0.1\t-\t-\tc\tr\n", "tolerance: found 'inf'"},
        {HEADER ROW ROW, ":3: found m of 'p=1' of the scene s again"},
    };
    char path[PATH_MAX];
    temporary_path(&folder, path, "broken.tsv");
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_baseline b = {0};
        check_ok(rl_file_write(path, row[i].text, strlen(row[i].text), &error), &error);
        check_fails(rl_baseline_read(&b, path, &error), &error, RL_ERR_INPUT, row[i].words);
        check_fails(rl_baseline_read(&b, path, &error), &error, RL_ERR_INPUT, "broken.tsv");
        assert_true(b.n == 0 && !b.row);
    }
    struct rl_baseline b = {0};
    check_ok(rl_file_write(path, HEADER ROW "\0", sizeof(HEADER ROW "\0") - 1, &error), &error);
    check_fails(rl_baseline_read(&b, path, &error), &error, RL_ERR_INPUT, "zero byte");
    temporary_path(&folder, path, "missing.tsv");
    assert_int_not_equal(rl_baseline_read(&b, path, &error), RL_OK);
    assert_non_null(strstr(error.message, "missing.tsv"));
}

/* Windows' line ends and comments between rows are no harm. */
static void lines(void **state)
{
    (void)state;
    static const char text[] = "# a\r\n" HEADER "\n# b\n" ROW;
    char path[PATH_MAX];
    struct rl_baseline b = {0};
    temporary_path(&folder, path, "lines.tsv");
    check_ok(rl_file_write(path, text, sizeof text - 1, &error), &error);
    check_ok(rl_baseline_read(&b, path, &error), &error);
    assert_true(b.n == 1);
    assert_string_equal(b.row[0].renderer, "r");
    rl_baseline_clear(&b);
}

/* The verdict on the row `at` when `now` has it in place of the baseline's. */
static void expect(const struct rl_baseline_row *now_row, size_t at, enum rl_change verdict,
                   const char *reason)
{
    struct rl_baseline before = {0}, now = {0};
    struct rl_comparison c;
    two_rows(&before);
    two_rows(&now);
    now.row[at] = *now_row;
    check_ok(rl_baseline_compare(&c, &before, &now, 0.01, &error), &error);
    assert_string_equal(rl_change_name(c.row[at].result.verdict), rl_change_name(verdict));
    assert_non_null(strstr(c.row[at].result.reason, reason));
    size_t all = 0;
    for (int v = 0; v < RL_CHANGES; v++)
        all += c.count[v];
    assert_true(all == c.n);
    rl_comparison_clear(&c);
    rl_baseline_clear(&before);
    rl_baseline_clear(&now);
}

static void comparisons(void **state)
{
    (void)state;
    struct rl_baseline_row r = a_random_row, f = a_fixed_row;
    expect(&r, 0, RL_CHANGE_SAME, "");
    expect(&f, 1, RL_CHANGE_SAME, "");
    r.mean.value = 0.11;
    expect(&r, 0, RL_CHANGE_WORSE, "");
    r.mean.value = 0.09;
    expect(&r, 0, RL_CHANGE_BETTER, "");
    f.mean.value += 0x1p-49;
    expect(&f, 1, RL_CHANGE_WORSE, "");
    snprintf(f.renderer, sizeof f.renderer, "softpipe");
    expect(&f, 1, RL_CHANGE_WORSE, ""); /* the CPU's alone */
    f.drawn = true;
    expect(&f, 1, RL_CHANGE_INCOMPARABLE, "another renderer");
    f.mean.value = NAN;
    expect(&f, 1, RL_CHANGE_WORSE, "not finite");
    f = a_fixed_row;
    f.drawn = true;
    snprintf(f.renderer, sizeof f.renderer, "softpipe");
    expect(&f, 1, RL_CHANGE_SAME, "");
    f.mean.value += 0x1p-49;
    snprintf(f.renderer, sizeof f.renderer, "llvmpipe (LLVM 19, 512 bits)");
    expect(&f, 1, RL_CHANGE_WORSE, "");
    r = a_random_row;
    snprintf(r.scene_hash, sizeof r.scene_hash, "f");
    expect(&r, 0, RL_CHANGE_INCOMPARABLE, "the scene has changed");
    r = a_random_row;
    r.kind = RL_METRIC_FIXED;
    expect(&r, 0, RL_CHANGE_INCOMPARABLE, "kind");
    r = a_random_row;
    r.best = RL_BEST_ZERO;
    expect(&r, 0, RL_CHANGE_INCOMPARABLE, "best");
    r = a_random_row;
    snprintf(r.unit, sizeof r.unit, "px");
    expect(&r, 0, RL_CHANGE_INCOMPARABLE, "unit");
    r = a_random_row;
    snprintf(r.metric, sizeof r.metric, "mae");
    expect(&r, 0, RL_CHANGE_INCOMPARABLE, "not in the baseline");
}

static void gone(void **state)
{
    (void)state;
    struct rl_baseline before = {0}, now = {0};
    struct rl_comparison c;
    two_rows(&before);
    check_ok(rl_baseline_add(&now, &a_fixed_row, &error), &error);
    check_ok(rl_baseline_compare(&c, &before, &now, 0.01, &error), &error);
    assert_true(c.n == 2 && c.n_tests == 0 && c.count[RL_CHANGE_SAME] == 1);
    assert_null(c.row[1].now);
    assert_string_equal(c.row[1].result.reason, "not measured now");
    check_near(c.p_family, 1.0, 0.0);
    rl_comparison_clear(&c);
    rl_baseline_clear(&before);
    rl_baseline_clear(&now);
}

/* Three tests at the level that Sidak gives each; the smallest p as one of three. */
static void corrected(void **state)
{
    (void)state;
    struct rl_baseline before = {0}, now = {0};
    struct rl_comparison c;
    struct rl_baseline_row r = a_random_row;
    for (int i = 0; i < 3; i++) {
        snprintf(r.metric, sizeof r.metric, "m%d", i);
        r.mean.value = 0.1;
        check_ok(rl_baseline_add(&before, &r, &error), &error);
        r.mean.value = 0.1 + 0.002 * i;
        check_ok(rl_baseline_add(&now, &r, &error), &error);
    }
    check_ok(rl_baseline_compare(&c, &before, &now, 0.01, &error), &error);
    assert_true(c.n_tests == 3);
    check_near(c.level, 1.0 - cbrt(0.99), 1e-15);
    double p = c.row[2].result.p;
    check_near(c.p_family, 1.0 - (1.0 - p) * (1.0 - p) * (1.0 - p), 1e-12);

    struct rl_reruns reruns = {0};
    check_ok(rl_reruns_add(&reruns, &c, &error), &error);
    check_ok(rl_reruns_add(&reruns, &c, &error), &error);
    check_ok(rl_reruns_judge(&reruns, &error), &error);
    assert_true(reruns.runs == 2 && reruns.n == 3 && reruns.alarmed_runs == 0);
    assert_true(reruns.row[2].n == 2 && reruns.row[2].smallest_p == p);
    check_near(reruns.smallest_p, rl_sidak_p(p, 6.0), 1e-15);
    /* Both runs are the same, so p of each against the other is 1: as far from uniform as can be. */
    check_near(reruns.row[2].distance, 1.0, 1e-15);
    check_near(reruns.row[2].fit_p, rl_kolmogorov_p(1.0, 2), 1e-15);
    /* 100 values that deviate by sqrt(2 x 49 x 0.01^2/99), 50 of the baseline, 0.004 apart. */
    double deviation = sqrt(98.0 / 99.0) * 0.01;
    check_near(reruns.row[2].offset, -0.004 / (deviation * sqrt(1.0 / 50.0 + 1.0 / 100.0)), 1e-9);
    rl_reruns_clear(&reruns);
    rl_comparison_clear(&c);
    rl_baseline_clear(&before);
    rl_baseline_clear(&now);
}

/* Runs of normal values against a baseline that is off by three standard errors: p values against the other runs are uniform all the same.
 * With a deviation that is too small they are not. Seeds 1 to 200. */
static void reruns(void **state)
{
    (void)state;
    enum { RUNS = 200, N = 8 };
    for (int wrong = 0; wrong < 2; wrong++) {
        struct rl_baseline before = {0};
        struct rl_reruns reruns = {0};
        struct rl_baseline_row r = a_random_row;
        r.mean = (struct rl_mean){3.0 / sqrt(128.0), 1.0, 128};
        check_ok(rl_baseline_add(&before, &r, &error), &error);
        for (uint64_t k = 1; k <= RUNS; k++) {
            struct rl_baseline now = {0};
            struct rl_comparison c;
            double value[N];
            for (uint64_t i = 0; i < N; i++)
                value[i] = noise(k, i);
            r.mean = rl_mean_of(value, N);
            r.mean.value *= wrong ? 1.5 : 1.0;
            check_ok(rl_baseline_add(&now, &r, &error), &error);
            check_ok(rl_baseline_compare(&c, &before, &now, 1e-4, &error), &error);
            check_ok(rl_reruns_add(&reruns, &c, &error), &error);
            rl_comparison_clear(&c);
            rl_baseline_clear(&now);
        }
        check_ok(rl_reruns_judge(&reruns, &error), &error);
        assert_true(reruns.n == 1 && reruns.row[0].n == RUNS);
        if (wrong)
            assert_true(reruns.smallest_fit_p < 1e-3);
        else
            assert_true(reruns.smallest_fit_p > 0.01);
        check_near(reruns.row[0].offset, 3.0, 1.0);
        rl_reruns_clear(&reruns);
        rl_baseline_clear(&before);
    }
}

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(written_and_read), cmocka_unit_test(broken_files), cmocka_unit_test(lines),
        cmocka_unit_test(comparisons),      cmocka_unit_test(gone),         cmocka_unit_test(corrected),
        cmocka_unit_test(reruns),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
