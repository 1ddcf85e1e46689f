/* Within the study `effects`: plan and tables (effects.c), measuring (effects_measure.c) and claims (effects_claims.c). */
#ifndef RL_STUDIES_EFFECTS_H
#define RL_STUDIES_EFFECTS_H

#include "studies/study.h"

/* The full scene is the scene with attenuation, spheres and culling; the bare one has none of all features (features.h) but culling. One case each feature, and
 * before them feature=all, which is about the scenes that they are held against.
 *
 * feature=all: full_ms, bare_ms; floor_ms, the most that two arms of the same work may differ by; time_zero, full frame with every
 * effect named that is not, its coefficients 0, over the full frame, and zero_work, what that has more of draws, programs, modules,
 * textures and bytes; time_sum, bare frame and everything that features add to it over the full frame; frames.
 * A feature: row, its place; named, 1 if the scene asks for it, else it was put on one of its materials (rl_view_host); added_ms to the bare
 * scene, to that with highlights where it needs them; removed_ms from the full one; time_added_clear and time_removed_clear,
 * 1 where that is more than the floor; the same two of draws, triangles, bytes, textures, programs and (different) modules; and the error of the full scene
 * without it against that with it: rmse, max, share of the foreground that changes. */
int rl_effects_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                       const struct rl_scene *scene, struct rl_error *error);

int rl_effects_fits(const struct rl_scene *scene, struct rl_error *error);

int rl_effects_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
