/* The study `samples`: its plan, and that its verdicts follow from the rows: other rows, other verdict. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "studies/judged.h"
#include "studies/study.h"

static const struct rl_place place = {"samples", "made-up", "made-up.yaml", 1};

/* What a made-up world is like: noise of one random normal, its fall with N, the floor with the paper's settings, the error of
 * the regular pattern at N = 13, and the floors over the environment map's size. */
struct world {
    double noise_1, slope, floor, regular_13;
    double position, texels_256; /* what the map's position does, and what 256 texels do */
    double spread;               /* half width of every interval, relative */
    double time_3, time_5;       /* frame time of 3 and 5 normals over that of 4 */
    double noise;                /* of the clock */
};

static const struct world usual = {
    .noise_1 = 0.2,
    .slope = -0.5,
    .floor = 0.01,
    .regular_13 = 0.15,
    .position = 0.01,
    .texels_256 = 0.002,
    .spread = 0.02,
    .time_3 = 0.98,
    .time_5 = 1.02,
    .noise = 0.005,
};

static void metric(struct rl_record *r, const char *name, double value, double spread)
{
    assert_int_equal(
        rl_record_metric_add(r, name, value, value * (1.0 - spread), value * (1.0 + spread), "1", NULL),
        RL_OK);
}

static void fill(struct rl_record *r, double noise, double floor, double spread)
{
    metric(r, "rmse", hypot(noise, floor), spread);
    metric(r, "noise", noise, spread);
    metric(r, "floor", floor, spread);
    metric(r, "variance", noise * noise, spread);
    metric(r, "bias2", floor * floor, spread);
    r->status = RL_RECORD_OK;
}

/* Noise, floor and error are those of R_r = 30 divided by `factor`. */
static void add_rr(struct rl_run *run, const struct world *w, double rr, double factor)
{
    static const int N[] = {1, 2, 3, 4, 5, 8, 13, 16, 32, 64, 128, 256, 512, 1024};
    for (size_t i = 0; i < sizeof N / sizeof N[0]; i++) {
        int n = N[i];
        struct rl_record *r = rl_run_add(
            run, &place, n, NULL, "series=methods setting=paper method=regular samples=%d rr=%g", n, rr);
        fill(r, 0.0, w->regular_13 * 13.0 / n / factor, 0.0);
        r = rl_run_add(run, &place, n, NULL, "series=methods setting=paper method=random samples=%d rr=%g", n,
                       rr);
        fill(r, w->noise_1 * pow(n, w->slope) / factor, w->floor / factor, w->spread);
        if (n == 3 || n == 5)
            metric(r, "time_to_random4", n == 3 ? w->time_3 : w->time_5, w->noise);
    }
}

static void make(struct rl_run *run, const struct world *w)
{
    *run = (struct rl_run){.study = "samples", .grid = "default"};
    add_rr(run, w, 3.0, 0.5);
    add_rr(run, w, 30.0, 1.0);
    add_rr(run, w, 300.0, 20.0);
    metric(rl_run_add(run, &place, 4, NULL, "series=time setting=again method=random samples=4 rr=30"),
           "time_to_random4", 1.0, w->noise);
    run->record[run->n_records - 1].status = RL_RECORD_OK;
    for (int size = 64; size <= 2048; size *= 2) {
        double texels = w->texels_256 * 256.0 / size;
        struct rl_record *r =
            rl_run_add(run, &place, 5000, NULL, "series=floor samples=1024 rr=30 env_size=%d", size);
        fill(r, 0.001, hypot(w->position, texels), w->spread);
        metric(r, "floor_centre", texels, w->spread);
        metric(r, "parallax", w->position, 0.0);
    }
}

static struct rl_claim judge(const struct rl_run *run, const char *words)
{
    return claim_of("samples", run, words);
}

static enum rl_verdict verdict_in(struct world w, const char *words)
{
    struct rl_run run;
    make(&run, &w);
    struct rl_claim c = judge(&run, words);
    rl_run_clear(&run);
    return c.verdict;
}

static void test_flips(void **state)
{
    (void)state;
    struct world w = usual;

    static const char four[] = "paper: 4 random normals a pixel suffice";
    assert_int_equal(verdict_in(w, four), RL_VERDICT_FAILS);
    w.noise_1 = 0.1; /* at R_r 300: 0.1/2/20 = 0.0025 */
    assert_int_equal(verdict_in(w, four), RL_VERDICT_HOLDS_UP_TO);
    w.noise_1 = w.floor = 0.001;
    assert_int_equal(verdict_in(w, four), RL_VERDICT_HOLDS);

    w = usual;
    static const char enough[] = "ours: some number of random normals";
    assert_int_equal(verdict_in(w, enough), RL_VERDICT_HOLDS_UP_TO); /* the floor is in the way at 3 and 30 */
    w.noise_1 = 0.05;
    w.floor = 0.0001;
    assert_int_equal(verdict_in(w, enough), RL_VERDICT_HOLDS);
    w.floor = 1.0;
    assert_int_equal(verdict_in(w, enough), RL_VERDICT_FAILS);

    w = usual;
    static const char slope[] = "falls as N^(-1/2)";
    assert_int_equal(verdict_in(w, slope), RL_VERDICT_HOLDS);
    w.slope = -0.45;
    assert_int_equal(verdict_in(w, slope), RL_VERDICT_FAILS);

    w = usual;
    static const char share[] = "most of the squared error is bias";
    assert_int_equal(verdict_in(w, share), RL_VERDICT_HOLDS); /* 0.2/32 of noise under 0.01 */
    w.floor = 0.001;
    assert_int_equal(verdict_in(w, share), RL_VERDICT_FAILS);
    w.floor = w.noise_1 / 32.0;
    assert_int_equal(verdict_in(w, share), RL_VERDICT_INCONCLUSIVE);

    /* At R_r 3 the floor is far below the noise: the central R_r does not speak for it. */
    w = usual;
    struct rl_run run;
    make(&run, &w);
    struct rl_record *rough =
        rl_run_add(&run, &place, 2048, NULL, "series=methods setting=paper method=random samples=2048 rr=3");
    fill(rough, 0.01, 0.001, 0.02);
    struct rl_claim c = judge(&run, share);
    rl_run_clear(&run);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS_UP_TO);
    assert_true(c.value == 30.0 && c.low == 3.0);

    w = usual;
    static const char regular[] = "paper: 4 random normals give no more error than 13 regular";
    assert_int_equal(verdict_in(w, regular), RL_VERDICT_HOLDS); /* 0.1 against 0.15 */
    w.regular_13 = 0.05;
    assert_int_equal(verdict_in(w, regular), RL_VERDICT_FAILS);
    w.regular_13 = hypot(0.1, 0.01);
    assert_int_equal(verdict_in(w, regular), RL_VERDICT_INCONCLUSIVE);

    w = usual;
    static const char truth[] = "nearer to the truth than 13 regular";
    assert_int_equal(verdict_in(w, truth), RL_VERDICT_HOLDS);
    w.regular_13 = 0.005;
    assert_int_equal(verdict_in(w, truth), RL_VERDICT_FAILS);

    w = usual;
    static const char position[] = "neither samples nor texels";
    assert_int_equal(verdict_in(w, position), RL_VERDICT_HOLDS);
    w.position = 0.001;
    assert_int_equal(verdict_in(w, position), RL_VERDICT_FAILS);
    w.position = 1.0 / 255.0;
    w.texels_256 = 0.0001;
    assert_int_equal(verdict_in(w, position), RL_VERDICT_INCONCLUSIVE);

    w = usual;
    static const char centre[] = "seen from the object's centre";
    assert_int_equal(verdict_in(w, centre), RL_VERDICT_HOLDS);
    w.texels_256 = 0.1;
    assert_int_equal(verdict_in(w, centre), RL_VERDICT_FAILS);

    w = usual;
    static const char texels[] = "256 texels are enough";
    assert_int_equal(verdict_in(w, texels), RL_VERDICT_HOLDS);
    w.texels_256 = 0.02;
    assert_int_equal(verdict_in(w, texels), RL_VERDICT_FAILS);
}

static void test_four_against_its_neighbours(void **state)
{
    (void)state;
    static const char best[] = "no worse a choice than 3 or 5", time[] = "hardly costs time";
    struct world w = usual; /* 5 have four fifths of the MSE in 1.02 of the time */
    assert_int_equal(verdict_in(w, best), RL_VERDICT_FAILS);
    assert_int_equal(verdict_in(w, time), RL_VERDICT_HOLDS);
    w.time_5 = 1.6;
    w.time_3 = 0.9;
    assert_int_equal(verdict_in(w, best), RL_VERDICT_HOLDS);
    assert_int_equal(verdict_in(w, time), RL_VERDICT_FAILS);
    w.time_3 = 0.4; /* now 3 are the better choice */
    assert_int_equal(verdict_in(w, best), RL_VERDICT_FAILS);
    w = usual;
    w.noise = 0.2; /* a clock that cannot tell */
    assert_int_equal(verdict_in(w, best), RL_VERDICT_INCONCLUSIVE);
    assert_int_equal(verdict_in(w, time), RL_VERDICT_INCONCLUSIVE);

    struct rl_run run;
    make(&run, &usual);
    struct rl_claim c = judge(&run, best);
    double four = 0.04 / 4.0 + 1e-4, five = 0.04 / 5.0 + 1e-4;
    assert_true(fabs(c.value - four / (five * 1.02)) < 1e-9);
    assert_true(c.low < c.value && c.value < c.high);
    rl_run_clear(&run);
}

static void test_values(void **state)
{
    (void)state;
    struct rl_run run;
    make(&run, &usual);
    struct rl_claim c = judge(&run, "falls as N^(-1/2)");
    assert_true(fabs(c.value + 0.5) < 1e-9);
    c = judge(&run, "paper: 4 random normals give no more error");
    assert_true(fabs(c.value - hypot(0.1, 0.01) / 0.15) < 1e-9);
    c = judge(&run, "256 texels are enough");
    assert_true(fabs(c.value - 0.2) < 1e-9);
    assert_true(c.low < c.value && c.value < c.high);
    assert_string_equal(c.study, "samples");
    assert_string_equal(c.command, "roughlight study run samples --scene made-up.yaml");
    c = judge(
        &run,
        "ours: some number of random normals"); /* needs sqrt(0.2^2/N + 0.01^2)/20 <= 1/255 at R_r 300 */
    assert_true(c.value == 300.0);
    rl_run_clear(&run);
}

/* Nothing measured, or only something: no verdict is made up. */
static void test_missing(void **state)
{
    (void)state;
    struct rl_run run;
    make(&run, &usual);
    check_undecided("samples", &run, 11);
    rl_run_clear(&run);
}

/* Every case is its own, random has seeds and regular has none, and what the claims need is in every grid. */
static void test_plan(void **state)
{
    (void)state;
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "samples"};
        assert_int_equal(rl_study_find("samples")->plan(&run, &place, (enum rl_grid)grid, 0, NULL), RL_OK);
        for (size_t i = 0; i < run.n_records; i++) {
            const char *parameters = run.record[i].parameters;
            bool once = rl_parameters_match(parameters, "method=regular") ||
                        rl_parameters_match(parameters, "series=time");
            assert_true(once == (rl_parameter_number(parameters, "seeds") == 1.0));
            assert_true(once || grid == RL_GRID_QUICK || rl_parameter_number(parameters, "seeds") >= 16.0);
        }
        static const char *const needed[] = {
            "series=methods setting=paper method=random samples=4 rr=30",
            "series=methods setting=paper method=random samples=4 rr=3",
            "series=methods setting=paper method=random samples=3 rr=30",
            "series=methods setting=paper method=random samples=5 rr=30",
            "series=methods setting=paper method=regular samples=13 rr=30",
            "series=time setting=none method=none rr=30",
            "series=time setting=again method=random samples=4 rr=30",
            "series=floor env_size=256",
            "series=floor env_size=512",
        };
        check_plan(&run, needed, sizeof needed / sizeof needed[0]);
        rl_run_clear(&run);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_flips),  cmocka_unit_test(test_four_against_its_neighbours),
        cmocka_unit_test(test_values), cmocka_unit_test(test_missing),
        cmocka_unit_test(test_plan),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
