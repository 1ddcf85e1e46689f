/* A case's parameters as settings. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "studies/bench.h"

static void test_settings(void **state)
{
    (void)state;
    struct rl_settings s;
    struct rl_error error = {0};
    assert_int_equal(rl_bench_settings(&s,
                                       "method=random samples=64 rr=2.5 normal_bits=float env_size=1024 "
                                       "env_format=rgba16f width=64 height=48 tolerance=1e-3 seeds=8 "
                                       "interpolation=gouraud",
                                       &error),
                     RL_OK);
    assert_string_equal(s.method, "random");
    assert_true(s.samples == 64 && s.rr == 2.5 && s.normal_bits == RL_NORMAL_BITS_FLOAT &&
                s.env_size == 1024);
    assert_true(s.env_format == RL_TEXEL_RGBA16F && s.width == 64 && s.height == 48 && s.tolerance == 1e-3);
    assert_int_equal(s.interpolation, RL_INTERPOLATION_GOURAUD);
    assert_int_equal(rl_bench_settings(&s, "", &error), RL_OK); /* the paper's */
    assert_int_equal(s.interpolation, RL_INTERPOLATION_OF_MATERIAL);
    assert_true(s.normal_bits == 8 && s.env_size == 256 && s.method == NULL && s.rr == 0.0);
    assert_int_equal(rl_bench_settings(&s, "method=none", &error), RL_OK);
    assert_null(s.method);
    static const char *const bad[] = {"method=magic",    "samples=4.5",       "samples=100000",
                                      "rr=-1",           "normal_bits=two",   "env_size=1e300",
                                      "env_format=jpeg", "interpolation=flat"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        assert_int_equal(rl_bench_settings(&s, bad[i], &error), RL_ERR_INPUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_settings)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
