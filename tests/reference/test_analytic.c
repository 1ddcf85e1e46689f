/* L_o where it is elementary: wedges and hemispheres of light seen from above, R = 1; reciprocity and the bound on energy. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "reference/fixture.h"
#include "support/check.h"

static const double ratios[] = {0.5, 1.0, 1.0 + 1e-9, 1.5, 3.0, 30.0, 300.0, 1e4};

/* The directions above the horizon whose azimuth lies in [start, start + omega], omega < pi: one triangle. */
static struct shape wedge(double start, double omega)
{
    struct shape shape = {.n = 3};
    shape.vertex[0] = v3(0, 0, 1);
    shape.vertex[1] = v3(cos(start), sin(start), 0);
    shape.vertex[2] = v3(cos(start + omega), sin(start + omega), 0);
    return shape;
}

/* Seen along the normal, L stands at 2 delta: the horizon is at delta = pi/4, and G = min(1, 2 cos(2 delta)) is below 1 from pi/6 on.
 *
 *     G = 1:  M = U(pi/4) - U(-pi/4)
 *     else    M = U(pi/6) - U(-pi/6) + 4 int over [sin pi/6, sin pi/4] of norm (1 - 2 s^2)/(1 + k^2 s^2) ds,
 *             (1 - 2 s^2)/(1 + k^2 s^2) = -2/k^2 + (1 + 2/k^2)/(1 + k^2 s^2);   R = 1: (s - 2 s^3/3)
 */
static double hemisphere(double rr, bool attenuation)
{
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    double edge = attenuation ? RL_PI / 6.0 : RL_PI / 4.0;
    double sum = rl_ellipsoid_cdf(&e, edge) - rl_ellipsoid_cdf(&e, -edge);
    if (!attenuation)
        return sum;
    double kk = rr * rr - 1.0, k = sqrt(fabs(kk)), part[2];
    static const double ends[2] = {0.5, 0.70710678118654752440};
    for (int i = 0; i < 2; i++) {
        double s = ends[i];
        if (fabs(kk) < 1e-6)
            part[i] = s - 2.0 * s * s * s / 3.0 - kk * (s * s * s / 3.0 - 2.0 * pow(s, 5.0) / 5.0);
        else
            part[i] = -2.0 * s / kk + (1.0 + 2.0 / kk) * (kk > 0.0 ? atan(k * s) : atanh(k * s)) / k;
    }
    return sum + 4.0 * e.norm * (part[1] - part[0]);
}

static void test_wedges(void **state)
{
    (void)state;
    struct dice d = dice_make(81);
    for (size_t i = 0; i < LENGTH(ratios); i++)
        for (int j = 0; j < 40; j++) {
            bool attenuation = j % 2;
            double omega = j < 4 ? 1e-3 : uniform(&d, 0.01, 3.1);
            struct shape light = wedge(uniform(&d, 0.0, 2.0 * RL_PI), omega);
            const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 1)};
            check_near(value_of(&s, ratios[i], &light, 1, attenuation, 1e-11),
                       omega / (2.0 * RL_PI) * hemisphere(ratios[i], attenuation), 2e-11);
        }
}

/* R = 1 in numbers: a light filling the half space above gives sin(pi/4), and with attenuation (4 sqrt(1/2) - 1)/3; half of it, half. */
static void test_half_space(void **state)
{
    (void)state;
    const struct shape light[4] = {wedge(0.3, RL_PI / 2), wedge(0.3 + RL_PI / 2, RL_PI / 2),
                                   wedge(0.3 + RL_PI, RL_PI / 2), wedge(0.3 + 1.5 * RL_PI, RL_PI / 2)};
    const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 1)};
    check_near(value_of(&s, 1.0, light, 4, false, 1e-12), sqrt(0.5), 1e-12);
    check_near(value_of(&s, 1.0, light, 4, true, 1e-12), (4.0 * sqrt(0.5) - 1.0) / 3.0, 1e-12);
    check_near(value_of(&s, 1.0, light, 2, false, 1e-12), sqrt(0.5) / 2.0, 1e-12);
    /* Seen from any side, the part of a line above the horizon is phi/2 -+ pi/4, tan(phi) = v_t/v_N: by the midpoint rule, which
     * converges geometrically on a circle. */
    struct dice d = dice_make(82);
    for (int i = 0; i < 40; i++) {
        struct rl_surface aside = s;
        double rr = ratios[(size_t)i % LENGTH(ratios)], n_v = uniform(&d, 0.2, 1.0), sum = 0.0;
        struct rl_ellipsoid e = rl_ellipsoid_make(rr);
        aside.V = v3(sqrt(1.0 - n_v * n_v), 0.0, n_v);
        enum { LINES = 4000 };
        for (int j = 0; j < LINES; j++) {
            double phi = atan2(aside.V.x * cos(RL_PI * (j + 0.5) / LINES), n_v);
            sum +=
                rl_ellipsoid_cdf(&e, 0.5 * phi + RL_PI / 4.0) - rl_ellipsoid_cdf(&e, 0.5 * phi - RL_PI / 4.0);
        }
        check_near(value_of(&aside, rr, light, 4, false, 1e-10), sum / LINES, 2e-10);
    }
}

/* P just above a light so large that it fills the half space: how near its plane P may be before it counts as lying in it. */
static void test_close_to_the_plane(void **state)
{
    (void)state;
    const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 1)};
    static const double heights[] = {1e-6, 1e-7, 3e-8};
    for (size_t i = 0; i < LENGTH(heights); i++) {
        double h = heights[i];
        const struct shape light = {4, {{1e6, 1e6, h}, {-1e6, 1e6, h}, {-1e6, -1e6, h}, {1e6, -1e6, h}}};
        for (size_t j = 0; j < LENGTH(ratios); j++)
            check_near(value_of(&s, ratios[j], &light, 1, j % 2, 1e-11), hemisphere(ratios[j], j % 2), 1e-10);
    }
}

/* A small square of solid angle 4e-8 about a direction, facing P. */
static struct shape small_light(rl_vec3 direction)
{
    struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, direction);
    struct shape shape = {.n = 4};
    for (int i = 0; i < 4; i++)
        shape.vertex[i] =
            v3_madd(v3_madd(direction, i == 0 || i == 3 ? -1e-4 : 1e-4, f.T), i < 2 ? -1e-4 : 1e-4, f.B);
    return shape;
}

/* D, G and V.H do not change when V and L change places, so a small light's highlight does not either. */
static void test_reciprocity(void **state)
{
    (void)state;
    struct dice d = dice_make(83);
    for (int i = 0; i < 200; i++) {
        struct rl_surface there = {v3(0, 0, 0), unit_vector(&d), v3(0, 0, 0)}, back;
        rl_vec3 L;
        do {
            there.V = unit_vector(&d);
            L = unit_vector(&d);
        } while (v3_dot(there.N, there.V) < 0.05 || v3_dot(there.N, L) < 0.05 ||
                 v3_length(v3_cross(there.N, v3_normalize(v3_add(L, there.V)))) < 0.05);
        back = there;
        back.V = L;
        struct shape at_light = small_light(L), at_eye = small_light(there.V);
        double rr = pow(10.0, uniform(&d, 0.0, 2.0));
        double value = value_of(&there, rr, &at_light, 1, i % 2, 1e-17);
        check_relative(value_of(&back, rr, &at_eye, 1, i % 2, 1e-17), value, 1e-5);
        assert_true(value > 0.0);
    }
}

/* Light all round gives 1 without attenuation and less with it; more of it never gives less; no lights give more than 1. */
static void test_energy(void **state)
{
    (void)state;
    struct dice d = dice_make(84);
    for (int i = 0; i < 300; i++) {
        struct rl_surface s = surface_point(&d, 0.02);
        double rr = ratios[(size_t)i % LENGTH(ratios)], before = 0.0, radiance[4] = {1.0, 1.0, 0.5, 1.0};
        struct shape shapes[4];
        for (size_t n = 1; n <= LENGTH(shapes); n++) {
            shapes[n - 1] = random_light(&d, &s);
            if (n == 3)
                continue;
            struct rl_light_set *set = lights_of(shapes, radiance, n);
            double value = integrate(&s, rr, set, i % 2, 1e-9).value[0];
            rl_light_set_free(set);
            assert_true(value >= -1e-9 && value <= 1.0 + 1e-9);
            if (n <= 2) /* a darker light may hide a brighter one */
                assert_true(value >= before - 2e-9);
            before = value;
        }
    }
    const struct shape light[4] = {wedge(0, RL_PI / 2), wedge(RL_PI / 2, RL_PI / 2), wedge(RL_PI, RL_PI / 2),
                                   wedge(1.5 * RL_PI, RL_PI / 2)};
    for (int i = 0; i < 100; i++) {
        struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 0)};
        double n_v = uniform(&d, 0.02, 1.0), rr = ratios[(size_t)i % LENGTH(ratios)];
        s.V = v3(sqrt(1.0 - n_v * n_v), 0, n_v);
        double with = value_of(&s, rr, light, 4, true, 1e-9);
        assert_true(with > 0.0 && with <= value_of(&s, rr, light, 4, false, 1e-9) + 2e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_wedges),
        cmocka_unit_test(test_half_space),
        cmocka_unit_test(test_close_to_the_plane),
        cmocka_unit_test(test_reciprocity),
        cmocka_unit_test(test_energy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
