/* The rows of the table of integrators, one by one: what each promises of its error, its points, its seed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <gsl/gsl_cdf.h>
#include <cmocka.h>

#include "reference/fixture.h"
#include "reference/integrators.h"
#include "support/check.h"

static const struct rl_surface overhead = {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
static const struct shape quad = {4, {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
static const struct shape behind = {4, {{-1, -1, -2}, {1, -1, -2}, {1, 1, -2}, {-1, 1, -2}}};
/* Of all normals about one in 2000 sees it. */
static const struct shape tiny = {3, {{0.5, 0, 2}, {0.54, 0, 2}, {0.5, 0.04, 2}}};

static struct rl_estimate ask(const char *name, const struct rl_surface *s, double rr,
                              const struct rl_light_set *set, const struct rl_integrate_options *options)
{
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    struct rl_estimate estimate;
    struct rl_error error;
    check_ok(rl_integrator_find(name)->integrate(&estimate, s, &e, set, options, &error), &error);
    return estimate;
}

static void test_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < rl_n_integrators; i++) {
        const struct rl_integrator *it = rl_integrators[i];
        assert_true(it->name && it->summary && it->evaluation && it->error && it->integrate && it->uses);
        assert_ptr_equal(rl_integrator_find(it->name), it);
        assert_true((it->uses & RL_USES_TOLERANCE) == 0 || it->default_tolerance > 0.0);
    }
    assert_null(rl_integrator_find("guess"));
    assert_null(rl_integrator_find(NULL));
}

/* An ordinary point, by all, each at its own default tolerance. */
static void test_all_agree(void **state)
{
    (void)state;
    const struct rl_surface s = {v3(0.1, 0.2, 0.0), v3(0, 0, 1), v3_normalize(v3(0.4, -0.3, 1.0))};
    struct rl_light_set *set = set_of(&quad, 1);
    double truth = integrate(&s, 5.0, set, true, 1e-12).value[0];
    for (size_t i = 0; i < rl_n_integrators; i++) {
        const struct rl_integrator *it = rl_integrators[i];
        struct rl_estimate r = ask(
            it->name, &s, 5.0, set,
            &(struct rl_integrate_options){
                .attenuation = true, .tolerance = it->default_tolerance, .confidence = 0.9999, .seed = 1});
        print_message("%-12s %.10g, off by %.1e, stated %.1e, %zu %s\n", it->name, r.value[0],
                      r.value[0] - truth, r.error[0], r.evaluations, it->evaluation);
        check_near(r.value[0], truth, r.error[0] + 1e-12);
        assert_true(r.evaluations > 0);
        if (it->uses & RL_USES_TOLERANCE)
            assert_true(r.converged && r.error[0] <= it->default_tolerance);
    }
    rl_light_set_free(set);
}

/* Light all round: the faces of a box that is longer to one side. */
static struct rl_light_set *box_about(double shift)
{
    struct shape around[6];
    for (int i = 0; i < 6; i++) {
        double side = i % 2 ? 1.0 : -1.0;
        rl_vec3 axis = v3(i / 2 == 0 ? side : 0, i / 2 == 1 ? side : 0, i / 2 == 2 ? side : 0);
        rl_vec3 t = v3(axis.y, axis.z, axis.x), b = v3(axis.z, axis.x, axis.y);
        around[i].n = 4;
        for (int j = 0; j < 4; j++)
            around[i].vertex[j] =
                v3_madd(v3_madd(axis, j == 1 || j == 2 ? 1.0 : -1.0, t), j >= 2 ? 1.0 : -1.0, b);
    }
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 4; j++)
            around[i].vertex[j] = v3_madd(around[i].vertex[j], shift, v3(1, 1, 1));
    return set_of(around, 6);
}

/* Nothing but misses, or nothing but hits: the samples do not vary, and still the value is not known. */
static void test_no_variance(void **state)
{
    (void)state;
    static const size_t most[] = {1, 10, 1000, 30000};
    struct rl_light_set *none = set_of(&behind, 1), *all = box_about(0.0);
    for (size_t i = 0; i < LENGTH(most); i++) {
        struct rl_integrate_options options = {
            .attenuation = true, .tolerance = 1e-9, .max_evaluations = most[i]};
        struct rl_estimate r = ask("montecarlo", &overhead, 3.0, none, &options);
        assert_true(r.value[0] == 0.0 && !r.converged && r.evaluations == most[i]);
        /* The largest mean that n misses leave possible at 99 % (two-sided) is 1 - 0.005^(1/n). */
        double n = (double)most[i], least = 1.0 - pow(0.005, 1.0 / n);
        assert_true(r.error[0] >= 0.8 * least && r.error[0] <= 10.0 / n + 0.1);
        options.attenuation = false;
        struct rl_estimate hits = ask("montecarlo", &overhead, 3.0, all, &options);
        check_near(hits.value[0], 1.0, 0.0);
        check_near(hits.error[0], r.error[0], 1e-12);
    }
    /* VEGAS claims a standard error of 0 there. */
    struct rl_estimate r = ask("vegas", &overhead, 3.0, none,
                               &(struct rl_integrate_options){.attenuation = true, .tolerance = 1e-2});
    assert_true(r.value[0] == 0.0 && r.error[0] > 0.0 && r.converged);
    r = ask("vegas", &overhead, 3.0, all, &(struct rl_integrate_options){.tolerance = 1e-2});
    check_near(r.value[0], 1.0, r.error[0]);
    rl_light_set_free(none);
    rl_light_set_free(all);
}

/* Poles of the area integral: constant radiance all round has both, the mirror direction and -V, well inside a face or near an edge;
 * an edge that passes close by the mirror direction takes up nearly half a turn about it. */
static void test_cubature_poles(void **state)
{
    (void)state;
    static const rl_vec3 views[] = {{0, 0, 1}, {0.3, 0.2, 1}, {0.95, 0.1, 1}, {1, 0.4, 0.06}};
    struct rl_light_set *all = box_about(0.2);
    for (size_t i = 0; i < LENGTH(views); i++) {
        const struct rl_surface s = {v3(0.1, -0.2, 0.3), v3(0, 0, 1), v3_normalize(views[i])};
        struct rl_estimate r =
            ask("cubature", &s, 3.0, all, &(struct rl_integrate_options){.tolerance = 1e-8});
        print_message("furnace off by %.1e, stated %.1e, %zu points\n", r.value[0] - 1.0, r.error[0],
                      r.evaluations);
        check_near(r.value[0], 1.0, r.error[0]);
        assert_true(r.converged && r.evaluations < 1000000);
    }
    rl_light_set_free(all);
    for (int digits = 1; digits <= 9; digits++)
        for (int side = -1; side <= 1; side += 2) {
            double gap = pow(0.1, digits);
            const struct shape edge = {4,
                                       {{side * gap, -1, 2}, {1, -1.3, 2}, {1, 1.1, 2}, {side * gap, 1, 2}}};
            struct rl_light_set *set = set_of(&edge, 1);
            for (int wanted = 2; wanted <= 8; wanted++) {
                double tolerance = pow(0.1, wanted);
                struct rl_estimate truth = integrate(&overhead, 20.0, set, true, 1e-11);
                struct rl_estimate r =
                    ask("cubature", &overhead, 20.0, set,
                        &(struct rl_integrate_options){.attenuation = true, .tolerance = tolerance});
                check_near(r.value[0], truth.value[0], r.error[0] + truth.error[0]);
                assert_true(r.converged);
            }
            rl_light_set_free(set);
        }
}

/* About one hit in all the samples: an interval by the sample variance alone would hold in 63 % of the cases. */
static void test_rare_hits(void **state)
{
    (void)state;
    enum { SEEDS = 1500, SAMPLES = 8000 };
    struct rl_light_set *set = set_of(&tiny, 1);
    double truth = integrate(&overhead, 3.0, set, true, 1e-12).value[0];
    unsigned missed = 0;
    for (uint64_t seed = 0; seed < SEEDS; seed++) {
        struct rl_estimate r =
            ask("montecarlo", &overhead, 3.0, set,
                &(struct rl_integrate_options){
                    .attenuation = true, .tolerance = 1e-9, .max_evaluations = SAMPLES, .seed = seed});
        missed += fabs(r.value[0] - truth) > r.error[0];
    }
    double high = missed ? gsl_cdf_binomial_Q(missed - 1, 0.01, SEEDS) : 1.0;
    print_message("%.2f hits expected; %u of %d intervals missed\n", truth * SAMPLES, missed, SEEDS);
    assert_true(truth * SAMPLES > 0.3 && truth * SAMPLES < 3.0 && high > 0.001);
    rl_light_set_free(set);
}

/* GSL's generators take 32 bits and give 0 and 4357 the same stream. */
static void test_seeds(void **state)
{
    (void)state;
    static const uint64_t seeds[] = {0, 1, 4356, 4357, 0xfffffffe, (uint64_t)1 << 32, UINT64_MAX};
    static const char *const names[] = {"montecarlo", "vegas"};
    struct rl_light_set *set = set_of(&quad, 1);
    for (size_t k = 0; k < LENGTH(names); k++) {
        double value[LENGTH(seeds)];
        for (size_t i = 0; i < LENGTH(seeds); i++) {
            const struct rl_integrate_options options = {
                .attenuation = true, .tolerance = 1e-9, .max_evaluations = 6000, .seed = seeds[i]};
            value[i] = ask(names[k], &overhead, 3.0, set, &options).value[0];
            assert_true(ask(names[k], &overhead, 3.0, set, &options).value[0] == value[i]);
            for (size_t j = 0; j < i; j++)
                assert_true(value[i] != value[j]);
        }
    }
    rl_light_set_free(set);
}

/* However few points are allowed there are no more, the error holds, and nobody claims a tolerance that was not reached. */
static void test_few_points(void **state)
{
    (void)state;
    static const size_t most[] = {1, 2, 16, 17, 18, 50, 51, 52, 100, 299, 300, 301, 1000, 3000, 30000};
    struct rl_light_set *set = set_of(&quad, 1);
    const struct rl_surface s = {v3(0.1, 0.2, 0.0), v3(0, 0, 1), v3_normalize(v3(0.4, -0.3, 1.0))};
    double truth = integrate(&s, 30.0, set, true, 1e-12).value[0];
    for (size_t i = 0; i < rl_n_integrators; i++) {
        const struct rl_integrator *it = rl_integrators[i];
        /* The reference takes whole panels. */
        size_t slack = strcmp(it->name, "reference") == 0 ? 1000 : 0;
        for (size_t j = 0; j < LENGTH(most) && (it->uses & RL_USES_MAX_EVALUATIONS); j++)
            for (int loose = 0; loose < 2; loose++) {
                double tolerance = loose ? 0.01 : 1e-14;
                struct rl_estimate r = ask(it->name, &s, 30.0, set,
                                           &(struct rl_integrate_options){.attenuation = true,
                                                                          .tolerance = tolerance,
                                                                          .max_evaluations = most[j],
                                                                          .confidence = 0.9999});
                if (r.evaluations > most[j] + slack)
                    print_error("%s: %zu evaluations, %zu allowed\n", it->name, r.evaluations, most[j]);
                assert_true(r.evaluations <= most[j] + slack);
                assert_int_equal(r.converged, r.error[0] <= tolerance);
                if (strcmp(it->name, "cubature-uv") != 0)
                    check_near(r.value[0], truth, r.error[0] + 1e-12);
                assert_true(slack || loose || !r.converged);
            }
    }
    rl_light_set_free(set);
}

/* A polygon before another, a plane passing through another, the same polygon twice, one inside the other in one plane. */
static void test_cubature_hidden(void **state)
{
    (void)state;
    static const struct shape front = {4,
                                       {{-0.5, -2, 1.5}, {0.6, -2, 1.5}, {0.6, 0.3, 1.5}, {-0.5, 0.3, 1.5}}};
    static const struct shape through = {4, {{-1, -1, 1.5}, {1, -1, 1.5}, {1, 1, 2.5}, {-1, 1, 2.5}}};
    static const struct shape inside = {3, {{-0.5, -0.5, 2}, {0.5, -0.5, 2}, {0, 0.5, 2}}};
    static const struct shape *const others[] = {&front, &through, &quad, &inside};
    const struct rl_surface s = {v3(0.1, 0.2, 0.0), v3(0, 0, 1), v3_normalize(v3(0.4, -0.3, 1.0))};
    for (size_t i = 0; i < LENGTH(others); i++)
        for (int order = 0; order < 2; order++) {
            const struct shape shapes[2] = {order ? *others[i] : quad, order ? quad : *others[i]};
            struct rl_light_set *set = lights_of(shapes, (const double[]){1.0, 0.25}, 2);
            struct rl_integrate_options options = {.attenuation = i % 2, .tolerance = 1e-8};
            struct rl_estimate r = ask("cubature", &s, 4.0, set, &options);
            double truth = integrate(&s, 4.0, set, i % 2, 1e-11).value[0];
            check_near(r.value[0], truth, r.error[0] + 1e-11);
            assert_true(r.converged);
            rl_light_set_free(set);
        }
}

/* Mirrors: the peak is found whatever its width, and rounding is stated. Where the printed frame has no density it is refused. */
static void test_cubature_extremes(void **state)
{
    (void)state;
    static const double smooth[] = {1e3, 1e6, 1e9, 1e12};
    const struct shape half = {4, {{0, -1, 2}, {1, -1, 2}, {1, 1, 2}, {0, 1, 2}}};
    struct rl_light_set *set = set_of(&quad, 1), *cut = set_of(&half, 1);
    const struct rl_integrate_options options = {.attenuation = true, .tolerance = 1e-7};
    for (size_t i = 0; i < LENGTH(smooth); i++) {
        const struct rl_surface s = {v3(0.1, 0.2, 0.0), v3(0, 0, 1), v3_normalize(v3(0.2, -0.1, 1.0))};
        struct rl_estimate r = ask("cubature", &s, smooth[i], set, &options);
        double truth = integrate(&s, smooth[i], set, true, 1e-10).value[0];
        check_near(r.value[0], truth, r.error[0] + 1e-10);
        assert_true(r.converged == (smooth[i] < 1e8) && (r.error[0] < 1e-2 || smooth[i] > 1e10));
        r = ask("cubature", &overhead, smooth[i], cut, &options);
        struct rl_estimate exact = integrate(&overhead, smooth[i], cut, true, 1e-10);
        check_near(r.value[0], exact.value[0], r.error[0] + exact.error[0]);
    }
    rl_light_set_free(cut);

    const struct rl_surface sideways = {v3(0, 0, 0), v3(1, 0, 0), v3(1, 0, 0)};
    struct rl_ellipsoid e = rl_ellipsoid_make(3.0);
    struct rl_estimate r;
    struct rl_error error;
    check_fails(rl_integrator_find("cubature")
                    ->integrate(&r, &sideways, &e, set,
                                &(struct rl_integrate_options){.frame = RL_FRAME_PRINTED, .tolerance = 1e-3},
                                &error),
                &error, RL_ERR_INPUT, "printed frame");
    rl_light_set_free(set);
}

/* P close to the light's plane, below the light: all directions are in a small part of its area. */
static void test_cubature_close(void **state)
{
    (void)state;
    for (int digits = 1; digits <= 8; digits++) {
        double h = pow(0.1, digits);
        const struct shape close = {4, {{-0.3, -0.5, h}, {1, -0.4, h}, {1, 1, h}, {-0.2, 1, h}}};
        const struct rl_surface s = {v3(0.1, 0.2, 0.0), v3(0, 0, 1), v3_normalize(v3(0.4, -0.3, 1.0))};
        struct rl_light_set *set = set_of(&close, 1);
        struct rl_estimate truth = integrate(&s, 3.0, set, true, 1e-10);
        struct rl_estimate r = ask("cubature", &s, 3.0, set,
                                   &(struct rl_integrate_options){.attenuation = true, .tolerance = 1e-5});
        check_near(r.value[0], truth.value[0], r.error[0] + truth.error[0]);
        assert_true(r.converged && r.value[0] > 0.2);
        rl_light_set_free(set);
    }
}

/* The reason why cubature-uv is no ground truth: it may miss a light and be sure of it. */
static void test_cubature_uv_is_fooled(void **state)
{
    (void)state;
    struct rl_light_set *set = set_of(&tiny, 1);
    struct rl_estimate r = ask("cubature-uv", &overhead, 3.0, set,
                               &(struct rl_integrate_options){.attenuation = true, .tolerance = 1e-6});
    assert_true(r.value[0] == 0.0 && r.error[0] == 0.0 && r.converged);
    rl_light_set_free(set);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_all_agree),
        cmocka_unit_test(test_no_variance),
        cmocka_unit_test(test_rare_hits),
        cmocka_unit_test(test_seeds),
        cmocka_unit_test(test_few_points),
        cmocka_unit_test(test_cubature_hidden),
        cmocka_unit_test(test_cubature_extremes),
        cmocka_unit_test(test_cubature_poles),
        cmocka_unit_test(test_cubature_close),
        cmocka_unit_test(test_cubature_uv_is_fooled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
