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

enum {
    RL_PROBE_IN_MAX = 15 + RL_EFFECT_VALUES_MAX,
    RL_PROBE_OUT_MAX = 9,
    RL_PROBE_MODULES_MAX = 8,
    RL_PROBE_NAME_MAX = 32
};

struct rl_probe_column {
    char name[RL_PROBE_NAME_MAX];
    double low, high; /* of what is taken; both 0: any finite number */
    bool optional;    /* NAN stands for a parameter that was left out */
    bool goes_on;     /* G or B of a colour, left out where the column before it is, and only there */
    bool whole;       /* a whole number: which of an effect's choices */
    bool rounded;     /* the bound allows for RL_PROBE_ROUNDING of it, too */
};

struct rl_probe {
    char name[RL_PROBE_NAME_MAX];
    const char *summary;
    size_t n_in, n_out;
    size_t n_directions, n_vectors; /* vectors: triples that begin the columns, directions among them */
    const struct rl_effect *effect; /* or NULL; then `modules` and `glsl` are made for it */
    bool polygon;                   /* its function of a polygon, a triangle here, not of a direction */
    struct rl_probe_column in[RL_PROBE_IN_MAX];
    const char *out[RL_PROBE_OUT_MAX];
    void (*cpu)(const struct rl_probe *probe, const double *in, double *out);
    /* GLSL: modules, and the body of void evaluate(float a[N_IN], out float r[N_OUT]). NULL: there is no such function. */
    const char *modules[RL_PROBE_MODULES_MAX];
    const char *glsl;
    /* |GLSL - C| <= absolute + relative |C| for every result wherever the arguments are in range, and beside that what C changes by
     * where each component of the vectors moves by RL_PROBE_ROUNDING times the vector's length: GLSL has them in single precision. */
    double absolute, relative;
    const char *bound; /* what else there is to say of the bound, or NULL */
};

/* Eight units in the last place of single precision: what normalizing a vector and a few sums and products of it lose. */
#define RL_PROBE_ROUNDING 5e-7

/* The i-th probe: functions of the model, then those of the effects. False: there are no more. */
bool rl_probe_at(struct rl_probe *probe, size_t i);
/* RL_ERR_INPUT with the names there are. */
int rl_probe_find(struct rl_probe *probe, const char *name, struct rl_error *error);

/* RL_ERR_INPUT, naming the column: a number out of its range, or a direction that is the zero vector. */
int rl_probe_check_row(const struct rl_probe *probe, const double *row, struct rl_error *error);

/* RL_ERR_INPUT if no shader has the function. */
int rl_probe_check_gpu(const struct rl_probe *probe, struct rl_error *error);

void rl_probe_cpu(const struct rl_probe *probe, const double *rows, size_t n_rows, double *results);
/* Arguments are rounded to single precision first, those of functions of the model so that they stay in range. RL_ERR_INPUT: as rl_probe_check_gpu. */
int rl_probe_gpu(const struct rl_probe *probe, struct rl_gpu *gpu, const double *rows, size_t n_rows,
                 double *results, struct rl_error *error);

/* In single precision; beyond it, its largest number. */
float rl_probe_single(double x);

/* The directions that begin a row, in single precision. Its squares end at 1.8e19 and 1e-19: one whose largest component is beyond 1e-3
 * to 1e3 is scaled to about 1 first, by a power of two, so that nothing but the rounding to 24 bits is lost. */
void rl_probe_round_directions(float *to, const struct rl_probe *probe, const double *row);

/* effect.c: the probe of an effect's function, of a direction or (polygon) of a polygon. False: it has none. */
bool rl_probe_of_effect(struct rl_probe *probe, const struct rl_effect *effect, bool polygon);
/* The values of the effect's parameters in a row. */
const double *rl_probe_effect_values(const struct rl_probe *probe, const double *row);
/* rl_probe_gpu for effects: a program for each combination of choices. */
int rl_probe_effect_gpu(const struct rl_probe *probe, struct rl_gpu *gpu, const double *rows, size_t n_rows,
                        double *results, struct rl_error *error);

#endif
