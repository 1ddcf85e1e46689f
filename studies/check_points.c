/* The check's cases of the integrators: single points, each hard in its own way. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "reference/integrators.h"
#include "studies/check_parts.h"

enum { VERTICES_MAX = 10, POLYGONS_MAX = 2 };

static const struct point {
    const char *name;
    rl_vec3 N, V; /* any length */
    size_t n_polygons;
    size_t n[POLYGONS_MAX];
    rl_vec3 vertex[POLYGONS_MAX][VERTICES_MAX];
} points[] = {
    /* The mirror direction is inside. */
    {"overhead",
     {0.1, 0.2, 1.0},
     {0.3, -0.2, 0.9},
     1,
     {4},
     {{{-1.2, -0.4, 2.0}, {0.8, -0.4, 2.0}, {0.8, 1.6, 2.2}, {-1.2, 1.6, 2.2}}}},
    /* Seen at 8 degrees above the surface: masking everywhere. */
    {"grazing",
     {0.0, 0.0, 1.0},
     {0.99, 0.0, 0.14},
     1,
     {4},
     {{{-2.0, -1.0, 0.2}, {-2.0, 1.0, 0.2}, {-2.0, 1.0, 1.6}, {-2.0, -1.0, 1.6}}}},
    /* A light that the horizon cuts. */
    {"horizon",
     {0.2, -0.1, 1.0},
     {0.5, 0.3, 0.8},
     1,
     {3},
     {{{-1.5, -1.5, -0.8}, {-1.0, 1.2, -0.5}, {-1.3, -0.2, 1.9}}}},
    /* Half a degree across. */
    {"small",
     {0.0, 0.0, 1.0},
     {0.3, 0.1, 0.95},
     1,
     {3},
     {{{-0.300, -0.108, 0.95}, {-0.292, -0.100, 0.95}, {-0.306, -0.098, 0.95}}}},
    /* Not convex. */
    {"star",
     {0.0, 0.1, 1.0},
     {0.1, 0.4, 0.9},
     1,
     {10},
     {{{0.0, 1.0, 2.0},
       {-0.2351, 0.3236, 2.0},
       {-0.9511, 0.3090, 2.0},
       {-0.3804, -0.1236, 2.0},
       {-0.5878, -0.8090, 2.0},
       {0.0, -0.4, 2.0},
       {0.5878, -0.8090, 2.0},
       {0.3804, -0.1236, 2.0},
       {0.9511, 0.3090, 2.0},
       {0.2351, 0.3236, 2.0}}}},
    /* Two lights, the nearer one hides a part of the other. */
    {"two",
     {0.1, 0.0, 1.0},
     {0.4, 0.2, 0.9},
     2,
     {3, 4},
     {{{-1.0, -1.0, 1.5}, {0.5, -0.8, 1.5}, {-0.4, 0.9, 1.5}},
      {{-1.5, -1.5, 3.0}, {1.5, -1.5, 3.0}, {1.5, 0.5, 3.0}, {-1.5, 0.5, 3.0}}}},
};

static const struct point *find(const char *name)
{
    for (size_t i = 0; i < sizeof points / sizeof points[0]; i++)
        if (strcmp(points[i].name, name) == 0)
            return &points[i];
    return NULL;
}

static void add_estimate(struct rl_check_rows *rows, const struct rl_integrator *it,
                         const struct rl_estimate *estimate)
{
    double value = estimate->value[0];
    /* The exhaustive sum's stated error is about the texels' size; its own rounding is that of each texel's term in single precision. */
    if (it->uses & RL_USES_ENV_SIZE)
        rl_check_fixed(rows, "value", RL_BEST_SAME, value, 16.0 * FLT_EPSILON * fabs(value),
                       "16 ulp of single precision: each program within 8", false);
    else
        rl_check_fixed(rows, "value", RL_BEST_SAME, value,
                       2.0 * estimate->error[0] + 4.0 * DBL_EPSILON * fabs(value),
                       "twice the stated error: each program within it", false);
}

int rl_check_point(struct rl_check_rows *rows, const struct rl_check_case *c,
                   struct rl_check_context *context)
{
    (void)context;
    char name[RL_NAME_MAX] = "", method[RL_NAME_MAX] = "";
    rl_parameter(c->parameters, "point", name, sizeof name);
    rl_parameter(c->parameters, "method", method, sizeof method);
    const struct point *p = find(name);
    const struct rl_integrator *it = rl_integrator_find(method);
    if (!p || !it)
        return rl_fail(rows->error, RL_ERR_INPUT, "there is no point %s or no integrator %s", name, method);
    const rl_vec3 *polygon[POLYGONS_MAX];
    for (size_t i = 0; i < p->n_polygons; i++)
        polygon[i] = p->vertex[i];
    struct rl_light_set *set = NULL;
    int status = rl_light_set_from_polygons(&set, polygon, p->n, p->n_polygons, rows->error);
    if (status != RL_OK)
        return status;
    const struct rl_ellipsoid e = rl_ellipsoid_make(rl_parameter_number(c->parameters, "rr"));
    const struct rl_surface surface = {.N = v3_normalize(p->N), .V = v3_normalize(p->V)};
    double env_size = rl_parameter_number(c->parameters, "env_size");
    const struct rl_integrate_options options = {
        .attenuation = !rl_parameters_match(c->parameters, "attenuation=off"),
        .frame =
            rl_parameters_match(c->parameters, "frame=printed") ? RL_FRAME_PRINTED : RL_FRAME_ORTHONORMAL,
        .tolerance = 1e-11,
        .simd = rl_parameters_match(c->parameters, "simd=plain") ? RL_SIMD_PLAIN : rl_simd_best(),
        .env_size = isnan(env_size) ? 0 : (int)env_size};
    struct rl_estimate estimate;
    status = it->integrate(&estimate, &surface, &e, set, &options, rows->error);
    rl_light_set_free(set);
    if (status == RL_OK)
        add_estimate(rows, it, &estimate);
    return status;
}
