/* Points, directions and polygons for the tests of the integrators: from fixed, printed seeds. */
#ifndef TESTS_REFERENCE_FIXTURE_H
#define TESTS_REFERENCE_FIXTURE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "model/random.h"
#include "reference/integrator.h"

#define LENGTH(a) (sizeof(a) / sizeof(a)[0])

enum { SHAPE_MAX = 16 };

struct shape {
    size_t n;
    rl_vec3 vertex[SHAPE_MAX];
};

struct dice {
    uint64_t seed, index;
};

static inline struct dice dice_make(uint64_t seed)
{
    printf("seed %llu\n", (unsigned long long)seed);
    return (struct dice){seed, 0};
}

static inline double uniform(struct dice *d, double low, double high)
{
    return low + (high - low) * rl_random_uniform(d->seed, d->index++);
}

static inline rl_vec3 unit_vector(struct dice *d)
{
    double z = uniform(d, -1.0, 1.0), angle = uniform(d, 0.0, 2.0 * RL_PI), r = sqrt(1.0 - z * z);
    return v3(r * cos(angle), r * sin(angle), z);
}

/* A point with N.V >= n_v_least. */
static inline struct rl_surface surface_point(struct dice *d, double n_v_least)
{
    struct rl_surface s = {.P = v3(uniform(d, -1.0, 1.0), uniform(d, -1.0, 1.0), uniform(d, -1.0, 1.0)),
                           .N = unit_vector(d)};
    do
        s.V = unit_vector(d);
    while (v3_dot(s.N, s.V) < n_v_least);
    return s;
}

/* n vertices round a centre in a plane of random tilt, their distances from it between the two radii in turn; both equal and
 * jitter 0: regular. */
static inline struct shape polygon_about(struct dice *d, rl_vec3 centre, size_t n, double even, double odd,
                                         double jitter)
{
    struct shape shape = {.n = n};
    rl_vec3 normal = unit_vector(d), t = v3_normalize(v3_cross(normal, unit_vector(d))),
            b = v3_cross(normal, t);
    for (size_t i = 0; i < n; i++) {
        double angle = 2.0 * RL_PI * ((double)i + uniform(d, 0.0, jitter)) / (double)n;
        double r = (i % 2 ? odd : even) * (1.0 - uniform(d, 0.0, jitter));
        shape.vertex[i] = v3_madd(v3_madd(centre, r * cos(angle), t), r * sin(angle), b);
    }
    return shape;
}

/* Where lights matter: somewhere about the mirror direction, 1 to 2 away. */
static inline rl_vec3 near_mirror(struct dice *d, const struct rl_surface *s, double spread)
{
    rl_vec3 mirror = v3_reflect(s->V, s->N);
    rl_vec3 direction = v3_normalize(v3_madd(mirror, uniform(d, 0.0, spread), unit_vector(d)));
    return v3_madd(s->P, uniform(d, 1.0, 2.0), direction);
}

/* A light of 3 to 6 jittered vertices (even numbers of which may be far from convex), or a ten-edged star. */
static inline struct shape random_light(struct dice *d, const struct rl_surface *s)
{
    rl_vec3 centre = near_mirror(d, s, 0.8);
    double radius = uniform(d, 0.1, 1.1);
    size_t n = 3 + (size_t)uniform(d, 0.0, 5.0);
    if (n == 7)
        return polygon_about(d, centre, 10, 0.38 * radius, radius, 0.0);
    return polygon_about(d, centre, n, radius, radius, 0.5);
}

static inline struct rl_light_set *set_of(const struct shape *shapes, size_t n)
{
    const rl_vec3 *vertices[SHAPE_MAX];
    size_t n_vertices[SHAPE_MAX];
    for (size_t i = 0; i < n; i++) {
        vertices[i] = shapes[i].vertex;
        n_vertices[i] = shapes[i].n;
    }
    struct rl_light_set *set = NULL;
    struct rl_error error;
    if (rl_light_set_from_polygons(&set, vertices, n_vertices, n, &error) != RL_OK)
        printf("%s\n", error.message);
    return set;
}

/* Polygon i is a light of radiance[i] grey. */
static inline struct rl_light_set *lights_of(const struct shape *shapes, const double *radiance, size_t n)
{
    struct rl_light light[SHAPE_MAX] = {{0}};
    struct rl_polygon polygon[SHAPE_MAX] = {{0}};
    for (size_t i = 0; i < n; i++) {
        polygon[i].n = (int)shapes[i].n;
        polygon[i].vertex = (rl_vec3 *)shapes[i].vertex;
        light[i].n_polygons = 1;
        light[i].polygon = &polygon[i];
        for (int c = 0; c < 3; c++)
            light[i].radiance[c] = radiance[i];
    }
    struct rl_light_set *set = NULL;
    rl_light_set_make(&set, light, n, NULL);
    return set;
}

static inline struct rl_estimate integrate(const struct rl_surface *s, double rr,
                                           const struct rl_light_set *set, bool attenuation, double tolerance)
{
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    struct rl_estimate estimate;
    rl_integrate_lines(&estimate, s, &e, set,
                       &(struct rl_integrate_options){
                           .attenuation = attenuation, .tolerance = tolerance, .simd = rl_simd_best()});
    return estimate;
}

/* The value for one or several polygons of radiance 1. */
static inline double value_of(const struct rl_surface *s, double rr, const struct shape *shapes, size_t n,
                              bool attenuation, double tolerance)
{
    struct rl_light_set *set = set_of(shapes, n);
    double value = integrate(s, rr, set, attenuation, tolerance).value[0];
    rl_light_set_free(set);
    return value;
}

#endif
