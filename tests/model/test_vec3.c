/* Vectors at the ends of the range of doubles, and the mirror. */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "model/vec3.h"
#include "support/check.h"

static void test_normalize(void **state)
{
    (void)state;
    static const double sizes[] = {1.0, 1e-3, 1e300, DBL_MAX / 3.0, 1e-300, DBL_MIN, 4.0 * DBL_TRUE_MIN};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        double s = sizes[i];
        rl_vec3 a = v3_normalize(v3(0.0, -s, 0.0));
        check_near(a.y, -1.0, 0.0);
        check_near(v3_length(v3_normalize(v3(s, s, -s))), 1.0, 4.0 * DBL_EPSILON);
        a = v3_normalize(v3(2.0 * s / 4.0, s, -2.0 * s / 2.0)); /* 1, 2, -2 of length 3 */
        check_near(a.x, 1.0 / 3.0, 4.0 * DBL_EPSILON);
        check_near(a.y, 2.0 / 3.0, 4.0 * DBL_EPSILON);
        check_near(a.z, -2.0 / 3.0, 4.0 * DBL_EPSILON);
    }
    rl_vec3 zero = v3_normalize(v3(0.0, -0.0, 0.0));
    check_near(v3_length(zero), 0.0, 0.0);
    /* One component tiny beside another. */
    check_near(v3_normalize(v3(1e-300, 0.0, 1e300)).z, 1.0, 0.0);
}

static void test_products(void **state)
{
    (void)state;
    rl_vec3 a = v3(1.0, 2.0, 3.0);
    rl_vec3 b = v3(4.0, -5.0, 6.0);
    check_near(v3_dot(a, b), 12.0, 0.0);
    rl_vec3 c = v3_cross(a, b); /* 2*6+3*5, 3*4-1*6, -5-8 */
    check_near(c.x, 27.0, 0.0);
    check_near(c.y, 6.0, 0.0);
    check_near(c.z, -13.0, 0.0);
    c = v3_madd(a, 2.0, v3_sub(b, v3_add(a, v3_scale(0.5, b))));
    check_near(c.x, 3.0, 0.0); /* 1 + 2 (4 - 1 - 2) */
    check_near(c.y, -7.0, 0.0);
    check_near(c.z, 3.0, 0.0);
    check_near(v3_length(v3(2.0, -3.0, 6.0)), 7.0, 0.0);
}

static void test_reflect(void **state)
{
    (void)state;
    rl_vec3 N = v3(0.6, 0.0, 0.8);
    rl_vec3 V = v3_normalize(v3(-0.2, 0.5, 0.7));
    rl_vec3 L = v3_reflect(V, N);
    check_near(v3_length(L), 1.0, 4.0 * DBL_EPSILON);
    check_near(v3_dot(L, N), v3_dot(V, N), 4.0 * DBL_EPSILON);
    check_near(v3_length(v3_cross(v3_add(L, V), N)), 0.0, 4.0 * DBL_EPSILON);
    check_near(v3_length(v3_sub(v3_reflect(N, N), N)), 0.0, 4.0 * DBL_EPSILON);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_normalize),
        cmocka_unit_test(test_products),
        cmocka_unit_test(test_reflect),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
