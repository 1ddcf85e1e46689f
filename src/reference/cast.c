/* Rays against polygons (see cast.h). */
#include "reference/cast.h"

#include <stdlib.h>

#include "model/frame.h"
#include "reference/side.h"

/* `level`: P is in the polygon's plane but for rounding; then corners are where they are, for along rays they would be anywhere. */
static void place_outline(struct rl_cast_polygon *polygon, struct rl_point2 *out, const rl_vec3 *vertex,
                          rl_vec3 P, bool level)
{
    polygon->vertex = out;
    for (size_t i = 0; i < polygon->n; i++) {
        rl_vec3 d = v3_sub(vertex[i], vertex[0]), from_P = v3_sub(vertex[i], P);
        /* Along the ray from P into the plane: the factor on from_P, less 1. */
        double slide = level ? 0.0 : -v3_dot(polygon->normal, d) / v3_dot(polygon->normal, from_P);
        d = v3_madd(d, slide, from_P);
        out[i] = (struct rl_point2){v3_dot(polygon->T, d), v3_dot(polygon->B, d)};
        polygon->low.x = i ? fmin(polygon->low.x, out[i].x) : out[i].x;
        polygon->low.y = i ? fmin(polygon->low.y, out[i].y) : out[i].y;
        polygon->high.x = i ? fmax(polygon->high.x, out[i].x) : out[i].x;
        polygon->high.y = i ? fmax(polygon->high.y, out[i].y) : out[i].y;
    }
}

static bool inside(const struct rl_cast_polygon *polygon, double x, double y)
{
    int winding = 0;
    for (size_t i = 0, before = polygon->n - 1; i < polygon->n; before = i++) {
        struct rl_point2 a = polygon->vertex[before], b = polygon->vertex[i];
        bool above_a = a.y > y, above_b = b.y > y;
        if (above_a == above_b)
            continue;
        double turn = (b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y);
        if (above_b ? turn > 0.0 : turn < 0.0)
            winding += above_b ? 1 : -1;
    }
    return winding != 0;
}

int rl_cast_make(struct rl_cast *cast, rl_vec3 P, const struct rl_light_set *set, struct rl_error *error)
{
    *cast = (struct rl_cast){.n_polygons = set->n_polygons};
    cast->polygon = calloc(set->n_polygons + 1, sizeof *cast->polygon);
    cast->vertex = calloc(set->n_vertices + 1, sizeof *cast->vertex);
    if (!cast->polygon || !cast->vertex) {
        rl_cast_free(cast);
        return rl_fail_memory(error, "the lights");
    }
    for (size_t i = 0; i < set->n_polygons; i++) {
        const struct rl_set_polygon *from = &set->polygon[i];
        struct rl_cast_polygon *to = &cast->polygon[i];
        const struct rl_frame frame = rl_frame_make(RL_FRAME_ORTHONORMAL, from->normal);
        rl_vec3 origin = v3_sub(set->vertex[from->first], P);
        *to = (struct rl_cast_polygon){
            .origin = origin, .T = frame.T, .B = frame.B, .normal = from->normal, .n = from->n};
        to->distance = rl_side_distance(set, from, P);
        if (to->distance == 0.0)
            continue;
        bool level = !(fabs(to->distance) > from->thickness + 1e-15 * v3_length(origin));
        place_outline(to, &cast->vertex[from->first], &set->vertex[from->first], P, level);
        /* From beside it is seen edge-on, and covers less than rounding does; from within it is half of all directions. */
        if (level && !inside(to, -v3_dot(to->T, origin), -v3_dot(to->B, origin)))
            to->distance = 0.0;
    }
    return RL_OK;
}

void rl_cast_free(struct rl_cast *cast)
{
    free(cast->polygon);
    free(cast->vertex);
    *cast = (struct rl_cast){0};
}

size_t rl_cast_nearest(const struct rl_cast *cast, rl_vec3 L)
{
    size_t hit = RL_CAST_MISS;
    double nearest = INFINITY;
    for (size_t i = 0; i < cast->n_polygons; i++) {
        const struct rl_cast_polygon *polygon = &cast->polygon[i];
        double t = polygon->distance / v3_dot(polygon->normal, L);
        /* Planes that coincide are met at distances that differ by rounding. */
        if (!(t > 0.0 && t < nearest - 1e-13 * t))
            continue;
        rl_vec3 d = v3_sub(v3_scale(t, L), polygon->origin);
        double x = v3_dot(polygon->T, d), y = v3_dot(polygon->B, d);
        if (x < polygon->low.x || x > polygon->high.x || y < polygon->low.y || y > polygon->high.y ||
            !inside(polygon, x, y))
            continue;
        nearest = t;
        hit = i;
    }
    return hit;
}

bool rl_cast_needless(const struct rl_surface *surface, const struct rl_light_set *set)
{
    return !(v3_dot(surface->N, surface->V) > 0.0) || set->n_polygons == 0 || !(set->brightest > 0.0);
}

double rl_cast_brightest(const struct rl_light_set *set, int channel)
{
    double brightest = 0.0;
    for (size_t i = 0; i < set->n_radiances; i++)
        brightest = fmax(brightest, set->radiance[i][channel]);
    return brightest;
}

void rl_cast_unknown(struct rl_estimate *estimate, const struct rl_light_set *set)
{
    *estimate = (struct rl_estimate){.converged = false};
    for (int c = 0; c < 3; c++)
        estimate->error[c] = rl_cast_brightest(set, c);
}
