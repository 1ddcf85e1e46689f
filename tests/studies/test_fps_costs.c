/* The study `fps`: its cost models find again what made-up frame times are made of, and the verdicts follow from them; what chance
 * explains decides nothing. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "model/random.h"
#include "studies/fps.h"
#include "studies/judged.h"
#include "support/check.h"

static const struct rl_place place = {"fps", "made-up", "made-up.yaml", 1};

/* What the cases of all series take, in ms: made of these. */
struct prices {
    double frame, per_pixel, plain;                  /* without highlight; what plain adds to every frame */
    double pass, per_drawn, per_sample, per_regular; /* the highlight */
    double map, per_texel, lookup;                   /* lookup: slower by this part with the largest map */
    double per_object, highlight_object, per_map;
    double per_roughness, bake;
    double start, cpu_pixel, per_texel_normal;
    double crooked;       /* the largest case of each series takes this many times as long */
    double again, jitter; /* how far two equal arms differ; single frames */
};

static const struct prices usual_prices = {.frame = 1.0,
                                           .per_pixel = 5e-6,
                                           .plain = 0.2,
                                           .pass = 0.5,
                                           .per_drawn = 1e-5,
                                           .per_sample = 2e-5,
                                           .per_regular = 1e-5,
                                           .map = 0.1,
                                           .per_texel = 1e-6,
                                           .per_object = 0.5,
                                           .highlight_object = 0.5,
                                           .per_map = 0.4,
                                           .bake = 20.0,
                                           .start = 20.0,
                                           .cpu_pixel = 1e-4,
                                           .per_texel_normal = 1e-6,
                                           .crooked = 1.0,
                                           .again = 1.0,
                                           .jitter = 0.002};

/* A third of the picture has a highlight. */
static double drawn(const struct rl_record *r)
{
    return floor(rl_parameter_number(r->parameters, "width") * rl_parameter_number(r->parameters, "height") /
                 3.0);
}

static bool is(const struct rl_record *r, const char *pattern)
{
    return rl_parameters_match(r->parameters, pattern);
}

static double ms_of(const struct rl_record *r, const struct prices *p)
{
    const char *q = r->parameters;
    double pixels = rl_parameter_number(q, "width") * rl_parameter_number(q, "height");
    double edge = rl_parameter_number(q, "env_size"), samples = rl_parameter_number(q, "samples");
    double objects = rl_parameter_number(q, "objects"), roughnesses = rl_parameter_number(q, "roughnesses");
    double none = p->frame + p->per_pixel * pixels + (objects > 1.0 ? p->per_object * (objects - 1.0) : 0.0);
    double highlight = p->per_drawn * drawn(r) +
                       (is(r, "method=regular") ? p->per_regular : p->per_sample) * drawn(r) * samples;
    /* The objects' model has no constant: with objects their price takes its place. */
    highlight += objects >= 1.0 ? p->highlight_object * objects - p->per_drawn * drawn(r) : p->pass;
    if (is(r, "arm=none"))
        return none;
    if (is(r, "arm=plain"))
        return none + p->plain + 0.2 * p->per_pixel * pixels;
    if (is(r, "arm=environment"))
        return p->map + p->per_texel * 6.0 * edge * edge + (objects >= 1.0 ? p->per_map * objects : 0.0);
    if (is(r, "arm=normal-maps"))
        return 1.0 + p->bake * roughnesses;
    if (is(r, "arm=exhaustive"))
        return p->start + p->cpu_pixel * drawn(r) + p->per_texel_normal * drawn(r) * edge * edge;
    double ms = none + highlight + (roughnesses >= 1.0 ? p->per_roughness * roughnesses : 0.0);
    return ms * (is(r, "arm=random-4-again") ? p->again : 1.0) *
           (is(r, "series=environment env_size=1024") ? 1.0 + p->lookup : 1.0);
}

/* The largest of what makes a case large, in its series. */
static bool is_largest(const struct rl_record *r)
{
    return is(r, "series=size width=1920") || is(r, "series=environment env_size=1024") ||
           is(r, "series=objects objects=6") || is(r, "series=roughness roughnesses=4") ||
           is(r, "series=maps roughnesses=4") || is(r, "series=exhaustive env_size=256 width=160");
}

static void add_number(struct rl_record *r, const char *name, double value, const char *unit)
{
    assert_int_equal(rl_record_metric_add(r, name, value, value, value, unit, NULL), RL_OK);
}

/* Measures the default grid's cases as the prices have it. */
static void measure_made_up(struct rl_run *run, const struct prices *p)
{
    enum { FRAMES = 20 };
    double ms[FRAMES];
    assert_int_equal(rl_study_find("fps")->plan(run, &place, RL_GRID_DEFAULT, 0, NULL), RL_OK);
    for (size_t i = 0; i < run->n_records; i++) {
        struct rl_record *r = &run->record[i];
        r->status = RL_RECORD_OK;
        double exact = ms_of(r, p) * (is_largest(r) ? p->crooked : 1.0);
        for (uint64_t k = 0; k < FRAMES; k++)
            ms[k] = exact * (1.0 + p->jitter * (2.0 * rl_random_uniform(5, 1000 * i + k) - 1.0));
        assert_int_equal(rl_record_series_add(r, "frame_ms", ms, FRAMES, NULL), RL_OK);
        double low = exact * (1.0 - p->jitter), high = exact * (1.0 + p->jitter);
        assert_int_equal(rl_record_metric_add(r, "frame_ms", exact, low, high, "ms", NULL), RL_OK);
        assert_int_equal(
            rl_record_metric_add(r, "fps", 1000.0 / exact, 1000.0 / high, 1000.0 / low, "1/s", NULL), RL_OK);
        add_number(r, "time_precision", p->jitter, "1");
        add_number(r, "time_capped", is(r, "arm=plain"), "1");
        add_number(r, "drawn_px", drawn(r), "px");
        double objects = rl_parameter_number(r->parameters, "objects");
        add_number(r, "env_maps", objects >= 1.0 ? objects : 1.0, "1");
        double edge = rl_parameter_number(r->parameters, "env_size");
        if (is(r, "arm=exhaustive"))
            add_number(r, "texel_normals", drawn(r) * edge * edge, "1");
        if (is(r, "arm=random-4-again"))
            assert_int_equal(rl_record_metric_add(r, "time_to_random4", p->again, p->again - p->jitter,
                                                  p->again + p->jitter, "1", NULL),
                             RL_OK);
    }
}

static struct rl_claim priced(struct prices p, const char *words)
{
    struct rl_run run = {.study = "fps", .grid = "default"};
    measure_made_up(&run, &p);
    struct rl_claim c = claim_of("fps", &run, words);
    rl_run_clear(&run);
    return c;
}

/* Every model finds the prices again, within its interval. */
static void test_models(void **state)
{
    (void)state;
    static const struct {
        const char *model, *metric;
        double value;
    } row[] = {{"none", "constant_ms", 1.0},
               {"none", "per_pixel_ns", 5.0},
               {"random-pixels", "constant_ms", 0.5},
               {"random-pixels", "per_drawn_pixel_ns", 10.0},
               {"random-pixels", "per_sample_ns", 20.0},
               {"regular-pixels", "per_sample_ns", 10.0},
               {"environment-pass", "constant_ms", 0.1},
               {"environment-pass", "per_texel_ns", 1.0},
               {"objects-none", "per_object_us", 500.0},
               {"objects-frame", "per_object_us", 500.0},
               {"objects-frame", "per_sample_ns", 20.0},
               {"objects-pass", "per_object_us", 400.0},
               {"roughness-frame", "per_roughness_us", 0.0},
               {"maps", "per_roughness_us", 2e4},
               {"exhaustive", "constant_ms", 20.0},
               {"exhaustive", "per_drawn_pixel_ns", 100.0},
               {"exhaustive", "per_texel_normal_ns", 1.0}};
    struct prices p = usual_prices;
    struct rl_run run = {.study = "fps", .grid = "default"}, models;
    measure_made_up(&run, &p);
    assert_int_equal(rl_fps_derive(&models, &run, NULL), RL_OK);
    assert_int_equal(models.n_records, 15);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        char pattern[64];
        snprintf(pattern, sizeof pattern, "model=%s", row[i].model);
        const struct rl_metric *m = rl_record_metric(rl_run_find(&models, NULL, pattern), row[i].metric);
        assert_non_null(m);
        double width = m->high - m->low;
        if (row[i].value < m->low - 0.5 * width || row[i].value > m->high + 0.5 * width || !(width > 0.0))
            fail_msg("%s %s: %g in [%g, %g], expected %g", row[i].model, row[i].metric, m->value, m->low,
                     m->high, row[i].value);
    }
    /* Without its baseline a model of what is added has no points left, and no figures. */
    for (size_t i = 0; i < run.n_records; i++)
        if (is(&run.record[i], "series=size arm=none"))
            run.record[i].status = RL_RECORD_FAILED;
    rl_run_clear(&models);
    assert_int_equal(rl_fps_derive(&models, &run, NULL), RL_OK);
    const struct rl_record *r = rl_run_find(&models, NULL, "model=random");
    check_near(rl_record_metric(r, "points")->value, 0.0, 0.0);
    assert_null(rl_record_metric(r, "constant_ms"));
    rl_run_clear(&models);
    rl_run_clear(&run);
}

static void test_costs_flip(void **state)
{
    (void)state;
    static const char *const fits[] = {"the frame without highlight takes a + b x pixels",
                                       "random adds to it is a + b x pixels + c x",
                                       "regular adds to it is a + b x pixels + c x",
                                       "drawing an environment map takes a + b x texels",
                                       "drawing the environment maps takes a + b x objects",
                                       "baking normal maps takes a + b x roughnesses",
                                       "exhaustive takes a + b x pixels + c x texel-normals"};
    struct prices p = usual_prices;
    for (size_t i = 0; i < sizeof fits / sizeof fits[0]; i++) {
        struct rl_claim c = priced(p, fits[i]);
        if (c.verdict != RL_VERDICT_HOLDS || c.low > c.value || c.value > c.high || !strstr(c.note, "R^2"))
            fail_msg("%s: %s, %g [%g, %g], %s", fits[i], rl_verdict_name(c.verdict), c.value, c.low, c.high,
                     c.note);
    }
    /* Where pixels cost beside their samples, the paper's simpler model cannot describe both. */
    p.per_drawn = 1e-4;
    assert_int_equal(priced(p, "random adds to it is a + b x pixels x samples").verdict, RL_VERDICT_FAILS);
    p = usual_prices;
    p.per_drawn = 0.0;
    assert_int_equal(priced(p, "random adds to it is a + b x pixels x samples").verdict, RL_VERDICT_HOLDS);
    /* A bend within what equal arms differ by is no fault of the model; beyond it is. */
    p = usual_prices;
    p.crooked = 1.6;
    assert_int_equal(priced(p, "drawing an environment map takes").verdict, RL_VERDICT_FAILS);
    assert_int_equal(priced(p, "maps takes a + b x objects").verdict, RL_VERDICT_FAILS);
    p.again = 1.3;
    assert_int_equal(priced(p, "maps takes a + b x objects").verdict, RL_VERDICT_INCONCLUSIVE);
}

/* A claim without a number says why it has none. */
static void test_refused(void **state)
{
    (void)state;
    static const char plain[] = "what plain adds to it is a + b x pixels";
    struct prices p = usual_prices;
    struct rl_claim c = priced(p, plain);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_non_null(strstr(c.note, "20 frames or more, a cap came before 2 % in 3 of 3 cases"));
    p.plain = -0.5; /* faster than the frame without it, at the smallest size: noise, on a real machine */
    c = priced(p, plain);
    assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
    assert_true(isnan(c.value));
    assert_non_null(strstr(c.note, "no fit of plain: a median of -0.42"));
    assert_non_null(strstr(c.note, "not above 0, at width 320"));
    struct rl_run run = {.study = "fps", .grid = "default"};
    measure_made_up(&run, &usual_prices);
    for (size_t i = 0; i < run.n_records; i++)
        if (is(&run.record[i], "series=maps roughnesses=4"))
            run.record[i].status = RL_RECORD_FAILED;
    c = claim_of("fps", &run, "baking normal maps takes");
    assert_non_null(strstr(c.note, "2 cases are no more than it has terms"));
    rl_run_clear(&run);
}

static void test_prices_flip(void **state)
{
    (void)state;
    static const char pattern_normal[] = "a normal of the fixed pattern costs no more";
    struct prices p = usual_prices;
    struct rl_claim c = priced(p, pattern_normal);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_true(c.low <= 0.5 && 0.5 <= c.high);
    p.per_regular = 4e-5;
    assert_int_equal(priced(p, pattern_normal).verdict, RL_VERDICT_FAILS);
    p.again = 3.0;
    assert_int_equal(priced(p, pattern_normal).verdict, RL_VERDICT_INCONCLUSIVE);

    /* 320x240: 1.4 + 0.76 ms without sizes; the largest is 11.4 + 67 ms. */
    static const char reach[] = "random 4 keeps to 24 frames/s";
    p = usual_prices;
    c = priced(p, reach);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS_UP_TO);
    assert_true(c.value == 640.0 * 480.0 && c.high == 1920.0 * 1080.0);
    p.per_sample = 1e-6;
    c = priced(p, reach);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS); /* at all: the rate of the largest, with its interval */
    assert_string_equal(c.unit, "frames/s");
    assert_true(c.value > 24.0 && c.low < c.value && c.value < c.high);
    p.frame = 50.0;
    assert_int_equal(priced(p, reach).verdict, RL_VERDICT_FAILS);
    p.frame = 40.5; /* 320x240 takes a frame of 24 a second, nearly */
    p.jitter = 0.05;
    assert_int_equal(priced(p, reach).verdict, RL_VERDICT_INCONCLUSIVE);
    assert_string_equal(priced(p, reach).unit, "frames/s");
    /* 640x480 for certain, 1920x1080 perhaps. */
    p = usual_prices;
    p.per_sample = 0.0;
    p.frame = 41.66 - p.per_pixel * 1920 * 1080 - p.pass - p.per_drawn * 1920 * 360;
    c = priced(p, reach);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS_UP_TO);
    assert_true(c.value == 640.0 * 480.0 && c.low == c.value && c.high == INFINITY);

    static const char lookup[] = "the largest environment map measured";
    p = usual_prices;
    assert_int_equal(priced(p, lookup).verdict, RL_VERDICT_HOLDS);
    p.lookup = 0.2;
    assert_int_equal(priced(p, lookup).verdict, RL_VERDICT_FAILS);
    p.again = 1.2;
    assert_int_equal(priced(p, lookup).verdict, RL_VERDICT_INCONCLUSIVE);

    static const char object[] = "ours: an object more";
    p = usual_prices;
    assert_int_equal(priced(p, object).verdict, RL_VERDICT_HOLDS);
    p.highlight_object = 1.5;
    assert_int_equal(priced(p, object).verdict, RL_VERDICT_FAILS);
    assert_int_equal(priced(usual_prices, "every object has an environment map").verdict, RL_VERDICT_HOLDS);

    static const char roughness[] = "ours: one more roughness adds";
    p = usual_prices;
    c = priced(p, roughness);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_true(fabs(c.value) < 0.01);
    p.per_roughness = 0.5;
    assert_int_equal(priced(p, roughness).verdict, RL_VERDICT_FAILS);
    assert_int_equal(priced(p, "one more roughness, with bounding spheres").verdict, RL_VERDICT_FAILS);

    static const char baking[] = "normal map of one more roughness is made";
    p = usual_prices;
    assert_int_equal(priced(p, baking).verdict, RL_VERDICT_HOLDS);
    p.bake = 50.0;
    assert_int_equal(priced(p, baking).verdict, RL_VERDICT_FAILS);

    /* 102400 pixels, times 65536 texels at 1 ns, 100 ns a pixel, and 20 ms. */
    static const char extrapolated[] = "by its model, not measured";
    p = usual_prices;
    c = priced(p, extrapolated);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_string_equal(c.unit, "s, extrapolated");
    check_relative(c.value, 0.020 + 102400 * 1e-7 + 102400 * 65536e-9, 0.02);
    p.per_texel_normal *= -0.01; /* hardly seen where it was measured */
    c = priced(p, extrapolated);
    assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
    assert_true(isnan(c.value));
    assert_non_null(strstr(c.note, "left out"));
    p.start = p.per_texel_normal = p.cpu_pixel = 1e-9;
    assert_int_equal(priced(p, extrapolated).verdict, RL_VERDICT_FAILS);
    p = usual_prices;
    assert_int_equal(priced(p, "exhaustive takes more than 1/24 s a frame even").verdict, RL_VERDICT_HOLDS);
    p.start = 1e-9;
    p.per_texel_normal = 1e-12;
    assert_int_equal(priced(p, "exhaustive takes more than 1/24 s a frame even").verdict, RL_VERDICT_FAILS);

    static const char precise[] = "ours: the clock is precise";
    assert_int_equal(priced(usual_prices, precise).verdict, RL_VERDICT_HOLDS);
    p = usual_prices;
    p.jitter = 0.03;
    assert_int_equal(priced(p, precise).verdict, RL_VERDICT_FAILS);
}

static size_t cases_of(const struct rl_run *run, const char *pattern)
{
    size_t n = 0;
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, NULL, pattern));)
        n++;
    return n;
}

/* A claim comes from the cases that its model was fitted to, and not from those of others. */
static void test_cases(void **state)
{
    (void)state;
    static const struct {
        const char *words, *pattern[2];
    } rows[] = {
        {"the frame without highlight takes a + b x pixels", {"series=size arm=none"}},
        {"plain adds to it is a + b x pixels", {"series=size arm=plain", "series=size arm=none"}},
        {"baking normal maps takes a + b x roughnesses", {"series=maps arm=normal-maps"}},
        {"drawing the environment maps takes a + b x objects", {"series=objects arm=environment"}},
        {"exhaustive takes a + b x pixels + c x texel-normals", {"series=exhaustive arm=exhaustive"}},
        {"normal map of one more roughness is made", {"series=maps arm=normal-maps"}},
        {"drawing the environment map anew costs less",
         {"series=table1 arm=environment", "series=table1 arm=random-4"}},
    };
    struct rl_run run = {.study = "fps", .grid = "default"};
    measure_made_up(&run, &usual_prices);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        size_t expected = cases_of(&run, rows[i].pattern[0]),
               found = claim_of("fps", &run, rows[i].words).n_cases;
        if (rows[i].pattern[1])
            expected += cases_of(&run, rows[i].pattern[1]);
        /* What two equal arms differ by was read for all of the scene's claims. */
        expected += cases_of(&run, "series=table1 arm=random-4-again");
        expected += strstr(rows[i].words, "anew") ? 0 : cases_of(&run, "series=table1 arm=random-4");
        if (found != expected)
            fail_msg("'%s' comes from %zu cases, expected %zu", rows[i].words, found, expected);
    }
    rl_run_clear(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_models),      cmocka_unit_test(test_costs_flip), cmocka_unit_test(test_refused),
        cmocka_unit_test(test_prices_flip), cmocka_unit_test(test_cases),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
