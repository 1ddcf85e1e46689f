/* `roughlight study run`: measures studies. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/console.h"
#include "cli/output.h"
#include "cli/render_options.h"
#include "cli/study.h"
#include "results/database.h"
#include "studies/forecast.h"
#include "studies/runner.h"

/* What the command line asks for. */
struct request {
    size_t n_studies;
    const struct rl_study *study[RL_CLI_POSITIONALS_MAX];
    const char *scene[RL_CLI_GIVEN_MAX + 1];
    struct rl_axis axis[RL_AXES_MAX];
    char cache[PATH_MAX];
    struct rl_run_options run;
};

static bool is_among(const struct rl_study *study, const struct rl_study *const *studies, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (studies[i] == study)
            return true;
    return false;
}

/* The studies named, each once: their cases would be counted, and listed, twice. */
static int take_studies(struct request *r, const struct rl_arguments *a, struct rl_error *error)
{
    if (a->n_positionals == 0)
        return rl_fail(error, RL_ERR_INPUT,
                       "found no study, expected at least one; 'roughlight study list' lists them");
    for (size_t i = 0; i < a->n_positionals; i++) {
        const struct rl_study *study = rl_study_find(a->positional[i]);
        if (!study)
            return rl_fail(error, RL_ERR_INPUT, "there is no study '%s'; 'roughlight study list' lists them",
                           a->positional[i]);
        if (!is_among(study, r->study, r->n_studies))
            r->study[r->n_studies++] = study;
    }
    return RL_OK;
}

static int take_axes(struct request *r, const struct rl_arguments *a, struct rl_error *error)
{
    const char *text;
    int status = RL_OK;
    for (size_t i = 0; (text = rl_argument_nth(a, "axis", i)) && status == RL_OK; i++) {
        if (i == RL_AXES_MAX)
            return rl_fail(error, RL_ERR_INPUT, "--axis: given more than %d times", RL_AXES_MAX);
        status = rl_axis_parse(&r->axis[i], text, error);
        r->run.n_axes = i + 1;
    }
    r->run.axes = r->axis;
    return status;
}

/* A whole number from 1 on at *text, which moves behind it; 0 if there is none. */
static int take_count(const char **text)
{
    char *end;
    long value = isdigit((unsigned char)**text) ? strtol(*text, &end, 10) : 0;
    if (value < 1 || value > INT_MAX)
        return 0;
    *text = end;
    return (int)value;
}

/* --shard i/n */
static int take_shard(struct rl_run_options *run, const struct rl_arguments *a, struct rl_error *error)
{
    const char *text = rl_argument(a, "shard"), *at = text;
    if (!text)
        return RL_OK;
    run->shard = take_count(&at);
    if (run->shard > 0 && *at++ == '/')
        run->n_shards = take_count(&at);
    if (run->n_shards >= 1 && run->shard <= run->n_shards && *at == '\0')
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "--shard: found '%.40s', expected I/N with 1 <= I <= N", text);
}

static void take_scenes(struct request *r, const struct rl_arguments *a)
{
    while ((r->scene[r->run.n_scenes] = rl_argument_nth(a, "scene", r->run.n_scenes)))
        r->run.n_scenes++;
    r->run.scenes = r->scene;
}

static int take_options(struct request *r, const struct rl_arguments *a, struct rl_error *error)
{
    struct rl_run_options *run = &r->run;
    bool quick = rl_argument_flag(a, "quick"), full = rl_argument_flag(a, "full");
    if (quick && full)
        return rl_fail(error, RL_ERR_INPUT, "--quick and --full: found both, expected one of them");
    if (rl_argument(a, "format") && !rl_argument_flag(a, "dry-run"))
        return rl_fail(error, RL_ERR_INPUT, "--format has no effect without --dry-run: a run prints no rows");
    rl_study_cache(r->cache, a);
    run->cache = r->cache;
    run->database = rl_study_database(a);
    run->backend = rl_argument_backend(a);
    run->grid = quick ? RL_GRID_QUICK : full ? RL_GRID_FULL : RL_GRID_DEFAULT;
    run->retry = rl_argument_flag(a, "retry");
    run->again = rl_argument_flag(a, "again");
    take_scenes(r, a);
    int status = take_axes(r, a, error);
    if (status == RL_OK)
        status = take_shard(run, a, error);
    return status == RL_OK ? rl_argument_threads(a, &run->threads, error) : status;
}

static void name_case(const struct rl_record *r)
{
    bool failed = r->status == RL_RECORD_FAILED;
    fprintf(stderr, "roughlight: %s: %s %s %s%s%s\n", failed ? "failed" : "missing", r->study, r->scene,
            r->parameters, failed ? ": " : "", failed ? r->message : "");
}

size_t rl_study_name_failures(const struct rl_study *const *studies, size_t n, const char *database,
                              bool missing)
{
    struct rl_database *db;
    size_t named = 0;
    if (rl_database_open(&db, database, RL_DATABASE_READ, NULL) != RL_OK)
        return 0;
    for (size_t i = 0; i < n; i++) {
        struct rl_run run;
        if (rl_database_load_run(db, studies[i]->name, &run, NULL) != RL_OK)
            continue;
        for (size_t k = 0; k < run.n_records; k++)
            if (run.record[k].status == RL_RECORD_FAILED ||
                (missing && run.record[k].status == RL_RECORD_PLANNED)) {
                name_case(&run.record[k]);
                named++;
            }
        rl_run_clear(&run);
    }
    rl_database_close(db);
    return named;
}

/* A row each case of one study. */
static void print_forecast(struct rl_rows *rows, const struct rl_forecast *f)
{
    static const char *const state[] = {
        [RL_RECORD_PLANNED] = "open", [RL_RECORD_OK] = "done", [RL_RECORD_FAILED] = "failed"};
    for (size_t i = 0; i < f->planned->run.n_records; i++) {
        const struct rl_record *r = &f->planned->run.record[i];
        const struct rl_forecast_entry *entry = &f->entry[i];
        if (!entry->wanted)
            continue;
        rl_rows_text(rows, r->study);
        rl_rows_text(rows, r->scene);
        rl_rows_text(rows, r->parameters);
        rl_rows_integer(rows, r->group);
        rl_rows_text(rows, state[entry->state]);
        rl_rows_text(rows, entry->open ? "yes" : "no");
        rl_rows_number(rows, entry->group_seconds);
        rl_rows_text(rows, rl_forecast_source_name(entry->source));
        rl_rows_text(rows, r->identity);
    }
}

/* A guess, so no more than two digits of what is short. */
static void print_guess(char *text, size_t size, double seconds)
{
    if (seconds < 10.0)
        snprintf(text, size, "%.2g s", seconds);
    else
        rl_console_time(text, size, seconds);
}

/* "36 cases, 12 to be measured in 3 groups: about 20 s; not measured here yet", and what is not in that sum. */
static void print_sum(const struct rl_forecast *sum)
{
    char all[32], first[32];
    print_guess(all, sizeof all, sum->seconds);
    print_guess(first, sizeof first, sum->seconds_first);
    fprintf(stderr, "dry run: %zu cases, %zu to be measured in %zu groups", sum->n_wanted, sum->n_open,
            sum->groups_open);
    if (sum->groups_open > sum->groups_unknown)
        fprintf(stderr, ": about %s", all);
    if (sum->groups_first > 0 && sum->groups_first + sum->groups_unknown == sum->groups_open)
        fprintf(stderr, "; not measured here yet");
    else if (sum->groups_first > 0)
        fprintf(stderr, ", %s of it in groups unlike any measured here yet (%zu)", first, sum->groups_first);
    if (sum->groups_unknown > 0)
        fprintf(stderr, "%s the time of %zu groups is unknown (nothing like them was measured)",
                sum->groups_open > sum->groups_unknown ? ", and" : ":", sum->groups_unknown);
    fprintf(stderr, "\n");
}

static int dry_run(const struct request *r, enum rl_output format, struct rl_error *error)
{
    static const char *const column[] = {"study",   "scene",         "parameters",   "group",    "state",
                                         "measure", "group_seconds", "seconds_from", "identity", NULL};
    struct rl_bench bench = {0};
    struct rl_rows rows;
    struct rl_forecast sum = {0};
    int status = rl_bench_open(&bench, r->run.backend, r->run.threads, r->run.cache, NULL, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    for (size_t i = 0; i < r->n_studies && status == RL_OK; i++) {
        struct rl_forecast f;
        status = rl_forecast_make(&f, r->study[i], &r->run, &bench.provenance, error);
        if (status != RL_OK)
            break;
        if (i == 0)
            rl_rows_begin(&rows, format, column);
        print_forecast(&rows, &f);
        sum.n_wanted += f.n_wanted;
        sum.n_open += f.n_open;
        sum.groups_open += f.groups_open;
        sum.groups_unknown += f.groups_unknown;
        sum.groups_first += f.groups_first;
        sum.seconds += f.seconds;
        sum.seconds_first += f.seconds_first;
        rl_forecast_clear(&f);
    }
    rl_bench_close(&bench);
    if (status != RL_OK)
        return rl_exit_of(status);
    rl_rows_end(&rows);
    status = rl_output_check(error);
    if (status == RL_OK)
        print_sum(&sum);
    return rl_exit_of(status);
}

static int carry_out(const struct request *r, struct rl_error *error)
{
    struct rl_console console;
    const struct rl_progress *progress = rl_console_begin(&console);
    struct rl_run_outcome outcome;
    int status = rl_studies_run(&outcome, r->study, r->n_studies, &r->run, progress, error);
    rl_console_end(&console);
    if (status == RL_OK || status == RL_ERR_CANCELLED)
        fprintf(stderr, "%zu cases: %zu measured, %zu done before, %zu failed\n", outcome.planned,
                outcome.measured, outcome.skipped, outcome.failed);
    if (status == RL_OK || status == RL_ERR_CANCELLED) {
        char spent[256];
        rl_spent_text(spent, sizeof spent, outcome.seconds);
        fprintf(stderr, "%s\n", spent);
    }
    if (outcome.failed > 0)
        rl_study_name_failures(r->study, r->n_studies, r->run.database, false);
    return status == RL_OK && outcome.failed > 0 ? RL_EXIT_PARTIAL : rl_exit_of(status);
}

int rl_study_run_command(const struct rl_arguments *a, struct rl_error *error)
{
    struct request *request = calloc(1, sizeof *request);
    if (!request)
        return rl_exit_of(rl_fail_memory(error, "the options"));
    int status = take_studies(request, a, error);
    if (status == RL_OK)
        status = take_options(request, a, error);
    enum rl_output format = RL_OUTPUT_TSV;
    if (status == RL_OK)
        status = rl_argument_output(a, &format, error);
    int code = rl_exit_of(status);
    if (status == RL_OK)
        code = rl_argument_flag(a, "dry-run") ? dry_run(request, format, error) : carry_out(request, error);
    free(request);
    return code;
}
