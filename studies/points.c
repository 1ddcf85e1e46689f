/* The fixed points (see points.h): numbers by address, so that none depends on how many were made before. */
#include "studies/points.h"

#include <math.h>
#include <stdint.h>

#include "model/frame.h"
#include "model/random.h"

/* ROLLS: numbers that one attempt at a light may use. */
enum { SEED = 20260, ROLLS = 64, POINT_ROLLS = 1 << 20 };

struct dice {
    uint64_t index;
};

static double uniform(struct dice *d, double low, double high)
{
    return low + (high - low) * rl_random_uniform(SEED, d->index++);
}

static double log_uniform(struct dice *d, double low, double high)
{
    return exp(uniform(d, log(low), log(high)));
}

/* At `angle` from the axis, anywhere round it. */
static rl_vec3 about(struct dice *d, rl_vec3 axis, double angle)
{
    struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, axis);
    double round = uniform(d, 0.0, 2.0 * RL_PI);
    return v3_normalize(rl_frame_microfacet_normal(&f, sin(angle), cos(angle), round));
}

static size_t shape(double outline[RL_POINT_VERTICES_MAX][2], struct dice *d, enum rl_point_light_kind kind)
{
    size_t n = kind == RL_POINT_QUAD ? 4 : 10;
    for (size_t i = 0; i < n; i++) {
        /* A corner of a quad is moved by no more than leaves it convex; the star's inner radius is a pentagram's. */
        double angle = 2.0 * RL_PI * (double)i / (double)n, r = i % 2 ? 0.382 : 1.0;
        if (kind == RL_POINT_QUAD) {
            angle += uniform(d, -0.3, 0.3);
            r = uniform(d, 0.8, 1.2);
        }
        outline[i][0] = r * cos(angle);
        outline[i][1] = r * sin(angle);
    }
    return n;
}

/* Half of the lobe lies within tan(delta) = 1/R_r, and a light's direction turns twice as far as the normal. */
static rl_vec3 towards_light(struct dice *d, const struct rl_point *p, double half_size)
{
    double reach = fmin(1.2, half_size + 2.0 * atan(1.0 / p->e.rr));
    return about(d, v3_reflect(p->surface.V, p->surface.N), reach * sqrt(uniform(d, 0.0, 1.0)));
}

static void place_light(struct rl_point *p, struct dice *d, enum rl_point_light_kind kind, rl_vec3 centre,
                        double half_size)
{
    double distance = log_uniform(d, 0.5, 8.0), radius = distance * tan(half_size);
    rl_vec3 normal = about(d, centre, acos(uniform(d, 0.5, 1.0)));
    struct rl_frame f = rl_frame_make(RL_FRAME_ORTHONORMAL, normal);
    double outline[RL_POINT_VERTICES_MAX][2], turn = uniform(d, 0.0, 2.0 * RL_PI);
    p->n_vertices = shape(outline, d, kind);
    for (size_t i = 0; i < p->n_vertices; i++) {
        double x = radius * (cos(turn) * outline[i][0] - sin(turn) * outline[i][1]);
        double y = radius * (sin(turn) * outline[i][0] + cos(turn) * outline[i][1]);
        p->vertex[i] = v3_madd(v3_madd(v3_madd(p->surface.P, distance, centre), x, f.T), y, f.B);
    }
}

void rl_point_make(struct rl_point *point, enum rl_point_light_kind kind, size_t index)
{
    uint64_t first = ((uint64_t)kind << 40) + (uint64_t)index * POINT_ROLLS;
    struct dice d = {first};
    double z = uniform(&d, -1.0, 1.0), round = uniform(&d, 0.0, 2.0 * RL_PI), r = sqrt(1.0 - z * z);
    *point = (struct rl_point){.e = rl_ellipsoid_make(log_uniform(&d, 1.0, 300.0))};
    point->surface.N = v3(r * cos(round), r * sin(round), z);
    point->surface.V = about(&d, point->surface.N, acos(uniform(&d, 0.05, 1.0)));
    double half_size;
    rl_vec3 centre;
    uint64_t attempt = 1;
    do {
        d.index = first + ROLLS * attempt++;
        half_size = log_uniform(&d, 0.1, 0.9);
        centre = towards_light(&d, point, half_size);
    } while (!(v3_dot(centre, point->surface.N) > 0.02));
    place_light(point, &d, kind, centre, half_size);
}

const char *rl_point_light_name(enum rl_point_light_kind kind)
{
    static const char *const name[] = {[RL_POINT_QUAD] = "quad", [RL_POINT_STAR] = "star"};
    return name[kind];
}
