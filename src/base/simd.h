/* Which instruction set the inner loops run in, chosen when the program runs.
 *
 * A loop that is worth it is compiled three times from one source, for plain C, AVX2 with FMA and AVX-512, and the caller picks by
 * rl_simd_best(). ROUGHLIGHT_SIMD=plain|avx2|avx512 lowers the choice; src/cli refuses a value that is unknown or that this
 * machine lacks (rl_simd_check).
 *
 *     static sum_function *const sum[] = {sum_plain, sum_avx2, sum_avx512};
 *     double total = sum[rl_simd_best()](texels, n);
 *
 * The three give the same answer but for rounding: FMA rounds once where plain C rounds twice.
 */
#ifndef RL_BASE_SIMD_H
#define RL_BASE_SIMD_H

#include "base/error.h"

/* In ascending order: each machine that has one has those before it. */
enum rl_simd { RL_SIMD_PLAIN, RL_SIMD_AVX2, RL_SIMD_AVX512, RL_SIMD_COUNT };

/* The best that this machine and ROUGHLIGHT_SIMD allow; what the variable says is ignored where rl_simd_check would refuse it.
 * AVX-512 means its F, DQ, BW and VL parts. */
enum rl_simd rl_simd_best(void);

/* RL_ERR_INPUT where ROUGHLIGHT_SIMD is set to something unknown or to a set that this machine lacks. */
int rl_simd_check(struct rl_error *error);

/* "plain", "avx2" or "avx512". */
const char *rl_simd_name(enum rl_simd simd);

#endif
