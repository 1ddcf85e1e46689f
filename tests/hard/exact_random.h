/* Random rows of arguments for `exact --random`, made of the rows of a catalogue: ranges of columns, which of them are choices and which
 * exclude each other are known from there, for nothing of src/ is included here.
 *
 *     struct exact_draw d = {.seed = 20261126};
 *     exact_random_row(row, &d, f, rows, n);
 */
#ifndef RL_TESTS_HARD_EXACT_RANDOM_H
#define RL_TESTS_HARD_EXACT_RANDOM_H

#include <stdint.h>

#include "exact.h"

struct exact_draw {
    uint64_t seed, index;
};

/* `rows`: n x f->n_in of the catalogue, n > 0; NAN is an argument that is left out. Directions are no zero vectors and no longer than
 * 1e300; other columns stay within those of the catalogue. */
void exact_random_row(double row[], struct exact_draw *d, const struct exact_function *f, const double *rows,
                      size_t n);

#endif
