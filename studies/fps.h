/* Within the study `fps`: plan (fps.c), scenes with more objects (fps_scene.c), measuring (fps_measure.c), cost models (fps_models.c)
 * and claims (fps_claims.c: Table 1; fps_cost_claims.c: what things cost).
 *
 * Cases by series, each a group of its own whose arms take turns frame by frame:
 *
 *     series=table1                          none, plain, regular-13, random-4, random-4-again, environment
 *     series=size                            the same methods by picture size and samples
 *     series=environment env_size=S          random-4, environment: by the map's size
 *     series=objects objects=N               none, random-4, environment: N objects in place of one, of as many pixels together
 *     series=roughness roughnesses=N         none, random-4, random-4-margin: N R_r among RL_FPS_OBJECTS objects
 *     series=maps roughnesses=N              normal-maps: the same scenes set up
 *     series=exhaustive env_size=S           exhaustive on the CPU, beside none and random-4
 *
 * `arm` says what is timed: `environment` the pass that draws the environment maps, `normal-maps` their baking and upload, every other
 * a frame; random-4-again is random-4 once more (A/A). `rounds` is the least number of rounds, `seconds` the cap of their
 * time; up to three times `rounds` are measured for an interval within 2 %. */
#ifndef RL_STUDIES_FPS_H
#define RL_STUDIES_FPS_H

#include "studies/study.h"

/* Kimura and Tokoi, Table 1: frames a second on a GeForce FX 5200. */
#define RL_PAPER_PLAIN_FPS 530.0
#define RL_PAPER_REGULAR_FPS 28.0 /* 13 normals */
#define RL_PAPER_RANDOM_FPS 38.0  /* 4 normals */

#define RL_FILM_FPS 24.0
#define RL_VIDEO_FPS 30.0

enum { RL_FPS_OBJECTS = 4, RL_FPS_OBJECTS_MAX = 1000 };

/* Fills metrics and the series frame_ms, paired by round within a group. */
int rl_fps_measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                   struct rl_error *error);

/* The arm of that name that was measured in the same group as `like` and has its picture size and objects, and otherwise most in common with
 * it; -1: none. */
long rl_fps_arm(const struct rl_record *records, size_t n, const struct rl_record *like, const char *name);

/* RL_ERR_INPUT: objects or roughnesses that are not 1 to RL_FPS_OBJECTS_MAX. */
int rl_fps_check(const char *parameters, struct rl_error *error);

/* The first object with a highlight, alone and `objects` times: each shrunk to 1/sqrt(objects), in rows across the line of sight, so that
 * all together cover about as many pixels as the one did. They wear `roughnesses` materials in turn, whose R_r are a thousandth
 * apart: other maps, the same work. What it does not own is the original's, which must outlive it. */
int rl_fps_scene_make(struct rl_scene *copy, const struct rl_scene *scene, int objects, int roughnesses,
                      struct rl_error *error);
void rl_fps_scene_free(struct rl_scene *copy);

/* The models of every scene that has a series: one record each, "model=NAME ...", with its coefficients and residuals; and the table
 * that shows them. */
int rl_fps_derive(struct rl_run *models, const struct rl_run *run, struct rl_error *error);
extern const struct rl_table rl_fps_model_table;

/* Reads the cases that a model is fitted to: a claim that rests on the model rests on them (results/trace.h). */
void rl_fps_read_cases(const struct rl_run *run, const char *scene, const char *model);

int rl_fps_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);
/* Those of the series beside table1. */
int rl_fps_judge_costs(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
