/* Whether a scene has anything for studies to measure: lights, and a highlight in the picture. Figures of nothing are all 0 and would
 * decide every claim.
 *
 *     if (rl_scene_check(&scene, &error) != RL_OK) ...
 */
#ifndef RL_STUDIES_SCENE_CHECK_H
#define RL_STUDIES_SCENE_CHECK_H

#include "base/error.h"
#include "image/image.h"
#include "scene/scene.h"

/* RL_ERR_INPUT: no light with area, no object whose material has a highlight, or none whose bounding sphere is behind the centre of some
 * pixel of the film. Takes milliseconds; what it lets through may still be covered, or missed by fewer pixels. */
int rl_scene_check(const struct rl_scene *scene, struct rl_error *error);

/* RL_ERR_INPUT: a picture (R, G, B, A) of nothing but background. */
int rl_foreground_check(const struct rl_image *picture, struct rl_error *error);

#endif
