/* HTML: whatever a scene or a message is called, the page stays whole. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "results/html.h"
#include "results/report.h"

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
    struct rl_claim *c = rl_claims_add(&claims, NULL);
    snprintf(c->text, sizeof c->text, "%s", hostile);
    snprintf(c->note, sizeof c->note, "%s", hostile);
    snprintf(c->unit, sizeof c->unit, "%s", hostile);
    snprintf(c->study, sizeof c->study, "%s", hostile);
    snprintf(c->command, sizeof c->command, "%s", hostile);
    rl_claim_value(c, 1.0, 0.5, 2.0, hostile);

    struct rl_buffer page = {0};
    const struct rl_html_link links[] = {{hostile, hostile}, {NULL, NULL}};
    rl_html_begin(&page, hostile);
    rl_report_claims(&page, &claims);
    rl_report_table(&page, &table, &run, hostile);
    rl_report_provenance(&page, &run, NULL);
    rl_report_missing(&page, &run);
    rl_html_figure(&page, hostile, hostile, hostile, links);
    rl_html_end(&page);
    assert_int_equal(rl_buffer_check(&page, NULL), RL_OK);
    assert_int_equal(count(page.data, "<script"), 0);
    assert_true(count(page.data, escaped) >= 12);
    assert_int_equal(count(page.data, "<table"), count(page.data, "</table>"));
    assert_int_equal(count(page.data, "<td"), count(page.data, "</td>"));
    rl_buffer_clear(&page);
    rl_claims_clear(&claims);
    rl_run_clear(&run);
}

static void test_values(void **state)
{
    (void)state;
    static const struct {
        double value, low, high;
        const char *unit, *expected;
    } row[] = {
        {1.36, 1.25, 1.5, "1", ">1.36 [1.25, 1.5]</td>"},
        {30, 30, 30, "R_r", ">30 R_r</td>"},
        {NAN, NAN, NAN, "1", ">not measured</td>"},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_claims claims = {0};
        struct rl_claim *c = rl_claims_add(&claims, NULL);
        rl_claim_value(c, row[i].value, row[i].low, row[i].high, row[i].unit);
        struct rl_buffer page = {0};
        rl_report_claims(&page, &claims);
        assert_non_null(strstr(page.data, row[i].expected));
        rl_buffer_clear(&page);
        rl_claims_clear(&claims);
    }
}

static void test_count(void **state)
{
    (void)state;
    struct rl_claims claims = {0};
    rl_claims_add(&claims, NULL)->verdict = RL_VERDICT_HOLDS;
    rl_claims_add(&claims, NULL)->verdict = RL_VERDICT_FAILS;
    rl_claims_add(&claims, NULL)->verdict = RL_VERDICT_FAILS;
    char text[160];
    rl_report_count(text, sizeof text, &claims);
    assert_string_equal(text, "Of 3 claims, 1 hold, 0 hold up to a point, 2 fail and 0 are inconclusive.");
    rl_claims_clear(&claims);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_escaping),
        cmocka_unit_test(test_page),
        cmocka_unit_test(test_values),
        cmocka_unit_test(test_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
