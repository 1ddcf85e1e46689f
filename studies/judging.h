/* What the judges of studies share: the claims of one scene, and verdicts along an axis such as R_r.
 *
 *     struct rl_judging j = {run, scene, claims, error};
 *     double rr[RL_AXIS_MAX];
 *     size_t n = rl_judging_axis(&j, "series=methods", "rr", rr);
 *     struct rl_claim *c = rl_judging_claim(&j, "paper: 4 random normals suffice");
 *     rl_judging_along(c, rr, verdict, n);
 */
#ifndef RL_STUDIES_JUDGING_H
#define RL_STUDIES_JUDGING_H

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

/* A new claim about the scene, its name added in brackets; NULL if memory runs out. */
struct rl_claim *rl_judging_claim(const struct rl_judging *j, const char *text);

/* The metric of the first measured row that matches; NULL if there is none. */
const struct rl_metric *rl_judging_metric(const struct rl_judging *j, const char *pattern,
                                          const char *metric);

/* The different values of a parameter among measured rows that match `pattern`, ascending. */
size_t rl_judging_axis(const struct rl_judging *j, const char *pattern, const char *key,
                       double value[RL_AXIS_MAX]);

/* The R_r nearest to the central one, in ratio. */
double rl_central_rr(const double *rr, size_t n);

/* The verdicts at the R_r of an ascending axis make one: holds or fails where they all do. Where it holds without a gap from one end, the
 * smooth or the rough one, and fails somewhere beyond, its reach is the last such R_r, which
 * becomes the claim's value, and the next R_r the other end of the interval that holds the limit; of two
 * such reaches the longer one. Else the claim is left as it is. */
void rl_judging_along(struct rl_claim *c, const double *rr, const enum rl_verdict *verdict, size_t n);

/* Adds "; R_r 3: 0.031" to the note, "none" for an infinite value. */
void rl_judging_note(struct rl_claim *c, double rr, double value);

/* a / b as the claim's value, their intervals taken for independent: the worst of both ends. */
void rl_judging_ratio(struct rl_claim *c, const struct rl_metric *a, const struct rl_metric *b,
                      const char *unit);

#endif
