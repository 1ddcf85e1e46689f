/* The adaptive rule: exactness, marked square roots, honesty, limits. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "model/vec3.h"
#include "reference/quadrature.h"
#include "support/check.h"

#define LENGTH(a) (sizeof(a) / sizeof(a)[0])

typedef double scalar(double x);

static bool call(double value[RL_QUADRATURE_COMPONENTS], double x, void *user)
{
    scalar *const *f = user;
    value[0] = (*f)(x);
    value[1] = -2.0 * value[0];
    value[2] = 0.0;
    value[3] = 1.0;
    return true;
}

static double power22(double x)
{
    return 23.0 * pow(x, 22.0);
}
static double root(double x)
{
    return 1.5 * sqrt(x);
}
static double both_roots(double x)
{
    return 8.0 / RL_PI * sqrt(x * (1.0 - x));
}
static double mirrored_root(double x)
{
    return 1.5 * sqrt(1.0 - x);
}
static double step(double x)
{
    return x < 1.0 / RL_PI ? 1.0 : 0.0;
}
static double spike(double x)
{
    return 1e-3 / (1e-6 + (x - 0.3) * (x - 0.3));
}
static double kink(double x)
{
    return fabs(x - 0.37);
}

/* Over [0, 1]; in one application of the rule where `most` is its 15 points. */
static const struct {
    const char *name;
    scalar *f;
    bool root_at_a, root_at_b;
    double exact, tolerance;
    size_t most;
} table[] = {
    {"polynomial of degree 22", power22, false, false, 1.0, 1e-2, 200},
    {"square root at a", root, true, false, 1.0, 1e-13, 15},
    {"square root at b", mirrored_root, false, true, 1.0, 1e-13, 15},
    {"square roots at both ends", both_roots, true, true, 1.0, 1e-8, 200},
    {"unmarked square root", root, false, false, 1.0, 1e-9, 2000},
    {"step", step, false, false, 1.0 / RL_PI, 1e-9, 2000},
    {"narrow spike", spike, false, false, 0, 1e-9, 2000},
    {"kink", kink, false, false, 0.5 * (0.37 * 0.37 + 0.63 * 0.63), 1e-12, 2000},
};

static void test_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(table); i++) {
        struct rl_panel panel = {0.0, 1.0, table[i].root_at_a, table[i].root_at_b};
        struct rl_quadrature_result r;
        scalar *f = table[i].f;
        rl_quadrature(&r, call, &f, &panel, 1,
                      &(struct rl_quadrature_options){.tolerance = 2.0 * table[i].tolerance});
        double exact = f == spike ? atan(700.0) + atan(300.0) : table[i].exact;
        double off = fabs(r.value[0] - exact);
        print_message("%-28s off %.1e, stated %.1e, %zu evaluations\n", table[i].name, off, r.error[0],
                      r.evaluations);
        assert_true(r.converged);
        assert_true(off <= r.error[0] + 1e-15);
        assert_true(off <= table[i].tolerance);
        assert_true(r.evaluations <= table[i].most);
        check_near(r.value[1], -2.0 * r.value[0], 1e-13);
        check_near(r.value[3], 1.0, 1e-12);
        assert_true(r.value[2] == 0.0);
    }
}

/* Degree 22 is exact in a single application: weights and nodes are right to the last digit. */
static void test_rule_is_exact(void **state)
{
    (void)state;
    for (int degree = 0; degree <= 22; degree++) {
        double sum = 0.0;
        for (int i = 0; i < RL_KRONROD_NODES; i++)
            sum += rl_kronrod_weight(i) * pow(rl_kronrod_node(i), degree);
        check_near(sum, degree % 2 ? 0.0 : 2.0 / (degree + 1), 5e-16);
    }
}

static void test_panels_add_up(void **state)
{
    (void)state;
    const struct rl_panel panels[] = {{0.0, 0.37, false, false}, {0.37, 1.0, false, false}};
    struct rl_quadrature_result r;
    scalar *f = kink;
    rl_quadrature(&r, call, &f, panels, 2, &(struct rl_quadrature_options){.tolerance = 1e-14});
    check_near(r.value[0], 0.5 * (0.37 * 0.37 + 0.63 * 0.63), 1e-15);
    assert_int_equal(r.evaluations, 30);
}

static void test_limit_is_kept(void **state)
{
    (void)state;
    const struct rl_panel panel = {0.0, 1.0, false, false};
    struct rl_quadrature_result r;
    scalar *f = step;
    rl_quadrature(&r, call, &f, &panel, 1,
                  &(struct rl_quadrature_options){.tolerance = 1e-15, .max_evaluations = 100});
    assert_false(r.converged);
    assert_true(r.evaluations <= 100);
    assert_true(fabs(r.value[0] - 1.0 / RL_PI) <= r.error[0]);

    /* Nothing left to halve. */
    rl_quadrature(&r, call, &f, &panel, 1, &(struct rl_quadrature_options){.tolerance = 0.0});
    assert_false(r.converged);
    check_near(r.value[0], 1.0 / RL_PI, 1e-13);
}

/* More pieces than fit the array that comes first. */
static double comb(double x)
{
    return floor(500.0 * x) - 2.0 * floor(250.0 * x);
}

static void test_many_pieces(void **state)
{
    (void)state;
    const struct rl_panel panel = {0.0, 1.0 + 1e-3 * RL_PI, false, false};
    struct rl_quadrature_result r;
    scalar *f = comb;
    rl_quadrature(&r, call, &f, &panel, 1,
                  &(struct rl_quadrature_options){.tolerance = 1e-4, .max_evaluations = 1000000});
    assert_true(r.converged);
    check_near(r.value[0], 0.5 + (1e-3 * RL_PI - 2e-3), 1e-4);
}

static bool nothing(double value[RL_QUADRATURE_COMPONENTS], double x, void *user)
{
    (void)x, (void)user;
    for (int i = 0; i < RL_QUADRATURE_COMPONENTS; i++)
        value[i] = 0.0;
    return false;
}

static void test_empty_panels_cost_one(void **state)
{
    (void)state;
    const struct rl_panel panels[] = {{0.0, 1.0, false, false}, {1.0, 2.0, true, true}};
    struct rl_quadrature_result r;
    rl_quadrature(&r, nothing, NULL, panels, 2, &(struct rl_quadrature_options){.tolerance = 1e-14});
    assert_true(r.converged && r.value[0] == 0.0 && r.error[0] == 0.0);
    assert_int_equal(r.evaluations, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_table),         cmocka_unit_test(test_rule_is_exact),
        cmocka_unit_test(test_panels_add_up), cmocka_unit_test(test_limit_is_kept),
        cmocka_unit_test(test_many_pieces),   cmocka_unit_test(test_empty_panels_cost_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
