/* Tables as TSV, CSV and JSON: columns, values that read back, awkward texts. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "results/claims.h"
#include "results/export.h"

static const struct rl_column column[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
    {"method", RL_COLUMN_TEXT, "method"},
    {"samples", RL_COLUMN_NUMBER, "samples"},
    {"frame_ms", RL_COLUMN_VALUE, "frame_ms"},
    {"frame_ms_low", RL_COLUMN_LOW, "frame_ms"},
    {"frame_ms_high", RL_COLUMN_HIGH, "frame_ms"},
    {"rmse", RL_COLUMN_VALUE, "rmse"},
};
static const struct rl_table table = {"times", "times", "kind=time", column,
                                      sizeof column / sizeof column[0]};

static void make_run(struct rl_run *run)
{
    static const struct rl_place place = {"fps", "a\tb", "a.yaml", 255};
    *run = (struct rl_run){.study = "fps"};
    struct rl_record *r = rl_run_add(run, &place, 0, NULL, "kind=time method=random samples=4");
    rl_record_metric_add(r, "frame_ms", 0.1, 0.05, INFINITY, "ms", NULL);
    rl_record_series_add(r, "frame_ms", (double[]){0.1, 0.3}, 2, NULL);
    r->status = RL_RECORD_OK;
    rl_hash_text(r->identity, 0xfedcba9876543210);
    r = rl_run_add(run, &place, 0, NULL, "kind=error method=random samples=4");
    r->status = RL_RECORD_OK;
    rl_run_add(run, &place, 0, NULL, "kind=time method=plain samples=1"); /* planned only */
}

static void expect(struct rl_buffer *text, const char *expected)
{
    assert_int_equal(rl_buffer_check(text, NULL), RL_OK);
    assert_string_equal(text->data, expected);
    rl_buffer_clear(text);
}

static void test_tables(void **state)
{
    (void)state;
    struct rl_run run;
    make_run(&run);
    struct rl_buffer text = {0};
    rl_export_run(&text, &table, &run, RL_EXPORT_TSV);
    expect(&text,
           "scene\tscene_hash\tmethod\tsamples\tframe_ms\tframe_ms_low\tframe_ms_high\trmse\tidentity\n"
           "a b\t00000000000000ff\trandom\t4\t0.1\t0.05\tinf\tnan\tfedcba9876543210\n");
    rl_export_run(&text, &table, &run, RL_EXPORT_JSON);
    expect(&text,
           "[\n  {\"scene\": \"a\\u0009b\", \"scene_hash\": \"00000000000000ff\", \"method\": \"random\", "
           "\"samples\": 4, \"frame_ms\": 0.1, \"frame_ms_low\": 0.05, \"frame_ms_high\": null, \"rmse\": "
           "null, \"identity\": \"fedcba9876543210\"}\n]\n");
    rl_export_samples(&text, &run, 1, RL_EXPORT_TSV);
    expect(&text, "study\tscene\tparameters\tseries\tindex\tvalue\tidentity\n"
                  "fps\ta b\tkind=time method=random samples=4\tframe_ms\t0\t0.1\tfedcba9876543210\n"
                  "fps\ta b\tkind=time method=random samples=4\tframe_ms\t1\t0.3\tfedcba9876543210\n");
    struct rl_run empty = {0};
    rl_export_run(&text, &table, &empty, RL_EXPORT_JSON);
    expect(&text, "[]\n");
    rl_run_clear(&run);
}

static void test_csv(void **state)
{
    (void)state;
    static const struct {
        const char *text, *field;
    } row[] = {
        {"plain, no", "\"plain, no\""},
        {"a \"word\"", "\"a \"\"word\"\"\""},
        {"\"", "\"\"\"\""},
        {"two\nlines", "\"two\nlines\""},
        {"back\r", "\"back\r\""},
        {"a\ttab; and so on", "a\ttab; and so on"},
        {" blanks ", " blanks "},
        {"", ""},
    };
    static const char *const name[] = {"text", "number"};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_buffer text = {0};
        struct rl_export t;
        char expected[128];
        rl_export_begin(&t, &text, RL_EXPORT_CSV, name, 2);
        rl_export_text(&t, row[i].text);
        rl_export_number(&t, 0.1);
        rl_export_end(&t);
        snprintf(expected, sizeof expected, "text,number\r\n%s,0.1\r\n", row[i].field);
        expect(&text, expected);
    }
    struct rl_run run;
    struct rl_buffer text = {0};
    make_run(&run);
    rl_export_run(&text, &table, &run, RL_EXPORT_CSV);
    expect(&text, "scene,scene_hash,method,samples,frame_ms,frame_ms_low,frame_ms_high,rmse,identity\r\n"
                  "a\tb,00000000000000ff,random,4,0.1,0.05,inf,nan,fedcba9876543210\r\n");
    rl_run_clear(&run);
    assert_string_equal(rl_export_ending(RL_EXPORT_CSV), ".csv");
}

static void test_numbers(void **state)
{
    (void)state;
    static const struct {
        double value;
        const char *text;
    } row[] = {
        {0.1, "0.1"},
        {1.0 / 3.0, "0.3333333333333333"},
        {1024, "1024"},
        {-1e-300, "-1e-300"},
        {NAN, "nan"},
        {-NAN, "nan"},
        {INFINITY, "inf"},
        {-INFINITY, "-inf"},
        {0.30000000000000004, "0.30000000000000004"},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_buffer text = {0};
        rl_buffer_number(&text, row[i].value);
        expect(&text, row[i].text);
    }
}

static void test_growth(void **state)
{
    (void)state;
    struct rl_buffer text = {0};
    for (int i = 0; i < 20000; i++)
        rl_buffer_printf(&text, "%06d\n", i);
    assert_int_equal(text.length, 140000);
    assert_string_equal(text.data + text.length - 7, "019999\n");
    assert_int_equal(strlen(text.data), text.length);
    rl_buffer_clear(&text);
}

static void test_claims_table(void **state)
{
    (void)state;
    struct rl_claims claims = {0};
    struct rl_claim *c = rl_claims_add(&claims, NULL);
    snprintf(c->text, sizeof c->text, "paper: fast");
    snprintf(c->study, sizeof c->study, "fps");
    snprintf(c->command, sizeof c->command, "roughlight study run fps");
    rl_claim_value(c, 1.5, 1.25, 1.75, "1");
    c->verdict = RL_VERDICT_HOLDS;
    snprintf(c->scene, sizeof c->scene, "teapot-star");
    c->figure = "rate";
    snprintf(c->note, sizeof c->note, "by round");
    char(*identity)[RL_HASH_TEXT] = malloc(2 * sizeof *identity); /* rl_claims_clear frees it */
    assert_non_null(identity);
    rl_hash_text(identity[0], 1);
    rl_hash_text(identity[1], 2);
    c->identity = identity;
    c->n_cases = 2;
    c = rl_claims_add(&claims, NULL);
    snprintf(c->text, sizeof c->text, "ours: \"not\" measured");
    struct rl_buffer text = {0};
    rl_claims_export(&text, &claims, RL_EXPORT_TSV);
    expect(
        &text,
        "claim\tverdict\tvalue\tlow\thigh\tunit\tstudy\tcommand\tscene\tfigure\tnote\tcases\tsize_px\tseeds\n"
        "paper: fast\tholds\t1.5\t1.25\t1.75\t1\tfps\troughlight study run fps\tteapot-star\trate\tby "
        "round\t0000000000000001 0000000000000002\t\t\n"
        "ours: \"not\" measured\tinconclusive\tnan\tnan\tnan\t\t\t\t\t\t\t\t\t\n");
    rl_claims_export(&text, &claims, RL_EXPORT_JSON);
    assert_non_null(
        strstr(text.data,
               "\"claim\": \"ours: \\\"not\\\" measured\", \"verdict\": \"inconclusive\", \"value\": null"));
    rl_buffer_clear(&text);
    rl_claims_clear(&claims);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tables), cmocka_unit_test(test_csv),          cmocka_unit_test(test_numbers),
        cmocka_unit_test(test_growth), cmocka_unit_test(test_claims_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
