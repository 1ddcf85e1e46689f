/* A study's own page: claims in full, figures, tables, provenance (see report_page.h). */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "results/html.h"
#include "results/report.h"
#include "studies/report_page.h"

bool rl_report_measured(const struct rl_run *run)
{
    return rl_run_count(run, RL_RECORD_OK) > 0;
}

void rl_report_spent(double seconds[RL_SPENT_KINDS], const struct rl_run *run)
{
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, NULL, ""));)
        for (int k = 0; k < RL_SPENT_HARNESS; k++) {
            char name[RL_NAME_MAX];
            snprintf(name, sizeof name, "spent_%s", rl_spent_name((enum rl_spent_kind)k));
            const struct rl_metric *m = rl_record_metric(r, name);
            seconds[k] += m ? m->value : 0.0;
        }
}

void rl_report_add_spent(struct rl_buffer *text, const double seconds[RL_SPENT_KINDS], const char *of)
{
    char words[256];
    double all = 0.0;
    for (int k = 0; k < RL_SPENT_KINDS; k++)
        all += seconds[k];
    if (!(all > 0.0))
        return;
    rl_spent_text(words, sizeof words, seconds);
    rl_buffer_printf(
        text,
        "<p class=\"spent\">%s. Where the time of %s went, by <a href=\"spent.tsv\">spent.tsv</a>; "
        "plans and the database are not in it.</p>\n",
        words, of);
}

void rl_report_navigation(struct rl_buffer *text, const struct rl_report_page *page, size_t here)
{
    rl_buffer_add(text,
                  here == rl_n_studies ? "<nav><b>Overview</b>" : "<nav><a href=\"index.html\">Overview</a>");
    for (size_t i = 0; i < rl_n_studies; i++) {
        if (page->data->run[i].n_records == 0)
            continue;
        const char *name = rl_studies[i]->name;
        if (i == here)
            rl_buffer_printf(text, " <b>%s</b>", name);
        else
            rl_buffer_printf(text, " <a href=\"%s.html\">%s</a>", name, name);
    }
    rl_buffer_add(text, "</nav>\n");
}

int rl_report_write(const struct rl_report_page *page, const struct rl_buffer *text, const char *name)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/%s", page->options->folder, name);
    return rl_buffer_write(text, path, page->error);
}

/* How many scenes a run has, the cases without one not among them. */
static size_t count_scenes(const struct rl_run *run)
{
    size_t n = 0;
    const char *scene;
    for (size_t i = 0; (scene = rl_run_scene(run, i)); i++)
        n += strcmp(scene, RL_NO_SCENE) != 0;
    return n;
}

/* One command for all scenes of a claim; where they are all of the study's own they need not be named. */
static int row_command(struct rl_verdict_row *row, const struct rl_run *run, struct rl_error *error)
{
    const char **scene = calloc(row->n + 1, sizeof *scene);
    if (!scene)
        return rl_fail_memory(error, "a claim's scenes");
    for (size_t k = 0; k < row->n; k++)
        scene[k] = row->cell[k].claim->scene;
    rl_run_command(row->command, sizeof row->command, run, scene,
                   row->n == count_scenes(run) && rl_run_has_own_scenes(run) ? 0 : row->n);
    free(scene);
    return RL_OK;
}

int rl_report_rows(struct rl_verdict_rows *rows, const struct rl_report_page *page, size_t study)
{
    int status = rl_verdict_rows_make(rows, &page->data->claims, rl_studies[study]->name, page->error);
    for (size_t i = 0; i < rows->n && status == RL_OK; i++) {
        struct rl_verdict_row *row = &rows->row[i];
        const struct rl_claim *first = row->cell[0].claim;
        size_t f = rl_report_find_figure(page, rl_studies[study], first->figure, first->scene);
        if (f < page->n_figures) {
            snprintf(row->picture, sizeof row->picture, "%s", page->figure[f].name);
            snprintf(row->anchor, sizeof row->anchor, "%s", page->figure[f].anchor);
        }
        status = row_command(row, &page->data->run[study], page->error);
    }
    if (status != RL_OK)
        rl_verdict_rows_clear(rows);
    return status;
}

static const char *scene_title(const char *scene)
{
    return strcmp(scene, RL_NO_SCENE) == 0 ? "without a scene" : scene;
}

static void add_picture(struct rl_buffer *text, const struct rl_report_page *page, size_t i)
{
    const struct rl_report_figure *f = &page->figure[i];
    rl_buffer_printf(text, "<figure id=\"%s\">", f->anchor);
    if (page->plot[i].missing) {
        rl_buffer_add(text, "<figcaption>");
        rl_html_text(text, scene_title(f->scene));
        rl_buffer_printf(text, ": nothing to draw, no value is positive.</figcaption></figure>\n");
        return;
    }
    rl_buffer_printf(text,
                     "<a href=\"%s.svg\"><img src=\"%s.svg\" width=\"900\" height=\"620\" alt=\"figure ",
                     f->name, f->name);
    rl_html_text(text, f->figure->name);
    rl_buffer_add(text, ", ");
    rl_html_text(text, scene_title(f->scene));
    rl_buffer_add(text, "\"></a><figcaption>");
    rl_html_text(text, scene_title(f->scene));
    rl_buffer_printf(text, " <a href=\"%s.svg\">SVG</a> <a href=\"%s.png\">PNG</a></figcaption></figure>\n",
                     f->name, f->name);
}

/* Every figure once, with a picture for each scene: so they are compared. */
static void add_figures(struct rl_buffer *text, const struct rl_report_page *page,
                        const struct rl_study *study)
{
    for (size_t i = 0; i < page->n_figures; i++) {
        const struct rl_figure *figure = page->figure[i].figure;
        bool first = page->figure[i].study == study;
        for (size_t k = 0; k < i && first; k++)
            first = page->figure[k].figure != figure;
        if (!first)
            continue;
        rl_html_element(text, "h3", figure->name);
        rl_html_element(text, "p", figure->caption);
        rl_buffer_add(text, "<div class=\"plots\">\n");
        for (size_t k = i; k < page->n_figures; k++)
            if (page->figure[k].figure == figure)
                add_picture(text, page, k);
        rl_buffer_add(text, "</div>\n");
    }
}

static void add_each_table(struct rl_buffer *text, const struct rl_table *tables, size_t n,
                           const struct rl_run *run)
{
    for (size_t t = 0; t < n; t++) {
        char file[128];
        if (!rl_run_find(run, NULL, tables[t].pattern))
            continue;
        snprintf(file, sizeof file, "%s.tsv", tables[t].name);
        rl_report_table(text, tables, t, run, file);
    }
}

static void add_tables(struct rl_buffer *text, const struct rl_study *study, const struct rl_run *run,
                       const struct rl_run *derived)
{
    rl_buffer_add(
        text, "<h2 id=\"tables\">Tables</h2>\n<p>Every measured case is a row; its last column is what names "
              "it above, in the exported tables and in the database. Rows without a name follow from several "
              "cases.</p>\n");
    add_each_table(text, study->tables, study->n_tables, run);
    add_each_table(text, study->derived_tables, study->n_derived_tables, derived);
    rl_report_other_cases(text, study->tables, study->n_tables, run);
    rl_buffer_printf(
        text, "<p>Raw figures of every case, in the order taken: <a href=\"%s_raw.tsv\">%s_raw.tsv</a></p>\n",
        study->name, study->name);
}

/* The pages before and after, of studies that were run. */
static void add_neighbours(struct rl_buffer *text, const struct rl_report_page *page, size_t here)
{
    size_t before = here, after = here + 1;
    while (before > 0 && page->data->run[before - 1].n_records == 0)
        before--;
    while (after < rl_n_studies && page->data->run[after].n_records == 0)
        after++;
    rl_buffer_add(text, "<nav class=\"ends\">");
    if (before > 0)
        rl_buffer_printf(text, "<a href=\"%s.html\" rel=\"prev\">&larr; %s</a>", rl_studies[before - 1]->name,
                         rl_studies[before - 1]->name);
    rl_buffer_add(text, "<a href=\"index.html\">Overview</a>");
    if (after < rl_n_studies)
        rl_buffer_printf(text, "<a href=\"%s.html\" rel=\"next\">%s &rarr;</a>", rl_studies[after]->name,
                         rl_studies[after]->name);
    rl_buffer_add(text, "</nav>\n");
}

static void add_reproduction(struct rl_buffer *text, const struct rl_run *run)
{
    const char *scene[64];
    size_t n = 0;
    char command[RL_GRID_MAX + 4096];
    while (n < sizeof scene / sizeof scene[0] && (scene[n] = rl_run_scene(run, n)))
        n++;
    rl_run_command(command, sizeof command, run, scene, rl_run_has_own_scenes(run) ? 0 : n);
    rl_buffer_add(text,
                  "<h2 id=\"reproduce\">How to reproduce it, and where the figures come from</h2>\n<pre>");
    rl_html_text(text, command);
    rl_buffer_add(text, "\nroughlight study report</pre>\n");
    rl_report_provenance(text, run, NULL);
}

/* Claims that what was measured makes no number for: their verdict would be none, and they are in no table. */
static void add_without(struct rl_buffer *text, const struct rl_claims *without, const char *study)
{
    bool any = false;
    for (size_t i = 0; i < without->n; i++) {
        const struct rl_claim *c = &without->claim[i];
        if (strcmp(c->study, study) != 0)
            continue;
        if (!any)
            rl_buffer_add(text,
                          "<h3 id=\"without\">Claims without a number</h3>\n<p>All cases of this run are "
                          "measured, and none of them has what these claims take: they are neither judged "
                          "nor in claims.tsv. A larger grid may have it.</p>\n<ul class=\"without\">\n");
        any = true;
        rl_buffer_add(text, "<li>");
        rl_html_text(text, c->text);
        rl_buffer_add(text, ": ");
        rl_html_text(text, c->note);
        rl_buffer_add(text, "</li>\n");
    }
    rl_buffer_add(text, any ? "</ul>\n" : "");
}

static int write_study(const struct rl_report_page *page, size_t i)
{
    const struct rl_study *study = rl_studies[i];
    const struct rl_run *run = &page->data->run[i];
    struct rl_verdict_rows rows;
    struct rl_buffer text = {0};
    char title[128];
    int status = rl_report_rows(&rows, page, i);
    if (status != RL_OK)
        return status;
    snprintf(title, sizeof title, "roughlight: study %.64s", study->name);
    rl_html_begin(&text, title);
    rl_report_navigation(&text, page, i);
    snprintf(title, sizeof title, "Study %.64s", study->name);
    rl_html_element(&text, "h1", title);
    rl_buffer_add(&text, "<p class=\"lead\">");
    rl_html_text(&text, study->summary);
    rl_buffer_add(&text, ".</p>\n");
    rl_html_element(&text, "p", study->text);
    double seconds[RL_SPENT_KINDS] = {0};
    rl_report_spent(seconds, run);
    rl_report_add_spent(&text, seconds, "its cases");
    rl_report_missing(&text, run);
    rl_buffer_add(&text, "<h2 id=\"claims\">Claims</h2>\n");
    rl_verdict_details(&text, &rows);
    add_without(&text, &page->data->without, study->name);
    if (rl_report_measured(run)) {
        rl_buffer_add(&text, "<h2 id=\"figures\">Figures</h2>\n");
        add_figures(&text, page, study);
        add_tables(&text, study, run, &page->data->derived[i]);
    }
    add_reproduction(&text, run);
    add_neighbours(&text, page, i);
    rl_html_end(&text);
    status = rl_report_write(page, &text, rows.page);
    rl_verdict_rows_clear(&rows);
    rl_buffer_clear(&text);
    return status;
}

int rl_report_write_studies(const struct rl_report_page *page)
{
    int status = RL_OK;
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++)
        if (page->data->run[i].n_records > 0)
            status = write_study(page, i);
    return status;
}
