/* The closed forms along one line, against quadrature of D G as the model defines them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <gsl/gsl_integration.h>

#include <cmocka.h>

#include "model/attenuation.h"
#include "model/vec3.h"
#include "reference/inner.h"
#include "support/check.h"

#define LENGTH(a) (sizeof(a) / sizeof(a)[0])

static const double ratios[] = {1e-3,   0.1,    0.5, 0.7, 0.9999, 1.0,   1.0 + 1e-9,
                                1.0149, 1.0151, 1.5, 3.0, 30.0,   300.0, 1e5};
static const double phis[] = {-1.55, -1.0, -0.8, -0.3, 0.0, 0.2, 0.7853, 0.7855, 1.2, 1.5};
static const double stretches[] = {1.0, 0.9, 0.5, 0.01};

struct integrand {
    struct rl_ellipsoid e;
    double stretch, v_t, v_n;
    bool attenuation;
};

/* D G at delta, G at the normal's own angle; from the definitions. */
static double density_times_g(double delta, void *user)
{
    const struct integrand *w = user;
    double normal = atan(w->stretch * tan(delta));
    double n_h = cos(normal), v_h = w->v_n * cos(normal) + w->v_t * sin(normal),
           n_l = 2.0 * v_h * n_h - w->v_n;
    return rl_ellipsoid_pdf(&w->e, delta) * (w->attenuation ? rl_attenuation(n_h, w->v_n, n_l, v_h) : 1.0);
}

static double quadrature(struct integrand *w, double a, double b, gsl_integration_workspace *workspace)
{
    gsl_function f = {.function = density_times_g, .params = w};
    double value, error;
    gsl_integration_qag(&f, a, b, 1e-14, 1e-13, 2000, GSL_INTEG_GAUSS31, workspace, &value, &error);
    return value;
}

static struct rl_angle angle_of(double delta)
{
    return (struct rl_angle){sin(delta), cos(delta)};
}

static double delta_of(struct rl_angle a)
{
    return atan2(a.s, a.c);
}

struct one_case {
    struct integrand w;
    struct rl_inner_line line;
};

/* Calls `check` for every combination of the tables. */
static void for_all(void (*check)(struct one_case *c, gsl_integration_workspace *workspace))
{
    gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(2000);
    for (size_t i = 0; i < LENGTH(ratios); i++)
        for (size_t j = 0; j < LENGTH(phis); j++)
            for (size_t k = 0; k < LENGTH(stretches); k++) {
                struct one_case c = {.w = {.e = rl_ellipsoid_make(ratios[i]),
                                           .stretch = stretches[k],
                                           .v_t = 0.8 * sin(phis[j]),
                                           .v_n = 0.8 * cos(phis[j]),
                                           .attenuation = true}};
                rl_inner_line_make(&c.line, &c.w.e, stretches[k], c.w.v_t, c.w.v_n);
                check(&c, workspace);
            }
    gsl_integration_workspace_free(workspace);
}

static double g_at(const struct integrand *w, double delta)
{
    struct integrand copy = *w;
    return density_times_g(delta, &copy) / rl_ellipsoid_pdf(&w->e, delta);
}

static void check_zones(struct one_case *c, gsl_integration_workspace *workspace)
{
    (void)workspace;
    check_near(g_at(&c->w, delta_of(c->line.bound[0])), 0.0, 1e-11);
    check_near(g_at(&c->w, delta_of(c->line.bound[RL_ZONES])), 0.0, 1e-11);
    for (int zone = 0; zone < RL_ZONES; zone++) {
        double a = delta_of(c->line.bound[zone]), b = delta_of(c->line.bound[zone + 1]);
        assert_true(a <= b);
        if (b - a < 1e-6)
            continue;
        double g = g_at(&c->w, 0.5 * (a + b));
        assert_true(zone == 2 ? g == 1.0 : g > 0.0 && g < 1.0);
        /* Which of the two it is: masking takes over where N.V is the lesser. */
        double normal = atan(c->w.stretch * tan(0.5 * (a + b)));
        double v_h = c->w.v_n * cos(normal) + c->w.v_t * sin(normal),
               n_l = 2.0 * v_h * cos(normal) - c->w.v_n;
        if (zone != 2)
            assert_int_equal(zone == 1 || zone == 3, c->w.v_n < n_l);
    }
    assert_true(c->line.bound[2].s < 0.0 && c->line.bound[3].s > 0.0);
}

static void test_zones(void **state)
{
    (void)state;
    for_all(check_zones);
}

static void check_closed_forms(struct one_case *c, gsl_integration_workspace *workspace)
{
    double sum = 0.0;
    for (int zone = 0; zone < RL_ZONES; zone++) {
        double from = delta_of(c->line.bound[zone]), to = delta_of(c->line.bound[zone + 1]);
        /* Two uneven parts; zone 2 is cut at the peak, for the quadrature's sake. */
        double middle = zone == 2 ? 0.0 : from + 0.3 * (to - from);
        const double ends[3] = {from, middle, to};
        for (int i = 0; i < 2; i++) {
            double exact = quadrature(&c->w, ends[i], ends[i + 1], workspace);
            double value = rl_inner_attenuated(&c->line, &c->w.e, c->w.stretch, angle_of(ends[i]),
                                               angle_of(ends[i + 1]));
            check_near(value, exact, 1e-13);
            sum += exact;
        }
    }
    /* All zones at once, and beyond the horizon nothing. */
    check_near(rl_inner_attenuated(&c->line, &c->w.e, c->w.stretch, (struct rl_angle){-1.0, 0.0},
                                   (struct rl_angle){1.0, 0.0}),
               sum, 1e-12);
    assert_true(rl_inner_attenuated(&c->line, &c->w.e, c->w.stretch, c->line.bound[RL_ZONES],
                                    (struct rl_angle){1.0, 0.0}) == 0.0);
}

static void test_closed_forms(void **state)
{
    (void)state;
    for_all(check_closed_forms);
}

static void test_mass(void **state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(ratios); i++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(ratios[i]);
        check_near(rl_inner_mass(&e, (struct rl_angle){-1.0, 0.0}, (struct rl_angle){1.0, 0.0}), 1.0, 1e-14);
        for (int j = 0; j < 9; j++)
            for (int k = 0; k < 8; k++) {
                double a = -1.5 + 0.37 * j, b = fmin(1.57, a + 0.01 + 0.41 * k);
                check_near(rl_inner_mass(&e, angle_of(a), angle_of(b)),
                           rl_ellipsoid_cdf(&e, b) - rl_ellipsoid_cdf(&e, a), 2e-15);
            }
    }
}

/* A stretch so short that the difference of two cdfs would have lost all but two digits. */
static void test_mass_of_short_stretches(void **state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(ratios); i++) {
        struct rl_ellipsoid e = rl_ellipsoid_make(ratios[i]);
        if (e.rr < 1.0)
            continue; /* no such form there */
        struct rl_angle a = {0.375, sqrt(1.0 - 0.375 * 0.375)},
                        b = {0.375 + 0x1p-46, a.c - 0.375 / a.c * 0x1p-46};
        double density = rl_ellipsoid_pdf_sincos(&e, a.s, a.c) / a.c; /* of sin(delta) */
        check_relative(rl_inner_mass(&e, a, b), density * 0x1p-46, 1e-12);
    }
}

static void test_unstretch(void **state)
{
    (void)state;
    struct rl_angle a = rl_inner_unstretch(angle_of(0.7), 0.25);
    check_near(tan(0.7), 0.25 * a.s / a.c, 1e-15);
    /* A frame that has collapsed: all mass is at delta' = 0. */
    assert_true(rl_inner_unstretch(angle_of(1e-9), 0.0).s == 1.0);
    assert_true(rl_inner_unstretch(angle_of(-1e-9), 0.0).s == -1.0);
    assert_true(rl_inner_unstretch(angle_of(0.0), 0.0).c == 1.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_zones),     cmocka_unit_test(test_closed_forms),
        cmocka_unit_test(test_mass),      cmocka_unit_test(test_mass_of_short_stretches),
        cmocka_unit_test(test_unstretch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
