/* L_o where it is known by other means: furnace, mirror, closed forms, symmetries. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "reference/fixture.h"
#include "reference/witness.h"
#include "support/check.h"

static const double ratios[] = {0.5, 1.0, 1.5, 3.0, 30.0, 300.0};

/* Square faces of a box about the origin, turned so that the x axis becomes `axis`. */
static void box(struct shape face[6], rl_vec3 low, rl_vec3 high, rl_vec3 axis)
{
    struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, axis);
    for (int i = 0; i < 6; i++) {
        face[i].n = 4;
        for (int j = 0; j < 4; j++) {
            double a = j == 1 || j == 2 ? 1.0 : 0.0, b = j >= 2 ? 1.0 : 0.0, side = i % 2;
            const double unit[3] = {i / 2 == 0 ? side : a,
                                    i / 2 == 1   ? side
                                    : i / 2 == 0 ? a
                                                 : b,
                                    i / 2 == 2 ? side : b};
            double x = low.x + unit[0] * (high.x - low.x), y = low.y + unit[1] * (high.y - low.y),
                   z = low.z + unit[2] * (high.z - low.z);
            face[i].vertex[j] = v3_madd(v3_madd(v3_scale(x, f.N), y, f.T), z, f.B);
        }
    }
}

/* Constant radiance all round, G off: exactly 1, for every R and V. */
static void test_furnace(void **state)
{
    (void)state;
    struct dice d = dice_make(31);
    struct shape face[6];
    for (size_t i = 0; i < LENGTH(ratios); i++)
        for (int j = 0; j < 30; j++) {
            /* Axis-aligned with the frame at first: every degeneracy there is. */
            rl_vec3 axis = j < 10 ? v3(1, 0, 0) : unit_vector(&d);
            box(face, v3(-1.5, -1.0, -2.0), v3(1.0, 1.0, 3.0), axis);
            struct rl_surface s = {v3_scale(j % 2 ? 0.3 : 0.0, unit_vector(&d)), unit_vector(&d),
                                   v3(0, 0, 0)};
            if (j < 10)
                s.N = j % 3 == 0 ? v3(1, 0, 0) : j % 3 == 1 ? v3(0, -1, 0) : v3(0, 0, -1);
            rl_vec3 t = v3_normalize(v3_cross(s.N, j < 10 ? v3(0.3, 0.3, 0.3) : unit_vector(&d)));
            double n_v = j % 5 == 0 ? 1.0 : j % 5 == 1 ? 0.05 : uniform(&d, 0.05, 1.0);
            s.V = v3_madd(v3_scale(n_v, s.N), sqrt(1.0 - n_v * n_v), t);
            check_near(value_of(&s, ratios[i], face, 6, false, 1e-10), 1.0, 1e-10);
        }
}

/* The printed frame narrows the lobe, but it still integrates to 1; where it has collapsed it is a mirror. */
static void test_furnace_in_the_printed_frame(void **state)
{
    (void)state;
    struct dice d = dice_make(32);
    struct shape face[6];
    box(face, v3(-1.5, -1.0, -2.0), v3(1.0, 1.0, 3.0), v3(0, 1, 0));
    struct rl_light_set *set = set_of(face, 6), *one = set_of(&face[1], 1);
    for (int i = 0; i < 30; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        s.P = v3(0, 0, 0);
        if (i % 3 == 0) {
            s.N = v3(i % 2 ? 1 : -1, 0, 0);
            s.V = v3_normalize(v3_madd(s.N, 0.9, unit_vector(&d)));
        }
        struct rl_ellipsoid e = rl_ellipsoid_make(ratios[(size_t)i % LENGTH(ratios)]);
        const struct rl_integrate_options options = {.frame = RL_FRAME_PRINTED, .tolerance = 1e-10};
        struct rl_estimate r;
        rl_integrate_lines(&r, &s, &e, set, &options);
        check_near(r.value[0], 1.0, 1e-10);
        rl_integrate_lines(&r, &s, &e, one, &options);
        rl_vec3 mirror = v3_reflect(s.V, s.N);
        if (i % 3 == 0)
            check_near(r.value[0], witness_hit(s.P, mirror, face[1].vertex, 4) > 0.0 ? 1.0 : 0.0, 1e-10);
    }
    rl_light_set_free(set);
    rl_light_set_free(one);
}

/* Smooth surfaces are mirrors: 1 less the tail beyond the light's edge, 0 plus the tail inside. At the edge's angle delta at least,
 * the tail is at most 2 (1 - U(delta)). */
static void test_mirror(void **state)
{
    (void)state;
    static const double smooth[] = {1e3, 1e6, 1e9, 1e12};
    const struct shape quad = {4, {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
    for (size_t i = 0; i < LENGTH(smooth); i++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(smooth[i]);
        for (int j = 0; j < 2; j++) {
            rl_vec3 V = v3_normalize(v3(j ? -2.5 : -0.3, 0.1, 2.0));
            struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), V};
            double tail = 2.0 * rl_ellipsoid_cdf(&e, -0.05);
            struct rl_light_set *set = set_of(&quad, 1);
            struct rl_estimate r = integrate(&s, smooth[i], set, true, 1e-9);
            rl_light_set_free(set);
            if (j)
                assert_true(r.value[0] >= -1e-9 && r.value[0] <= tail + 1e-9);
            else
                assert_true(r.value[0] <= 1.0 + 1e-9 && r.value[0] >= 1.0 - tail - 1e-9);
            if (i == 0) /* the witness cannot resolve sharper peaks */
                check_near(r.value[0], witness_area(&s, smooth[i], quad.vertex, 4, true, 1e-10), 1e-9);
        }
    }
}

/* The light's edge in the mirror direction of a surface so smooth that rounding of the angle decides: the error says so. */
static void test_rounding_is_stated(void **state)
{
    (void)state;
    const struct shape half = {4, {{0, -1, 2}, {1, -1, 2}, {1, 1, 2}, {0, 1, 2}}};
    const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 1)};
    struct rl_light_set *set = set_of(&half, 1);
    struct rl_estimate r = integrate(&s, 1e12, set, false, 1e-9);
    assert_true(fabs(r.value[0] - 0.5) <= r.error[0] && r.error[0] > 1e-6 && !r.converged);
    r = integrate(&s, 100.0, set, false, 1e-9);
    assert_true(fabs(r.value[0] - 0.5) <= 0.02 && r.error[0] <= 1e-9 && r.converged);
    rl_light_set_free(set);
}

/* R = 1, V = N, a square of half side a at height h overhead: D = cos(delta)/2, the edge at azimuth psi is seen at
 * tan(2 delta) = a/(h cos psi), so L_o = (4/pi) int_0^(pi/4) sin(atan(a/(h cos psi))/2) d psi. */
static double square_overhead(double psi, void *user)
{
    double ratio = *(double *)user;
    return 4.0 / RL_PI * sin(0.5 * atan(ratio / cos(psi)));
}

static void test_roughest(void **state)
{
    (void)state;
    for (int i = 0; i < 10; i++) {
        double ratio = 0.01 * pow(3.0, i);
        gsl_function f = {.function = square_overhead, .params = &ratio};
        double expected, error;
        size_t evaluations;
        gsl_integration_qng(&f, 0.0, RL_PI / 4.0, 1e-13, 0.0, &expected, &error, &evaluations);
        const struct shape square = {
            4, {{-ratio, -ratio, 1}, {ratio, -ratio, 1}, {ratio, ratio, 1}, {-ratio, ratio, 1}}};
        const struct rl_surface s = {v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 1)};
        check_near(value_of(&s, 1.0, &square, 1, false, 1e-12), expected, 1e-12);
    }
}

/* A small light far off: D(delta) G Omega / (pi 4 (V.H) |sin delta|). */
static void test_small_far_light(void **state)
{
    (void)state;
    struct dice d = dice_make(33);
    for (int i = 0; i < 100; i++) {
        struct rl_surface s = surface_point(&d, 0.1);
        rl_vec3 direction;
        do
            direction = unit_vector(&d);
        while (v3_dot(direction, s.N) < 0.1 || v3_dot(direction, v3_reflect(s.V, s.N)) > 0.98);
        rl_vec3 far = v3_madd(s.P, 1e4, direction);
        double rr = pow(10.0, uniform(&d, -0.3, 2.0));
        bool attenuation = i % 2;
        /* Facing the point, each vertex a metre from the middle: solid angle 2e-8 up to 1e-8 of itself. */
        struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, direction);
        struct shape quad = {4, {v3_add(far, f.T), v3_add(far, f.B), v3_sub(far, f.T), v3_sub(far, f.B)}};
        rl_vec3 H = v3_normalize(v3_add(direction, s.V));
        double n_h = v3_dot(s.N, H), v_h = v3_dot(s.V, H), sine = v3_length(v3_cross(s.N, H));
        struct rl_ellipsoid e = rl_ellipsoid_make(rr);
        double g = attenuation ? rl_attenuation(n_h, v3_dot(s.N, s.V), v3_dot(s.N, direction), v_h) : 1.0;
        double expected = rl_ellipsoid_pdf_sincos(&e, sine, n_h) * g * 2e-8 / (RL_PI * 4.0 * v_h * sine);
        check_relative(value_of(&s, rr, &quad, 1, attenuation, 1e-16), expected, 1e-6);
    }
}

static void test_symmetries(void **state)
{
    (void)state;
    struct dice d = dice_make(34);
    for (int i = 0; i < 200; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        double rr = pow(10.0, uniform(&d, -0.3, 2.4));
        bool attenuation = i % 2;
        struct shape shapes[1] = {polygon_about(&d, near_mirror(&d, &s, 0.8), 6, 0.8, 0.5, 0.2)};
        double whole = value_of(&s, rr, shapes, 1, attenuation, 1e-11);

        /* The other way round, from another vertex. */
        struct shape turned = {.n = 6};
        for (size_t j = 0; j < 6; j++)
            turned.vertex[j] = shapes[0].vertex[(10 - j) % 6];
        check_near(value_of(&s, rr, &turned, 1, attenuation, 1e-11), whole, 2e-11);

        /* Cut in two along a diagonal. */
        struct shape parts[2] = {{.n = 4}, {.n = 4}};
        for (size_t j = 0; j < 4; j++) {
            parts[0].vertex[j] = shapes[0].vertex[j];
            parts[1].vertex[j] = shapes[0].vertex[(j + 3) % 6];
        }
        double sum = value_of(&s, rr, &parts[0], 1, attenuation, 1e-11) +
                     value_of(&s, rr, &parts[1], 1, attenuation, 1e-11);
        check_near(sum, whole, 4e-11);
        check_near(value_of(&s, rr, parts, 2, attenuation, 1e-11), whole, 2e-11);

        /* The whole scene turned and moved. */
        struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, unit_vector(&d));
#define TURN(a) v3_madd(v3_madd(v3_scale((a).x, f.T), (a).y, f.B), (a).z, f.N)
        struct rl_surface moved = {v3_add(TURN(s.P), v3(3, -2, 1)), TURN(s.N), TURN(s.V)};
        for (size_t j = 0; j < 6; j++)
            turned.vertex[j] = v3_add(TURN(shapes[0].vertex[j]), v3(3, -2, 1));
#undef TURN
        check_near(value_of(&moved, rr, &turned, 1, attenuation, 1e-11), whole, 3e-11);
    }
}

/* A light that stands in front of another takes its place; the order in the scene does not matter. */
static void test_nearest_wins(void **state)
{
    (void)state;
    struct dice d = dice_make(35);
    for (int i = 0; i < 100; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        double rr = pow(10.0, uniform(&d, -0.3, 2.4));
        struct shape far = random_light(&d, &s), near = far;
        for (size_t j = 0; j < far.n; j++) /* the same outline as seen from P */
            near.vertex[j] = v3_madd(s.P, 0.5, v3_sub(far.vertex[j], s.P));
        const struct shape pair[2] = {far, near}, reversed[2] = {near, far};
        struct rl_light_set *a = lights_of(pair, (const double[]){1.0, 0.25}, 2);
        struct rl_light_set *b = lights_of(reversed, (const double[]){0.25, 1.0}, 2);
        double single = value_of(&s, rr, &near, 1, i % 2, 1e-10);
        check_near(integrate(&s, rr, a, i % 2, 1e-10).value[0], 0.25 * single, 2e-10);
        check_near(integrate(&s, rr, b, i % 2, 1e-10).value[0], 0.25 * single, 2e-10);
        rl_light_set_free(a);
        rl_light_set_free(b);
    }
}

static void test_nothing_to_see(void **state)
{
    (void)state;
    const struct shape quad = {4, {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    struct rl_light_set *set = set_of(&quad, 1), *empty = set_of(NULL, 0);
    const struct rl_surface turned = {v3(0, 0, 0), v3(0, 0, 1), v3(1, 0, -1e-9)};
    const struct rl_surface seen = {v3(0, 0, 0), v3(0, 0, 1), v3(0, 0, 1)};
    const struct rl_surface above = {v3(0, 0, 2), v3(0, 0, 1), v3(0, 0, 1)}; /* the light below the horizon */
    struct rl_estimate r = integrate(&turned, 3.0, set, true, 1e-6);
    assert_true(r.value[0] == 0.0 && r.error[0] == 0.0 && r.converged);
    r = integrate(&seen, 3.0, empty, true, 1e-6);
    assert_true(r.value[0] == 0.0 && r.converged);
    r = integrate(&above, 3.0, set, true, 1e-6);
    assert_true(r.value[0] == 0.0 && r.converged);
    r = integrate(&above, 3.0, set, false, 1e-6);
    assert_true(r.value[0] > 0.0);
    r = integrate(&seen, 3.0, set, true, 0.0);
    assert_false(r.converged);
    rl_light_set_free(set);
    rl_light_set_free(empty);

    const rl_vec3 bad[3] = {{0, 0, 1}, {NAN, 0, 1}, {0, 1, 1}};
    const rl_vec3 *vertices[1] = {bad};
    struct rl_error error;
    check_fails(rl_light_set_from_polygons(&set, vertices, (const size_t[]){2}, 1, &error), &error,
                RL_ERR_INPUT, "2 vertices");
    check_fails(rl_light_set_from_polygons(&set, vertices, (const size_t[]){3}, 1, &error), &error,
                RL_ERR_INPUT, "vertex 1");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_furnace),        cmocka_unit_test(test_furnace_in_the_printed_frame),
        cmocka_unit_test(test_mirror),         cmocka_unit_test(test_rounding_is_stated),
        cmocka_unit_test(test_roughest),       cmocka_unit_test(test_small_far_light),
        cmocka_unit_test(test_symmetries),     cmocka_unit_test(test_nearest_wins),
        cmocka_unit_test(test_nothing_to_see),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
