/* The points of the study `accuracy` (studies/points.h): the same for ever, and as they are described. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>

#include "studies/points.h"

/* As they were when the study was first run: another generator makes old and new figures incomparable. */
static void test_points_are_fixed(void **state)
{
    (void)state;
    static const struct {
        enum rl_point_light_kind kind;
        size_t index;
        double rr, v_x, last_x;
    } known[] = {
        {RL_POINT_QUAD, 0, 1.62488515897125, -0.394897836525958, 0.297137139074686},
        {RL_POINT_QUAD, 99, 2.10489994789581, -0.920124165069303, 0.0129813537606903},
        {RL_POINT_STAR, 0, 21.3350273129622, 0.340278209460503, 0.26678223864496},
        {RL_POINT_STAR, 99, 3.03366469605639, -0.269397613087647, 1.49230633640548},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        struct rl_point p;
        rl_point_make(&p, known[i].kind, known[i].index);
        double last_x = p.vertex[p.n_vertices - 1].x;
        printf("rr %.15g, V.x %.15g, last vertex's x %.15g\n", p.e.rr, p.surface.V.x, last_x);
        assert_true(fabs(p.e.rr / known[i].rr - 1.0) < 1e-12);
        assert_true(fabs(p.surface.V.x - known[i].v_x) < 1e-12);
        assert_true(fabs(last_x - known[i].last_x) < 1e-12);
    }
}

/* Each corner turns the same way. */
static bool convex(const struct rl_point *p)
{
    rl_vec3 normal = v3(0.0, 0.0, 0.0);
    for (size_t i = 0; i < p->n_vertices; i++) {
        const rl_vec3 *a = &p->vertex[i], *b = &p->vertex[(i + 1) % p->n_vertices],
                      *c = &p->vertex[(i + 2) % p->n_vertices];
        rl_vec3 turn = v3_cross(v3_sub(*b, *a), v3_sub(*c, *b));
        if (i > 0 && !(v3_dot(turn, normal) > 0.0))
            return false;
        normal = turn;
    }
    return true;
}

static void test_points_are_as_promised(void **state)
{
    (void)state;
    double least_rr = INFINITY, most_rr = 0.0, least_v_n = 1.0;
    for (size_t i = 0; i < 200; i++) {
        struct rl_point p, star;
        rl_point_make(&p, RL_POINT_QUAD, i);
        rl_point_make(&star, RL_POINT_STAR, i);
        assert_true(fabs(v3_length(p.surface.N) - 1.0) < 1e-14 && fabs(v3_length(p.surface.V) - 1.0) < 1e-14);
        double v_n = v3_dot(p.surface.N, p.surface.V);
        assert_true(v_n > 0.05 - 1e-12 && p.e.rr >= 1.0 && p.e.rr <= 300.0);
        assert_true(p.n_vertices == 4 && star.n_vertices == 10);
        assert_true(convex(&p) && !convex(&star));
        least_rr = fmin(least_rr, p.e.rr);
        most_rr = fmax(most_rr, p.e.rr);
        least_v_n = fmin(least_v_n, v_n);
    }
    assert_true(least_rr < 1.2 && most_rr > 250.0 && least_v_n < 0.08);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_points_are_fixed),
        cmocka_unit_test(test_points_are_as_promised),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
