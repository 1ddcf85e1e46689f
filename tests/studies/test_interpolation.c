/* The study `interpolation`: rates and verdicts follow from figures of a made-up run;
 * what is measured falls as theory has it. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "measure/metrics.h"
#include "studies/interpolation.h"
#include "studies/judged.h"
#include "support/check.h"
#include "support/temporary.h"

static const struct rl_place alone = {"interpolation", RL_NO_SCENE, "", 0};
static const char *const objects[] = {"sphere", "teapot"};

/* ---- Made-up runs ---- */

struct world {
    double phong, gouraud, constant; /* powers of h */
    double side;                     /* of gouraud, lit from the side */
    double scale[3];                 /* RMSE at h = 1: phong, gouraud, constant */
    double step, jump_gouraud, jump_phong;
    double few, many; /* time to that of phong */
    double noise;     /* A/A */
};

static const struct world usual = {2.0, 2.0, 1.0, 1.8, {0.05, 0.8, 1.0}, 0.1, 3.0, 0.2, 0.7, 1.4, 0.02};

static void metric(struct rl_record *r, const char *name, double value, double low, double high)
{
    assert_non_null(r);
    assert_int_equal(rl_record_metric_add(r, name, value, low, high, "1", NULL), RL_OK);
    r->status = RL_RECORD_OK;
}

static void add_error(struct rl_run *run, const char *object, const char *light, int tessellation,
                      const char *interpolation, double rmse)
{
    double triangles = 16.0 * tessellation * tessellation;
    struct rl_record *r =
        rl_run_add(run, &alone, 0, NULL, "series=error object=%s light=%s tessellation=%d interpolation=%s",
                   object, light, tessellation, interpolation);
    metric(r, "rmse", rmse, rmse, rmse);
    metric(r, "triangles", triangles, triangles, triangles);
}

static void add_line(struct rl_run *run, const char *object, const char *surface, const char *interpolation,
                     double step, double slope, double jump)
{
    struct rl_record *r =
        rl_run_add(run, &alone, 1, NULL, "series=bands object=%s surface=%s interpolation=%s", object,
                   surface, interpolation);
    metric(r, "step", step, step, step);
    metric(r, "slope", slope, slope, slope);
    metric(r, "jump", jump, jump, jump);
}

static void add_time(struct rl_run *run, int tessellation, const char *interpolation, const char *arm,
                     double ratio, double half)
{
    struct rl_record *r =
        rl_run_add(run, &alone, 2, NULL, "series=time object=sphere tessellation=%d interpolation=%s arm=%s",
                   tessellation, interpolation, arm);
    metric(r, "time_to_phong", ratio, ratio - half, ratio + half);
    metric(r, "triangles", 1.0, 1.0, 1.0);
}

/* Tessellations in no order, since axes may come in any; of rates the finest five count, and the coarsest is far off. */
static void make(struct rl_run *run, const struct world *w)
{
    static const int tessellation[] = {32, 2, 8, 4, 64, 16};
    static const char *const modes[] = {"phong", "gouraud", "constant"};
    const double power[] = {w->phong, w->gouraud, w->constant};
    *run = (struct rl_run){.study = "interpolation", .grid = "default"};
    for (int o = 0; o < 2; o++) {
        for (size_t i = 0; i < sizeof tessellation / sizeof tessellation[0]; i++)
            for (int m = 0; m < 3; m++) {
                int t = tessellation[i];
                double off = t == 2 ? 0.7 : 1.0;
                add_error(run, objects[o], "eye", t, modes[m], off * w->scale[m] * pow(t, -power[m]));
                add_error(run, objects[o], "side", t, modes[m],
                          off * w->scale[m] * pow(t, m == 1 ? -w->side : -power[m]));
            }
        add_line(run, objects[o], "mesh", "constant", w->step, 0.0, 0.0);
        add_line(run, objects[o], "mesh", "gouraud", 0.0, 3.0, w->jump_gouraud);
        add_line(run, objects[o], "mesh", "phong", 0.0, 4.0, w->jump_phong);
        add_line(run, objects[o], "exact", "phong", 0.0, 4.0, 0.01);
    }
    for (int t = 4; t <= 64; t *= 4) {
        add_time(run, t, "phong", "frame", 1.0, 0.0);
        add_time(run, t, "gouraud", "frame", t == 4 ? w->few : w->many, 0.001);
        add_time(run, t, "constant", "frame", t == 4 ? w->few : w->many, 0.001);
        add_time(run, t, "phong", "again", 1.0, w->noise);
    }
}

static struct rl_claim judge(struct world w, const char *words)
{
    struct rl_run run;
    make(&run, &w);
    struct rl_claim found = claim_of("interpolation", &run, words);
    rl_run_clear(&run);
    return found;
}

static void rates_are_those_of_the_finest(void **state)
{
    (void)state;
    struct rl_run run, derived;
    make(&run, &usual);
    struct rl_interpolation_rates r = rl_interpolation_rates(&run, "teapot", "side", "gouraud");
    check_near(r.rate.value, 1.8, 1e-9);
    check_near(r.rate.high - r.rate.low, 0.0, 1e-6);
    assert_int_equal(r.points, RL_INTERPOLATION_FITTED);
    check_near(r.from_tessellation, 4.0, 0.0);
    /* 0.8 h^2 = 1/255 at h = 1/14.283: 16 T^2 triangles. */
    r = rl_interpolation_rates(&run, "sphere", "eye", "gouraud");
    check_near(r.triangles.value, 16.0 * 0.8 * 255.0, 1e-6);
    check_near(r.triangles.low, 16.0 * 64.0, 0.0);
    check_near(r.triangles.high, 16.0 * 256.0, 0.0);
    r = rl_interpolation_rates(&run, "sphere", "eye", "constant");
    assert_true(isinf(r.triangles.value) && isinf(r.triangles.high));
    check_near(r.triangles.low, 16.0 * 4096.0, 0.0);
    assert_int_equal(rl_interpolation_derive(&derived, &run, NULL), RL_OK);
    assert_int_equal(derived.n_records, 12);
    assert_non_null(rl_run_find(&derived, RL_NO_SCENE, "object=sphere light=side interpolation=phong"));
    rl_run_clear(&derived);
    rl_run_clear(&run);
    run = (struct rl_run){.study = "interpolation"};
    add_error(&run, "sphere", "eye", 4, "phong", 1e-4);
    r = rl_interpolation_rates(&run, "sphere", "eye", "phong");
    assert_true(isnan(r.rate.value));
    /* Fewer than the first would do: only a bound, no value. */
    assert_true(isnan(r.triangles.value) && r.triangles.low == 0.0 && r.triangles.high == 256.0);
    assert_int_equal(rl_interpolation_derive(&derived, &run, NULL), RL_OK);
    const struct rl_record *row = rl_run_find(&derived, RL_NO_SCENE, "interpolation=phong");
    const struct rl_metric *bound = row ? rl_record_metric(row, "triangles_for_step") : NULL;
    assert_true(bound && isnan(bound->value) && bound->low == 0.0 && bound->high == 256.0);
    rl_run_clear(&derived);
    /* Of Gouraud shading 1024 to 4096: at least 4 times as many, but no telling how many more. */
    add_error(&run, "sphere", "eye", 8, "gouraud", 0.008);
    add_error(&run, "sphere", "eye", 16, "gouraud", 0.002);
    struct rl_claim c =
        claim_of("interpolation", &run, "times the triangles of Phong shading for an RMSE of 1/255 (sphere");
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_true(isinf(c.high));
    check_near(c.low, 4.0, 0.0);
    check_near(c.value, 4.0, 0.0); /* the bound is the number, and its unit says so */
    assert_string_equal(c.unit, "times the triangles or more");
    assert_non_null(strstr(c.note, "phong: at most 256"));
    rl_run_clear(&run);
}

/* Constant shading does not get there, with 65536 triangles; Gouraud's does, with 1024 to 4096: 16 times as many or more. Where neither
 * does, there is no number. */
static void bounds_are_numbers(void **state)
{
    (void)state;
    static const char words[] = "times the triangles of Gouraud shading for an RMSE of 1/255 (teapot";
    struct rl_claim c = judge(usual, words);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    check_near(c.value, 16.0, 0.0);
    check_near(c.low, 16.0, 0.0);
    assert_true(isinf(c.high));
    assert_non_null(strstr(c.note, "constant: more than 6.554e+04, the finest"));
    struct world w = usual;
    w.scale[1] = 100.0;
    c = judge(w, words);
    assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
    assert_true(isnan(c.value) && isnan(c.low) && isnan(c.high));
}

static void verdicts_flip(void **state)
{
    (void)state;
    static const struct {
        const char *words;
        size_t field;
        double value;
        enum rl_verdict verdict;
    } rows[] = {
        {"Phong shading's error falls with the square of the edge (RMSE, sphere",
         offsetof(struct world, phong), 2.0, RL_VERDICT_HOLDS},
        {"Phong shading's error falls with the square of the edge (RMSE, teapot",
         offsetof(struct world, phong), 1.5, RL_VERDICT_FAILS},
        {"Gouraud shading's error falls with the square", offsetof(struct world, gouraud), 1.9,
         RL_VERDICT_HOLDS},
        {"Gouraud shading's error falls with the square", offsetof(struct world, gouraud), 1.7,
         RL_VERDICT_FAILS},
        {"constant shading's error falls with the edge", offsetof(struct world, constant), 1.0,
         RL_VERDICT_HOLDS},
        {"constant shading's error falls with the edge", offsetof(struct world, constant), 1.2,
         RL_VERDICT_FAILS},
        {"a terminator in view", offsetof(struct world, side), 1.7, RL_VERDICT_HOLDS},
        {"a terminator in view", offsetof(struct world, side), 2.1, RL_VERDICT_FAILS},
        {"times the triangles of Phong", offsetof(struct world, scale[0]), 0.01, RL_VERDICT_HOLDS},
        {"times the triangles of Phong", offsetof(struct world, scale[0]), 5.0, RL_VERDICT_FAILS},
        {"times the triangles of Gouraud", offsetof(struct world, scale[1]), 1.0, RL_VERDICT_HOLDS},
        {"steps from triangle to triangle by more than 1/255 (teapot)", offsetof(struct world, step), 0.1,
         RL_VERDICT_HOLDS},
        {"steps from triangle to triangle by more than 1/255 (teapot)", offsetof(struct world, step), 0.001,
         RL_VERDICT_FAILS},
        {"Gouraud shading makes Mach bands", offsetof(struct world, jump_gouraud), 3.0, RL_VERDICT_HOLDS},
        {"Gouraud shading makes Mach bands", offsetof(struct world, jump_gouraud), 1.9, RL_VERDICT_FAILS},
        {"Phong shading leaves no Mach bands", offsetof(struct world, jump_phong), 0.3, RL_VERDICT_HOLDS},
        {"Phong shading leaves no Mach bands", offsetof(struct world, jump_phong), 0.5, RL_VERDICT_FAILS},
        {"Gouraud shading takes no longer than Phong shading (a frame of the sphere, the fewest",
         offsetof(struct world, few), 0.7, RL_VERDICT_HOLDS},
        {"Gouraud shading takes no longer than Phong shading (a frame of the sphere, the fewest",
         offsetof(struct world, few), 1.01, RL_VERDICT_INCONCLUSIVE},
        {"constant shading takes no longer than Phong shading (a frame of the sphere, the most",
         offsetof(struct world, many), 1.4, RL_VERDICT_FAILS},
        {"constant shading takes no longer than Phong shading (a frame of the sphere, the most",
         offsetof(struct world, noise), 0.6, RL_VERDICT_INCONCLUSIVE},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct world w = usual;
        memcpy((char *)&w + rows[i].field, &rows[i].value, sizeof rows[i].value);
        struct rl_claim c = judge(w, rows[i].words);
        check_verdict(&c, rows[i].verdict, rows[i].words, rows[i].value);
    }
    check_near(judge(usual, "Gouraud shading makes Mach").value, 0.75, 1e-12);
    check_near(judge(usual, "a terminator in view").value, 0.2, 1e-9);
    assert_string_equal(judge(usual, "a terminator in view").command, "roughlight study run interpolation");
}

static void nothing_measured(void **state)
{
    (void)state;
    struct rl_run run;
    make(&run, &usual);
    check_undecided("interpolation", &run, 20);
    rl_run_clear(&run);
}

/* ---- Measured ---- */

static double figure(const struct rl_run *run, const char *pattern, const char *name)
{
    const struct rl_record *r = rl_run_find(run, RL_NO_SCENE, pattern);
    const struct rl_metric *m = r ? rl_record_metric(r, name) : NULL;
    if (!m)
        fail_msg("nothing was measured for '%s'", pattern);
    return m ? m->value : NAN;
}

/* The quick grid but for its times, as the runner would. */
static void measure_all(struct rl_run *run, struct rl_bench *bench)
{
    const struct rl_study *study = rl_study_find("interpolation");
    struct rl_error error;
    *run = (struct rl_run){.study = "interpolation", .grid = "quick"};
    check_ok(study->plan_alone(run, &alone, RL_GRID_QUICK, 0, &error), &error);
    for (size_t first = 0, end; first < run->n_records; first = end) {
        for (end = first; end < run->n_records && run->record[end].group == run->record[first].group; end++)
            run->record[end].status = RL_RECORD_OK;
        if (rl_parameters_match(run->record[first].parameters, "series=time"))
            continue;
        check_ok(study->measure(&run->record[first], end - first, bench, NULL, &error), &error);
    }
}

/* A picture on the GPU against one of a mesh with 64 times the triangles, per pixel: another way to the same error, but for outlines. */
static double error_of_picture(struct rl_bench *bench, const char *interpolation)
{
    struct rl_error error;
    struct rl_scene coarse, fine;
    struct rl_image drawn, truth;
    struct rl_metrics m;
    char parameters[128];
    check_ok(rl_interpolation_scene_make(&coarse, "sphere", 8, "eye", 20.0, &error), &error);
    check_ok(rl_interpolation_scene_make(&fine, "sphere", 64, "eye", 20.0, &error), &error);
    snprintf(parameters, sizeof parameters, "interpolation=%s width=160 height=120", interpolation);
    check_ok(rl_bench_picture(&drawn, bench, &coarse, parameters, 1, &error), &error);
    check_ok(rl_bench_picture(&truth, bench, &fine, "interpolation=phong width=160 height=120", 1, &error),
             &error);
    check_ok(rl_metrics_compute(&m, &drawn, &truth, &error), &error);
    rl_image_clear(&drawn);
    rl_image_clear(&truth);
    rl_interpolation_scene_free(&coarse);
    rl_interpolation_scene_free(&fine);
    return m.rmse;
}

static void errors_fall(void **state)
{
    (void)state;
    static const char *const lights[] = {"eye", "side"};
    struct temporary folder = {0};
    char cache[PATH_MAX], pattern[160];
    struct rl_bench bench;
    struct rl_error error;
    struct rl_run run;
    temporary_make(&folder);
    temporary_path(&folder, cache, "cache");
    check_ok(rl_bench_open(&bench, "auto", 0, cache, NULL, &error), &error);
    measure_all(&run, &bench);
    for (int o = 0; o < 2; o++)
        for (int l = 0; l < 2; l++) {
            double last[RL_INTERPOLATIONS] = {1.0, 1.0, 1.0};
            for (int t = o ? 2 : 4; t <= (o ? 16 : 32); t *= 2) {
                double here[RL_INTERPOLATIONS];
                for (int i = 0; i < RL_INTERPOLATIONS; i++) {
                    snprintf(pattern, sizeof pattern,
                             "series=error object=%s light=%s tessellation=%d interpolation=%s", objects[o],
                             lights[l], t, rl_interpolation_name((enum rl_interpolation)i));
                    here[i] = figure(&run, pattern, "rmse");
                    assert_true(here[i] < last[i]);
                    assert_true(here[i] < figure(&run, pattern, "max"));
                    last[i] = here[i];
                }
                assert_true(here[RL_INTERPOLATION_PHONG] < here[RL_INTERPOLATION_GOURAUD]);
                assert_true(here[RL_INTERPOLATION_GOURAUD] < here[RL_INTERPOLATION_CONSTANT]);
            }
        }
    static const char *const modes[] = {"gouraud", "constant"};
    for (int m = 0; m < 2; m++) {
        snprintf(pattern, sizeof pattern,
                 "series=error object=sphere light=eye tessellation=8 interpolation=%s", modes[m]);
        double drawn = error_of_picture(&bench, modes[m]), found = figure(&run, pattern, "rmse");
        print_message("%s: %.4g on the surface, %.4g in the picture\n", modes[m], found, drawn);
        check_relative(drawn, found, 0.2);
    }
    /* The surface itself is smooth; a constant jumps; Gouraud has corners. */
    double own = figure(&run, "series=bands object=sphere surface=exact", "slope");
    assert_true(figure(&run, "series=bands object=sphere surface=exact", "jump") < 0.01 * own);
    assert_true(figure(&run, "series=bands object=sphere surface=mesh interpolation=gouraud", "jump") >
                0.5 * own);
    assert_true(figure(&run, "series=bands object=sphere surface=mesh interpolation=constant", "step") >
                0.05);
    rl_run_clear(&run);
    rl_bench_close(&bench);
    temporary_remove(&folder);
}

static void every_grid_has_what_claims_need(void **state)
{
    (void)state;
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "interpolation"};
        const struct rl_study *study = rl_study_find("interpolation");
        assert_int_equal(study->plan_alone(&run, &alone, (enum rl_grid)grid, 0, NULL), RL_OK);
        static const char *const needed[] = {
            "series=error object=sphere light=side interpolation=gouraud",
            "series=error object=teapot light=eye interpolation=constant",
            "series=bands object=teapot surface=exact interpolation=phong",
            "series=bands object=sphere surface=mesh interpolation=gouraud",
            "series=time object=sphere interpolation=constant arm=frame",
            "series=time object=sphere interpolation=phong arm=again",
        };
        check_plan(&run, needed, sizeof needed / sizeof needed[0]);
        rl_run_clear(&run);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bounds_are_numbers), cmocka_unit_test(rates_are_those_of_the_finest),
        cmocka_unit_test(verdicts_flip),      cmocka_unit_test(nothing_measured),
        cmocka_unit_test(errors_fall),        cmocka_unit_test(every_grid_has_what_claims_need),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
