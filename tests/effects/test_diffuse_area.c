/* The exact irradiance of polygon lights against closed forms, an integral over directions, and the sum over its parts. */
#include "effects/lamp.h"
#include "model/random.h"

static const uint64_t seed = 1760;
static const rl_vec3 origin = {0.0, 0.0, 0.0}, z = {0.0, 0.0, 1.0};

/* E over pi: the form factor of a patch at P with normal N, of a polygon of radiance 1. */
static double form_factor(rl_vec3 P, rl_vec3 N, const rl_vec3 *vertex, int n)
{
    struct lamp lamp;
    double rgb[3], *value = lamp_values(&lamp, "diffuse-area");
    const struct rl_surface s = {.P = P, .N = v3_normalize(N), .V = v3_normalize(N)};
    value[0] = value[1] = value[2] = 1.0;
    lamp_pack(&lamp);
    lamp.effect->area(&s, vertex, n, lamp.params, rgb);
    return rgb[0];
}

static void rectangle(rl_vec3 to[4], rl_vec3 corner, rl_vec3 u, rl_vec3 v)
{
    to[0] = corner;
    to[1] = v3_add(corner, u);
    to[2] = v3_add(to[1], v);
    to[3] = v3_add(corner, v);
}

/* A corner right above P: rectangle a x b parallel to the patch at height c (Howell's catalogue, B-4), and one that stands on the patch's
 * plane, height a, width b, at distance c (B-5). */
static double parallel(double a, double b, double c)
{
    double x = a / c, y = b / c, rx = sqrt(1.0 + x * x), ry = sqrt(1.0 + y * y);
    return (x / rx * atan(y / rx) + y / ry * atan(x / ry)) / (2.0 * RL_PI);
}

static double perpendicular(double a, double b, double c)
{
    double x = a / b, y = c / b, r = sqrt(x * x + y * y);
    return (atan(1.0 / y) - y / r * atan(1.0 / r)) / (2.0 * RL_PI);
}

static void test_rectangles(void **state)
{
    (void)state;
    static const double size[][3] = {{1, 1, 1},       {2, 0.5, 1},     {100, 100, 0.1},
                                     {0.01, 0.02, 1}, {1e-4, 1e-4, 1}, {1, 3, 7}};
    for (size_t i = 0; i < sizeof size / sizeof size[0]; i++) {
        double a = size[i][0], b = size[i][1], c = size[i][2];
        rl_vec3 r[4];
        rectangle(r, v3(0, 0, c), v3(a, 0, 0), v3(0, b, 0));
        /* Absolute: the sum over edges cancels, from angles of the size of the light. */
        check_near(form_factor(origin, z, r, 4), parallel(a, b, c), 1e-16 + 4e-16 * (a + b) / c);
        rectangle(r, v3(c, 0, 0), v3(0, b, 0), v3(0, 0, a));
        check_near(form_factor(origin, z, r, 4), perpendicular(a, b, c), 1e-15);
        /* Half of a wall twice as high is below the horizon; order and winding do not matter, nor does moving all of it. */
        rectangle(r, v3(c, 0, -a), v3(0, b, 0), v3(0, 0, 2 * a));
        check_near(form_factor(origin, z, r, 4), perpendicular(a, b, c), 1e-15);
        rl_vec3 turned[4] = {r[1], r[0], r[3], r[2]};
        check_near(form_factor(origin, z, turned, 4), perpendicular(a, b, c), 1e-15);
        for (int k = 0; k < 4; k++)
            turned[k] = v3_add(r[k], v3(3, -2, 5));
        check_near(form_factor(v3(3, -2, 5), z, turned, 4), perpendicular(a, b, c), 1e-12);
    }
}

/* Where something is 0 or undefined. */
static void test_corners(void **state)
{
    (void)state;
    rl_vec3 r[4];
    rectangle(r, v3(-1, -1, -2), v3(2, 0, 0), v3(0, 2, 0)); /* below */
    check_near(form_factor(origin, z, r, 4), 0.0, 0.0);
    rectangle(r, v3(1, -1, 0), v3(2, 0, 0), v3(0, 2, 0)); /* in the horizon */
    check_near(form_factor(origin, z, r, 4), 0.0, 0.0);
    rectangle(r, v3(-1, -1, 0), v3(2, 0, 0), v3(0, 2, 0)); /* P in it, N across it */
    check_near(form_factor(origin, z, r, 4), 0.0, 0.0);
    rectangle(r, v3(1, 0, 1), v3(2, 0, 0), v3(0, 0, 2)); /* seen edge on */
    check_near(form_factor(origin, z, r, 4), 0.0, 1e-16);
    rectangle(r, v3(0, 0, 0), v3(1, 0, 0), v3(0, 0, 1)); /* P a corner, and on an edge */
    check_near(form_factor(origin, z, r, 4), 0.0, 1e-15);
    rectangle(r, v3(-1, 0, 0), v3(2, 0, 0), v3(0, 0, 1));
    assert_true(isfinite(form_factor(origin, z, r, 4)));
    /* Just under a huge light: all of the sky. */
    rectangle(r, v3(-1, -1, 1e-9), v3(2, 0, 0), v3(0, 2, 0));
    check_near(form_factor(origin, z, r, 4), 1.0, 1e-8);
    /* A vertex on the horizon, an edge in it. */
    const rl_vec3 triangle[3] = {{1, -1, 0}, {1, 1, 0}, {1, 0, 1}},
                  up[3] = {{1, 0, 0}, {1, 1, 1}, {1, -1, 1}};
    const rl_vec3 lower[3] = {{1, -1, 1e-14}, {1, 1, 1e-14}, {1, 0, 1}},
                  lifted[3] = {{1, 0, -1e-14}, {1, 1, 1}, {1, -1, 1}};
    check_near(form_factor(origin, z, triangle, 3), form_factor(origin, z, lower, 3), 1e-13);
    check_near(form_factor(origin, z, up, 3), form_factor(origin, z, lifted, 3), 1e-13);
}

/* Six sides of a box about P: all of the sky above the horizon, whatever N is. */
static void test_furnace(void **state)
{
    (void)state;
    uint64_t index = 0;
    print_message("seed %llu\n", (unsigned long long)seed);
    for (int i = 0; i < 200; i++) {
        double u[5], sum = 0.0;
        for (int k = 0; k < 5; k++)
            u[k] = 2.0 * rl_random_uniform(seed, index++) - 1.0;
        rl_vec3 P = v3(0.9 * u[2], 0.9 * u[3], 0.9 * u[4]), N = lamp_direction(u[0], RL_PI * u[1]);
        for (int axis = 0; axis < 3; axis++)
            for (int sign = -1; sign <= 1; sign += 2) {
                double c[3] = {-1, -1, -1}, a[3] = {0}, b[3] = {0};
                c[axis] = sign;
                a[(axis + 1) % 3] = b[(axis + 2) % 3] = 2.0;
                rl_vec3 r[4];
                rectangle(r, v3(c[0], c[1], c[2]), v3(a[0], a[1], a[2]), v3(b[0], b[1], b[2]));
                sum += form_factor(P, N, r, 4);
            }
        check_near(sum, 1.0, 1e-14);
    }
}

/* A star of many crossings of the horizon: the sum of its triangles about the middle, each alone. And of concave polygons that is the
 * whole test, for a triangle cannot be. */
static void test_parts(void **state)
{
    (void)state;
    enum { POINTS = 12 };
    uint64_t index = 1000;
    for (int i = 0; i < 500; i++) {
        double u[8];
        for (int k = 0; k < 8; k++)
            u[k] = 2.0 * rl_random_uniform(seed, index++) - 1.0;
        rl_vec3 centre = v3(2 * u[0], 2 * u[1], u[2]), a = v3_normalize(v3(u[3], u[4], u[5])),
                b = v3_cross(a, v3_normalize(v3(u[6], u[7], 0.3))), star[POINTS];
        double sum = 0.0;
        for (int k = 0; k < POINTS; k++) {
            double angle = 2.0 * RL_PI * k / POINTS, r = k % 2 ? 0.3 : 1.5;
            star[k] = v3_madd(v3_madd(centre, r * cos(angle), a), r * sin(angle), b);
        }
        for (int k = 0; k < POINTS; k++) {
            const rl_vec3 part[3] = {centre, star[k], star[(k + 1) % POINTS]};
            sum += form_factor(origin, z, part, 3);
        }
        check_near(form_factor(origin, z, star, POINTS), sum, 1e-13);
    }
}

/* One triangle across the horizon against 10^6 directions. */
static void test_directions(void **state)
{
    (void)state;
    enum { RINGS = 1000, SPOKES = 1000 };
    const rl_vec3 t[3] = {{1.0, -1.0, -0.5}, {1.5, 1.0, 0.3}, {0.2, 0.4, 1.2}};
    double sum = 0.0;
    for (int i = 0; i < RINGS; i++)
        for (int j = 0; j < SPOKES; j++) {
            double cc = (i + 0.5) / RINGS; /* of cos^2: each is as good as the next to Lambert */
            rl_vec3 d = lamp_direction(sqrt(cc), 2.0 * RL_PI * (j + 0.5) / SPOKES);
            double w[3];
            for (int k = 0; k < 3; k++)
                w[k] = v3_dot(d, v3_cross(t[k], t[(k + 1) % 3]));
            double side = v3_dot(t[0], v3_cross(t[1], t[2]));
            sum += w[0] * side > 0.0 && w[1] * side > 0.0 && w[2] * side > 0.0;
        }
    check_near(form_factor(origin, z, t, 3), sum / (RINGS * (double)SPOKES), 1e-4);
}

/* Far away it is what the effect diffuse takes it for. */
static void test_far(void **state)
{
    (void)state;
    rl_vec3 r[4];
    rectangle(r, v3(600, -0.5, 800), v3(0.6, 0, -0.8), v3(0, 1, 0)); /* r = 1000, cosine 0.96 at it */
    check_relative(form_factor(origin, z, r, 4), 0.8 * 0.96 / 1e6 / RL_PI, 2e-3);
}

/* Irradiance has no unit of length. */
static void test_sizes(void **state)
{
    (void)state;
    for (int e = -307; e <= 307; e++) {
        double size = pow(10.0, e);
        const rl_vec3 vertex[] = {v3(size, 0.0, size), v3(0.0, size, size), v3(-size, -size, size)};
        double value = form_factor(origin, z, vertex, 3);
        if (!(fabs(value - 0.3003491900968692) < 1e-15))
            fail_msg("sized 1e%d: %.17g, expected 0.3003491900968692", e, value);
    }
    /* Differences beyond the range of numbers. */
    const rl_vec3 far[] = {v3(1.7e308, 0.0, 1.7e308), v3(0.0, 1.7e308, 1.7e308),
                           v3(-1.7e308, -1.7e308, 1.7e308)};
    assert_true(fabs(form_factor(origin, z, far, 3) - 0.3003491900968692) < 1e-15);
    assert_true(isfinite(form_factor(v3(0.0, 0.0, -1.7e308), z, far, 3)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rectangles), cmocka_unit_test(test_corners),    cmocka_unit_test(test_furnace),
        cmocka_unit_test(test_parts),      cmocka_unit_test(test_directions), cmocka_unit_test(test_sizes),
        cmocka_unit_test(test_far),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
