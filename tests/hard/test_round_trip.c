/* The ellipsoid distribution at and around its limits, in C and in GLSL: U to delta and back again, and a cdf that grows. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>

#include "model/ellipsoid.h"
#include "model/vec3.h"
#include "probe/probe.h"
#include "support/check.h"

#define LENGTH(a) (sizeof(a) / sizeof(a)[0])

static struct rl_gpu *gpu;

static int open_gpu(void **state)
{
    (void)state;
    struct rl_error error;
    return rl_gpu_open(&gpu, "auto", &error);
}

static int close_gpu(void **state)
{
    (void)state;
    rl_gpu_close(gpu);
    return 0;
}

/* Numbers of single precision, so that both backends get the same ones. */
static const float ratios[] = {
    1e-6f,  0.01f, 0.5f, 0.999f, 0.999999f, 1.0f - 0x1p-24f, 1.0f, 1.0f + 0x1p-23f, 1.000001f,
    1.001f, 2.0f,  1e3f, 1e6f,   1e12f};
static const float us[] = {0.0f,      0x1p-126f,       1e-30f, 1e-12f,          1e-6f,     1e-3f, 0.25f,
                           0.499999f, 0.5f - 0x1p-25f, 0.5f,   0.5f + 0x1p-24f, 0.500001f, 0.75f, 0.999f,
                           0.999999f, 1.0f - 0x1p-24f, 1.0f};
static const float deltas[] = {-1.57079625f, -1.57079f, -1.57f, -0.785398163f, -1e-3f, -1e-6f, -1e-12f,
                               0.0f,         1e-12f,    1e-6f,  1e-3f,         0.5f,   1.57f,  1.57079f};

enum { RUN = 16, PER_RATIO = LENGTH(deltas) * (RUN + 1) };

static void evaluate(const char *name, bool on_gpu, const double *rows, size_t n, double *results)
{
    struct rl_error error;
    struct rl_probe p;
    check_ok(rl_probe_find(&p, name, &error), &error);
    if (on_gpu)
        check_ok(rl_probe_gpu(&p, gpu, rows, n, results, &error), &error);
    else
        rl_probe_cpu(&p, rows, n, results);
}

/* delta is rounded on its way, which moves U by D times that; the rest are a few units in the last place. Where R < 1 an error of an ulp in
 * 2 u atanh(k) is one of atanh(k) ulps in U. */
static void round_trip(bool on_gpu)
{
    enum { N = LENGTH(ratios) * LENGTH(us) };
    static double there[N][2], delta[N][3], back[N][2], u[N], d[N];
    double epsilon = on_gpu ? FLT_EPSILON : DBL_EPSILON, worst = 0.0;
    for (size_t i = 0; i < N; i++) {
        there[i][0] = back[i][0] = (double)ratios[i / LENGTH(us)];
        there[i][1] = (double)us[i % LENGTH(us)];
    }
    evaluate("ellipsoid-inverse", on_gpu, there[0], N, delta[0]);
    for (size_t i = 0; i < N; i++)
        back[i][1] = fmin(fmax(delta[i][0], -0.5 * RL_PI), 0.5 * RL_PI);
    evaluate("ellipsoid-cdf", on_gpu, back[0], N, u);
    evaluate("ellipsoid-pdf", false, back[0], N, d);
    for (size_t i = 0; i < N; i++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(back[i][0]);
        double size = fabs(delta[i][0]), moved = d[i] * epsilon * fmax(size, on_gpu ? FLT_MIN : DBL_MIN);
        /* Near an end D itself changes by as much as the step is long. */
        double beside = rl_ellipsoid_pdf(&e, size - epsilon * size) * epsilon * size;
        double bound = (16.0 + (e.rr < 1.0 ? 2.0 * e.half_range : 0.0)) * epsilon *
                           fmax(there[i][1], on_gpu ? 0.1 : 0.0) +
                       2.0 * fmax(moved, beside);
        double off = fabs(u[i] - there[i][1]);
        if (!(off <= bound))
            print_error("%s: R_r %.9g, U %.9g: delta %.17g, back to %.17g, %.3g off, expected %.3g\n",
                        on_gpu ? "gpu" : "cpu", back[i][0], there[i][1], back[i][1], u[i], off, bound);
        assert_true(off <= bound);
        worst = fmax(worst, bound > 0.0 ? off / bound : 0.0);
    }
    print_message("%s: %.3g of the bound\n", on_gpu ? "gpu" : "cpu", worst);
}

/* From the deltas of the table in steps of one unit in the last place of single precision: what U falls by, in its own units, is at most what
 * rounding does, and from one entry of the table to the next it does not fall. */
static void monotone(bool on_gpu)
{
    enum { N = LENGTH(ratios) * PER_RATIO };
    static double rows[N][2], u[N];
    double epsilon = on_gpu ? FLT_EPSILON : DBL_EPSILON, worst = 0.0;
    for (size_t i = 0; i < N; i++) {
        rows[i][0] = (double)ratios[i / PER_RATIO];
        rows[i][1] = i % (RUN + 1) == 0 ? (double)deltas[i % PER_RATIO / (RUN + 1)]
                                        : (double)nextafterf((float)rows[i - 1][1], INFINITY);
    }
    evaluate("ellipsoid-cdf", on_gpu, rows[0], N, u);
    for (size_t i = 0; i < N; i++) {
        assert_true(u[i] >= 0.0 && u[i] <= 1.0);
        if (i % PER_RATIO == 0)
            continue;
        double fall = (u[i - 1] - u[i]) / (epsilon * u[i - 1]), allowed = i % (RUN + 1) == 0 ? 0.0 : 4.0;
        if (fall > allowed)
            print_error("%s: R_r %.9g: U falls by %.3g ulp from delta %.9g to %.9g\n", on_gpu ? "gpu" : "cpu",
                        rows[i][0], fall, rows[i - 1][1], rows[i][1]);
        assert_true(!(fall > allowed));
        worst = fmax(worst, fall);
    }
    print_message("%s: U falls by %.3g ulp at most\n", on_gpu ? "gpu" : "cpu", worst);
}

static void test_round_trip(void **state)
{
    (void)state;
    round_trip(false);
    round_trip(true);
}

static void test_monotone(void **state)
{
    (void)state;
    monotone(false);
    monotone(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_round_trip), cmocka_unit_test(test_monotone)};
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
