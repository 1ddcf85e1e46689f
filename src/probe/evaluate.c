/* Evaluates probes: checks rows, calls the C function or runs the GLSL one (see probe.h). */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "gpu/compute.h"
#include "probe/probe.h"

int rl_probe_check_row(const struct rl_probe *probe, const double *row, struct rl_error *error)
{
    for (size_t i = 0; i < probe->n_in; i++) {
        const struct rl_probe_column *c = &probe->in[i];
        bool bounded = c->low < c->high;
        if (c->optional && c->goes_on && isnan(row[i]) != isnan(row[i - 1]))
            return rl_fail(error, RL_ERR_INPUT,
                           "%s: found %s, expected %s, as for %s: a colour has three channels or none",
                           c->name, isnan(row[i]) ? "-" : "a number", isnan(row[i]) ? "a number" : "-",
                           probe->in[i - 1].name);
        if (c->optional && isnan(row[i]))
            continue;
        if (c->whole && row[i] != floor(row[i]))
            return rl_fail(error, RL_ERR_INPUT, "%s: found %.17g, expected a whole number", c->name, row[i]);
        if (!isfinite(row[i]) || (bounded && !(row[i] >= c->low && row[i] <= c->high)))
            return bounded ? rl_fail(error, RL_ERR_INPUT, "%s: found %.17g, expected %g to %g", c->name,
                                     row[i], c->low, c->high)
                           : rl_fail(error, RL_ERR_INPUT, "%s: found %g, expected a finite number", c->name,
                                     row[i]);
    }
    for (size_t i = 0; i < probe->n_directions; i++)
        if (row[3 * i] == 0.0 && row[3 * i + 1] == 0.0 && row[3 * i + 2] == 0.0)
            return rl_fail(error, RL_ERR_INPUT, "%s, %s, %s: found the zero vector, expected a direction",
                           probe->in[3 * i].name, probe->in[3 * i + 1].name, probe->in[3 * i + 2].name);
    const char *key = NULL, *expected = NULL;
    if (probe->effect && probe->effect->check)
        expected = probe->effect->check(rl_probe_effect_values(probe, row), &key);
    if (expected)
        return rl_fail(error, RL_ERR_INPUT, "%s: expected %s", key, expected);
    return RL_OK;
}

int rl_probe_check_gpu(const struct rl_probe *probe, struct rl_error *error)
{
    if (probe->glsl || probe->effect)
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "%s: no shader has this function, expected the backend cpu",
                   probe->name);
}

void rl_probe_cpu(const struct rl_probe *probe, const double *rows, size_t n_rows, double *results)
{
    for (size_t i = 0; i < n_rows; i++)
        probe->cpu(probe, rows + i * probe->n_in, results + i * probe->n_out);
}

static void list_modules(struct rl_plan_program *program, const struct rl_probe *probe)
{
    *program = (struct rl_plan_program){.pass = "probe"};
    for (size_t i = 0; i < RL_PROBE_MODULES_MAX && probe->modules[i]; i++)
        snprintf(program->module[program->n_modules++], RL_PLAN_MODULE_NAME, "%s", probe->modules[i]);
    snprintf(program->module[program->n_modules++], RL_PLAN_MODULE_NAME, "passes/probe");
}

float rl_probe_single(double x)
{
    return fabs(x) > (double)FLT_MAX ? copysignf(FLT_MAX, (float)x) : (float)x;
}

void rl_probe_round_directions(float *to, const struct rl_probe *probe, const double *row)
{
    for (size_t i = 0; i < probe->n_directions; i++) {
        const double *d = row + 3 * i;
        double most = fmax(fabs(d[0]), fmax(fabs(d[1]), fabs(d[2])));
        int power = most > 1e-3 && most < 1e3 ? 0 : -ilogb(most);
        for (size_t c = 0; c < 3; c++)
            to[3 * i + c] = (float)scalbn(d[c], power);
    }
}

/* What rounding takes out of the column's range, such as pi/2, becomes the last number of single precision in it. */
static float round_argument(const struct rl_probe_column *c, double x)
{
    float rounded = rl_probe_single(x);
    if (c->low < c->high && (double)rounded > c->high)
        return nextafterf(rounded, -INFINITY);
    if (c->low < c->high && (double)rounded < c->low)
        return nextafterf(rounded, INFINITY);
    return rounded;
}

static void round_row(float *to, const struct rl_probe *probe, const double *row)
{
    for (size_t i = 0; i < probe->n_in; i++)
        to[i] = round_argument(&probe->in[i], row[i]);
    rl_probe_round_directions(to, probe, row);
}

/* Of a function of the model: one program does for all rows. */
int rl_probe_gpu(const struct rl_probe *probe, struct rl_gpu *gpu, const double *rows, size_t n_rows,
                 double *results, struct rl_error *error)
{
    if (probe->effect)
        return rl_probe_effect_gpu(probe, gpu, rows, n_rows, results, error);
    struct rl_plan_program program;
    list_modules(&program, probe);
    float *in = malloc((n_rows * probe->n_in + 1) * sizeof *in);
    float *out = malloc((n_rows * probe->n_out + 1) * sizeof *out);
    char *glue = NULL;
    int status = rl_probe_check_gpu(probe, error);
    if (status != RL_OK || !in || !out ||
        asprintf(&glue, "void evaluate(float a[N_IN], out float r[N_OUT])\n{\n%s}\n", probe->glsl) < 0) {
        glue = NULL;
        status = status == RL_OK ? rl_fail_memory(error, "rows") : status;
    }
    if (status == RL_OK) {
        for (size_t i = 0; i < n_rows; i++)
            round_row(in + i * probe->n_in, probe, rows + i * probe->n_in);
        status = rl_gpu_compute(gpu, &program, glue, in, probe->n_in, out, probe->n_out, n_rows, error);
    }
    for (size_t i = 0; i < n_rows * probe->n_out && status == RL_OK; i++)
        results[i] = (double)out[i];
    free(in);
    free(out);
    free(glue);
    return status;
}
