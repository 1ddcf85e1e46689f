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
    **found = (struct rl_rerun_row){.before = before, .smallest_p = 1.0, .distance = NAN, .fit_p = NAN};
    return RL_OK;
}

static int add_p(struct rl_rerun_row *row, const struct rl_regression *result, struct rl_error *error)
{
    double *more = realloc(row->p, (row->n + 1) * sizeof *more);
    if (!more)
        return rl_fail_memory(error, "reruns");
    row->p = more;
    row->p[row->n++] = result->p;
    row->smallest_p = fmin(row->smallest_p, result->p);
    row->alarms += result->verdict == RL_CHANGE_WORSE || result->verdict == RL_CHANGE_BETTER;
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
            status = add_p(row, &compared->result, error);
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

static double distance_from_uniform(double p[], size_t n)
{
    double largest = 0.0;
    qsort(p, n, sizeof *p, ascending);
    for (size_t i = 0; i < n; i++)
        largest = fmax(largest, fmax((double)(i + 1) / (double)n - p[i], p[i] - (double)i / (double)n));
    return largest;
}

void rl_reruns_judge(struct rl_reruns *reruns)
{
    double smallest_p = 1.0, smallest_fit = 1.0, tests = 0.0;
    for (size_t i = 0; i < reruns->n; i++) {
        struct rl_rerun_row *row = &reruns->row[i];
        row->distance = distance_from_uniform(row->p, row->n);
        row->fit_p = rl_kolmogorov_p(row->distance, row->n);
        smallest_p = fmin(smallest_p, row->smallest_p);
        smallest_fit = fmin(smallest_fit, row->fit_p);
        tests += (double)row->n;
    }
    reruns->smallest_p = reruns->n ? rl_sidak_p(smallest_p, tests) : NAN;
    reruns->smallest_fit_p = reruns->n ? rl_sidak_p(smallest_fit, (double)reruns->n) : NAN;
}

void rl_reruns_clear(struct rl_reruns *reruns)
{
    for (size_t i = 0; i < reruns->n; i++)
        free(reruns->row[i].p);
    free(reruns->row);
    *reruns = (struct rl_reruns){0};
}
