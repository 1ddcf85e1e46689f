/* Glue: the GLSL that joins a program's modules, written from the plan. It stands before the last module. */
#ifndef RL_GPU_GLUE_H
#define RL_GPU_GLUE_H

#include "base/error.h"
#include "scene/plan.h"

/* NULL: the stage needs none. */
struct rl_glue {
    char *vertex, *fragment;
};

/* What program `program` of the plan calls, with the effects of a material that uses it. Surface: vec3 shade_effects(Surface s), the sum of
 * the effects over the lights that they see, and vec3 shade_highlight(Surface s), the highlight that has no pass of its own or 0. Where the
 * effects are interpolated, vec3 shade_lights(Surface s) in the vertex shader and, in the fragment shader, vec3 shade_constants(), which are the
 * two parts of that sum, and what a highlight has. Highlight: vec3 highlight_factor(Surface s). Clear what was made, also after an error. */
int rl_glue_make(struct rl_glue *glue, const struct rl_plan_material *material, int program,
                 struct rl_error *error);
void rl_glue_clear(struct rl_glue *glue);

#endif
