/* What a bound of GLSL against C has to allow for beside what the descriptor states: GLSL has its arguments in single precision. */
#ifndef RL_TESTS_ROUNDING_H
#define RL_TESTS_ROUNDING_H

#include <math.h>
#include <string.h>

#include "model/plane.h"
#include "probe/probe.h"

/* Whether GLSL may count P as in the triangle's plane, or C, where the other does not: by its 2 units of single precision's rounding twice,
 * and the rounding of (v_1 - v_0) x (v_2 - v_0), which of a needle is all there is. */
static inline bool in_plane_by_rounding(const struct rl_probe *p, const double *row)
{
    if (!p->polygon)
        return false;
    const rl_vec3 v[3] = {v3(row[6], row[7], row[8]), v3(row[9], row[10], row[11]),
                          v3(row[12], row[13], row[14])};
    rl_vec3 d = v3_sub(v[1], v[0]), e = v3_sub(v[2], v[0]), zero = v3(0.0, 0.0, 0.0);
    double distance = rl_plane_distance(v, 3, zero, 4.0 / RL_PLANE_UNITS * RL_UNIT_SINGLE);
    double rounding = 2.0 * RL_UNIT_SINGLE * v3_length(d) * v3_length(e) * v3_length(v[0]);
    return distance == 0.0 || fabs(v3_dot(v3_cross(d, e), v[0])) <= rounding;
}

/* What rounding of the arguments does to the C function: for each result the sum over the vectors' components of the change when one
 * moves by RL_PROBE_ROUNDING times the vector's length, and the same of numbers that the bound allows it for. */
static inline void rounding_add(const struct rl_probe *p, const double *row, const double *value,
                                double *allowed)
{
    double moved[RL_PROBE_IN_MAX], there[RL_PROBE_OUT_MAX];
    memcpy(moved, row, p->n_in * sizeof *moved);
    for (size_t i = 0; i < p->n_in; i++) {
        bool vector = i < 3 * p->n_vectors;
        if (!vector && !p->in[i].rounded)
            continue;
        const double *v = row + i - i % 3;
        double length = vector ? sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) : fabs(row[i]);
        double step = RL_PROBE_ROUNDING * length;
        double change[RL_PROBE_OUT_MAX] = {0.0};
        for (int sign = -1; sign <= 1; sign += 2) {
            moved[i] = row[i] + sign * step;
            if (!vector)
                moved[i] = fmin(fmax(moved[i], p->in[i].low), p->in[i].high);
            rl_probe_cpu(p, moved, 1, there);
            for (size_t k = 0; k < p->n_out; k++)
                change[k] = fmax(change[k], fabs(there[k] - value[k]));
        }
        moved[i] = row[i];
        for (size_t k = 0; k < p->n_out; k++)
            allowed[k] += change[k];
    }
}

#endif
