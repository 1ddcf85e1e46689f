/* The study `budget`: its plan, and that its verdicts follow from the rows: other rows, other verdict. */
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

static const struct rl_place place = {"budget", "made-up", "made-up.yaml", 1};

/* Squared errors of a made-up world, all of a relative spread of 1 %. */
struct world {
    double sampling, parallax, normals, frame, interaction;
};

static const struct world usual = {1.0, 0.2, 0.001, 0.005, 0.01};

static void add(struct rl_run *run, const char *arm, double rr, double mse, double sum)
{
    struct rl_record *r = rl_run_add(run, &place, 0, NULL, "arm=%s rr=%g", arm, rr);
    const struct {
        const char *name;
        double value;
    } metric[] = {{"mse", mse}, {"rmse", sqrt(mse)}, {"share", mse / sum}};
    for (int i = 0; i < 3; i++)
        assert_int_equal(rl_record_metric_add(r, metric[i].name, metric[i].value, 0.99 * metric[i].value,
                                              1.01 * metric[i].value, "1", NULL),
                         RL_OK);
    r->status = RL_RECORD_OK;
}

static struct rl_claim judge(struct world w, const char *words)
{
    struct rl_run run = {.study = "budget", .grid = "default"};
    double sum = w.sampling + w.parallax + w.normals + w.frame;
    add(&run, "sampling", 30.0, w.sampling, sum);
    add(&run, "parallax", 30.0, w.parallax, sum);
    add(&run, "normals", 30.0, w.normals, sum);
    add(&run, "frame", 30.0, w.frame, sum);
    add(&run, "all", 30.0, sum, sum);
    assert_int_equal(rl_record_metric_add(&run.record[4], "interaction_share", w.interaction,
                                          w.interaction - 0.01, w.interaction + 0.01, "1", NULL),
                     RL_OK);
    struct rl_claim found = claim_of("budget", &run, words);
    rl_run_clear(&run);
    return found;
}

static void test_flips(void **state)
{
    (void)state;
    static const char first[] = "one approximation dominates";
    struct world w = usual;
    struct rl_claim c = judge(w, first);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_true(fabs(c.value - 5.0) < 1e-9);
    assert_non_null(strstr(c.note, "sampling"));
    w.parallax = 0.9;
    assert_int_equal(judge(w, first).verdict, RL_VERDICT_FAILS);
    w.parallax = 3.0;
    c = judge(w, first);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_non_null(strstr(c.note, "parallax, MSE 3"));

    static const char most[] = "4 normals a pixel make most";
    assert_int_equal(judge(usual, most).verdict, RL_VERDICT_HOLDS);
    assert_int_equal(judge(w, most).verdict, RL_VERDICT_FAILS);

    static const char second[] = "single position (parallax) is the largest";
    w = usual;
    assert_int_equal(judge(w, second).verdict, RL_VERDICT_HOLDS);
    w.frame = 0.5;
    assert_int_equal(judge(w, second).verdict, RL_VERDICT_FAILS);

    static const char normals[] = "8-bit normals make almost no difference";
    w = usual;
    assert_int_equal(judge(w, normals).verdict, RL_VERDICT_HOLDS);
    w.normals = 0.1;
    assert_int_equal(judge(w, normals).verdict, RL_VERDICT_FAILS);

    static const char frame[] = "tangent frame as printed";
    w = usual;
    assert_int_equal(judge(w, frame).verdict, RL_VERDICT_HOLDS);
    w.frame = 0.1;
    assert_int_equal(judge(w, frame).verdict, RL_VERDICT_FAILS);

    static const char rest[] = "interaction left over";
    w = usual;
    assert_int_equal(judge(w, rest).verdict, RL_VERDICT_HOLDS);
    w.interaction = -0.3;
    assert_int_equal(judge(w, rest).verdict, RL_VERDICT_FAILS);
    w.interaction = 0.1;
    assert_int_equal(judge(w, rest).verdict, RL_VERDICT_INCONCLUSIVE);
}

/* Nothing measured: no verdict is made up; and every grid has every arm at R_r 30, each departing from the base in what it says. */
static void test_plan(void **state)
{
    (void)state;
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "budget"};
        assert_int_equal(rl_study_find("budget")->plan(&run, &place, (enum rl_grid)grid, 0, NULL), RL_OK);
        struct rl_claims claims = {0};
        assert_int_equal(rl_study_find("budget")->judge(&claims, &run, NULL), RL_OK);
        assert_true(claims.n == 6);
        for (size_t i = 0; i < claims.n; i++)
            assert_true(claims.claim[i].verdict == RL_VERDICT_INCONCLUSIVE && isnan(claims.claim[i].value));
        rl_claims_clear(&claims);
        static const struct {
            const char *arm;
            int samples, normal_bits, env_size;
            enum rl_texel_format format;
            enum rl_margin margin;
            enum rl_frame_kind frame;
        } row[] = {
            {"sampling", 4, RL_NORMAL_BITS_FLOAT, 0, RL_TEXEL_RGBA16F, RL_MARGIN_OFF, RL_FRAME_ORTHONORMAL},
            {"normals", 0, 8, 0, RL_TEXEL_RGBA16F, RL_MARGIN_OFF, RL_FRAME_ORTHONORMAL},
            {"map", 0, RL_NORMAL_BITS_FLOAT, 256, RL_TEXEL_RGBA16F, RL_MARGIN_OFF, RL_FRAME_ORTHONORMAL},
            {"format", 0, RL_NORMAL_BITS_FLOAT, 0, RL_TEXEL_RGBA8, RL_MARGIN_OFF, RL_FRAME_ORTHONORMAL},
            {"sphere", 0, RL_NORMAL_BITS_FLOAT, 0, RL_TEXEL_RGBA16F, RL_MARGIN_AUTO, RL_FRAME_ORTHONORMAL},
            {"frame", 0, RL_NORMAL_BITS_FLOAT, 0, RL_TEXEL_RGBA16F, RL_MARGIN_OFF, RL_FRAME_PRINTED},
            {"all", 4, 8, 256, RL_TEXEL_RGBA8, RL_MARGIN_AUTO, RL_FRAME_PRINTED},
        };
        for (size_t i = 0; i < run.n_records; i++)
            run.record[i].status = RL_RECORD_OK;
        struct rl_settings base, s;
        assert_int_equal(
            rl_bench_settings(&base, rl_run_find(&run, NULL, "arm=base rr=30")->parameters, NULL), RL_OK);
        for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
            char pattern[64];
            snprintf(pattern, sizeof pattern, "arm=%s rr=30", row[i].arm);
            assert_int_equal(rl_bench_settings(&s, rl_run_find(&run, NULL, pattern)->parameters, NULL),
                             RL_OK);
            assert_int_equal(s.samples, row[i].samples ? row[i].samples : base.samples);
            assert_int_equal(s.normal_bits, row[i].normal_bits);
            assert_int_equal(s.env_size, row[i].env_size ? row[i].env_size : base.env_size);
            assert_int_equal(s.env_format, row[i].format);
            assert_int_equal(s.margin_kind, row[i].margin);
            assert_int_equal(s.frame, row[i].frame);
        }
        rl_run_clear(&run);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_flips),
        cmocka_unit_test(test_plan),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
