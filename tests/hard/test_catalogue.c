/* Hard cases: every row of tests/hard/NAME.tsv within its bound, in C and in GLSL; a catalogue for every probe; a fault is seen. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "probe/catalogue.h"
#include "support/check.h"
#include "support/temporary.h"

static const char *const backend_name[] = {"cpu", "gpu"};

static struct rl_gpu *gpu;

static int open_gpu(void **state)
{
    (void)state;
    struct rl_error error;
    return rl_gpu_open(&gpu, "auto", &error);
}

static int close_gpu(void **state)
{
    (void)state;
    rl_gpu_close(gpu);
    return 0;
}

/* ---- Rows ---- */

static void print_failures(const struct rl_catalogue *c, enum rl_catalogue_backend backend,
                           const double *results)
{
    const struct rl_probe *p = &c->probe;
    for (size_t i = 0; i < c->n_rows * p->n_out; i++) {
        size_t row = i / p->n_out;
        struct rl_catalogue_error e = rl_catalogue_error_of(c, backend, row, i % p->n_out, results[i]);
        if (e.share <= 1.0)
            continue;
        print_error("%s.tsv:%zu, %s: %s is %.17g, expected %.21Lg within %.3g, off by %.3g (%.3g ulp): %s\n ",
                    p->name, c->line[row], backend_name[backend], p->out[i % p->n_out], results[i],
                    c->answers[i][backend].exact, c->answers[i][backend].bound, e.error, e.ulp, c->why[row]);
        for (size_t k = 0; k < p->n_in; k++)
            print_error(" %s %.17g", p->in[k].name, c->rows[row * p->n_in + k]);
        print_error("\n");
    }
}

/* Returns how many rows fail. */
static size_t judge(const struct rl_catalogue *c, enum rl_catalogue_backend backend)
{
    struct rl_error error;
    struct rl_catalogue_verdict v;
    double *results = malloc(c->n_rows * c->probe.n_out * sizeof *results);
    assert_non_null(results);
    check_ok(rl_catalogue_evaluate(c, backend == RL_CATALOGUE_GPU ? gpu : NULL, results, &error), &error);
    rl_catalogue_judge(&v, c, backend, results);
    print_failures(c, backend, results);
    print_message("%-24s %s %4zu rows, %.3g ulp, %.3g of the bound at line %zu\n", c->probe.name,
                  backend_name[backend], v.n_rows, v.worst_ulp, v.worst_share, c->line[v.row]);
    free(results);
    return v.n_failed;
}

static void test_rows(void **state)
{
    (void)state;
    struct rl_error error;
    char folder[PATH_MAX], **paths;
    size_t n, failed = 0;
    check_ok(rl_catalogue_folder(folder, sizeof folder, &error), &error);
    check_ok(rl_catalogue_list(&paths, &n, folder, &error), &error);
    for (size_t i = 0; i < n; i++) {
        struct rl_catalogue c;
        check_ok(rl_catalogue_load(&c, paths[i], &error), &error);
        failed += judge(&c, RL_CATALOGUE_CPU);
        if (rl_probe_check_gpu(&c.probe, NULL) == RL_OK)
            failed += judge(&c, RL_CATALOGUE_GPU);
        rl_catalogue_free(&c);
    }
    rl_catalogue_list_free(paths, n);
    assert_int_equal(failed, 0);
}

static void test_every_probe_has_a_catalogue(void **state)
{
    (void)state;
    struct rl_error error;
    char folder[PATH_MAX], path[PATH_MAX + 64];
    struct rl_probe p;
    size_t missing = 0;
    check_ok(rl_catalogue_folder(folder, sizeof folder, &error), &error);
    for (size_t i = 0; rl_probe_at(&p, i); i++) {
        snprintf(path, sizeof path, "%s/%s.tsv", folder, p.name);
        bool has = access(path, R_OK) == 0;
        if (!has)
            print_error("%s: no such file\n", path);
        missing += !has;
    }
    assert_int_equal(missing, 0);
}

/* ---- Faults ---- */

static int load_text(struct rl_catalogue *c, const char *name, const char *text, struct rl_error *error)
{
    struct temporary t = {0};
    char path[PATH_MAX];
    temporary_make(&t);
    temporary_path(&t, path, name);
    check_ok(rl_file_write(path, text, strlen(text), error), error);
    int status = rl_catalogue_load(c, path, error);
    temporary_remove(&t);
    return status;
}

#define HEADER "# D\nrr\tdelta\tpdf\tpdf_bound\tpdf_single\tpdf_single_bound\twhy\n"

/* The answer 1/2 and one that is 9 ulp too large; what the backends say is 1/2 in all rows. */
static void test_faults_are_seen(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_catalogue c;
    struct rl_catalogue_verdict v;
    double results[] = {0.5, 0.5, NAN};
    check_ok(load_text(&c, "ellipsoid-pdf.tsv",
                       HEADER "1\t0\t0.5\t4.44e-16\t0.5\t5e-6\tright\n\n"
                              "1\t0\t0.50000000000000099920\t8.88e-16\t0.50001\t5e-6\tdoctored\n"
                              "1\t0\t0.5\t1\t0.5\t1\tfinite it must be\n",
                       &error),
             &error);
    assert_int_equal(c.n_rows, 3);
    assert_int_equal(c.line[1], 5);
    assert_string_equal(c.why[1], "doctored");
    assert_int_equal(judge(&c, RL_CATALOGUE_CPU), 1);
    for (int b = 0; b < RL_CATALOGUE_BACKENDS; b++) {
        rl_catalogue_judge(&v, &c, b, results);
        assert_int_equal(v.n_failed, 2);
        assert_int_equal(v.row, 2);
        assert_true(isinf(v.worst_ulp));
        results[2] = 0.5;
        rl_catalogue_judge(&v, &c, b, results);
        assert_int_equal(v.n_failed, 1);
        assert_int_equal(v.row, 1);
        results[2] = NAN;
    }
    /* 0.9992e-15 is 9 units of 2^-53 and beyond a bound of 8.88e-16. */
    struct rl_catalogue_error e = rl_catalogue_error_of(&c, RL_CATALOGUE_CPU, 1, 0, 0.5);
    check_near(e.ulp, 9.0, 1e-3);
    check_near(e.share, 1.125, 1e-3);
    rl_catalogue_free(&c);
}

static void test_bad_files(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text, *words;
    } cases[] = {
        {"nothing.tsv", HEADER, "nothing.tsv: function 'nothing': expected one of ellipsoid-pdf"},
        {"ellipsoid-pdf.tsv", HEADER, ".tsv:3: found no rows"},
        {"ellipsoid-pdf.tsv", "rr\tdelta\tpdf\twhy\n",
         ".tsv:1: column 4 of the header: found 'why', expected pdf_bound"},
        {"ellipsoid-pdf.tsv", HEADER "1\t0\thard\n", ".tsv:3: found 3 columns, expected 7"},
        {"ellipsoid-pdf.tsv", HEADER "1\tx\t0\t0\t0\t0\thard\n", ".tsv:3: delta: found 'x'"},
        {"ellipsoid-pdf.tsv", HEADER "1\t2\t0\t0\t0\t0\thard\n", ".tsv:3: delta: found 2, expected -1.5708"},
        {"ellipsoid-pdf.tsv", HEADER "1\t0\t0\tnan\t0\t0\thard\n", ".tsv:3: pdf_bound: found 'nan'"},
        {"ellipsoid-pdf.tsv", HEADER "1\t0\t0\t-1\t0\t0\thard\n", ".tsv:3: found the bound -1"},
        {"ellipsoid-pdf.tsv", HEADER "1\t0\t0\t0\t0\t0\t\n", ".tsv:3: why: found nothing"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct rl_error error;
        struct rl_catalogue c;
        check_fails(load_text(&c, cases[i].name, cases[i].text, &error), &error, RL_ERR_INPUT,
                    cases[i].words);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rows),
        cmocka_unit_test(test_every_probe_has_a_catalogue),
        cmocka_unit_test(test_faults_are_seen),
        cmocka_unit_test(test_bad_files),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
