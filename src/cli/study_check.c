/* `roughlight study check`: error metrics of a small fixed set of cases against a baseline. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/console.h"
#include "cli/output.h"
#include "cli/render_options.h"
#include "cli/study.h"
#include "results/baseline.h"
#include "results/buffer.h"
#include "results/reruns.h"
#include "studies/check.h"

/* The probability that a check raises any alarm although nothing has changed. */
static const double LEVEL = 1e-4;

struct request {
    const char *baseline, *write;
    long long runs;
    struct rl_check_options options;
    const char *scene[RL_CLI_GIVEN_MAX];
    enum rl_output format;
    int threads;
};

/* A baseline has more seeds than a check, so that its own chance counts for little, and other ones: the same would find nothing where
 * the seeds are drawn wrongly. */
static int take_options(struct request *q, const struct rl_arguments *a, struct rl_error *error)
{
    long long first_seed = q->write ? 1 : 1000001, seeds = q->write ? 256 : 16;
    int status = rl_argument_integer(a, "seed", 0, 1LL << 30, &first_seed, error);
    if (status == RL_OK)
        status = rl_argument_integer(a, "seeds", 4, RL_CHECK_SEEDS_MAX, &seeds, error);
    if (status == RL_OK && seeds % 2)
        status = rl_fail(error, RL_ERR_INPUT, "--seeds: found %lld, expected an even number", seeds);
    if (status != RL_OK)
        return status;
    q->options = (struct rl_check_options){.first_seed = (uint64_t)first_seed,
                                           .seeds = (size_t)seeds,
                                           .random = true,
                                           .fixed = true,
                                           .tolerances = q->write != NULL,
                                           .scene = q->scene};
    while ((q->scene[q->options.n_scenes] = rl_argument_nth(a, "scene", q->options.n_scenes)))
        q->options.n_scenes++;
    return rl_check_options_check(&q->options, error) == RL_OK ? RL_OK : rl_fail_prefix(error, "--scene");
}

static int take_request(struct request *q, const struct rl_arguments *a, struct rl_error *error)
{
    q->write = rl_argument(a, "write");
    q->baseline = rl_argument(a, "baseline");
    if (!q->baseline)
        q->baseline = "tests/baseline.tsv";
    int status = rl_argument_output(a, &q->format, error);
    if (status == RL_OK)
        status = rl_argument_integer(a, "runs", 1, 10000, &q->runs, error);
    if (status == RL_OK)
        status = rl_argument_threads(a, &q->threads, error);
    if (status == RL_OK && q->write && (rl_argument(a, "baseline") || q->runs))
        status = rl_fail(error, RL_ERR_INPUT, "--write: found it beside --%s, expected one of them",
                         q->runs ? "runs" : "baseline");
    if (status == RL_OK && q->write && rl_argument(a, "format"))
        status = rl_fail(error, RL_ERR_INPUT, "--format has no effect with --write, which prints no rows");
    if (status == RL_OK)
        status = take_options(q, a, error);
    return status == RL_OK && q->write ? rl_output_file_check(q->write, error) : status;
}

/* Without the rows of scenes that are not asked for. */
static int read_baseline(struct rl_baseline *before, const struct request *q, struct rl_error *error)
{
    int status = rl_baseline_read(before, q->baseline, error);
    size_t kept = 0;
    for (size_t i = 0; i < before->n; i++)
        if (rl_check_wants(&q->options, before->row[i].scene))
            before->row[kept++] = before->row[i];
    before->n = kept;
    return status;
}

/* Cases that failed, a line each on stderr; returns how many. */
static size_t name_failures(const struct rl_check *check)
{
    size_t n = 0;
    for (const char *line = rl_check_failures(check); *line; n++) {
        int length = (int)strcspn(line, "\n");
        fprintf(stderr, "roughlight: %.*s\n", length, line);
        line += length + 1;
    }
    return n;
}

/* ---- A new baseline ---------------------------------------------------------------------------------------------- */

static int write_baseline(struct rl_check *check, const struct request *q, struct rl_error *error)
{
    struct rl_baseline now = {0};
    struct rl_buffer comment = {0};
    rl_buffer_printf(
        &comment,
        "What `roughlight study check` holds error metrics against; its columns are explained in "
        "src/results/baseline.h.\n"
        "Made by: roughlight study check --write FILE --seeds %zu --seed %llu\n",
        q->options.seeds, (unsigned long long)q->options.first_seed);
    int status = rl_check_measure(&now, check, &q->options, error);
    if (status == RL_OK && name_failures(check) > 0)
        status = rl_fail(error, RL_ERR_CHECK, "%s: not written, since cases failed", q->write);
    if (status == RL_OK)
        status = rl_buffer_check(&comment, error);
    if (status == RL_OK)
        status = rl_baseline_write(&now, q->write, comment.data, error);
    if (status == RL_OK)
        fprintf(stderr, "%s: %zu metrics\n", q->write, now.n);
    rl_buffer_clear(&comment);
    rl_baseline_clear(&now);
    return rl_exit_of(status);
}

/* ---- One check --------------------------------------------------------------------------------------------------- */

static void print_row(struct rl_rows *rows, const struct rl_compared *c)
{
    const struct rl_baseline_row *row = c->now ? c->now : c->before;
    const struct rl_regression *r = &c->result;
    rl_rows_text(rows, row->scene);
    rl_rows_text(rows, row->parameters);
    rl_rows_text(rows, row->metric);
    rl_rows_text(rows, row->kind == RL_METRIC_RANDOM ? "random" : "fixed");
    rl_rows_text(rows, row->unit);
    rl_rows_text(rows, rl_change_name(r->verdict));
    rl_rows_text(rows, r->reason);
    rl_rows_number(rows, c->before ? c->before->mean.value : NAN);
    rl_rows_number(rows, c->now ? c->now->mean.value : NAN);
    rl_rows_number(rows, r->change);
    rl_rows_number(rows, row->kind == RL_METRIC_RANDOM ? r->change - r->half_width : r->change);
    rl_rows_number(rows, row->kind == RL_METRIC_RANDOM ? r->change + r->half_width : r->change);
    rl_rows_number(rows, r->detectable);
    rl_rows_number(rows, r->p);
    rl_rows_number(rows, c->now ? c->now->seconds : NAN);
}

static void print_comparison(const struct rl_comparison *c, enum rl_output format)
{
    struct rl_rows rows;
    rl_rows_begin(&rows, format,
                  (const char *[]){"scene", "parameters", "metric", "kind", "unit", "verdict", "reason",
                                   "baseline", "value", "change", "change_low", "change_high", "detectable",
                                   "p", "case_seconds", NULL});
    for (size_t i = 0; i < c->n; i++)
        print_row(&rows, &c->row[i]);
    rl_rows_end(&rows);
}

/* One line of what was found, and a line for each metric that is worse. */
static void say(const struct rl_comparison *c)
{
    for (size_t i = 0; i < c->n; i++) {
        const struct rl_compared *row = &c->row[i];
        if (row->result.verdict == RL_CHANGE_WORSE)
            fprintf(stderr, "worse: %s of %s %s: %.6g, was %.6g%s%s\n", row->now->metric, row->now->scene,
                    row->now->parameters, row->now->mean.value, row->before->mean.value,
                    *row->result.reason ? ": " : "", row->result.reason);
    }
    fprintf(stderr, "%zu metrics:", c->n);
    for (int v = 0; v < RL_CHANGES; v++)
        fprintf(stderr, "%s %zu %s", v ? "," : "", c->count[v], rl_change_name((enum rl_change)v));
    fprintf(stderr, "; smallest p of %zu tests, corrected: %.3g\n", c->n_tests, c->p_family);
}

static int compare_once(struct rl_check *check, const struct rl_baseline *before, const struct request *q,
                        struct rl_error *error)
{
    struct rl_baseline now = {0};
    struct rl_comparison comparison = {0};
    size_t failed = 0;
    int status = rl_check_measure(&now, check, &q->options, error);
    if (status == RL_OK)
        status = rl_baseline_compare(&comparison, before, &now, LEVEL, error);
    if (status == RL_OK) {
        print_comparison(&comparison, q->format);
        failed = name_failures(check);
        say(&comparison);
        status = rl_output_check(error);
    }
    int code = rl_exit_of(status);
    if (status == RL_OK && comparison.count[RL_CHANGE_WORSE] > 0)
        code = RL_EXIT_CHECK;
    else if (status == RL_OK && failed > 0)
        code = RL_EXIT_PARTIAL;
    else if (status == RL_OK && comparison.count[RL_CHANGE_INCOMPARABLE] == comparison.n)
        code = rl_exit_of(rl_fail(error, RL_ERR_INPUT,
                                  "%s: found no metric that can be compared, expected some", q->baseline));
    rl_comparison_clear(&comparison);
    rl_baseline_clear(&now);
    return code;
}

/* ---- Many checks with other seeds -------------------------------------------------------------------------------- */

static void print_reruns(const struct rl_reruns *reruns, enum rl_output format)
{
    struct rl_rows rows;
    rl_rows_begin(&rows, format,
                  (const char *[]){"scene", "parameters", "metric", "runs", "alarms", "smallest_p",
                                   "baseline_offset", "distance_from_uniform", "fit_p", NULL});
    for (size_t i = 0; i < reruns->n; i++) {
        const struct rl_rerun_row *row = &reruns->row[i];
        rl_rows_text(&rows, row->before->scene);
        rl_rows_text(&rows, row->before->parameters);
        rl_rows_text(&rows, row->before->metric);
        rl_rows_integer(&rows, (long long)row->n);
        rl_rows_integer(&rows, (long long)row->alarms);
        rl_rows_number(&rows, row->smallest_p);
        rl_rows_number(&rows, row->offset);
        rl_rows_number(&rows, row->distance);
        rl_rows_number(&rows, row->fit_p);
    }
    rl_rows_end(&rows);
}

static int run_once(struct rl_reruns *reruns, struct rl_check *check, const struct rl_baseline *before,
                    const struct request *q, long long run, struct rl_error *error)
{
    struct rl_baseline now = {0};
    struct rl_comparison comparison = {0};
    struct rl_check_options options = q->options;
    options.first_seed += (uint64_t)run * options.seeds;
    options.fixed = run == 0; /* they do not depend on the seed */
    int status = rl_check_measure(&now, check, &options, error);
    if (status == RL_OK)
        status = rl_baseline_compare(&comparison, before, &now, LEVEL, error);
    if (status == RL_OK)
        status = rl_reruns_add(reruns, &comparison, error);
    if (status == RL_OK && comparison.count[RL_CHANGE_WORSE] + comparison.count[RL_CHANGE_BETTER] > 0)
        say(&comparison);
    rl_comparison_clear(&comparison);
    rl_baseline_clear(&now);
    return status;
}

static int compare_often(struct rl_check *check, const struct rl_baseline *before, const struct request *q,
                         const struct rl_progress *progress, struct rl_error *error)
{
    struct rl_reruns reruns = {0};
    int status = RL_OK;
    for (long long run = 0; run < q->runs && status == RL_OK; run++) {
        status = run_once(&reruns, check, before, q, run, error);
        rl_progress_update(progress, "runs", (size_t)run + 1, (size_t)q->runs);
    }
    if (status == RL_OK)
        status = rl_reruns_judge(&reruns, error);
    if (status == RL_OK) {
        print_reruns(&reruns, q->format);
        fprintf(stderr,
                "%zu runs of %zu tests: %zu with an alarm; smallest p, corrected for all: %.3g; p values "
                "uniform for each metric: "
                "smallest p of Kolmogorov's test, corrected: %.3g\n",
                reruns.runs, reruns.n, reruns.alarmed_runs, reruns.smallest_p, reruns.smallest_fit_p);
        status = rl_output_check(error);
    }
    int code = status == RL_OK && reruns.alarmed_runs > 0 ? RL_EXIT_CHECK : rl_exit_of(status);
    rl_reruns_clear(&reruns);
    return code;
}

int rl_study_check_command(const struct rl_arguments *a, struct rl_error *error)
{
    struct request q = {0};
    struct rl_baseline before = {0};
    struct rl_check *check = NULL;
    int status = take_request(&q, a, error);
    if (status == RL_OK && !q.write)
        status = read_baseline(&before, &q, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    struct rl_console console;
    const struct rl_progress *progress = rl_console_begin(&console);
    /* Of many runs, the runs themselves are the progress. */
    const struct rl_progress quiet = {.cancelled = progress->cancelled, .user = progress->user};
    status = rl_check_open(&check, rl_argument_backend(a), q.threads, q.runs ? &quiet : progress, error);
    int code = rl_exit_of(status);
    if (status == RL_OK && q.write)
        code = write_baseline(check, &q, error);
    else if (status == RL_OK && q.runs)
        code = compare_often(check, &before, &q, progress, error);
    else if (status == RL_OK)
        code = compare_once(check, &before, &q, error);
    rl_check_close(check);
    rl_console_end(&console);
    rl_baseline_clear(&before);
    return code;
}
