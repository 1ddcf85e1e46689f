/* Boxes for `cubature`: the cells of area.h in pieces on which the integrand over the area is tame.
 *
 *     f(s, t) = p(delta') G / (4 (V.H) |sin delta'|) (h/r^3) d area/(ds dt),   u = near(s) + t (1 - near(s))
 *
 * with h the distance of the light's plane and r that of the point from P; p is D, or in the printed frame, whose tangents have
 * the length l, D(delta) d delta/d delta' with tan(delta') = l tan(delta), delta' being where the normal stands.
 *
 * A box is halved for as long as
 *   - it is larger than its distance from P, or takes up too much of a turn about its apex, or near(s) changes much along it;
 *   - the microfacet normal turns across it by more than its distance from N and the width of D allow.
 * Then no peak can hide between the points of a rule. What is left inside are the kinks of G. A kink that may be in a box has a bound
 * on the error it makes there, and the boxes with the largest are halved until the sum of the bounds is small enough.
 */
#ifndef RL_REFERENCE_BOXES_H
#define RL_REFERENCE_BOXES_H

#include "model/ellipsoid.h"
#include "reference/area.h"

struct rl_box {
    const struct rl_area_cell *cell;
    double s0, s1, t0, t1;
    double kink; /* bound on what a kink inside may add to the error of the integral; 0: there is none */
    bool kink_across_s;  /* it is met on the way along s rather than along t */
    double value, error; /* of the integral: for the caller */
    bool done;
};

struct rl_boxes {
    const struct rl_surface *surface; /* these first six by the caller */
    const struct rl_ellipsoid *e;
    const struct rl_cast *cast;
    bool attenuation;
    double stretch; /* l */
    size_t most;    /* boxes */
    size_t n, room;
    struct rl_box *box;
    bool unresolved; /* `most` did not suffice */
    bool failed;     /* memory did not */
};

/* The boxes of all cells, and on until the bounds of the kinks add up to `kinks` at most, or there are `most` boxes. */
void rl_boxes_make(struct rl_boxes *boxes, const struct rl_area *area, double kinks);
void rl_boxes_free(struct rl_boxes *boxes);

/* f. */
double rl_boxes_integrand(const struct rl_boxes *boxes, const struct rl_area_cell *cell, double s, double t);

#endif
