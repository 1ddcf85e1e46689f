/* The parts of the report's pages that come out of the results: tables, provenance. Verdicts: results/verdicts.h.
 *
 *     rl_html_begin(&page, title);
 *     rl_report_table(&page, study->tables, 0, &run, "samples.tsv");
 *     rl_html_end(&page);
 */
#ifndef RL_RESULTS_REPORT_H
#define RL_RESULTS_REPORT_H

#include <stddef.h>

#include "results/export.h"
#include "results/html.h"
#include "results/record.h"

/* The rows of the t-th of a study's tables in a box that scrolls, with the file that holds it. A row is the anchor case-IDENTITY unless
 * an earlier table has the same case. */
void rl_report_table(struct rl_buffer *page, const struct rl_table *tables, size_t t,
                     const struct rl_run *run, const char *file);

/* The measured cases that none of the n tables has; nothing if there are none. */
void rl_report_other_cases(struct rl_buffer *page, const struct rl_table *tables, size_t n,
                           const struct rl_run *run);

/* The run's scenes and their hashes; program, machine and renderer that measured it, unless `before`, the run shown
 * before it (or NULL), has the same. */
void rl_report_provenance(struct rl_buffer *page, const struct rl_run *run, const struct rl_run *before);

/* Cases planned but not measured, and cases that failed with their messages; nothing if there are none. */
void rl_report_missing(struct rl_buffer *page, const struct rl_run *run);

#endif
