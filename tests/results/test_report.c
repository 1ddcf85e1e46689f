/* HTML: whatever a scene or a message is called, the page stays whole. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "results/html.h"
#include "results/report.h"
#include "results/verdicts.h"

static const char hostile[] = "<script>alert(\"a\")</script> & 'b'";
static const char escaped[] = "&lt;script&gt;alert(&quot;a&quot;)&lt;/script&gt; &amp; &#39;b&#39;";

static void test_escaping(void **state)
{
    (void)state;
    struct rl_buffer page = {0};
    rl_html_text(&page, hostile);
    assert_string_equal(page.data, escaped);
    rl_buffer_clear(&page);
    rl_html_element(&page, "p", "RMSE < 1/255");
    assert_string_equal(page.data, "<p>RMSE &lt; 1/255</p>\n");
    rl_buffer_clear(&page);
}

static size_t count(const char *text, const char *word)
{
    size_t n = 0;
    for (; (text = strstr(text, word)); text++)
        n++;
    return n;
}

static size_t count_claims(const struct rl_buffer *page)
{
    return count(page->data, "<div class=\"cell\"");
}

/* A claim of a study about a scene, with two cases. */
static struct rl_claim *add_claim(struct rl_claims *claims, const char *study, const char *scene,
                                  const char *text)
{
    struct rl_claim *c = rl_claims_add(claims, NULL);
    assert_non_null(c);
    snprintf(c->text, sizeof c->text, "%s", text);
    snprintf(c->study, sizeof c->study, "%s", study);
    snprintf(c->scene, sizeof c->scene, "%s", scene);
    c->identity = malloc(2 * sizeof *c->identity); /* rl_claims_clear frees it */
    assert_non_null(c->identity);
    rl_hash_text(c->identity[0], claims->n);
    rl_hash_text(c->identity[1], 0xabcd000000000000 + claims->n);
    c->n_cases = 2;
    return c;
}

/* Every text that a database or a scene file can bring in, hostile. */
static void test_page(void **state)
{
    (void)state;
    static const struct rl_column column[] = {{hostile, RL_COLUMN_SCENE, NULL},
                                              {"value", RL_COLUMN_TEXT, "key"}};
    const struct rl_table table = {"t", hostile, "", column, 2};
    struct rl_place place = {"samples", hostile, hostile, 1};
    struct rl_run run = {.study = "samples", .grid = "quick"};
    rl_run_add(&run, &place, 0, NULL, "key=<script>")->status = RL_RECORD_OK;
    struct rl_record *r = rl_run_add(&run, &place, 0, NULL, "key=<script>x");
    r->status = RL_RECORD_FAILED;
    snprintf(r->message, sizeof r->message, "%s", hostile);
    snprintf(run.provenance.renderer, sizeof run.provenance.renderer, "%s", hostile);
    struct rl_claims claims = {0};
    struct rl_claim *c = add_claim(&claims, "samples", hostile, hostile);
    snprintf(c->note, sizeof c->note, "%s", hostile);
    snprintf(c->command, sizeof c->command, "%s", hostile);
    rl_claim_value(c, 1.0, 0.5, 2.0, hostile);
    struct rl_verdict_rows rows;
    assert_int_equal(rl_verdict_rows_make(&rows, &claims, "samples", NULL), RL_OK);

    struct rl_buffer page = {0};
    const struct rl_html_link links[] = {{hostile, hostile}, {NULL, NULL}};
    rl_html_begin(&page, hostile);
    rl_verdict_overview(&page, &rows);
    rl_verdict_details(&page, &rows);
    rl_report_table(&page, &table, 0, &run, hostile);
    rl_report_other_cases(&page, &table, 0, &run);
    rl_report_provenance(&page, &run, NULL);
    rl_report_missing(&page, &run);
    rl_html_figure(&page, hostile, hostile, hostile, links);
    rl_html_end(&page);
    assert_int_equal(rl_buffer_check(&page, NULL), RL_OK);
    assert_int_equal(count(page.data, "<script"), 0);
    assert_true(count(page.data, escaped) >= 16);
    static const char *const tag[] = {"table",   "td",   "tr",     "div", "span",
                                      "details", "code", "figure", "p",   "a"};
    for (size_t i = 0; i < sizeof tag / sizeof tag[0]; i++) {
        char open[2][16], close[16];
        snprintf(open[0], sizeof open[0], "<%s>", tag[i]);
        snprintf(open[1], sizeof open[1], "<%s ", tag[i]);
        snprintf(close, sizeof close, "</%s>", tag[i]);
        assert_int_equal(count(page.data, open[0]) + count(page.data, open[1]), count(page.data, close));
    }
    rl_buffer_clear(&page);
    rl_verdict_rows_clear(&rows);
    rl_claims_clear(&claims);
    rl_run_clear(&run);
}

static void test_names(void **state)
{
    (void)state;
    static const struct {
        const char *text, *name;
    } row[] = {
        {"teapot-star", "teapot-star"},
        {"a b", "a_20b"},
        {"50%#1?", "50_25_231_3f"},
        {"../x", ".._2fx"},
        {"", ""},
        {"\xc3\xa9\"", "_c3_a9_22"},
    };
    char name[32];
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        rl_html_name(name, sizeof name, row[i].text);
        assert_string_equal(name, row[i].name);
    }
    rl_html_name(name, 8, "    long");
    assert_string_equal(name, "_20_20"); /* whole, or not at all */
}

static void test_values(void **state)
{
    (void)state;
    static const struct {
        double value, low, high;
        const char *unit, *expected;
    } row[] = {
        {1.36, 1.25, 1.5, "1", ">1.36</b> <span class=\"interval\">[1.25, 1.5]</span>"},
        {1.36, 1.25, 1.5, "ms",
         ">1.36</b> <span class=\"unit\">ms</span> <span class=\"interval\">[1.25, 1.5]</span>"},
        {30, 30, 30, "R_r", ">30</b> <span class=\"unit\">R_r</span></div>"},
        {30, 30, INFINITY, "1", ">30</b> <span class=\"interval\">[30, inf]</span>"},
        {INFINITY, 30, INFINITY, "1", ">more than was tried</span>"},
        {NAN, NAN, NAN, "1", ">not measured</span>"},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_claims claims = {0};
        struct rl_claim *c = rl_claims_add(&claims, NULL);
        rl_claim_value(c, row[i].value, row[i].low, row[i].high, row[i].unit);
        struct rl_verdict_rows rows;
        assert_int_equal(rl_verdict_rows_make(&rows, &claims, "", NULL), RL_OK);
        struct rl_buffer page = {0};
        rl_verdict_details(&page, &rows);
        if (!strstr(page.data, row[i].expected))
            fail_msg("'%s' is not in: %s", row[i].expected, page.data);
        rl_buffer_clear(&page);
        rl_verdict_rows_clear(&rows);
        rl_claims_clear(&claims);
    }
}

/* A claim about two scenes is one row of two cells; the paper's come first; numbers are those among the study's claims. */
static void test_rows(void **state)
{
    (void)state;
    struct rl_claims claims = {0};
    add_claim(&claims, "samples", "one", "ours: it is fast (one)");
    add_claim(&claims, "samples", "one", "paper: it is fast (one)");
    add_claim(&claims, "fps", "one", "ours: it is fast (one)");
    add_claim(&claims, "samples", "two", "ours: it is fast (two)");
    add_claim(&claims, "samples", "none", "ours: nothing (one)");
    struct rl_verdict_rows rows;
    assert_int_equal(rl_verdict_rows_make(&rows, &claims, "samples", NULL), RL_OK);
    assert_string_equal(rows.page, "samples.html");
    assert_int_equal(rows.n, 3);
    assert_true(rows.row[0].paper && !rows.row[1].paper && !rows.row[2].paper);
    assert_string_equal(rows.row[0].text, "it is fast");
    assert_string_equal(rows.row[1].text, "it is fast");
    assert_string_equal(rows.row[2].text, "nothing (one)"); /* not its own scene */
    assert_int_equal(rows.row[0].n, 1);
    assert_int_equal(rows.row[0].cell[0].number, 2);
    assert_int_equal(rows.row[1].n, 2);
    assert_int_equal(rows.row[1].cell[0].number, 1);
    assert_int_equal(rows.row[1].cell[1].number, 3);
    assert_string_equal(rows.row[1].cell[1].claim->scene, "two");
    snprintf(rows.row[1].picture, sizeof rows.row[1].picture, "samples-error-one");
    snprintf(rows.row[1].anchor, sizeof rows.row[1].anchor, "figure-error-one");
    rl_claim_value(&claims.claim[3], 2.0, 2.0, 2.0, "1");

    struct rl_buffer page = {0};
    rl_verdict_overview(&page, &rows);
    assert_int_equal(count_claims(&page), 4);
    assert_int_equal(count(page.data, "samples-error-one.small.png"), 1);
    assert_int_equal(count(page.data, "href=\"samples.html#figure-error-one\""), 1);
    assert_int_equal(count(page.data, "href=\"samples.html#claim-3\""), 1);
    assert_int_equal(count(page.data, "#case-"), 0);
    rl_buffer_clear(&page);
    rl_verdict_details(&page, &rows);
    assert_int_equal(count(page.data, "id=\"claim-"), 4);
    assert_int_equal(count(page.data, "href=\"#case-"), 8);
    assert_int_equal(count(page.data, "href=\"#case-abcd000000000004\">abcd0000</a>"), 1);
    rl_buffer_clear(&page);
    rl_verdict_rows_clear(&rows);
    rl_claims_clear(&claims);
}

/* Two tables with a case in common: one anchor each case, and none is left out. */
static void test_anchors(void **state)
{
    (void)state;
    static const struct rl_column column[] = {{"value", RL_COLUMN_TEXT, "key"}};
    const struct rl_table table[] = {{"t", "odd", "odd=1", column, 1}, {"u", "small", "small=1", column, 1}};
    struct rl_place place = {"samples", "one", "one", 1};
    struct rl_run run = {.study = "samples"};
    for (int i = 0; i < 8; i++)
        rl_run_add(&run, &place, 0, NULL, "key=%d odd=%d small=%d", i, i % 2, i < 4)->status = RL_RECORD_OK;
    rl_run_identify(&run, "here");
    struct rl_buffer page = {0};
    rl_report_table(&page, table, 0, &run, "t.tsv");
    rl_report_table(&page, table, 1, &run, "u.tsv");
    rl_report_other_cases(&page, table, 2, &run);
    for (size_t i = 0; i < run.n_records; i++) {
        char anchor[64];
        snprintf(anchor, sizeof anchor, "id=\"case-%s\"", run.record[i].identity);
        assert_int_equal(count(page.data, anchor), 1);
    }
    assert_int_equal(count(page.data, "<tr"), 2 + 4 + 4 + 2);
    rl_buffer_clear(&page);
    rl_run_clear(&run);
}

/* A list that is closed on the screen is closed on paper: there its summary names the file that has it all. */
static void test_print(void **state)
{
    (void)state;
    struct rl_claims claims = {0};
    struct rl_claim *c = add_claim(&claims, "samples", "one", "ours: x");
    free(c->identity);
    c->n_cases = 5;
    c->identity = calloc(c->n_cases, sizeof *c->identity);
    assert_non_null(c->identity);
    struct rl_verdict_rows rows;
    assert_int_equal(rl_verdict_rows_make(&rows, &claims, "samples", NULL), RL_OK);
    struct rl_buffer page = {0};
    rl_html_begin(&page, "x");
    rl_verdict_details(&page, &rows);
    assert_non_null(strstr(page.data, "<details class=\"cases\"><summary data-file=\"claims.tsv\">5 cases"));
    const char *print = strstr(page.data, "@media print{");
    assert_non_null(print);
    assert_non_null(
        strstr(print, "details:not([open])>summary[data-file]::after{content:\", in \" attr(data-file)}"));
    rl_buffer_clear(&page);
    rl_verdict_rows_clear(&rows);
    rl_claims_clear(&claims);

    static const struct rl_column column[] = {{"scene", RL_COLUMN_SCENE, NULL}};
    const struct rl_table table = {"t", "what it holds", "", column, 1};
    struct rl_place place = {"samples", "one", "one.yaml", 1};
    struct rl_run run = {.study = "samples"};
    for (int i = 0; i < 17; i++)
        rl_run_add(&run, &place, 0, NULL, "i=%d", i)->status = RL_RECORD_OK;
    rl_report_table(&page, &table, 0, &run, "t.tsv");
    assert_non_null(strstr(page.data, "<details><summary data-file=\"t.tsv\">what it holds (17 rows)"));
    rl_buffer_clear(&page);
    rl_run_clear(&run);
}

static void test_count(void **state)
{
    (void)state;
    struct rl_claims claims = {0};
    add_claim(&claims, "a", "one", "ours: x")->verdict = RL_VERDICT_HOLDS;
    add_claim(&claims, "a", "one", "paper: y")->verdict = RL_VERDICT_FAILS;
    add_claim(&claims, "b", "one", "paper: z")->verdict = RL_VERDICT_FAILS;
    static const struct {
        const char *study;
        char only;
        size_t n, holds, fails;
    } row[] = {
        {NULL, 0, 3, 1, 2}, {"a", 0, 2, 1, 1}, {"a", 'p', 1, 0, 1}, {NULL, 'o', 1, 1, 0}, {"c", 0, 0, 0, 0}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_verdict_count c = rl_verdict_count(&claims, row[i].study, row[i].only);
        assert_int_equal(c.n, row[i].n);
        assert_int_equal(c.of[RL_VERDICT_HOLDS], row[i].holds);
        assert_int_equal(c.of[RL_VERDICT_FAILS], row[i].fails);
    }
    rl_claims_clear(&claims);
}

/* Whoever sees no colours, or prints: the four verdicts differ in mark and in word. */
static void test_badges(void **state)
{
    (void)state;
    struct rl_buffer page[4] = {{0}};
    for (int i = 0; i < 4; i++)
        rl_verdict_badge(&page[i], rl_verdict_order[i]);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < i; k++)
            assert_string_not_equal(strchr(page[i].data, '>'), strchr(page[k].data, '>'));
    for (int i = 0; i < 4; i++)
        rl_buffer_clear(&page[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_escaping), cmocka_unit_test(test_page),  cmocka_unit_test(test_names),
        cmocka_unit_test(test_values),   cmocka_unit_test(test_rows),  cmocka_unit_test(test_anchors),
        cmocka_unit_test(test_print),    cmocka_unit_test(test_count), cmocka_unit_test(test_badges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
