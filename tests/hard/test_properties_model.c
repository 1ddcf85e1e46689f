/* Properties of frames, attenuation, reflectance and point lights over a million random inputs a function. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "effects/effect.h"
#include "hard/draw.h"
#include "hard/property.h"
#include "model/attenuation.h"
#include "model/frame.h"
#include "model/fresnel.h"

enum { ROWS = 1000000 };
static const uint64_t seed = 20261127;

static struct draw begin(uint64_t stream)
{
    print_message("seed %llu, stream %llu\n", (unsigned long long)seed, (unsigned long long)stream);
    return (struct draw){.seed = seed, .index = stream << 40};
}

static double distance(rl_vec3 a, rl_vec3 b)
{
    return v3_length(v3_sub(a, b));
}

static void test_frames(void **state)
{
    (void)state;
    struct draw d = begin(1);
    for (int i = 0; i < ROWS; i++) {
        rl_vec3 in = draw_direction(&d), N = v3_normalize(in);
        struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, N);
        require(fabs(v3_dot(N, N) - 1.0) <= 8.0 * ULP, &in.x, 3);
        require(fabs(v3_dot(f.T, f.T) - 1.0) <= 16.0 * ULP && fabs(v3_dot(f.B, f.B) - 1.0) <= 16.0 * ULP,
                &in.x, 3);
        require(fabs(v3_dot(f.T, f.B)) <= 8.0 * ULP && fabs(v3_dot(f.T, N)) <= 8.0 * ULP &&
                    fabs(v3_dot(f.B, N)) <= 8.0 * ULP,
                &in.x, 3);
        require(distance(v3_cross(f.T, f.B), N) <= 16.0 * ULP, &in.x, 3);
        /* N mirrored at y = 0 mirrors T, and turns B round as a right-handed frame must. */
        struct rl_frame m = rl_frame_make(RL_FRAME_ORTHONORMAL, v3(N.x, -N.y, N.z));
        require(distance(m.T, v3(f.T.x, -f.T.y, f.T.z)) == 0.0, &in.x, 3);
        require(distance(m.B, v3(-f.B.x, f.B.y, -f.B.z)) == 0.0, &in.x, 3);
        /* A length is no matter. */
        struct rl_frame g = rl_frame_make(RL_FRAME_ORTHONORMAL, v3_normalize(v3_scale(0.5, in)));
        bool whole = fmin(fabs(in.x), fmin(fabs(in.y), fabs(in.z))) > 1e-300;
        require(!whole || (distance(g.T, f.T) == 0.0 && distance(g.B, f.B) == 0.0), &in.x, 3);
    }
}

/* As the paper has it: orthogonal, and sqrt(n_y^2 + n_z^2) long, which is its collapse at +-x. */
static void test_printed_frame(void **state)
{
    (void)state;
    struct draw d = begin(2);
    for (int i = 0; i < ROWS; i++) {
        rl_vec3 in = draw_direction(&d), N = v3_normalize(in);
        struct rl_frame f = rl_frame_make(RL_FRAME_PRINTED, N);
        double length = hypot(N.y, N.z);
        /* Squares below 1e-154 are no numbers any more. */
        bool whole = length > 1e-150;
        require(!whole || (fabs(v3_length(f.T) - length) <= 8.0 * ULP * length &&
                           fabs(v3_length(f.B) - length) <= 8.0 * ULP * length),
                &in.x, 3);
        require(fabs(v3_dot(f.T, f.B)) <= 8.0 * ULP * length * length + DBL_MIN, &in.x, 3);
        require(fabs(v3_dot(f.T, N)) <= 8.0 * ULP * length && fabs(v3_dot(f.B, N)) <= 8.0 * ULP * length,
                &in.x, 3);
    }
}

static void test_attenuation(void **state)
{
    (void)state;
    struct draw d = begin(3);
    for (int i = 0; i < ROWS; i++) {
        const double in[] = {draw_between(&d, -1.0, 1.0), draw_between(&d, -1.0, 1.0),
                             draw_between(&d, -1.0, 1.0), draw_between(&d, -1.0, 1.0)};
        double more = draw_below(&d, 2) ? draw_between(&d, -1.0, 1.0) : 1.0;
        double g = rl_attenuation(in[0], in[1], in[2], in[3]);
        require(g >= 0.0 && g <= 1.0, in, 4);
        require(rl_attenuation(in[0], in[2], in[1], in[3]) == g, in, 4);
        /* It rises with every cosine but V.H, where there is any to fall from. */
        require(rl_attenuation(fmax(in[0], more), in[1], in[2], in[3]) >= g, in, 4);
        require(rl_attenuation(in[0], fmax(in[1], more), in[2], in[3]) >= g, in, 4);
        require(rl_attenuation(in[0], in[1], fmax(in[2], more), in[3]) >= g, in, 4);
        require(rl_attenuation(in[0], in[1], in[2], fmax(in[3], more)) <= g || in[3] <= 0.0, in, 4);
        require(g == 0.0 || (in[1] > 0.0 && in[2] > 0.0), in, 4);
    }
}

static void test_reflectance(void **state)
{
    (void)state;
    struct draw d = begin(4);
    for (int i = 0; i < ROWS; i++) {
        const double in[] = {draw_between(&d, 0.01, 1e8), draw_between(&d, 0.0, 100.0),
                             draw_between(&d, 0.0, 1.0)};
        double f = rl_fresnel(in[0], in[1], in[2]);
        require(f >= 0.0 && f <= 1.0, in, 3);
        double none = rl_fresnel(in[0], in[1], 0.0);
        require(none == 1.0 || (in[0] == 1.0 && in[1] == 0.0 && none == 0.0), in, 3);
    }
}

/* Of dielectrics. */
static void test_dielectrics(void **state)
{
    (void)state;
    struct draw d = begin(5);
    double worst = 0.0;
    for (int i = 0; i < ROWS; i++) {
        const double in[] = {1.0 + draw_between(&d, 0.0, 99.0), draw_between(&d, 0.0, 1.0),
                             draw_between(&d, 0.0, 1.0)};
        double n = in[0], least = fmin(in[1], in[2]), most = fmax(in[1], in[2]);
        /* From Brewster's angle on, tan = n, both polarisations rise towards grazing. */
        double brewster = 1.0 / sqrt(1.0 + n * n);
        double low = rl_fresnel(n, 0.0, least * brewster), high = rl_fresnel(n, 0.0, most * brewster);
        require(high <= low * (1.0 + 16.0 * ULP), in, 3);
        /* Light along the same path the other way, out of the medium (Stokes). What rounding does to n and to the cosine inside moves
         * c^2 by some n^2 ulps, and F falls with c by no more than 4 n^2/sqrt(n^2 - 1). */
        double c = in[1], inside = sqrt((n - 1.0) * (n + 1.0) + c * c) / n;
        double there = rl_fresnel(n, 0.0, c), back = rl_fresnel(1.0 / n, 0.0, inside);
        double moved = fmin(8.0 * n * n * ULP / fmax(c, DBL_MIN), 4.0 * n * sqrt(ULP));
        double allowed = 32.0 * ULP + 4.0 * n * n * moved / sqrt(fmax((n - 1.0) * (n + 1.0), ULP));
        worst = fmax(worst, fabs(there - back) / allowed);
        require(fabs(there - back) <= allowed, in, 2);
        /* Towards 1 there is no surface. */
        double straight = (n - 1.0) / (n + 1.0);
        double normal = rl_fresnel(n, 0.0, 1.0);
        require(fabs(normal - straight * straight) <= 8.0 * ULP * normal, in, 1);
    }
    print_message("back along the path: %.2g of what is allowed\n", worst);
}

static void test_point_light(void **state)
{
    (void)state;
    struct draw d = begin(6);
    for (int i = 0; i < ROWS; i++) {
        rl_vec3 in[2] = {{draw_any(&d, 1000), draw_any(&d, 1000), draw_any(&d, 1000)},
                         {draw_any(&d, 1000), draw_any(&d, 1000), draw_any(&d, 1000)}};
        if (draw_below(&d, 2)) {
            int reach = draw_below(&d, 4) ? 60 : 1000;
            in[1] = v3_madd(in[0], draw_exponent(&d, -reach, reach), draw_direction(&d));
        }
        if (!isfinite(in[1].x) || !isfinite(in[1].y) || !isfinite(in[1].z))
            continue;
        const struct rl_source there = {.at = in[1], .strength = {1.0, 0.0, 1e30}};
        const struct rl_source back = {.at = in[0], .strength = {1.0, 0.0, 1e30}};
        struct rl_incident a = {.irradiance = {0.0}}, b = a;
        bool seen = rl_incident_from_source(&a, &there, in[0]);
        require(seen == rl_incident_from_source(&b, &back, in[1]), &in[0].x, 6);
        if (!seen)
            continue;
        require(fabs(v3_dot(a.L, a.L) - 1.0) <= 8.0 * ULP, &in[0].x, 6);
        for (int c = 0; c < 3; c++)
            require(a.irradiance[c] >= 0.0 && a.irradiance[c] < INFINITY, &in[0].x, 6);
        require(a.L.x == -b.L.x && a.L.y == -b.L.y && a.L.z == -b.L.z, &in[0].x, 6);
        require(a.irradiance[0] == b.irradiance[0] && a.irradiance[1] == 0.0, &in[0].x, 6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_frames),      cmocka_unit_test(test_printed_frame),
        cmocka_unit_test(test_attenuation), cmocka_unit_test(test_reflectance),
        cmocka_unit_test(test_dielectrics), cmocka_unit_test(test_point_light),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
