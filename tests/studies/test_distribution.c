/* The study `distribution`: verdicts follow from figures of a made-up run; what is measured obeys what is known of it. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "studies/judged.h"
#include "studies/study.h"
#include "support/check.h"

static const struct rl_place place = {"distribution", RL_NO_SCENE, "", 0};

/* What the whole program makes of an R_r, but for a factor that tests plant: the linker puts this in its place (Makefile). */
static double planted = 1.0;
struct rl_ellipsoid __real_rl_ellipsoid_make(double rr);
struct rl_ellipsoid __wrap_rl_ellipsoid_make(double rr);
struct rl_ellipsoid __wrap_rl_ellipsoid_make(double rr)
{
    return __real_rl_ellipsoid_make(planted * rr);
}

/* Figures of maps grow with R_r: `reach` is the R_r at which 8 bits and halves are off by about as much as the claims allow. */
struct world {
    double misfit_float, misfit_16;
    double far_float, far_16;   /* Kolmogorov distances */
    double reach_8, reach_half; /* above it distance and width (8), tilt (half) are far, below near */
    double tilt_8;
    double restarted, bias_8, bias_float,
        noise; /* restarted generator's bias over the hash's noise; baked maps' bias, noise over the hash's */
    double spread; /* half width of intervals */
    double
        lean; /* the float maps' mean direction off N, over D's root mean square sine; its half width is 0.005 */
    double p; /* of every chi-square test */
};

static const struct world usual = {.misfit_float = 0.005,
                                   .misfit_16 = 0.01,
                                   .far_float = 0.002,
                                   .far_16 = 0.003,
                                   .reach_8 = 10.0,
                                   .reach_half = 300.0,
                                   .tilt_8 = 1e-5,
                                   .restarted = 1.0,
                                   .bias_8 = 0.0005,
                                   .bias_float = 0.0005,
                                   .noise = 1.0,
                                   .spread = 0.002,
                                   .lean = 0.002,
                                   .p = 0.5};

static void metric(struct rl_record *r, const char *name, double value, double spread)
{
    assert_int_equal(rl_record_metric_add(r, name, value, value - spread, value + spread, "1", NULL), RL_OK);
    r->status = RL_RECORD_OK;
}

static void add_map(struct rl_run *run, const struct world *w, double rr, const char *bits)
{
    struct rl_record *r =
        rl_run_add(run, &place, 0, NULL, "series=map rr=%g normal_bits=%s normal_size=512", rr, bits);
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    bool float_map = strcmp(bits, "float") == 0, eight = strcmp(bits, "8") == 0;
    bool near_8 = rr <= w->reach_8;
    double misfit = float_map ? w->misfit_float : eight ? (near_8 ? 0.01 : 0.5) : w->misfit_16;
    metric(r, "p_delta", w->p, 0.0);
    metric(r, "p_theta", w->p, 0.0);
    metric(r, "misfit_delta", 0.0, w->spread);
    metric(r, "misfit_theta", misfit, w->spread);
    metric(r, "kolmogorov", float_map ? w->far_float : eight ? (near_8 ? 0.005 : 0.1) : w->far_16, w->spread);
    metric(r, "width", eight && !near_8 ? 1.5 : 1.0, w->spread);
    double median = rl_ellipsoid_inverse(&e, 0.75).delta;
    /* Any scale will do, but that the lean must be in terms of it. */
    double rms = 0.6 / rr;
    metric(r, "d_median", median, 0.0);
    metric(r, "d_rms_sine", rms, 0.0);
    metric(r, "mean_tilt", rms * (float_map ? w->lean : 1.0), rms * 0.005);
    metric(r, "tilt", eight ? w->tilt_8 : (rr <= w->reach_half ? 0.001 : 0.02) * median, 1e-9);
}

static void add_point(struct rl_run *run, const char *generator, const char *bits, double bias, double share,
                      double noise, double spread)
{
    struct rl_record *r = rl_run_add(run, &place, 1, NULL,
                                     "series=point generator=%s normal_bits=%s samples=4", generator, bits);
    metric(r, "bias", bias, spread);
    metric(r, "floor", fabs(bias), spread);
    metric(r, "bias_share", share, 0.0);
    metric(r, "noise", noise, spread);
}

static void make(struct rl_run *run, const struct world *w)
{
    static const double rr[] = {1.0, 10.0, 300.0, 1000.0};
    static const char *const bits[] = {"8", "16", "half", "float"};
    *run = (struct rl_run){.study = "distribution", .grid = "default"};
    for (size_t i = 0; i < 4; i++)
        for (size_t b = 0; b < 4; b++)
            add_map(run, w, rr[i], bits[b]);
    add_point(run, "lcg", "float", 0.24 * w->restarted, 1.0, 0.0, 0.02);
    add_point(run, "baked", "float", w->bias_float, 0.0, 0.24 * w->noise, w->spread);
    add_point(run, "baked", "8", w->bias_8, 0.0, 0.24 * w->noise, w->spread);
    add_point(run, "hash", "float", 0.0, 0.0, 0.24, w->spread);
}

static struct rl_claim judge(struct world w, const char *words)
{
    struct rl_run run;
    make(&run, &w);
    struct rl_claim found = claim_of("distribution", &run, words);
    rl_run_clear(&run);
    return found;
}

static void verdicts_flip(void **state)
{
    (void)state;
    /* One field of the usual world changed, and the verdict that must follow. */
    static const char inverse[] = "normals by the inverse cdf", cdf_8[] = "the cdf of an 8-bit",
                      cdf_16[] = "the cdf of a 16-bit", bins_8[] = "an 8-bit map's normals fill",
                      bins_16[] = "a 16-bit map's normals fill", bins_float[] = "a float map's normals fill",
                      tilt_8[] = "8 bits do not tilt", tilt_half[] = "half floats",
                      width[] = "the lobe that an 8-bit map holds", restarted[] = "restarted at every pixel",
                      baked_8[] = "baked into a map serve", baked_float[] = "baked into a float map",
                      lean[] = "do not lean", hash[] = "as noisy as those of a hash";
    static const struct {
        const char *words;
        size_t field;
        double value;
        enum rl_verdict verdict;
    } rows[] = {
        {inverse, offsetof(struct world, far_float), 0.02, RL_VERDICT_FAILS},
        {inverse, offsetof(struct world, far_float), 0.009, RL_VERDICT_INCONCLUSIVE},
        {bins_float, offsetof(struct world, misfit_float), 0.005, RL_VERDICT_HOLDS},
        {bins_float, offsetof(struct world, misfit_float), 0.03, RL_VERDICT_FAILS},
        {bins_float, offsetof(struct world, misfit_float), 0.019, RL_VERDICT_INCONCLUSIVE},
        {bins_float, offsetof(struct world, spread), 0.05,
         RL_VERDICT_INCONCLUSIVE}, /* few texels prove nothing */
        {bins_float, offsetof(struct world, p), 1e-9,
         RL_VERDICT_HOLDS}, /* and many disprove nothing that matters */
        {bins_16, offsetof(struct world, misfit_16), 0.01, RL_VERDICT_HOLDS},
        {bins_16, offsetof(struct world, misfit_16), 0.03, RL_VERDICT_FAILS},
        {cdf_8, offsetof(struct world, reach_8), 10.0, RL_VERDICT_HOLDS_UP_TO},
        {cdf_8, offsetof(struct world, reach_8), 1e4, RL_VERDICT_HOLDS},
        {cdf_8, offsetof(struct world, reach_8), 0.5, RL_VERDICT_FAILS},
        {cdf_16, offsetof(struct world, far_16), 0.003, RL_VERDICT_HOLDS},
        {cdf_16, offsetof(struct world, far_16), 0.02, RL_VERDICT_FAILS},
        {cdf_16, offsetof(struct world, far_16), 0.01, RL_VERDICT_INCONCLUSIVE},
        {bins_8, offsetof(struct world, reach_8), 10.0, RL_VERDICT_HOLDS_UP_TO},
        {bins_8, offsetof(struct world, reach_8), 0.5, RL_VERDICT_FAILS},
        {tilt_8, offsetof(struct world, tilt_8), 1e-5, RL_VERDICT_HOLDS},
        {tilt_8, offsetof(struct world, tilt_8), 1e-3, RL_VERDICT_FAILS},
        {tilt_half, offsetof(struct world, reach_half), 300.0, RL_VERDICT_HOLDS_UP_TO},
        {tilt_half, offsetof(struct world, reach_half), 1e4, RL_VERDICT_HOLDS},
        {width, offsetof(struct world, reach_8), 10.0, RL_VERDICT_HOLDS_UP_TO},
        {width, offsetof(struct world, reach_8), 0.5, RL_VERDICT_FAILS},
        {lean, offsetof(struct world, lean), 0.0, RL_VERDICT_HOLDS},
        {lean, offsetof(struct world, lean), 0.004, RL_VERDICT_HOLDS},
        {lean, offsetof(struct world, lean), 0.007,
         RL_VERDICT_INCONCLUSIVE}, /* 0 is outside of it, and 0.01 within */
        {lean, offsetof(struct world, lean), 0.02, RL_VERDICT_FAILS},
        {restarted, offsetof(struct world, restarted), 1.0, RL_VERDICT_HOLDS},
        {restarted, offsetof(struct world, restarted), 0.0, RL_VERDICT_FAILS},
        {restarted, offsetof(struct world, restarted), 0.3, RL_VERDICT_FAILS},
        {restarted, offsetof(struct world, restarted), 0.5, RL_VERDICT_INCONCLUSIVE},
        {baked_8, offsetof(struct world, bias_8), 0.0005, RL_VERDICT_HOLDS},
        {baked_8, offsetof(struct world, bias_8), -0.02, RL_VERDICT_FAILS}, /* whatever a float map does */
        {baked_8, offsetof(struct world, bias_8), 0.003, RL_VERDICT_INCONCLUSIVE},
        {baked_8, offsetof(struct world, bias_float), 0.01, RL_VERDICT_HOLDS},
        {baked_float, offsetof(struct world, bias_8), -0.02, RL_VERDICT_HOLDS},
        {baked_float, offsetof(struct world, bias_float), 0.01, RL_VERDICT_FAILS},
        {hash, offsetof(struct world, noise), 1.0, RL_VERDICT_HOLDS},
        {hash, offsetof(struct world, noise), 1.2, RL_VERDICT_FAILS},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct world w = usual;
        memcpy((char *)&w + rows[i].field, &rows[i].value, sizeof rows[i].value);
        struct rl_claim c = judge(w, rows[i].words);
        check_verdict(&c, rows[i].verdict, rows[i].words, rows[i].value);
        assert_string_equal(c.command, "roughlight study run distribution");
    }
    /* The limit lies between the last R_r that holds and the first that fails. */
    static const char *const along[] = {cdf_8, bins_8, width};
    for (size_t i = 0; i < 3; i++) {
        struct rl_claim c = judge(usual, along[i]);
        assert_true(c.value == 10.0 && c.low == 10.0 && c.high == 300.0);
        assert_string_equal(c.unit, "R_r and rougher");
    }
    struct rl_claim half = judge(usual, tilt_half);
    assert_true(half.value == 300.0 && half.low == 300.0 && half.high == 1000.0);
    struct rl_claim leaning = judge(usual, lean);
    check_near(leaning.value, 0.002, 1e-12);
    check_near(leaning.high, 0.007, 1e-12);
    check_near(judge(usual, bins_float).value, 0.005, 1e-12); /* theta's, the larger */
    check_near(judge(usual, baked_8).value, 0.0005, 1e-15);
}

/* Nothing measured: no verdict is made up. */
static void nothing_measured(void **state)
{
    (void)state;
    struct rl_run run;
    make(&run, &usual);
    check_undecided("distribution", &run, 14);
    rl_run_clear(&run);
}

static const struct rl_record *measured(const struct rl_run *run, const char *pattern)
{
    const struct rl_record *r = rl_run_find(run, RL_NO_SCENE, pattern);
    if (!r)
        fail_msg("nothing was measured for '%s'", pattern);
    return r;
}

static struct rl_metric figure(const struct rl_run *run, const char *pattern, const char *name)
{
    const struct rl_metric *m = rl_record_metric(measured(run, pattern), name);
    assert_non_null(m);
    assert_true(m->low <= m->value && m->value <= m->high);
    return *m;
}

/* The groups of the quick grid whose series it is, as the runner would. */
static void measure(struct rl_run *run, const char *series)
{
    const struct rl_study *study = rl_study_find("distribution");
    struct rl_bench bench;
    struct rl_error error;
    *run = (struct rl_run){.study = "distribution", .grid = "quick"};
    check_ok(rl_bench_open(&bench, "auto", 0, "", NULL, &error), &error);
    check_ok(study->plan_alone(run, &place, RL_GRID_QUICK, 0, &error), &error);
    for (size_t first = 0, end; first < run->n_records; first = end) {
        for (end = first; end < run->n_records && run->record[end].group == run->record[first].group;)
            end++;
        if (!rl_parameters_match(run->record[first].parameters, series))
            continue;
        for (size_t i = first; i < end; i++)
            run->record[i].status = RL_RECORD_OK;
        check_ok(study->measure(&run->record[first], end - first, &bench, NULL, &error), &error);
    }
    rl_bench_close(&bench);
}

/* Normals of another R_r than was asked for, everywhere in the program: what they are held against must not move with them. */
static void another_rr_is_seen(void **state)
{
    (void)state;
    static const char *const words[] = {"normals by the inverse cdf", "a float map's normals fill"};
    static const struct {
        double factor;
        bool fails;
    } rows[] = {{1.0, false}, {1.3, true}, {0.7, true}, {1.15, true}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_run run;
        planted = rows[i].factor;
        measure(&run, "series=map");
        planted = 1.0;
        for (size_t k = 0; k < 2; k++) {
            struct rl_claim c = claim_of("distribution", &run, words[k]);
            if ((c.verdict == RL_VERDICT_FAILS) != rows[i].fails)
                fail_msg("R_r times %g: '%s' %s, at %g [%g, %g]", rows[i].factor, words[k],
                         rl_verdict_name(c.verdict), c.value, c.low, c.high);
        }
        rl_run_clear(&run);
    }
}

static void what_is_known_is_measured(void **state)
{
    (void)state;
    struct rl_run run;
    measure(&run, "series=map");
    /* Float maps follow D. */
    static const char *const smooth[] = {"series=map normal_bits=float rr=1",
                                         "series=map normal_bits=float rr=30",
                                         "series=map normal_bits=float rr=1000"};
    for (size_t i = 0; i < 3; i++) {
        assert_true(figure(&run, smooth[i], "p_delta").value > 1e-4);
        assert_true(figure(&run, smooth[i], "p_theta").value > 1e-4);
        check_near(figure(&run, smooth[i], "mean_u").value, 0.5, 4.0 * sqrt(1.0 / 12.0) / 128.0);
        check_near(figure(&run, smooth[i], "width").value, 1.0, 0.05);
        assert_true(figure(&run, smooth[i], "tilt").value < 1e-8);
    }
    /* 8 bits at R_r = 1000: nearly all normals are the four with tangential parts +-1/255, at |delta| = sqrt(2)/255, which is
     * 5.5 times the median of D, tan(atan(k)/2)/k; only delta's outer sixteenth moves. */
    static const char eight[] = "series=map normal_bits=8 rr=1000";
    check_near(figure(&run, eight, "width").value, sqrt(2.0) / 255.0 / (tan(atan(1000.0) / 2.0) / 1000.0),
               0.02);
    check_near(figure(&run, eight, "kolmogorov").value, 0.45, 0.02);
    assert_true(figure(&run, eight, "p_delta").value < 1e-100);
    rl_run_clear(&run);
}

/* G is 1 about the mirror direction and the light has radiance 1: a sample is 1 with probability L_o, else 0. */
static void generators_as_expected(void **state)
{
    (void)state;
    struct rl_run run;
    measure(&run, "");
    double truth = figure(&run, "series=point generator=hash samples=4", "truth").value;
    double variance = truth * (1.0 - truth) / 4.0;
    struct rl_metric hash = figure(&run, "series=point generator=hash samples=4", "variance");
    struct rl_metric baked =
        figure(&run, "series=point generator=baked normal_bits=float samples=4", "variance");
    check_relative(hash.value, variance, 0.05);
    check_relative(baked.value, variance, 0.05);
    check_near(figure(&run, "series=point generator=hash samples=4", "bias").value, 0.0, 0.01);
    check_near(figure(&run, "series=point generator=baked normal_bits=float samples=16", "bias").value, 0.0,
               0.01);
    /* Restarted: one value at every pixel, another for every seed. */
    assert_true(figure(&run, "series=point generator=lcg samples=4", "variance").value == 0.0);
    assert_true(figure(&run, "series=point generator=lcg samples=4", "bias_share").value == 1.0);
    assert_true(figure(&run, "series=point generator=lcg samples=1", "floor").value > 0.3);
    assert_true(figure(&run, "series=point generator=hash samples=4", "bias_share").value < 0.01);
    /* Of the pictures, the restarted one has at most the five values that four normals can make; the others are near the truth. */
    const struct rl_series *picture =
        rl_record_series(measured(&run, "series=patch generator=reference"), "picture");
    const struct rl_series *noisy =
        rl_record_series(measured(&run, "series=patch generator=baked"), "picture");
    assert_non_null(picture);
    assert_non_null(noisy);
    double sum = 0.0;
    for (size_t i = 0; i < picture->n; i++)
        sum += (noisy->value[i] - picture->value[i]) / (double)picture->n;
    check_near(sum, 0.0, 0.015); /* 3 standard deviations: 0.24/sqrt(2304) */
    rl_run_clear(&run);
}

static void every_grid_has_what_claims_need(void **state)
{
    (void)state;
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "distribution"};
        assert_int_equal(rl_study_find("distribution")->plan_alone(&run, &place, (enum rl_grid)grid, 0, NULL),
                         RL_OK);
        static const char *const needed[] = {
            "series=map normal_bits=8 rr=1",        "series=map normal_bits=16 rr=30",
            "series=map normal_bits=half rr=1000",  "series=map normal_bits=float rr=1000",
            "series=point generator=lcg samples=4", "series=point generator=hash samples=4",
            "series=patch generator=reference"};
        check_plan(&run, needed, sizeof needed / sizeof needed[0]);
        rl_run_clear(&run);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdicts_flip),          cmocka_unit_test(nothing_measured),
        cmocka_unit_test(another_rr_is_seen),     cmocka_unit_test(what_is_known_is_measured),
        cmocka_unit_test(generators_as_expected), cmocka_unit_test(every_grid_has_what_claims_need),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
