/* Tables and provenance as HTML (see report.h). */
#include "results/report.h"

#include <stdio.h>
#include <string.h>

/* A case may be in several tables; its anchor is in the first. */
static bool shown_before(const struct rl_table *tables, size_t t, const struct rl_record *r)
{
    for (size_t i = 0; i < t; i++)
        if (rl_parameters_match(r->parameters, tables[i].pattern))
            return true;
    return false;
}

/* Opens a row of a case, with its anchor if it is to have one. */
static void begin_case(struct rl_buffer *page, const struct rl_record *r, bool anchor)
{
    if (anchor && r->identity[0]) /* what follows from several cases has none */
        rl_buffer_printf(page, "<tr id=\"case-%s\">", r->identity);
    else
        rl_buffer_add(page, "<tr>");
}

static size_t count_rows(const struct rl_table *table, const struct rl_run *run)
{
    size_t n = 0;
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, NULL, table->pattern));)
        n++;
    return n;
}

/* A table that fits the window is shown at once, a longer one when it is asked for. */
static void begin_table(struct rl_buffer *page, const struct rl_table *table, size_t n_rows, const char *file)
{
    enum { SHORT = 16 };
    rl_buffer_printf(page, "<details%s><summary data-file=\"", n_rows <= SHORT ? " open" : "");
    rl_html_text(page, file);
    rl_buffer_add(page, "\">");
    rl_html_text(page, table->summary);
    rl_buffer_printf(page, " (%zu rows)</summary>\n<p><a href=\"", n_rows);
    rl_html_text(page, file);
    rl_buffer_add(page, "\">");
    rl_html_text(page, file);
    rl_buffer_add(page, "</a></p>\n<div class=\"scroll\"><table class=\"data\"><thead><tr>");
    for (size_t i = 0; i < table->n_columns; i++)
        rl_html_element(page, "th", table->column[i].name);
    rl_buffer_printf(page, "<th>%s</th></tr></thead>\n<tbody>\n", rl_identity_column);
}

void rl_report_table(struct rl_buffer *page, const struct rl_table *tables, size_t t,
                     const struct rl_run *run, const char *file)
{
    const struct rl_table *table = &tables[t];
    begin_table(page, table, count_rows(table, run), file);
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, NULL, table->pattern));) {
        begin_case(page, r, !shown_before(tables, t, r));
        for (size_t i = 0; i < table->n_columns; i++) {
            char text[RL_COLUMN_TEXT_MAX];
            rl_column_text(text, sizeof text, &table->column[i], r);
            rl_html_element(page, "td", text);
        }
        rl_buffer_printf(page, "<td>%s</td></tr>\n", r->identity);
    }
    rl_buffer_add(page, "</tbody></table></div></details>\n");
}

void rl_report_other_cases(struct rl_buffer *page, const struct rl_table *tables, size_t n,
                           const struct rl_run *run)
{
    bool begun = false;
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, NULL, ""));) {
        if (shown_before(tables, n, r))
            continue;
        if (!begun)
            rl_buffer_add(page,
                          "<details><summary>Cases that are in no table</summary>\n<div class=\"scroll\">"
                          "<table class=\"data\"><tbody>\n");
        begun = true;
        begin_case(page, r, true);
        rl_html_element(page, "td", r->scene);
        rl_html_element(page, "td", r->parameters);
        rl_buffer_printf(page, "<td>%s</td></tr>\n", r->identity);
    }
    if (begun)
        rl_buffer_add(page, "</tbody></table></div></details>\n");
}

static void pair(struct rl_buffer *page, const char *name, const char *value)
{
    rl_buffer_add(page, "<tr>");
    rl_html_element(page, "th", name);
    rl_html_element(page, "td", value);
    rl_buffer_add(page, "</tr>\n");
}

/* The runs' scenes, each once. */
static void scene_pairs(struct rl_buffer *page, const struct rl_run *run)
{
    char text[256];
    const char *last = "";
    for (size_t i = 0; i < run->n_records; i++) {
        const struct rl_record *r = &run->record[i];
        if (r->scene_path[0] == '\0' || strcmp(r->scene_hash, last) == 0) /* "": without a scene */
            continue;
        last = r->scene_hash;
        snprintf(text, sizeof text, "%.180s, hash %s", r->scene_path, r->scene_hash);
        pair(page, "scene", text);
    }
}

void rl_report_provenance(struct rl_buffer *page, const struct rl_run *run, const struct rl_run *before)
{
    const struct rl_provenance *p = &run->provenance;
    char text[RL_GRID_MAX + 256], environment[RL_HASH_TEXT], same[RL_HASH_TEXT] = "";
    rl_provenance_environment(p, environment);
    if (before)
        rl_provenance_environment(&before->provenance, same);
    rl_buffer_add(page, "<table>\n");
    snprintf(text, sizeof text, "%s, grid %s, begun %s", run->study, run->grid, run->started);
    pair(page, "study", text);
    scene_pairs(page, run);
    if (strcmp(environment, same) == 0) {
        pair(page, "environment", "the same as above");
    } else {
        snprintf(text, sizeof text, "roughlight %s, commit %s%s, code %s", p->version, p->commit,
                 p->dirty ? " with changes" : "", p->code_hash);
        pair(page, "program", text);
        pair(page, "compiler", p->compiler);
        pair(page, "flags", p->cflags);
        snprintf(text, sizeof text, "%s, %d threads", p->cpu, p->threads);
        pair(page, "CPU", text);
        snprintf(text, sizeof text, "%s: %s", p->backend, p->renderer);
        pair(page, "renderer", text);
        pair(page, "OpenGL", p->gl_version);
        pair(page, "system", p->os);
    }
    rl_buffer_add(page, "</table>\n");
}

void rl_report_missing(struct rl_buffer *page, const struct rl_run *run)
{
    size_t planned = rl_run_count(run, RL_RECORD_PLANNED);
    if (planned > 0) {
        char text[160];
        snprintf(text, sizeof text,
                 "%zu of %zu cases are not measured yet: run the study again to complete them.", planned,
                 run->n_records);
        rl_html_element(page, "p", text);
    }
    if (rl_run_count(run, RL_RECORD_FAILED) == 0)
        return;
    rl_buffer_add(page, "<p>Cases that failed:</p>\n<ul>\n");
    for (size_t i = 0; i < run->n_records; i++) {
        const struct rl_record *r = &run->record[i];
        if (r->status != RL_RECORD_FAILED)
            continue;
        rl_buffer_add(page, "<li>");
        rl_html_text(page, r->scene);
        rl_buffer_add(page, " ");
        rl_html_text(page, r->parameters);
        rl_buffer_add(page, ": ");
        rl_html_text(page, r->message);
        rl_buffer_add(page, "</li>\n");
    }
    rl_buffer_add(page, "</ul>\n");
}
