/* What accuracy each pixel of an image has reached, and the passes by which all of them come to the one that is wanted.
 *
 * Under a time budget the image is drawn in passes of decreasing tolerance. A pixel keeps the best result it has had, and is
 * drawn again only until its error is within the wanted tolerance. Since the quadrature takes the same steps whatever its
 * tolerance and merely stops earlier (quadrature.h), a pixel that a loose pass brought within the wanted tolerance has the very
 * value that one pass would have given.
 */
#ifndef RL_REFERENCE_ACCURACY_H
#define RL_REFERENCE_ACCURACY_H

#include <stdbool.h>
#include <stddef.h>

#include "image/image.h"
#include "reference/integrator.h"

enum { RL_PASSES_MAX = 8 };

/* One pixel. */
struct rl_accuracy {
    float error[3]; /* stated error of L_o, rounded up */
    bool drawn;     /* a foreground pixel that has a value */
    bool done;      /* background, or within the wanted tolerance: not to be drawn again */
};

/* Over the foreground, all in units of L_o: before the material's factor, and before rounding to float. */
struct rl_accuracy_summary {
    size_t foreground, within; /* pixels */
    double worst_error, rms_error, mean_error;
    size_t nonfinite; /* values of the image */
};

/* The tolerances of the passes, relative to the brightest light, the last being the wanted one. Returns how many. */
int rl_accuracy_passes(double tolerance[RL_PASSES_MAX], double wanted);

/* Takes in a new result for a pixel; `wanted` is the absolute tolerance, `last` says that this was the last pass. Returns false,
 * and changes nothing, if the pixel had a better result already. */
bool rl_accuracy_improve(struct rl_accuracy *reached, const struct rl_estimate *estimate, double wanted,
                         bool last);

void rl_accuracy_summarise(struct rl_accuracy_summary *summary, const struct rl_accuracy *reached,
                           const struct rl_image *image);

#endif
