/* Within the study `fps`: what the notes of its claims on costs say of the models that they rest on. */
#ifndef RL_STUDIES_FPS_NOTES_H
#define RL_STUDIES_FPS_NOTES_H

#include "studies/judging.h"

/* One scene: what was measured, and the models fitted to it. */
struct rl_fps_costs {
    struct rl_judging measured, models;
};

/* A figure of a model, NULL if it has none. Whoever reads it reads the cases that the model was fitted to. */
const struct rl_metric *rl_fps_model_metric(const struct rl_fps_costs *k, const char *model,
                                            const char *metric);

/* Adds ", b 1.25 ns" with its interval; m NULL: nothing. */
void rl_fps_note_term(struct rl_claim *c, const struct rl_metric *m, const char *name);

/* All coefficients, R^2, the case that is described worst, and how many frames stand behind it. */
void rl_fps_note_fit(struct rl_claim *c, const struct rl_fps_costs *k, const char *model);

/* Why the model has no figures; nothing if it has. */
void rl_fps_note_refusal(struct rl_claim *c, const struct rl_fps_costs *k, const char *model);

#endif
