/* Puts the page together: verdicts, pictures, each study's plots and tables, provenance, how to reproduce (see report.h). */
#include "studies/report.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "results/html.h"
#include "results/plot.h"
#include "results/report.h"
#include "studies/gallery.h"
#include "studies/planner.h"
#include "studies/study.h"

/* The page at work. */
struct page {
    const struct rl_report_options *options;
    const struct rl_report_data *data;
    const struct rl_progress *progress;
    struct rl_error *error;
    struct rl_buffer text;
    size_t plots_done, plots_total;
};

/* The figures of a scene, or of the cases without one. */
static const struct rl_figure *figures_of(const struct rl_study *study, const char *scene, size_t *n)
{
    bool alone = strcmp(scene, RL_NO_SCENE) == 0;
    *n = alone ? study->n_figures_alone : study->n_figures;
    return alone ? study->figures_alone : study->figures;
}

static size_t count_plots(const struct rl_study *study, const struct rl_run *run)
{
    size_t total = 0, n;
    for (size_t i = 0; rl_run_scene(run, i); i++, total += n)
        figures_of(study, rl_run_scene(run, i), &n);
    return total;
}

static bool measured(const struct rl_run *run)
{
    return rl_run_count(run, RL_RECORD_OK) > 0;
}

/* What was measured where, in a sentence or two. */
static void add_opening(struct page *p)
{
    char text[512];
    const struct rl_provenance *where = NULL;
    for (size_t i = 0; i < rl_n_studies; i++)
        if (measured(&p->data->run[i]))
            where = &p->data->run[i].provenance;
    rl_html_element(&p->text, "h1",
                    "Highlights of shaped lights on rough surfaces: what the method gains and what it loses");
    rl_report_count(text, sizeof text, &p->data->claims);
    rl_buffer_add(&p->text, "<p class=\"lead\">");
    rl_html_text(&p->text, "Kimura and Tokoi draw highlights that show the shape of a polygon light, blurred "
                           "by surface roughness, "
                           "nearly in real time. This page holds their claims against measurements. ");
    rl_html_text(&p->text, text);
    rl_buffer_add(&p->text, "</p>\n");
    if (where) {
        snprintf(text, sizeof text,
                 "Measured on %.100s with %d threads; renderer %.100s (%.30s): speeds are this renderer's, "
                 "and no verdict on the paper's own machine. Every interval is one of 95 %%: of errors and "
                 "times over seeds and frames.",
                 where->cpu, where->threads, where->renderer, where->backend);
        rl_html_element(&p->text, "p", text);
    }
}

static void add_verdicts(struct page *p)
{
    rl_buffer_add(
        &p->text,
        "<h2 id=\"verdicts\">Verdicts</h2>\n<p>Claims marked <em>paper</em> are stated or implied by Kimura "
        "and Tokoi; those marked <em>ours</em> follow from their method. Each verdict is computed from the "
        "figures below; the command is what measured it (cases of a database that are done are not measured "
        "again). <a href=\"claims.tsv\">claims.tsv</a> holds the "
        "table.</p>\n");
    rl_report_claims(&p->text, &p->data->claims);
}

/* In place of a figure that has nothing to draw: why. */
static int add_missing_plot(struct page *p, const struct rl_figure *figure, const char *path)
{
    char text[1200];
    snprintf(text, sizeof text, "Figure %s: %.1000s", figure->name, p->error->message);
    rl_html_element(&p->text, "p", text);
    remove(path); /* an empty picture, if gnuplot left one */
    rl_progress_update(p->progress, "plots", ++p->plots_done, p->plots_total);
    return RL_OK;
}

/* One figure of one scene as SVG and PNG. */
static int plot(struct page *p, const struct rl_study *study, const struct rl_figure *figure,
                const char *scene)
{
    static const char *const ending[] = {"svg", "png"};
    char script[80], file[2][256], path[PATH_MAX];
    snprintf(script, sizeof script, "%s.gp", study->name);
    for (int k = 0; k < 2; k++) {
        snprintf(file[k], sizeof file[k], "%s-%s-%.100s.%s", study->name, figure->name, scene, ending[k]);
        snprintf(path, sizeof path, "%s/%s", p->options->folder, file[k]);
        const char *arguments[] = {p->options->folder, path, figure->name, scene, NULL};
        int status = rl_plot(script, arguments, p->error);
        /* Ctrl-C on a terminal ends gnuplot as well: that is no fault of the figure. */
        if (rl_progress_cancelled(p->progress))
            return rl_fail(p->error, RL_ERR_CANCELLED, "interrupted while the plots were drawn");
        if (status == RL_ERR_CHECK) /* one scene without a highlight, say, does not cost the page */
            return add_missing_plot(p, figure, path);
        if (status != RL_OK)
            return status;
    }
    const struct rl_html_link links[] = {{"SVG", file[0]}, {"PNG", file[1]}, {NULL, NULL}};
    rl_html_figure(&p->text, file[0], figure->caption, figure->caption, links);
    rl_progress_update(p->progress, "plots", ++p->plots_done, p->plots_total);
    return RL_OK;
}

static int add_figures(struct page *p, const struct rl_study *study, const char *scene)
{
    size_t n;
    const struct rl_figure *figure = figures_of(study, scene, &n);
    int status = RL_OK;
    rl_html_element(&p->text, "h3", strcmp(scene, RL_NO_SCENE) == 0 ? "without a scene" : scene);
    rl_buffer_add(&p->text, "<div class=\"plots\">\n");
    for (size_t f = 0; f < n && status == RL_OK; f++) {
        if (rl_progress_cancelled(p->progress))
            return rl_fail(p->error, RL_ERR_CANCELLED, "interrupted while the plots were drawn");
        status = plot(p, study, &figure[f], scene);
    }
    rl_buffer_add(&p->text, "</div>\n");
    return status;
}

static int add_study(struct page *p, const struct rl_study *study, const struct rl_run *run)
{
    rl_buffer_printf(&p->text, "<h2 id=\"%s\">Study %s</h2>\n", study->name, study->name);
    rl_html_element(&p->text, "p", study->text);
    rl_report_missing(&p->text, run);
    if (!measured(run))
        return RL_OK;
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++)
        status = add_figures(p, study, scene);
    for (size_t t = 0; t < study->n_tables && status == RL_OK; t++) {
        char file[128];
        snprintf(file, sizeof file, "%s.tsv", study->tables[t].name);
        rl_report_table(&p->text, &study->tables[t], run, file);
    }
    return status;
}

/* The pictures are this program's; figures may be older. */
static void note_other_build(struct page *p, const struct rl_provenance *now)
{
    for (size_t i = 0; i < rl_n_studies; i++) {
        const struct rl_run *run = &p->data->run[i];
        if (run->n_records == 0 || strcmp(run->provenance.code_hash, now->code_hash) == 0)
            continue;
        char text[256];
        snprintf(text, sizeof text,
                 "The pictures were rendered by another build (commit %s, code %s) than study %.40s was "
                 "measured with.",
                 now->commit, now->code_hash, run->study);
        rl_html_element(&p->text, "p", text);
    }
}

/* The scene of the samples study; at the film's size, or after a quick run at that run's. */
static int add_gallery(struct page *p)
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
        status = rl_gallery_make(&p->text, &gallery, &bench, p->progress, p->error);
        note_other_build(p, &bench.provenance);
        rl_bench_close(&bench);
    }
    rl_scene_clear(&scene);
    return status;
}

static void add_provenance(struct page *p)
{
    rl_buffer_add(&p->text, "<h2 id=\"provenance\">Where the figures come from</h2>\n");
    const struct rl_run *before = NULL;
    for (size_t i = 0; i < rl_n_studies; i++) {
        if (p->data->run[i].n_records == 0)
            continue;
        rl_report_provenance(&p->text, &p->data->run[i], before);
        before = &p->data->run[i];
    }
    rl_buffer_add(
        &p->text,
        "<h2 id=\"reproduce\">How to reproduce this page</h2>\n"
        "<p>From a clone of the sources, with all that was measured here:</p>\n<pre>make report</pre>\n"
        "<p>Or step by step, with scenes, grid and files of one's own:</p>\n<pre>");
    for (size_t i = 0; i < rl_n_studies; i++) {
        const struct rl_run *run = &p->data->run[i];
        if (run->n_records == 0)
            continue;
        char grid[RL_GRID_MAX + 4];
        rl_run_arguments(grid, sizeof grid, run);
        rl_buffer_printf(&p->text, "roughlight study run %s --db results.db%s\n", run->study, grid);
    }
    rl_buffer_add(&p->text, "roughlight study export --db results.db --format tsv -o tables\n"
                            "roughlight study report --db results.db -o report</pre>\n"
                            "<p>Raw frame times: <a href=\"frame_times.tsv\">frame_times.tsv</a>.</p>\n");
}

static int build(struct page *p)
{
    rl_html_begin(&p->text, "roughlight: report");
    add_opening(p);
    add_verdicts(p);
    int status = add_gallery(p);
    for (size_t i = 0; i < rl_n_studies; i++)
        p->plots_total += measured(&p->data->run[i]) ? count_plots(rl_studies[i], &p->data->run[i]) : 0;
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++)
        if (p->data->run[i].n_records > 0)
            status = add_study(p, rl_studies[i], &p->data->run[i]);
    if (status != RL_OK)
        return status;
    add_provenance(p);
    rl_html_end(&p->text);
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/index.html", p->options->folder);
    return rl_buffer_write(&p->text, path, p->error);
}

int rl_report_make(const struct rl_report_options *options, const struct rl_progress *progress,
                   struct rl_error *error)
{
    struct rl_report_data data;
    int status = rl_report_load(&data, options->database, error);
    if (status != RL_OK)
        return status;
    struct page page = {.options = options, .data = &data, .progress = progress, .error = error};
    status = rl_report_export(&data, options->folder, RL_EXPORT_TSV, error);
    if (status == RL_OK)
        status = build(&page);
    rl_buffer_clear(&page.text);
    rl_report_clear(&data);
    return status;
}
