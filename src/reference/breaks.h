/* Where the integral along lines breaks as theta runs over [0, pi): found in advance, so that every panel between is smooth.
 *
 *   - the line passes a vertex: the azimuth of q = V + p;
 *   - the line's circle touches an edge, d = 0: a square root on one side;
 *   - the place where the line crosses an edge passes a kink of G. On the edge, masking and shadowing swap where N.L = N.V,
 *     masking reaches 1 on the plane (4 v_N N - 2 V).L = 2 - 4 v_N^2, shadowing where 2 (N.H)(N.L) = V.H. There the
 *     second derivative jumps;
 *   - masking's zone on the line opens, |v_t| = v_N: the third does.
 */
#ifndef RL_REFERENCE_BREAKS_H
#define RL_REFERENCE_BREAKS_H

#include "reference/lines.h"

struct rl_break {
    double theta;
    bool touch;
};

/* Room that rl_breaks_find may need. */
size_t rl_breaks_most(const struct rl_light_set *set);

/* Fills the breaks, in no order and some perhaps twice; returns how many. */
size_t rl_breaks_find(struct rl_break *breaks, const struct rl_lines *lines);

#endif
