/* `hard`: the catalogue of hard cases, or files of it, against their exact answers; a row for each function and backend. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/output.h"
#include "cli/render_options.h"
#include "probe/catalogue.h"

static const struct rl_option options_hard[] = {
    {0, "backend", "NAME",
     "only this: cpu (double precision); gpu (as $ROUGHLIGHT_BACKEND says), or one of its backends by name"},
    {0},
};

static const char *const backend_name[] = {"cpu", "gpu"};

/* What is wanted, and the sum of it. */
struct request {
    bool wants[RL_CATALOGUE_BACKENDS];
    struct rl_gpu *gpu;
    struct rl_rows rows;
    size_t n_failed;
};

static void name_failures(const struct rl_catalogue *c, const char *path, enum rl_catalogue_backend backend,
                          const double *results)
{
    for (size_t i = 0; i < c->n_rows * c->probe.n_out; i++) {
        size_t row = i / c->probe.n_out, out = i % c->probe.n_out;
        struct rl_catalogue_error e = rl_catalogue_error_of(c, backend, row, out, results[i]);
        if (!(e.share <= 1.0))
            fprintf(stderr,
                    "%s:%zu: %s, %s: found %.17g, expected %.21Lg within %.3g, %.3g away (%.3g ulp): %s\n",
                    path, c->line[row], backend_name[backend], c->probe.out[out], results[i],
                    c->answers[i][backend].exact, c->answers[i][backend].bound, e.error, e.ulp, c->why[row]);
    }
}

static void print_verdict(struct rl_rows *rows, const struct rl_catalogue *c,
                          enum rl_catalogue_backend backend, const struct rl_catalogue_verdict *v,
                          const double *results)
{
    size_t i = v->row * c->probe.n_out + v->out;
    rl_rows_text(rows, c->probe.name);
    rl_rows_text(rows, backend_name[backend]);
    rl_rows_integer(rows, (long long)v->n_rows);
    rl_rows_integer(rows, (long long)v->n_failed);
    rl_rows_number(rows, v->worst_ulp);
    rl_rows_number(rows, v->worst_share);
    rl_rows_text(rows, c->probe.out[v->out]);
    rl_rows_number(rows, rl_catalogue_error_of(c, backend, v->row, v->out, results[i]).error);
    rl_rows_number(rows, c->answers[i][backend].bound);
    rl_rows_integer(rows, (long long)c->line[v->row]);
    rl_rows_text(rows, c->why[v->row]);
}

static int judge(struct request *q, const struct rl_catalogue *c, const char *path, struct rl_error *error)
{
    double *results = malloc(c->n_rows * c->probe.n_out * sizeof *results);
    int status = results ? RL_OK : rl_fail_memory(error, "results");
    for (int b = 0; b < RL_CATALOGUE_BACKENDS && status == RL_OK; b++) {
        struct rl_catalogue_verdict verdict;
        if (!q->wants[b] || (b == RL_CATALOGUE_GPU && rl_probe_check_gpu(&c->probe, NULL) != RL_OK))
            continue;
        status = rl_catalogue_evaluate(c, b == RL_CATALOGUE_GPU ? q->gpu : NULL, results, error);
        if (status != RL_OK)
            break;
        rl_catalogue_judge(&verdict, c, b, results);
        print_verdict(&q->rows, c, b, &verdict, results);
        name_failures(c, path, b, results);
        q->n_failed += verdict.n_failed;
    }
    free(results);
    return status;
}

/* All of them are read before anything is printed. */
static int judge_files(struct request *q, const char *const *paths, size_t n, enum rl_output format,
                       struct rl_error *error)
{
    static const char *const columns[] = {"function",  "backend",     "rows",   "failed",
                                          "worst_ulp", "worst_share", "result", "error",
                                          "bound",     "line",        "why",    NULL};
    struct rl_catalogue *c = calloc(n + 1, sizeof *c);
    size_t n_read = 0;
    int status = c ? RL_OK : rl_fail_memory(error, "catalogues");
    while (status == RL_OK && n_read < n) {
        status = rl_catalogue_load(&c[n_read], paths[n_read], error);
        n_read += status == RL_OK;
    }
    if (status == RL_OK) {
        rl_rows_begin(&q->rows, format, columns);
        for (size_t i = 0; i < n && status == RL_OK; i++)
            status = judge(q, &c[i], paths[i], error);
        rl_rows_end(&q->rows);
    }
    for (size_t i = 0; i < n_read; i++)
        rl_catalogue_free(&c[i]);
    free(c);
    return status;
}

/* The files named, or all of the catalogue. */
static int judge_named(struct request *q, const struct rl_arguments *a, enum rl_output format,
                       struct rl_error *error)
{
    char folder[4096];
    char **paths = NULL;
    size_t n = 0;
    if (a->n_positionals > 0)
        return judge_files(q, a->positional, a->n_positionals, format, error);
    int status = rl_catalogue_folder(folder, sizeof folder, error);
    if (status == RL_OK)
        status = rl_catalogue_list(&paths, &n, folder, error);
    if (status == RL_OK)
        status = judge_files(q, (const char *const *)paths, n, format, error);
    rl_catalogue_list_free(paths, n);
    return status;
}

static int run(const struct rl_arguments *a, struct rl_error *error)
{
    struct request q = {.wants = {true, true}};
    enum rl_output format;
    const char *backend = rl_argument(a, "backend");
    if (backend) {
        bool cpu = strcmp(backend, "cpu") == 0;
        q.wants[RL_CATALOGUE_CPU] = cpu;
        q.wants[RL_CATALOGUE_GPU] = !cpu;
    }
    if (!backend || strcmp(backend, "gpu") == 0)
        backend = rl_environment_backend();
    int status = rl_argument_output(a, &format, error);
    if (status == RL_OK && q.wants[RL_CATALOGUE_GPU])
        status = rl_gpu_open(&q.gpu, backend, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    status = judge_named(&q, a, format, error);
    if (q.gpu)
        rl_gpu_close(q.gpu);
    if (status == RL_OK && q.n_failed > 0)
        status = rl_fail(error, RL_ERR_CHECK, "%zu rows beyond their bounds", q.n_failed);
    return rl_exit_of(status);
}

const struct rl_command rl_command_hard = {
    .name = "hard",
    .arguments = "[FILE...] [--backend NAME]",
    .max_positionals = RL_CLI_POSITIONALS_MAX,
    .summary = "the catalogue of hard cases against exact answers, in C and in GLSL",
    .description =
        "Reads files of hard cases, tests/hard/FUNCTION.tsv by default: arguments of a function of `probe`, "
        "exact "
        "answers and\n"
        "bounds. Prints a row for each function and backend: rows, how many fail, the worst error in units "
        "in "
        "the last\n"
        "place (where the arguments' own rounding does not do more), the worst share of a bound, then of "
        "that "
        "one the result,\n"
        "its error and bound, the file's line and why the case is hard. Rows that fail are named on stderr; "
        "exit 1 if there\n"
        "are any.\n\n"
        "  roughlight hard\n"
        "  roughlight hard tests/hard/frame.tsv --backend cpu --format json",
    .options = (const struct rl_option *const[]){options_hard, rl_options_format, NULL},
    .run = run,
};
