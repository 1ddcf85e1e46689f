/* How far a polygon's plane lies off a point (see plane.h).
 *
 * Plain arithmetic tells where the distance is well above its own rounding, and that is nearly always. Else the volume
 *
 *     sum over i of ((v_i - v_0) x (v_(i+1) - v_0)) . (v_0 - P)
 *
 * is added up in pairs of numbers whose sum counts (model/pair.h), as Shewchuk, Adaptive Precision Floating-Point Arithmetic (1997), has it
 * for the same determinant, orient3d.
 */
#include "model/plane.h"

#include <math.h>

#include "model/pair.h"

static struct rl_pair_vec3 difference(rl_vec3 a, rl_vec3 b, double scale)
{
    return (struct rl_pair_vec3){rl_pair_sum(scale * a.x, scale * -b.x),
                                 rl_pair_sum(scale * a.y, scale * -b.y),
                                 rl_pair_sum(scale * a.z, scale * -b.z)};
}

static rl_vec3 high(const struct rl_pair_vec3 *a)
{
    return v3(a->x.high, a->y.high, a->z.high);
}

/* A power of two that brings a length to about 1, so that no product of three leaves the range. */
static double scale_of(double size)
{
    return size > DBL_MIN && size < INFINITY ? ldexp(1.0, -ilogb(size)) : 1.0;
}

static double in_pairs(const rl_vec3 *v, size_t n, rl_vec3 P, rl_vec3 most, double scale, double unit)
{
    double off = 0.0;
    struct rl_pair_vec3 normal = rl_pair_vec3_of(v3(0.0, 0.0, 0.0));
    for (size_t i = 1; i + 1 < n; i++)
        normal = rl_pair_vec3_add(
            normal, rl_pair_cross(difference(v[i], v[0], scale), difference(v[i + 1], v[0], scale)));
    for (size_t i = 1; n > 3 && i < n; i++)
        off = fmax(off, fabs(rl_pair_dot(normal, difference(v[i], v[0], scale)).high));
    double volume = rl_pair_dot(normal, difference(v[0], P, scale)).high;
    double rounding = rl_plane_rounding(high(&normal), v3_scale(scale, most), v3_scale(scale, P), unit);
    return fabs(volume) > 2.0 * off + rounding ? volume / v3_length(high(&normal)) / scale : 0.0;
}

/* As far as plain arithmetic tells; 0: it does not. */
static double in_doubles(const rl_vec3 *v, size_t n, rl_vec3 P, rl_vec3 most, double unit)
{
    rl_vec3 normal = v3(0.0, 0.0, 0.0), first = v3_sub(v[0], P);
    double products = 0.0, off = 0.0, reach = 0.0;
    for (size_t i = 1; i < n; i++) {
        rl_vec3 a = v3_sub(v[i], v[0]), b = v3_sub(v[i + 1 < n ? i + 1 : i], v[0]);
        normal = v3_add(normal, v3_cross(a, b));
        products += v3_length(a) * v3_length(b);
        reach = fmax(reach, v3_length(a));
    }
    for (size_t i = 1; n > 3 && i < n; i++)
        off = fmax(off, fabs(v3_dot(normal, v3_sub(v[i], v[0]))));
    double volume = v3_dot(normal, first);
    /* Some operations on each of the products, the corners' volumes twice. */
    double here = 64.0 * DBL_EPSILON * products * (v3_length(first) + reach);
    return fabs(volume) > 2.0 * off + here + rl_plane_rounding(normal, most, P, unit)
               ? volume / v3_length(normal)
               : 0.0;
}

double rl_plane_distance(const rl_vec3 *v, size_t n, rl_vec3 P, double unit)
{
    rl_vec3 most = rl_plane_most(v, n);
    double scale =
        scale_of(fmax(fmax(fmax(most.x, most.y), fmax(most.z, fabs(P.x))), fmax(fabs(P.y), fabs(P.z))));
    double distance = scale > 0x1p-300 && scale < 0x1p300 ? in_doubles(v, n, P, most, unit) : 0.0;
    return distance != 0.0 ? distance : in_pairs(v, n, P, most, scale, unit);
}
