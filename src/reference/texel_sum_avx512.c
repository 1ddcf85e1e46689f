/* The loop of texel_sum.h in avx512. */
#define TEXEL_SUM rl_texel_sum_avx512
#include "reference/texel_sum_kernel.h"
