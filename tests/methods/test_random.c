/* `random`: whether the texels' normals follow D (a chi-square test against the integral of the density, not
 * against the cdf that drew them), and whether their weights give the right means, which a chi-square test
 * would not see. */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_integration.h>

#include <cmocka.h>

#include "methods/method.h"
#include "support/check.h"

enum { DELTAS = 24, THETAS = 12, TEXELS = 1 << 18 };

static const double ratios[] = {0.1, 0.5, 1.0, 1.0 + 1e-6, 3.0, 30.0, 1e6};
static const uint64_t seed = 20260103;

static struct rl_microfacet texel(const struct rl_ellipsoid *e, uint64_t index)
{
    return rl_method_find("random")->texel(e, seed, index);
}

static double density(double delta, void *ellipsoid)
{
    return rl_ellipsoid_pdf(ellipsoid, delta);
}

/* Edges of the bins of delta: narrow in the middle, where D is 1/R wide, and wider outwards. */
static double edge(double rr, int i)
{
    double scale = fmin(1.0, 1.0 / rr);
    double limit = asinh(0.5 * RL_PI / scale);
    return i == 0 ? -0.5 * RL_PI : i == DELTAS ? 0.5 * RL_PI : scale * sinh(limit * (2.0 * i / DELTAS - 1.0));
}

static double term(double count, double expected)
{
    return (count - expected) * (count - expected) / expected;
}

/* Bins too rare for the test are taken together. */
static double chi_square(int counts[DELTAS][THETAS], const double probability[DELTAS], int *cells)
{
    double chi2 = 0.0;
    double rare = 0.0;
    double rare_expected = 0.0;
    for (int i = 0; i < DELTAS; i++) {
        double expected = TEXELS * probability[i] / THETAS;
        for (int j = 0; j < THETAS; j++) {
            if (expected >= 5.0) {
                chi2 += term(counts[i][j], expected);
                (*cells)++;
            } else {
                rare += counts[i][j];
                rare_expected += expected;
            }
        }
    }
    if (rare_expected >= 5.0) {
        chi2 += term(rare, rare_expected);
        (*cells)++;
    }
    return chi2;
}

static void test_normals_follow_the_density(void **state)
{
    (void)state;
    print_message("seed %llu\n", (unsigned long long)seed);
    gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(200);
    for (size_t r = 0; r < sizeof ratios / sizeof ratios[0]; r++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(ratios[r]);
        gsl_function f = {density, &e};
        double edges[DELTAS + 1];
        double probability[DELTAS];
        for (int i = 0; i <= DELTAS; i++)
            edges[i] = edge(ratios[r], i);
        for (int i = 0; i < DELTAS; i++) {
            double bound = 0.0;
            gsl_integration_qag(&f, edges[i], edges[i + 1], 0.0, 1e-9, 200, GSL_INTEG_GAUSS31, workspace,
                                &probability[i], &bound);
        }
        int counts[DELTAS][THETAS] = {{0}};
        for (uint64_t t = 0; t < TEXELS; t++) {
            struct rl_microfacet m = texel(&e, t);
            /* theta in [0, pi): z has the sign of sin(delta) */
            double sign = m.z < 0.0 ? -1.0 : 1.0;
            double delta = atan2(sign * hypot(m.y, m.z), m.x);
            double theta = atan2(sign * m.z, sign * m.y);
            int i = 0;
            while (i < DELTAS - 1 && delta >= edges[i + 1])
                i++;
            int j = (int)(theta / RL_PI * THETAS);
            assert_in_range(j, 0, THETAS - 1);
            counts[i][j]++;
        }
        int cells = 0;
        double chi2 = chi_square(counts, probability, &cells);
        double p = gsl_cdf_chisq_Q(chi2, cells - 1);
        print_message("R %g: chi-square %.1f of %d cells, p %.3f\n", ratios[r], chi2, cells, p);
        assert_true(cells > DELTAS * THETAS / 2);
        assert_true(p > 1e-3 / 7.0);
    }
    gsl_integration_workspace_free(workspace);
}

/* E[cos delta] = pi (R - 1)/(2 k atan k) and E[sin^2 delta] = 1/(k atan k) - 1/k^2; with h = sqrt(1 - R^2)
 * for R < 1 pi (1 - R)/(2 h atanh h) and 1/h^2 - 1/(h atanh h); at R = 1 pi/4 and 1/3. */
static void expectations(const struct rl_ellipsoid *e, double *cosine, double *sine2)
{
    double k = e->k;
    if (fabs(e->rr - 1.0) < 1e-3) { /* the formulas cancel there */
        *cosine = 0.25 * RL_PI;
        *sine2 = 1.0 / 3.0;
    } else {
        *cosine = RL_PI * fabs(e->rr - 1.0) / (2.0 * k * e->half_range);
        *sine2 = fabs(1.0 / (k * e->half_range) - 1.0 / (k * k));
    }
}

static void test_means(void **state)
{
    (void)state;
    for (size_t r = 0; r < sizeof ratios / sizeof ratios[0]; r++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(ratios[r]);
        double x = 0.0;
        double y = 0.0;
        double z = 0.0;
        double y2 = 0.0;
        double z2 = 0.0;
        double yz = 0.0;
        for (uint64_t t = 0; t < TEXELS; t++) {
            struct rl_microfacet m = texel(&e, t);
            x += m.weight * m.x / TEXELS;
            y += m.weight * m.y / TEXELS;
            z += m.weight * m.z / TEXELS;
            y2 += m.weight * m.y * m.y / TEXELS;
            z2 += m.weight * m.z * m.z / TEXELS;
            yz += m.weight * m.y * m.z / TEXELS;
        }
        double cosine = 0.0;
        double sine2 = 0.0;
        expectations(&e, &cosine, &sine2);
        /* Variances: cos^2 = 1 - sin^2; y and z share sin^2; sin^4 is at most sin^2. */
        double bound = 4.5 / sqrt(TEXELS);
        check_near(x, cosine, bound * sqrt(1.0 - sine2 - cosine * cosine) + 1e-6);
        check_near(y, 0.0, bound * sqrt(0.5 * sine2));
        check_near(z, 0.0, bound * sqrt(0.5 * sine2));
        check_near(y2, 0.5 * sine2, bound * sqrt(sine2));
        check_near(z2, 0.5 * sine2, bound * sqrt(sine2));
        check_near(yz, 0.0, bound * sqrt(sine2));
    }
}

static void test_texels(void **state)
{
    (void)state;
    for (size_t r = 0; r < sizeof ratios / sizeof ratios[0]; r++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(ratios[r]);
        for (uint64_t t = 0; t < 10000; t++) {
            struct rl_microfacet m = texel(&e, t);
            check_near(m.x * m.x + m.y * m.y + m.z * m.z, 1.0, 8.0 * DBL_EPSILON);
            assert_true(m.x >= 0.0);
            check_near(m.weight, 1.0, 0.0);
        }
        /* The same texel twice, another texel, another seed. */
        const struct rl_method *random = rl_method_find("random");
        assert_true(random->texel(&e, 1, 7).z == random->texel(&e, 1, 7).z);
        assert_true(random->texel(&e, 1, 7).z != random->texel(&e, 1, 8).z);
        assert_true(random->texel(&e, 1, 7).z != random->texel(&e, 2, 7).z);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_normals_follow_the_density),
        cmocka_unit_test(test_means),
        cmocka_unit_test(test_texels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
