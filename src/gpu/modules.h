/* Shader modules: the files under shaders/, put together into the source of one shader, and compiler messages
 * traced back to them.
 *
 * Module K's lines are numbered from (K + 1) 10000 + 1 by a #line directive, so that a message about line 40012 is one about
 * line 12 of module 3's file. GLSL's own string numbers would not do: Mesa gives 0 for all but errors of syntax.
 */
#ifndef RL_GPU_MODULES_H
#define RL_GPU_MODULES_H

#include <stddef.h>

#include "base/error.h"
#include "scene/plan.h"

/* The source of a shader out of modules [first, end) of `program`: "#version", then `defines`, then the
 * modules; `glue`, if not NULL, before the last. Free *source with free(). */
int rl_modules_assemble(char **source, const struct rl_plan_program *program, size_t first, size_t end,
                        const char *defines, const char *glue, struct rl_error *error);

/* RL_ERR_INPUT with the first error of a compiler's log, as "shaders/effects/diffuse.glsl:12: message". */
int rl_modules_fail(const struct rl_plan_program *program, const char *log, struct rl_error *error);

#endif
