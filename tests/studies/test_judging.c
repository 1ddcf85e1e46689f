/* Verdicts along R_r: of every pattern of steps, the verdict of all, the number that carries it, and what the note says of the rest. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "studies/judging.h"
#include "support/check.h"

enum { STEPS = 5 };

static const double rr[STEPS] = {1.0, 10.0, 30.0, 100.0, 1000.0};

/* A letter each R_r: h holds, f fails, u undecided, - not measured. The number at the i-th R_r is i + 1, its interval a tenth to each
 * side. */
static struct rl_claim concluded(const char *letters, struct rl_claim c)
{
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, strlen(letters));
    for (size_t i = 0; letters[i]; i++)
        if (letters[i] != '-') {
            double x = (double)(i + 1);
            step[i] = (struct rl_step){rr[i], x, x - 0.1, x + 0.1,
                                       letters[i] == 'h'   ? RL_VERDICT_HOLDS
                                       : letters[i] == 'f' ? RL_VERDICT_FAILS
                                                           : RL_VERDICT_INCONCLUSIVE};
        }
    rl_judging_conclude(&c, step, strlen(letters), "of something");
    return c;
}

static const struct rl_claim fresh = {
    .verdict = RL_VERDICT_INCONCLUSIVE, .value = NAN, .low = NAN, .high = NAN};

static void the_number_carries_the_verdict(void **state)
{
    (void)state;
    static const char rough[] = "R_r and rougher", smooth[] = "R_r and smoother", figure[] = "of something";
    static const struct {
        const char *letters;
        enum rl_verdict verdict;
        double value, low, high;
        const char *unit, *note;
    } rows[] = {
        {"hhhhh", RL_VERDICT_HOLDS, 3.0, 2.9, 3.1, figure, "at R_r 30; R_r 1: 1; "},
        {"hhffh", RL_VERDICT_HOLDS_UP_TO, 10.0, 10.0, 30.0, rough,
         "next, R_r 30, fails: 3 [2.9, 3.1] of something; also at R_r 1000 and smoother; R_r 1: 1; R_r 10: "
         "2; "},
        {"hhuff", RL_VERDICT_HOLDS_UP_TO, 10.0, 10.0, 100.0, rough,
         "next, R_r 30, is undecided: 3 [2.9, 3.1] of something; R_r 1: 1; "},
        {"hhhuu", RL_VERDICT_HOLDS_UP_TO, 30.0, 30.0, INFINITY, rough,
         "next, R_r 100, is undecided: 4 [3.9, 4.1] of something; R_r 1: 1; "},
        {"hhhh-", RL_VERDICT_HOLDS_UP_TO, 100.0, 100.0, INFINITY, rough,
         "next, R_r 1000, was not measured; R_r 1: 1; "},
        {"ffuhh", RL_VERDICT_HOLDS_UP_TO, 100.0, 10.0, 100.0, smooth,
         "next, R_r 30, is undecided: 3 [2.9, 3.1] of something; R_r 1: 1; "},
        {"uuuhh", RL_VERDICT_HOLDS_UP_TO, 100.0, 0.0, 100.0, smooth,
         "next, R_r 30, is undecided: 3 [2.9, 3.1] of something; R_r 1: 1; "},
        {"hfhhh", RL_VERDICT_HOLDS_UP_TO, 30.0, 10.0, 30.0, smooth,
         "next, R_r 10, fails: 2 [1.9, 2.1] of something; also at R_r 1 and rougher; R_r 1: 1; "},
        {"hhhfh", RL_VERDICT_HOLDS_UP_TO, 30.0, 30.0, 100.0, rough,
         "next, R_r 100, fails: 4 [3.9, 4.1] of something; also at R_r 1000 and smoother; R_r 1: 1; "},
        /* No end holds: one that fails is enough. */
        {"fffff", RL_VERDICT_FAILS, 3.0, 2.9, 3.1, figure, "at R_r 30; "},
        {"uuuuf", RL_VERDICT_FAILS, 5.0, 4.9, 5.1, figure, "at R_r 1000; R_r 1: 1; "},
        {"uhhfu", RL_VERDICT_FAILS, 4.0, 3.9, 4.1, figure, "at R_r 100; "},
        {"f---u", RL_VERDICT_FAILS, 1.0, 0.9, 1.1, figure, "at R_r 1; "},
        {"-fuf-", RL_VERDICT_FAILS, 2.0, 1.9, 2.1, figure, "at R_r 10; "}, /* by its ratio nearer to 30 */
        {"uhhhu", RL_VERDICT_INCONCLUSIVE, 1.0, 0.9, 1.1, figure, "at R_r 1; "},
        {"-hhhu", RL_VERDICT_INCONCLUSIVE, 5.0, 4.9, 5.1, figure, "at R_r 1000; R_r 1: not measured; "},
        {"uuuuu", RL_VERDICT_INCONCLUSIVE, 3.0, 2.9, 3.1, figure, "at R_r 30; "},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_claim c = concluded(rows[i].letters, fresh);
        if (c.verdict != rows[i].verdict || c.value != rows[i].value)
            fail_msg("%s: %s at %g, expected %s at %g", rows[i].letters, rl_verdict_name(c.verdict), c.value,
                     rl_verdict_name(rows[i].verdict), rows[i].value);
        check_near(c.low, rows[i].low, 1e-12);
        if (isinf(rows[i].high))
            assert_true(c.high == INFINITY);
        else
            check_near(c.high, rows[i].high, 1e-12);
        assert_string_equal(c.unit, rows[i].unit);
        if (strncmp(c.note, rows[i].note, strlen(rows[i].note)) != 0)
            fail_msg("%s: '%s', expected '%s...'", rows[i].letters, c.note, rows[i].note);
    }
}

static void nothing_measured_says_nothing(void **state)
{
    (void)state;
    static const char *const rows[] = {"", "-", "-----"};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_claim c = concluded(rows[i], fresh);
        assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
        assert_true(isnan(c.value));
        assert_string_equal(c.note, "");
    }
    /* Some that was, all of it good, but neither end. */
    struct rl_claim c = concluded("-hhh-", fresh);
    assert_int_equal(c.verdict, RL_VERDICT_INCONCLUSIVE);
    assert_true(isnan(c.value));
}

/* Where a count of normals is asked for there may be none at all. */
static void what_ends_it_may_be_infinite(void **state)
{
    (void)state;
    static const struct {
        struct rl_step next;
        const char *unit, *note;
    } rows[] = {
        {{10.0, INFINITY, INFINITY, INFINITY, RL_VERDICT_FAILS}, "normals", "next, R_r 10, fails: none; "},
        {{10.0, INFINITY, 900.0, INFINITY, RL_VERDICT_INCONCLUSIVE},
         "normals",
         "next, R_r 10, is undecided: none, or 900 normals; "},
        {{10.0, 2.5, 2.5, 2.5, RL_VERDICT_FAILS}, "times", "next, R_r 10, fails: 2.5 times; "},
        {{10.0, 1.0, 0.9, 1.25, RL_VERDICT_INCONCLUSIVE}, "1", "next, R_r 10, is undecided: 1 [0.9, 1.25]; "},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_claim c = fresh;
        struct rl_step step[2] = {{1.0, 5.0, 4.0, 6.0, RL_VERDICT_HOLDS}, rows[i].next};
        rl_judging_conclude(&c, step, 2, rows[i].unit);
        assert_int_equal(c.verdict, RL_VERDICT_HOLDS_UP_TO);
        if (strncmp(c.note, rows[i].note, strlen(rows[i].note)) != 0)
            fail_msg("row %zu: '%s', expected '%s...'", i, c.note, rows[i].note);
    }
}

/* Of every case the verdict and how bad it is: which speaks for all in the end? */
static void the_worst_speaks(void **state)
{
    (void)state;
    enum { CASES = 3, h = RL_VERDICT_HOLDS, f = RL_VERDICT_FAILS, u = RL_VERDICT_INCONCLUSIVE };
    static const struct {
        int verdict[CASES];
        double badness[CASES];
        int of_all, speaker;
    } rows
        [] =
            {
                {{h, h, h}, {1, 3, 2}, h, 1},
                {{h, u, h}, {1, 2, 3}, u, 1}, /* a wide interval is no proof, though another case is worse and sure */
                {{u, h, u}, {3, 9, 2}, u, 0},
                {{f, u, h}, {1, 2, 3}, f, 0},
                {{u, f, f}, {5, 2, 3}, f, 2},
                {{u, u, h}, {NAN, NAN, 1}, h, 2}, /* what was not measured says nothing */
                {{u, u, u}, {NAN, NAN, NAN}, u, -1},
            };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_claim c = fresh;
        double worst = NAN;
        int speaker = -1;
        for (int k = 0; k < CASES; k++)
            if (rl_judging_worse(&c, (enum rl_verdict)rows[i].verdict[k], rows[i].badness[k], &worst))
                speaker = k;
        if ((int)c.verdict != rows[i].of_all || speaker != rows[i].speaker)
            fail_msg("row %zu: %s, spoken for by %d", i, rl_verdict_name(c.verdict), speaker);
    }
}

/* A judge's own number, such as the worst of all, stays only where it cannot mislead. */
static void own_numbers(void **state)
{
    (void)state;
    struct rl_claim own = fresh;
    rl_claim_value(&own, 7.0, 6.0, 8.0, "of its own");
    assert_true(concluded("hhhhh", own).value == 7.0);
    assert_true(concluded("hhhff", own).value == 30.0);
    assert_true(concluded("uuffu", own).value == 3.0);
    assert_true(concluded("uhhhh", own).value == 10.0);
}

/* Beside nothing nothing is small or large. */
static void ratios(void **state)
{
    (void)state;
    static const struct {
        struct rl_metric a, b;
        double value, low, high;
    } rows[] = {
        {{.value = 2, .low = 1, .high = 3}, {.value = 4, .low = 2, .high = 5}, 0.5, 0.2, 1.5},
        {{.value = 2, .low = 1, .high = 3}, {.value = 4, .low = 0, .high = 5}, 0.5, 0.2, INFINITY},
        {{.value = 0, .low = 0, .high = 0}, {.value = 4, .low = 2, .high = 5}, 0.0, 0.0, 0.0},
        {{.value = 2, .low = 1, .high = 3}, {.value = 0, .low = 0, .high = 0}, NAN, NAN, NAN},
        {{.value = 0, .low = 0, .high = 0}, {.value = 0, .low = 0, .high = 0}, NAN, NAN, NAN},
        {{.value = 0, .low = 0, .high = 0}, {.value = 0, .low = 0, .high = 5}, NAN, NAN, NAN},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_claim c = fresh;
        rl_judging_ratio(&c, &rows[i].a, &rows[i].b, "times");
        const double found[] = {c.value, c.low, c.high};
        const double expected[] = {rows[i].value, rows[i].low, rows[i].high};
        for (int k = 0; k < 3; k++)
            if (isnan(expected[k]) ? !isnan(found[k]) : found[k] != expected[k])
                fail_msg("row %zu: [%d] is %g, expected %g", i, k, found[k], expected[k]);
        assert_string_equal(c.unit, "times");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_number_carries_the_verdict),
        cmocka_unit_test(nothing_measured_says_nothing),
        cmocka_unit_test(what_ends_it_may_be_infinite),
        cmocka_unit_test(the_worst_speaks),
        cmocka_unit_test(own_numbers),
        cmocka_unit_test(ratios),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
