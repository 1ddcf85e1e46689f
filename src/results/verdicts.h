/* Claims and their verdicts as HTML: the same claim about several scenes is one row with a cell for each.
 *
 *     struct rl_verdict_rows rows;
 *     rl_verdict_rows_make(&rows, &claims, "samples", &error);
 *     rows.row[0].picture = "samples-error-teapot-star";             what studies know: its figure, its page, its command
 *     rl_verdict_overview(&page, &rows);                             short, for the page of all studies
 *     rl_verdict_details(&page, &rows);                              with notes and cases, for the study's own
 *     rl_verdict_rows_clear(&rows);
 *
 * On the study's page a claim has the anchor claim-N, N its place among the study's claims from 1 on; a case has case-IDENTITY
 * (rl_report_table), a figure figure-NAME-SCENE.
 */
#ifndef RL_RESULTS_VERDICTS_H
#define RL_RESULTS_VERDICTS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "results/buffer.h"
#include "results/claims.h"

struct rl_verdict_cell {
    const struct rl_claim *claim;
    size_t number; /* among the study's claims, from 1 on */
};

/* One claim, about as many scenes as it has cells. */
struct rl_verdict_row {
    char text[256]; /* without "paper: " or "ours: " in front and the scene in brackets behind */
    bool paper;
    size_t n;
    struct rl_verdict_cell *cell; /* in the order of the claims */
    char picture[256];            /* the figure's files are PICTURE.small.png and so on; "": there is none */
    char anchor[256];             /* of the figure on the study's page */
    char command[1024];           /* measures all of its cells; "": their own commands, one after another */
};

/* The paper's claims first, else in their order. */
struct rl_verdict_rows {
    size_t n;
    struct rl_verdict_row *row;
    char page[96]; /* of the study, e.g. samples.html */
};

int rl_verdict_rows_make(struct rl_verdict_rows *rows, const struct rl_claims *claims, const char *study,
                         struct rl_error *error);
void rl_verdict_rows_clear(struct rl_verdict_rows *rows);

/* Figure, claim with its command, and by scene the verdict, the value, its interval. */
void rl_verdict_overview(struct rl_buffer *page, const struct rl_verdict_rows *rows);
/* The same with notes and the cases that each verdict comes from. */
void rl_verdict_details(struct rl_buffer *page, const struct rl_verdict_rows *rows);

/* How many claims of a study (NULL: of all) have each verdict; `only` 'p': the paper's alone, 'o': ours alone, 0: both. */
struct rl_verdict_count {
    size_t n, of[4]; /* by enum rl_verdict */
};
struct rl_verdict_count rl_verdict_count(const struct rl_claims *claims, const char *study, char only);

/* "✓ 3 hold": a verdict with its mark and its words, or with a number in place of the words. */
void rl_verdict_badge(struct rl_buffer *page, enum rl_verdict verdict);
void rl_verdict_badge_count(struct rl_buffer *page, enum rl_verdict verdict, size_t n);

/* The four in the order in which tables show them: holds, holds up to, fails, inconclusive. */
extern const enum rl_verdict rl_verdict_order[4];

#endif
