/* Writes into an image where it came from, as attributes "roughlight:NAME": version, commit, scene and its hash, every
 * parameter that determines the picture, seed, renderer, CPU, threads, seconds, and the date. Of a photometric scene also
 * whiteLuminance, the cd/m^2 that 1 stands for.
 */
#ifndef RL_RESULTS_STAMP_H
#define RL_RESULTS_STAMP_H

#include <stdbool.h>

#include "base/error.h"
#include "image/image.h"
#include "scene/plan.h"
#include "scene/scene.h"

/* `renderer`: what drew it, e.g. the GL renderer's name or "CPU, Embree 3.13.5"; `threads`: it used;
 * `seconds`: it took. */
int rl_stamp_image(struct rl_image *image, const struct rl_scene *scene, const struct rl_plan *plan,
                   const char *renderer, int threads, double seconds, struct rl_error *error);

/* What an image whose values carry their error says of it: over the foreground, of L_o. */
struct rl_stamp_accuracy {
    size_t foreground, within; /* pixels; those within the tolerance */
    double worst_error, rms_error, mean_error;
    double max_seconds; /* the budget; 0: none, and none is written */
};

int rl_stamp_accuracy(struct rl_image *image, const struct rl_stamp_accuracy *accuracy,
                      struct rl_error *error);

/* What an image is known by where it is kept: all that it depends on, as text. It says so itself, whatever its file is called. */
int rl_stamp_key(struct rl_image *image, const char *key, struct rl_error *error);
bool rl_stamp_has_key(const struct rl_image *image, const char *key);

#endif
