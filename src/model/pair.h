/* Pairs of numbers whose sum counts, of some 104 bits: for sums whose terms cancel, and for cosines whose n-th power is wanted, since a
 * rounded cosine is off by n/2 units in the last place there.
 *
 * The sum of two numbers is such a pair exactly (Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B), and so is their product
 * (Dekker 1971; by the fused multiply-add), as long as neither leaves the range of numbers. Operations on pairs are off by 1e-31 or so of what
 * they add up. */
#ifndef RL_MODEL_PAIR_H
#define RL_MODEL_PAIR_H

#include <math.h>

#include "model/vec3.h"

/* high + low, |low| <= half a unit in the last place of high. */
struct rl_pair {
    double high, low;
};

struct rl_pair_vec3 {
    struct rl_pair x, y, z;
};

static inline struct rl_pair rl_pair_sum(double a, double b)
{
    double s = a + b, of_b = s - a;
    return (struct rl_pair){s, (a - (s - of_b)) + (b - of_b)};
}

static inline struct rl_pair rl_pair_add(struct rl_pair a, struct rl_pair b)
{
    struct rl_pair s = rl_pair_sum(a.high, b.high), t = rl_pair_sum(a.low, b.low);
    s = rl_pair_sum(s.high, s.low + t.high);
    return rl_pair_sum(s.high, s.low + t.low);
}

static inline struct rl_pair rl_pair_minus(struct rl_pair a)
{
    return (struct rl_pair){-a.high, -a.low};
}

static inline struct rl_pair rl_pair_multiply(struct rl_pair a, struct rl_pair b)
{
    double product = a.high * b.high;
    return rl_pair_sum(product, fma(a.high, b.high, -product) + (a.high * b.low + a.low * b.high));
}

/* By a power of two. */
static inline struct rl_pair rl_pair_scale(double s, struct rl_pair a)
{
    return (struct rl_pair){s * a.high, s * a.low};
}

/* b is not 0. */
static inline struct rl_pair rl_pair_divide(struct rl_pair a, struct rl_pair b)
{
    double quotient = a.high / b.high;
    return rl_pair_sum(quotient, (fma(-quotient, b.high, a.high) + (a.low - quotient * b.low)) / b.high);
}

/* a >= 0. */
static inline struct rl_pair rl_pair_root(struct rl_pair a)
{
    double root = sqrt(a.high);
    if (!(root > 0.0))
        return (struct rl_pair){0.0, 0.0};
    return rl_pair_sum(root, (fma(-root, root, a.high) + a.low) / (2.0 * root));
}

/* ---- Vectors ---- */

static inline struct rl_pair_vec3 rl_pair_vec3_of(rl_vec3 a)
{
    return (struct rl_pair_vec3){{a.x, 0.0}, {a.y, 0.0}, {a.z, 0.0}};
}

static inline struct rl_pair_vec3 rl_pair_vec3_add(struct rl_pair_vec3 a, struct rl_pair_vec3 b)
{
    return (struct rl_pair_vec3){rl_pair_add(a.x, b.x), rl_pair_add(a.y, b.y), rl_pair_add(a.z, b.z)};
}

static inline struct rl_pair_vec3 rl_pair_vec3_minus(struct rl_pair_vec3 a)
{
    return (struct rl_pair_vec3){rl_pair_minus(a.x), rl_pair_minus(a.y), rl_pair_minus(a.z)};
}

static inline struct rl_pair_vec3 rl_pair_vec3_scale(struct rl_pair s, struct rl_pair_vec3 a)
{
    return (struct rl_pair_vec3){rl_pair_multiply(s, a.x), rl_pair_multiply(s, a.y),
                                 rl_pair_multiply(s, a.z)};
}

static inline struct rl_pair rl_pair_dot(struct rl_pair_vec3 a, struct rl_pair_vec3 b)
{
    return rl_pair_add(rl_pair_add(rl_pair_multiply(a.x, b.x), rl_pair_multiply(a.y, b.y)),
                       rl_pair_multiply(a.z, b.z));
}

/* a d - b c */
static inline struct rl_pair rl_pair_determinant(struct rl_pair a, struct rl_pair b, struct rl_pair c,
                                                 struct rl_pair d)
{
    return rl_pair_add(rl_pair_multiply(a, d), rl_pair_minus(rl_pair_multiply(b, c)));
}

static inline struct rl_pair_vec3 rl_pair_cross(struct rl_pair_vec3 a, struct rl_pair_vec3 b)
{
    return (struct rl_pair_vec3){rl_pair_determinant(a.y, a.z, b.y, b.z),
                                 rl_pair_determinant(a.z, a.x, b.z, b.x),
                                 rl_pair_determinant(a.x, a.y, b.x, b.y)};
}

/* ---- Angles between vectors of any length but 0: what unit vectors' lengths are off by 1 does not count ---- */

static inline struct rl_pair rl_pair_cosine(struct rl_pair_vec3 a, struct rl_pair_vec3 b)
{
    return rl_pair_divide(rl_pair_dot(a, b),
                          rl_pair_root(rl_pair_multiply(rl_pair_dot(a, a), rl_pair_dot(b, b))));
}

/* sin^2, also near 0. */
static inline struct rl_pair rl_pair_sin_sin(struct rl_pair_vec3 a, struct rl_pair_vec3 b)
{
    struct rl_pair_vec3 across = rl_pair_cross(a, b);
    return rl_pair_divide(rl_pair_dot(across, across),
                          rl_pair_multiply(rl_pair_dot(a, a), rl_pair_dot(b, b)));
}

#endif
