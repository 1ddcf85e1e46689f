/* Draws polygons into cube maps, row by row (see cube_map.h).
 *
 * A row of texel centres lies in a plane through the eye point, which cuts a polygon's plane in a line and the polygon in stretches of
 * that line. They are found before anything is projected, so that polygons may reach behind the eye point: only then is each stretch
 * cut where it passes behind and taken to the face. */
#include "reference/cube_map.h"

#include <math.h>
#include <stdlib.h>

#include "reference/side.h"

/* Axes s, t and outward of each face. */
static const signed char axes[RL_CUBE_FACES][3][3] = {
    {{0, 0, -1}, {0, -1, 0}, {1, 0, 0}},  /* +x */
    {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},  /* -x */
    {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},    /* +y */
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},  /* -y */
    {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},   /* +z */
    {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, /* -z */
};

rl_vec3 rl_cube_direction(int face, double s, double t)
{
    const signed char(*a)[3] = axes[face];
    return v3(s * a[0][0] + t * a[1][0] + a[2][0], s * a[0][1] + t * a[1][1] + a[2][1],
              s * a[0][2] + t * a[1][2] + a[2][2]);
}

static double along(const signed char axis[3], rl_vec3 v)
{
    return axis[0] * v.x + axis[1] * v.y + axis[2] * v.z;
}

rl_vec3 rl_cube_on_face(int face, rl_vec3 v)
{
    return v3(along(axes[face][0], v), along(axes[face][1], v), along(axes[face][2], v));
}

/* tan(solid angle/2) of the triangle of corners a, b, c of lengths la, lb, lc, over twice its area on the face. */
static double half_tangent(rl_vec3 a, double la, rl_vec3 b, double lb, rl_vec3 c, double lc)
{
    return 1.0 / (la * lb * lc + v3_dot(a, b) * lc + v3_dot(b, c) * la + v3_dot(c, a) * lb);
}

double rl_cube_solid_angle(double s, double t, double half)
{
    rl_vec3 a = v3(s - half, t - half, 1.0), b = v3(s + half, t - half, 1.0);
    rl_vec3 c = v3(s + half, t + half, 1.0), d = v3(s - half, t + half, 1.0);
    double la = v3_length(a), lb = v3_length(b), lc = v3_length(c), ld = v3_length(d);
    double doubled = 4.0 * half * half;
    double one = doubled * half_tangent(a, la, b, lb, c, lc),
           two = doubled * half_tangent(a, la, c, lc, d, ld);
    return 2.0 * atan((one + two) / (1.0 - one * two));
}

/* A place where a polygon's outline passes through a row's plane. */
struct pass {
    double s, w;     /* in the plane: along the face's s axis, and outward */
    double position; /* on the line in which the two planes meet */
    int sign;
};

struct face {
    int number, size;
    rl_vec3 *vertex; /* of the polygon being drawn, on the face's axes */
    struct pass *pass;
    /* 1/distance along each texel's direction, of what is seen so far; NULL: all is one radiance. */
    double *nearest;
    struct rl_cube_box *lit; /* of this face */
    uint16_t *seen;          /* of this face */
    rl_vec3 nearness;        /* of the polygon: 1/distance in direction (s, t, 1) is nearness.(s, t, 1) */
    uint16_t radiance;
};

/* A row belongs to [low, high) of what passes through it, as a texel of it does to [from, to): where two polygons share an edge, no texel
 * is lost between them, nor seen by both. For that the edge is gone along from the side that is not above the row, whichever way round
 * the polygon has it: both then compute the same place, bit for bit. */
static size_t find_passes(const struct face *f, size_t n, double t)
{
    size_t found = 0;
    for (size_t i = 0; i < n; i++) {
        rl_vec3 a = f->vertex[i], b = f->vertex[i + 1 < n ? i + 1 : 0];
        double from = a.y - t * a.z, to = b.y - t * b.z;
        if ((from > 0.0) == (to > 0.0))
            continue;
        rl_vec3 low = to > 0.0 ? a : b, high = to > 0.0 ? b : a;
        double below = fmin(from, to), span = fmax(from, to) - below, at = -below / span;
        /* w = z + at (difference of z), with the terms in t gone: they are all but equal where the edge's plane all but holds the face's
         * axis. */
        double w = (low.z * (high.y - low.y) - low.y * (high.z - low.z)) / span;
        struct pass p = {.s = low.x + at * (high.x - low.x), .w = w, .sign = to > 0.0 ? 1 : -1};
        p.position = f->nearness.x * p.w - (f->nearness.y * t + f->nearness.z) * p.s;
        size_t place = found++;
        for (; place > 0 && f->pass[place - 1].position > p.position; place--)
            f->pass[place] = f->pass[place - 1];
        f->pass[place] = p;
    }
    return found;
}

/* The first texel whose centre is not left of s. */
static int texel_from(const struct face *f, double s)
{
    double x = ceil(0.5 * ((s + 1.0) * f->size - 1.0));
    return x <= 0.0 ? 0 : x >= f->size ? f->size : (int)x;
}

/* Where a stretch's end is seen; `other` is its other end. Behind the eye point the stretch is cut, which is at infinity. */
static double project(const struct pass *end, const struct pass *other)
{
    if (end->w > 0.0)
        return end->s / end->w;
    return copysign(INFINITY, end->s * other->w - other->s * end->w);
}

static void enclose(struct rl_cube_box *box, int first, int end, int row)
{
    box->from[0] = first < box->from[0] ? first : box->from[0];
    box->to[0] = end > box->to[0] ? end : box->to[0];
    box->from[1] = row < box->from[1] ? row : box->from[1];
    box->to[1] = row >= box->to[1] ? row + 1 : box->to[1];
}

static void fill_stretch(const struct face *f, int row, double t, const struct pass *a, const struct pass *b)
{
    if (!(a->w > 0.0) && !(b->w > 0.0))
        return;
    double from = project(a, b), to = project(b, a);
    int first = texel_from(f, fmin(from, to)), end = texel_from(f, fmax(from, to));
    size_t start = (size_t)row * (size_t)f->size;
    if (first < end)
        enclose(f->lit, first, end, row);
    for (int x = first; x < end; x++) {
        size_t i = start + (size_t)x;
        if (f->nearest) {
            double s = (2 * x + 1.0) / f->size - 1.0;
            double near = f->nearness.x * s + f->nearness.y * t + f->nearness.z;
            if (!(near > f->nearest[i]))
                continue;
            f->nearest[i] = near;
        }
        f->seen[i] = f->radiance;
    }
}

static void draw_row(const struct face *f, size_t n, int row)
{
    double t = (2 * row + 1.0) / f->size - 1.0;
    size_t passes = find_passes(f, n, t);
    int winding = 0;
    for (size_t i = 0; i + 1 < passes; i++) {
        winding += f->pass[i].sign;
        if (winding != 0)
            fill_stretch(f, row, t, &f->pass[i], &f->pass[i + 1]);
    }
}

/* A polygon whose vertices lie on the face's axes already. */
static void draw_polygon(const struct face *f, size_t n)
{
    double low = INFINITY, high = -INFINITY;
    bool behind = false;
    for (size_t i = 0; i < n; i++) {
        behind = behind || !(f->vertex[i].z > 0.0);
        low = fmin(low, f->vertex[i].y / f->vertex[i].z);
        high = fmax(high, f->vertex[i].y / f->vertex[i].z);
    }
    /* One more at either end: which rows an outline passes through is decided there, where it does not depend on rounding. */
    int first = behind ? 0 : texel_from(f, low) - 1, end = behind ? f->size : texel_from(f, high) + 1;
    for (int row = first < 0 ? 0 : first; row < end && row < f->size; row++)
        draw_row(f, n, row);
}

static bool in_front(const struct face *f, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (f->vertex[i].z > 0.0)
            return true;
    return false;
}

static void draw_face(struct face *f, const struct rl_light_set *set, rl_vec3 from)
{
    for (size_t i = 0; i < set->n_polygons; i++) {
        const struct rl_set_polygon *polygon = &set->polygon[i];
        double distance = rl_side_distance(set, polygon, from);
        if (distance == 0.0)
            continue; /* seen edge-on */
        for (size_t k = 0; k < polygon->n; k++)
            f->vertex[k] = rl_cube_on_face(f->number, v3_sub(set->vertex[polygon->first + k], from));
        f->nearness = v3_scale(1.0 / distance, rl_cube_on_face(f->number, polygon->normal));
        f->radiance = (uint16_t)(polygon->radiance + 1);
        if (in_front(f, polygon->n))
            draw_polygon(f, polygon->n);
    }
}

static size_t most_vertices(const struct rl_light_set *set)
{
    size_t most = 0;
    for (size_t i = 0; i < set->n_polygons; i++)
        most = set->polygon[i].n > most ? set->polygon[i].n : most;
    return most;
}

int rl_cube_map_make(struct rl_cube_map *map, const struct rl_light_set *set, rl_vec3 from, int size,
                     struct rl_error *error)
{
    size_t texels = (size_t)size * (size_t)size, n = most_vertices(set) + 1;
    if (set->n_radiances >= UINT16_MAX)
        return rl_fail(error, RL_ERR_INPUT, "found lights of %zu different radiances, expected up to %d",
                       set->n_radiances, UINT16_MAX - 1);
    *map = (struct rl_cube_map){.size = size, .seen = calloc(RL_CUBE_FACES * texels, sizeof *map->seen)};
    struct face f = {.size = size,
                     .vertex = malloc(n * sizeof *f.vertex),
                     .pass = malloc(n * sizeof *f.pass),
                     .nearest = set->n_radiances > 1 ? malloc(texels * sizeof *f.nearest) : NULL};
    bool ready = map->seen && f.vertex && f.pass && (f.nearest || set->n_radiances <= 1);
    for (f.number = 0; f.number < RL_CUBE_FACES && ready; f.number++) {
        f.seen = map->seen + (size_t)f.number * texels;
        f.lit = &map->lit[f.number];
        *f.lit = (struct rl_cube_box){{size, size}, {0, 0}};
        for (size_t i = 0; i < texels && f.nearest; i++)
            f.nearest[i] = 0.0;
        draw_face(&f, set, from);
    }
    free(f.vertex);
    free(f.pass);
    free(f.nearest);
    if (ready)
        return RL_OK;
    rl_cube_map_clear(map);
    return rl_fail_memory(error, "an environment map");
}

void rl_cube_map_clear(struct rl_cube_map *map)
{
    free(map->seen);
    *map = (struct rl_cube_map){0};
}
