/* Asks the CPU and the environment (see simd.h). */
#include "base/simd.h"

#include <stdlib.h>
#include <string.h>

static const char *const names[RL_SIMD_COUNT] = {"plain", "avx2", "avx512"};

const char *rl_simd_name(enum rl_simd simd)
{
    return names[simd];
}

/* The compiler's own question also asks whether the operating system keeps the wide registers. */
static enum rl_simd of_machine(void)
{
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
        return RL_SIMD_PLAIN;
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
        return RL_SIMD_AVX512;
    return RL_SIMD_AVX2;
#else
    return RL_SIMD_PLAIN;
#endif
}

/* What ROUGHLIGHT_SIMD asks for; RL_SIMD_COUNT: unset, empty or unknown. */
static enum rl_simd asked_for(const char *text)
{
    int simd = 0;
    while (simd < RL_SIMD_COUNT && (!text || strcmp(text, names[simd]) != 0))
        simd++;
    return (enum rl_simd)simd;
}

enum rl_simd rl_simd_best(void)
{
    enum rl_simd best = of_machine();
    enum rl_simd asked = asked_for(getenv("ROUGHLIGHT_SIMD"));
    return asked < best ? asked : best;
}

int rl_simd_check(struct rl_error *error)
{
    const char *text = getenv("ROUGHLIGHT_SIMD");
    if (!text || !*text)
        return RL_OK;
    enum rl_simd best = of_machine(), asked = asked_for(text);
    if (asked == RL_SIMD_COUNT)
        return rl_fail(error, RL_ERR_INPUT, "ROUGHLIGHT_SIMD: found '%s', expected plain, avx2 or avx512",
                       text);
    if (asked > best)
        return rl_fail(
            error, RL_ERR_INPUT,
            "ROUGHLIGHT_SIMD: found '%s', expected no more than %s, which is what this machine has", text,
            names[best]);
    return RL_OK;
}
