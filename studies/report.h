/* From the database to tables and the report page.
 *
 * The latest run of every study is what counts. Exports: NAME.tsv for each table of each study, frame_times.tsv with every raw
 * sample, provenance.tsv with what measured them, claims.tsv with every verdict; the same with .json. The report is a folder with index.html, the tables, the plots as SVG
 * and PNG, and the pictures; nothing in it refers to anything outside.
 */
#ifndef RL_STUDIES_REPORT_H
#define RL_STUDIES_REPORT_H

#include "base/error.h"
#include "base/progress.h"
#include "results/claims.h"
#include "results/export.h"

/* The latest run of each study, in the order of rl_studies; and their claims. A claim that has no number, though every case of its run was
 * measured, stands apart: it is in no table, and its study's page lists it with the reason. */
struct rl_report_data {
    struct rl_run *run;     /* [rl_n_studies] */
    struct rl_run *derived; /* [rl_n_studies], what follows from each (struct rl_study, derive) */
    struct rl_claims claims;
    struct rl_claims without; /* a number: all that was planned is measured, and it did not make one */
};

int rl_report_load(struct rl_report_data *data, const char *database, struct rl_error *error);
void rl_report_clear(struct rl_report_data *data);

/* Writes the tables of all studies of which something was measured into `folder`, which is made if need be, and removes those of others
 * from it. A table of a measured study may be without rows: its plots read it. */
int rl_report_export(const struct rl_report_data *data, const char *folder, enum rl_export_format format,
                     struct rl_error *error);

/* Writes each measured study's share of frame_times as NAME_raw.tsv: what its plots read, who need not look through all for it. */
int rl_report_export_raw(const struct rl_report_data *data, const char *folder, struct rl_error *error);

struct rl_report_options {
    const char *database, *folder, *cache, *backend;
    int threads;
};

int rl_report_make(const struct rl_report_options *options, const struct rl_progress *progress,
                   struct rl_error *error);

#endif
