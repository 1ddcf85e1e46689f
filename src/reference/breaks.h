/* Where the integral along lines breaks as theta runs over [0, pi): found in advance, so that every panel between is smooth.
 *
 *   - the line passes a vertex: the azimuth of q = V + p;
 *   - the line's circle touches an edge, d = 0: a square root on one side;
 *   - the place where the line crosses an edge passes a kink of G. On the edge, masking and shadowing swap where N.L = N.V,
 *     masking reaches 1 on the plane (4 v_N N - 2 V).L = 2 - 4 v_N^2, shadowing where 2 (N.H)(N.L) = V.H. There the
 *     second derivative jumps;
 *   - masking's zone on the line opens, |v_t| = v_N: the third does;
 *   - without attenuation, the place where the line crosses an edge passes from one end of the line to the other, N.L = -N.V: the
 *     second derivative jumps;
 *   - the line passes where edges of two polygons cross, seen from P, or where one polygon passes through another: what hides what
 *     changes there. The seam along which it does is an edge like any other.
 */
#ifndef RL_REFERENCE_BREAKS_H
#define RL_REFERENCE_BREAKS_H

#include "reference/lines.h"

enum rl_break_kind {
    RL_BREAK_ROOT, /* no break: an edge's great circle would be touched here if the edge went on; where the circle is crossed nearby,
                     * the integrand goes like a square root that starts here */
    RL_BREAK_KINK, /* a derivative jumps */
    RL_BREAK_TOUCH, /* a square root starts */
};

struct rl_break {
    double theta;
    enum rl_break_kind kind;
};

/* Room that rl_breaks_find may need. */
size_t rl_breaks_most(const struct rl_light_set *set);

/* One edge's start, three touches, four planes and up to five kinks of shadowing. */
enum { RL_BREAKS_OF_EDGE = 13 };

/* Those of one edge: at most RL_BREAKS_OF_EDGE. */
size_t rl_breaks_of_edge(struct rl_break *breaks, const struct rl_lines *lines, const struct rl_edge *edge);

/* Fills the breaks, in no order and some perhaps twice; returns how many. *complete: false where so many pairs of polygons cross that
 * some breaks were left out. */
size_t rl_breaks_find(struct rl_break *breaks, bool *complete, const struct rl_lines *lines);

/* Its part that looks at pairs of polygons (overlap.c). */
size_t rl_overlap_breaks_most(const struct rl_light_set *set);
size_t rl_overlap_breaks(struct rl_break *breaks, bool *complete, const struct rl_lines *lines);

/* Where a line's circle touches the great circle m, whatever part of that is an edge: up to two, as RL_BREAK_ROOT, and where those two
 * nearly coincide, a RL_BREAK_KINK. */
enum { RL_TOUCHES_MOST = 3 };
size_t rl_touch_breaks(struct rl_break *breaks, const struct rl_lines *lines, rl_vec3 m);

/* The azimuth in [0, pi) of the undirected line along (x, y). */
double rl_line_azimuth(double x, double y);

#endif
