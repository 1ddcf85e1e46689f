/* Normal numbers with a fixed seed, for tests of whether intervals hold as often as they claim. */
#ifndef RL_TESTS_MEASURE_NOISE_H
#define RL_TESTS_MEASURE_NOISE_H

#include <math.h>
#include <stdint.h>

#include "model/random.h"
#include "model/vec3.h"

/* Mean 0, variance 1 (Box and Muller 1958). */
static inline double noise(uint64_t seed, uint64_t index)
{
    double u = rl_random_uniform(seed, 2 * index);
    double v = rl_random_uniform(seed, 2 * index + 1);
    return sqrt(-2.0 * log(u)) * cos(2.0 * RL_PI * v);
}

#endif
