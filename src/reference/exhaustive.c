/* The integrator `exhaustive`: the sum over every texel of an environment map rendered from the very point (texel_map.h), and how far
 * off it may be.
 *
 * Its error has four parts.
 *
 *   edges     A texel that an edge passes through counts whole or not at all, as its centre is seen; its weight times what it should
 *             count, the polygon's coverage of it, less what it counts is known, and so is the sum over all: |sum| is the part, and on
 *             top of it, since the weight is not constant over the texel, each texel's variation of it, one by one. Where several
 *             polygons may meet in a texel, coverage says little: then the texel counts with its weight times the range of radiances
 *             about it.
 *   interior  The curvature of the weight, and its poles: the difference between maps of this size and of half of it, with edges as
 *             they should count, which is three times the error where that falls as h^2 and the error itself where it falls as h; and,
 *             lest two agree by chance, a quarter of the next difference.
 *   grazing   An eye so close to the horizon that no square of the pole's is as low: all that it can see (see most_at_grazing).
 *   rounding  Directions are floats, the pole's integrals good to 5e-4 of what lies near to it.
 */
#include <math.h>
#include <stdlib.h>

#include "reference/integrators.h"
#include "reference/texel_edges.h"
#include "reference/texel_map.h"
#include "reference/texel_pole.h"

enum { SIZE_BY_DEFAULT = 512, SIZE_LEAST = 8, SIZE_MOST = 4096 };

struct question {
    const struct rl_surface *surface;
    const struct rl_ellipsoid *e;
    const struct rl_light_set *set;
    bool attenuation;
};

struct level {
    double value[3];   /* as the texels' centres say */
    double covered[3]; /* with edges as they should count */
    double slack[3];   /* what that leaves unknown of the edges */
    size_t evaluations;
};

/* A texel's place, and the integral of the weight over it. */
struct texel {
    int face, x, y;
    double integral,
        variation; /* variation: what a shift of the lit part may change of `integral` times its part */
};

/* The weight's logarithm changes by up to 3/|y| (1/|y| of the pole, 2/|y| of D), and with G by 1/(N.V): times the sixth of an edge by
 * which the lit part's centroid may lie off, times the part itself. Where the horizon passes through, the weight at the centre says
 * nothing: the most of the corners' stands for it. */
static double variation_of(const struct question *q, const struct rl_texel_pole *pole, const struct texel *t,
                           double s, double u, double half)
{
    rl_vec3 L = rl_cube_direction(t->face, s, u);
    double edge = 2.0 * half / v3_length(L), y = fmax(rl_texel_distance(pole, t->face, s, u), 0.5 * edge);
    double part = edge / 6.0 * (3.0 / y + (q->attenuation ? 1.0 / pole->v.z : 0.0));
    double variation = fmin(1.0, part) * t->integral;
    if (!q->attenuation || v3_dot(q->surface->N, L) > 2.0 * half)
        return variation;
    /* A corner may be the pole itself: 1/|y| has a mean of some 4 over the edge about it. */
    struct rl_texel_pole held = *pole;
    held.reach = 0.25 * edge;
    double most = 0.0;
    for (int i = 0; i < 4; i++)
        most = fmax(most,
                    rl_texel_weight(&held, t->face, s + (i & 1 ? half : -half), u + (i & 2 ? half : -half)));
    return variation + most * rl_texel_solid_angle(s, u, half);
}

static struct texel texel_at(const struct question *q, const struct rl_texel_pole *pole, int size,
                             uint32_t index, size_t *evaluations)
{
    struct texel t = {.face = (int)(index / ((uint32_t)size * (uint32_t)size)),
                      .x = (int)(index % (uint32_t)size),
                      .y = (int)(index / (uint32_t)size % (uint32_t)size)};
    double s = (2 * t.x + 1.0) / size - 1.0, u = (2 * t.y + 1.0) / size - 1.0;
    t.integral = rl_texel_integral(pole, t.face, s, u, 1.0 / size, evaluations);
    t.variation = variation_of(q, pole, &t, s, u, 1.0 / size);
    return t;
}

static void widen(double low[3], double high[3], const double radiance[3])
{
    for (int c = 0; c < 3; c++) {
        low[c] = fmin(low[c], radiance[c]);
        high[c] = fmax(high[c], radiance[c]);
    }
}

/* The range of radiances of a texel, its neighbours and a polygon; also where one polygon pierces another, which is no edge of
 * either. */
static void radiances_about(double low[3], double high[3], const struct question *q,
                            const struct rl_cube_map *cube, const struct texel *t, uint32_t polygon)
{
    static const double black[3] = {0.0, 0.0, 0.0};
    for (int c = 0; c < 3; c++)
        low[c] = high[c] = q->set->radiance[q->set->polygon[polygon].radiance][c];
    for (int y = t->y - 1; y <= t->y + 1; y++)
        for (int x = t->x - 1; x <= t->x + 1; x++) {
            if (x < 0 || y < 0 || x >= cube->size || y >= cube->size)
                continue;
            size_t row = (size_t)t->face * (size_t)cube->size + (size_t)y;
            unsigned seen = cube->seen[row * (size_t)cube->size + (size_t)x];
            widen(low, high, seen ? q->set->radiance[seen - 1] : black);
        }
}

/* One polygon is all there is: its coverage says what each texel should count. */
static void correct_edges(struct level *level, const struct question *q, const struct rl_texel_pole *pole,
                          const struct rl_cube_map *cube, const struct rl_texel_edges *edges)
{
    const double *radiance = q->set->radiance[0];
    for (size_t i = 0; i < edges->n; i++) {
        const struct rl_texel_edge *edge = &edges->edge[i];
        struct texel t = texel_at(q, pole, cube->size, edge->texel, &level->evaluations);
        double less = edge->coverage - (cube->seen[edge->texel] ? 1.0 : 0.0);
        for (int c = 0; c < 3; c++) {
            level->covered[c] += less * t.integral * radiance[c];
            level->slack[c] += t.variation * radiance[c];
        }
    }
}

/* Several polygons: the worst that each texel may be off. */
static void allow_for_edges(struct level *level, const struct question *q, const struct rl_texel_pole *pole,
                            const struct rl_cube_map *cube, const struct rl_texel_edges *edges)
{
    for (size_t i = 0; i < edges->n; i++) {
        struct texel t = texel_at(q, pole, cube->size, edges->edge[i].texel, &level->evaluations);
        double low[3], high[3];
        radiances_about(low, high, q, cube, &t, edges->edge[i].polygon);
        for (int c = 0; c < 3; c++)
            level->slack[c] += (t.integral + t.variation) * (high[c] - low[c]);
    }
}

static int at_size(struct level *level, const struct question *q, int size, struct rl_error *error)
{
    *level = (struct level){.evaluations = 0};
    struct rl_texel_map *map = NULL;
    struct rl_texel_edges edges = {0};
    int status = rl_texel_map_make(&map, q->set, q->surface->P, size, error);
    if (status == RL_OK)
        status = rl_texel_edges_find(&edges, q->set, q->surface->P, size, error);
    if (status == RL_OK) {
        level->evaluations = rl_texel_map_integrate(level->value, map, q->surface, q->e, q->attenuation);
        for (int c = 0; c < 3; c++)
            level->covered[c] = level->value[c];
        struct rl_texel_pole pole = rl_texel_pole_make(q->surface, q->e, q->attenuation, 0.0);
        if (q->set->n_polygons == 1)
            correct_edges(level, q, &pole, rl_texel_map_cube(map), &edges);
        else
            allow_for_edges(level, q, &pole, rl_texel_map_cube(map), &edges);
    }
    rl_texel_edges_clear(&edges);
    rl_texel_map_free(map);
    return status;
}

/* What can come back to an eye of small v_N = N.V, from a light of radiance 1 all round. At azimuth theta, with v_t = cos(theta) and a = v_N/|v_t|,
 * D <= D_0, G <= min(1, 2 v_N/(v_N + v_t tan(delta))) where the facet faces the eye: the integral over delta is at most
 * D_0 a (1 + 2 log(1 + 1/a)), and at most 1. Its mean over theta: a's is v_N (1 + log(2/v_N)) where a < 1. */
static double most_at_grazing(const struct question *q, int size)
{
    double v_n = v3_dot(q->surface->N, q->surface->V), rr = q->e->rr;
    if (!q->attenuation || v_n >= fmax(1.0, rr) * RL_TEXEL_GRAZING / size)
        return 0.0;
    double d_0 = q->e->norm * fmax(1.0, 0.5 + 0.5 / rr);
    return fmin(1.0, d_0 * v_n * (1.0 + 2.0 * log(1.0 + 1.0 / v_n)) * (1.0 + log(2.0 / v_n)));
}

static void conclude(struct rl_estimate *estimate, const struct level level[3], double grazing,
                     double tolerance)
{
    estimate->converged = true;
    for (int c = 0; c < 3; c++) {
        double edges = fabs(level[0].value[c] - level[0].covered[c]) + level[0].slack[c];
        double interior = fabs(level[0].covered[c] - level[1].covered[c]) +
                          0.25 * fabs(level[1].covered[c] - level[2].covered[c]);
        estimate->value[c] = level[0].value[c];
        estimate->error[c] = edges + interior + grazing + 5e-4 * fabs(level[0].value[c]);
        estimate->converged = estimate->converged && estimate->error[c] <= tolerance;
    }
    for (int i = 0; i < 3; i++)
        estimate->evaluations += level[i].evaluations;
}

static int check(const struct rl_integrate_options *options, int size, struct rl_error *error)
{
    if (options->frame != RL_FRAME_ORTHONORMAL)
        return rl_fail(error, RL_ERR_INPUT, "exhaustive: found the frame %s, expected %s",
                       rl_frame_name(options->frame), rl_frame_name(RL_FRAME_ORTHONORMAL));
    if (size < SIZE_LEAST || size > SIZE_MOST)
        return rl_fail(error, RL_ERR_INPUT,
                       "exhaustive: found an environment map of %d texels, expected %d to %d", size,
                       SIZE_LEAST, SIZE_MOST);
    return RL_OK;
}

static int integrate(struct rl_estimate *estimate, const struct rl_surface *surface,
                     const struct rl_ellipsoid *e, const struct rl_light_set *set,
                     const struct rl_integrate_options *options, struct rl_error *error)
{
    int size = options->env_size > 0 ? options->env_size : SIZE_BY_DEFAULT;
    *estimate = (struct rl_estimate){.converged = true};
    int status = check(options, size, error);
    if (status != RL_OK || !(v3_dot(surface->N, surface->V) > 0.0))
        return status;
    struct question question = {surface, e, set, options->attenuation};
    struct level level[3];
    for (int i = 0; i < 3 && status == RL_OK; i++)
        status = at_size(&level[i], &question, size >> i, error);
    if (status == RL_OK)
        conclude(estimate, level, most_at_grazing(&question, size) * set->brightest,
                 options->tolerance * set->brightest);
    return status;
}

const struct rl_integrator rl_integrator_exhaustive = {
    .name = "exhaustive",
    .summary = "every texel of an environment map rendered from the point",
    .evaluation = "texels",
    .error = "bounds the true error: edges as their texels' coverage says, the rest from maps of half and a "
             "quarter of the size",
    .uses = RL_USES_ENV_SIZE,
    .integrate = integrate,
};
