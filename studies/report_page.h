/* What the report's pages share while they are made. */
#ifndef RL_STUDIES_REPORT_PAGE_H
#define RL_STUDIES_REPORT_PAGE_H

#include <stdbool.h>
#include <stddef.h>

#include "results/buffer.h"
#include "results/plot.h"
#include "results/verdicts.h"
#include "studies/report.h"
#include "studies/spent.h"
#include "studies/study.h"

/* A figure of one scene: its files and its anchor. */
struct rl_report_figure {
    const struct rl_study *study;
    const struct rl_figure *figure;
    const char *scene;
    char name[256];   /* of its files, without folder and ending */
    char anchor[256]; /* on the study's page */
};

struct rl_report_page {
    const struct rl_report_options *options;
    const struct rl_report_data *data;
    const struct rl_progress *progress;
    struct rl_error *error;
    size_t n_figures;
    struct rl_report_figure *figure; /* [n_figures], in the order of studies, scenes, figures */
    struct rl_plot_figure *plot;     /* [n_figures], the same */
};

/* Draws every figure of every measured run. */
int rl_report_draw(struct rl_report_page *page);
/* The figure of a scene by its name, NULL: the first; its place among the figures, or n_figures if there is no such picture. */
size_t rl_report_find_figure(const struct rl_report_page *page, const struct rl_study *study,
                             const char *figure, const char *scene);

/* Every study's page. */
int rl_report_write_studies(const struct rl_report_page *page);

/* The rows of a study's claims, with figures and commands. */
int rl_report_rows(struct rl_verdict_rows *rows, const struct rl_report_page *page, size_t study);

/* Links to all pages; `here` is the study whose page it is, or rl_n_studies on the overview. */
void rl_report_navigation(struct rl_buffer *text, const struct rl_report_page *page, size_t here);

/* Writes the text as FOLDER/name. */
int rl_report_write(const struct rl_report_page *page, const struct rl_buffer *text, const char *name);

/* Adds where the time of the run's groups went to `seconds`; what was asked for but not measured anew counts as when it was. */
void rl_report_spent(double seconds[RL_SPENT_KINDS], const struct rl_run *run);
/* A line that says it in words; nothing if there is none. */
void rl_report_add_spent(struct rl_buffer *text, const double seconds[RL_SPENT_KINDS], const char *of);

/* Whether any case of the run was measured. */
bool rl_report_measured(const struct rl_run *run);

#endif
