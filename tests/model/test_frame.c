/* Tangent frames over the sphere, on the axes and with zeros of both signs. */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "model/frame.h"
#include "model/random.h"
#include "support/check.h"

enum { SPHERE = 20000 };

/* Axes, signed zeros, and normals close to where N.z changes its sign or is -1. */
static const rl_vec3 special[] = {
    {1.0, 0.0, 0.0},    {-1.0, 0.0, 0.0},  {0.0, 1.0, 0.0},    {0.0, -1.0, 0.0},       {0.0, 0.0, 1.0},
    {0.0, 0.0, -1.0},   {1.0, 0.0, -0.0},  {-1.0, -0.0, -0.0}, {-0.0, 1.0, -0.0},      {-0.0, -0.0, 1.0},
    {-0.0, -0.0, -1.0}, {-0.0, 0.0, -1.0}, {1.0, 0.0, 1e-300}, {1.0, 0.0, -1e-300},    {0.6, 0.8, 1e-17},
    {0.6, 0.8, -1e-17}, {1e-9, 0.0, -1.0}, {0.0, -1e-9, -1.0}, {1e-200, 1e-200, -1.0}, {1e-8, 1e-8, 1.0},
};

enum { SPECIAL = sizeof special / sizeof special[0] };

/* The i-th of SPHERE points spread evenly over the sphere, and the special ones after them. */
static rl_vec3 normal(int i)
{
    if (i >= SPHERE)
        return special[i - SPHERE];
    double z = 2.0 * (i + 0.5) / SPHERE - 1.0;
    double r = sqrt((1.0 - z) * (1.0 + z));
    double angle = 2.399963229728653 * i; /* the golden angle */
    return v3_normalize(v3(r * cos(angle), r * sin(angle), z));
}

static void test_orthonormal(void **state)
{
    (void)state;
    const double bound = 8.0 * DBL_EPSILON;
    for (int i = 0; i < SPHERE + SPECIAL; i++) {
        rl_vec3 N = normal(i);
        struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, N);
        check_near(v3_length(f.T), 1.0, bound);
        check_near(v3_length(f.B), 1.0, bound);
        check_near(v3_dot(f.T, f.B), 0.0, bound);
        check_near(v3_dot(f.T, N), 0.0, bound);
        check_near(v3_dot(f.B, N), 0.0, bound);
        check_near(v3_length(v3_sub(v3_cross(f.T, f.B), N)), 0.0, bound);
        assert_memory_equal(&f.N, &N, sizeof N);
    }
}

/* Lengths sqrt(n_y^2 + n_z^2), orthogonal, and T x B = -(n_y^2 + n_z^2) N: left-handed, unlike the other. */
static void test_printed(void **state)
{
    (void)state;
    const double bound = 8.0 * DBL_EPSILON;
    for (int i = 0; i < SPHERE + SPECIAL; i++) {
        rl_vec3 N = normal(i);
        struct rl_frame f = rl_frame_make(RL_FRAME_PRINTED, N);
        double length = hypot(N.y, N.z);
        check_near(v3_length(f.T), length, bound);
        check_near(v3_length(f.B), length, bound);
        check_near(v3_dot(f.T, f.B), 0.0, bound);
        check_near(v3_dot(f.T, N), 0.0, bound);
        check_near(v3_dot(f.B, N), 0.0, bound);
        rl_vec3 expected = v3_scale(-length * length, N);
        check_near(v3_length(v3_sub(v3_cross(f.T, f.B), expected)), 0.0, bound);
    }
    /* It collapses at +-x. */
    struct rl_frame f = rl_frame_make(RL_FRAME_PRINTED, v3(-1.0, 0.0, 0.0));
    check_near(v3_length(f.T), 0.0, 0.0);
    check_near(v3_length(f.B), 0.0, 0.0);
}

static void test_printed_as_in_the_paper(void **state)
{
    (void)state;
    const rl_vec3 N = v3(2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0);
    struct rl_frame f = rl_frame_make(RL_FRAME_PRINTED, N);
    const double T[3] = {0.0, 6.0 / 7.0, -3.0 / 7.0};
    const double B[3] = {45.0 / 49.0, -6.0 / 49.0, -12.0 / 49.0};
    check_near(f.T.x, T[0], DBL_EPSILON);
    check_near(f.T.y, T[1], DBL_EPSILON);
    check_near(f.T.z, T[2], DBL_EPSILON);
    check_near(f.B.x, B[0], DBL_EPSILON);
    check_near(f.B.y, B[1], DBL_EPSILON);
    check_near(f.B.z, B[2], DBL_EPSILON);
}

static void test_microfacet_normal(void **state)
{
    (void)state;
    const uint64_t seed = 5;
    for (int i = 0; i < SPHERE; i += 7) {
        struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, normal(i));
        double delta = RL_PI * (rl_random_uniform(seed, 2 * (uint64_t)i) - 0.5);
        double theta = RL_PI * rl_random_uniform(seed, 2 * (uint64_t)i + 1);
        rl_vec3 H = rl_frame_microfacet_normal(&f, sin(delta), cos(delta), theta);
        check_near(v3_length(H), 1.0, 8.0 * DBL_EPSILON);
        check_near(v3_dot(H, f.N), cos(delta), 8.0 * DBL_EPSILON);
        check_near(v3_dot(H, f.T), sin(delta) * cos(theta), 8.0 * DBL_EPSILON);
        check_near(v3_dot(H, f.B), sin(delta) * sin(theta), 8.0 * DBL_EPSILON);
    }
}

static void test_names(void **state)
{
    (void)state;
    assert_string_equal(rl_frame_name(RL_FRAME_ORTHONORMAL), "orthonormal");
    assert_string_equal(rl_frame_name(RL_FRAME_PRINTED), "printed");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_orthonormal),
        cmocka_unit_test(test_printed),
        cmocka_unit_test(test_printed_as_in_the_paper),
        cmocka_unit_test(test_microfacet_normal),
        cmocka_unit_test(test_names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
