/* The loop of texel_sum.h in plain. */
#define TEXEL_SUM rl_texel_sum_plain
#include "reference/texel_sum_kernel.h"

rl_texel_sum *rl_texel_sum_for(enum rl_simd simd)
{
    static rl_texel_sum *const sums[RL_SIMD_COUNT] = {rl_texel_sum_plain, rl_texel_sum_avx2,
                                                      rl_texel_sum_avx512};
    return sums[simd];
}
