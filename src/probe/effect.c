/* Probes of effects, made from their descriptors. A row has N and V, then the direction L to a light that gives an irradiance of 1
 * perpendicular to it, or a triangle of radiance 1 by its vertices as seen from P, then the parameters. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gpu/compute.h"
#include "probe/probe.h"

/* ---- Descriptors ---- */

static void add_column(struct rl_probe *probe, const char *name, const char *suffix,
                       const struct rl_effect_param *p)
{
    struct rl_probe_column *c = &probe->in[probe->n_in++];
    snprintf(c->name, sizeof c->name, "%s%s", name, suffix);
    if (!p)
        return;
    c->low = p->low;
    c->high = p->high;
    c->optional = isnan(p->absent[0]);
    if (p->kind != RL_EFFECT_CHOICE)
        return;
    c->whole = true;
    while (p->choice[(int)c->high + 1].name)
        c->high++;
}

static void add_param(struct rl_probe *probe, const struct rl_effect_param *p)
{
    static const char *const rgb[] = {"_r", "_g", "_b"};
    const char *name = p->key ? p->key : probe->effect->name;
    if (p->kind != RL_EFFECT_COLOUR)
        add_column(probe, name, "", p);
    for (int c = 0; c < 3 && p->kind == RL_EFFECT_COLOUR; c++) {
        add_column(probe, name, rgb[c], p);
        probe->in[probe->n_in - 1].goes_on = c > 0;
    }
}

const double *rl_probe_effect_values(const struct rl_probe *probe, const double *row)
{
    return row + 3 * probe->n_vectors;
}

static void shade(const struct rl_probe *probe, const double *in, double *out)
{
    const struct rl_effect *effect = probe->effect;
    double params[RL_EFFECT_PARAMS][4] = {{0.0}};
    struct rl_surface s = {.N = v3_normalize(v3(in[0], in[1], in[2])),
                           .V = v3_normalize(v3(in[3], in[4], in[5]))};
    rl_vec3 v[3];
    for (size_t i = 0; i < probe->n_vectors - 2; i++)
        v[i] = v3(in[6 + 3 * i], in[7 + 3 * i], in[8 + 3 * i]);
    effect->pack(rl_probe_effect_values(probe, in), params);
    if (probe->polygon)
        effect->area(&s, v, 3, params, out);
    else if (effect->reflect)
        effect->reflect(&s, v3_normalize(v[0]), params, out);
    else if (effect->constant)
        effect->constant(params, out);
    else
        effect->factor(&s, params, out);
}

bool rl_probe_of_effect(struct rl_probe *probe, const struct rl_effect *effect, bool polygon)
{
    static const char *const directions[] = {"nx", "ny", "nz", "vx", "vy", "vz", "lx", "ly", "lz"};
    static const char *const triangle[] = {"ax", "ay", "az", "bx", "by", "bz", "cx", "cy", "cz"};
    if (polygon ? !effect->area : !effect->reflect && !effect->constant && !effect->factor)
        return false;
    *probe = (struct rl_probe){
        .summary = effect->summary,
        .n_out = 3,
        .n_directions = polygon ? 2 : 3,
        .n_vectors = polygon ? 5 : 3,
        .effect = effect,
        .polygon = polygon,
        .out = {"r", "g", "b"},
        .cpu = shade,
        .absolute = effect->absolute,
        .relative = effect->relative,
    };
    snprintf(probe->name, sizeof probe->name, "%s%s", effect->name, polygon ? "-polygon" : "");
    for (size_t i = 0; i < 3 * probe->n_directions; i++)
        add_column(probe, directions[i], "", NULL);
    for (size_t i = 0; i < 9 && polygon; i++)
        add_column(probe, triangle[i], "", NULL);
    for (size_t i = 0; effect->param[i].help; i++)
        add_param(probe, &effect->param[i]);
    return true;
}

/* ---- GLSL ---- */

/* The GPU gets N, V and what follows, and the vec4s that the effect packs: 3 n_vectors + 4 n_params columns. */
static char *write_glue(const struct rl_probe *probe)
{
    const struct rl_effect *effect = probe->effect;
    char name[32], *glue = NULL;
    int k = effect->n_params, first = (int)(3 * probe->n_vectors);
    const char *what = effect->factor ? "factor" : "constant", *fill = "";
    const char *arguments = effect->factor ? "s, " : "";
    rl_effect_identifier(name, effect);
    if (probe->polygon) {
        what = "area";
        arguments = "s, 0, 3, ";
        fill = "    for (int i = 0; i < 3; i++)\n"
               "        vertices[i] = vec3(a[6 + 3 * i], a[7 + 3 * i], a[8 + 3 * i]);\n";
    } else if (effect->reflect) {
        what = "reflect";
        arguments = "s, normalize(vec3(a[6], a[7], a[8])), ";
    }
    int n = asprintf(&glue,
                     "void evaluate(float a[N_IN], out float r[N_OUT])\n{\n"
                     "    vec4 params[%d];\n"
                     "    for (int i = 0; i < %d; i++)\n"
                     "        params[i] = vec4(a[%d + 4 * i], a[%d + 4 * i], a[%d + 4 * i], a[%d + 4 * i]);\n"
                     "    Surface s = Surface(vec3(0.0), normalize(vec3(a[0], a[1], a[2])),\n"
                     "                        normalize(vec3(a[3], a[4], a[5])));\n"
                     "%s    vec3 rgb = %s_%s(%sparams);\n    r = float[](rgb.r, rgb.g, rgb.b);\n}\n",
                     k, k, first, first + 1, first + 2, first + 3, fill, what, name, arguments);
    return n < 0 ? NULL : glue;
}

/* The modules that a surface program would have of this effect, with the choices of these values. */
static void list_modules(struct rl_plan_program *program, const struct rl_probe *probe, const double *value)
{
    *program = (struct rl_plan_program){.pass = "probe"};
    rl_plan_add_module(program, "common/surface");
    if (probe->effect->area)
        rl_plan_add_module(program, "common/one_polygon");
    rl_plan_add_effect(program, probe->effect, value);
    rl_plan_add_module(program, "passes/probe");
}

static void round_row(float *to, const struct rl_probe *probe, const double *row)
{
    double params[RL_EFFECT_PARAMS][4] = {{0.0}};
    size_t first = 3 * probe->n_vectors;
    for (size_t i = 0; i < first; i++)
        to[i] = rl_probe_single(row[i]);
    rl_probe_round_directions(to, probe, row);
    probe->effect->pack(rl_probe_effect_values(probe, row), params);
    for (int i = 0; i < 4 * probe->effect->n_params; i++)
        to[first + (size_t)i] = (float)params[i / 4][i % 4];
}

/* Whether two rows link the same modules. */
static bool same_choices(const struct rl_probe *probe, const double *a, const double *b)
{
    for (size_t i = 0; probe->effect->param[i].help; i++)
        if (rl_effect_module(probe->effect, rl_probe_effect_values(probe, a), i) !=
            rl_effect_module(probe->effect, rl_probe_effect_values(probe, b), i))
            return false;
    return true;
}

struct batch {
    float *in, *out;
    size_t *row, n;
    bool *done;
    char *glue;
};

/* The rows from `first` on that make its choices. */
static int evaluate_like(struct batch *batch, const struct rl_probe *probe, struct rl_gpu *gpu,
                         const double *rows, size_t first, size_t n_rows, double *results,
                         struct rl_error *error)
{
    size_t n_in = 3 * probe->n_vectors + 4 * (size_t)probe->effect->n_params;
    const double *like = rows + first * probe->n_in;
    struct rl_plan_program program;
    list_modules(&program, probe, rl_probe_effect_values(probe, like));
    batch->n = 0;
    for (size_t i = first; i < n_rows; i++) {
        if (batch->done[i] || !same_choices(probe, like, rows + i * probe->n_in))
            continue;
        round_row(batch->in + batch->n * n_in, probe, rows + i * probe->n_in);
        batch->row[batch->n++] = i;
        batch->done[i] = true;
    }
    int status = rl_gpu_compute(gpu, &program, batch->glue, batch->in, n_in, batch->out, probe->n_out,
                                batch->n, error);
    for (size_t i = 0; i < batch->n * probe->n_out && status == RL_OK; i++)
        results[batch->row[i / probe->n_out] * probe->n_out + i % probe->n_out] = (double)batch->out[i];
    return status;
}

int rl_probe_effect_gpu(const struct rl_probe *probe, struct rl_gpu *gpu, const double *rows, size_t n_rows,
                        double *results, struct rl_error *error)
{
    size_t n_in = 3 * probe->n_vectors + 4 * (size_t)probe->effect->n_params;
    struct batch batch = {
        .in = malloc((n_rows + 1) * n_in * sizeof(float)),
        .out = malloc((n_rows + 1) * probe->n_out * sizeof(float)),
        .row = malloc((n_rows + 1) * sizeof(size_t)),
        .done = calloc(n_rows + 1, sizeof(bool)),
        .glue = write_glue(probe),
    };
    int status = batch.in && batch.out && batch.row && batch.done && batch.glue
                     ? RL_OK
                     : rl_fail_memory(error, "rows");
    for (size_t i = 0; i < n_rows && status == RL_OK; i++)
        if (!batch.done[i])
            status = evaluate_like(&batch, probe, gpu, rows, i, n_rows, results, error);
    free(batch.in);
    free(batch.out);
    free(batch.row);
    free(batch.done);
    free(batch.glue);
    return status;
}
