/* The loop of texel_sum.h in avx2. */
#define TEXEL_SUM rl_texel_sum_avx2
#include "reference/texel_sum_kernel.h"
