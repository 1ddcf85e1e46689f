/* Properties of the ellipsoid distribution over a million random inputs a function: range, symmetry, order, and that the inverse is one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "hard/draw.h"
#include "hard/property.h"
#include "model/ellipsoid.h"

enum { ROWS = 1000000 };
static const uint64_t seed = 20261126;

/* What the functions are documented to keep to (ellipsoid.h). */
static const double bound = 8.0 * ULP;

static const double half_pi = 0.5 * RL_PI;

static struct draw begin(uint64_t stream)
{
    print_message("seed %llu, stream %llu\n", (unsigned long long)seed, (unsigned long long)stream);
    return (struct draw){.seed = seed, .index = stream << 40};
}

static void test_pdf(void **state)
{
    (void)state;
    struct draw d = begin(1);
    for (int i = 0; i < ROWS; i++) {
        const double in[] = {draw_between(&d, RL_RR_MIN, RL_RR_MAX), draw_between(&d, -half_pi, half_pi)};
        struct rl_ellipsoid e = rl_ellipsoid_make(in[0]);
        double pdf = rl_ellipsoid_pdf(&e, in[1]);
        require(pdf > 0.0 && pdf < INFINITY, in, 2);
        require(rl_ellipsoid_pdf(&e, -in[1]) == pdf, in, 2);
        /* Smooth: the peak is at 0. Rough: two peaks at the ends, no more than norm/(2R) high. */
        require(pdf <= (1.0 + bound) * e.norm * fmax(1.0, 0.5 / e.rr + 0.5), in, 2);
    }
}

static void test_cdf(void **state)
{
    (void)state;
    struct draw d = begin(2);
    double worst = 0.0;
    for (int i = 0; i < ROWS; i++) {
        const double in[] = {draw_between(&d, RL_RR_MIN, RL_RR_MAX), draw_between(&d, -half_pi, half_pi),
                             draw_below(&d, 4) ? draw_between(&d, -half_pi, half_pi)
                                               : draw_neighbour(&d, 0.0)};
        struct rl_ellipsoid e = rl_ellipsoid_make(in[0]);
        double u = rl_ellipsoid_cdf(&e, in[1]);
        require(u >= 0.0 && u <= 1.0, in, 2);
        require(1.0 - rl_ellipsoid_cdf(&e, -fabs(in[1])) == rl_ellipsoid_cdf(&e, fabs(in[1])), in, 2);
        double beside = nextafter(in[1], in[2]);
        const double other[] = {in[2], fmin(fmax(beside, -half_pi), half_pi)};
        for (int k = 0; k < 2; k++) {
            double v = rl_ellipsoid_cdf(&e, other[k]);
            double fall = other[k] >= in[1] ? u - v : v - u;
            worst = fmax(worst, fall / fmax(u, v));
            require(fall <= 2.0 * bound * fmax(u, v), in, 3);
        }
    }
    print_message("farthest out of order: %.2g ulp, expected at most 16\n", worst / ULP);
}

static void test_inverse(void **state)
{
    (void)state;
    struct draw d = begin(3);
    for (int i = 0; i < ROWS; i++) {
        const double in[] = {draw_between(&d, RL_RR_MIN, RL_RR_MAX), draw_between(&d, 0.0, 1.0),
                             draw_between(&d, 0.0, 1.0)};
        struct rl_ellipsoid e = rl_ellipsoid_make(in[0]);
        struct rl_delta x = rl_ellipsoid_inverse(&e, in[1]);
        require(fabs(x.delta) <= half_pi && fabs(x.sin_delta) <= 1.0, in, 2);
        require(x.cos_delta >= 0.0 && x.cos_delta <= 1.0, in, 2);
        require(fabs(x.sin_delta * x.sin_delta + x.cos_delta * x.cos_delta - 1.0) <= 4.0 * ULP, in, 2);
        if (in[1] >= 0.5) {
            struct rl_delta y = rl_ellipsoid_inverse(&e, 1.0 - in[1]);
            require(x.delta == -y.delta && x.sin_delta == -y.sin_delta && x.cos_delta == y.cos_delta, in, 2);
        }
        const double other[] = {in[2], nextafter(in[1], in[2])};
        for (int k = 0; k < 2; k++) {
            struct rl_delta y = rl_ellipsoid_inverse(&e, other[k]);
            double fall = other[k] >= in[1] ? x.delta - y.delta : y.delta - x.delta;
            require(fall <= 2.0 * bound * fmax(fabs(x.delta), fabs(y.delta)), in, 3);
        }
    }
}

/* U of delta of U. An ulp in the sine and cosine, and in x = 2 U A, is one of A ulps in U where sinh(x) grows like e^x. */
static void test_round_trip(void **state)
{
    (void)state;
    struct draw d = begin(4);
    double worst = 0.0;
    for (int i = 0; i < ROWS; i++) {
        const double in[] = {draw_between(&d, RL_RR_MIN, RL_RR_MAX), draw_between(&d, 0.0, 1.0)};
        struct rl_ellipsoid e = rl_ellipsoid_make(in[0]);
        struct rl_delta x = rl_ellipsoid_inverse(&e, in[1]);
        double u = rl_ellipsoid_cdf_sincos(&e, x.sin_delta, x.cos_delta);
        double off = fabs(u - in[1]) / in[1], allowed = 2.0 * bound;
        if (in[0] < 1.0)
            allowed += 2.0 * e.half_range * ULP;
        worst = fmax(worst, in[1] > 1e-290 ? off / allowed : 0.0);
        /* cos^2 ends where U does. */
        require(off <= allowed || in[1] < 1e-290, in, 2);
    }
    print_message("of what is allowed: %.2g\n", worst);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pdf),
        cmocka_unit_test(test_cdf),
        cmocka_unit_test(test_inverse),
        cmocka_unit_test(test_round_trip),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
