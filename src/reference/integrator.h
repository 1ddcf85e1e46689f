/* The integral L_o at one point, by integration along lines, in double precision, on the true polygons.
 *
 *     L_o = (1/pi) integral over theta in [0,pi), delta in [-pi/2,pi/2] of D(delta) G L_e(P, L) d delta d theta
 *
 * For one theta the reflected direction runs once round a circle as delta does; where it crosses the lights' edges has a closed
 * form (lines.h), and so has the integral between crossings, attenuated or not (inner.h). Over theta what is left breaks where the
 * circle passes a vertex, touches an edge, or a crossing passes a kink of G: all known in advance (breaks.h). There the range is
 * split, and each panel is integrated adaptively (quadrature.h).
 *
 * With attenuation off G = 1 for every L, also below the horizon: then constant radiance all round gives exactly 1.
 */
#ifndef RL_REFERENCE_INTEGRATOR_H
#define RL_REFERENCE_INTEGRATOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "base/simd.h"
#include "effects/effect.h"
#include "model/ellipsoid.h"
#include "scene/scene.h"

/* The lights as the integrator wants them: every polygon of every light with its radiance. */
struct rl_light_set;
int rl_light_set_make(struct rl_light_set **set, const struct rl_light *lights, size_t n_lights,
                      struct rl_error *error);
/* Planar polygons given directly, two-sided, of radiance 1: polygon i has n_vertices[i] >= 3 vertices. RL_ERR_INPUT
 * names the polygon that is not so. */
int rl_light_set_from_polygons(struct rl_light_set **set, const rl_vec3 *const vertices[],
                               const size_t n_vertices[], size_t n_polygons, struct rl_error *error);
void rl_light_set_free(struct rl_light_set *set);

/* What hides the lights (occlusion.h). */
struct rl_occlusion;

struct rl_integrate_options {
    bool attenuation;
    enum rl_frame_kind frame; /* RL_FRAME_PRINTED: H as the paper's frame gives it, normalised */
    double tolerance;         /* absolute error wanted, in units of the brightest radiance of the set */
    size_t
        max_evaluations; /* 0: the integrator's own. Past it the best value so far and its error are returned */
    enum rl_simd simd;   /* instruction set of `reference`; rl_simd_best() for the fastest */
    uint64_t seed;       /* of those that draw random numbers */
    double confidence;   /* of those: the error is the half width of the interval of this level; 0: 0.99 */
    int env_size;        /* of `exhaustive`: texels along a face's edge; 0: 512 */
    struct rl_occlusion *occlusion; /* of the reference: seen from this very point; NULL: nothing hides */
    /* Of the reference, with V = N and attenuation (which here is no more than the horizon): E/pi, the irradiance, in place of L_o. The
     * lines are then the meridians about N, and a stretch of one gives half the difference of its ends' squared sines. */
    bool irradiance;
};

struct rl_estimate {
    double value[3], error[3]; /* RGB; |value - truth| <= error is meant to hold */
    size_t evaluations;        /* lines drawn; of the witnesses what their rows say (integrators.h) */
    bool converged;            /* error within tolerance */
};

/* One point. Thread-safe: `set` is only read. N and V unit vectors; V.N <= 0 gives 0. */
void rl_integrate_lines(struct rl_estimate *estimate, const struct rl_surface *surface,
                        const struct rl_ellipsoid *e, const struct rl_light_set *set,
                        const struct rl_integrate_options *options);

#endif
