/* `probe`: a function of the model, by name, on rows of arguments from standard input, in C or in GLSL. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/output.h"
#include "cli/probe_rows.h"
#include "cli/render_options.h"

static const struct rl_option options_probe[] = {
    {0, "backend", "NAME",
     "cpu (double precision, the default); gpu (as $ROUGHLIGHT_BACKEND says), or one of its backends by "
     "name"},
    {0},
};

static int evaluate(const struct rl_probe *probe, const char *backend, const struct rl_probe_rows *rows,
                    double *results, struct rl_error *error)
{
    if (strcmp(backend, "cpu") == 0) {
        rl_probe_cpu(probe, rows->value, rows->n, results);
        return RL_OK;
    }
    struct rl_gpu *gpu;
    int status = rl_gpu_open(&gpu, backend, error);
    if (status != RL_OK)
        return status;
    status = rl_probe_gpu(probe, gpu, rows->value, rows->n, results, error);
    rl_gpu_close(gpu);
    return status;
}

static void print(const struct rl_probe *probe, enum rl_output format, const double *results, size_t n)
{
    const char *columns[RL_PROBE_OUT_MAX + 1] = {NULL};
    memcpy(columns, probe->out, probe->n_out * sizeof *columns);
    struct rl_rows rows;
    rl_rows_begin(&rows, format, columns);
    for (size_t i = 0; i < n * probe->n_out; i++)
        rl_rows_number(&rows, results[i]);
    rl_rows_end(&rows);
}

static int probe(const struct rl_arguments *a, struct rl_error *error)
{
    struct rl_probe function;
    struct rl_probe_rows rows = {0};
    enum rl_output format;
    const char *backend = rl_argument(a, "backend");
    if (!backend)
        backend = "cpu";
    else if (strcmp(backend, "gpu") == 0)
        backend = rl_environment_backend();
    int status = rl_probe_find(&function, a->positional[0], error);
    if (status == RL_OK)
        status = rl_argument_output(a, &format, error);
    if (status == RL_OK && strcmp(backend, "cpu") != 0)
        status = rl_probe_check_gpu(&function, error);
    if (status == RL_OK)
        status = rl_probe_rows_read(&rows, &function, stdin, "standard input", error);
    double *results = status == RL_OK ? malloc((rows.n * function.n_out + 1) * sizeof *results) : NULL;
    if (status == RL_OK && !results)
        status = rl_fail_memory(error, "results");
    if (status == RL_OK)
        status = evaluate(&function, backend, &rows, results, error);
    if (status == RL_OK)
        print(&function, format, results, rows.n);
    free(results);
    rl_probe_rows_clear(&rows);
    return status;
}

static int run(const struct rl_arguments *a, struct rl_error *error)
{
    return rl_exit_of(probe(a, error));
}

static void print_columns(const struct rl_probe *p)
{
    printf(" ");
    for (size_t i = 0; i < p->n_in; i++)
        printf(" %s", p->in[i].name);
    printf(" ->");
    for (size_t i = 0; i < p->n_out; i++)
        printf(" %s", p->out[i]);
    printf("\n");
}

static void print_functions(void)
{
    struct rl_probe p;
    printf("\nfunctions, their columns, and how far GLSL is from C at most, beside what C changes by when "
           "vectors "
           "change\nby %g of their length, for GLSL has them in single precision:\n",
           RL_PROBE_ROUNDING);
    for (size_t i = 0; rl_probe_at(&p, i); i++) {
        printf("\n  %s: %s\n  ", p.name, p.summary);
        print_columns(&p);
        if (rl_probe_check_gpu(&p, NULL) == RL_OK)
            printf("    GLSL: within %g + %g |value|%s%s\n", p.absolute, p.relative, p.bound ? "; " : "",
                   p.bound ? p.bound : "");
        else
            printf("    cpu only: no shader has it\n");
    }
}

const struct rl_command rl_command_probe = {
    .name = "probe",
    .arguments = "FUNCTION [options] <ROWS",
    .min_positionals = 1,
    .max_positionals = 1,
    .summary = "a function of the model on rows of arguments, in C or in GLSL",
    .description =
        "Reads rows of arguments from standard input, numbers with tabs or blanks between them, and prints a "
        "row of\n"
        "results for each, after a header. The first line may be a header: the names of the columns, in "
        "their "
        "order.\n"
        "Empty lines are skipped. Directions need not be unit vectors. Nothing is printed if any row is "
        "wrong.\n"
        "Of an effect: N, V and L, a light in direction L of irradiance 1 perpendicular to it (or the "
        "vertices "
        "of a triangle\n"
        "of radiance 1, seen from the point), then its parameters; a choice is its number from 0, and - "
        "leaves "
        "an optional\n"
        "parameter out.\n\n"
        "  roughlight probe frame --backend gpu <normals.tsv\n"
        "  echo '30 0.1' | roughlight probe ellipsoid-pdf --format json",
    .options = (const struct rl_option *const[]){options_probe, rl_options_format, NULL},
    .more_help = print_functions,
    .run = run,
};
