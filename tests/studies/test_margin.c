/* The study `margin`: its plan, and that its verdicts follow from the rows: other rows, other verdict. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "studies/judged.h"
#include "studies/margin.h"
#include "studies/study.h"

static const struct rl_place place = {"margin", "made-up", "made-up.yaml", 1};
static const struct rl_place alone = {"margin", RL_NO_SCENE, "", 0};

/* What a made-up world is like at R_r 300, 100 and 3, where auto has no sphere. */
struct world {
    double worst, other_worst;            /* of auto, and of the bound 0.1 */
    double loss, filled, filled_300, due; /* at R_r 100 and 300; at 30 both are 0.5 */
    double missed_300;                    /* by auto at R_r 300, 0: as at 100 */
    double missed, missed_half;           /* by auto and by the margin 0.5, at R_r 100 */
    double time, time_300, noise, cost;
};

static const struct world usual = {
    .worst = 0.001,
    .other_worst = 0.01,
    .loss = 0.0005,
    .filled = 0.5,
    .filled_300 = 0.5,
    .due = 0.5,
    .missed = 0.002,
    .missed_half = 0.003,
    .time = 0.8,
    .time_300 = 0.7,
    .noise = 0.02,
    .cost = 0.05,
};

static void metric(struct rl_record *r, const char *name, double value, double spread)
{
    assert_int_equal(rl_record_metric_add(r, name, value, value - spread, value + spread, "1", NULL), RL_OK);
    r->status = RL_RECORD_OK;
}

static struct rl_record *arm(struct rl_run *run, const char *name, double rr)
{
    return rl_run_add(run, &place, (int)rr, NULL, "series=margin arm=%s rr=%g", name, rr);
}

static void add_rr(struct rl_run *run, const struct world *w, double rr, double time)
{
    bool sphere = rr > 10.0;
    metric(arm(run, "again", rr), "time_to_off", 1.0, w->noise);
    metric(arm(run, "huge", rr), "time_to_off", 1.0 + w->cost, 0.01);
    struct rl_record *r = arm(run, "auto", rr);
    metric(r, "spheres", sphere, 0.0);
    metric(r, "bound", 0.02, 0.0);
    metric(r, "from_rr", 20.0, 0.0);
    metric(r, "worst_exact", sphere ? w->worst : 0.0, 1e-4);
    metric(r, "loss_exact", sphere ? w->loss : 0.0, 1e-4);
    if (!isnan(w->missed))
        metric(r, "missed_exact",
               !sphere                              ? 0.0
               : rr == 300.0 && w->missed_300 > 0.0 ? w->missed_300
                                                    : w->missed,
               1e-4);
    metric(r, "missed", 0.0, 0.0); /* of frames: decides nothing */
    metric(r, "time_to_off", sphere ? time : 1.0, 0.01);
    r = arm(run, "0.5", rr);
    metric(r, "spheres", 1.0, 0.0);
    metric(r, "missed_exact", rr > 10.0 ? w->missed_half : 0.2, 1e-4);
    r = rl_run_add(run, &place, 1000 + (int)rr, NULL, "series=bound loss=0.1 rr=%g", rr);
    metric(r, "spheres", sphere, 0.0);
    metric(r, "bound", 0.1, 0.0);
    metric(r, "worst_exact", sphere ? w->other_worst : 0.0, 1e-4);
}

static void add_filled(struct rl_run *run, double rr, double filled, double due)
{
    struct rl_record *r = rl_run_add(run, &alone, 5000, NULL, "series=filled loss=0.02 rr=%g", rr);
    metric(r, "bound", 0.02, 0.0);
    metric(r, "filled", filled, 0.0);
    metric(r, "due", due, 0.0);
}

static struct rl_claim judge(struct world w, const char *words)
{
    struct rl_run run = {.study = "margin", .grid = "default"};
    add_rr(&run, &w, 3.0, w.time);
    add_rr(&run, &w, 100.0, w.time);
    add_rr(&run, &w, 300.0, w.time_300);
    add_filled(&run, 30.0, 0.5, 0.5);
    add_filled(&run, 100.0, w.filled, w.due);
    add_filled(&run, 300.0, w.filled_300, w.due);
    struct rl_claim found = claim_of("margin", &run, words);
    rl_run_clear(&run);
    return found;
}

static void test_flips(void **state)
{
    (void)state;
    static const char bound[] = "margin auto keeps its bound";
    struct world w = usual;
    struct rl_claim c = judge(w, bound);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_true(c.value == 0.001);
    w.worst = 0.03;
    assert_int_equal(judge(w, bound).verdict, RL_VERDICT_FAILS);
    w.worst = 0.02;
    assert_int_equal(judge(w, bound).verdict, RL_VERDICT_INCONCLUSIVE);

    static const char any[] = "keeps any bound";
    assert_int_equal(judge(w, any).verdict, RL_VERDICT_HOLDS);
    assert_true(fabs(judge(w, any).value - 0.1) < 1e-12);
    w.other_worst = 0.2;
    assert_int_equal(judge(w, any).verdict, RL_VERDICT_FAILS);

    static const char energy[] = "auto misses at most 1 %";
    w = usual;
    assert_int_equal(judge(w, energy).verdict, RL_VERDICT_HOLDS);
    /* The most that is missed speaks, not what the central R_r happens to miss. */
    w.missed_300 = 0.004;
    c = judge(w, energy);
    assert_true(c.verdict == RL_VERDICT_HOLDS && c.value == 0.004);
    assert_non_null(strstr(c.note, "the most, at R_r 300; R_r 100: 0.002"));
    w = usual;
    w.missed = 0.05;
    c = judge(w, energy);
    assert_int_equal(
        c.verdict, RL_VERDICT_FAILS); /* that nothing is missed at R_r 3, without a sphere, does not count */
    assert_true(c.value == 0.05);

    w.missed = NAN; /* no highlight: no share of it */
    assert_int_equal(judge(w, energy).verdict, RL_VERDICT_INCONCLUSIVE);

    static const char loss[] = "bound x radiance x pixels skipped";
    w = usual;
    assert_int_equal(judge(w, loss).verdict, RL_VERDICT_HOLDS);
    w.loss = 0.03;
    assert_int_equal(judge(w, loss).verdict, RL_VERDICT_FAILS);
    static const char half[] = "1.5 times as large";
    w = usual;
    c = judge(w, half);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS_UP_TO);
    assert_true(c.value == 100.0);
    w.missed_half = 0.1;
    assert_int_equal(judge(w, half).verdict, RL_VERDICT_FAILS);

    static const char time[] = "the sphere saves time";
    w = usual;
    c = judge(w, time);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS); /* R_r 3, without a sphere, says nothing of the sphere */
    assert_true(c.value == 0.8);
    assert_non_null(strstr(c.note, "no sphere at R_r 3: auto has one from R_r 20 on"));
    assert_null(strstr(c.note, "R_r 3: 1"));
    w.time = 0.98; /* less, but no less than chance */
    c = judge(w, time);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS_UP_TO);
    assert_true(c.value == 300.0);
    /* The interval shown is the one that was judged: 0.98 is undecided since it may be off by what two equal arms are. */
    assert_non_null(strstr(c.note, "next, R_r 100, is undecided: 0.98 [0.95, 1.01] times"));
    w.time = w.time_300 = 1.2;
    c = judge(w, time);
    assert_int_equal(c.verdict, RL_VERDICT_FAILS);
    assert_true(c.value == 1.2 &&
                fabs(c.low - 1.17) < 1e-12); /* that of an R_r that fails, with its interval */

    static const char cost[] = "pass itself is cheap";
    w = usual;
    assert_int_equal(judge(w, cost).verdict, RL_VERDICT_HOLDS);
    w.cost = 0.3;
    c = judge(w, cost);
    assert_int_equal(c.verdict, RL_VERDICT_FAILS);
    assert_true(fabs(c.low - 0.27) < 1e-12 && fabs(c.high - 0.33) < 1e-12); /* noise included */
    w.cost = 0.08; /* below a tenth, but by less than noise */
    w.noise = 0.05;
    assert_int_equal(judge(w, cost).verdict, RL_VERDICT_INCONCLUSIVE);
}

/* One row outside is enough, and the note says how many there are. */
static void test_filled(void **state)
{
    (void)state;
    static const char keeps[] = "keeps its bound whatever the lights",
                      proved[] = "as large as its proof asks", tight[] = "hardly larger than any light needs";
    struct world w = usual;
    assert_int_equal(judge(w, keeps).verdict, RL_VERDICT_HOLDS);
    assert_int_equal(judge(w, proved).verdict, RL_VERDICT_HOLDS);
    struct rl_claim c = judge(w, tight);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_non_null(strstr(c.note, "of 3 rows"));
    assert_non_null(strstr(c.note, "; 0 outside"));
    w.filled_300 = 0.015; /* a margin far too large at R_r 300 alone */
    assert_int_equal(judge(w, keeps).verdict, RL_VERDICT_HOLDS);
    c = judge(w, proved);
    assert_int_equal(c.verdict, RL_VERDICT_FAILS);
    assert_true(fabs(c.value - 0.03) < 1e-12 && fabs(c.high - 0.03) < 1e-12);
    assert_non_null(strstr(c.note, "bound 0.02 at R_r 300; 1 outside"));
    c = judge(w, tight);
    assert_int_equal(c.verdict, RL_VERDICT_FAILS);
    assert_true(c.value == 0.015);
    w.filled_300 = 0.0; /* no sphere, though there could be one */
    assert_int_equal(judge(w, proved).verdict, RL_VERDICT_FAILS);
    w.filled_300 = 1.05; /* far too small */
    c = judge(w, keeps);
    assert_int_equal(c.verdict, RL_VERDICT_FAILS);
    assert_true(c.value == 1.05);
    assert_int_equal(judge(w, proved).verdict, RL_VERDICT_FAILS);
    w = usual;
    w.filled = 0.52; /* a little too small */
    c = judge(w, proved);
    assert_true(c.verdict == RL_VERDICT_FAILS && fabs(c.value - 1.04) < 1e-12);
    w = usual;
    w.filled = w.filled_300 = w.due = 0.1; /* small lights: as proved, but wasteful */
    assert_int_equal(judge(w, proved).verdict, RL_VERDICT_HOLDS);
    c = judge(w, tight);
    assert_int_equal(c.verdict, RL_VERDICT_FAILS);
    assert_non_null(strstr(c.note, "; 2 outside"));
}

/* The closed form itself, at every R_r and bound: what it leaves to lights made for it, against its proof. A margin that is too large
 * at some R_r alone loses nothing and is seen nowhere else. */
static void test_as_proved(void **state)
{
    (void)state;
    static const double rr[] = {0.5, 1, 3, 30, 100, 300, 1000}, loss[] = {0.3, 0.1, 0.02, 0.005};
    size_t with_spheres = 0;
    for (size_t i = 0; i < sizeof rr / sizeof rr[0]; i++)
        for (size_t k = 0; k < sizeof loss / sizeof loss[0]; k++) {
            struct rl_margin_filled f = rl_margin_filled(rr[i], loss[k]);
            assert_int_equal(isnan(f.lost), isnan(f.due));
            if (isnan(f.due))
                continue;
            with_spheres++;
            print_message("R_r %g, bound %g: %.5f of it lost, %.5f due\n", rr[i], loss[k], f.lost, f.due);
            assert_true(f.lost > 0.0 && f.lost <= 1.0 && fabs(f.lost / f.due - 1.0) < 1e-4);
        }
    assert_true(with_spheres >= 15);
}

/* Nothing measured: no verdict is made up. */
static void test_missing(void **state)
{
    (void)state;
    struct rl_run run = {.study = "margin", .grid = "quick"};
    assert_int_equal(rl_study_find("margin")->plan_alone(&run, &alone, RL_GRID_QUICK, 0, NULL), RL_OK);
    assert_int_equal(rl_study_find("margin")->plan(&run, &place, RL_GRID_QUICK, 100, NULL), RL_OK);
    struct rl_claims claims = {0};
    assert_int_equal(rl_study_find("margin")->judge(&claims, &run, NULL), RL_OK);
    assert_true(claims.n == 10);
    for (size_t i = 0; i < claims.n; i++) {
        assert_int_equal(claims.claim[i].verdict, RL_VERDICT_INCONCLUSIVE);
        assert_true(isnan(claims.claim[i].value));
    }
    rl_claims_clear(&claims);
    rl_run_clear(&run);
}

/* Every case is its own, and what the claims need is in every grid. */
static void test_plan(void **state)
{
    (void)state;
    for (int grid = RL_GRID_QUICK; grid <= RL_GRID_FULL; grid++) {
        struct rl_run run = {.study = "margin"};
        assert_int_equal(rl_study_find("margin")->plan_alone(&run, &alone, (enum rl_grid)grid, 0, NULL),
                         RL_OK);
        assert_int_equal(rl_study_find("margin")->plan(&run, &place, (enum rl_grid)grid, 100, NULL), RL_OK);
        static const char *const needed[] = {
            "series=margin arm=off rr=30",    "series=margin arm=again rr=300",
            "series=margin arm=auto rr=30",   "series=margin arm=huge rr=30",
            "series=margin arm=0.5 rr=30",    "series=bound rr=30",
            "series=filled loss=0.02 rr=300", "series=margin arm=none rr=300 method=none",
        };
        check_plan(&run, needed, sizeof needed / sizeof needed[0]);
        rl_run_clear(&run);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_flips),   cmocka_unit_test(test_filled), cmocka_unit_test(test_as_proved),
        cmocka_unit_test(test_missing), cmocka_unit_test(test_plan),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
