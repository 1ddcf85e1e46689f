/* Sweeps: which parameters of its cases a study lets `--axis` replace, and by what. A table in the study's descriptor, and the one place
 * for it: what is refused, what the help says and what error messages list all come from there.
 *
 *     static const struct rl_sweep sweeps[] = {
 *         {.name = "rr", .kind = RL_SWEEP_REAL, .low = RL_RR_MIN, .high = RL_RR_MAX},
 *         {.name = "samples", .of = "series=methods", .kind = RL_SWEEP_WHOLE, .low = 1, .high = 1024, .together = 20},
 *     };
 *
 * What is not in it cannot be swept: the keys that tell a study's arms apart, and what its claims say is the same everywhere.
 */
#ifndef RL_STUDIES_SWEEP_H
#define RL_STUDIES_SWEEP_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

enum rl_sweep_kind { RL_SWEEP_WHOLE, RL_SWEEP_REAL, RL_SWEEP_POWER_OF_TWO, RL_SWEEP_WORD };

struct rl_sweep {
    const char *name;
    const char *
        of; /* "series=methods": only in cases that match; others keep what they have; NULL: in all that have the parameter */
    enum rl_sweep_kind kind;
    /* 0: each value makes a group of its own. Else values stay in the case's group, side by side with what they are held against and timed
     * with; at most so many of them. */
    int together;
    double low, high;         /* of numbers, both included */
    const char *const *words; /* of RL_SWEEP_WORD, NULL at the end */
    const char
        *named_by; /* only in cases where this key has the same number, and gets the new one too; or NULL */
};

/* What a normal map's bits and an environment map's format may be. */
extern const char *const rl_sweep_normal_bits[], *const rl_sweep_env_formats[];

/* Common rows of tables. Two seeds are the least that tell noise from bias; 64: RL_SEEDS_MAX. */
#define RL_SWEEP_RR(of_)                                                                                     \
    {                                                                                                        \
        .name = "rr", .of = (of_), .kind = RL_SWEEP_REAL, .low = 0.01, .high = 1e6                           \
    }
#define RL_SWEEP_SEEDS(of_)                                                                                  \
    {                                                                                                        \
        .name = "seeds", .of = (of_), .kind = RL_SWEEP_WHOLE, .low = 2, .high = 64                           \
    }
#define RL_SWEEP_PIXELS(name_, of_)                                                                          \
    {                                                                                                        \
        .name = (name_), .of = (of_), .kind = RL_SWEEP_WHOLE, .low = 8, .high = 16384                        \
    }
#define RL_SWEEP_TOLERANCE(of_)                                                                              \
    {                                                                                                        \
        .name = "tolerance", .of = (of_), .kind = RL_SWEEP_REAL, .low = 1e-12, .high = 0.1                   \
    }
#define RL_SWEEP_ENV_SIZE(of_)                                                                               \
    {                                                                                                        \
        .name = "env_size", .of = (of_), .kind = RL_SWEEP_WHOLE, .low = 8, .high = 4096                      \
    }
#define RL_SWEEP_NORMAL_SIZE(of_)                                                                            \
    {                                                                                                        \
        .name = "normal_size", .of = (of_), .kind = RL_SWEEP_POWER_OF_TWO, .low = 64, .high = 2048           \
    }

/* Whether `parameters` are of a case whose value it replaces. */
bool rl_sweep_applies(const struct rl_sweep *sweep, const char *parameters);

/* The first of n that applies; NULL if there is none. */
const struct rl_sweep *rl_sweep_find(const struct rl_sweep *sweeps, size_t n, const char *name,
                                     const char *parameters);

/* RL_ERR_INPUT with what was found and what would have been right. */
int rl_sweep_check(const struct rl_sweep *sweep, const char *value, struct rl_error *error);

/* "a whole number from 1 to 1024", "8, half or float" */
void rl_sweep_values(char text[], size_t size, const struct rl_sweep *sweep);

/* "rr, samples, seeds": each name once. */
void rl_sweep_names(char text[], size_t size, const struct rl_sweep *sweeps, size_t n);

#endif
