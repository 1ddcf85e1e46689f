/* The study `accuracy`: its grid holds what its claims need, what it measures makes sense, and its verdicts follow
 * from the figures. No bar of speed is tested here: the study judges those, on the machine that it runs on. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "reference/integrators.h"
#include "scene/scene.h"
#include "studies/judged.h"
#include "studies/study.h"

static const struct rl_place alone = {"accuracy", RL_NO_SCENE, "", 0};
static const struct rl_place place = {"accuracy", "sphere-quad", "sphere-quad", 1};

static const struct rl_study *study(void)
{
    return rl_study_find("accuracy");
}

static double value(const struct rl_record *r, const char *metric)
{
    const struct rl_metric *m = rl_record_metric(r, metric);
    if (!m)
        fail_msg("no metric %s of %s", metric, r->parameters);
    return m ? m->value : NAN;
}

/* Few points and small budgets: milliseconds. */
static void measure_few(struct rl_run *run)
{
    *run = (struct rl_run){.study = "accuracy", .grid = "quick"};
    for (int e = 2; e <= 12; e += 2)
        assert_non_null(
            rl_run_add(run, &alone, 0, NULL,
                       "part=points integrator=reference tolerance=%g light=star points=8 max_evaluations=0",
                       pow(10.0, -e)));
    static const char *const witness[] = {"cubature", "cubature-uv", "montecarlo", "vegas"};
    for (size_t i = 0; i < sizeof witness / sizeof witness[0]; i++)
        assert_non_null(
            rl_run_add(run, &alone, 0, NULL,
                       "part=points integrator=%s tolerance=0.01 light=star points=4 max_evaluations=20000",
                       witness[i]));
    struct rl_bench bench = {0};
    struct rl_error error;
    if (study()->measure(run->record, run->n_records, &bench, NULL, &error) != RL_OK)
        fail_msg("%s", error.message);
}

static void test_measures_points(void **state)
{
    (void)state;
    struct rl_run run, again;
    measure_few(&run);
    measure_few(&again);
    for (size_t i = 0; i < run.n_records; i++) {
        const struct rl_record *r = &run.record[i];
        double tolerance = rl_parameter_number(r->parameters, "tolerance");
        static const char *const share[] = {"bounded", "within", "converged"};
        for (size_t k = 0; k < 3; k++)
            assert_true(value(r, share[k]) >= 0.0 && value(r, share[k]) <= 1.0);
        assert_true(value(r, "time_us") > 0.0 && value(r, "evaluations") > 0.0);
        assert_true(value(r, "true_error") <= value(r, "error_p90") &&
                    value(r, "error_p90") <= value(r, "error_max"));
        if (rl_parameters_match(r->parameters, "integrator=reference")) {
            assert_true(value(r, "error_max") <= tolerance);
            assert_true(value(r, "bounded") == 1.0 && value(r, "within") == 1.0);
        }
        const struct rl_series *a = rl_record_series(r, "true_error"),
                               *b = rl_record_series(&again.record[i], "true_error");
        assert_true(a->n == (size_t)rl_parameter_number(r->parameters, "points"));
        for (size_t k = 0; k < a->n; k++)
            assert_true(a->value[k] == b->value[k]); /* the random ones have their seeds */
    }
    /* Of 4096 samples and more at 1e-2 each point errs by something. */
    assert_true(value(&run.record[8], "true_error") > 1e-6);
    rl_run_clear(&run);
    rl_run_clear(&again);
}

static void test_measures_kernel_and_images(void **state)
{
    (void)state;
    struct rl_run run = {.study = "accuracy"};
    struct rl_bench bench = {0};
    struct rl_error error;
    rl_run_add(&run, &alone, 0, NULL, "part=kernel simd=plain threads=1 size=32 seconds=0.001 rounds=2");
    rl_run_add(&run, &alone, 0, NULL, "part=kernel simd=plain threads=2 size=32 seconds=0.001 rounds=2");
    rl_run_add(&run, &place, 1, NULL,
               "part=images method=reference tolerance=0.0001 threads=1 width=32 height=24 rounds=2");
    rl_run_add(&run, &place, 1, NULL,
               "part=images method=exhaustive tolerance=0.0001 threads=1 width=32 height=24 rounds=2");
    assert_int_equal(study()->measure(&run.record[0], 2, &bench, NULL, &error), RL_OK);
    struct rl_scene scene = {0};
    assert_int_equal(rl_scene_load(&scene, "studies/scenes/sphere-quad.yaml", &error), RL_OK);
    assert_int_equal(study()->measure(&run.record[2], 2, &bench, &scene, &error), RL_OK);
    rl_scene_clear(&scene);
    assert_true(value(&run.record[0], "texel_normals") > 0.0 && value(&run.record[1], "texel_normals") > 0.0);
    assert_true(value(&run.record[2], "seconds") > 0.0 && value(&run.record[2], "lines") > 0.0);
    assert_true(value(&run.record[2], "unconverged") == 0.0 && value(&run.record[2], "worst_error") <= 1e-4);
    assert_true(value(&run.record[3], "texel_normals") > 0.0);
    rl_run_clear(&run);
}

/* Every integrator but exhaustive, whose accuracy is its map's and not a tolerance's; and what the claims look up. */
static void test_plan(void **state)
{
    (void)state;
    static const char *const needed[] = {
        "part=points integrator=reference light=quad tolerance=1e-06",
        "part=points integrator=reference light=quad tolerance=1e-10",
        "part=points integrator=reference light=quad tolerance=0.01",
        "part=points integrator=reference light=quad tolerance=1e-12",
        "part=points integrator=reference light=quad tolerance=1e-05",
        "part=points integrator=cubature-uv light=quad tolerance=1e-05",
        "part=points integrator=montecarlo light=quad tolerance=0.01",
        "part=points integrator=montecarlo light=quad tolerance=0.001",
        "part=images method=reference tolerance=1e-06 threads=1",
        "part=images method=reference tolerance=0.001",
        "part=images method=reference tolerance=1e-08",
        "part=images method=exhaustive",
        "part=kernel simd=plain threads=1",
        "part=images method=reference tolerance=1e-06 width=640 height=480", /* not of the quick grid: it takes too long */
    };
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "accuracy"};
        assert_int_equal(study()->plan_alone(&run, &alone, (enum rl_grid)grid, 0, NULL), RL_OK);
        assert_int_equal(study()->plan(&run, &place, (enum rl_grid)grid, 3, NULL), RL_OK);
        check_plan(&run, needed, sizeof needed / sizeof needed[0] - (grid == RL_GRID_QUICK));
        for (size_t i = 0; i < rl_n_integrators; i++) {
            char pattern[80];
            snprintf(pattern, sizeof pattern, "part=points integrator=%s light=star",
                     rl_integrators[i]->name);
            assert_true((rl_run_find(&run, NULL, pattern) != NULL) ==
                        (strcmp(rl_integrators[i]->name, "exhaustive") != 0));
        }
        rl_run_clear(&run);
    }
}

enum { POINTS = 100, ROUNDS = 7 };

/* What a made-up world is like. */
struct world {
    double reference_us, uv_us, uv_right; /* uv_right: share of points at which cubature-uv is right */
    double montecarlo_exponent, bounded, covered, one_s, two_s, rate, others;
};

static const struct world usual = {.reference_us = 6.0,
                                   .uv_us = 2e5,
                                   .uv_right = 0.3,
                                   .montecarlo_exponent = 2.0,
                                   .bounded = 1.0,
                                   .covered = 0.99,
                                   .one_s = 1.2,
                                   .two_s = 0.61,
                                   .rate = 3e9,
                                   .others = 0.5};

/* `right`: share of points with no error, the others have one of 1. Times vary over the points, those of cubature-uv most. */
static void add_points(struct rl_run *run, const char *integrator, double tolerance, double us, double right,
                       double bounded)
{
    double time[POINTS], off[POINTS], converged[POINTS];
    double spread = strcmp(integrator, "cubature-uv") == 0 ? 0.3 : 0.1;
    for (int i = 0; i < POINTS; i++) {
        time[i] = us * (1.0 + spread * i / POINTS);
        off[i] = i < right * POINTS ? 0.0 : 1.0;
        converged[i] = 1.0;
    }
    struct rl_record *r =
        rl_run_add(run, &alone, 0, NULL, "part=points integrator=%s tolerance=%g light=quad points=%d",
                   integrator, tolerance, POINTS);
    rl_record_series_add(r, "time_us", time, POINTS, NULL);
    rl_record_series_add(r, "true_error", off, POINTS, NULL);
    rl_record_series_add(r, "converged", converged, POINTS, NULL);
    rl_record_metric_add(r, "time_us", us, 0.9 * us, 1.1 * us, "us", NULL);
    rl_record_metric_add(r, "within", right, right, right, "1", NULL);
    rl_record_metric_add(r, "bounded", bounded, bounded, bounded, "1", NULL);
    r->status = RL_RECORD_OK;
}

static void add_image(struct rl_run *run, const struct world *w, int threads, double seconds)
{
    double s[ROUNDS], others[ROUNDS];
    for (int i = 0; i < ROUNDS; i++) {
        s[i] = seconds * (1.0 + 0.001 * i) * (i == 3 ? 2.0 : 1.0); /* one round is slow, for all alike */
        others[i] = 0.02;
    }
    s[5] = fmax(
        1.3, seconds); /* one is disturbed by another program, and any number of threads is as fast as any */
    others[5] = w->others;
    struct rl_record *r =
        rl_run_add(run, &place, 1, NULL,
                   "part=images method=reference tolerance=1e-06 threads=%d width=640 height=480", threads);
    rl_record_series_add(r, "seconds", s, ROUNDS, NULL);
    rl_record_series_add(r, "others", others, ROUNDS, NULL);
    r->status = RL_RECORD_OK;
}

static void make(struct rl_run *run, const struct world *w)
{
    *run = (struct rl_run){.study = "accuracy", .grid = "default"};
    snprintf(run->provenance.cpu, sizeof run->provenance.cpu, "a made-up machine");
    static const double tolerance[] = {1e-2, 1e-5, 1e-6, 1e-10, 1e-12};
    for (size_t i = 0; i < sizeof tolerance / sizeof tolerance[0]; i++)
        add_points(run, "reference", tolerance[i], w->reference_us, 1.0, w->bounded);
    add_points(run, "cubature-uv", 1e-5, w->uv_us, w->uv_right, w->uv_right);
    static const double coarse[] = {1e-2, 3e-3, 1e-3};
    for (size_t i = 0; i < sizeof coarse / sizeof coarse[0]; i++)
        add_points(run, "montecarlo", coarse[i], 500.0 * pow(1e-2 / coarse[i], w->montecarlo_exponent), 1.0,
                   w->covered);
    struct rl_record *r = rl_run_add(run, &alone, 2, NULL, "part=kernel simd=avx2 threads=2");
    rl_record_metric_add(r, "texel_normals", w->rate, 0.99 * w->rate, 1.01 * w->rate, "1/s", NULL);
    r->status = RL_RECORD_OK;
    add_image(run, w, 1, w->one_s);
    add_image(run, w, 2, w->two_s);
}

static struct rl_claim judge(struct world w, const char *words)
{
    struct rl_run run;
    make(&run, &w);
    struct rl_claim found = claim_of("accuracy", &run, words);
    rl_run_clear(&run);
    return found;
}

static void test_flips(void **state)
{
    (void)state;
    static const struct {
        const char *words;
        size_t field;                   /* of struct world */
        double holds, fails, straddles; /* 0 or NaN: there is no such value */
    } table[] = {
        {"at most 20 us a point to 1e-06", offsetof(struct world, reference_us), 15.0, 30.0, 20.0},
        {"at most 100 us a point to 1e-10", offsetof(struct world, reference_us), 80.0, 120.0, 100.0},
        {"at least 10,000 times as fast", offsetof(struct world, uv_us), 2e5, 5e4, 5.85e4},
        {"stated error bounds its true error at every point", offsetof(struct world, bounded), 1.0, 0.99,
         0.0},
        {"Monte Carlo's stated error", offsetof(struct world, covered), 0.99, 0.9, 0.97},
        {"is no ground truth", offsetof(struct world, uv_right), 0.3, 1.0, 0.9},
        {"Monte Carlo's time grows", offsetof(struct world, montecarlo_exponent), 1.9, 1.0, 0.0},
        {"inner loop takes at least 1e9", offsetof(struct world, rate), 2e9, 5e8, 1e9},
        {"takes at most 2 s on two cores", offsetof(struct world, two_s), 0.7, 2.5, 1.5},
        {"at least 1.8 times as fast as one", offsetof(struct world, two_s), 0.61, 0.9, 0.0},
        /* A disturbed round does not count; the same times in a quiet one do. */
        {"at least 1.8 times as fast as one", offsetof(struct world, others), 0.5, NAN, 0.05},
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        const struct {
            double value;
            enum rl_verdict verdict;
        } each[] = {{table[i].holds, RL_VERDICT_HOLDS},
                    {table[i].fails, RL_VERDICT_FAILS},
                    {table[i].straddles, RL_VERDICT_INCONCLUSIVE}};
        for (size_t k = 0; k < 3; k++) {
            if (!(each[k].value > 0.0))
                continue;
            struct world w = usual;
            memcpy((char *)&w + table[i].field, &each[k].value, sizeof each[k].value);
            struct rl_claim c = judge(w, table[i].words);
            if (c.verdict != each[k].verdict)
                fail_msg("'%s' at %g: found %s, %g [%g, %g]", table[i].words, each[k].value,
                         rl_verdict_name(c.verdict), c.value, c.low, c.high);
        }
    }
}

static void test_values(void **state)
{
    (void)state;
    struct rl_claim c = judge(usual, "at least 10,000 times as fast");
    assert_true(c.low < c.value && c.value < c.high && fabs(c.value / (2e5 / 6.0) - 1.03) < 0.01);
    assert_non_null(strstr(c.note, "30 of 100 points"));
    assert_non_null(strstr(c.note, "a made-up machine"));
    assert_string_equal(c.command, "roughlight study run accuracy");
    c = judge(usual, "at least 1.8 times as fast as one"); /* paired: the disturbed round changes nothing */
    assert_true(fabs(c.low - 1.2 / 0.61) < 1e-9 && fabs(c.high - 1.2 / 0.61) < 1e-9);
    assert_string_equal(c.command, "roughlight study run accuracy --scene sphere-quad");
    c = judge(usual, "Monte Carlo's time grows");
    assert_true(fabs(c.value - 2.0) < 1e-9);
    c = judge(usual, "the reference's time does not grow");
    assert_true(fabs(c.value) < 1e-9 && c.verdict == RL_VERDICT_HOLDS);
}

/* Nothing measured: no verdict is made up. */
static void test_missing(void **state)
{
    (void)state;
    struct rl_run run;
    make(&run, &usual);
    check_undecided("accuracy", &run, 15);
    rl_run_clear(&run);
}

/* Where other programs took part in every round there is a number still, and it decides nothing; but that they slow exhaustive down, so
 * that its rate beside them is a lower bound. */
static void test_never_quiet(void **state)
{
    (void)state;
    for (int fast = 0; fast < 2; fast++) {
        struct rl_run run;
        make(&run, &usual);
        struct rl_record *r =
            rl_run_add(&run, &place, 2, NULL, "part=images method=exhaustive threads=2 width=160 height=120");
        double seconds[] = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5}, rate = fast ? 2e9 : 5e8;
        rl_record_metric_add(r, "texel_normals", rate, rate, rate, "1/s", NULL);
        rl_record_metric_add(r, "seconds", 0.5, 0.5, 0.5, "s", NULL);
        rl_record_series_add(r, "seconds", seconds, 6, NULL);
        rl_record_series_add(r, "others", seconds, 6, NULL);
        r->status = RL_RECORD_OK;
        for (size_t k = 0; k < run.n_records; k++)
            for (size_t s = 0; s < run.record[k].n_series; s++)
                for (size_t i = 0; i < ROUNDS && strcmp(run.record[k].series[s].name, "others") == 0 &&
                                   i < run.record[k].series[s].n;
                     i++)
                    run.record[k].series[s].value[i] = 0.5;
        struct rl_claim c = claim_of("accuracy", &run, "exhaustive draws an image");
        assert_int_equal(c.verdict, fast ? RL_VERDICT_HOLDS : RL_VERDICT_INCONCLUSIVE);
        assert_true(c.value == rate && c.low == rate && isinf(c.high));
        c = claim_of("accuracy", &run, "at least 1.8 times as fast as one");
        assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
        assert_true(fabs(c.value - 1.2 / 0.61) < 1e-9 && c.low == 0.0 && isinf(c.high));
        rl_run_clear(&run);
    }
}

/* The smallest and largest of five rounds, or one round alone, are no interval of 95 %: they decide nothing. */
static void test_few_rounds(void **state)
{
    (void)state;
    static const char *const words[] = {"takes at most 2 s on two cores",
                                        "at least 1.8 times as fast as one"};
    for (size_t n = 1; n <= ROUNDS; n++)
        for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
            struct rl_run run;
            struct world w = usual;
            w.others = 0.02;
            w.one_s = 1.3;
            make(&run, &w);
            for (size_t k = 0; k < run.n_records; k++)
                for (size_t s = 0; s < run.record[k].n_series; s++)
                    if (rl_parameters_match(run.record[k].parameters, "part=images"))
                        run.record[k].series[s].n = n;
            struct rl_claim c = claim_of("accuracy", &run, words[i]);
            assert_true(isfinite(c.value) && c.low <= c.value && c.value <= c.high);
            assert_int_equal(c.low == 0.0, n < 6);
            /* An upper bound of 96.9 % takes five. */
            assert_int_equal(isinf(c.high), n < 6 - (i == 0));
            if (i == 0 && n == 5)
                assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
            else if (n < 6)
                assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
            else if (i == 0)
                assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
            rl_run_clear(&run);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_few_rounds),
        cmocka_unit_test(test_never_quiet),
        cmocka_unit_test(test_measures_points),
        cmocka_unit_test(test_measures_kernel_and_images),
        cmocka_unit_test(test_plan),
        cmocka_unit_test(test_flips),
        cmocka_unit_test(test_values),
        cmocka_unit_test(test_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
