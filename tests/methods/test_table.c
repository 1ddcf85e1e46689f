/* The table of highlight methods: names, and descriptors that say all they must. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "methods/method.h"

static void test_find(void **state)
{
    (void)state;
    static const char *const names[] = {"plain", "regular", "random", "exhaustive", "reference"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const struct rl_method *m = rl_method_find(names[i]);
        assert_non_null(m);
        assert_string_equal(m->name, names[i]);
    }
    assert_null(rl_method_find("Random"));
    assert_null(rl_method_find(""));
    assert_null(rl_method_find(NULL));
}

static void test_descriptors(void **state)
{
    (void)state;
    assert_true(rl_n_methods >= 5);
    for (size_t i = 0; i < rl_n_methods; i++) {
        const struct rl_method *m = rl_methods[i];
        print_message("%s: %s\n", m->name, m->summary);
        assert_ptr_equal(rl_method_find(m->name), m); /* no name comes twice */
        assert_true(strlen(m->summary) > 10 && !strchr(m->summary, '\n'));
        assert_true(m->on_gpu || m->on_cpu);
        assert_in_range(m->default_samples, 1, RL_SAMPLES_MAX);
        assert_true(m->sampled || m->default_samples == 1);
        assert_int_equal(m->needs_pattern, m->pattern != NULL);
        assert_int_equal(m->needs_normal_map, m->texel != NULL);
        assert_int_equal(m->n_params > 0, m->pack != NULL);
        assert_in_range(m->n_params, 0, RL_EFFECT_PARAMS);
    }
    /* The paper's counts. */
    assert_int_equal(rl_method_find("regular")->default_samples, 13);
    assert_int_equal(rl_method_find("random")->default_samples, 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_find),
        cmocka_unit_test(test_descriptors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
