/* The order at which sums over texels converge to the reference as the map grows; texel_map.h has the theory. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "reference/texel_fixture.h"

enum { SIZES_MOST = 7 };

/* The slope of log(error) over log(h), by least squares over n sizes. */
static double fitted_order(const double error[], int n)
{
    double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (int i = 0; i < n; i++) {
        double x = -i * log(2.0), y = log(error[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

enum light_kind { INSIDE, OUTSIDE, ALIGNED, FURNACE };

/* A direction well above the horizon and well beside the mirror direction. */
static rl_vec3 above_aside(struct dice *d, const struct rl_surface *s)
{
    rl_vec3 L, R = v3_reflect(s->V, s->N);
    do
        L = unit_vector(d);
    while (v3_dot(L, s->N) < 0.4 || v3_dot(L, R) > 0.6);
    return L;
}

/* Adds the squares of one random point's errors. */
static void add_errors(double squares[], int first, int n, struct dice *d, enum light_kind kind)
{
    struct rl_surface s = surface_point(d, 0.3);
    struct shape light = {4, {{-1.0, -1.0, 3.0}, {1.0, -1.0, 3.0}, {1.0, 1.0, 3.0}, {-1.0, 1.0, 3.0}}};
    /* All round, a broad lobe: the order is that of maps that resolve it. */
    double rr = pow(10.0, uniform(d, 0.0, kind == FURNACE ? 0.2 : 1.0));
    if (kind == INSIDE)
        light = polygon_about(d, v3_madd(s.P, 1.0, v3_reflect(s.V, s.N)), 5, 0.6, 0.6, 0.2);
    else if (kind == OUTSIDE)
        light = polygon_about(d, v3_madd(s.P, 1.5, above_aside(d, &s)), 5, 0.4, 0.4, 0.2);
    else
        s.P = v3(0.0, 0.0, 0.0);
    if (kind == ALIGNED) {
        s.N = v3(0.0, 0.0, 1.0);
        s.V = v3_normalize(v3(uniform(d, 1.5, 2.0), uniform(d, 0.5, 1.0), 1.0));
    }
    struct rl_light_set *set = kind == FURNACE ? furnace() : set_of(&light, 1);
    double truth = kind == FURNACE ? 1.0 : integrate(&s, rr, set, true, 1e-11).value[0];
    for (int i = 0; i < n; i++) {
        double off = map_value(&s, rr, set, kind != FURNACE, first << i) - truth;
        squares[i] += off * off;
    }
    rl_light_set_free(set);
}

/* The root mean square over points at each size: a single point's error is as chance has it. */
static void test_order(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        enum light_kind kind;
        int points, first, sizes;
        double low, high;
    } rows[] = {
        /* 3/2 from edges across the grid */
        {"mirror direction outside the light", OUTSIDE, 40, 32, 7, 1.35, 1.75},
        /* 1 */
        {"edges along the grid", ALIGNED, 4, 32, 7, 0.9, 1.1},
        /* at first 3/2 from the edges, then 1 from the pole */
        {"mirror direction inside the light", INSIDE, 12, 32, 7, 1.0, 1.8},
        /* 1, from the poles alone; smaller maps integrate the whole lobe as near to one */
        {"light all round", FURNACE, 2, 128, 4, 0.85, 1.15},
    };
    struct dice d = dice_make(81);
    for (size_t i = 0; i < LENGTH(rows); i++) {
        double error[SIZES_MOST] = {0.0};
        for (int k = 0; k < rows[i].points; k++)
            add_errors(error, rows[i].first, rows[i].sizes, &d, rows[i].kind);
        for (int k = 0; k < rows[i].sizes; k++)
            error[k] = sqrt(error[k] / rows[i].points);
        double order = fitted_order(error, rows[i].sizes);
        print_message("%s: order %.2f, error %.1e at %d, %.1e at %d\n", rows[i].name, order, error[0],
                      rows[i].first, error[rows[i].sizes - 1], rows[i].first << (rows[i].sizes - 1));
        if (!(order >= rows[i].low && order <= rows[i].high))
            fail_msg("%s: order %.3f, expected %.2f to %.2f", rows[i].name, order, rows[i].low, rows[i].high);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
