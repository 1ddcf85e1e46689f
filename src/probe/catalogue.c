/* Reads catalogues of hard cases and judges results by them (see catalogue.h). */
#include "probe/catalogue.h"

#include <dirent.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "base/paths.h"

/* ---- Reading ---- */

enum { FIELDS_MAX = RL_PROBE_IN_MAX + 4 * RL_PROBE_OUT_MAX + 2 };

struct reader {
    struct rl_catalogue *c;
    size_t room;
    const char *field[FIELDS_MAX];
};

/* Fields beyond FIELDS_MAX are not kept: there are too many in any case. Those that a line lacks are empty. */
static size_t split(const char *field[], char *line)
{
    size_t n = 0;
    for (size_t i = 0; i < FIELDS_MAX; i++) {
        const char *next = strsep(&line, "\t");
        field[i] = next ? next : "";
        n += next != NULL;
    }
    return n;
}

static size_t n_columns(const struct rl_probe *p)
{
    return p->n_in + 4 * p->n_out + 1;
}

/* The name of column i. */
static void column_name(char name[], size_t size, const struct rl_probe *p, size_t i)
{
    static const char *const suffix[] = {"", "_bound", "_single", "_single_bound"};
    size_t answer = i - p->n_in;
    if (i < p->n_in)
        snprintf(name, size, "%s", p->in[i].name);
    else if (answer < 4 * p->n_out)
        snprintf(name, size, "%s%s", p->out[answer / 4], suffix[answer % 4]);
    else
        snprintf(name, size, "why");
}

static int read_header(struct reader *r, size_t n, struct rl_error *error)
{
    const struct rl_probe *p = &r->c->probe;
    char expected[RL_PROBE_NAME_MAX + 16];
    for (size_t i = 0; i < n_columns(p); i++) {
        column_name(expected, sizeof expected, p, i);
        if (strcmp(r->field[i], expected) != 0)
            return rl_fail(error, RL_ERR_INPUT, "column %zu of the header: found '%.64s', expected %s", i + 1,
                           r->field[i], expected);
    }
    if (n > n_columns(p))
        return rl_fail(error, RL_ERR_INPUT, "found '%.64s' after the header's column why, expected its end",
                       r->field[n_columns(p)]);
    return RL_OK;
}

static int read_number(long double *to, const struct reader *r, size_t i, struct rl_error *error)
{
    char name[RL_PROBE_NAME_MAX + 16], *end;
    *to = strtold(r->field[i], &end);
    if (end != r->field[i] && *end == '\0' && isfinite(*to))
        return RL_OK;
    column_name(name, sizeof name, &r->c->probe, i);
    return rl_fail(error, RL_ERR_INPUT, "%s: found '%.64s', expected a finite number", name, r->field[i]);
}

static void *grow(void *array, size_t size, bool *whole)
{
    void *grown = realloc(array, size);
    if (grown)
        return grown;
    *whole = false;
    return array;
}

static int make_room(struct reader *r, struct rl_error *error)
{
    struct rl_catalogue *c = r->c;
    bool whole = true;
    if (c->n_rows < r->room)
        return RL_OK;
    r->room = r->room ? 2 * r->room : 64;
    c->rows = grow(c->rows, r->room * c->probe.n_in * sizeof *c->rows, &whole);
    c->answers = grow(c->answers, r->room * c->probe.n_out * sizeof *c->answers, &whole);
    c->line = grow(c->line, r->room * sizeof *c->line, &whole);
    c->why = grow(c->why, r->room * sizeof *c->why, &whole);
    return whole ? RL_OK : rl_fail_memory(error, "a catalogue");
}

static int read_answers(struct reader *r, struct rl_error *error)
{
    struct rl_catalogue *c = r->c;
    for (size_t k = 0; k < c->probe.n_out; k++) {
        for (size_t b = 0; b < RL_CATALOGUE_BACKENDS; b++) {
            size_t i = c->probe.n_in + 4 * k + 2 * b;
            struct rl_catalogue_answer *answer = &c->answers[c->n_rows * c->probe.n_out + k][b];
            long double bound;
            int status = read_number(&answer->exact, r, i, error);
            if (status == RL_OK)
                status = read_number(&bound, r, i + 1, error);
            if (status != RL_OK)
                return status;
            answer->bound = (double)bound;
            if (bound < 0.0L)
                return rl_fail(error, RL_ERR_INPUT, "found the bound %g, expected none below 0",
                               answer->bound);
        }
    }
    return RL_OK;
}

static int read_row(struct reader *r, size_t n, size_t line, struct rl_error *error)
{
    struct rl_catalogue *c = r->c;
    const struct rl_probe *p = &c->probe;
    if (n != n_columns(p))
        return rl_fail(error, RL_ERR_INPUT,
                       "found %zu columns, expected %zu: `make hard-answers` adds answers", n, n_columns(p));
    int status = make_room(r, error);
    for (size_t i = 0; i < p->n_in && status == RL_OK; i++) {
        long double x = (long double)NAN;
        if (!p->in[i].optional || strcmp(r->field[i], "-") != 0)
            status = read_number(&x, r, i, error);
        c->rows[c->n_rows * p->n_in + i] = (double)x;
    }
    if (status == RL_OK)
        status = rl_probe_check_row(p, c->rows + c->n_rows * p->n_in, error);
    if (status == RL_OK)
        status = read_answers(r, error);
    if (status == RL_OK && r->field[n - 1][0] == '\0')
        return rl_fail(error, RL_ERR_INPUT, "why: found nothing, expected why the row is hard");
    c->line[c->n_rows] = line;
    c->why[c->n_rows] = r->field[n - 1];
    c->n_rows++;
    return status;
}

static int read_lines(struct reader *r, const char *path, struct rl_error *error)
{
    bool header = true;
    size_t number = 1;
    int status = RL_OK;
    for (char *line = r->c->text, *next; line && *line && status == RL_OK; line = next, number++) {
        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        if (line[0] == '#' || line[0] == '\0')
            continue;
        size_t n = split(r->field, line);
        status = header ? read_header(r, n, error) : read_row(r, n, number, error);
        header = false;
        if (status != RL_OK)
            rl_fail_prefix(error, "%s:%zu", path, number);
    }
    if (status == RL_OK && r->c->n_rows == 0)
        return rl_fail(error, RL_ERR_INPUT, "%s:%zu: found no rows, expected a header and rows", path,
                       number);
    return status;
}

int rl_catalogue_find_probe(struct rl_probe *probe, const char *path, struct rl_error *error)
{
    const char *base = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(base, "."), base);
    int status = rl_probe_find(probe, name, error);
    if (status != RL_OK)
        rl_fail_prefix(error, "%s", path);
    return status;
}

int rl_catalogue_load(struct rl_catalogue *c, const char *path, struct rl_error *error)
{
    *c = (struct rl_catalogue){0};
    struct reader r = {.c = c};
    size_t size;
    /* First: of a file that is not there its name is not what is wrong. */
    int status = rl_file_read(&c->text, &size, path, error);
    if (status == RL_OK)
        status = rl_catalogue_find_probe(&c->probe, path, error);
    if (status == RL_OK)
        status = read_lines(&r, path, error);
    if (status != RL_OK)
        rl_catalogue_free(c);
    return status;
}

void rl_catalogue_free(struct rl_catalogue *c)
{
    free(c->rows);
    free(c->answers);
    free(c->line);
    free(c->why);
    free(c->text);
    *c = (struct rl_catalogue){0};
}

/* ---- Folders ---- */

/* By a file of it: a build tree has a folder of that name, too, with programs. */
int rl_catalogue_folder(char path[], size_t size, struct rl_error *error)
{
    int status = rl_path_data(path, size, "tests/hard/ellipsoid-pdf.tsv", error);
    if (status == RL_OK)
        *strrchr(path, '/') = '\0';
    return status;
}

static int is_catalogue(const struct dirent *entry)
{
    const char *dot = strrchr(entry->d_name, '.');
    return entry->d_name[0] != '.' && dot && strcmp(dot, ".tsv") == 0;
}

int rl_catalogue_list(char ***paths, size_t *n, const char *folder, struct rl_error *error)
{
    struct dirent **entry = NULL;
    int found = scandir(folder, &entry, is_catalogue, alphasort);
    *n = 0;
    *paths = NULL;
    if (found < 0)
        return rl_fail(error, RL_ERR_INPUT, "%s: %s", folder, strerror(errno));
    *paths = calloc((size_t)found + 1, sizeof **paths);
    bool whole = *paths != NULL;
    for (int i = 0; i < found; i++) {
        if (whole && asprintf(&(*paths)[*n], "%s/%s", folder, entry[i]->d_name) >= 0)
            (*n)++;
        else
            whole = false;
        free(entry[i]);
    }
    free(entry);
    if (whole && *n > 0)
        return RL_OK;
    rl_catalogue_list_free(*paths, *n);
    *paths = NULL;
    *n = 0;
    return whole ? rl_fail(error, RL_ERR_INPUT, "%s: found no file NAME.tsv, expected some", folder)
                 : rl_fail_memory(error, "names of catalogues");
}

void rl_catalogue_list_free(char **paths, size_t n)
{
    for (size_t i = 0; i < n; i++)
        free(paths[i]);
    free(paths);
}

/* ---- Judging ---- */

int rl_catalogue_evaluate(const struct rl_catalogue *c, struct rl_gpu *gpu, double *results,
                          struct rl_error *error)
{
    if (gpu)
        return rl_probe_gpu(&c->probe, gpu, c->rows, c->n_rows, results, error);
    rl_probe_cpu(&c->probe, c->rows, c->n_rows, results);
    return RL_OK;
}

/* One unit in the last place of x, down to that of denormal numbers. */
static double ulp_of(double x, int digits, int least_exponent)
{
    int exponent = x > 0.0 ? ilogb(x) + 1 - digits : least_exponent;
    return ldexp(1.0, exponent > least_exponent ? exponent : least_exponent);
}

static double ulp_for(enum rl_catalogue_backend backend, double size)
{
    return backend == RL_CATALOGUE_CPU ? ulp_of(size, DBL_MANT_DIG, DBL_MIN_EXP - DBL_MANT_DIG)
                                       : ulp_of(fmax(size, 0.1), FLT_MANT_DIG, FLT_MIN_EXP - FLT_MANT_DIG);
}

double rl_catalogue_plain_bound(enum rl_catalogue_backend backend, double size)
{
    return backend == RL_CATALOGUE_CPU ? 8.0 * ulp_for(backend, size) : fmax(1e-5 * size, 1e-6);
}

struct rl_catalogue_error rl_catalogue_error_of(const struct rl_catalogue *c,
                                                enum rl_catalogue_backend backend, size_t row, size_t out,
                                                double got)
{
    const struct rl_catalogue_answer *answer = &c->answers[row * c->probe.n_out + out][backend];
    struct rl_catalogue_error e = {.error = INFINITY, .ulp = INFINITY, .share = INFINITY};
    double size = (double)fabsl(answer->exact);
    double ulp = ulp_for(backend, size);
    /* Bounds are printed with three digits. */
    e.conditioned = answer->bound > 1.01 * rl_catalogue_plain_bound(backend, size);
    if (!isfinite(got))
        return e;
    e.error = (double)fabsl((long double)got - answer->exact);
    e.ulp = e.error / ulp;
    if (e.error <= answer->bound)
        e.share = answer->bound > 0.0 ? e.error / answer->bound : 0.0;
    else if (answer->bound > 0.0)
        e.share = e.error / answer->bound;
    return e;
}

void rl_catalogue_judge(struct rl_catalogue_verdict *verdict, const struct rl_catalogue *c,
                        enum rl_catalogue_backend backend, const double *results)
{
    *verdict = (struct rl_catalogue_verdict){.n_rows = c->n_rows};
    for (size_t row = 0; row < c->n_rows; row++) {
        bool failed = false;
        for (size_t out = 0; out < c->probe.n_out; out++) {
            double got = results[row * c->probe.n_out + out];
            struct rl_catalogue_error e = rl_catalogue_error_of(c, backend, row, out, got);
            failed = failed || !(e.share <= 1.0);
            if (!e.conditioned || !isfinite(got))
                verdict->worst_ulp = fmax(verdict->worst_ulp, e.ulp);
            if (e.share > verdict->worst_share) {
                verdict->worst_share = e.share;
                verdict->row = row;
                verdict->out = out;
            }
        }
        verdict->n_failed += failed;
    }
}
