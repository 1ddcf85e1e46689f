/* Checks a polygon and tiles it with triangles by ear clipping (Meisters 1975): an ear is a convex corner
 * whose triangle holds no other vertex, and every simple polygon of more than three vertices has one.
 *
 * All of it works on the polygon laid flat along Newell's normal. */
#include <stdbool.h>
#include <stdlib.h>

#include "scene/scene.h"

/* Offsets from the plane up to this part of the polygon's size are taken for rounding. */
#define PLANAR_TOLERANCE 1e-6
/* Points closer to a line than this part of the size lie on it. */
#define TOUCH_TOLERANCE 1e-12

struct point {
    double x, y;
};

struct flat {
    int n;
    double size; /* largest distance of a vertex from the first */
    struct point p[RL_POLYGON_VERTICES_MAX];
};

/* Twice the signed area of abc. */
static double turn(struct point a, struct point b, struct point c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* -1, 0 or 1; 0 where c is on the line ab as far as rounding can tell. */
static int side(const struct flat *f, struct point a, struct point b, struct point c)
{
    double t = turn(a, b, c), limit = TOUCH_TOLERANCE * f->size * f->size;
    return (t > limit) - (t < -limit);
}

static bool within_box(struct point a, struct point b, struct point p)
{
    return p.x >= fmin(a.x, b.x) && p.x <= fmax(a.x, b.x) && p.y >= fmin(a.y, b.y) && p.y <= fmax(a.y, b.y);
}

/* Whether the closed segments ab and cd have a point in common. */
static bool segments_meet(const struct flat *f, struct point a, struct point b, struct point c,
                          struct point d)
{
    int c_side = side(f, a, b, c), d_side = side(f, a, b, d), a_side = side(f, c, d, a),
        b_side = side(f, c, d, b);
    if (c_side * d_side < 0 && a_side * b_side < 0)
        return true;
    return (c_side == 0 && within_box(a, b, c)) || (d_side == 0 && within_box(a, b, d)) ||
           (a_side == 0 && within_box(c, d, a)) || (b_side == 0 && within_box(c, d, b));
}

/* Newell's normal: the sum of the cross products of successive vertices, twice the area long. */
static rl_vec3 newell(const rl_vec3 *vertex, int n)
{
    rl_vec3 sum = v3(0.0, 0.0, 0.0);
    for (int i = 1; i + 1 < n; i++)
        sum = v3_add(sum, v3_cross(v3_sub(vertex[i], vertex[0]), v3_sub(vertex[i + 1], vertex[0])));
    return sum;
}

static void flatten(struct flat *f, const rl_vec3 *vertex, int n, rl_vec3 normal)
{
    struct rl_frame frame = rl_frame_make(RL_FRAME_ORTHONORMAL, normal);
    f->n = n;
    for (int i = 0; i < n; i++) {
        rl_vec3 d = v3_sub(vertex[i], vertex[0]);
        f->p[i] = (struct point){v3_dot(d, frame.T), v3_dot(d, frame.B)};
    }
}

static int check_flat(const rl_vec3 *vertex, int n, rl_vec3 normal, double size, struct rl_error *error)
{
    rl_vec3 mean = v3(0.0, 0.0, 0.0);
    for (int i = 0; i < n; i++)
        mean = v3_madd(mean, 1.0 / n, vertex[i]);
    for (int i = 0; i < n; i++) {
        double off = fabs(v3_dot(v3_sub(vertex[i], mean), normal));
        if (off > PLANAR_TOLERANCE * size)
            return rl_fail(error, RL_ERR_INPUT,
                           "found vertex %d off the polygon's plane by %.3g, expected a planar polygon", i,
                           off);
    }
    return RL_OK;
}

static int check_simple(const struct flat *f, struct rl_error *error)
{
    int n = f->n;
    for (int i = 0; i < n; i++) {
        struct point a = f->p[i], b = f->p[(i + 1) % n], c = f->p[(i + 2) % n];
        if (hypot(b.x - a.x, b.y - a.y) <= TOUCH_TOLERANCE * f->size)
            return rl_fail(error, RL_ERR_INPUT,
                           "found vertex %d at the same place as vertex %d, expected distinct vertices",
                           (i + 1) % n, i);
        if (side(f, a, b, c) == 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0.0)
            return rl_fail(error, RL_ERR_INPUT,
                           "found the edges at vertex %d on top of each other, expected a simple polygon",
                           (i + 1) % n);
    }
    for (int i = 0; i < n; i++)
        for (int j = i + 2; j < n; j++)
            if (!(i == 0 && j == n - 1) && segments_meet(f, f->p[i], f->p[i + 1], f->p[j], f->p[(j + 1) % n]))
                return rl_fail(error, RL_ERR_INPUT,
                               "found edges %d and %d (from the vertices of those numbers) meeting, expected "
                               "a simple polygon",
                               i, j);
    return RL_OK;
}

/* How good an ear the corner between `before` and `after` is: its height over its longest edge relative to
 * that edge, or -1 if it is none. Taking the best ear avoids slivers. */
static double ear_quality(const struct flat *f, const int *left, int n_left, int corner)
{
    int before = left[(corner + n_left - 1) % n_left], at = left[corner], after = left[(corner + 1) % n_left];
    struct point a = f->p[before], b = f->p[at], c = f->p[after];
    if (side(f, a, b, c) <= 0)
        return -1.0;
    for (int i = 0; i < n_left; i++) {
        int other = left[i];
        if (other != before && other != at && other != after && side(f, a, b, f->p[other]) >= 0 &&
            side(f, b, c, f->p[other]) >= 0 && side(f, c, a, f->p[other]) >= 0)
            return -1.0;
    }
    double longest =
        fmax(hypot(b.x - a.x, b.y - a.y), fmax(hypot(c.x - b.x, c.y - b.y), hypot(a.x - c.x, a.y - c.y)));
    return turn(a, b, c) / (longest * longest);
}

static int clip_ears(struct rl_polygon *polygon, const struct flat *f, struct rl_error *error)
{
    int left[RL_POLYGON_VERTICES_MAX], n_left = f->n;
    for (int i = 0; i < n_left; i++)
        left[i] = i;
    for (int t = 0; t < f->n - 2; t++) {
        int best = -1;
        double best_quality = -1.0;
        for (int i = 0; i < n_left; i++) {
            double quality = ear_quality(f, left, n_left, i);
            if (quality > best_quality) {
                best = i;
                best_quality = quality;
            }
        }
        if (best < 0)
            return rl_fail(
                error, RL_ERR_INPUT,
                "found edges too close to each other to tell inside from outside, expected a simple polygon");
        polygon->triangle[t][0] = (uint32_t)left[(best + n_left - 1) % n_left];
        polygon->triangle[t][1] = (uint32_t)left[best];
        polygon->triangle[t][2] = (uint32_t)left[(best + 1) % n_left];
        n_left--;
        for (int i = best; i < n_left; i++)
            left[i] = left[i + 1];
    }
    return RL_OK;
}

static int fill(struct rl_polygon *polygon, const rl_vec3 *vertex, int n, const struct flat *f,
                struct rl_error *error)
{
    polygon->n = n;
    polygon->vertex = malloc((size_t)n * sizeof *polygon->vertex);
    polygon->triangle = malloc((size_t)(n - 2) * sizeof *polygon->triangle);
    if (!polygon->vertex || !polygon->triangle)
        return rl_fail_memory(error, "a polygon");
    for (int i = 0; i < n; i++)
        polygon->vertex[i] = vertex[i];
    return clip_ears(polygon, f, error);
}

int rl_polygon_make(struct rl_polygon *polygon, const rl_vec3 *vertex, int n, struct rl_error *error)
{
    *polygon = (struct rl_polygon){0};
    if (n < 3 || n > RL_POLYGON_VERTICES_MAX)
        return rl_fail(error, RL_ERR_INPUT, "found %d vertices, expected 3 to %d", n,
                       RL_POLYGON_VERTICES_MAX);
    struct flat f = {.size = 0.0};
    for (int i = 0; i < n; i++) {
        if (!isfinite(vertex[i].x) || !isfinite(vertex[i].y) || !isfinite(vertex[i].z))
            return rl_fail(error, RL_ERR_INPUT, "found vertex %d (%g, %g, %g), expected finite numbers", i,
                           vertex[i].x, vertex[i].y, vertex[i].z);
        f.size = fmax(f.size, v3_length(v3_sub(vertex[i], vertex[0])));
        if (!isfinite(f.size))
            return rl_fail(error, RL_ERR_INPUT,
                           "found vertices 0 and %d farther apart than any number, expected a distance", i);
    }
    rl_vec3 sum = newell(vertex, n);
    polygon->normal = v3_normalize(sum);
    polygon->area = 0.5 * v3_length(sum);
    if (!(polygon->area > TOUCH_TOLERANCE * f.size * f.size)) {
        *polygon = (struct rl_polygon){0};
        return rl_fail(
            error, RL_ERR_INPUT,
            "found a polygon of zero area (in line, or crossing itself), expected an area above 0");
    }
    flatten(&f, vertex, n, polygon->normal);
    int status = check_flat(vertex, n, polygon->normal, f.size, error);
    if (status == RL_OK)
        status = check_simple(&f, error);
    if (status == RL_OK)
        status = fill(polygon, vertex, n, &f, error);
    if (status != RL_OK)
        rl_polygon_clear(polygon);
    return status;
}

void rl_polygon_clear(struct rl_polygon *polygon)
{
    free(polygon->vertex);
    free(polygon->triangle);
    *polygon = (struct rl_polygon){0};
}
