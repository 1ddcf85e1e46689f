/* The study `roughness`: its plan, its counts of normals, and that its verdicts follow from the rows: other rows, other verdict. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/progress.h"
#include "studies/judged.h"
#include "studies/roughness.h"
#include "studies/runner.h"

static const struct rl_place place = {"roughness", "made-up", "made-up.yaml", 1};
static const double rrs[] = {1.0, 30.0, 1000.0};

/* What a made-up world is like at every R_r but for `smooth`, which multiplies the floor but for parallax at R_r = 1000. */
struct world {
    double noise_1, parallax, floor_centre, smooth;
    double fine; /* floor_centre of the fine setting */
    double plain, regular_13, exhaustive;
    double fall; /* noise falls as N^fall */
    double spread;
};

static const struct world usual = {
    .noise_1 = 0.1,
    .parallax = 0.01,
    .floor_centre = 0.001,
    .smooth = 10.0,
    .fine = 0.001,
    .plain = 0.2,
    .regular_13 = 0.04,
    .exhaustive = 0.001,
    .fall = -0.5,
    .spread = 0.01,
};

static void metric(struct rl_record *r, const char *name, double value, double spread)
{
    assert_int_equal(
        rl_record_metric_add(r, name, value, value * (1.0 - spread), value * (1.0 + spread), "1", NULL),
        RL_OK);
    r->status = RL_RECORD_OK;
}

static double count(double variance, double floor)
{
    double room = pow(1.0 / 255.0, 2) - floor * floor;
    return room > 0.0 ? ceil(variance / room) : INFINITY;
}

static void add_rr(struct rl_run *run, const struct world *w, double rr)
{
    double centre = w->floor_centre * (rr > 100.0 ? w->smooth : 1.0), floor = hypot(centre, w->parallax);
    static const int samples[] = {4, 16, 64};
    for (size_t i = 0; i < 3; i++) {
        struct rl_record *r =
            rl_run_add(run, &place, 0, NULL, "series=methods setting=paper method=random samples=%d rr=%g",
                       samples[i], rr);
        double noise = w->noise_1 * pow(samples[i], w->fall);
        metric(r, "rmse", hypot(noise, floor), w->spread);
        metric(r, "rmse_centre", hypot(noise, centre), w->spread);
        metric(r, "variance", noise * noise, w->spread);
    }
    metric(rl_run_add(run, &place, 0, NULL, "series=methods setting=paper method=plain samples=0 rr=%g", rr),
           "rmse", w->plain, 0.0);
    metric(
        rl_run_add(run, &place, 0, NULL, "series=methods setting=paper method=regular samples=13 rr=%g", rr),
        "rmse", w->regular_13, 0.0);
    metric(rl_run_add(run, &place, 0, NULL, "series=methods setting=paper method=exhaustive rr=%g", rr),
           "rmse_centre", w->exhaustive, 0.0);
    for (int fine = 0; fine < 2; fine++) {
        double c = fine ? 0.0 : centre;
        struct rl_record *r =
            rl_run_add(run, &place, 0, NULL, "series=needed setting=%s rr=%g", fine ? "fine" : "paper", rr);
        metric(r, "floor", hypot(c, w->parallax), w->spread);
        metric(r, "floor_centre", fine ? w->fine : centre, w->spread);
        metric(r, "needed", count(w->noise_1 * w->noise_1, hypot(c, w->parallax)), w->spread);
        metric(r, "needed_centre", count(w->noise_1 * w->noise_1, c), w->spread);
    }
}

static void make(struct rl_run *run, const struct world *w)
{
    *run = (struct rl_run){.study = "roughness", .grid = "default"};
    for (size_t i = 0; i < sizeof rrs / sizeof rrs[0]; i++)
        add_rr(run, w, rrs[i]);
}

static struct rl_claim judge(const struct rl_run *run, const char *words)
{
    return claim_of("roughness", run, words);
}

static struct rl_claim claim_in(struct world w, const char *words)
{
    struct rl_run run;
    make(&run, &w);
    struct rl_claim c = judge(&run, words);
    rl_run_clear(&run);
    return c;
}

#define VERDICT(w, words) ((int)claim_in(w, words).verdict)

static void verdicts_follow_from_rows(void **state)
{
    (void)state;
    struct world w = usual;
    static const char four[] = "paper: 4 random normals a pixel suffice";
    assert_int_equal(VERDICT(w, four), RL_VERDICT_FAILS);
    w.noise_1 = 0.001;
    assert_int_equal(VERDICT(w, four), RL_VERDICT_FAILS); /* parallax */
    w.parallax = 0.001;
    assert_int_equal(VERDICT(w, four), RL_VERDICT_HOLDS_UP_TO);
    assert_true(claim_in(w, four).value == 30.0 && claim_in(w, four).high == 1000.0);
    w.smooth = 1.0;
    assert_int_equal(VERDICT(w, four), RL_VERDICT_HOLDS);

    w = usual;
    static const char but[] = "but for parallax (lights seen from the object's centre) 4 random";
    assert_int_equal(VERDICT(w, but), RL_VERDICT_FAILS);
    w.noise_1 = 0.001;
    assert_int_equal(VERDICT(w, but), RL_VERDICT_HOLDS_UP_TO);

    w = usual;
    static const char some[] = "paper's settings some number", some_centre[] = "the same but for parallax",
                      some_fine[] = "float normals and a large map some number";
    assert_int_equal(VERDICT(w, some), RL_VERDICT_FAILS);
    assert_int_equal(VERDICT(w, some_centre), RL_VERDICT_HOLDS_UP_TO);
    assert_int_equal(VERDICT(w, some_fine), RL_VERDICT_HOLDS);
    w.parallax = 0.0;
    assert_int_equal(VERDICT(w, some), RL_VERDICT_HOLDS_UP_TO);

    w = usual;
    static const char fine[] = "nothing but parallax stays";
    assert_int_equal(VERDICT(w, fine), RL_VERDICT_HOLDS);
    static const char attenuation[] = "attenuation is as the reference has it";
    assert_int_equal(VERDICT(w, attenuation), RL_VERDICT_HOLDS);
    w.fine = 0.0025;
    assert_int_equal(VERDICT(w, attenuation), RL_VERDICT_FAILS);
    assert_int_equal(VERDICT(w, fine), RL_VERDICT_HOLDS);
    w.fine = 0.005;
    assert_int_equal(VERDICT(w, fine), RL_VERDICT_FAILS);

    w = usual;
    static const char sum[] = "exhaustive sum over the texels";
    assert_int_equal(VERDICT(w, sum), RL_VERDICT_HOLDS);
    w.exhaustive = 0.01;
    assert_int_equal(VERDICT(w, sum), RL_VERDICT_FAILS);

    w = usual;
    static const char falls[] = "noise falls as 1/N";
    assert_int_equal(VERDICT(w, falls), RL_VERDICT_HOLDS);
    w.fall = -0.4;
    assert_int_equal(VERDICT(w, falls), RL_VERDICT_FAILS); /* 16^0.2 = 1.74 */

    w = usual;
    static const char plain[] = "less error than plain", regular[] = "no more error than 13 regular";
    assert_int_equal(VERDICT(w, plain), RL_VERDICT_HOLDS);
    w.plain = 0.01;
    assert_int_equal(VERDICT(w, plain), RL_VERDICT_FAILS);
    assert_int_equal(VERDICT(w, regular), RL_VERDICT_FAILS); /* 0.05 against 0.04 */
    w.regular_13 = 0.06;
    assert_int_equal(VERDICT(w, regular), RL_VERDICT_HOLDS);
}

/* Nothing measured: no verdict is made up. */
static void nothing_measured_is_inconclusive(void **state)
{
    (void)state;
    struct rl_run run;
    make(&run, &usual);
    check_undecided("roughness", &run, 8);
    rl_run_clear(&run);
}

static void every_grid_has_what_the_claims_need(void **state)
{
    (void)state;
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "roughness"};
        assert_int_equal(rl_study_find("roughness")->plan(&run, &place, (enum rl_grid)grid, 0, NULL), RL_OK);
        for (size_t i = 0; i < run.n_records; i++) {
            bool random = rl_parameters_match(run.record[i].parameters, "method=random");
            assert_true(random == (rl_parameter_number(run.record[i].parameters, "seeds") >= 16.0));
        }
        static const char *const needed[] = {
            "series=methods setting=paper method=random samples=4",
            "series=methods setting=paper method=random samples=16",
            "series=methods setting=paper method=regular samples=13",
            "series=methods setting=paper method=plain",
            "series=methods setting=paper method=exhaustive",
            "series=methods setting=fine method=random",
            "series=needed setting=paper",
            "series=needed setting=fine",
        };
        check_plan(&run, needed, sizeof needed / sizeof needed[0]);
        rl_run_clear(&run);
    }
}

static void value_of(const struct rl_run *run, const char *pattern, const char *name, double *value)
{
    const struct rl_record *r = rl_run_find(run, NULL, pattern);
    assert_non_null(r);
    assert_non_null(rl_record_metric(r, name));
    *value = rl_record_metric(r, name)->value;
}

/* One R_r of the quick grid, measured: the parts make the whole, the count follows from them, and noise falls as it must. */
static void measured_figures_obey_their_formulas(void **state)
{
    (void)state;
    struct rl_bench bench;
    struct rl_scene scene;
    struct rl_error error = {0};
    struct rl_progress quiet = {0};
    const char *build = getenv("BUILD");
    char cache[256];
    snprintf(cache, sizeof cache, "%s/tests/cache", build ? build : "build");
    assert_int_equal(rl_bench_open(&bench, "auto", 0, cache, &quiet, &error), RL_OK);
    assert_int_equal(rl_study_scene_load(&scene, "sphere-quad", &error), RL_OK);
    struct rl_run run = {.study = "roughness"};
    const struct rl_study *study = rl_study_find("roughness");
    assert_int_equal(study->plan(&run, &place, RL_GRID_QUICK, 0, &error), RL_OK);
    size_t n = 0;
    while (n < run.n_records && run.record[n].group == 0)
        n++;
    if (study->measure(run.record, n, &bench, &scene, &error) != RL_OK)
        fail_msg("%s", error.message);
    for (size_t i = 0; i < n; i++)
        run.record[i].status = RL_RECORD_OK;
    double variance[2], rmse, bias2, floor, one, needed, plain;
    value_of(&run, "series=methods method=random samples=4", "variance", &variance[0]);
    value_of(&run, "series=methods method=random samples=16 setting=paper", "variance", &variance[1]);
    assert_true(variance[0] / variance[1] > 3.0 && variance[0] / variance[1] < 5.0);
    value_of(&run, "series=methods method=random samples=4", "rmse", &rmse);
    value_of(&run, "series=methods method=random samples=4", "bias2", &bias2);
    assert_true(fabs(rmse * rmse - bias2 - variance[0]) < 1e-9);
    value_of(&run, "series=needed setting=paper", "variance_1", &one);
    assert_true(fabs(one - 0.5 * (4.0 * variance[0] + 16.0 * variance[1])) < 1e-12);
    value_of(&run, "series=needed setting=paper", "floor_centre", &floor);
    value_of(&run, "series=needed setting=paper", "needed_centre", &needed);
    assert_true(needed == count(one, floor));
    value_of(&run, "series=methods method=plain", "rmse", &plain);
    assert_true(plain > 0.01 && plain < 0.5);
    value_of(&run, "series=methods method=exhaustive", "rmse_centre", &rmse);
    assert_true(rmse > 0.0 && rmse < 0.02); /* texels of a small map */
    rl_run_clear(&run);
    rl_scene_clear(&scene);
    rl_bench_close(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdicts_follow_from_rows),
        cmocka_unit_test(nothing_measured_is_inconclusive),
        cmocka_unit_test(every_grid_has_what_the_claims_need),
        cmocka_unit_test(measured_figures_obey_their_formulas),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
