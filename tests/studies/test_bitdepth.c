/* The study `bitdepth`: its models of what has no texture, its plan, and that its verdicts follow from the rows. */
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
#include "studies/bitdepth.h"
#include "studies/judged.h"
#include "studies/judging.h"
#include "studies/runner.h"

static const struct rl_place place = {"bitdepth", "made-up", "made-up.yaml", 1};
static const double rrs[] = {3.0, 30.0, 300.0};

/* A made-up world: bias grows in proportion to R_r, from these at R_r = 30; noise is the same everywhere. */
struct world {
    double bias_8, bias_10, regular_8, noise, environment_8, frame_8;
    double change_8; /* of 6 and 10 bits: 0.02 and 0.005 */
    double spread, ms_16, ms_again;
    double dark_rr; /* where no normal met a light */
};

static const struct world usual = {
    .bias_8 = 0.002,
    .bias_10 = 0.0001,
    .regular_8 = 0.02,
    .noise = 0.04,
    .environment_8 = 0.0001,
    .frame_8 = 0.001,
    .change_8 = 0.01,
    .spread = 0.05,
    .ms_16 = 1.0,
    .ms_again = 1.0,
};

static void metric(struct rl_record *r, const char *name, double value, double spread)
{
    assert_int_equal(
        rl_record_metric_add(r, name, value, value * (1.0 - spread), value * (1.0 + spread), "1", NULL),
        RL_OK);
    r->status = RL_RECORD_OK;
}

static void add_normals(struct rl_run *run, const struct world *w, const char *bits, double rr, double bias)
{
    for (int samples = 4; samples <= 16; samples *= 4) { /* at N = 4 the interval says nothing */
        struct rl_record *r = rl_run_add(run, &place, 0, NULL,
                                         "series=normals samples=%d rr=%g normal_bits=%s", samples, rr, bits);
        double spread = samples == 4 ? 1000.0 : w->spread;
        metric(r, "bias", bias * rr / 30.0, spread);
        metric(r, "bias_of_noise", bias * rr / 30.0 / w->noise, spread);
        metric(r, "noise_4", rr == w->dark_rr ? 0.0 : w->noise, w->spread);
        metric(r, "change",
               strcmp(bits, "8") ? 0.02 * pow(2.0, 0.5 * (6.0 - strtod(bits, NULL))) : w->change_8,
               w->spread);
    }
}

static void add_change(struct rl_run *run, const struct world *w, const char *what, double rr, double change)
{
    struct rl_record *r = rl_run_add(run, &place, 0, NULL, "%s rr=%g samples=4", what, rr);
    metric(r, "change", change, w->spread);
    metric(r, "change_of_noise", change / w->noise, w->spread);
    metric(r, "noise_4", rr == w->dark_rr ? 0.0 : w->noise, w->spread);
}

static void add_time(struct rl_run *run, const char *arm, double to_8)
{
    struct rl_record *r = rl_run_add(run, &place, 1, NULL, "series=time arm=%s", arm);
    metric(r, "time_to_8", to_8, 0.002);
}

static void make(struct rl_run *run, const struct world *w)
{
    *run = (struct rl_run){.study = "bitdepth", .grid = "default"};
    for (size_t i = 0; i < sizeof rrs / sizeof rrs[0]; i++) {
        add_normals(run, w, "6", rrs[i], w->bias_8);
        add_normals(run, w, "8", rrs[i], w->bias_8);
        add_normals(run, w, "10", rrs[i], w->bias_10);
        add_change(run, w, "series=regular normal_bits=8", rrs[i], w->regular_8);
        add_change(run, w, "series=environment env_format=rgba8", rrs[i], w->environment_8);
        add_change(run, w, "series=frame frame_format=rgba8", rrs[i], w->frame_8);
    }
    add_time(run, "8", 1.0);
    add_time(run, "8-again", w->ms_again);
    add_time(run, "16", w->ms_16);
}

static struct rl_claim claim_in(struct world w, const char *words)
{
    struct rl_run run;
    make(&run, &w);
    struct rl_claim found = claim_of("bitdepth", &run, words);
    rl_run_clear(&run);
    return found;
}

#define VERDICT(w, words) ((int)claim_in(w, words).verdict)

static void verdicts_follow_from_rows(void **state)
{
    (void)state;
    struct world w = usual;
    static const char rounding[] = "8 bits are 8 bits";
    assert_int_equal(VERDICT(w, rounding), RL_VERDICT_HOLDS);
    assert_true(fabs(claim_in(w, rounding).value - 1.0) < 1e-9);
    w.change_8 = 0.016;
    assert_int_equal(VERDICT(w, rounding), RL_VERDICT_FAILS);
    w = usual;
    static const char eight[] = "paper: 8 bits (a step", ten[] = "ours: 10 bits make";
    assert_int_equal(VERDICT(w, eight), RL_VERDICT_HOLDS_UP_TO); /* 0.02 at R_r = 300 */
    assert_true(claim_in(w, eight).value == 30.0 && claim_in(w, eight).high == 300.0);
    assert_int_equal(VERDICT(w, ten), RL_VERDICT_HOLDS);
    w.bias_8 = 0.0001;
    assert_int_equal(VERDICT(w, eight), RL_VERDICT_HOLDS);
    w.noise = 0.001; /* below 1/255 still, but 0.1 of the noise at R_r = 30 */
    assert_int_equal(VERDICT(w, eight), RL_VERDICT_HOLDS_UP_TO);
    assert_true(claim_in(w, eight).value == 3.0);
    w.noise = 1.0; /* a hundredth of the noise, but above 1/255 */
    w.bias_8 = 0.01;
    assert_true(claim_in(w, eight).value == 3.0);
    w.bias_8 = 1.0;
    assert_int_equal(VERDICT(w, eight), RL_VERDICT_FAILS);
    assert_true(fabs(claim_in(w, eight).value - 255.0) <
                1e-9); /* what decides: 1 over 1/255, not 1 over 0.1 */
    w = usual;
    w.spread = 1000.0;
    assert_int_equal(VERDICT(w, eight), RL_VERDICT_INCONCLUSIVE);

    /* What is stored as it is proves nothing of other values: the note says so. */
    static const char map[] = "an environment map of 8 bits is enough";
    w = usual;
    assert_null(strstr(claim_in(w, map).note, rl_judging_exactly));
    w.environment_8 = 0.0;
    assert_int_equal(VERDICT(w, map), RL_VERDICT_HOLDS);
    assert_non_null(strstr(claim_in(w, map).note, rl_judging_exactly));

    /* Beside no noise nothing is said, be the bias below 1/255 or not. */
    w = usual;
    w.noise = NAN;
    assert_int_equal(VERDICT(w, eight), RL_VERDICT_INCONCLUSIVE);
    assert_true(isnan(claim_in(w, eight).value));

    w = usual;
    static const char pattern[] = "13 regular normals rounded to 8 bits",
                      less[] = "8 bits harm random normals less";
    assert_int_equal(VERDICT(w, pattern), RL_VERDICT_FAILS);
    assert_int_equal(VERDICT(w, less), RL_VERDICT_HOLDS_UP_TO); /* as much at R_r = 300 */
    assert_true(claim_in(w, less).value == 30.0 && claim_in(w, less).high == INFINITY);
    w.regular_8 = 0.01;
    assert_int_equal(VERDICT(w, less), RL_VERDICT_HOLDS_UP_TO);
    w.regular_8 = 0.0001;
    assert_int_equal(VERDICT(w, pattern), RL_VERDICT_HOLDS);
    assert_int_equal(VERDICT(w, less), RL_VERDICT_FAILS);

    w = usual;
    static const char environment[] = "environment map of 8 bits", buffer[] = "frame buffer of 8 bits";
    assert_int_equal(VERDICT(w, environment), RL_VERDICT_HOLDS);
    assert_int_equal(VERDICT(w, buffer), RL_VERDICT_HOLDS);
    w.environment_8 = w.frame_8 = 0.006;
    assert_int_equal(VERDICT(w, environment), RL_VERDICT_FAILS);
    assert_int_equal(VERDICT(w, buffer), RL_VERDICT_FAILS);

    w = usual;
    static const char time[] = "normal maps of 16 bits cost at most 5 %";
    assert_int_equal(VERDICT(w, time), RL_VERDICT_HOLDS);
    w.ms_16 = 1.2;
    assert_int_equal(VERDICT(w, time), RL_VERDICT_FAILS);
    w.ms_16 = 1.04; /* below 1.05, but by less than two arms of the same work differ */
    w.ms_again = 1.03;
    assert_int_equal(VERDICT(w, time), RL_VERDICT_INCONCLUSIVE);
    w.ms_16 = 1.0;
    w.ms_again = 1.1; /* the clock cannot tell */
    assert_int_equal(VERDICT(w, time), RL_VERDICT_INCONCLUSIVE);
    assert_int_equal(VERDICT(w, "normal maps of 10 bits cost"), RL_VERDICT_INCONCLUSIVE); /* not measured */
}

/* Where no normal met a light a change of 0 says nothing, and where all is dark there is no verdict. */
static void darkness_holds_nothing(void **state)
{
    (void)state;
    struct world w = usual;
    w.bias_8 = 0.0;
    static const char below[] = "the bias of 8-bit normals is below",
                      less[] = "8 bits harm random normals less";
    struct rl_claim c = claim_in(w, below);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_null(strstr(c.note, rl_judging_exactly)); /* it is no format that holds radiances */
    w.dark_rr = 300.0;
    c = claim_in(w, below);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS_UP_TO);
    assert_true(c.value == 30.0);
    assert_non_null(strstr(c.note, "not judged, for no normal met a light: R_r 300"));
    assert_int_equal(VERDICT(w, less), RL_VERDICT_HOLDS_UP_TO);

    struct rl_run run = {.study = "bitdepth", .grid = "default"};
    w.noise = w.environment_8 = w.frame_8 = w.regular_8 = 0.0;
    w.dark_rr = 30.0;
    add_normals(&run, &w, "8", 30.0, 0.0);
    add_change(&run, &w, "series=regular normal_bits=8", 30.0, 0.0);
    add_change(&run, &w, "series=frame frame_format=rgba8", 30.0, 0.0);
    static const char *const words[] = {below, "13 regular normals rounded to 8 bits",
                                        "frame buffer of 8 bits"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        c = claim_of("bitdepth", &run, words[i]);
        assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
        assert_true(isnan(c.value));
        assert_string_equal(c.note, "not judged, for no normal met a light: R_r 30");
    }
    rl_run_clear(&run);
}

static void every_grid_has_what_the_claims_need(void **state)
{
    (void)state;
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "bitdepth"};
        assert_int_equal(rl_study_find("bitdepth")->plan(&run, &place, (enum rl_grid)grid, 0, NULL), RL_OK);
        char group[RL_NAME_MAX] = "";
        for (size_t i = 0; i < run.n_records; i++) {
            /* The first of each series in a group is the one of full precision. */
            char series[RL_NAME_MAX];
            const char *parameters = run.record[i].parameters;
            rl_parameter(parameters, "series", series, sizeof series);
            if (strcmp(series, group) != 0 && strcmp(series, "time") != 0)
                assert_true(rl_parameters_match(parameters, "normal_bits=float") &&
                            rl_parameters_match(parameters, "frame_format=rgba32f") &&
                            (strcmp(series, "environment") != 0 ||
                             rl_parameters_match(parameters, "env_format=rgba32f")));
            snprintf(group, sizeof group, "%s", series);
        }
        static const char *const needed[] = {
            "series=normals samples=4 normal_bits=8",
            "series=regular samples=13 normal_bits=8",
            "series=environment env_format=rgba8",
            "series=frame frame_format=rgba8",
            "series=time arm=8-again",
            "series=time arm=16",
            "series=time arm=none method=none",
        };
        check_plan(&run, needed, sizeof needed / sizeof needed[0]);
        rl_run_clear(&run);
    }
}

/* Two passes, each rounded; by hand. */
static void frame_buffers_round_twice(void **state)
{
    (void)state;
    static const struct {
        enum rl_texel_format format;
        float surface, exact, rounded, clamped;
    } rows[] = {
        /* 0.3/255 becomes 0, and 0.3/255 + 0.3/255 = 0.6/255 of highlight on it do not make a step of it */
        {RL_TEXEL_RGBA8, 0.3f / 255, 0.6f / 255, 0.0f, 0.6f / 255},
        {RL_TEXEL_RGBA8, 0.0f, 0.6f / 255, 1.0f / 255, 0.6f / 255},
        {RL_TEXEL_RGBA8, 0.6f / 255, 1.2f / 255, 2.0f / 255, 1.2f / 255},
        {RL_TEXEL_RGBA8, 0.0f, 1.5f, 1.0f, 1.0f},
        {RL_TEXEL_RGB10A2, 0.0f, 0.6f / 1023, 1.0f / 1023, 0.6f / 1023},
        {RL_TEXEL_RGBA16, 0.0f, 0.6f / 65535, 1.0f / 65535, 0.6f / 65535},
        {RL_TEXEL_RGBA16F, 0.0f, 1.5f + 0.0004f, 1.5f, 1.5f + 0.0004f}, /* a step of 1/1024 */
        {RL_TEXEL_RGBA16F, 0.0f, 1.5f + 0.0006f, 1.5f + 1.0f / 1024, 1.5f + 0.0006f},
        {RL_TEXEL_R11G11B10F, 0.0f, 1.0f + 0.01f, 1.0f + 1.0f / 64, 1.0f + 0.01f}, /* a step of 1/64 */
        {RL_TEXEL_RGBA32F, 0.1f, 1.3f, 1.3f, 1.3f},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_image surface = {0};
        struct rl_seeds exact = {.n = 1}, rounded = {0}, clamped = {0};
        double share;
        assert_int_equal(rl_image_allocate(&surface, 1, 1, 4, NULL), RL_OK);
        assert_int_equal(rl_image_allocate(&exact.image[0], 1, 1, 4, NULL), RL_OK);
        surface.data[0] = rows[i].surface;
        exact.image[0].data[0] = rows[i].exact;
        exact.image[0].data[3] = 1.0f;
        assert_int_equal(
            rl_bitdepth_frames(&rounded, &clamped, &share, &exact, &surface, rows[i].format, NULL), RL_OK);
        assert_true(fabsf(rounded.image[0].data[0] - rows[i].rounded) < 2e-7f);
        assert_true(fabsf(clamped.image[0].data[0] - rows[i].clamped) < 2e-7f);
        assert_true(rounded.image[0].data[3] == 1.0f);
        assert_true(fabs(share - (rows[i].clamped < rows[i].exact ? 1.0 / 3.0 : 0.0)) < 1e-12);
        rl_seeds_clear(&exact);
        rl_seeds_clear(&rounded);
        rl_seeds_clear(&clamped);
        rl_image_clear(&surface);
    }
}

static double value_of(const struct rl_run *run, const char *pattern, const char *name)
{
    const struct rl_record *r = rl_run_find(run, NULL, pattern);
    assert_non_null(r);
    assert_non_null(rl_record_metric(r, name));
    return rl_record_metric(r, name)->value;
}

/* One group of the quick grid, R_r = 10: fewer bits, more change; full precision, none; frame buffers lose what rounding must. */
static void measured_figures_obey_their_order(void **state)
{
    (void)state;
    struct rl_bench bench;
    struct rl_scene scene;
    struct rl_error error = {0};
    struct rl_progress quiet = {0};
    assert_int_equal(rl_bench_open(&bench, "auto", 0, "", &quiet, &error), RL_OK);
    assert_int_equal(rl_study_scene_load(&scene, "sphere-quad", &error), RL_OK);
    struct rl_run run = {.study = "bitdepth"};
    const struct rl_study *study = rl_study_find("bitdepth");
    assert_int_equal(study->plan(&run, &place, RL_GRID_QUICK, 0, &error), RL_OK);
    size_t n = 0;
    while (n < run.n_records && run.record[n].group == 0)
        n++;
    if (study->measure(run.record, n, &bench, &scene, &error) != RL_OK)
        fail_msg("%s", error.message);
    for (size_t i = 0; i < n; i++)
        run.record[i].status = RL_RECORD_OK;
    static const char *const full[] = {"series=normals normal_bits=float", "series=regular normal_bits=float",
                                       "series=environment env_format=rgba32f",
                                       "series=frame frame_format=rgba32f"};
    for (size_t i = 0; i < 4; i++)
        assert_true(value_of(&run, full[i], "change") == 0.0);
    static const char *const bits[] = {"4", "6", "8", "10", "16"};
    for (int regular = 0; regular < 2; regular++) {
        double before = INFINITY;
        for (size_t i = 0; i < 5; i++) {
            char pattern[64];
            snprintf(pattern, sizeof pattern, "series=%s normal_bits=%s", regular ? "regular" : "normals",
                     bits[i]);
            double change = value_of(&run, pattern, "change");
            assert_true(change < before);
            before = change;
        }
    }
    assert_true(value_of(&run, "series=normals normal_bits=4", "bias") > 0.01);
    assert_true(value_of(&run, "series=normals normal_bits=8", "bias_of_noise") < 0.2);
    /* Two roundings of a uniform error of 1/255: 1/255/sqrt(6) where both passes write, less where only one does. */
    double frame = value_of(&run, "series=frame frame_format=rgba8", "change") * 255.0;
    assert_true(frame > 0.2 && frame < 1.0 / sqrt(6.0) + 0.05);
    rl_run_clear(&run);
    rl_scene_clear(&scene);
    rl_bench_close(&bench);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdicts_follow_from_rows),           cmocka_unit_test(darkness_holds_nothing),
        cmocka_unit_test(every_grid_has_what_the_claims_need), cmocka_unit_test(frame_buffers_round_twice),
        cmocka_unit_test(measured_figures_obey_their_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
