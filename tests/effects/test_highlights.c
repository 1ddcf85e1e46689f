/* Highlights of point and parallel lights: values by hand, energy, reciprocity, and the corners. */
#include "effects/lamp.h"
#include "model/facets.h"
#include "model/fresnel.h"
#include "model/random.h"

static const rl_vec3 z = {0.0, 0.0, 1.0};
static const uint64_t seed = 4711;

static void set_lobe(struct lamp *lamp, const char *name, double k_s, double grazing, double exponent)
{
    double *value = lamp_values(lamp, name);
    value[0] = value[1] = value[2] = k_s;
    value[3] = grazing;
    value[4] = exponent;
    lamp_pack(lamp);
}

/* reflectance, or n and k */
static void set_facets(struct lamp *lamp, double reflectance, double n, double k, double m, int distribution)
{
    double *value = lamp_values(lamp, "cook-torrance");
    for (int c = 0; c < 3; c++) {
        value[c] = reflectance;
        value[3 + c] = n;
        value[6 + c] = k;
    }
    value[9] = m;
    value[10] = distribution;
    lamp_pack(lamp);
}

static void test_lobes_by_hand(void **state)
{
    (void)state;
    struct lamp lamp;
    static const struct {
        const char *name;
        double k_s, grazing, exponent;
        rl_vec3 V, L;
        double expected;
    } rows[] = {
        {"phong", 0.5, 0.0, 20.0, {1, 0, 1}, {-1, 0, 1}, 0.5}, /* in the mirror direction */
        {"phong", 0.5, 0.0, 2.0, {0, 0, 1}, {1, 0, 1}, 0.25},  /* gamma 45 degrees: cos^2 = 1/2 */
        {"phong", 0.5, 0.0, 6.0, {0, 0, 1}, {1, 0, 1}, 0.0625},
        {"phong", 0.0, 1.0, 2.0, {0, 0, 1}, {0.8, 0, 0.6}, 0.36 * 0.01024}, /* (1 - 0.6)^5 = 0.01024 */
        {"phong", 0.5, 1.0, 2.0, {0, 0, 1}, {0.8, 0, 0.6}, 0.36 * (0.5 + 0.5 * 0.01024)},
        {"phong", 1.0, 0.0, 2.0, {1, 0, 0.1}, {1, 0, 0.1}, 0.0}, /* gamma beyond 90 degrees */
        {"phong", 1.0, 0.0, 1.0, {1, 0, 1}, {1, 0, 0}, 0.0},     /* N.L = 0 */
        {"phong", 1.0, 0.0, 1.0, {0, 0, 1}, {0, 0, -1}, 0.0},    /* behind */
        {"blinn", 0.5, 0.0, 20.0, {1, 0, 1}, {-1, 0, 1}, 0.5},
        {"blinn", 0.5, 0.0, 2.0, {0, 0, 1}, {0.96, 0, 0.28}, 0.32}, /* cos(delta) = 0.8 */
        {"blinn",
         0.0,
         1.0,
         2.0,
         {0, 0, 1},
         {0.96, 0, 0.28},
         0.64 * 0.00032},                                      /* beta = delta here: (1 - 0.8)^5 */
        {"blinn", 1.0, 0.0, 1.0, {1, 0, 1}, {-1, 0, -1}, 0.0}, /* L = -V: no half vector */
        {"blinn", 1.0, 0.0, 1.0, {1, 0, 0}, {0, 0, 1}, 0.0},   /* N.V = 0 */
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        set_lobe(&lamp, rows[i].name, rows[i].k_s, rows[i].grazing, rows[i].exponent);
        check_near(lamp_red(&lamp, z, rows[i].V, rows[i].L), rows[i].expected, 1e-14);
    }
}

/* Integrals of cos^n over the hemisphere: 2 pi/(n + 1), and 2 pi/(n + 2) with one cosine more. */
static void test_lobes_integrals(void **state)
{
    (void)state;
    struct lamp lamp;
    static const double exponents[] = {1.0, 2.0, 10.0, 100.0};
    for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; i++) {
        double n = exponents[i];
        set_lobe(&lamp, "phong", 1.0, 0.0, n);
        check_relative(lamp_integral(&lamp, z, false, 0.0), 2.0 * RL_PI / (n + 1.0), 0.002);
        check_relative(lamp_integral(&lamp, z, true, 0.0), 2.0 * RL_PI / (n + 2.0), 0.002);
        /* delta is half of gamma: the integral of cos^n(gamma/2) over the hemisphere, 8 pi (1 - 2^-(n/2 + 1))/(n + 2) */
        set_lobe(&lamp, "blinn", 1.0, 0.0, n);
        check_relative(lamp_integral(&lamp, z, false, 0.0),
                       8.0 * RL_PI * (1.0 - exp2(-0.5 * n - 1.0)) / (n + 2.0), 0.002);
    }
}

static double fresnel_mean(double n, double k)
{
    return rl_fresnel(n, k, 1.0);
}

static void test_cook_torrance_by_hand(void **state)
{
    (void)state;
    struct lamp lamp;
    /* Along the normal G = 1: F D / 4 with D = 1/(pi m^2) of either distribution. */
    for (int distribution = 0; distribution < 2; distribution++) {
        set_facets(&lamp, 0.25, NAN, NAN, 0.5, distribution);
        check_relative(lamp_red(&lamp, z, z, z), 0.25 / (4.0 * RL_PI * 0.25), 1e-14);
        set_facets(&lamp, NAN, 0.2, 3.0, 0.5, distribution);
        check_relative(lamp_red(&lamp, z, z, z), fresnel_mean(0.2, 3.0) / RL_PI, 1e-14);
        /* The mirror direction at 60 degrees: G = 1, N.V = 1/2. */
        rl_vec3 V = {sqrt(3.0), 0.0, 1.0}, L = {-sqrt(3.0), 0.0, 1.0};
        check_relative(lamp_red(&lamp, z, V, L), rl_fresnel(0.2, 3.0, 0.5) * 2.0 / RL_PI, 1e-13);
        /* Below the horizon, behind, opposite. */
        check_near(lamp_red(&lamp, z, z, v3(1.0, 0.0, 0.0)), 0.0, 0.0);
        check_near(lamp_red(&lamp, z, v3(1.0, 0.0, 0.0), z), 0.0, 0.0);
        check_near(lamp_red(&lamp, z, z, v3(0.0, 0.0, -1.0)), 0.0, 0.0);
        /* No surface, no highlight. */
        set_facets(&lamp, NAN, 1.0, 0.0, 0.5, distribution);
        check_near(lamp_red(&lamp, z, V, L), 0.0, 0.0);
        set_facets(&lamp, 0.0, NAN, NAN, 0.5, distribution);
        check_near(lamp_red(&lamp, z, V, L), 0.0, 1e-16);
    }
}

/* f(L, V) = f(V, L), f the radiance over the irradiance on the surface. */
static void test_reciprocity(void **state)
{
    (void)state;
    struct lamp lamp[3];
    uint64_t index = 0;
    print_message("seed %llu\n", (unsigned long long)seed);
    set_lobe(&lamp[0], "blinn", 0.3, 1.0, 20.0);
    for (int d = 0; d < 2; d++)
        set_facets(&lamp[1 + d], NAN, 0.5, 2.0, 0.3, d);
    for (int i = 0; i < 1000; i++) {
        double a = rl_random_uniform(seed, index++), b = rl_random_uniform(seed, index++);
        rl_vec3 V = lamp_direction(a, 6.3 * rl_random_uniform(seed, index++));
        rl_vec3 L = lamp_direction(b, 6.3 * rl_random_uniform(seed, index++));
        /* Blinn's is a radiance that is the same either way. */
        double there = lamp_red(&lamp[0], z, V, L), back = lamp_red(&lamp[0], z, L, V);
        check_near(there, back, 1e-13 * (1.0 + there));
        for (int d = 1; d < 3; d++) {
            there = lamp_red(&lamp[d], z, V, L) * a;
            back = lamp_red(&lamp[d], z, L, V) * b;
            check_near(there, back, 1e-12 * there);
        }
    }
}

/* Radiance 1 from all round, by the facets: H drawn as D cos(delta) has it, L = 2 (V.H) H - V. */
static double furnace(struct lamp *lamp, double cos_v, double m, int distribution)
{
    enum { RINGS = 300, SPOKES = 100 };
    rl_vec3 V = lamp_direction(cos_v, 0.0);
    double sum = 0.0;
    for (int i = 0; i < RINGS; i++)
        for (int j = 0; j < SPOKES; j++) {
            double u = (i + 0.5) / RINGS;
            double tan_tan = distribution ? m * m * u / (1.0 - u) : -m * m * log1p(-u);
            double c = 1.0 / sqrt(1.0 + tan_tan), ss = tan_tan / (1.0 + tan_tan);
            rl_vec3 H = lamp_direction(c, 2.0 * RL_PI * (j + 0.5) / SPOKES);
            double d = distribution ? rl_facets_ellipsoid(c, ss, m) : rl_facets_beckmann(c, ss, m);
            double v_h = v3_dot(V, H);
            if (v_h > 0.0)
                sum += lamp_red(lamp, z, V, v3_reflect(V, H)) * 4.0 * v_h / (d * c);
        }
    return sum / (RINGS * (double)SPOKES);
}

/* Never more than came; nearly Fresnel's reflectance where it is smooth. */
static void test_energy(void **state)
{
    (void)state;
    static const double roughness[] = {0.001, 0.01, 0.1, 0.3, 0.6, 1.0, 3.0},
                        cosines[] = {1.0, 0.8, 0.5, 0.2, 0.05};
    struct lamp lamp;
    for (int d = 0; d < 2; d++)
        for (size_t i = 0; i < sizeof roughness / sizeof roughness[0]; i++)
            for (size_t j = 0; j < sizeof cosines / sizeof cosines[0]; j++) {
                set_facets(&lamp, 1.0, NAN, NAN, roughness[i], d);
                double white = furnace(&lamp, cosines[j], roughness[i], d);
                assert_true(white <= 1.0 + 1e-3 && white > 0.0);
                if (roughness[i] > 0.001 || (d == 1 && cosines[j] < 0.5))
                    continue;
                check_near(white, 1.0, 0.005);
                set_facets(&lamp, NAN, 1.5, 0.0, roughness[i], d);
                check_near(furnace(&lamp, cosines[j], roughness[i], d), rl_fresnel(1.5, 0.0, cosines[j]),
                           0.005);
            }
}

/* The ellipsoid of m = 1 along the normal: D = 1/pi, G = min(1, 2 cos 2 delta); sin^2(30 degrees) + 1/8. */
static void test_energy_by_hand(void **state)
{
    (void)state;
    struct lamp lamp;
    set_facets(&lamp, 1.0, NAN, NAN, 1.0, 1);
    check_near(furnace(&lamp, 1.0, 1.0, 1), 0.375, 1e-4);
    check_near(lamp_integral(&lamp, z, false, 0.0), 0.375, 1e-4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lobes_by_hand),
        cmocka_unit_test(test_lobes_integrals),
        cmocka_unit_test(test_cook_torrance_by_hand),
        cmocka_unit_test(test_reciprocity),
        cmocka_unit_test(test_energy),
        cmocka_unit_test(test_energy_by_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
