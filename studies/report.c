/* Puts the pages together: the overview here, each study's page in report_study.c (see report.h). */
#include "studies/report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "results/html.h"
#include "results/report.h"
#include "studies/gallery.h"
#include "studies/planner.h"
#include "studies/report_page.h"

/* What was measured where, in a sentence or two. */
static void add_opening(struct rl_buffer *page, const struct rl_report_page *p)
{
    char text[512];
    const struct rl_provenance *where = NULL;
    for (size_t i = 0; i < rl_n_studies; i++)
        if (rl_report_measured(&p->data->run[i]))
            where = &p->data->run[i].provenance;
    rl_html_element(page, "h1",
                    "Highlights of shaped lights on rough surfaces: what the method gains and what it loses");
    rl_buffer_add(
        page, "<p class=\"lead\">Kimura and Tokoi draw highlights that show the shape of a polygon light, "
              "blurred by surface roughness, nearly in real time. This page holds their claims, and what "
              "follows from their method, against measurements: every verdict is computed from a figure, "
              "its interval and a bound.</p>\n");
    if (where) {
        snprintf(text, sizeof text,
                 "Measured on %.100s with %d threads; renderer %.100s (%.30s): speeds are this renderer's, "
                 "and no verdict on the paper's own machine. Every interval is one of 95 %%: of errors and "
                 "times over seeds and frames.",
                 where->cpu, where->threads, where->renderer, where->backend);
        rl_html_element(page, "p", text);
    }
}

static void add_counts(struct rl_buffer *page, const struct rl_claims *claims, const char *study, char only)
{
    struct rl_verdict_count count = rl_verdict_count(claims, study, only);
    rl_buffer_add(page, "<td class=\"counts\">");
    for (size_t k = 0; k < 4 && count.n > 0; k++) {
        rl_verdict_badge_count(page, rl_verdict_order[k], count.of[rl_verdict_order[k]]);
        rl_buffer_add(page, " ");
    }
    rl_buffer_add(page, "</td>");
}

/* A row's last cell. */
static void add_seconds(struct rl_buffer *page, const double seconds[RL_SPENT_KINDS])
{
    double all = 0.0;
    for (int k = 0; k < RL_SPENT_KINDS; k++)
        all += seconds[k];
    rl_buffer_printf(page, "<td class=\"number\">%.1f s</td></tr>\n", all);
}

/* The verdicts of all studies at a glance. */
static void add_summary(struct rl_buffer *page, const struct rl_report_page *p)
{
    const struct rl_claims *claims = &p->data->claims;
    rl_buffer_add(page, "<h2 id=\"verdicts\">Verdicts</h2>\n<p>");
    for (size_t k = 0; k < 4; k++) {
        rl_verdict_badge(page, rl_verdict_order[k]);
        rl_buffer_add(page, k < 3 ? " " : "</p>\n<p>");
    }
    rl_buffer_add(
        page,
        "A claim holds, or fails, where the whole interval lies on one side of its bound; it holds up to "
        "a place on an axis where it fails beyond; else it is inconclusive. Claims about several scenes "
        "count once for each. <em>Paper</em>: stated or implied by Kimura and Tokoi; <em>ours</em>: "
        "follows from their method. <a href=\"claims.tsv\">claims.tsv</a> has them all.</p>\n"
        "<div class=\"scroll wide\"><table class=\"summary\"><thead><tr><th>Study</th><th>What it "
        "measures</th>"
        "<th>The paper's claims</th><th>Ours</th><th class=\"number\">Cases</th><th "
        "class=\"number\">Time</th></tr></thead>\n<tbody>\n");
    double all[RL_SPENT_KINDS] = {0};
    for (size_t i = 0; i < rl_n_studies; i++) {
        const struct rl_run *run = &p->data->run[i];
        if (run->n_records == 0)
            continue;
        rl_buffer_printf(page, "<tr><td><a href=\"#%s\">%s</a></td><td>", run->study, run->study);
        rl_html_text(page, rl_studies[i]->summary);
        rl_buffer_add(page, "</td>");
        add_counts(page, claims, run->study, 'p');
        add_counts(page, claims, run->study, 'o');
        double seconds[RL_SPENT_KINDS] = {0};
        rl_report_spent(seconds, run);
        rl_report_spent(all, run);
        rl_buffer_printf(page, "<td class=\"number\">%zu</td>", rl_run_count(run, RL_RECORD_OK));
        add_seconds(page, seconds);
    }
    rl_buffer_printf(page, "<tr><th>all</th><th>%zu claims</th>", claims->n);
    add_counts(page, claims, NULL, 'p');
    add_counts(page, claims, NULL, 'o');
    rl_buffer_add(page, "<td></td>");
    add_seconds(page, all);
    rl_buffer_add(page, "</tbody></table></div>\n");
    rl_report_add_spent(page, all, "all cases");
}

/* A study's claims in short. */
static int add_claims(struct rl_buffer *page, const struct rl_report_page *p, size_t i)
{
    struct rl_verdict_rows rows;
    const char *name = rl_studies[i]->name;
    int status = rl_report_rows(&rows, p, i);
    if (status != RL_OK)
        return status;
    rl_buffer_printf(page, "<h2 id=\"%s\">%s: ", name, name);
    rl_html_text(page, rl_studies[i]->summary);
    rl_buffer_printf(page, "</h2>\n<p><a href=\"%s\">Notes, cases, figures and tables of %s</a></p>\n",
                     rows.page, name);
    rl_verdict_overview(page, &rows);
    rl_verdict_rows_clear(&rows);
    return RL_OK;
}

/* The pictures are this program's; figures may be older. */
static void note_other_build(struct rl_buffer *page, const struct rl_report_page *p,
                             const struct rl_provenance *now)
{
    bool any = false;
    for (size_t i = 0; i < rl_n_studies; i++) {
        const struct rl_run *run = &p->data->run[i];
        if (run->n_records == 0 || strcmp(run->provenance.code_hash, now->code_hash) == 0)
            continue;
        if (!any)
            rl_buffer_printf(
                page,
                "<p>The pictures were rendered by another build (commit %s, code %s) than these studies "
                "were measured with: %s",
                now->commit, now->code_hash, run->study);
        else
            rl_buffer_printf(page, ", %s", run->study);
        any = true;
    }
    rl_buffer_add(page, any ? ".</p>\n" : "");
}

/* The scene of the samples study; at the film's size, or after a quick run at that run's. */
static int add_gallery(struct rl_buffer *page, const struct rl_report_page *p)
{
    static const double rr[] = {30.0, 3.0};
    const struct rl_record *r = NULL;
    bool quick = false;
    for (size_t i = 0; i < rl_n_studies; i++)
        if (rl_studies[i] == rl_study_find("samples")) {
            r = rl_run_find(&p->data->run[i], NULL, "method=random samples=4");
            quick = strncmp(p->data->run[i].grid, rl_grid_name(RL_GRID_QUICK),
                            strlen(rl_grid_name(RL_GRID_QUICK))) == 0;
        }
    const char *path = r ? r->scene_path : "teapot-star";
    struct rl_scene scene = {0};
    int status = rl_study_scene_load(&scene, path, p->error);
    if (status != RL_OK)
        return status;
    struct rl_gallery gallery = {
        .scene_name = r ? r->scene : path,
        .scene = &scene,
        .width = r && quick ? (int)rl_parameter_number(r->parameters, "width") : scene.width,
        .height = r && quick ? (int)rl_parameter_number(r->parameters, "height") : scene.height,
        .tolerance = 1e-4,
        .rr = rr,
        .n_rr = sizeof rr / sizeof rr[0],
        .folder = p->options->folder};
    struct rl_bench bench;
    status = rl_bench_open(&bench, p->options->backend, p->options->threads, p->options->cache, p->progress,
                           p->error);
    if (status == RL_OK) {
        status = rl_gallery_make(page, &gallery, &bench, p->progress, p->error);
        note_other_build(page, p, &bench.provenance);
        rl_bench_close(&bench);
    }
    rl_scene_clear(&scene);
    return status;
}

/* A row each run; what measured it stands on its own page, and here where it is not the same for all. */
static void add_runs(struct rl_buffer *page, const struct rl_report_page *p)
{
    rl_buffer_add(
        page, "<h2 id=\"provenance\">Where the figures come from</h2>\n<div class=\"scroll "
              "wide\"><table><thead><tr><th>Study</th><th>Grid</th><th>Begun</th><th "
              "class=\"number\">Measured</th><th class=\"number\">Planned</th><th>Commit</th><th>Code</th>"
              "</tr></thead>\n<tbody>\n");
    for (size_t i = 0; i < rl_n_studies; i++) {
        const struct rl_run *run = &p->data->run[i];
        if (run->n_records == 0)
            continue;
        rl_buffer_printf(page, "<tr><td><a href=\"%s.html#reproduce\">%s</a></td><td>", run->study,
                         run->study);
        rl_html_text(page, run->grid);
        rl_buffer_printf(
            page,
            "</td><td>%s</td><td class=\"number\">%zu</td><td class=\"number\">%zu</td><td>%s%s</td>"
            "<td>%s</td></tr>\n",
            run->started, rl_run_count(run, RL_RECORD_OK), run->n_records, run->provenance.commit,
            run->provenance.dirty ? " with changes" : "", run->provenance.code_hash);
    }
    rl_buffer_add(
        page, "</tbody></table></div>\n<p>Each study's page has its scenes with their hashes, compiler and "
              "flags, CPU, renderer and system.</p>\n");
}

static void add_reproduction(struct rl_buffer *page, const struct rl_report_page *p)
{
    rl_buffer_add(
        page, "<h2 id=\"reproduce\">How to reproduce this report</h2>\n"
              "<p>From a clone of the sources, with all that was measured here:</p>\n<pre>make report</pre>\n"
              "<p>Or step by step, with scenes, grid and files of one's own (cases of a database that are "
              "done are not measured again):</p>\n<pre>");
    for (size_t i = 0; i < rl_n_studies; i++) {
        const struct rl_run *run = &p->data->run[i];
        if (run->n_records == 0)
            continue;
        char grid[RL_GRID_MAX + 4];
        rl_run_arguments(grid, sizeof grid, run);
        rl_buffer_printf(page, "roughlight study run %s --db results.db", run->study);
        rl_html_text(page, grid);
        rl_buffer_add(page, "\n");
    }
    rl_buffer_add(page, "roughlight study export --db results.db --format tsv -o tables\n"
                        "roughlight study report --db results.db -o report</pre>\n"
                        "<p>Raw frame times: <a href=\"frame_times.tsv\">frame_times.tsv</a>.</p>\n");
}

static int write_overview(const struct rl_report_page *p)
{
    struct rl_buffer page = {0};
    rl_html_begin(&page, "roughlight: report");
    rl_report_navigation(&page, p, rl_n_studies);
    add_opening(&page, p);
    add_summary(&page, p);
    int status = add_gallery(&page, p);
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++)
        if (p->data->run[i].n_records > 0)
            status = add_claims(&page, p, i);
    add_runs(&page, p);
    add_reproduction(&page, p);
    rl_html_end(&page);
    if (status == RL_OK)
        status = rl_report_write(p, &page, "index.html");
    rl_buffer_clear(&page);
    return status;
}

int rl_report_make(const struct rl_report_options *options, const struct rl_progress *progress,
                   struct rl_error *error)
{
    struct rl_report_data data;
    int status = rl_report_load(&data, options->database, error);
    if (status != RL_OK)
        return status;
    struct rl_report_page page = {.options = options, .data = &data, .progress = progress, .error = error};
    status = rl_report_export(&data, options->folder, RL_EXPORT_TSV, error);
    if (status == RL_OK)
        status = rl_report_export_raw(&data, options->folder, error);
    if (status == RL_OK)
        status = rl_report_draw(&page);
    if (status == RL_OK)
        status = rl_report_write_studies(&page);
    if (status == RL_OK)
        status = write_overview(&page);
    free(page.figure);
    free(page.plot);
    rl_report_clear(&data);
    return status;
}
