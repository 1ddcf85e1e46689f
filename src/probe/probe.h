/* Probes: the functions of the model, by name, on rows of numbers; in C (double precision) and, where the shaders have the same
 * function, in GLSL on the GPU.
 *
 *     struct rl_probe probe;
 *     rl_probe_find(&probe, "frame", &error);
 *     rl_probe_check_row(&probe, row, &error);              ranges of a row of probe.n_in arguments
 *     rl_probe_cpu(&probe, rows, n, results);               n rows of probe.n_out results
 *     rl_probe_gpu(&probe, gpu, rows, n, results, &error);
 *
 * Directions (probe.n_directions triples, the first columns) need not be unit vectors: both sides normalize them.
 */
#ifndef RL_PROBE_PROBE_H
#define RL_PROBE_PROBE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "effects/effect.h"
#include "gpu/gpu.h"

enum { RL_PROBE_IN_MAX = 40, RL_PROBE_OUT_MAX = 9, RL_PROBE_MODULES_MAX = 8, RL_PROBE_NAME_MAX = 32 };

struct rl_probe_column {
    char name[RL_PROBE_NAME_MAX];
    double low, high; /* of what is taken; equal to nothing where both are 0: any finite number */
};

struct rl_probe {
    const char *name, *summary;
    size_t n_in, n_out, n_directions;
    struct rl_probe_column in[RL_PROBE_IN_MAX];
    const char *out[RL_PROBE_OUT_MAX];
    void (*cpu)(const struct rl_probe *probe, const double *in, double *out);
    /* GLSL: modules, and the body of void evaluate(float a[N_IN], out float r[N_OUT]). NULL: there is no such function. */
    const char *modules[RL_PROBE_MODULES_MAX];
    const char *glsl;
    /* |GLSL - C| <= absolute + relative |C| for every result, wherever the arguments are in range. */
    double absolute, relative;
    const char *bound; /* what else there is to say of the bound, or NULL */
};

/* The i-th probe; false: there are no more. */
bool rl_probe_at(struct rl_probe *probe, size_t i);
/* RL_ERR_INPUT with the names there are. */
int rl_probe_find(struct rl_probe *probe, const char *name, struct rl_error *error);

/* RL_ERR_INPUT, naming the column: a number out of its range, or a direction that is the zero vector. */
int rl_probe_check_row(const struct rl_probe *probe, const double *row, struct rl_error *error);

/* RL_ERR_INPUT if no shader has the function. */
int rl_probe_check_gpu(const struct rl_probe *probe, struct rl_error *error);

void rl_probe_cpu(const struct rl_probe *probe, const double *rows, size_t n_rows, double *results);
/* Arguments are rounded to single precision first. RL_ERR_INPUT: as rl_probe_check_gpu. */
int rl_probe_gpu(const struct rl_probe *probe, struct rl_gpu *gpu, const double *rows, size_t n_rows,
                 double *results, struct rl_error *error);

#endif
