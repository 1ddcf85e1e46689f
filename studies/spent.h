/* Where a run's wall time goes, without a gap: at every moment the clock is on one kind of work, and what changes the kind puts
 * the old one back.
 *
 *     enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
 *     status = rl_gpu_scene_frame(...);
 *     rl_spent_on(&bench->spent, outer);
 *
 * The sum over all kinds is the time since rl_spent_begin. One thread only.
 */
#ifndef RL_STUDIES_SPENT_H
#define RL_STUDIES_SPENT_H

#include <stddef.h>

enum rl_spent_kind {
    /* What the study is about: frames and pictures drawn, read back and rounded, the integrators and samplers under test. */
    RL_SPENT_MEASURED,
    /* The truth it is held against: the reference computed or read from the cache, cdfs and integrals that samples are compared with. */
    RL_SPENT_REFERENCE,
    /* Before anything can be measured: opening the GPU, a scene's buffers, environment maps, normal maps, compiling shaders. */
    RL_SPENT_SETUP,
    /* What follows from it: error metrics, statistics. All of a study's measuring that is none of the others. */
    RL_SPENT_EVALUATION,
    /* Everything else: plans, looking up what is done, storing. */
    RL_SPENT_HARNESS,
    RL_SPENT_KINDS
};

struct rl_spent {
    double seconds[RL_SPENT_KINDS]; /* of the present kind up to `since` */
    double since;
    enum rl_spent_kind now;
};

/* "measured", "reference", "setup", "evaluation", "harness" */
const char *rl_spent_name(enum rl_spent_kind kind);

void rl_spent_begin(struct rl_spent *spent, enum rl_spent_kind kind);
/* From now on; gives what it was before. */
enum rl_spent_kind rl_spent_on(struct rl_spent *spent, enum rl_spent_kind kind);

/* "39.2 s: 71.0 % measured, 22.4 % reference, 3.1 % set-up, 2.6 % evaluation, 0.9 % harness"; without the harness where that has no
 * time, as groups have none. */
void rl_spent_text(char text[], size_t size, const double seconds[RL_SPENT_KINDS]);

#endif
