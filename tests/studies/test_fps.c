/* The study `fps`: its verdicts follow from the raw frame times, paired by round; what chance explains decides nothing. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "model/random.h"
#include "studies/judged.h"
#include "studies/study.h"

enum { ROUNDS = 60 };

static const struct rl_place place = {"fps", "made-up", "made-up.yaml", 1};

/* Milliseconds of each arm; `jitter`: relative spread of single frames; `wave`: how much the machine slows down in the middle of the run,
 * for all arms alike. */
struct world {
    double none, plain, regular, random, again, environment, jitter, wave;
};

static const struct world usual = {2.0, 2.5, 18.0, 9.0, 9.0, 3.0, 0.01, 0.0};

static void add_arm(struct rl_run *run, const char *arm, double ms, int index, const struct world *w)
{
    double value[ROUNDS];
    for (int i = 0; i < ROUNDS; i++) {
        double chance = 2.0 * rl_random_uniform(11, (uint64_t)index * 1000 + (uint64_t)i) - 1.0;
        value[i] = ms * (1.0 + w->jitter * chance) * (1.0 + (i > 20 && i < 40 ? w->wave : 0.0));
    }
    struct rl_record *r = rl_run_add(run, &place, 0, NULL, "arm=%s method=x samples=4", arm);
    assert_int_equal(rl_record_series_add(r, "frame_ms", value, ROUNDS, NULL), RL_OK);
    r->status = RL_RECORD_OK;
}

static struct rl_claim judge(struct world w, const char *words)
{
    struct rl_run run = {.study = "fps", .grid = "quick"};
    snprintf(run.provenance.renderer, sizeof run.provenance.renderer, "a made-up renderer");
    const struct {
        const char *arm;
        double ms;
    } arm[] = {{"none", w.none},       {"plain", w.plain},          {"regular-13", w.regular},
               {"random-4", w.random}, {"random-4-again", w.again}, {"environment", w.environment}};
    for (int i = 0; i < 6; i++)
        if (arm[i].ms > 0.0)
            add_arm(&run, arm[i].arm, arm[i].ms, i, &w);
    struct rl_claim found = claim_of("fps", &run, words);
    rl_run_clear(&run);
    return found;
}

static void test_flips(void **state)
{
    (void)state;
    static const char faster[] = "paper: 4 random normals are faster than 13 regular";
    struct world w = usual;
    struct rl_claim c = judge(w, faster);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_true(fabs(c.value - 2.0) < 0.02 && c.low <= c.value && c.value <= c.high);
    assert_string_equal(c.command, "roughlight study run fps --scene made-up.yaml --quick");
    w.regular = 8.0;
    assert_int_equal(judge(w, faster).verdict, RL_VERDICT_FAILS);
    w.regular = 9.3; /* faster by 3 %, but two equal arms differ by 10 % */
    w.again = 9.9;
    assert_int_equal(judge(w, faster).verdict, RL_VERDICT_INCONCLUSIVE);

    static const char plain[] = "the light's shape costs a factor of 530/38";
    w = usual;
    assert_int_equal(judge(w, plain).verdict, RL_VERDICT_FAILS);
    w.plain = w.random / 13.9;
    assert_int_equal(judge(w, plain).verdict, RL_VERDICT_HOLDS);

    static const char real_time[] = "random 4 reaches 24 frames/s";
    w = usual;
    c = judge(w, real_time);
    assert_int_equal(c.verdict, RL_VERDICT_HOLDS);
    assert_true(fabs(c.value - 1000.0 / 9.0) < 1.0);
    assert_non_null(strstr(c.note, "a made-up renderer"));
    w.random = 50.0;
    assert_int_equal(judge(w, real_time).verdict, RL_VERDICT_FAILS);
    w.regular = 50.0;
    assert_int_equal(judge(w, "regular 13 reaches 24 frames/s").verdict, RL_VERDICT_FAILS);

    static const char fair[] = "ours: the clock is fair";
    w = usual;
    assert_int_equal(judge(w, fair).verdict, RL_VERDICT_HOLDS);
    w.again = 9.5;
    assert_int_equal(judge(w, fair).verdict, RL_VERDICT_FAILS);

    static const char environment[] = "ours: drawing the environment map anew";
    w = usual;
    assert_int_equal(judge(w, environment).verdict, RL_VERDICT_HOLDS);
    w.environment = 20.0;
    assert_int_equal(judge(w, environment).verdict, RL_VERDICT_FAILS);
}

/* A machine that is three times as slow for a third of the run: ratios within a round do not notice. */
static void test_paired(void **state)
{
    (void)state;
    struct world w = usual;
    w.wave = 2.0;
    struct rl_claim c = judge(w, "paper: 4 random normals are faster than 13 regular");
    assert_true(fabs(c.value - 2.0) < 0.02 && c.high - c.low < 0.05);
}

static void test_missing(void **state)
{
    (void)state;
    struct world w = usual;
    w.random = 0.0;
    assert_int_equal(judge(w, "faster than 13 regular").verdict, RL_VERDICT_INCONCLUSIVE);
    assert_int_equal(judge(w, "random 4 reaches").verdict, RL_VERDICT_INCONCLUSIVE);
    w = usual;
    w.again = 0.0; /* without a noise floor no difference can be told from chance */
    assert_int_equal(judge(w, "faster than 13 regular").verdict, RL_VERDICT_INCONCLUSIVE);
    assert_int_equal(judge(w, "the clock is fair").verdict, RL_VERDICT_INCONCLUSIVE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_flips),
        cmocka_unit_test(test_paired),
        cmocka_unit_test(test_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
