/* Which batch function takes which lines (see batch.h). */
#include "reference/batch.h"

#if defined(__x86_64__)
#define BATCH(name) (name)
#else
#define BATCH(name) NULL
#endif

rl_batch_function *rl_batch_for(const struct rl_lines *lines, enum rl_simd simd)
{
    static rl_batch_function *const functions[RL_SIMD_COUNT] = {
        [RL_SIMD_AVX2] = BATCH(rl_batch_avx2),
        [RL_SIMD_AVX512] = BATCH(rl_batch_avx512),
    };
    return lines->stretch == 1.0 && lines->e->rr >= 1.0 && !lines->occlusion && !lines->irradiance
               ? functions[simd]
               : NULL;
}
