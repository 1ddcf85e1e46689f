/* Eight lines side by side (see batch.h). The Makefile gives this file AVX-512. */
#if defined(__AVX512F__)
#include <immintrin.h>
#include <sleef.h>

enum { LANES = 8 };
typedef double vd __attribute__((vector_size(64)));
typedef long vm __attribute__((vector_size(64))); /* a mask: all bits of a lane or none */

#define VECTOR(function) function##d8_u10avx512f
#define VECTOR_LOG Sleef_logd8_u35avx512f
#define VECTOR_PAIR Sleef___m512d_2
#define VECTOR_SQRT _mm512_sqrt_pd
#define VECTOR_BITS(mask) ((unsigned)_mm512_movepi64_mask((__m512i)(mask)))
#define BATCH_FUNCTION rl_batch_avx512
#include "reference/batch_kernel.h"
#endif
