/* Claims as rows, and verdicts as HTML (see verdicts.h). */
#include "results/verdicts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "results/html.h"

const enum rl_verdict rl_verdict_order[4] = {RL_VERDICT_HOLDS, RL_VERDICT_HOLDS_UP_TO, RL_VERDICT_FAILS,
                                             RL_VERDICT_INCONCLUSIVE};

/* Each verdict has a mark of its own shape beside its colour: for print, and for readers who see colours differently. */
static const struct {
    const char *class, *mark;
} look[] = {
    [RL_VERDICT_INCONCLUSIVE] = {"inconclusive", "?"},
    [RL_VERDICT_HOLDS] = {"holds", "&#10003;"},     /* check mark */
    [RL_VERDICT_HOLDS_UP_TO] = {"upto", "&#9680;"}, /* circle, its left half black */
    [RL_VERDICT_FAILS] = {"fails", "&#10007;"},     /* ballot x */
};

void rl_verdict_badge(struct rl_buffer *page, enum rl_verdict verdict)
{
    rl_buffer_printf(page, "<span class=\"verdict %s\">%s %s</span>", look[verdict].class, look[verdict].mark,
                     rl_verdict_name(verdict));
}

void rl_verdict_badge_count(struct rl_buffer *page, enum rl_verdict verdict, size_t n)
{
    rl_buffer_printf(page, "<span class=\"verdict %s%s\" title=\"%s\">%s&nbsp;%zu</span>",
                     look[verdict].class, n ? "" : " zero", rl_verdict_name(verdict), look[verdict].mark, n);
}

static bool is_paper(const struct rl_claim *c)
{
    return strncmp(c->text, "paper: ", strlen("paper: ")) == 0;
}

struct rl_verdict_count rl_verdict_count(const struct rl_claims *claims, const char *study, char only)
{
    struct rl_verdict_count count = {0};
    for (size_t i = 0; i < claims->n; i++) {
        const struct rl_claim *c = &claims->claim[i];
        if ((study && strcmp(c->study, study) != 0) || (only && (only == 'p') != is_paper(c)))
            continue;
        count.n++;
        count.of[c->verdict]++;
    }
    return count;
}

/* The claim's own words: without whose it is, and without the scene. */
static void bare_text(char text[256], const struct rl_claim *c)
{
    const char *colon = strstr(c->text, ": ");
    bool marked = is_paper(c) || strncmp(c->text, "ours: ", strlen("ours: ")) == 0;
    char scene[80];
    snprintf(text, 256, "%s", marked ? colon + 2 : c->text);
    size_t length = strlen(text), end = (size_t)snprintf(scene, sizeof scene, " (%s)", c->scene);
    if (length > end && strcmp(text + length - end, scene) == 0)
        text[length - end] = '\0';
}

static struct rl_verdict_row *find_row(struct rl_verdict_rows *rows, const char *text, bool paper)
{
    for (size_t i = 0; i < rows->n; i++)
        if (rows->row[i].paper == paper && strcmp(rows->row[i].text, text) == 0)
            return &rows->row[i];
    return NULL;
}

/* A row's cells are as many as the study's claims: it can have no more. */
static int add_row(struct rl_verdict_rows *rows, const char *text, bool paper, size_t most)
{
    struct rl_verdict_row *row = &rows->row[rows->n];
    row->cell = calloc(most, sizeof *row->cell);
    rows->n++;
    if (!row->cell)
        return RL_ERR_SYSTEM;
    row->paper = paper;
    snprintf(row->text, sizeof row->text, "%s", text);
    return RL_OK;
}

/* The rows of the paper's claims or of ours. */
static int add_rows(struct rl_verdict_rows *rows, const struct rl_claims *claims, const char *study,
                    bool paper)
{
    size_t number = 0, most = rl_verdict_count(claims, study, 0).n;
    for (size_t i = 0; i < claims->n; i++) {
        const struct rl_claim *c = &claims->claim[i];
        if (strcmp(c->study, study) != 0)
            continue;
        number++;
        if (is_paper(c) != paper)
            continue;
        char text[256];
        bare_text(text, c);
        if (!find_row(rows, text, paper) && add_row(rows, text, paper, most) != RL_OK)
            return RL_ERR_SYSTEM;
        struct rl_verdict_row *row = find_row(rows, text, paper);
        row->cell[row->n++] = (struct rl_verdict_cell){c, number};
    }
    return RL_OK;
}

int rl_verdict_rows_make(struct rl_verdict_rows *rows, const struct rl_claims *claims, const char *study,
                         struct rl_error *error)
{
    *rows = (struct rl_verdict_rows){.row = calloc(claims->n + 1, sizeof *rows->row)};
    snprintf(rows->page, sizeof rows->page, "%.80s.html", study);
    if (!rows->row)
        return rl_fail_memory(error, "rows of claims");
    int status = add_rows(rows, claims, study, true);
    if (status == RL_OK)
        status = add_rows(rows, claims, study, false);
    if (status == RL_OK)
        return RL_OK;
    rl_verdict_rows_clear(rows);
    return rl_fail_memory(error, "rows of claims");
}

void rl_verdict_rows_clear(struct rl_verdict_rows *rows)
{
    for (size_t i = 0; i < rows->n; i++)
        free(rows->row[i].cell);
    free(rows->row);
    *rows = (struct rl_verdict_rows){0};
}

/* "0.0564" with its unit, then the interval on a line of its own. */
static void add_value(struct rl_buffer *page, const struct rl_claim *c, const char *href, size_t number)
{
    if (isnan(c->value) && !isnan(c->low)) { /* bounds alone */
        rl_buffer_printf(page, "<span class=\"interval\">[%.4g, %.4g]</span>", c->low, c->high);
        return;
    }
    if (isnan(c->value) || isinf(c->value)) {
        rl_html_element(page, "span", isnan(c->value) ? "not measured" : "more than was tried");
        return;
    }
    if (href)
        rl_buffer_printf(page, "<a class=\"value\" href=\"%s#claim-%zu\">%.4g</a>", href, number, c->value);
    else
        rl_buffer_printf(page, "<b class=\"value\">%.4g</b>", c->value);
    if (c->unit[0] && strcmp(c->unit, "1") != 0) {
        rl_buffer_add(page, " <span class=\"unit\">");
        rl_html_text(page, c->unit);
        rl_buffer_add(page, "</span>");
    }
    if (c->low < c->value || c->high > c->value)
        rl_buffer_printf(page, " <span class=\"interval\">[%.4g, %.4g]</span>", c->low, c->high);
}

/* Links to the rows of the tables below: the first digits of an identity tell cases of one study apart. */
static void add_cases(struct rl_buffer *page, const struct rl_claim *c)
{
    enum { SHOWN = 4 };
    if (c->n_cases == 0)
        return;
    rl_buffer_add(page, c->n_cases > SHOWN ? "<details class=\"cases\"><summary data-file=\"claims.tsv\">"
                                           : "<div class=\"cases\">");
    rl_buffer_printf(page, "%zu %s%s", c->n_cases, c->n_cases == 1 ? "case" : "cases",
                     c->n_cases > SHOWN ? "</summary>" : ":");
    for (size_t k = 0; k < c->n_cases; k++)
        rl_buffer_printf(page, " <a href=\"#case-%s\">%.8s</a>", c->identity[k], c->identity[k]);
    rl_buffer_add(page, c->n_cases > SHOWN ? "</details>" : "</div>");
}

/* Lines break between the words of a command, never at its hyphens. */
static void add_command(struct rl_buffer *page, const char *command)
{
    rl_buffer_add(page, "<code>");
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
    rl_buffer_add(page, "</code>");
}

static void add_commands(struct rl_buffer *page, const struct rl_verdict_row *row)
{
    if (row->command[0])
        add_command(page, row->command);
    for (size_t k = 0; k < row->n && !row->command[0]; k++)
        add_command(page, row->cell[k].claim->command);
}

/* The figure in small, a link to it in large. */
static void add_picture(struct rl_buffer *page, const struct rl_verdict_row *row, const char *href)
{
    if (!row->picture[0])
        return;
    rl_buffer_printf(
        page,
        "<a href=\"%s#%s\"><img class=\"small\" src=\"%s.small.png\" width=\"160\" height=\"110\" "
        "alt=\"figure %s\"></a>",
        href, row->anchor, row->picture, row->picture);
}

static void add_cell(struct rl_buffer *page, const struct rl_verdict_row *row, size_t k, const char *href)
{
    const struct rl_claim *c = row->cell[k].claim;
    rl_buffer_add(page, "<div class=\"cell\"");
    if (!href)
        rl_buffer_printf(page, " id=\"claim-%zu\"", row->cell[k].number);
    rl_buffer_add(page, ">");
    if (c->scene[0] && strcmp(c->scene, "none") != 0) {
        rl_buffer_add(page, "<span class=\"scene\">");
        rl_html_text(page, c->scene);
        rl_buffer_add(page, "</span>");
    }
    rl_verdict_badge(page, c->verdict);
    add_value(page, c, href, row->cell[k].number);
    if (c->size_px[0] || c->seeds[0]) {
        rl_buffer_add(page, "<span class=\"note\">");
        rl_buffer_printf(page, "%s%s%s%s", c->size_px, c->size_px[0] ? " px" : "",
                         c->size_px[0] && c->seeds[0] ? ", seeds: "
                         : c->seeds[0]                ? "seeds: "
                                                      : "",
                         c->seeds);
        rl_buffer_add(page, "</span>");
    }
    if (!href && c->note[0]) {
        rl_buffer_add(page, "<span class=\"note\">");
        rl_html_text(page, c->note);
        rl_buffer_add(page, "</span>");
    }
    if (!href)
        add_cases(page, c);
    rl_buffer_add(page, "</div>");
}

/* `href`: the study's page, or NULL on that page itself. */
static void add_table(struct rl_buffer *page, const struct rl_verdict_rows *rows, const char *href)
{
    rl_buffer_printf(page,
                     "<table class=\"claims%s\"><thead><tr><th>Claim, and what measures it</th>"
                     "<th>Verdict and value [95 %% interval]</th><th>Figure</th></tr></thead>\n<tbody>\n",
                     href ? "" : " full");
    for (size_t i = 0; i < rows->n; i++) {
        const struct rl_verdict_row *row = &rows->row[i];
        rl_buffer_printf(page, "<tr><td><span class=\"whose %s\">%s</span> ", row->paper ? "paper" : "ours",
                         row->paper ? "paper" : "ours");
        rl_html_text(page, row->text);
        add_commands(page, row);
        rl_buffer_add(page, "</td><td><div class=\"cells\">");
        for (size_t k = 0; k < row->n; k++)
            add_cell(page, row, k, href);
        rl_buffer_add(page, "</div></td><td>");
        add_picture(page, row, href ? href : "");
        rl_buffer_add(page, "</td></tr>\n");
    }
    rl_buffer_add(page, "</tbody></table>\n");
}

void rl_verdict_overview(struct rl_buffer *page, const struct rl_verdict_rows *rows)
{
    add_table(page, rows, rows->page);
}

void rl_verdict_details(struct rl_buffer *page, const struct rl_verdict_rows *rows)
{
    add_table(page, rows, NULL);
}
