/* Points of the exact sphere and teapot, and where meshes of them have these points (see interpolation.h). The order of vertices and
 * triangles is that of scene/shapes.c and scene/teapot.c. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "scene/teapot.h"
#include "studies/interpolation.h"

struct rl_mesh_locator {
    const struct rl_mesh *mesh;
    size_t n; /* tessellation */
    /* Of the teapot: the triangle of each half of each cell, or NONE where it has no area. NULL: a sphere. */
    size_t *half;
};

#define NONE SIZE_MAX

static rl_vec3 corner(const struct rl_mesh *mesh, size_t triangle, int k)
{
    const float *p = mesh->position[mesh->triangle[triangle][k]];
    return v3(p[0], p[1], p[2]);
}

/* ---- The teapot ---- */

/* Which patch a vertex is of, and where in its grid: i along v, j along u. */
struct grid_point {
    size_t patch, i, j;
};

static struct grid_point grid_point(size_t vertex, size_t n)
{
    size_t row = n + 1, in_patch = vertex % (row * row);
    return (struct grid_point){vertex / (row * row), in_patch / row, in_patch % row};
}

/* A cell's first half holds the corner on the next row of v, its second the one on the next column of u. */
static size_t half_index(size_t patch, size_t i, size_t j, size_t n, bool second)
{
    return 2 * ((patch * n + i) * n + j) + second;
}

static int fill_halves(struct rl_mesh_locator *l, struct rl_error *error)
{
    size_t n_halves = (size_t)2 * RL_TEAPOT_PATCHES * l->n * l->n;
    l->half = malloc(n_halves * sizeof *l->half);
    if (!l->half)
        return rl_fail_memory(error, "a table of triangles");
    for (size_t h = 0; h < n_halves; h++)
        l->half[h] = NONE;
    for (size_t t = 0; t < l->mesh->n_triangles; t++) {
        const uint32_t *k = l->mesh->triangle[t];
        struct grid_point at = grid_point(k[0], l->n);
        l->half[half_index(at.patch, at.i, at.j, l->n, k[1] != k[0] + l->n + 1)] = t;
    }
    return RL_OK;
}

/* Which of n cells x in [0, 1] is in, and how far. */
static size_t cell_of(double x, size_t n, double *within)
{
    double scaled = fmin(fmax(x, 0.0), 1.0) * (double)n;
    double cell = fmin(floor(scaled), (double)(n - 1));
    *within = scaled - cell;
    return (size_t)cell;
}

static struct rl_mesh_point locate_on_patch(const struct rl_mesh_locator *l, const struct rl_exact_point *p)
{
    double a, b;
    size_t j = cell_of(p->u, l->n, &a), i = cell_of(p->v, l->n, &b);
    bool second = a > b;
    size_t triangle = l->half[half_index((size_t)p->patch, i, j, l->n, second)];
    if (triangle ==
        NONE) { /* at the lid's tip one half has no area: the diagonal stands for it, at the same v */
        second = !second;
        triangle = l->half[half_index((size_t)p->patch, i, j, l->n, second)];
        a = b;
    }
    if (second)
        return (struct rl_mesh_point){triangle, {1.0 - a, b, a - b}};
    return (struct rl_mesh_point){triangle, {1.0 - b, b - a, a}};
}

static void exact_on_patch(struct rl_exact_point *point, const struct rl_mesh *mesh, size_t n,
                           const struct rl_mesh_point *at)
{
    double u = 0.0, v = 0.0;
    for (int k = 0; k < 3; k++) {
        struct grid_point g = grid_point(mesh->triangle[at->triangle][k], n);
        u += at->weight[k] * (double)g.j / (double)n;
        v += at->weight[k] * (double)g.i / (double)n;
        point->patch = (int)g.patch;
    }
    point->u = fmin(fmax(u, 0.0), 1.0);
    point->v = fmin(fmax(v, 0.0), 1.0);
    rl_teapot_evaluate(point->patch, point->u, point->v, &point->P, &point->N);
}

/* ---- The sphere ---- */

/* X = s (weights x corners), weights that sum to 1; returns the least of them, negative outside. */
static double weigh(struct rl_mesh_point *at, const struct rl_mesh *mesh, size_t triangle, rl_vec3 X)
{
    rl_vec3 a = corner(mesh, triangle, 0), b = corner(mesh, triangle, 1), c = corner(mesh, triangle, 2);
    double w[3] = {v3_dot(X, v3_cross(b, c)), v3_dot(X, v3_cross(c, a)), v3_dot(X, v3_cross(a, b))};
    double sum = w[0] + w[1] + w[2];
    at->triangle = triangle;
    for (int k = 0; k < 3; k++)
        at->weight[k] = w[k] / sum;
    return fmin(at->weight[0], fmin(at->weight[1], at->weight[2]));
}

/* Between two rings of latitude a triangle's edge is a great circle, not a circle of latitude: the triangle may be in the row above or
 * below. */
static struct rl_mesh_point locate_on_sphere(const struct rl_mesh_locator *l, rl_vec3 X)
{
    size_t rows = 2 * l->n, columns = 4 * l->n, triangles_of_column = 2 * (rows - 1);
    double longitude = atan2(X.z, X.x);
    double within;
    size_t column =
        cell_of((longitude < 0.0 ? longitude + 2.0 * RL_PI : longitude) / (2.0 * RL_PI), columns, &within);
    size_t row = cell_of(acos(fmin(fmax(X.y, -1.0), 1.0)) / RL_PI, rows, &within);
    struct rl_mesh_point best = {0}, at;
    double inside = -INFINITY;
    for (size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < rows; r++) {
        /* In a column come the caps at both poles, then two triangles for each row between. */
        bool cap = r == 0 || r == rows - 1;
        size_t first = cap ? (r > 0 ? 1 : 0) : 2 * r;
        for (size_t t = first; t < first + (cap ? 1 : 2); t++) {
            double least = weigh(&at, l->mesh, column * triangles_of_column + t, X);
            if (least > inside) {
                inside = least;
                best = at;
            }
        }
    }
    return best;
}

/* ---- Either ---- */

static bool is_teapot(const char *object)
{
    return strcmp(object, "teapot") == 0;
}

void rl_exact_from_mesh(struct rl_exact_point *point, const char *object, const struct rl_mesh *mesh,
                        int tessellation, const struct rl_mesh_point *at)
{
    *point = (struct rl_exact_point){.patch = -1};
    if (is_teapot(object)) {
        exact_on_patch(point, mesh, (size_t)tessellation, at);
        return;
    }
    rl_vec3 sum = v3(0.0, 0.0, 0.0);
    for (int k = 0; k < 3; k++)
        sum = v3_madd(sum, at->weight[k], corner(mesh, at->triangle, k));
    point->P = point->N = v3_normalize(sum);
}

int rl_mesh_locator_make(struct rl_mesh_locator **locator, const char *object, const struct rl_mesh *mesh,
                         int tessellation, struct rl_error *error)
{
    struct rl_mesh_locator *l = calloc(1, sizeof *l);
    *locator = NULL;
    if (!l)
        return rl_fail_memory(error, "a table of triangles");
    l->mesh = mesh;
    l->n = (size_t)tessellation;
    int status = is_teapot(object) ? fill_halves(l, error) : RL_OK;
    if (status != RL_OK) {
        free(l);
        return status;
    }
    *locator = l;
    return RL_OK;
}

void rl_mesh_locator_free(struct rl_mesh_locator *locator)
{
    if (locator)
        free(locator->half);
    free(locator);
}

struct rl_mesh_point rl_mesh_locate(const struct rl_mesh_locator *locator, const struct rl_exact_point *point)
{
    return locator->half ? locate_on_patch(locator, point) : locate_on_sphere(locator, point->P);
}
