/* Many lines of one panel at a time, several side by side in vector registers.
 *
 * Between two breaks every line crosses the same edges in the same order, so one line's stretches (rl_lines_trace) are those of all,
 * and what is left is straight arithmetic: the places of the crossings and the closed forms of inner.h. The same source is compiled
 * for each instruction set (batch_kernel.h); sines, logarithms and arctangents are SLEEF's. A line whose crossings do not come out in the
 * order traced (rounding, right at a break) is marked, and the caller does it alone.
 *
 * Only for the orthonormal frame, R >= 1 and nothing that hides the lights; the general path is rl_lines_integrate.
 */
#ifndef RL_REFERENCE_BATCH_H
#define RL_REFERENCE_BATCH_H

#include "base/simd.h"
#include "reference/lines.h"
#include "reference/rule.h"

/* value[0 .. 3][i] as rl_lines_integrate has it at theta[i], i = 0 .. RL_RULE_BATCH - 1; where the set is grey, [1] and [2] are left
 * alone. Returns a bit i for each line that has to be done again. */
typedef unsigned rl_batch_function(double value[4][RL_RULE_BATCH], const struct rl_lines *lines,
                                   const struct rl_stretch *stretch, size_t n_stretches,
                                   const double theta[RL_RULE_BATCH]);

#if defined(__x86_64__)
rl_batch_function rl_batch_avx2, rl_batch_avx512;
#endif

/* NULL where there is none for this instruction set, or these lines need the general path. */
rl_batch_function *rl_batch_for(const struct rl_lines *lines, enum rl_simd simd);

#endif
