/* The part of a light polygon that is lit up and seen from a point, cut into cells for integration over its area.
 *
 * In the polygon's plane as seen from P everything that is seen or not changes along straight lines: the outline, the outlines of
 * other polygons projected from P, the lines where their planes pass through this one, and the horizon. Round an apex the plane is
 * cut into wedges at every end and meeting of these, so that in a wedge they lie one behind the other; between two of them
 * all is seen or nothing is, and one ray decides which. A cell is such a piece:
 *
 *     x(s, u) = apex + u ((1-s) from + s to),   u from near(s) to 1,   d area = u |from x to| du ds
 *
 * The factor u takes a pole at the apex out. The apices are where the mirror direction meets the plane, where the integrand over
 * the area has its pole 1/|sin delta|, and, where light from below the horizon counts, where -V does, with a pole 1/(V.H); each
 * serves the half plane nearer to it. Where neither is near, the polygon's middle is the apex.
 *
 * Outlines may be of any shape. Those that cross themselves are taken by winding number, as everywhere.
 */
#ifndef RL_REFERENCE_AREA_H
#define RL_REFERENCE_AREA_H

#include "reference/cast.h"
#include "reference/integrator.h"

struct rl_area_cell {
    size_t polygon;
    struct rl_point2 apex, from, to; /* in the cast polygon's axes; `from` and `to` relative to the apex */
    double near_from, near_to;       /* near(s) at s = 0 and s = 1, in [0, 1) */
};

struct rl_area {
    size_t n, room;
    struct rl_area_cell *cell;
};

/* The cells of all polygons. */
int rl_area_make(struct rl_area *area, const struct rl_cast *cast, const struct rl_surface *surface,
                 bool attenuation, struct rl_error *error);
void rl_area_free(struct rl_area *area);

/* near(s): the inner border is straight, so that 1/near is linear in s. */
static inline double rl_area_near(const struct rl_area_cell *cell, double s)
{
    double under = (1.0 - s) * cell->near_to + s * cell->near_from;
    return under > 0.0 ? cell->near_from * cell->near_to / under : 0.0;
}

#endif
