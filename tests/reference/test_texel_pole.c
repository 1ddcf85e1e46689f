/* Integrals of the weight over texels near its poles, against a dense midpoint rule over the definition. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "model/attenuation.h"
#include "reference/fixture.h"
#include "reference/texel_pole.h"
#include "support/check.h"

/* D G / (4 pi (V.H) |sin delta|) from H itself. */
static double weight(const struct rl_surface *s, const struct rl_ellipsoid *e, bool attenuation, rl_vec3 L)
{
    rl_vec3 H = v3_normalize(v3_add(s->V, L));
    double n_h = v3_dot(s->N, H), v_h = v3_dot(s->V, H), sine = v3_length(v3_cross(s->N, H));
    double g = attenuation ? rl_attenuation(n_h, v3_dot(s->N, s->V), v3_dot(s->N, L), v_h) : 1.0;
    return rl_ellipsoid_pdf_sincos(e, sine, fabs(n_h)) * g / (4.0 * RL_PI * v_h * sine);
}

/* The face and place of a direction. */
static int place_of(double *s, double *t, rl_vec3 L)
{
    for (int face = 0; face < RL_CUBE_FACES; face++) {
        rl_vec3 on = rl_cube_on_face(face, L);
        *s = on.x / on.z;
        *t = on.y / on.z;
        if (on.z > 0.0 && fabs(*s) <= 1.0 && fabs(*t) <= 1.0)
            return face;
    }
    return 0;
}

/* The dense rule's own error: of a texel that holds a pole it is as 1/POINTS, of others far less. */
static void test_against_midpoints(void **state)
{
    (void)state;
    enum { POINTS = 300, CASES = 120 };
    struct dice d = dice_make(91);
    double worst_at_pole = 0.0, worst_beside = 0.0;
    for (int i = 0; i < CASES; i++) {
        struct rl_surface s = surface_point(&d, 0.1);
        bool attenuation = i % 2, behind = i % 4 == 2, at_pole = i % 3 == 0;
        struct rl_ellipsoid e = rl_ellipsoid_make(pow(10.0, uniform(&d, -0.5, 1.5)));
        const double half = 1.0 / 16;
        double x, y, sum = 0.0;
        int face = place_of(&x, &y, behind ? v3_scale(-1.0, s.V) : v3_reflect(s.V, s.N));
        x += uniform(&d, -half, half) + (at_pole ? 0.0 : 3.0 * half);
        y += uniform(&d, -half, half);
        for (int k = 0; k < POINTS * POINTS; k++) {
            int column = k % POINTS, row = k / POINTS;
            double u = x + half * ((2 * column + 1.0) / POINTS - 1.0);
            double v = y + half * ((2 * row + 1.0) / POINTS - 1.0);
            sum += weight(&s, &e, attenuation, v3_normalize(rl_cube_direction(face, u, v))) *
                   pow(1.0 + u * u + v * v, -1.5);
        }
        sum *= 4.0 * half * half / ((double)POINTS * POINTS);
        struct rl_texel_pole pole = rl_texel_pole_make(&s, &e, attenuation, 0.0);
        size_t evaluations = 0;
        double off = fabs(rl_texel_integral(&pole, face, x, y, half, &evaluations) - sum);
        assert_true(evaluations > 0);
        double *worst = at_pole ? &worst_at_pole : &worst_beside;
        *worst = fmax(*worst, at_pole ? off / sum : off);
    }
    print_message("off by %.1e of a texel at a pole; %.1e beside one\n", worst_at_pole, worst_beside);
    check_near(worst_at_pole, 0.0, 1.5e-2);
    check_near(worst_beside, 0.0, 3e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_midpoints),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
