/* Effects without a highlight, from their textbooks: constant light, Lambert's law, and Lambert's irradiance of a polygon; and what a point
 * light gives.
 *
 *     k_d/pi max(0, N.L)                                     of light from L (Lambert 1760)
 *     k_d/pi |1/2 sum of angle_i (gamma_i . N)|              of a polygon, with what is below the horizon N.v = 0 cut off;
 *                                                            gamma_i along v_i x v_i+1, angle_i between v_i and v_i+1
 *                                                            0 of one in whose plane P is but for rounding (src/model/plane.h)
 *     (Q - P)/|Q - P|, 1/|Q - P|^2                           of a point light at Q; at P itself it gives nothing
 */
#include "exact_arithmetic.h"

#include <math.h>

void exact_ambient(mpfr_t out[], mpfr_t in[])
{
    for (int c = 0; c < 3; c++)
        give(out[c], in[9 + c]);
}

void exact_diffuse(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    num n_l = most_of(number(0.0), dot(unit(vector(in, 0)), unit(vector(in, 6))));
    for (int c = 0; c < 3; c++)
        give(out[c], over(times(in[9 + c], n_l), pi()));
}

/* Sutherland and Hodgman's clipping (1974) by the half space N.v > 0; what lies in the plane is kept where it belongs to an edge that comes
 * up from it. */
static size_t clip(vec to[], const vec v[], size_t n, vec N)
{
    size_t made = 0;
    for (size_t i = 0; i < n; i++) {
        vec a = v[i], b = v[(i + 1) % n];
        num z_a = dot(N, a), z_b = dot(N, b);
        bool above_a = sign_of(z_a) > 0, above_b = sign_of(z_b) > 0;
        if (above_a)
            to[made++] = a;
        if (above_a != above_b)
            to[made++] = sum(a, scaled(over(z_a, minus(z_a, z_b)), difference(b, a)));
    }
    return made;
}

double exact_unit = 0x1p-52;

/* What the model's convention has as in the triangle's plane, P being 0: |A.v_0| at most some units of the coordinates' size, axis by axis;
 * A = (v_1 - v_0) x (v_2 - v_0). In single precision 2 units, in double 16. */
static bool is_in_plane(const vec v[3])
{
    vec A = cross(difference(v[1], v[0]), difference(v[2], v[0])),
        most = {number(0.0), number(0.0), number(0.0)};
    for (size_t i = 0; i < 3; i++) {
        most.x = most_of(most.x, size_of(v[i].x));
        most.y = most_of(most.y, size_of(v[i].y));
        most.z = most_of(most.z, size_of(v[i].z));
    }
    num size =
        plus(times(size_of(A.x), most.x), plus(times(size_of(A.y), most.y), times(size_of(A.z), most.z)));
    num units = number(exact_unit * (exact_unit > 0x1p-52 ? 2.0 : 16.0));
    return sign_of(minus(size_of(dot(A, v[0])), times(units, size))) <= 0;
}

void exact_diffuse_area_polygon(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    vec N = unit(vector(in, 0)), v[3], w[8];
    for (size_t i = 0; i < 3; i++)
        v[i] = vector(in, 6 + 3 * i);
    size_t n = clip(w, v, 3, N);
    num total = number(0.0);
    for (size_t i = 0; i < n; i++) {
        vec a = w[i], b = w[(i + 1) % n], across = cross(a, b);
        num size = length(across);
        /* No direction: P is on the edge's line. */
        if (sign_of(size) > 0)
            total = plus(total, times(angle(size, dot(a, b)), over(dot(N, across), size)));
    }
    num irradiance = is_in_plane(v) ? number(0.0) : times(number(0.5), size_of(total));
    for (int c = 0; c < 3; c++)
        give(out[c], over(times(in[15 + c], irradiance), pi()));
}

/* The solid angle that the triangle has at most: what it gives where it and N face each other. Seen edge on by both it gives next to nothing of
 * that, and the sum over its edges has that error. */
double exact_diffuse_area_whole(mpfr_t in[])
{
    exact_begin();
    vec v[3];
    num distance = number(0.0), size = number(0.0);
    for (size_t i = 0; i < 3; i++)
        v[i] = vector(in, 6 + 3 * i);
    for (size_t i = 0; i < 3; i++) {
        distance = most_of(distance, length(v[i]));
        size = most_of(size, length(difference(v[i], v[(i + 1) % 3])));
    }
    return sign_of(distance) > 0 ? mpfr_get_d(square(over(least_of(size, distance), distance)), MPFR_RNDN)
                                 : 0.0;
}

/* In the triangle's plane P sees one side of it or the other, all of the sky or none. Beside it, by d of its size, directions of horizon and edges
 * that pass P are known to 1/d units in the last place: two thirds of the digits are to be left. */
bool exact_in_plane(mpfr_t in[], int bits)
{
    exact_begin();
    vec a = vector(in, 6), b = vector(in, 9), c = vector(in, 12);
    vec normal = cross(difference(b, a), difference(c, a));
    num size = most_of(length(a), most_of(length(b), length(c))), reach = times(length(normal), size);
    return mpfr_cmp(size_of(dot(normal, a)), times(number(ldexp(1.0, -bits / 3)), reach)) <= 0;
}

void exact_point_light(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    vec d = difference(vector(in, 3), vector(in, 0)), L = {number(0.0), number(0.0), number(1.0)};
    num r_r = dot(d, d), e = number(0.0);
    if (sign_of(r_r) > 0) {
        L = unit(d);
        e = over(number(1.0), r_r);
    }
    give(out[0], L.x);
    give(out[1], L.y);
    give(out[2], L.z);
    give(out[3], e);
}
