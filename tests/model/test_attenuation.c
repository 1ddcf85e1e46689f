/* Geometric attenuation: values by hand, limits, and the places where its minimum changes sides. */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "model/attenuation.h"
#include "model/random.h"
#include "model/vec3.h"
#include "support/check.h"

static void test_values(void **state)
{
    (void)state;
    static const struct {
        double n_h, n_v, n_l, v_h, g;
    } cases[] = {
        {1.0, 1.0, 1.0, 1.0, 1.0},                 /* everything along N */
        {1.0, 0.3, 0.3, 0.3, 1.0},                 /* H = N: 2 N.V/V.H = 2, whatever the angle */
        {0.5, 0.6, 0.8, 0.9, 0.66666666666666667}, /* masking: 2 x 0.5 x 0.6/0.9 */
        {0.5, 0.8, 0.6, 0.9, 0.66666666666666667}, /* shadowing: the same with V and L exchanged */
        {0.5, 0.5, 0.9, 0.5, 1.0},                 /* masking just reaches 1 */
        {0.5, 0.25, 0.9, 0.5, 0.5},
        {0.25, 1e-3, 1e-6, 0.5, 1e-6},
        {1.0, 1e-300, 1.0, 1e-300, 1.0},
        {1.0, 1.0, 1.0, DBL_TRUE_MIN, 1.0}, /* the quotient would overflow */
        {1e-200, 1e-200, 1.0, 0.5, 0.0},    /* the product underflows */
        {0.5, 0.6, 0.0, 0.9, 0.0},
        {0.5, 0.6, -0.1, 0.9, 0.0},
        {0.5, 0.6, 0.8, 0.0, 0.0},
        {0.5, 0.6, 0.8, -0.9, 0.0},
        {0.0, 0.6, 0.8, 0.9, 0.0},
        {-0.5, 0.6, 0.8, 0.9, 0.0},
        {0.5, 0.0, 0.8, 0.9, 0.0},
        {0.5, -0.6, 0.8, 0.9, 0.0},
        {NAN, 0.6, 0.8, 0.9, 0.0},
        {0.5, NAN, 0.8, 0.9, 0.0},
        {0.5, 0.6, NAN, 0.9, 0.0},
        {0.5, 0.6, 0.8, NAN, 0.0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        check_relative(rl_attenuation(cases[i].n_h, cases[i].n_v, cases[i].n_l, cases[i].v_h), cases[i].g,
                       4.0 * DBL_EPSILON);
}

static void test_range_and_reciprocity(void **state)
{
    (void)state;
    const uint64_t seed = 3;
    for (uint64_t i = 0; i < 10000; i++) {
        double n_h = rl_random_uniform(seed, 4 * i);
        double n_v = rl_random_uniform(seed, 4 * i + 1);
        double n_l = rl_random_uniform(seed, 4 * i + 2);
        double v_h = rl_random_uniform(seed, 4 * i + 3);
        double g = rl_attenuation(n_h, n_v, n_l, v_h);
        assert_true(g > 0.0 && g <= 1.0);
        assert_true(g == rl_attenuation(n_h, n_l, n_v, v_h));
    }
}

/* G for N = z, V in the plane of x and z at `angle` from N, and H at `delta`. */
static double in_plane(double angle, double delta)
{
    rl_vec3 N = v3(0.0, 0.0, 1.0);
    rl_vec3 V = v3(sin(angle), 0.0, cos(angle));
    rl_vec3 H = v3(sin(delta), 0.0, cos(delta));
    rl_vec3 L = v3_reflect(V, H);
    return rl_attenuation(v3_dot(N, H), v3_dot(N, V), v3_dot(N, L), v3_dot(V, H));
}

/* With v_N = cos(angle), v_t = sin(angle): masking reaches 1 at tan(delta) = v_N/v_t, delta = pi/2 - angle; shadowing
 * at tan(3 delta) = -v_N/v_t, delta = (angle -+ pi/2)/3. G = 1 from the lower of these to the first of the upper ones, and
 * is less just outside. */
static void test_where_it_reaches_one(void **state)
{
    (void)state;
    for (int degrees = 5; degrees <= 85; degrees += 5) {
        double angle = degrees * RL_PI / 180.0;
        double lower = (angle - 0.5 * RL_PI) / 3.0;
        double upper = fmin(0.5 * RL_PI - angle, (angle + 0.5 * RL_PI) / 3.0);
        check_near(in_plane(angle, 0.0), 1.0, 0.0);
        check_near(in_plane(angle, lower), 1.0, 1e-14);
        check_near(in_plane(angle, upper), 1.0, 1e-14);
        check_near(in_plane(angle, lower + 1e-6), 1.0, 0.0);
        check_near(in_plane(angle, upper - 1e-6), 1.0, 0.0);
        assert_true(in_plane(angle, lower - 1e-6) < 1.0 - 1e-8);
        assert_true(in_plane(angle, upper + 1e-6) < 1.0 - 1e-8);
        /* L sets where its angle, 2 delta - angle, is pi/2. */
        check_near(in_plane(angle, 0.25 * RL_PI + 0.5 * angle + 1e-6), 0.0, 0.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values),
        cmocka_unit_test(test_range_and_reciprocity),
        cmocka_unit_test(test_where_it_reaches_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
