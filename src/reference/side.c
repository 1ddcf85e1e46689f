/* On which side of a polygon's plane a point lies (see side.h).
 *
 * Plain arithmetic tells where the distance is well above its own rounding, and that is nearly always. Else the volume
 *
 *     sum over i of ((v_i - v_0) x (v_(i+1) - v_0)) . (v_0 - P)
 *
 * is added up in pairs of numbers whose sum counts, of some 104 bits: the difference of two numbers is such a pair exactly (Knuth,
 * The Art of Computer Programming 2, section 4.2.2, theorem B), and so is their product (Dekker 1971; by the fused multiply-add). As
 * Shewchuk, Adaptive Precision Floating-Point Arithmetic (1997), has it for the same determinant, orient3d.
 */
#include "reference/side.h"

#include <float.h>

/* high + low, |low| <= half a unit in the last place of high. */
struct pair {
    double high, low;
};

struct pair_vec3 {
    struct pair x, y, z;
};

static struct pair sum_of(double a, double b)
{
    double s = a + b, of_b = s - a;
    return (struct pair){s, (a - (s - of_b)) + (b - of_b)};
}

static struct pair add(struct pair a, struct pair b)
{
    struct pair s = sum_of(a.high, b.high), t = sum_of(a.low, b.low);
    s = sum_of(s.high, s.low + t.high);
    return sum_of(s.high, s.low + t.low);
}

static struct pair multiply(struct pair a, struct pair b)
{
    double product = a.high * b.high;
    return sum_of(product, fma(a.high, b.high, -product) + (a.high * b.low + a.low * b.high));
}

static struct pair minus(struct pair a)
{
    return (struct pair){-a.high, -a.low};
}

static struct pair_vec3 difference(rl_vec3 a, rl_vec3 b, double scale)
{
    return (struct pair_vec3){sum_of(scale * a.x, scale * -b.x), sum_of(scale * a.y, scale * -b.y),
                              sum_of(scale * a.z, scale * -b.z)};
}

static struct pair determinant(struct pair a, struct pair d, struct pair b, struct pair c)
{
    return add(multiply(a, d), minus(multiply(b, c)));
}

static struct pair_vec3 cross(const struct pair_vec3 *a, const struct pair_vec3 *b)
{
    return (struct pair_vec3){determinant(a->y, b->z, a->z, b->y), determinant(a->z, b->x, a->x, b->z),
                              determinant(a->x, b->y, a->y, b->x)};
}

static double dot(const struct pair_vec3 *a, const struct pair_vec3 *b)
{
    return add(add(multiply(a->x, b->x), multiply(a->y, b->y)), multiply(a->z, b->z)).high;
}

static double length(const struct pair_vec3 *a)
{
    return v3_length(v3(a->x.high, a->y.high, a->z.high));
}

/* A power of two that brings a length to about 1, so that no product of three leaves the range. */
static double scale_of(double size)
{
    return size > DBL_MIN && size < DBL_MAX ? ldexp(1.0, -ilogb(size)) : 1.0;
}

static double largest(rl_vec3 a)
{
    return fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z)));
}

/* The largest of the points' coordinates on each axis. */
static rl_vec3 coordinates(const rl_vec3 *v, size_t n, rl_vec3 P)
{
    rl_vec3 most = v3(fabs(P.x), fabs(P.y), fabs(P.z));
    for (size_t i = 0; i < n; i++)
        most = v3(fmax(most.x, fabs(v[i].x)), fmax(most.y, fabs(v[i].y)), fmax(most.z, fabs(v[i].z)));
    return most;
}

static double distance_in_pairs(const rl_vec3 *v, size_t n, rl_vec3 P)
{
    /* Closer than this many units in the last place of the coordinates themselves is in the plane. */
    static const double units = 8.0 * DBL_EPSILON;
    rl_vec3 size = coordinates(v, n, P);
    double scale = scale_of(largest(size)), off = 0.0;
    struct pair_vec3 normal = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    for (size_t i = 1; i + 1 < n; i++) {
        struct pair_vec3 a = difference(v[i], v[0], scale), b = difference(v[i + 1], v[0], scale),
                         c = cross(&a, &b);
        normal = (struct pair_vec3){add(normal.x, c.x), add(normal.y, c.y), add(normal.z, c.z)};
    }
    for (size_t i = 1; n > 3 && i < n; i++) {
        struct pair_vec3 a = difference(v[i], v[0], scale);
        off = fmax(off, fabs(dot(&normal, &a)));
    }
    struct pair_vec3 first = difference(v[0], P, scale);
    double volume = dot(&normal, &first);
    double rounding =
        units * scale *
        (fabs(normal.x.high) * size.x + fabs(normal.y.high) * size.y + fabs(normal.z.high) * size.z);
    return fabs(volume) > 2.0 * off + rounding ? volume / length(&normal) / scale : 0.0;
}

double rl_side_distance(const struct rl_light_set *set, const struct rl_set_polygon *polygon, rl_vec3 P)
{
    const rl_vec3 *vertex = &set->vertex[polygon->first];
    rl_vec3 first = v3_sub(vertex[0], P);
    double distance = v3_dot(polygon->normal, first);
    if (fabs(distance) > polygon->thickness + 1e-15 * v3_length(first))
        return distance;
    return distance_in_pairs(vertex, polygon->n, P);
}
