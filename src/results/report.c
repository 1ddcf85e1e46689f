/* Verdicts, tables and provenance as HTML (see report.h). */
#include "results/report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *verdict_class(enum rl_verdict verdict)
{
    switch (verdict) {
    case RL_VERDICT_HOLDS:
        return "holds";
    case RL_VERDICT_HOLDS_UP_TO:
        return "upto";
    case RL_VERDICT_FAILS:
        return "fails";
    default:
        return "inconclusive";
    }
}

static void value_with_interval(struct rl_buffer *page, const struct rl_claim *c)
{
    char text[128];
    if (isnan(c->value))
        snprintf(text, sizeof text, "not measured");
    else if (isinf(c->value))
        snprintf(text, sizeof text, "more than was tried");
    else if (c->low < c->value || c->high > c->value)
        snprintf(text, sizeof text, "%.4g [%.4g, %.4g]", c->value, c->low, c->high);
    else
        snprintf(text, sizeof text, "%.4g", c->value);
    rl_html_text(page, text);
    if (isfinite(c->value) && c->unit[0] && strcmp(c->unit, "1") != 0) {
        rl_buffer_add(page, " ");
        rl_html_text(page, c->unit);
    }
}

/* Lines break between the words of a command, never at its hyphens. */
static void command_words(struct rl_buffer *page, const char *command)
{
    for (const char *at = command; *at;) {
        char word[256];
        size_t length = strcspn(at, " ");
        snprintf(word, sizeof word, "%.*s", (int)length, at);
        rl_buffer_add(page, "<span class=\"word\">");
        rl_html_text(page, word);
        rl_buffer_add(page, "</span>");
        at += length;
        size_t blanks = strspn(at, " ");
        rl_buffer_add(page, blanks ? " " : "");
        at += blanks;
    }
}

static void claim_row(struct rl_buffer *page, const struct rl_claim *c)
{
    rl_buffer_add(page, "<tr><td>");
    rl_html_text(page, c->text);
    rl_buffer_printf(page, "</td><td><span class=\"verdict %s\">%s</span></td><td>",
                     verdict_class(c->verdict), rl_verdict_name(c->verdict));
    value_with_interval(page, c);
    if (c->note[0]) {
        rl_buffer_add(page, "<span class=\"note\">");
        rl_html_text(page, c->note);
        rl_buffer_add(page, "</span>");
    }
    rl_buffer_add(page, "</td><td data-label=\"Study\"><a href=\"#");
    rl_html_text(page, c->study);
    rl_buffer_add(page, "\">");
    rl_html_text(page, c->study);
    rl_buffer_add(page, "</a></td><td data-label=\"Command\"><code>");
    command_words(page, c->command);
    rl_buffer_add(page, "</code></td></tr>\n");
}

void rl_report_claims(struct rl_buffer *page, const struct rl_claims *claims)
{
    rl_buffer_add(
        page,
        "<table class=\"claims\"><thead><tr><th>Claim</th><th>Verdict</th><th>Value [95 % interval]</th>"
        "<th>Study</th><th>Command</th></tr></thead>\n<tbody>\n");
    for (size_t i = 0; i < claims->n; i++)
        claim_row(page, &claims->claim[i]);
    rl_buffer_add(page, "</tbody></table>\n");
}

void rl_report_count(char text[], size_t size, const struct rl_claims *claims)
{
    size_t n[4] = {0};
    for (size_t i = 0; i < claims->n; i++)
        n[claims->claim[i].verdict]++;
    snprintf(text, size,
             "Of %zu claims, %zu hold, %zu hold up to a point, %zu fail and %zu are inconclusive.", claims->n,
             n[RL_VERDICT_HOLDS], n[RL_VERDICT_HOLDS_UP_TO], n[RL_VERDICT_FAILS], n[RL_VERDICT_INCONCLUSIVE]);
}

void rl_report_table(struct rl_buffer *page, const struct rl_table *table, const struct rl_run *run,
                     const char *file)
{
    rl_buffer_add(page, "<details><summary>");
    rl_html_text(page, table->summary);
    rl_buffer_add(page, "</summary>\n<p><a href=\"");
    rl_html_text(page, file);
    rl_buffer_add(page, "\">");
    rl_html_text(page, file);
    rl_buffer_add(page, "</a></p>\n<div class=\"scroll\"><table class=\"data\"><thead><tr>");
    for (size_t i = 0; i < table->n_columns; i++)
        rl_html_element(page, "th", table->column[i].name);
    rl_buffer_add(page, "</tr></thead>\n<tbody>\n");
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, NULL, table->pattern));) {
        rl_buffer_add(page, "<tr>");
        for (size_t i = 0; i < table->n_columns; i++) {
            char text[RL_NAME_MAX];
            rl_column_text(text, sizeof text, &table->column[i], r);
            rl_html_element(page, "td", text);
        }
        rl_buffer_add(page, "</tr>\n");
    }
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
