/* Fur: values by hand, integrals, reciprocity, and what happens where a fibre points to the light or the eye. */
#include "effects/lamp.h"

#include <string.h>

#include "model/fur.h"
#include "model/random.h"

static const rl_vec3 z = {0.0, 0.0, 1.0};
static const uint64_t seed = 815;

/* c: of goldman */
static void set_fur(struct lamp *lamp, const char *name, double diffuse, double specular, double exponent,
                    double c)
{
    double *value = lamp_values(lamp, name);
    for (int i = 0; i < 3; i++) {
        value[i] = diffuse;
        value[3 + i] = specular;
    }
    value[6] = exponent;
    if (strncmp(name, "goldman", 7) == 0)
        value[7] = c;
    lamp_pack(lamp);
}

static void test_by_hand(void **state)
{
    (void)state;
    struct lamp lamp;
    static const struct {
        const char *name;
        double diffuse, specular, exponent, c;
        rl_vec3 V, L;
        double expected;
    } rows[] = {
        /* |n x l| */
        {"kajiya", 0.5, 0, 8, 0, {0, 1, 1}, {0.6, 0, 0.8}, 0.3},
        {"kajiya", 0.5, 0, 8, 0, {0, 1, 1}, {0.6, 0, -0.8}, 0.3}, /* from below as well */
        {"kajiya", 0.5, 0, 8, 0, {0, 1, 1}, {0, 0, 1}, 0.0},
        /* the cone: light straight down the fibre's side, the eye on it at any angle about n */
        {"kajiya", 0, 0.5, 8, 0, {0, 1, 0}, {1, 0, 0}, 0.5},
        {"kajiya", 0, 0.5, 8, 0, {-1, 0, 0}, {1, 0, 0}, 0.5},
        {"kajiya", 0, 0.5, 8, 0, {0, 0.6, -0.8}, {0.6, 0, 0.8}, 0.5},
        {"kajiya", 0, 1.0, 2, 0, {0, 0.6, 0.8}, {0.6, 0, 0.8}, 0.0}, /* 0.36 - 0.64 < 0 */
        {"kajiya", 0, 1.0, 2, 0, {0, 0.8, 0.6}, {1, 0, 0}, 0.64},
        {"kajiya-printed", 0, 0.5, 8, 0, {0, 1, 0}, {1, 0, 0}, 0.5},
        {"kajiya-printed", 0, 1.0, 2, 0, {0, 0.6, 0.8}, {0.6, 0, 0.8}, 1.0},     /* cos(psi + theta) = -1 */
        {"kajiya-printed", 0, 1.0, 2, 0, {0, 0.6, -0.8}, {0.6, 0, 0.8}, 0.0784}, /* 0.64 - 0.36 = 0.28 */
        /* f_dir: kappa 1, -1, 0; f_surf 1 */
        {"goldman", 0.5, 0, 8, 1, {1, 0, 0}, {1, 0, 0}, 0.5},
        {"goldman", 0.5, 0, 8, 1, {-1, 0, 0}, {1, 0, 0}, 0.0},
        {"goldman", 0.5, 0, 8, -1, {-1, 0, 0}, {1, 0, 0}, 0.5},
        {"goldman", 0.5, 0, 8, 0.4, {0, 1, 0}, {1, 0, 0}, 0.25},
        {"goldman", 0.5, 0, 8, 0, {1, 0, 0}, {1, 0, 0}, 0.25},
        {"goldman", 0, 0.5, 8, 0.5, {1, 0, 0}, {1, 0, 0}, 0.375},
        /* f_surf: l.n = -0.6 hides, -0.28 in part, 0.8 not at all */
        {"goldman", 1, 0, 8, 1, {1, 0, 0}, {0.8, 0, -0.6}, 0.0},
        {"goldman", 1, 0, 8, 1, {1, 0, 0}, {0.96, 0, -0.28}, 0.96 * 0.44},
        {"goldman", 1, 0, 8, 1, {1, 0, 0}, {0.6, 0, 0.8}, 0.6},
        {"goldman-printed", 1, 0, 8, 1, {1, 0, 0}, {0.8, 0, -0.6}, 0.8 * -0.2},
        {"goldman-printed", 1, 0, 8, 1, {1, 0, 0}, {0.6, 0, 0.8}, 0.6 * 2.6},
        /* n parallel to l or e: kappa = 0 */
        {"goldman", 0, 1, 1, 1, {0, 0, -1}, {0, 0, 1}, 0.5},
        {"goldman", 1, 0, 1, 1, {0, 0, 1}, {1, 0, 0}, 0.5},
        /* |n x h| */
        {"lengyel", 0.5, 0, 8, 0, {0, 0, 1}, {0.6, 0, 0.8}, 0.3},
        {"lengyel", 0, 1, 2, 0, {1, 0, 0}, {1, 0, 0}, 1.0},
        {"lengyel", 0, 1, 2, 0, {0, 1, 0}, {1, 0, 0}, 0.5},
        {"lengyel", 0, 1, 2, 0, {-1, 0, 0}, {1, 0, 0}, 0.0},
        {"lengyel", 0, 1, 2, 0, {0, 0, 1}, {0, 0, 1}, 0.0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        set_fur(&lamp, rows[i].name, rows[i].diffuse, rows[i].specular, rows[i].exponent, rows[i].c);
        check_near(lamp_red(&lamp, z, rows[i].V, rows[i].L), rows[i].expected, 1e-14);
    }
}

/* A ball lit from the eye: the middle (n = l = e) glows as printed, since the power loses the sign, with either sign of the sines. */
static void test_glow(void **state)
{
    (void)state;
    struct lamp lamp;
    set_fur(&lamp, "kajiya", 0.0, 1.0, 8.0, 0.0);
    check_near(lamp_red(&lamp, z, z, z), 0.0, 0.0);
    set_fur(&lamp, "kajiya-printed", 0.0, 1.0, 8.0, 0.0);
    check_near(lamp_red(&lamp, z, z, z), 1.0, 0.0);
    double cos_difference = v3_dot(z, z) * -v3_dot(z, z) + rl_fur_sine(z, z) * rl_fur_sine(z, z);
    double cos_sum = v3_dot(z, z) * -v3_dot(z, z) - rl_fur_sine(z, z) * rl_fur_sine(z, z);
    check_near(cos_difference, -1.0, 0.0);
    check_near(cos_sum, -1.0, 0.0);
}

static void test_integrals(void **state)
{
    (void)state;
    struct lamp lamp;
    static const char *const names[] = {"kajiya", "kajiya-printed", "lengyel"};
    rl_vec3 V = {0.48, 0.6, 0.64};
    for (size_t i = 0; i < 3; i++) {
        set_fur(&lamp, names[i], 1.0, 0.0, 8.0, 0.0);
        check_relative(lamp_integral(&lamp, V, false, -1.0), RL_PI * RL_PI, 1e-3);
    }
    /* kappa is 0 on average: f_dir = 1/2 whatever c is; f_surf takes what is below -30 degrees and some: the integral of
     * sin^2(psi) f_surf over psi, by 10^5 midpoints. */
    double sum = 0.0;
    for (int i = 0; i < 100000; i++) {
        double psi = RL_PI * (i + 0.5) / 100000;
        sum += sin(psi) * sin(psi) * fmin(fmax(2.0 * cos(psi) + 1.0, 0.0), 1.0) * RL_PI / 100000;
    }
    for (int c = -2; c <= 2; c++) {
        set_fur(&lamp, "goldman", 1.0, 0.0, 8.0, 0.5 * c);
        check_relative(lamp_integral(&lamp, V, false, -1.0), RL_PI * sum, 1e-3);
    }
}

static void test_exchange(void **state)
{
    (void)state;
    static const char *const names[] = {"kajiya", "kajiya-printed", "lengyel"};
    uint64_t index = 0;
    print_message("seed %llu\n", (unsigned long long)seed);
    for (size_t i = 0; i < 3; i++)
        for (int k = 0; k < 1000; k++) {
            struct lamp lamp;
            set_fur(&lamp, names[i], 0.0, 1.0, 8.0, 0.0);
            double u[4];
            for (int j = 0; j < 4; j++)
                u[j] = rl_random_uniform(seed, index++);
            rl_vec3 a = lamp_direction(2.0 * u[0] - 1.0, 7.0 * u[1]),
                    b = lamp_direction(2.0 * u[2] - 1.0, 7.0 * u[3]);
            check_near(lamp_red(&lamp, z, a, b), lamp_red(&lamp, z, b, a), 1e-14);
        }
}

/* kappa is continuous where it has no meaning, and itself a hundredth of a degree away. */
static void test_kappa(void **state)
{
    (void)state;
    rl_vec3 e = {1.0, 0.0, 0.0};
    double before = rl_fur_kappa(z, z, e);
    check_near(before, 0.0, 0.0);
    for (int i = 0; i < 40; i++) {
        double angle = 1e-9 * pow(1.5, i);
        double kappa = rl_fur_kappa(z, v3(sin(angle), 0.0, cos(angle)), e);
        assert_true(kappa >= before && kappa <= 1.0 + 1e-15 && kappa - before < 0.4);
        before = kappa;
    }
    check_near(rl_fur_kappa(z, v3(sin(1.001e-4), 0.0, cos(1.001e-4)), e), 1.0, 1e-14);
    check_near(rl_fur_kappa(z, e, z), 0.0, 0.0);
    check_near(rl_fur_kappa(z, z, v3(0.0, 0.0, -1.0)), 0.0, 0.0);
}

/* Monochrome: the luminance of what it would be in colour. */
static void test_monochrome(void **state)
{
    (void)state;
    static const char *const names[] = {"kajiya", "kajiya-printed", "goldman", "goldman-printed", "lengyel"};
    const struct rl_surface s = {.N = v3_normalize(v3(0.2, 0.3, 1.0)), .V = v3_normalize(v3(1.0, 0.1, 0.4))};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        struct lamp lamp;
        double rgb[2][3], colours[6] = {0.1, 0.5, 0.9, 0.7, 0.2, 0.4};
        double *value = lamp_values(&lamp, names[i]);
        memcpy(value, colours, sizeof colours);
        if (strncmp(names[i], "goldman", 7) == 0)
            value[7] = 0.3;
        for (int on = 0; on < 2; on++) {
            value[rl_effect_values(lamp.effect) - 1] = on;
            lamp_pack(&lamp);
            lamp.effect->reflect(&s, v3_normalize(v3(-0.3, 1.0, 0.4)), lamp.params, rgb[on]);
        }
        double luminance = 0.2126 * rgb[0][0] + 0.7152 * rgb[0][1] + 0.0722 * rgb[0][2];
        for (int c = 0; c < 3; c++)
            check_near(rgb[1][c], luminance, 1e-15);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_hand),  cmocka_unit_test(test_glow),  cmocka_unit_test(test_integrals),
        cmocka_unit_test(test_exchange), cmocka_unit_test(test_kappa), cmocka_unit_test(test_monochrome),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
