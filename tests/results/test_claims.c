/* Verdicts follow from the interval and the bound alone. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "results/claims.h"

static void test_verdicts(void **state)
{
    (void)state;
    static const struct {
        double low, high;
        enum rl_verdict at_least_1, at_most_1, equals_1; /* the last to within 0.25 */
    } row[] = {
        {1.0, 1.0, RL_VERDICT_HOLDS, RL_VERDICT_HOLDS, RL_VERDICT_HOLDS},
        {1.1, 1.2, RL_VERDICT_HOLDS, RL_VERDICT_FAILS, RL_VERDICT_HOLDS},
        {0.8, 0.9, RL_VERDICT_FAILS, RL_VERDICT_HOLDS, RL_VERDICT_HOLDS},
        {0.9, 1.1, RL_VERDICT_INCONCLUSIVE, RL_VERDICT_INCONCLUSIVE, RL_VERDICT_HOLDS},
        {1.1, 1.3, RL_VERDICT_HOLDS, RL_VERDICT_FAILS, RL_VERDICT_INCONCLUSIVE},
        {0.7, 0.8, RL_VERDICT_FAILS, RL_VERDICT_HOLDS, RL_VERDICT_INCONCLUSIVE},
        {1.5, 1.6, RL_VERDICT_HOLDS, RL_VERDICT_FAILS, RL_VERDICT_FAILS},
        {0.0, 3.0, RL_VERDICT_INCONCLUSIVE, RL_VERDICT_INCONCLUSIVE, RL_VERDICT_INCONCLUSIVE},
        {-INFINITY, INFINITY, RL_VERDICT_INCONCLUSIVE, RL_VERDICT_INCONCLUSIVE, RL_VERDICT_INCONCLUSIVE},
        {NAN, NAN, RL_VERDICT_INCONCLUSIVE, RL_VERDICT_INCONCLUSIVE, RL_VERDICT_INCONCLUSIVE},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        assert_int_equal(rl_verdict_at_least(row[i].low, row[i].high, 1.0), row[i].at_least_1);
        assert_int_equal(rl_verdict_at_most(row[i].low, row[i].high, 1.0), row[i].at_most_1);
        assert_int_equal(rl_verdict_equals(row[i].low, row[i].high, 1.0, 0.25), row[i].equals_1);
    }
}

static void test_names(void **state)
{
    (void)state;
    assert_string_equal(rl_verdict_name(RL_VERDICT_HOLDS), "holds");
    assert_string_equal(rl_verdict_name(RL_VERDICT_HOLDS_UP_TO), "holds up to");
    assert_string_equal(rl_verdict_name(RL_VERDICT_FAILS), "fails");
    assert_string_equal(rl_verdict_name(RL_VERDICT_INCONCLUSIVE), "inconclusive");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_verdicts), cmocka_unit_test(test_names)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
