/* Glue: the GLSL that joins a program's modules, written from the plan. It stands before the last module. */
#ifndef RL_GPU_GLUE_H
#define RL_GPU_GLUE_H

#include "base/error.h"
#include "scene/plan.h"

/* What the surface pass calls: vec3 shade_effects(Surface s), the sum of the material's effects over the lights that they see, and
 * vec3 shade_highlight(Surface s), the highlight that has no pass of its own or 0. Free *text. */
int rl_glue_surface(char **text, const struct rl_plan_material *material, struct rl_error *error);

#endif
