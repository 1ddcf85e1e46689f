/* The inner loop of `exhaustive`: every instruction set against a plain evaluation in double precision of the definition. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>

#include "model/attenuation.h"
#include "model/frame.h"
#include "reference/fixture.h"
#include "reference/texel_sum.h"
#include "support/check.h"

enum { TEXELS_MOST = 5000 };

struct texels {
    float x[TEXELS_MOST], y[TEXELS_MOST], z[TEXELS_MOST], solid_angle[TEXELS_MOST];
};

/* sum of D G / (4 pi (V.H) |sin delta|) d omega, from H itself. Texels with |y| below the reach are not in it. */
static double by_definition(const struct rl_texel_list *list, const struct rl_surface *s, double rr,
                            bool attenuation)
{
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    double sum = 0.0;
    for (size_t i = 0; i < list->n; i++) {
        rl_vec3 L = v3((double)list->x[i], (double)list->y[i], (double)list->z[i]);
        rl_vec3 H = v3_normalize(v3_add(s->V, L));
        double n_h = v3_dot(s->N, H), v_h = v3_dot(s->V, H), sine = v3_length(v3_cross(s->N, H));
        double g = attenuation ? rl_attenuation(n_h, v3_dot(s->N, s->V), v3_dot(s->N, L), v_h) : 1.0;
        sum += rl_ellipsoid_pdf_sincos(&e, sine, fabs(n_h)) * g / (4.0 * RL_PI * v_h * sine) *
               (double)list->solid_angle[i];
    }
    return sum;
}

static struct rl_texel_point point_of(const struct rl_surface *s, double rr, double reach, bool attenuation)
{
    struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, s->N);
    const rl_vec3 axis[3] = {f.T, f.B, f.N};
    struct rl_texel_point p = {
        .rr = (float)rr, .u_least = (float)(reach * reach), .attenuation = attenuation};
    for (int i = 0; i < 3; i++) {
        p.axis[i][0] = (float)axis[i].x;
        p.axis[i][1] = (float)axis[i].y;
        p.axis[i][2] = (float)axis[i].z;
        p.v[i] = (float)v3_dot(axis[i], s->V);
    }
    return p;
}

static double scale_of(double rr)
{
    return rl_ellipsoid_make(rr).norm / (2.0 * RL_PI * rr);
}

/* Directions all over the sphere but for the poles. */
static struct rl_texel_list draw(struct texels *t, size_t n, struct dice *d, const struct rl_surface *s,
                                 double reach)
{
    for (size_t i = 0; i < n; i++) {
        rl_vec3 L, m;
        do {
            L = unit_vector(d);
            m = v3_add(L, s->V);
        } while (v3_length(v3_cross(m, s->N)) < reach);
        t->x[i] = (float)L.x;
        t->y[i] = (float)L.y;
        t->z[i] = (float)L.z;
        t->solid_angle[i] = (float)uniform(d, 1e-6, 1e-3);
    }
    return (struct rl_texel_list){n, t->x, t->y, t->z, t->solid_angle};
}

/* Single texels may be off by what rounding a direction does at the reach, 1e-7/reach, and the lobe's flank, twice that; sums are better.
 * All lengths about a register's and a block's. */
static void test_against_definition(void **state)
{
    (void)state;
    static const size_t lengths[] = {0,   1,   3,   7,   8,   9,   15,  16,   17,  31,
                                     127, 128, 129, 255, 256, 257, 511, 1000, 5000};
    struct texels *t = malloc(sizeof *t);
    struct dice d = dice_make(61);
    enum rl_simd best = rl_simd_best();
    double worst[RL_SIMD_COUNT] = {0.0}, worst_long[RL_SIMD_COUNT] = {0.0};
    for (int i = 0; i < 400; i++) {
        struct rl_surface s = surface_point(&d, 0.05);
        const double reach = 0.02, rr = pow(10.0, uniform(&d, -1.0, 3.0));
        bool attenuation = i % 2;
        size_t n = lengths[(size_t)i % LENGTH(lengths)];
        struct rl_texel_list list = draw(t, n, &d, &s, reach);
        struct rl_texel_point p = point_of(&s, rr, reach, attenuation);
        double expected = by_definition(&list, &s, rr, attenuation);
        for (int k = 0; k <= (int)best; k++) {
            double found = scale_of(rr) * rl_texel_sum_for((enum rl_simd)k)(&list, &p);
            double off = fabs(found - expected) / fmax(expected, 1e-300);
            worst[k] = fmax(worst[k], expected > 0.0 ? off : found);
            if (n >= 1000)
                worst_long[k] = fmax(worst_long[k], off);
        }
    }
    free(t);
    for (int k = 0; k <= (int)best; k++) {
        print_message("%s: off by %.1e of the sum at most, %.1e with 1000 texels or more\n",
                      rl_simd_name((enum rl_simd)k), worst[k], worst_long[k]);
        check_near(worst[k], 0.0, 2e-5);
        check_near(worst_long[k], 0.0, 2e-6);
    }
}

/* No R_r, view or direction makes anything else than a finite number >= 0: also at both poles, where |y| is held. */
static void test_finite(void **state)
{
    (void)state;
    static const double ratios[] = {1e-6, 1e-3, 1.0, 30.0, 1e6, 1e12};
    struct dice d = dice_make(62);
    for (int i = 0; i < 200; i++) {
        struct rl_surface s = surface_point(&d, 1e-6);
        if (i % 3 == 0)
            s = (struct rl_surface){.N = v3(0, 0, 1), .V = v3(0, 0, 1)};
        rl_vec3 R = v3_reflect(s.V, s.N);
        const rl_vec3 L[] = {R, v3_scale(-1.0, s.V), v3_scale(-1.0, s.N), s.N, s.V};
        for (size_t k = 0; k < LENGTH(L) * LENGTH(ratios) * 2; k++) {
            rl_vec3 at = L[k % LENGTH(L)];
            double rr = ratios[k / LENGTH(L) % LENGTH(ratios)];
            const float x = (float)at.x, y = (float)at.y, z = (float)at.z, solid_angle = 1e-6f;
            struct rl_texel_list list = {1, &x, &y, &z, &solid_angle};
            struct rl_texel_point p = point_of(&s, rr, 4.0 / 4096, k >= LENGTH(L) * LENGTH(ratios));
            for (int simd = 0; simd <= (int)rl_simd_best(); simd++) {
                double sum = rl_texel_sum_for((enum rl_simd)simd)(&list, &p);
                assert_true(isfinite(sum) && sum >= 0.0);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_definition),
        cmocka_unit_test(test_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
