/* Within the study `bare`: plan and tables (bare.c), measuring and claims (bare_measure.c). */
#ifndef RL_STUDIES_BARE_H
#define RL_STUDIES_BARE_H

#include "studies/study.h"

/* What a scene may take, over the time of the bare program. */
#define RL_BARE_BOUND 1.03

/* Whether the bare program can draw the scene, once it has no effects but diffuse and phong. */
int rl_bare_fits(const struct rl_scene *scene, struct rl_error *error);

/* Arms of a group: the scene, with no effects but diffuse and phong, by its `plan` and by the bare program (bare_program.h) with `uniforms`,
 * with uniforms once `again` (A/A) and with `literals`. Metrics: those of timing_arms.h, time_to_uniforms and time_to_literals among them; worst, the largest
 * difference of a pixel from the plan's picture; of the plan also draws, programs, textures and stencil (buffers). */
int rl_bare_measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                    struct rl_error *error);

/* Metrics draws, programs, textures and stencil: what a frame of the scene draws, and what there is for it, as the GL layer counted
 * and OpenGL allocated. No plan is asked: whether it did what it says is what the figures are about. */
int rl_bare_add_work(struct rl_record *record, struct rl_gpu_scene *gs, struct rl_error *error);

int rl_bare_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
