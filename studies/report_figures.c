/* The figures of the report: which there are, where they are, and drawing them all at once (see report_page.h). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "results/html.h"
#include "studies/report_page.h"

/* The figures of a scene, or of the cases without one. */
static const struct rl_figure *figures_of(const struct rl_study *study, const char *scene, size_t *n)
{
    bool alone = strcmp(scene, RL_NO_SCENE) == 0;
    *n = alone ? study->n_figures_alone : study->n_figures;
    return alone ? study->figures_alone : study->figures;
}

/* Whether the series of a scene's f-th figure was measured on it. */
static bool wanted(const struct rl_study *study, size_t f, const struct rl_run *run, const char *scene)
{
    const char *pattern =
        study->figure_patterns && strcmp(scene, RL_NO_SCENE) != 0 ? study->figure_patterns[f] : NULL;
    return !pattern || rl_run_find(run, scene, pattern);
}

static size_t count_figures(const struct rl_study *study, const struct rl_run *run)
{
    size_t total = 0, n;
    const char *scene;
    for (size_t i = 0; (scene = rl_run_scene(run, i)); i++, total += n)
        figures_of(study, scene, &n);
    return total;
}

static void add_figure(struct rl_report_page *page, const struct rl_study *study,
                       const struct rl_figure *figure, const char *scene)
{
    struct rl_report_figure *f = &page->figure[page->n_figures];
    struct rl_plot_figure *p = &page->plot[page->n_figures++];
    char place[160];
    rl_html_name(place, sizeof place, scene);
    *f = (struct rl_report_figure){.study = study, .figure = figure, .scene = scene};
    snprintf(f->name, sizeof f->name, "%.40s-%.40s-%s", study->name, figure->name, place);
    snprintf(f->anchor, sizeof f->anchor, "figure-%.40s-%s", figure->name, place);
    *p = (struct rl_plot_figure){.tables = page->options->folder, .name = figure->name, .scene = scene};
    snprintf(p->script, sizeof p->script, "%.70s.gp", study->name);
    snprintf(p->stem, sizeof p->stem, "%s/%s", page->options->folder, f->name);
}

int rl_report_draw(struct rl_report_page *page)
{
    size_t total = 0;
    for (size_t i = 0; i < rl_n_studies; i++)
        if (rl_report_measured(&page->data->run[i]))
            total += count_figures(rl_studies[i], &page->data->run[i]);
    page->figure = calloc(total + 1, sizeof *page->figure);
    page->plot = calloc(total + 1, sizeof *page->plot);
    if (!page->figure || !page->plot)
        return rl_fail_memory(page->error, "the report's figures");
    const char *scene;
    for (size_t i = 0; i < rl_n_studies; i++) {
        const struct rl_run *run = &page->data->run[i];
        for (size_t k = 0; rl_report_measured(run) && (scene = rl_run_scene(run, k)); k++) {
            size_t n;
            const struct rl_figure *figure = figures_of(rl_studies[i], scene, &n);
            for (size_t f = 0; f < n; f++)
                if (wanted(rl_studies[i], f, run, scene))
                    add_figure(page, rl_studies[i], &figure[f], scene);
        }
    }
    return rl_plot_figures(page->plot, page->n_figures, page->options->threads, page->progress, page->error);
}

size_t rl_report_find_figure(const struct rl_report_page *page, const struct rl_study *study,
                             const char *figure, const char *scene)
{
    for (size_t i = 0; i < page->n_figures; i++) {
        const struct rl_report_figure *f = &page->figure[i];
        if (f->study == study && strcmp(f->scene, scene) == 0 &&
            (!figure || strcmp(f->figure->name, figure) == 0))
            return page->plot[i].missing ? page->n_figures : i;
    }
    return page->n_figures;
}
