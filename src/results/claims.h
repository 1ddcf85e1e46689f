/* Claims and their verdicts. A verdict is always computed from a figure, its interval and a bound; none is written down.
 *
 *     struct rl_claim *c = rl_claims_add(&claims, &error);
 *     snprintf(c->text, sizeof c->text, "paper: random 4 is faster than regular 13");
 *     rl_claim_value(c, 1.9, 1.85, 1.95, "1");
 *     c->verdict = rl_verdict_at_least(c->low, c->high, 1.0);
 */
#ifndef RL_RESULTS_CLAIMS_H
#define RL_RESULTS_CLAIMS_H

#include <stddef.h>

#include "base/error.h"
#include "base/hash.h"
#include "results/buffer.h"
#include "results/export.h"

enum rl_verdict {
    RL_VERDICT_INCONCLUSIVE, /* not measured, or the interval holds the bound */
    RL_VERDICT_HOLDS,
    RL_VERDICT_HOLDS_UP_TO, /* along an axis; the value is the last place where it holds */
    RL_VERDICT_FAILS
};

struct rl_claim {
    char text[256]; /* begins "paper: " (stated or implied there) or "ours: " */
    enum rl_verdict verdict;
    double value, low, high; /* NaN: not measured */
    char unit[64];
    char note[400]; /* one line beside the number: what it is, what it was held against */
    char study[64];
    char scene[64];     /* as records name it */
    const char *figure; /* of the study, that shows it; NULL: its first. A text that stays */
    char command[800];  /* reproduces it; words quoted for a shell */
    char size_px
        [96]; /* "96x72": of its cases' pictures, with ", " between different ones; "" where none has a picture */
    char seeds[64]; /* how many its cases have, likewise */
    size_t n_cases;
    char (*identity)[RL_HASH_TEXT]; /* of the cases that it comes from (see results/trace.h) */
};

struct rl_claims {
    size_t n;
    struct rl_claim *claim;
    struct rl_trace *trace; /* NULL: none is at work */
};

/* A new claim, inconclusive and without a value; NULL with `error` filled if memory runs out. Valid until the next is added. */
struct rl_claim *rl_claims_add(struct rl_claims *claims, struct rl_error *error);
void rl_claims_clear(struct rl_claims *claims);

void rl_claim_value(struct rl_claim *claim, double value, double low, double high, const char *unit);

/* Holds if the whole interval lies at or above (below) the bound, fails if all of it lies beyond, else inconclusive; NaN is
 * inconclusive. */
enum rl_verdict rl_verdict_at_least(double low, double high, double bound);
enum rl_verdict rl_verdict_at_most(double low, double high, double bound);
/* "The value is `target`", to within `margin` (an equivalence test): holds if the interval lies in [target - margin, target + margin],
 * fails if it lies outside, inconclusive if it reaches over an end. */
enum rl_verdict rl_verdict_equals(double low, double high, double target, double margin);

/* "holds", "holds up to", "fails", "inconclusive". */
const char *rl_verdict_name(enum rl_verdict verdict);

/* claims.tsv: columns claim, verdict, value, low, high, unit, study, command, scene, figure, note, cases, size_px, seeds; `cases` are identities
 * with a blank between two. */
void rl_claims_export(struct rl_buffer *out, const struct rl_claims *claims, enum rl_export_format format);

#endif
