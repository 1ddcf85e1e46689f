/* `roughlight study`: runs studies, shows how far they are, exports their tables, makes the report. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/console.h"
#include "cli/output.h"
#include "cli/render_options.h"
#include "cli/study.h"
#include "studies/report.h"
#include "studies/study.h"

static const struct rl_option study_options[] = {
    {0, "db", "FILE", "results database (build/results.db)"},
    {0, "scene", "FILE",
     "run: scene file or name of a shipped scene; check: only cases of this one; may be given several times "
     "(each study's own; check: all)"},
    {0, "quick", NULL, "run: a small grid, seconds: to see that all works"},
    {0, "full", NULL, "run: the full grid, as long as it takes"},
    {0, "axis", "NAME=VALUES",
     "run: other values of a parameter of the cases: rr=1,2,4 or rr=1:100:log9 or rr=0:1:lin5; several: "
     "every combination"},
    {0, "dry-run", NULL,
     "run: list the cases and the time they may take; nothing is measured, nothing written"},
    {0, "retry", NULL, "run: measure failed cases again"},
    {0, "again", NULL, "run: measure all cases again, done or not"},
    {0, "shard", "I/N", "run: measure the I-th of N shares only, the same on every machine"},
    {0, "study", "NAME", "merge: name the cases of this study that no file has; may be given several times"},
    {0, "allow-mixed", NULL, "merge: take together what different versions, renderers or scenes gave"},
    {0, "baseline", "FILE", "check: what metrics are held against (tests/baseline.tsv)"},
    {0, "write", "FILE", "check: measure a new baseline into this file"},
    {0, "seeds", "N", "check: pictures and maps of each random metric, even, 4 to 1024 (16; --write: 256)"},
    {0, "seed", "S", "check: the first of them (1000001; --write: 1)"},
    {0, "runs", "N", "check: N checks, each with other seeds: do they raise false alarms?"},
    {0, "backend", "NAME",
     "run, report, check: auto, osmesa, egl, egl-surfaceless, egl-device ($ROUGHLIGHT_BACKEND, auto)"},
    {0, "threads", "N",
     "run, report, check: of the reference and of Mesa's llvmpipe ($ROUGHLIGHT_THREADS, all)"},
    {0, "format", "tsv|json|csv",
     "how rows are printed, and the tables of export written; csv: export only (tsv)"},
    {'o', "output", "DIR", "export, report: where to write (build/tables, build/report)"},
    {0},
};

static const struct rl_option *const options[] = {study_options, NULL};

const char *rl_study_database(const struct rl_arguments *a)
{
    const char *path = rl_argument(a, "db");
    return path ? path : "build/results.db";
}

void rl_study_cache(char cache[PATH_MAX], const struct rl_arguments *a)
{
    const char *path = rl_study_database(a), *slash = strrchr(path, '/');
    snprintf(cache, PATH_MAX, "%.*scache", slash ? (int)(slash + 1 - path) : 0, path);
}

static int list(const struct rl_arguments *a, struct rl_error *error)
{
    enum rl_output format;
    int status = rl_argument_output(a, &format, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    struct rl_rows rows;
    rl_rows_begin(&rows, format, (const char *[]){"study", "summary", "scenes", "axes", NULL});
    for (size_t i = 0; i < rl_n_studies; i++) {
        char scenes[256] = "";
        for (const char *const *s = rl_studies[i]->scenes; *s; s++) {
            size_t used = strlen(scenes);
            snprintf(scenes + used, sizeof scenes - used, "%s%s", used ? " " : "", *s);
        }
        rl_rows_text(&rows, rl_studies[i]->name);
        rl_rows_text(&rows, rl_studies[i]->summary);
        rl_rows_text(&rows, scenes);
        char axes[256];
        rl_sweep_names(axes, sizeof axes, rl_studies[i]->sweeps.sweep, rl_studies[i]->sweeps.n);
        rl_rows_text(&rows, axes);
    }
    rl_rows_end(&rows);
    return rl_exit_of(rl_output_check(error));
}

static int take_export_format(enum rl_export_format *format, const struct rl_arguments *a,
                              struct rl_error *error)
{
    static const enum rl_export_format formats[] = {RL_EXPORT_TSV, RL_EXPORT_JSON, RL_EXPORT_CSV};
    const char *text = rl_argument(a, "format");
    *format = RL_EXPORT_TSV;
    for (size_t i = 0; text && i < sizeof formats / sizeof formats[0]; i++) {
        *format = formats[i];
        if (strcmp(text, rl_export_ending(formats[i]) + 1) == 0)
            return RL_OK;
    }
    return text ? rl_fail(error, RL_ERR_INPUT, "--format: found '%s', expected tsv, json or csv", text)
                : RL_OK;
}

static int export_tables(const struct rl_arguments *a, struct rl_error *error)
{
    enum rl_export_format format;
    const char *folder = rl_argument(a, "output");
    struct rl_report_data data = {0};
    int status = take_export_format(&format, a, error);
    if (status == RL_OK)
        status = rl_report_load(&data, rl_study_database(a), error);
    if (status == RL_OK)
        status = rl_report_export(&data, folder ? folder : "build/tables", format, error);
    rl_report_clear(&data);
    return rl_exit_of(status);
}

/* The columns of a table that export writes, wrapped; of one of cases, identity is the last. */
static void print_columns(const char *name, const char *summary, const struct rl_column *column, size_t n,
                          bool cases)
{
    printf("  %s: %s\n     ", name, summary);
    size_t used = 5;
    for (size_t i = 0; i < n; i++) {
        size_t length = strlen(column[i].name) + 1;
        if (used + length > 110) {
            printf("\n     ");
            used = 5;
        }
        printf(" %s", column[i].name);
        used += length;
    }
    printf("%s%s\n", cases ? " " : "", cases ? rl_identity_column : "");
}

static void print_each(const struct rl_table *tables, size_t n)
{
    for (size_t t = 0; t < n; t++)
        print_columns(tables[t].name, tables[t].summary, tables[t].column, tables[t].n_columns, true);
}

/* What --axis takes, study by study. */
static void print_axes(void)
{
    printf(
        "\nWhat --axis may replace, of which cases, by what. Whatever tells a study's cases apart stays.\n");
    for (size_t i = 0; i < rl_n_studies; i++) {
        const struct rl_sweeps *sweeps = &rl_studies[i]->sweeps;
        printf("\n  %s\n", rl_studies[i]->name);
        for (size_t k = 0; k < sweeps->n; k++) {
            char values[256];
            rl_sweep_values(values, sizeof values, &sweeps->sweep[k]);
            printf("    %-13s%s%s%s%s\n", sweeps->sweep[k].name, values, sweeps->sweep[k].of ? " (of " : "",
                   sweeps->sweep[k].of ? sweeps->sweep[k].of : "", sweeps->sweep[k].of ? ")" : "");
        }
    }
}

static void print_tables(void)
{
    static const struct rl_column samples[] = {{.name = "study"},  {.name = "scene"}, {.name = "parameters"},
                                               {.name = "series"}, {.name = "index"}, {.name = "value"}};
    static const struct rl_column spent[] = {
        {.name = "study"},       {.name = "scene"},   {.name = "parameters"},  {.name = "measured_s"},
        {.name = "reference_s"}, {.name = "setup_s"}, {.name = "evaluation_s"}};
    static const struct rl_column provenance[] = {
        {.name = "study"},   {.name = "scene"},     {.name = "scene_hash"}, {.name = "grid"},
        {.name = "started"}, {.name = "measured"},  {.name = "version"},    {.name = "commit"},
        {.name = "dirty"},   {.name = "code_hash"}, {.name = "compiler"},   {.name = "cflags"},
        {.name = "cpu"},     {.name = "backend"},   {.name = "renderer"},   {.name = "gl_version"},
        {.name = "os"},      {.name = "threads"}};
    static const struct rl_column claims[] = {{.name = "claim"},  {.name = "verdict"}, {.name = "value"},
                                              {.name = "low"},    {.name = "high"},    {.name = "unit"},
                                              {.name = "study"},  {.name = "command"}, {.name = "scene"},
                                              {.name = "figure"}, {.name = "note"},    {.name = "cases"}};
    printf("\nThe tables of export; columns are added at times, none is renamed. NAME_low and NAME_high: the "
           "95 %% interval of "
           "NAME.\n_ms, _px: the unit; without: a pure number, of radiance 1 = full scale. nan (JSON: null): "
           "not measured.\n"
           "identity: the case, as `cases` of claims names those that a verdict comes from.\n"
           "studies/README.md says what each is.\n\n");
    for (size_t i = 0; i < rl_n_studies; i++) {
        print_each(rl_studies[i]->tables, rl_studies[i]->n_tables);
        print_each(rl_studies[i]->derived_tables, rl_studies[i]->n_derived_tables);
    }
    print_columns("frame_times", "every raw figure of every case, in the order taken", samples,
                  sizeof samples / sizeof samples[0], true);
    print_columns("spent", "where the time of every group of cases went, by its first case", spent,
                  sizeof spent / sizeof spent[0], false);
    print_columns("provenance", "what measured the cases of each study and scene: program, machine, renderer",
                  provenance, sizeof provenance / sizeof provenance[0], false);
    print_columns("claims", "every claim with its verdict and the command that reproduces it", claims,
                  sizeof claims / sizeof claims[0], false);
}

static void print_more(void)
{
    print_axes();
    print_tables();
}

static int make_report(const struct rl_arguments *a, struct rl_error *error)
{
    const char *folder = rl_argument(a, "output");
    char cache[PATH_MAX];
    rl_study_cache(cache, a);
    struct rl_report_options report = {
        .database = rl_study_database(a),
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
        {"list", false, list},
        {"run", true, rl_study_run_command},
        {"status", false, rl_study_status_command},
        {"export", false, export_tables},
        {"merge", true, rl_study_merge_command},
        {"report", false, make_report},
        {"check", false, rl_study_check_command},
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
                              "study: found '%s', expected list, run, status, export, merge, report or check",
                              a->positional[0]));
}

const struct rl_command rl_command_study = {
    .name = "study",
    .arguments = "list | run NAME... | status | export | merge INTO FROM... | report | check  [options]",
    .min_positionals = 1,
    .max_positionals = RL_CLI_POSITIONALS_MAX,
    .summary = "run studies into a database; export their tables; make the report",
    .description =
        "  list     what there is to run\n"
        "  run      measure the studies named; cases that the database has already are not measured again\n"
        "  status   of each study's latest run and scene, how many cases are measured, failed (and why) and "
        "open\n"
        "  export   a file for each study's table, for frame_times, for provenance and for claims with their "
        "verdicts: .tsv,\n"
        "           .json or .csv\n"
        "  merge    put the results of other databases into INTO; nothing measured there is replaced, "
        "nothing is copied twice\n"
        "  report   the page with verdicts, pictures, plots and tables\n"
        "  check    has any error metric changed? A small fixed set of cases against a baseline; exit code 1 "
        "if "
        "one is worse\n"
        "\n"
        "A run may be interrupted (Ctrl-C) or killed and goes on where it was when started again. Exit code "
        "3: some cases\n"
        "failed; each is named, and left alone until --retry.\n"
        "\n"
        "  roughlight study run samples fps --quick --db quick.db\n"
        "  roughlight study report --db quick.db -o quick-report\n"
        "\n"
        "Other values than the study's own: --axis, of the parameters that are listed below. Values are "
        "checked "
        "before anything is measured.\n"
        "\n"
        "  roughlight study run samples --quick --axis rr=1:1000:log4 --axis samples=1,4,16\n"
        "\n"
        "On two machines, then together. merge refuses what different versions, commits or renderers "
        "measured, or scenes\n"
        "that differ; with --study it names what no file has (exit code 3).\n"
        "\n"
        "  roughlight study run samples --full --shard 1/2 --db 1.db          (and 2/2 --db 2.db)\n"
        "  roughlight study merge all.db 1.db 2.db --study samples\n"
        "\n"
        "check needs no database. Each metric is same, better, worse, inconclusive (more --seeds would tell) "
        "or "
        "incomparable;\n"
        "seeds below 1024 are the baseline's. --runs counts false alarms, which have a probability of 1e-4 a "
        "run.\n"
        "\n"
        "  roughlight study check --baseline tests/baseline.tsv >check.tsv\n"
        "  roughlight study check --write tests/baseline.tsv               (after a change that was meant)",
    .options = options,
    .more_help = print_more,
    .run = run,
};
