/* Within the study `fps`: the judgement of its claims, apart from the measuring. */
#ifndef RL_STUDIES_FPS_H
#define RL_STUDIES_FPS_H

#include "studies/study.h"

/* Cases by arm: none, plain, regular-13, random-4, random-4-again, environment, each with its series frame_ms paired by round. */
int rl_fps_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

#endif
