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

/* In the order of the verbs below. */
enum { LIST = 1, RUN = 2, STATUS = 4, EXPORT = 8, MERGE = 16, REPORT = 32, CHECK = 64 };

static const struct rl_verb_option options[] = {
    {RUN, {0, "db", "FILE", "results database, made if need be (build/results.db)"}},
    {STATUS | EXPORT | REPORT, {0, "db", "FILE", "results database (build/results.db)"}},
    {RUN,
     {0, "scene", "FILE",
      "scene file or name of a shipped scene; may be given several times (each study's own)"}},
    {CHECK,
     {0, "scene", "NAME", "only cases of this one; none: those without; may be given several times (all)"}},
    {RUN, {0, "quick", NULL, "a small grid, seconds: to see that all works"}},
    {RUN, {0, "full", NULL, "the full grid, as long as it takes"}},
    {RUN,
     {0, "axis", "NAME=VALUES",
      "other values of a parameter of the cases: rr=1,2,4 or rr=1:100:log9 or rr=0:1:lin5; several: every "
      "combination"}},
    {RUN,
     {0, "dry-run", NULL, "list the cases and the time they may take; nothing is measured, nothing written"}},
    {RUN, {0, "retry", NULL, "measure failed cases again"}},
    {RUN, {0, "again", NULL, "measure all cases again, done or not"}},
    {RUN, {0, "shard", "I/N", "measure the I-th of N shares only, the same on every machine"}},
    {MERGE,
     {0, "study", "NAME", "name the cases of this study that no file has; may be given several times"}},
    {MERGE, {0, "allow-mixed", NULL, "take together what different versions, renderers or scenes gave"}},
    {CHECK, {0, "baseline", "FILE", "what metrics are held against (tests/baseline.tsv)"}},
    {CHECK, {0, "write", "FILE", "measure a new baseline into this file"}},
    {CHECK, {0, "seeds", "N", "pictures and maps of each random metric, even, 4 to 1024 (16; --write: 256)"}},
    {CHECK, {0, "seed", "S", "the first of them (1000001; --write: 1)"}},
    {CHECK, {0, "runs", "N", "N checks, each with other seeds: do they raise false alarms?"}},
    {RUN | REPORT | CHECK,
     {0, "backend", "NAME", "auto, osmesa, egl, egl-surfaceless, egl-device ($ROUGHLIGHT_BACKEND, auto)"}},
    {RUN | REPORT | CHECK,
     {0, "threads", "N", "of the reference and of Mesa's llvmpipe ($ROUGHLIGHT_THREADS, all)"}},
    {RUN, {0, "format", "tsv|json", "how the rows of --dry-run are printed (tsv)"}},
    {LIST | STATUS | CHECK, {0, "format", "tsv|json", "how rows are printed (tsv)"}},
    {EXPORT, {0, "format", "tsv|json|csv", "of the files (tsv)"}},
    {EXPORT, {'o', "output", "DIR", "where to write, made if need be (build/tables)"}},
    {REPORT, {'o', "output", "DIR", "where to write, made if need be (build/report)"}},
    {0},
};

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
    if (status == RL_OK && data.without.n > 0)
        fprintf(
            stderr,
            "study export: what was measured has no number for %zu claims, which are not in claims%s; the "
            "report's pages list them\n",
            data.without.n, rl_export_ending(format));
    rl_report_clear(&data);
    return rl_exit_of(status);
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

static const struct rl_verb verbs[] = {
    {.name = "list",
     .arguments = "[--format tsv|json]",
     .summary = "what there is to run",
     .description = "Prints a row each study: name, what it measures, its scenes, and the parameters that "
                    "`study run --axis` may sweep.\n\n"
                    "  roughlight study list\n"
                    "  roughlight study list --format json",
     .run = list},
    {.name = "run",
     .arguments = "NAME... [options]",
     .max_positionals = RL_CLI_POSITIONALS_MAX,
     .summary = "measure studies into a database; what is there is not measured again",
     .description =
         "Measures the cases of the studies named. Those that the database has already are left alone. A run "
         "may be\n"
         "interrupted (Ctrl-C) or killed and goes on where it was when started again. Exit code 3: some "
         "cases failed;\n"
         "each is named, and left alone until --retry.\n\n"
         "  roughlight study run samples fps --quick --db quick.db\n"
         "  roughlight study run samples --scene my-scene.yaml --full --dry-run\n\n"
         "Other values than the study's own: --axis, of the parameters that are listed below. Values are "
         "checked before\n"
         "anything is measured.\n\n"
         "  roughlight study run samples --quick --axis rr=1:1000:log4 --axis samples=1,4,16\n\n"
         "On two machines, then together:\n\n"
         "  roughlight study run samples --full --shard 1/2 --db 1.db          (and 2/2 --db 2.db)\n"
         "  roughlight study merge all.db 1.db 2.db --study samples",
     .more_help = rl_study_print_axes,
     .run = rl_study_run_command},
    {.name = "status",
     .arguments = "[options]",
     .summary = "by study and scene: how many cases are measured, failed (and why) and open",
     .description =
         "Prints a row each study and scene, of the study's latest run: planned, measured, failed, open, and "
         "why cases\n"
         "failed. May be used while a run is at work.\n\n"
         "  roughlight study status --db quick.db",
     .run = rl_study_status_command},
    {.name = "export",
     .arguments = "[options]",
     .summary = "a file for each study's table, for raw figures, provenance and claims",
     .description = "Writes what a database holds as tables, a file each: .tsv, .json or .csv.\n\n"
                    "  roughlight study export --db quick.db -o tables\n"
                    "  roughlight study export --db quick.db -o tables --format csv",
     .more_help = rl_study_print_tables,
     .run = export_tables},
    {.name = "merge",
     .arguments = "INTO FROM... [options]",
     .min_positionals = 2,
     .max_positionals = RL_CLI_POSITIONALS_MAX,
     .summary = "put the results of other databases into one",
     .description =
         "Copies what the databases FROM hold into INTO. Nothing measured there is replaced, nothing is "
         "copied twice.\n"
         "Refuses what different versions, sources or renderers measured, or scenes that differ, unless "
         "--allow-mixed.\n"
         "With --study it names what no file has. Exit code 3: a case is missing, failed, or was measured "
         "twice with\n"
         "different results (the first is kept).\n\n"
         "  roughlight study merge all.db 1.db 2.db --study samples",
     .run = rl_study_merge_command},
    {.name = "report",
     .arguments = "[options]",
     .summary = "the pages with verdicts, pictures, plots and tables",
     .description = "Writes index.html, with a row each claim, and a page each study of the database.\n\n"
                    "  roughlight study report --db quick.db -o quick-report",
     .run = make_report},
    {.name = "check",
     .arguments = "[options]",
     .summary = "has an error metric changed since a baseline? exit code 1 if one is worse",
     .description =
         "Measures a small fixed set of cases and holds every error metric against a baseline; needs no "
         "database. Each\n"
         "is same, better, worse, inconclusive (more --seeds would tell) or incomparable; a row each. Exit "
         "code 1: one is\n"
         "worse; 3: a case failed. Seeds below 1024 are the baseline's. --runs counts false alarms, which "
         "have a\n"
         "probability of 1e-4 a run.\n\n"
         "  roughlight study check >check.tsv\n"
         "  roughlight study check --scene none --scene teapot-star\n"
         "  roughlight study check --write tests/baseline.tsv               (after a change that was meant)",
     .run = rl_study_check_command},
    {0},
};

const struct rl_command rl_command_study = {
    .name = "study",
    .arguments = "VERB [arguments] [options]",
    .summary = "run studies into a database; export their tables; make the report",
    .description =
        "Studies measure, over grids of cases, what each approximation costs in error and in time; "
        "verdicts on claims\n"
        "are computed from their figures.\n\n"
        "  roughlight study run samples fps --quick --db quick.db\n"
        "  roughlight study report --db quick.db -o quick-report",
    .verbs = verbs,
    .verb_options = options,
};
