/* Measures how far both backends are from the exact answers of the catalogue of hard cases and of its maps. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "studies/hard.h"

static enum rl_catalogue_backend backend_of(const struct rl_record *r)
{
    return rl_parameters_match(r->parameters, "backend=gpu") ? RL_CATALOGUE_GPU : RL_CATALOGUE_CPU;
}

/* Exact metrics, by name and unit. */
struct figure {
    const char *name, *unit;
    double value;
};

static int add_figures(struct rl_record *r, const struct figure *figure, size_t n, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = rl_record_add_exact(r, figure[i].name, figure[i].value, figure[i].unit, error);
    return status;
}

/* The catalogue's results on the case's backend, on the clock of what is measured; free them. */
static int evaluate(double **results, const struct rl_catalogue *c, enum rl_catalogue_backend backend,
                    struct rl_bench *bench, struct rl_error *error)
{
    *results = malloc(c->n_rows * c->probe.n_out * sizeof **results);
    if (!*results)
        return rl_fail_memory(error, "results of hard cases");
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    int status = rl_catalogue_evaluate(c, backend == RL_CATALOGUE_GPU ? bench->gpu : NULL, *results, error);
    rl_spent_on(&bench->spent, outer);
    return status;
}

static int measure_rows(struct rl_record *r, const char *path, struct rl_bench *bench, struct rl_error *error)
{
    struct rl_catalogue c;
    enum rl_catalogue_backend backend = backend_of(r);
    double *results = NULL;
    int status = rl_catalogue_load(&c, path, error);
    if (status != RL_OK)
        return status;
    status = evaluate(&results, &c, backend, bench, error);
    if (status == RL_OK) {
        struct rl_catalogue_verdict v;
        rl_catalogue_judge(&v, &c, backend, results);
        size_t i = v.row * c.probe.n_out + v.out;
        struct rl_catalogue_error e = rl_catalogue_error_of(&c, backend, v.row, v.out, results[i]);
        const struct figure figure[] = {
            {"rows", "1", (double)v.n_rows},
            {"failed", "1", (double)v.n_failed},
            {"worst_ulp", "ulp", v.worst_ulp},
            {"worst_share", "1", v.worst_share},
            {"error", "1", e.error},
            {"bound", "1", c.answers[i][backend].bound},
            {"line", "1", (double)c.line[v.row]},
        };
        status = add_figures(r, figure, sizeof figure / sizeof figure[0], error);
        snprintf(r->message, sizeof r->message, "%.32s: %.400s", c.probe.out[v.out], c.why[v.row]);
    }
    free(results);
    rl_catalogue_free(&c);
    return status;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* What the points of a map come to. */
struct points {
    size_t n, n_beyond, n_conditioned;
    double *ulp, *sorted, *beyond, *conditioned; /* [n]; the last two hold points */
    double worst_share;
};

static void judge_points(struct points *p, const struct rl_map *m, enum rl_catalogue_backend backend,
                         const double *results)
{
    for (size_t i = 0; i < p->n; i++) {
        struct rl_map_point point = rl_map_point_of(m, backend, results, i);
        p->ulp[i] = p->sorted[i] = point.ulp;
        p->worst_share = fmax(p->worst_share, point.share);
        if (!(point.share <= 1.0))
            p->beyond[p->n_beyond++] = (double)i;
        else if (point.widened)
            p->conditioned[p->n_conditioned++] = (double)i;
    }
    qsort(p->sorted, p->n, sizeof *p->sorted, by_value);
}

static int add_points(struct rl_record *r, const struct points *p, const struct rl_map *m,
                      struct rl_error *error)
{
    const struct figure figure[] = {
        {"points", "1", (double)p->n},
        {"worst_ulp", "ulp", p->sorted[p->n - 1]},
        {"median_ulp", "ulp", p->sorted[p->n / 2]},
        {"worst_share", "1", p->worst_share},
        {"beyond", "1", (double)p->n_beyond / (double)p->n},
        {"beyond_points", "1", (double)p->n_beyond},
        {"conditioned_points", "1", (double)p->n_conditioned},
    };
    const struct {
        const char *name;
        const double *value;
        size_t n;
    } series[] = {
        {"ulp", p->ulp, p->n},
        {"across", m->shown[RL_MAP_ACROSS], m->n[RL_MAP_ACROSS]},
        {"up", m->shown[RL_MAP_UP], m->n[RL_MAP_UP]},
        {"beyond", p->beyond, p->n_beyond},
        {"conditioned", p->conditioned, p->n_conditioned},
    };
    int status = add_figures(r, figure, sizeof figure / sizeof figure[0], error);
    for (size_t i = 0; i < sizeof series / sizeof series[0] && status == RL_OK; i++)
        if (series[i].n > 0)
            status = rl_record_series_add(r, series[i].name, series[i].value, series[i].n, error);
    return status;
}

static int measure_map(struct rl_record *r, const char *path, struct rl_bench *bench, struct rl_error *error)
{
    struct rl_map m;
    enum rl_catalogue_backend backend = backend_of(r);
    double *results = NULL;
    int status = rl_map_load(&m, path, error);
    if (status != RL_OK)
        return status;
    size_t n = m.catalogue.n_rows;
    double *room = malloc(4 * n * sizeof *room);
    status = room ? evaluate(&results, &m.catalogue, backend, bench, error)
                  : rl_fail_memory(error, "a map of hard cases");
    if (status == RL_OK) {
        struct points p = {
            .n = n, .ulp = room, .sorted = room + n, .beyond = room + 2 * n, .conditioned = room + 3 * n};
        judge_points(&p, &m, backend, results);
        status = add_points(r, &p, &m, error);
    }
    free(room);
    free(results);
    rl_map_free(&m);
    return status;
}

/* The file that the case is of: it was there when the case was planned. */
static int find_file(char path[], size_t size, const struct rl_record *r, bool map, struct rl_error *error)
{
    char wanted[RL_NAME_MAX];
    int status = map ? rl_map_folder(path, size, error) : rl_catalogue_folder(path, size, error);
    size_t used = status == RL_OK ? strlen(path) : 0;
    if (status == RL_OK && !rl_parameter(r->parameters, map ? "map" : "function", wanted, sizeof wanted))
        return rl_fail(error, RL_ERR_INPUT, "%s: expected %s=NAME", r->parameters, map ? "map" : "function");
    if (status == RL_OK && (size_t)snprintf(path + used, size - used, "/%s.tsv", wanted) >= size - used)
        return rl_fail(error, RL_ERR_SYSTEM, "the path of the hard cases is too long");
    return status;
}

int rl_hard_measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                    struct rl_error *error)
{
    (void)scene;
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        char path[PATH_MAX];
        bool map = rl_parameters_match(records[i].parameters, "series=map");
        status = find_file(path, sizeof path, &records[i], map, error);
        if (status == RL_OK)
            status = (map ? measure_map : measure_rows)(&records[i], path, bench, error);
    }
    return status;
}
