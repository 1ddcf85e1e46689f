/* A compiled program of the plan, with the places of its uniforms. */
#ifndef RL_GPU_PROGRAM_H
#define RL_GPU_PROGRAM_H

#include <stdbool.h>

#include "gpu/context.h"
#include "scene/plan.h"

struct rl_gpu_program {
    GLuint id;
    size_t n_modules;                        /* in its text */
    bool kept;                               /* the context had it from before */
    const struct rl_plan_material *material; /* the first that uses it; the others agree. NULL: environment */
    /* -1 where the program has no such uniform, which OpenGL ignores when set. */
    GLint clip_from_world, eye, specular, sphere_scale, seen_from, environment_unit;
    GLint face, centre, near_plane;
    GLint effect_params
        [RL_MATERIAL_EFFECTS_MAX]; /* by row of rl_effects: materials of one program may differ in what others link */
    GLint method_params;
};

/* Assembles, compiles and links program `index` of the plan, or takes one of the same text that the context has kept: every uniform is
 * set before each draw. Loop bounds and sizes known to the plan are compiled in. */
int rl_program_make(struct rl_gpu_program *program, struct rl_gpu *gpu, const struct rl_plan *plan,
                    size_t index, const struct rl_scene *scene, struct rl_error *error);
void rl_program_free(struct rl_gpu_program *program, struct rl_gpu *gpu);
/* A program of one compute shader, of all the modules. Delete *id with DeleteProgram. */
int rl_program_make_compute(GLuint *id, struct rl_gl *gl, const struct rl_plan_program *program,
                            const char *defines, const char *glue, struct rl_error *error);

/* The distance in texels, along the normal map's rows laid end to end, between two samples of one pixel: odd,
 * so that the multiples run through the whole map before they repeat, and near its golden section, so that
 * they spread. */
unsigned rl_normal_map_step(int size);

#endif
