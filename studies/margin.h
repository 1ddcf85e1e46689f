/* Within the study `margin`: plan (margin.c), measuring (margin_measure.c, margin_loss.c, margin_power.c) and claims (margin_claims.c). */
#ifndef RL_STUDIES_MARGIN_H
#define RL_STUDIES_MARGIN_H

#include "studies/seeds.h"
#include "studies/study.h"

/* Three kinds of cases. "series=margin arm=A": one group for each R_r, of the arms off, again (off once more: the noise floor), none, the
 * margins, auto and huge (which lets every pixel through: what the pass itself costs). "series=bound loss=X": the margin
 * that rl_margin_auto gives for the loss X, without a clock. "series=filled loss=X": the same X, but no scene.
 *
 * Metrics of all but off and again: spheres (1 if the plan has the pass), margin where it has; skipped, the share of the highlight
 * pass's pixels that it leaves out; missed, the share of the highlight's energy gone in frames of the same seeds, with
 * its interval over seeds, and worst, the most that a channel of a pixel loses in one of them; and of the integral itself, seen from
 * the object's centre, missed_exact, worst_exact and loss_exact, the mean over the pixels skipped. Shares of a highlight that is
 * not there (or, exactly, not above the tolerance) are not recorded. Losses are in units of the
 * brightest light's radiance. bound: what auto promises for worst_exact. from_rr: the R_r from
 * which on auto has a sphere. Of all where timed, and of an arm none without a highlight: what timing_arms.h adds, against that and against off.
 * Metrics of series=filled: bound, and where a light can have a sphere, filled, what two lights made for it lose of that (0: there
 * could be a sphere and is none), and due, what they would lose beside spheres that are just as large as the proof asks. */
int rl_margin_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                      const struct rl_scene *scene, struct rl_error *error);

/* What two equal lights on opposite sides of R = N, just outside of their spheres, take together from the pixel, over `loss`; the size at
 * which that is most. A light that is large beside the blur b meets each line at b/cos theta, and where the lobe's tail
 * falls as 1/delta^2 half of the bound is lost: 0.5 to 0.62 for R_r and losses where the largest lights have a sphere. Where only
 * small ones have one, that is little. */
struct rl_margin_filled {
    double lost; /* outside of the spheres of rl_margin_auto; NaN: no size has one */
    double due;  /* outside of spheres of just the angle that its proof asks for; NaN: none is that large */
};
struct rl_margin_filled rl_margin_filled(double rr, double loss);

int rl_margin_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

/* What the losses of a group's cases are taken from. Pictures are of the seeds 1 to n. */
struct rl_margin_truth {
    struct rl_seeds off;       /* without the pass */
    struct rl_image none;      /* without highlight */
    struct rl_image drawn;     /* where the highlight pass draws without the sphere pass */
    struct rl_image highlight; /* the integral alone; alpha 0 where the CPU saw another surface */
    double tolerance;          /* of `highlight` */
    double radiance;           /* of the brightest light */
};

int rl_margin_truth_make(struct rl_margin_truth *truth, struct rl_bench *bench, const struct rl_scene *scene,
                         const char *parameters, struct rl_error *error);
void rl_margin_truth_clear(struct rl_margin_truth *truth);

/* Draws `set` with every seed of the truth and adds what it loses. */
int rl_margin_add_loss(struct rl_record *record, struct rl_bench *bench, struct rl_bench_scene *set,
                       const struct rl_margin_truth *truth, struct rl_error *error);

#endif
