/* `margin auto`: that the sphere it gives has the angular radius of the derivation in margin.h, and that what the derivation
 * promises is so: the loss is integrated over directions, lights and roughness taken at random. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "model/ellipsoid.h"
#include "model/frame.h"
#include "model/random.h"
#include "scene/margin.h"
#include "support/check.h"

/* One object about the origin and lights that are spheres: all that the margin looks at. */
struct world {
    struct rl_scene scene;
    struct rl_object object;
    struct rl_light light[2];
    struct rl_plan_material material;
    struct rl_settings settings;
};

static void make(struct world *w, double rr, double r, double d)
{
    memset(w, 0, sizeof *w);
    w->object.radius = 1.0;
    w->light[0].centre = v3(0.0, d, 0.0);
    w->light[0].radius = r;
    w->light[1] = w->light[0];
    w->scene.n_objects = w->scene.n_lights = 1;
    w->scene.object = &w->object;
    w->scene.light = w->light;
    w->material.rr = rr;
    w->material.method = rl_method_find("random");
    w->settings = RL_SETTINGS_DEFAULT;
    w->settings.normal_bits = RL_NORMAL_BITS_FLOAT;
    w->settings.env_size = 4096;
}

/* The angular radius of the light's sphere with its margin, from the object's centre. */
static double sphere_angle(const struct world *w, double loss)
{
    double m = rl_margin_auto(&w->scene, &w->material, &w->settings, loss);
    return asin(fmin(1.0, (1.0 + m) * w->light[0].radius / v3_length(w->light[0].centre)));
}

/* The share of the lobe that meets the cap of angular radius a about u above the horizon of N = +z. */
static double weight_in_cap(double rr, rl_vec3 V, rl_vec3 u, double a)
{
    enum { LINES = 120, STEPS = 1500 };
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    size_t inside = 0;
    for (int j = 0; j < STEPS; j++) {
        struct rl_delta d = rl_ellipsoid_inverse(&e, (j + 0.5) / STEPS);
        for (int i = 0; i < LINES; i++) {
            double theta = RL_PI * (i + 0.5) / LINES;
            rl_vec3 H = v3(d.sin_delta * cos(theta), d.sin_delta * sin(theta), d.cos_delta);
            rl_vec3 L = v3_sub(v3_scale(2.0 * v3_dot(V, H), H), V);
            inside += L.z > 0.0 && v3_dot(L, u) >= cos(a);
        }
    }
    return (double)inside / (LINES * STEPS);
}

/* A direction at the angle `angle` from `axis`, at the azimuth phi about it. */
static rl_vec3 beside(rl_vec3 axis, double angle, double phi)
{
    struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, axis);
    rl_vec3 across = v3_add(v3_scale(cos(phi), f.T), v3_scale(sin(phi), f.B));
    return v3_add(v3_scale(cos(angle), axis), v3_scale(sin(angle), across));
}

/* Just outside of the sphere, whatever the direction, the loss is within its bound: for one light on one side of each line.
 * Rough materials and large losses go where b_1 of the derivation decides. */
static void test_bound(void **state)
{
    (void)state;
    enum { TRIES = 300 };
    static const double losses[] = {0.005, 0.02, 0.1, 0.3};
    size_t tried = 0;
    double fullest = 0.0;
    for (uint64_t k = 0; k < TRIES; k++) {
        double x[6];
        for (uint64_t i = 0; i < 6; i++)
            x[i] = rl_random_uniform(7, 6 * k + i);
        double rr = exp(x[0] * log(1000.0)), loss = losses[k % 4], d = 10.0;
        double a = 0.02 + 1.2 * x[1];
        struct world w;
        make(&w, rr, d * sin(a), d);
        double angle = sphere_angle(&w, loss);
        if (!(angle < 0.5 * RL_PI - 1e-9))
            continue;
        double v = acos(x[2]);
        rl_vec3 V = v3(sin(v), 0.0, cos(v)), R = v3(-V.x, 0.0, V.z);
        rl_vec3 u = beside(R, angle + 1e-6, 2.0 * RL_PI * x[3]);
        double weight = weight_in_cap(rr, V, u, a);
        /* The grid of lines and steps decides a few hundredths of the weight. */
        if (!(weight <= loss * 1.05 + 1e-3))
            fail_msg("R_r %g, a %g, loss %g: %g", rr, a, loss, weight);
        fullest = fmax(fullest, weight / loss);
        tried++;
    }
    print_message("%zu of %d had a sphere; at most %g of the bound\n", tried, TRIES, fullest);
    assert_true(tried > 60 && fullest > 0.3);
}

/* a + b as the header has it, with the map's texel and the normals' rounding. */
static void test_angle(void **state)
{
    (void)state;
    static const struct {
        double rr, r, d;
        int normal_bits, env_size;
        size_t n_lights;
    } row[] = {
        {100.0, 1.0, 4.0, RL_NORMAL_BITS_FLOAT, 4096, 1},
        {100.0, 1.0, 4.0, 8, 256, 1},
        {1000.0, 2.0, 4.0, 8, 64, 1},
        {1e5, 0.01, 4.0, 5, 256, 1},
        {300.0, 1.0, 4.0, RL_NORMAL_BITS_HALF, 256, 2},
        {100.0, 1.0, 4.0, 10, 1024, 2},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct world w;
        make(&w, row[i].rr, row[i].r, row[i].d);
        w.settings.normal_bits = row[i].normal_bits;
        w.settings.env_size = row[i].env_size;
        w.scene.n_lights = row[i].n_lights;
        double rounding = row[i].normal_bits == RL_NORMAL_BITS_FLOAT ? pow(2.0, -24.0)
                          : row[i].normal_bits == RL_NORMAL_BITS_HALF
                              ? pow(2.0, -11.0)
                              : 1.0 / (pow(2.0, row[i].normal_bits) - 1.0);
        if (row[i].normal_bits == 5)
            rounding += 1.0 / 65535.0;
        double a = asin(row[i].r / row[i].d) + sqrt(2.0) / row[i].env_size + 2.0 * asin(sqrt(3.0) * rounding);
        struct rl_ellipsoid e = rl_ellipsoid_make(row[i].rr);
        double both = 2.0 * rl_ellipsoid_inverse(&e, 0.99).delta,
               one = 2.0 * rl_ellipsoid_inverse(&e, 0.98).delta;
        double side = acos(cos(a) - sin(a) * sin(a)) - a;
        double b = row[i].n_lights == 2 ? both : fmin(both, fmax(one, side));
        check_near(sphere_angle(&w, 0.02), a + b, 1e-9);
    }
}

/* Without a map each point sees the light from where it is: from every point of the object the sphere covers a + b. */
static void test_from_points(void **state)
{
    (void)state;
    struct rl_method method = *rl_method_find("random");
    method.needs_environment = false;
    struct world w;
    make(&w, 300.0, 1.0, 3.0);
    w.material.method = &method;
    double sphere = 1.0 + rl_margin_auto(&w.scene, &w.material, &w.settings, 0.02);
    struct rl_ellipsoid e = rl_ellipsoid_make(300.0);
    double wider = 2.0 * asin(sqrt(3.0) * pow(2.0, -24.0)), b = 2.0 * rl_ellipsoid_inverse(&e, 0.99).delta;
    for (int i = 101; i <= 400; i++) {
        double d = 0.01 * i;
        assert_true(sphere >= d || asin(sphere / d) >= asin(1.0 / d) + wider + b - 1e-9);
    }
    assert_true(asin(sphere / 4.0) <= asin(1.0 / 4.0) + wider + b + 1e-9); /* and no more than needed */
}

/* No sphere where it would have to be as wide as a half space, nor about an object inside of the light; the wider loss has the
 * smaller sphere. */
static void test_limits(void **state)
{
    (void)state;
    struct world w;
    make(&w, 3.0, 1.0, 4.0);
    assert_true(isinf(rl_margin_auto(&w.scene, &w.material, &w.settings, 0.02)));
    make(&w, 1e6, 5.0, 4.0);
    assert_true(isinf(rl_margin_auto(&w.scene, &w.material, &w.settings, 0.02)));
    make(&w, 1e6, 1.0, 4.0);
    double narrow = rl_margin_auto(&w.scene, &w.material, &w.settings, 0.1);
    assert_true(narrow >= 0.0 && narrow <= rl_margin_auto(&w.scene, &w.material, &w.settings, 0.001));
    w.light[1].radius = 0.1; /* the smaller light needs the larger multiple */
    w.scene.n_lights = 2;
    assert_true(rl_margin_auto(&w.scene, &w.material, &w.settings, 0.02) > narrow);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bound),
        cmocka_unit_test(test_angle),
        cmocka_unit_test(test_from_points),
        cmocka_unit_test(test_limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
