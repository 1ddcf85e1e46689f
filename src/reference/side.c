/* On which side of a polygon's plane a point lies (see side.h).
 *
 * Plain arithmetic tells where the distance is well above its own rounding, and that is nearly always. Else the volume
 *
 *     sum over i of ((v_i - v_0) x (v_(i+1) - v_0)) . (v_0 - P)
 *
 * is added up in pairs of numbers (model/pair.h), as Shewchuk, Adaptive Precision Floating-Point Arithmetic (1997), has it for the same
 * determinant, orient3d.
 */
#include "reference/side.h"

#include <float.h>

#include "model/pair.h"

static struct rl_pair_vec3 difference(rl_vec3 a, rl_vec3 b, double scale)
{
    return (struct rl_pair_vec3){rl_pair_sum(scale * a.x, scale * -b.x),
                                 rl_pair_sum(scale * a.y, scale * -b.y),
                                 rl_pair_sum(scale * a.z, scale * -b.z)};
}

static double length(struct rl_pair_vec3 a)
{
    return v3_length(v3(a.x.high, a.y.high, a.z.high));
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
    struct rl_pair_vec3 normal = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    for (size_t i = 1; i + 1 < n; i++) {
        struct rl_pair_vec3 a = difference(v[i], v[0], scale), b = difference(v[i + 1], v[0], scale),
                            c = rl_pair_cross(a, b);
        normal = rl_pair_vec3_add(normal, c);
    }
    for (size_t i = 1; n > 3 && i < n; i++)
        off = fmax(off, fabs(rl_pair_dot(normal, difference(v[i], v[0], scale)).high));
    double volume = rl_pair_dot(normal, difference(v[0], P, scale)).high;
    double rounding =
        units * scale *
        (fabs(normal.x.high) * size.x + fabs(normal.y.high) * size.y + fabs(normal.z.high) * size.z);
    return fabs(volume) > 2.0 * off + rounding ? volume / length(normal) / scale : 0.0;
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
