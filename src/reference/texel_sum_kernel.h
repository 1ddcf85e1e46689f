/* The loop of texel_sum.h, once with attenuation and once without. Included by texel_sum_*.c, which differ in their compiler's flags
 * and in TEXEL_SUM, the function's name.
 *
 * `lanes` is as many floats as one register holds. Written with the few intrinsics that C has no operator for, because gcc leaves the
 * plain loop alone; and multiply-add is asked for by name, since the compiler is told not to contract. */
#include "reference/texel_sum.h"

#if defined(__AVX512F__)
#include <immintrin.h>
typedef __m512 lanes;
enum { LANES = 16 };
#define LOAD(from) _mm512_loadu_ps(from)
#define ALL(value) _mm512_set1_ps(value)
#define MADD(a, b, c) _mm512_fmadd_ps(a, b, c)
#define LEAST(a, b) _mm512_min_ps(a, b)
#define MOST(a, b) _mm512_max_ps(a, b)
#define ROOT(a) _mm512_sqrt_ps(a)
#elif defined(__AVX2__)
#include <immintrin.h>
typedef __m256 lanes;
enum { LANES = 8 };
#define LOAD(from) _mm256_loadu_ps(from)
#define ALL(value) _mm256_set1_ps(value)
#define MADD(a, b, c) _mm256_fmadd_ps(a, b, c)
#define LEAST(a, b) _mm256_min_ps(a, b)
#define MOST(a, b) _mm256_max_ps(a, b)
#define ROOT(a) _mm256_sqrt_ps(a)
#else
typedef float lanes;
enum { LANES = 1 };
#define LOAD(from) (*(from))
#define ALL(value) (value)
#define MADD(a, b, c) ((a) * (b) + (c))
#define LEAST(a, b) ((a) < (b) ? (a) : (b))
#define MOST(a, b) ((a) > (b) ? (a) : (b))
#define ROOT(a) __builtin_sqrtf(a)
#endif

/* Every lane of a shading point's numbers. */
struct spread {
    lanes axis[3][3], v[3], rr, rr_inverse, u_least;
};

static inline struct spread spread_make(const struct rl_texel_point *p)
{
    struct spread s = {.rr = ALL(p->rr), .rr_inverse = ALL(1.0f / p->rr), .u_least = ALL(p->u_least)};
    for (int i = 0; i < 3; i++) {
        s.v[i] = ALL(p->v[i]);
        for (int j = 0; j < 3; j++)
            s.axis[i][j] = ALL(p->axis[i][j]);
    }
    return s;
}

static inline lanes terms(const struct spread *p, lanes x, lanes y, lanes z, lanes solid_angle,
                          bool attenuation)
{
    lanes m_t = MADD(x, p->axis[0][0], MADD(y, p->axis[0][1], MADD(z, p->axis[0][2], p->v[0])));
    lanes m_b = MADD(x, p->axis[1][0], MADD(y, p->axis[1][1], MADD(z, p->axis[1][2], p->v[1])));
    lanes n_l = MADD(x, p->axis[2][0], MADD(y, p->axis[2][1], z * p->axis[2][2]));
    lanes n = n_l + p->v[2];
    lanes u = MADD(m_t, m_t, m_b * m_b);
    u = MOST(u, p->u_least);
    lanes nn = n * n, q = u + nn, above = n;
    if (attenuation) {
        lanes facing = LEAST(n_l, p->v[2]), lit = MOST(facing, ALL(0.0f));
        lanes g = ALL(4.0f) * n * lit;
        above *= LEAST(g, q);
    } else {
        above = MOST(n, -n) * q;
    }
    return above * solid_angle / (MADD(nn, p->rr_inverse, p->rr * u) * ROOT(q * u));
}

/* Sums of few floats become doubles: what rounding does to them is that of a single term. */
static inline double sum_texels(const struct rl_texel_list *texels, const struct rl_texel_point *point,
                                bool attenuation)
{
    enum { BLOCK = 16 * LANES };
    const struct spread p = spread_make(point);
    double total = 0.0;
    for (size_t from = 0; from < texels->n; from += BLOCK) {
        size_t end = texels->n - from < BLOCK ? texels->n : from + BLOCK, i = from;
        lanes sum = ALL(0.0f);
        for (; i + LANES <= end; i += LANES)
            sum += terms(&p, LOAD(&texels->x[i]), LOAD(&texels->y[i]), LOAD(&texels->z[i]),
                         LOAD(&texels->solid_angle[i]), attenuation);
        if (i < end) {
            float rest[4][LANES] = {{0.0f}};
            for (size_t k = 0; k < end - i; k++) {
                rest[0][k] = texels->x[i + k];
                rest[1][k] = texels->y[i + k];
                rest[2][k] = texels->z[i + k];
                rest[3][k] = texels->solid_angle[i + k];
            }
            sum += terms(&p, LOAD(rest[0]), LOAD(rest[1]), LOAD(rest[2]), LOAD(rest[3]), attenuation);
        }
        float part[LANES];
        __builtin_memcpy(part, &sum, sizeof part);
        for (int k = 0; k < LANES; k++)
            total += (double)part[k];
    }
    return total;
}

double TEXEL_SUM(const struct rl_texel_list *texels, const struct rl_texel_point *point)
{
    return point->attenuation ? sum_texels(texels, point, true) : sum_texels(texels, point, false);
}
