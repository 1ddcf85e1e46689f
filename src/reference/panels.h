/* From the breaks of [0, pi) to the panels between them. */
#ifndef RL_REFERENCE_PANELS_H
#define RL_REFERENCE_PANELS_H

#include "reference/breaks.h"
#include "reference/quadrature.h"

/* Fills at most n_breaks + 1 panels that go once round the circle [0, pi): the last runs past pi to the first break. Sorts the
 * breaks. A root no further beyond a panel's end than the panel is long is marked there. Returns how many panels. */
size_t rl_panels_between(struct rl_panel *panels, struct rl_break *breaks, size_t n_breaks);

#endif
