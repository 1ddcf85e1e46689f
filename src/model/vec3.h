/* Three-vectors in double precision, by value. */
#ifndef RL_MODEL_VEC3_H
#define RL_MODEL_VEC3_H

#include <math.h>

#define RL_PI 3.14159265358979323846

typedef struct rl_vec3 {
    double x, y, z;
} rl_vec3;

static inline rl_vec3 v3(double x, double y, double z)
{
    return (rl_vec3){x, y, z};
}

static inline rl_vec3 v3_add(rl_vec3 a, rl_vec3 b)
{
    return v3(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline rl_vec3 v3_sub(rl_vec3 a, rl_vec3 b)
{
    return v3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline rl_vec3 v3_scale(double s, rl_vec3 a)
{
    return v3(s * a.x, s * a.y, s * a.z);
}

/* a + s b */
static inline rl_vec3 v3_madd(rl_vec3 a, double s, rl_vec3 b)
{
    return v3(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

static inline double v3_dot(rl_vec3 a, rl_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline rl_vec3 v3_cross(rl_vec3 a, rl_vec3 b)
{
    return v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double v3_length(rl_vec3 a)
{
    return sqrt(v3_dot(a, a));
}

/* The zero vector stays zero. */
static inline rl_vec3 v3_normalize(rl_vec3 a)
{
    double m = fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z)));
    if (!(m > 0.0))
        return v3(0.0, 0.0, 0.0);
    /* A power of two brings the square of a huge or denormal vector into range, and rounds nothing. Each component is rounded once: the
     * length's own error is common to all, and no error of the direction. */
    if (!(m > 1e-140 && m < 1e140)) {
        int e = ilogb(m);
        a = v3(ldexp(a.x, -e), ldexp(a.y, -e), ldexp(a.z, -e));
    }
    double length = v3_length(a);
    return v3(a.x / length, a.y / length, a.z / length);
}

/* Mirror of V about the unit normal N: 2 (N.V) N - V, pointing away from the surface as V does. */
static inline rl_vec3 v3_reflect(rl_vec3 V, rl_vec3 N)
{
    return v3_sub(v3_scale(2.0 * v3_dot(N, V), N), V);
}

#endif
