/* Gathers p values over repeated comparisons (see reruns.h). */
#include "results/reruns.h"

#include <math.h>
#include <stdlib.h>

#include "measure/goodness.h"

static int find_row(struct rl_rerun_row **found, struct rl_reruns *reruns,
                    const struct rl_baseline_row *before, struct rl_error *error)
{
    for (size_t i = 0; i < reruns->n; i++)
        if (reruns->row[i].before == before) {
            *found = &reruns->row[i];
            return RL_OK;
        }
    struct rl_rerun_row *more = realloc(reruns->row, (reruns->n + 1) * sizeof *more);
    if (!more)
        return rl_fail_memory(error, "reruns");
    reruns->row = more;
    *found = &more[reruns->n++];
    **found = (struct rl_rerun_row){
        .before = before, .smallest_p = 1.0, .offset = NAN, .distance = NAN, .fit_p = NAN};
    return RL_OK;
}

static int add_run(struct rl_rerun_row *row, const struct rl_compared *compared, struct rl_error *error)
{
    struct rl_mean *more = realloc(row->run, (row->n + 1) * sizeof *more);
    if (!more)
        return rl_fail_memory(error, "reruns");
    const struct rl_regression *r = &compared->result;
    row->run = more;
    row->run[row->n++] = compared->now->mean;
    row->smallest_p = fmin(row->smallest_p, r->p);
    row->alarms += r->verdict == RL_CHANGE_WORSE || r->verdict == RL_CHANGE_BETTER;
    return RL_OK;
}

int rl_reruns_add(struct rl_reruns *reruns, const struct rl_comparison *c, struct rl_error *error)
{
    bool alarmed = false;
    int status = RL_OK;
    for (size_t i = 0; i < c->n && status == RL_OK; i++) {
        const struct rl_compared *compared = &c->row[i];
        enum rl_change verdict = compared->result.verdict;
        alarmed = alarmed || verdict == RL_CHANGE_WORSE || verdict == RL_CHANGE_BETTER;
        if (!compared->before || !compared->now || compared->now->kind != RL_METRIC_RANDOM ||
            !isfinite(compared->result.p))
            continue;
        struct rl_rerun_row *row;
        status = find_row(&row, reruns, compared->before, error);
        if (status == RL_OK)
            status = add_run(row, compared, error);
    }
    reruns->runs++;
    reruns->alarmed_runs += alarmed;
    return status;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* All values of all runs but one as one sample; `without` = n leaves none out. */
static struct rl_mean pool(const struct rl_rerun_row *row, size_t without)
{
    double n = 0.0, sum = 0.0, squares = 0.0;
    for (size_t i = 0; i < row->n; i++)
        if (i != without) {
            n += (double)row->run[i].n;
            sum += (double)row->run[i].n * row->run[i].value;
        }
    double mean = sum / n;
    for (size_t i = 0; i < row->n; i++)
        if (i != without) {
            const struct rl_mean *m = &row->run[i];
            squares += ((double)m->n - 1.0) * m->deviation * m->deviation +
                       (double)m->n * (m->value - mean) * (m->value - mean);
        }
    return (struct rl_mean){mean, sqrt(squares / (n - 1.0)), (size_t)n};
}

static int judge_row(struct rl_rerun_row *row, struct rl_error *error)
{
    double *p = malloc(row->n * sizeof *p);
    if (!p)
        return rl_fail_memory(error, "reruns");
    for (size_t i = 0; i < row->n; i++) {
        struct rl_regression r;
        struct rl_mean others = pool(row, i);
        rl_regression_random(&r, &others, &row->run[i], RL_BEST_SAME, INFINITY, 0.5);
        p[i] = r.p;
    }
    qsort(p, row->n, sizeof *p, ascending);
    row->distance = 0.0;
    for (size_t i = 0; i < row->n; i++)
        row->distance = fmax(
            row->distance, fmax((double)(i + 1) / (double)row->n - p[i], p[i] - (double)i / (double)row->n));
    row->fit_p = rl_kolmogorov_p(row->distance, row->n);
    free(p);
    return RL_OK;
}

int rl_reruns_judge(struct rl_reruns *reruns, struct rl_error *error)
{
    double smallest_p = 1.0, smallest_fit = 1.0, tests = 0.0;
    for (size_t i = 0; i < reruns->n; i++) {
        struct rl_rerun_row *row = &reruns->row[i];
        const struct rl_mean all = pool(row, row->n), *before = &row->before->mean;
        row->offset = (before->value - all.value) /
                      (all.deviation * sqrt(1.0 / (double)before->n + 1.0 / (double)all.n));
        int status = row->n > 1 ? judge_row(row, error) : RL_OK;
        if (status != RL_OK)
            return status;
        smallest_p = fmin(smallest_p, row->smallest_p);
        smallest_fit = fmin(smallest_fit, row->fit_p); /* fmin leaves NaN out */
        tests += (double)row->n;
    }
    reruns->smallest_p = reruns->n ? rl_sidak_p(smallest_p, tests) : NAN;
    reruns->smallest_fit_p = reruns->n ? rl_sidak_p(smallest_fit, (double)reruns->n) : NAN;
    return RL_OK;
}

void rl_reruns_clear(struct rl_reruns *reruns)
{
    for (size_t i = 0; i < reruns->n; i++)
        free(reruns->row[i].run);
    free(reruns->row);
    *reruns = (struct rl_reruns){0};
}
