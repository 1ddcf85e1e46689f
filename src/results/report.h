/* The parts of the report page that come out of the results: verdicts, tables, provenance.
 *
 *     rl_html_begin(&page, title);
 *     rl_report_claims(&page, &claims);
 *     rl_report_table(&page, &table, &run);
 *     rl_html_end(&page);
 */
#ifndef RL_RESULTS_REPORT_H
#define RL_RESULTS_REPORT_H

#include <stddef.h>

#include "results/claims.h"
#include "results/export.h"
#include "results/html.h"
#include "results/record.h"

/* The table of verdicts: claim, verdict, value with its 95 % interval, study, command. */
void rl_report_claims(struct rl_buffer *page, const struct rl_claims *claims);

/* "3 of 8 claims hold, 1 holds up to a point, ..." as a text. */
void rl_report_count(char text[], size_t size, const struct rl_claims *claims);

/* The rows of a study's table in a box that scrolls, with the file that holds it. */
void rl_report_table(struct rl_buffer *page, const struct rl_table *table, const struct rl_run *run,
                     const char *file);

/* The run's scenes and their hashes; program, machine and renderer that measured it, unless `before`, the run shown
 * before it (or NULL), has the same. */
void rl_report_provenance(struct rl_buffer *page, const struct rl_run *run, const struct rl_run *before);

/* Cases planned but not measured, and cases that failed with their messages; nothing if there are none. */
void rl_report_missing(struct rl_buffer *page, const struct rl_run *run);

#endif
