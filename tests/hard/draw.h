/* Numbers drawn for tests of properties: uniform in the exponent, not in value, about every place where a function of floating point has
 * reason to fail: 0, 1, 1/2, both ends of a range, and what lies a few units in the last place beside them. A number is a function of seed
 * and index alone.
 *
 *     struct draw d = {.seed = 20261126};
 *     double rr = draw_between(&d, RL_RR_MIN, RL_RR_MAX);
 *     rl_vec3 N = draw_direction(&d);                           of any length, along an axis or nearly so now and then
 */
#ifndef RL_TESTS_HARD_DRAW_H
#define RL_TESTS_HARD_DRAW_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "model/random.h"
#include "model/vec3.h"

struct draw {
    uint64_t seed, index;
    bool single; /* exponents of single precision, and numbers that it holds */
};

/* SplitMix64; seeds are few here, and far apart, so that they need no mixing of their own. */
static inline uint64_t draw_bits(struct draw *d)
{
    return rl_random_mix(d->seed + ++d->index * UINT64_C(0x9e3779b97f4a7c15));
}

static inline double draw_uniform(struct draw *d)
{
    return ((double)(draw_bits(d) >> 12) + 0.5) * 0x1p-52;
}

/* Below n. */
static inline unsigned draw_below(struct draw *d, unsigned n)
{
    return (unsigned)((draw_bits(d) >> 40) * n >> 24);
}

/* 2^low to 2^high, every exponent as likely as the next; its last bits all 0, now and then. low >= -1074. */
static inline double draw_exponent(struct draw *d, int low, int high)
{
    uint64_t bits = draw_bits(d), fraction = bits & ((UINT64_C(1) << 52) - 1);
    int exponent = low + (int)draw_below(d, (unsigned)(high - low));
    if (bits >> 61 == 0)
        fraction = bits >> 60 & 1 ? 0 : fraction & ~UINT64_C(0) << 40;
    if (exponent < -1022)
        return ldexp(1.0 + (double)fraction * 0x1p-52, exponent);
    uint64_t whole = (uint64_t)(exponent + 1023) << 52 | fraction;
    double x;
    memcpy(&x, &whole, sizeof x);
    return x;
}

static inline double draw_signed_exponent(struct draw *d, int low, int high)
{
    double x = draw_exponent(d, low, high);
    return draw_bits(d) >> 63 ? -x : x;
}

/* A few units in the last place away, up or down or not at all. */
static inline double draw_neighbour(struct draw *d, double x)
{
    unsigned steps = draw_below(d, 4);
    double towards = draw_bits(d) >> 63 ? INFINITY : -INFINITY;
    for (unsigned i = 0; i < steps; i++)
        x = d->single ? (double)nextafterf((float)x, (float)towards) : nextafter(x, towards);
    return x;
}

/* What the precision holds, and not outside of the range. */
static inline double draw_rounded(const struct draw *d, double x, double low, double high)
{
    x = fmin(fmax(x, low), high);
    if (!d->single)
        return x;
    float f = (float)x;
    /* Both directions of rounding may lead out. */
    if ((double)f > high)
        f = nextafterf(f, -INFINITY);
    if ((double)f < low)
        f = nextafterf(f, INFINITY);
    return (double)f;
}

/* In [low, high], both finite: near a place of those that lie in the range, at a distance of any exponent; one in four far from all. */
static inline double draw_between(struct draw *d, double low, double high)
{
    const double places[] = {low, high, 0.0, 1.0, 0.5, low, high, 0.0};
    int least = d->single ? -126 : -1022, most = 0;
    frexp(fmax(fabs(low), fabs(high)), &most);
    bool far = draw_below(d, 4) == 0;
    if (far && low > 0.0 && high > 4.0 * low)
        return draw_rounded(d, draw_exponent(d, ilogb(low), most), low, high);
    for (int tries = 0; tries < 8 && !far; tries++) {
        double place = places[draw_bits(d) >> 61];
        if (!(place >= low && place <= high))
            continue;
        /* Less than an ulp of the place is no distance from it. */
        int ulp = ilogb(place) - (d->single ? 24 : 53);
        int finest = place == 0.0 ? least : ulp > least ? ulp : least;
        double x = draw_below(d, 8) == 0
                       ? draw_neighbour(d, place)
                       : place + draw_signed_exponent(d, finest, most > finest ? most : finest + 1);
        if (x >= low && x <= high)
            return draw_rounded(d, x, low, high);
    }
    return draw_rounded(d, low + (high - low) * draw_uniform(d), low, high);
}

/* Any finite number from 2^-reach to 2^reach, or 0, or one near 1. */
static inline double draw_any(struct draw *d, int reach)
{
    unsigned kind = draw_below(d, 16);
    double x = kind == 0   ? (draw_bits(d) >> 63 ? 0.0 : -0.0)
               : kind == 1 ? draw_neighbour(d, draw_bits(d) >> 63 ? 1.0 : -1.0)
               : kind < 6  ? draw_signed_exponent(d, -2, 2)
                           : draw_signed_exponent(d, -reach, reach);
    return d->single ? (double)(float)x : x;
}

/* No zero vector: of components of one size, of different sizes, or along an axis; of any length. */
static inline rl_vec3 draw_direction(struct draw *d)
{
    int least = d->single ? -120 : -1074, most = d->single ? 120 : 1020;
    unsigned kind = draw_below(d, 4);
    int scale = kind == 0 ? least + (int)draw_below(d, (unsigned)(most - least - 2)) : 0;
    double v[3];
    for (int c = 0; c < 3; c++) {
        /* Sizes that matter beside each other, or any. */
        int reach = kind == 3 ? (d->single ? 120 : 1020) : 60;
        v[c] = kind < 2    ? ldexp(2.0 * draw_uniform(d) - 1.0, scale)
               : kind == 2 ? draw_signed_exponent(d, -reach, 1)
                           : draw_any(d, reach);
        if (d->single)
            v[c] = (double)(float)v[c];
    }
    if (v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0)
        v[draw_below(d, 3)] = draw_bits(d) >> 63 ? 1.0 : -1.0;
    return v3(v[0], v[1], v[2]);
}

/* The unit vector, moved by a distance of any exponent. */
static inline rl_vec3 draw_off(struct draw *d, rl_vec3 unit)
{
    double size = draw_exponent(d, d->single ? -30 : -60, 1);
    rl_vec3 off = v3(draw_uniform(d) - 0.5, draw_uniform(d) - 0.5, draw_uniform(d) - 0.5);
    return v3_madd(unit, size, off);
}

/* A direction in relation to others: along one of them or against it, across it, or mirrored at it, and a little off. */
static inline rl_vec3 draw_related(struct draw *d, rl_vec3 a, rl_vec3 b)
{
    unsigned kind = draw_below(d, 8);
    if (kind < 2)
        return draw_direction(d);
    rl_vec3 N = v3_normalize(a), V = v3_normalize(b), unit = N;
    if (kind == 2)
        unit = v3_scale(-1.0, N);
    if (kind == 3)
        unit = V;
    if (kind == 4)
        unit = v3_scale(-1.0, V);
    if (kind == 5)
        unit = v3_reflect(V, N);
    if (kind == 6)
        unit = v3_cross(N, v3(0.3, 0.5, -0.8));
    rl_vec3 v = draw_below(d, 8) == 0 ? unit : draw_off(d, unit);
    if (d->single)
        v = v3((double)(float)v.x, (double)(float)v.y, (double)(float)v.z);
    return v3_dot(v, v) > 0.0 ? v : v3(0.0, 0.0, 1.0);
}

#endif
