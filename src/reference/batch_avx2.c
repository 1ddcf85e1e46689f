/* Four lines side by side (see batch.h). The Makefile gives this file AVX2 and FMA. */
#if defined(__AVX2__)
#include <immintrin.h>
#include <sleef.h>

enum { LANES = 4 };
typedef double vd __attribute__((vector_size(32)));
typedef long vm __attribute__((vector_size(32))); /* a mask: all bits of a lane or none */

#define VECTOR(function) function##d4_u10avx2
#define VECTOR_LOG Sleef_logd4_u35avx2
#define VECTOR_PAIR Sleef___m256d_2
#define VECTOR_SQRT _mm256_sqrt_pd
#define VECTOR_BITS(mask) ((unsigned)_mm256_movemask_pd((vd)(mask)))
#define BATCH_FUNCTION rl_batch_avx2
#include "reference/batch_kernel.h"
#endif
