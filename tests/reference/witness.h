/* Independent ways to the same integral, for tests only: nothing here knows of lines.
 *
 *   witness_area   the integral over the light's own area: d omega_L = 4 (V.H) d omega_H and d omega_H = |sin delta| d delta d theta, so
 *
 *                      L_o = (1/pi) integral over the light of  D(delta) G / (4 (V.H) |sin delta|)  d omega_L
 *
 *                  by nested adaptive quadrature (GSL) over triangles with one corner where the mirror direction meets the plane,
 *                  which takes the pole out
 *   witness_dense  the definition: a midpoint rule over (U, theta), a ray for each normal
 *
 * One polygon each, radiance 1. The dense rule takes several and any frame.
 */
#ifndef TESTS_REFERENCE_WITNESS_H
#define TESTS_REFERENCE_WITNESS_H

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <stdbool.h>
#include <stddef.h>

#include "effects/effect.h"
#include "model/attenuation.h"
#include "model/ellipsoid.h"
#include "model/frame.h"

struct witness {
    struct rl_surface s;
    struct rl_ellipsoid e;
    bool attenuation;
    double tolerance;
    rl_vec3 apex, along_a, along_b, normal; /* the triangle: apex + u ((1-v) along_a + v along_b) */
    double twice_area, u;
    gsl_integration_workspace *outer, *inner;
};

#define WITNESS_PIECES 4000

static inline double witness_integrand(double v, void *user)
{
    const struct witness *w = user;
    rl_vec3 x = v3_madd(w->apex, w->u * (1.0 - v), w->along_a);
    x = v3_sub(v3_madd(x, w->u * v, w->along_b), w->s.P);
    double r = v3_length(x);
    rl_vec3 L = v3_scale(1.0 / r, x);
    rl_vec3 H = v3_normalize(v3_add(L, w->s.V));
    double n_h = v3_dot(w->s.N, H), v_h = v3_dot(w->s.V, H);
    double sine = v3_length(v3_cross(w->s.N, H));
    if (v_h == 0.0 || sine == 0.0)
        return 0.0;
    double g = w->attenuation ? rl_attenuation(n_h, v3_dot(w->s.N, w->s.V), v3_dot(w->s.N, L), v_h) : 1.0;
    double solid_angle = fabs(v3_dot(w->normal, L)) / (r * r);
    return rl_ellipsoid_pdf_sincos(&w->e, sine, fabs(n_h)) * g / (4.0 * fabs(v_h) * sine) * solid_angle *
           w->twice_area * w->u;
}

static inline double witness_at_u(double u, void *user)
{
    struct witness *w = user;
    w->u = u;
    gsl_function f = {.function = witness_integrand, .params = w};
    double value = 0.0, error = 0.0;
    gsl_integration_qag(&f, 0.0, 1.0, 0.1 * w->tolerance, 1e-13, WITNESS_PIECES, GSL_INTEG_GAUSS61, w->inner,
                        &value, &error);
    return value;
}

static inline double witness_area(const struct rl_surface *s, double rr, const rl_vec3 *vertex, size_t n,
                                  bool attenuation, double tolerance)
{
    struct witness w = {
        .s = *s, .e = rl_ellipsoid_make(rr), .attenuation = attenuation, .tolerance = tolerance};
    w.outer = gsl_integration_workspace_alloc(WITNESS_PIECES);
    w.inner = gsl_integration_workspace_alloc(WITNESS_PIECES);
    rl_vec3 normal = v3(0.0, 0.0, 0.0), centre = v3(0.0, 0.0, 0.0);
    for (size_t i = 0; i < n; i++) {
        normal =
            v3_add(normal, v3_cross(v3_sub(vertex[i], vertex[0]), v3_sub(vertex[(i + 1) % n], vertex[0])));
        centre = v3_madd(centre, 1.0 / (double)n, vertex[i]);
    }
    w.normal = v3_normalize(normal);
    double radius = 0.0;
    for (size_t i = 0; i < n; i++)
        radius = fmax(radius, v3_length(v3_sub(vertex[i], centre)));
    rl_vec3 mirror = v3_reflect(s->V, s->N);
    double t = v3_dot(w.normal, v3_sub(vertex[0], s->P)) / v3_dot(w.normal, mirror);
    rl_vec3 hit = v3_madd(s->P, t, mirror);
    w.apex = t > 0.0 && v3_length(v3_sub(hit, centre)) < 3.0 * radius ? hit : vertex[0];

    gsl_function f = {.function = witness_at_u, .params = &w};
    gsl_error_handler_t *handler = gsl_set_error_handler_off(); /* rounding reached: the best value is used */
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) {
        w.along_a = v3_sub(vertex[i], w.apex);
        w.along_b = v3_sub(vertex[(i + 1) % n], w.apex);
        w.twice_area = v3_dot(w.normal, v3_cross(w.along_a, w.along_b));
        double value = 0.0, error = 0.0;
        if (fabs(w.twice_area) > 1e-14 * radius * radius)
            gsl_integration_qag(&f, 0.0, 1.0, tolerance, 1e-13, WITNESS_PIECES, GSL_INTEG_GAUSS61, w.outer,
                                &value, &error);
        sum += value;
    }
    gsl_set_error_handler(handler);
    gsl_integration_workspace_free(w.outer);
    gsl_integration_workspace_free(w.inner);
    return sum / RL_PI;
}

/* Distance along L, or 0 for a miss. */
static inline double witness_hit(rl_vec3 P, rl_vec3 L, const rl_vec3 *vertex, size_t n)
{
    rl_vec3 normal = v3(0.0, 0.0, 0.0);
    for (size_t i = 1; i + 1 < n; i++)
        normal = v3_add(normal, v3_cross(v3_sub(vertex[i], vertex[0]), v3_sub(vertex[i + 1], vertex[0])));
    double t = v3_dot(normal, v3_sub(vertex[0], P)) / v3_dot(normal, L);
    if (!(t > 0.0))
        return 0.0;
    rl_vec3 x = v3_madd(P, t, L);
    /* Winding number by the signed angles at x. */
    double turn = 0.0;
    for (size_t i = 0; i < n; i++) {
        rl_vec3 a = v3_sub(vertex[i], x), b = v3_sub(vertex[(i + 1) % n], x);
        turn += atan2(v3_dot(normal, v3_cross(a, b)) / v3_length(normal), v3_dot(a, b));
    }
    return fabs(turn) > 1.0 ? t : 0.0;
}

/* The midpoint rule with n x n normals over (U, theta); polygon i has radiance[i]. */
static inline double witness_dense(const struct rl_surface *s, double rr, enum rl_frame_kind kind,
                                   const rl_vec3 *const *vertices, const size_t *n_vertices,
                                   const double *radiance, size_t n_polygons, bool attenuation, int n)
{
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    struct rl_frame frame = rl_frame_make(kind, s->N);
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        struct rl_delta d = rl_ellipsoid_inverse(&e, (i + 0.5) / n);
        for (int j = 0; j < n; j++) {
            rl_vec3 H = v3_normalize(
                rl_frame_microfacet_normal(&frame, d.sin_delta, d.cos_delta, RL_PI * (j + 0.5) / n));
            rl_vec3 L = v3_sub(v3_scale(2.0 * v3_dot(s->V, H), H), s->V);
            double nearest = INFINITY, seen = 0.0;
            for (size_t k = 0; k < n_polygons; k++) {
                double t = witness_hit(s->P, L, vertices[k], n_vertices[k]);
                if (t > 0.0 && t < nearest) {
                    nearest = t;
                    seen = radiance[k];
                }
            }
            double g = attenuation ? rl_attenuation(v3_dot(s->N, H), v3_dot(s->N, s->V), v3_dot(s->N, L),
                                                    v3_dot(s->V, H))
                                   : 1.0;
            sum += g * seen;
        }
    }
    return sum / ((double)n * n);
}

#endif
