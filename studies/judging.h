/* What the judges of studies share: the claims of one scene, and verdicts along an axis such as R_r.
 *
 *     struct rl_judging j = {run, scene, claims, error};
 *     double rr[RL_AXIS_MAX];
 *     size_t n = rl_judging_axis(&j, "series=methods", "rr", rr);
 *     struct rl_claim *c = rl_judging_claim(&j, "paper: 4 random normals suffice");
 *     struct rl_step step[RL_AXIS_MAX];
 *     rl_judging_steps(step, rr, n);
 *     step[i] = (struct rl_step){rr[i], m->value, m->low, m->high, rl_verdict_at_most(m->low, m->high, bound)}; ...
 *     rl_judging_conclude(c, step, n, "RMSE");
 */
#ifndef RL_STUDIES_JUDGING_H
#define RL_STUDIES_JUDGING_H

#include <stdbool.h>

#include "results/claims.h"
#include "results/record.h"

enum { RL_AXIS_MAX = 32 };

/* One step of an 8-bit frame buffer, of full scale 1. */
#define RL_STEP_OF_8_BITS (1.0 / 255.0)

/* Where single figures are taken: the highlight shows the light's shape. */
#define RL_CENTRAL_RR 30.0

/* One scene's rows of a run, and where its claims go. */
struct rl_judging {
    const struct rl_run *run;
    const char *scene;
    struct rl_claims *claims;
    struct rl_error *error;
};

/* A new claim about the scene, its name added in brackets if there is one; NULL if memory runs out. */
struct rl_claim *rl_judging_claim(const struct rl_judging *j, const char *text);

/* The metric of the first measured row that matches; NULL if there is none. */
const struct rl_metric *rl_judging_metric(const struct rl_judging *j, const char *pattern,
                                          const char *metric);

/* The different values of a parameter among measured rows that match `pattern`, ascending. */
size_t rl_judging_axis(const struct rl_judging *j, const char *pattern, const char *key,
                       double value[RL_AXIS_MAX]);

/* The R_r nearest to the central one, in ratio. */
double rl_central_rr(const double *rr, size_t n);

/* What a claim finds at one R_r of an ascending axis. NaN, inconclusive: not measured. */
struct rl_step {
    double rr, value, low, high;
    enum rl_verdict verdict;
};

/* One each R_r, not measured yet. */
void rl_judging_steps(struct rl_step step[RL_AXIS_MAX], const double *rr, size_t n);

/* The steps make one verdict, and the claim's number is what carries it:
 * - holds: at every R_r. The number that the claim already has, else that of the central R_r.
 * - holds up to: without a gap from one end, the smooth or the rough one (the longer of two such reaches), and not beyond. The last
 *   such R_r; the other end of its interval is the first R_r that fails, or there is none (infinity; from the smooth end 0).
 * - fails: at neither end does it hold, and some R_r fails. The number of that which fails, the nearest to the central one of several.
 * - inconclusive: likewise of what is undecided.
 * The note gets the R_r that the number belongs to, or what ended the reach, with its interval, and the other end's reach; then the
 * numbers of all. */
void rl_judging_conclude(struct rl_claim *c, const struct rl_step *step, size_t n, const char *unit);

/* Where what was looked for is not there the value is infinite, which is no number to show: the same verdict again, with the number that it
 * follows from in place of each step's. NULL: none was measured. */
void rl_judging_instead(struct rl_step *step, const struct rl_metric *m);
void rl_judging_conclude_again(struct rl_claim *c, const struct rl_step *step, size_t n, const char *unit);

/* For claims that hold where every case does: takes one more into the claim's verdict, which is `fails` if one fails, else inconclusive
 * if one is undecided. Whether this case speaks for all from now on, so that its number is the claim's: of those that carry the verdict
 * it is the worst. `*worst` is the badness of the speaker, NaN before the first; a NaN was not measured and says nothing. */
bool rl_judging_worse(struct rl_claim *c, enum rl_verdict verdict, double badness, double *worst);

/* Adds "; R_r 3: 0.031" to the note, "none" for an infinite value, "not measured" for NaN. */
void rl_judging_note(struct rl_claim *c, double rr, double value);

/* Whether there is anything to judge: without a highlight every error is 0 and every bound kept. `light` is the case's noise, or how strong
 * its highlight is; NULL, not recorded: taken for lit. */
bool rl_judging_lit(const struct rl_metric *light);
/* What the note then says. */
extern const char rl_judging_dark[];

/* What the note of a change of format that is exactly 0 says: the scene's values are such as the format holds, and other scenes'
 * need not be. */
extern const char rl_judging_exactly[];

/* a / b as the claim's value, their intervals taken for independent: the worst of both ends; NaN beside nothing. */
void rl_judging_ratio(struct rl_claim *c, const struct rl_metric *a, const struct rl_metric *b,
                      const char *unit);

#endif
