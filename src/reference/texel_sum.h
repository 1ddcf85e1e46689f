/* The inner loop of texel_map.h: a sum over texels of weight x solid angle, at one shading point.
 *
 * With M = V + L (not normalised: H is along it), in a frame whose third axis is N: n = M.N, u = the square of M's part in the
 * tangent plane, Q = u + n^2 = |M|^2. Then |sin delta| = sqrt(u/Q), cos delta = |n|/sqrt(Q), V.H = sqrt(Q)/2, and
 *
 *     D G / (4 pi (V.H) |sin delta|) = norm/(2 pi R) x |n| min(g, Q) / (p sqrt(Q u)),   p = n^2/R + R u
 *
 * with g = 4 n max(0, min(N.V, N.L)), so that G = min(1, g/Q); without attenuation g = Q. One root and one quotient; nothing cancels but M
 * itself, near the poles L = mirror direction and L = -V, and there u is held at u_least: texels so near are the caller's
 * (texel_map.h). Directions are floats, sums doubles. The factor norm/(2 pi R) is the caller's too.
 *
 * Compiled for each instruction set from texel_sum_kernel.h.
 */
#ifndef RL_REFERENCE_TEXEL_SUM_H
#define RL_REFERENCE_TEXEL_SUM_H

#include <stdbool.h>
#include <stddef.h>

#include "base/simd.h"

/* A shading point as the loop wants it. */
struct rl_texel_point {
    float axis[3][3]; /* T, B, N */
    float v[3];       /* V in that frame */
    float rr, u_least;
    bool attenuation;
};

/* Unit directions and solid angles. */
struct rl_texel_list {
    size_t n;
    const float *x, *y, *z, *solid_angle;
};

typedef double rl_texel_sum(const struct rl_texel_list *texels, const struct rl_texel_point *point);

rl_texel_sum rl_texel_sum_plain, rl_texel_sum_avx2, rl_texel_sum_avx512;

/* The one for an instruction set that this machine has. */
rl_texel_sum *rl_texel_sum_for(enum rl_simd simd);

#endif
