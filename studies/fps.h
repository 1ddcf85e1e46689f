/* Within the study `fps`: the judgement of its claims, apart from the measuring. */
#ifndef RL_STUDIES_FPS_H
#define RL_STUDIES_FPS_H

#include "studies/study.h"

/* Kimura and Tokoi, Table 1: frames a second on a GeForce FX 5200. */
#define RL_PAPER_PLAIN_FPS 530.0
#define RL_PAPER_REGULAR_FPS 28.0 /* 13 normals */
#define RL_PAPER_RANDOM_FPS 38.0  /* 4 normals */

/* Cases by arm: none, plain, regular-13, random-4, random-4-again, environment, each with its series frame_ms paired by round. */
int rl_fps_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
