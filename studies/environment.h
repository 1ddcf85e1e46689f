/* Within the study `environment`: plan (environment.c), scenes moved about (environment_scene.c), measuring (environment_measure.c)
 * and claims (environment_claims.c). */
#ifndef RL_STUDIES_ENVIRONMENT_H
#define RL_STUDIES_ENVIRONMENT_H

#include "studies/study.h"

/* Four kinds of cases, a group each, but for seam, which has one for each place:
 *
 *     series=size env_size=S           rmse_map: pictures against those of the largest map with the same seeds; floor_map:
 *                                      the same, noise taken out; floor_centre: against the reference from the
 *                                      object's centre, noise taken out
 *     series=format env_format=F       rmse_map, floor_map: against rgba32f of the same size
 *     series=parallax away=A           parallax: the reference from the centre against that from each point, lights A times as
 *                                      far and as large; size: the object's radius over the first light's distance
 *     series=seam place=P env_size=S   rmse_map, floor_map: the first light alone in the middle of a face, across an edge or a corner
 *
 * Of all, highlight: how strong it is, as the noise of the base's pictures, of parallax its RMS; 0: there is nothing to judge.
 *
 * Rows with "base=1" are what the others of their group are held against. */
int rl_environment_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                           const struct rl_scene *scene, struct rl_error *error);

int rl_environment_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

/* How a scene is moved. */
struct rl_environment_move {
    double
        away; /* lights this many times as far from the first shiny object's centre, and as large: seen from there
                          nothing changes */
    rl_vec3
        direction; /* zero, or where the first light is turned to from there, the whole scene with it; it is then
                          the only one */
};

/* A copy whose highlights are all that is left of it, moved. Its hash tells it from other copies. What it does not own is the
 * original's, which must outlive it. */
int rl_environment_scene_make(struct rl_scene *copy, const struct rl_scene *scene,
                              const struct rl_environment_move *move, struct rl_error *error);
void rl_environment_scene_free(struct rl_scene *copy);

/* RL_ERR_INPUT where the lights of a series=parallax case (away=A) would reach into the sphere around an object with a highlight: there is
 * no light in front of its surface then. Up to the scene as it is (A >= 1) nothing is refused. Other cases: RL_OK. */
int rl_environment_check(const char *parameters, const struct rl_scene *scene, struct rl_error *error);

/* The first object with a highlight; 0 if there is none. */
size_t rl_environment_object(const struct rl_scene *scene);

#endif
