/* Random numbers by address: a number is a function of (seed, index), so that a texel, a pixel or a thread draws the same one
 * whatever the order of evaluation. The mixer is the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
 */
#ifndef RL_MODEL_RANDOM_H
#define RL_MODEL_RANDOM_H

#include <stdint.h>

static inline uint64_t rl_random_mix(uint64_t x)
{
    x = (x ^ (x >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ (x >> 27)) * UINT64_C(0x94d049bb133111eb);
    return x ^ (x >> 31);
}

static inline uint64_t rl_random_bits(uint64_t seed, uint64_t index)
{
    /* The seed is mixed by itself, else seed s + 1 would be seed s shifted by one index. */
    uint64_t start = rl_random_mix(seed + UINT64_C(0x9e3779b97f4a7c15));
    return rl_random_mix(start + (index + 1) * UINT64_C(0x9e3779b97f4a7c15));
}

/* Uniform in the open interval (0, 1), 52 bits, centred: its mean over all values is exactly 1/2. */
static inline double rl_random_uniform(uint64_t seed, uint64_t index)
{
    return ((double)(rl_random_bits(seed, index) >> 12) + 0.5) * 0x1p-52;
}

#endif
