/* Functions of shader modules, evaluated row by row in a compute shader.
 *
 *     struct rl_plan_program program = {.pass = "probe"};      modules, the last one "passes/probe"
 *     rl_gpu_compute(gpu, &program, glue, arguments, 3, results, 6, n_rows, &error);
 *
 * `glue` defines void evaluate(float a[N_IN], out float r[N_OUT]) with the functions that the modules before the last define.
 * Arguments and results are single precision, as shaders have them.
 */
#ifndef RL_GPU_COMPUTE_H
#define RL_GPU_COMPUTE_H

#include <stddef.h>

#include "gpu/gpu.h"

/* RL_ERR_INPUT: a shader error, with module and line; RL_ERR_SYSTEM: OpenGL's. Every context has compute shaders: they came with OpenGL
 * 4.3, and rl_gpu_open asks for 4.5. */
int rl_gpu_compute(struct rl_gpu *gpu, const struct rl_plan_program *program, const char *glue,
                   const float *arguments, size_t n_in, float *results, size_t n_out, size_t n_rows,
                   struct rl_error *error);

#endif
