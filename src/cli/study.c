/* `roughlight study`: runs studies, shows how far they are, exports their tables, makes the report. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/console.h"
#include "cli/output.h"
#include "cli/render_options.h"
#include "results/database.h"
#include "studies/report.h"
#include "studies/runner.h"
#include "studies/study.h"

static const struct rl_option study_options[] = {
    {0, "db", "FILE", "results database (build/results.db)"},
    {0, "scene", "FILE",
     "run: scene file or name of a shipped scene; may be given several times (each study's own)"},
    {0, "quick", NULL, "run: a small grid, seconds: to see that all works"},
    {0, "full", NULL, "run: the full grid, as long as it takes"},
    {0, "backend", "NAME",
     "run, report: auto, osmesa, egl, egl-surfaceless, egl-device ($ROUGHLIGHT_BACKEND, auto)"},
    {0, "threads", "N", "run, report: of the reference and of Mesa's llvmpipe ($ROUGHLIGHT_THREADS, all)"},
    {'o', "output", "DIR", "export, report: where to write (build/tables, build/report)"},
    {0},
};

static const struct rl_option *const options[] = {study_options, rl_options_format, NULL};

static const char *database_of(const struct rl_arguments *a)
{
    const char *path = rl_argument(a, "db");
    return path ? path : "build/results.db";
}

/* References are kept beside the database. */
static void cache_of(char cache[PATH_MAX], const struct rl_arguments *a)
{
    const char *path = database_of(a), *slash = strrchr(path, '/');
    snprintf(cache, PATH_MAX, "%.*scache", slash ? (int)(slash + 1 - path) : 0, path);
}

static int list(const struct rl_arguments *a, struct rl_error *error)
{
    enum rl_output format;
    int status = rl_argument_output(a, &format, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    struct rl_rows rows;
    rl_rows_begin(&rows, format, (const char *[]){"study", "summary", "scenes", NULL});
    for (size_t i = 0; i < rl_n_studies; i++) {
        char scenes[256] = "";
        for (const char *const *s = rl_studies[i]->scenes; *s; s++) {
            size_t used = strlen(scenes);
            snprintf(scenes + used, sizeof scenes - used, "%s%s", used ? " " : "", *s);
        }
        rl_rows_text(&rows, rl_studies[i]->name);
        rl_rows_text(&rows, rl_studies[i]->summary);
        rl_rows_text(&rows, scenes);
    }
    rl_rows_end(&rows);
    return rl_exit_of(rl_output_check(error));
}

/* The studies named after `run`. */
static int take_studies(const struct rl_study *studies[], size_t *n, const struct rl_arguments *a,
                        struct rl_error *error)
{
    *n = a->n_positionals - 1;
    if (*n == 0)
        return rl_fail(error, RL_ERR_INPUT, "study run: no study named; 'roughlight study list' lists them");
    for (size_t i = 0; i < *n; i++) {
        studies[i] = rl_study_find(a->positional[i + 1]);
        if (!studies[i])
            return rl_fail(error, RL_ERR_INPUT,
                           "study run: there is no study '%s'; 'roughlight study list' lists them",
                           a->positional[i + 1]);
    }
    return RL_OK;
}

static int take_run_options(struct rl_run_options *run, const char *scenes[], const struct rl_arguments *a,
                            struct rl_error *error)
{
    bool quick = rl_argument_flag(a, "quick"), full = rl_argument_flag(a, "full");
    if (quick && full)
        return rl_fail(error, RL_ERR_INPUT, "--quick and --full: one of them, not both");
    run->database = database_of(a);
    run->backend = rl_argument_backend(a);
    run->grid = quick ? RL_GRID_QUICK : full ? RL_GRID_FULL : RL_GRID_DEFAULT;
    while (run->n_scenes < RL_CLI_GIVEN_MAX && rl_argument_nth(a, "scene", run->n_scenes)) {
        scenes[run->n_scenes] = rl_argument_nth(a, "scene", run->n_scenes);
        run->n_scenes++;
    }
    run->scenes = scenes;
    return rl_argument_threads(a, &run->threads, error);
}

/* Each case of these studies that failed, a line each. */
static void name_failures(const struct rl_study *const *studies, size_t n, const char *database)
{
    struct rl_database *db;
    if (rl_database_open(&db, database, RL_DATABASE_READ, NULL) != RL_OK)
        return;
    for (size_t i = 0; i < n; i++) {
        struct rl_run run;
        if (rl_database_load_run(db, studies[i]->name, &run, NULL) != RL_OK)
            continue;
        for (size_t k = 0; k < run.n_records; k++)
            if (run.record[k].status == RL_RECORD_FAILED)
                fprintf(stderr, "roughlight: failed: %s %s %s: %s\n", run.study, run.record[k].scene,
                        run.record[k].parameters, run.record[k].message);
        rl_run_clear(&run);
    }
    rl_database_close(db);
}

static int run_studies(const struct rl_arguments *a, struct rl_error *error)
{
    const struct rl_study *studies[RL_CLI_POSITIONALS_MAX];
    const char *scenes[RL_CLI_GIVEN_MAX];
    struct rl_run_options run = {0};
    size_t n = 0;
    int status = take_studies(studies, &n, a, error);
    if (status == RL_OK)
        status = take_run_options(&run, scenes, a, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    char cache[PATH_MAX];
    cache_of(cache, a);
    run.cache = cache;
    struct rl_console console;
    const struct rl_progress *progress = rl_console_begin(&console);
    struct rl_run_outcome outcome;
    status = rl_studies_run(&outcome, studies, n, &run, progress, error);
    rl_console_end(&console);
    if (status == RL_OK || status == RL_ERR_CANCELLED)
        fprintf(stderr, "%zu cases: %zu measured, %zu done before, %zu failed\n", outcome.planned,
                outcome.measured, outcome.skipped, outcome.failed);
    if (outcome.failed > 0)
        name_failures(studies, n, run.database);
    return status == RL_OK && outcome.failed > 0 ? RL_EXIT_PARTIAL : rl_exit_of(status);
}

static int show_status(const struct rl_arguments *a, struct rl_error *error)
{
    enum rl_output format;
    struct rl_database *db = NULL;
    int status = rl_argument_output(a, &format, error);
    if (status == RL_OK)
        status = rl_database_open(&db, database_of(a), RL_DATABASE_READ, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    struct rl_rows rows;
    rl_rows_begin(&rows, format,
                  (const char *[]){"study", "grid", "started", "planned", "measured", "failed", "commit",
                                   "renderer", NULL});
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++) {
        struct rl_run run;
        status = rl_database_load_run(db, rl_studies[i]->name, &run, error);
        if (status != RL_OK)
            break;
        rl_rows_text(&rows, run.study);
        rl_rows_text(&rows, run.grid);
        rl_rows_text(&rows, run.started);
        rl_rows_integer(&rows, (long long)run.n_records);
        rl_rows_integer(&rows, (long long)rl_run_count(&run, RL_RECORD_OK));
        rl_rows_integer(&rows, (long long)rl_run_count(&run, RL_RECORD_FAILED));
        rl_rows_text(&rows, run.provenance.commit);
        rl_rows_text(&rows, run.provenance.renderer);
        rl_run_clear(&run);
    }
    rl_rows_end(&rows);
    rl_database_close(db);
    return rl_exit_of(status == RL_OK ? rl_output_check(error) : status);
}

static int export_tables(const struct rl_arguments *a, struct rl_error *error)
{
    enum rl_output format;
    const char *folder = rl_argument(a, "output");
    struct rl_report_data data = {0};
    int status = rl_argument_output(a, &format, error);
    if (status == RL_OK)
        status = rl_report_load(&data, database_of(a), error);
    if (status == RL_OK)
        status = rl_report_export(&data, folder ? folder : "build/tables",
                                  format == RL_OUTPUT_JSON ? RL_EXPORT_JSON : RL_EXPORT_TSV, error);
    rl_report_clear(&data);
    return rl_exit_of(status);
}

static int make_report(const struct rl_arguments *a, struct rl_error *error)
{
    const char *folder = rl_argument(a, "output");
    char cache[PATH_MAX];
    cache_of(cache, a);
    struct rl_report_options report = {
        .database = database_of(a),
        .folder = folder ? folder : "build/report",
        .cache = cache,
        .backend = rl_argument_backend(a),
    };
    int status = rl_argument_threads(a, &report.threads, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    struct rl_console console;
    const struct rl_progress *progress = rl_console_begin(&console);
    status = rl_report_make(&report, progress, error);
    rl_console_end(&console);
    if (status == RL_OK)
        fprintf(stderr, "%s/index.html\n", report.folder);
    return rl_exit_of(status);
}

static int run(const struct rl_arguments *a, struct rl_error *error)
{
    static const struct {
        const char *name;
        bool takes_names;
        int (*run)(const struct rl_arguments *arguments, struct rl_error *error);
    } verbs[] = {
        {"list", false, list},          {"run", true, run_studies},
        {"status", false, show_status}, {"export", false, export_tables},
        {"report", false, make_report},
    };
    for (size_t i = 0; i < sizeof verbs / sizeof verbs[0]; i++) {
        if (strcmp(a->positional[0], verbs[i].name) != 0)
            continue;
        if (!verbs[i].takes_names && a->n_positionals > 1)
            return rl_exit_of(rl_fail(error, RL_ERR_INPUT, "study %s: unexpected argument '%s'",
                                      verbs[i].name, a->positional[1]));
        return verbs[i].run(a, error);
    }
    return rl_exit_of(rl_fail(error, RL_ERR_INPUT,
                              "study: found '%s', expected list, run, status, export or report",
                              a->positional[0]));
}

const struct rl_command rl_command_study = {
    .name = "study",
    .arguments = "list | run NAME... | status | export | report  [options]",
    .min_positionals = 1,
    .max_positionals = RL_CLI_POSITIONALS_MAX,
    .summary = "run studies into a database; export their tables; make the report",
    .description =
        "  list     what there is to run\n"
        "  run      measure the studies named; cases that the database has already are not measured again\n"
        "  status   how many cases of each study's latest run are measured\n"
        "  export   one table for each study, frame_times, and claims with their verdicts\n"
        "  report   the page with verdicts, pictures, plots and tables\n"
        "\n"
        "A run may be interrupted (Ctrl-C) and goes on where it was when started again. Exit code 3: some "
        "cases failed;\n"
        "each is named, and the next run tries it again.\n"
        "\n"
        "  roughlight study run samples fps --quick --db quick.db\n"
        "  roughlight study report --db quick.db -o quick-report",
    .options = options,
    .run = run,
};
