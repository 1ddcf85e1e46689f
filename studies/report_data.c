/* Loads the latest runs, judges them, writes their tables (see report.h). */
#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "results/database.h"
#include "results/trace.h"
#include "studies/report.h"
#include "studies/study.h"

/* Moves the claims without a number, from the first of a study's on, to those of no table. */
static int set_apart(struct rl_report_data *data, size_t first, const struct rl_run *run,
                     struct rl_error *error)
{
    int status = RL_OK;
    size_t kept = first;
    for (size_t i = first; i < data->claims.n; i++) {
        const struct rl_claim c = data->claims.claim[i];
        struct rl_claim *apart = isnan(c.value) ? rl_claims_add(&data->without, error) : NULL;
        if (apart) {
            *apart = c;
            if (c.note[0] == '\0')
                snprintf(apart->note, sizeof apart->note, "no case of the grid %.200s measures it",
                         run->grid);
            continue;
        }
        status = isnan(c.value) ? RL_ERR_SYSTEM : status;
        data->claims.claim[kept++] = c;
    }
    data->claims.n = kept;
    return status;
}

static int judge(struct rl_report_data *data, const struct rl_study *study, struct rl_run *run,
                 struct rl_error *error)
{
    size_t first = data->claims.n;
    int status = rl_trace_begin(&data->claims, run, error);
    if (status == RL_OK)
        status = study->judge(&data->claims, run, error);
    int ended = rl_trace_end(&data->claims, status == RL_OK ? error : NULL);
    status = status == RL_OK ? ended : status;
    /* Where all that was planned is measured, to run it again would change nothing. */
    bool complete = rl_run_count(run, RL_RECORD_OK) == run->n_records;
    return status == RL_OK && complete ? set_apart(data, first, run, error) : status;
}

int rl_report_load(struct rl_report_data *data, const char *path, struct rl_error *error)
{
    *data = (struct rl_report_data){.run = calloc(rl_n_studies, sizeof *data->run),
                                    .derived = calloc(rl_n_studies, sizeof *data->derived)};
    if (!data->run || !data->derived) {
        rl_report_clear(data);
        return rl_fail_memory(error, "the studies' runs");
    }
    struct rl_database *db;
    int status = rl_database_open(&db, path, RL_DATABASE_READ, error);
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++)
        status = rl_database_load_run(db, rl_studies[i]->name, &data->run[i], error);
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++)
        if (data->run[i].n_records > 0)
            status = judge(data, rl_studies[i], &data->run[i], error);
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++)
        if (data->run[i].n_records > 0 && rl_studies[i]->derive)
            status = rl_studies[i]->derive(&data->derived[i], &data->run[i], error);
    rl_database_close(db);
    if (status != RL_OK)
        rl_report_clear(data);
    return status;
}

void rl_report_clear(struct rl_report_data *data)
{
    for (size_t i = 0; data->run && i < rl_n_studies; i++)
        rl_run_clear(&data->run[i]);
    for (size_t i = 0; data->derived && i < rl_n_studies; i++)
        rl_run_clear(&data->derived[i]);
    free(data->run);
    free(data->derived);
    rl_claims_clear(&data->claims);
    rl_claims_clear(&data->without);
    *data = (struct rl_report_data){0};
}

static int write_table(struct rl_buffer *text, const char *folder, const char *name,
                       enum rl_export_format format, struct rl_error *error)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/%s%s", folder, name, rl_export_ending(format));
    int status = rl_buffer_write(text, path, error);
    rl_buffer_clear(text);
    return status;
}

/* What an earlier export left there would be taken for this one's. */
static void remove_tables(const struct rl_table *tables, size_t n, const char *folder,
                          enum rl_export_format format)
{
    char path[PATH_MAX];
    for (size_t t = 0; t < n; t++) {
        snprintf(path, sizeof path, "%s/%s%s", folder, tables[t].name, rl_export_ending(format));
        remove(path);
    }
}

static int write_tables(const struct rl_table *tables, size_t n, const struct rl_run *run, const char *folder,
                        enum rl_export_format format, struct rl_error *error)
{
    struct rl_buffer text = {0};
    int status = RL_OK;
    for (size_t t = 0; t < n && status == RL_OK; t++) {
        rl_export_run(&text, &tables[t], run, format);
        status = write_table(&text, folder, tables[t].name, format, error);
    }
    return status;
}

/* Where the time of every group went, by its first case (runner.h). */
static void export_spent(struct rl_buffer *out, const struct rl_run *runs, size_t n_runs,
                         enum rl_export_format format)
{
    static const char *const column[] = {"study",       "scene",   "parameters",  "measured_s",
                                         "reference_s", "setup_s", "evaluation_s"};
    struct rl_export t;
    rl_export_begin(&t, out, format, column, sizeof column / sizeof column[0]);
    for (size_t k = 0; k < n_runs; k++)
        for (const struct rl_record *r = NULL; (r = rl_run_next(&runs[k], r, NULL, ""));) {
            if (!rl_record_metric(r, "spent_measured"))
                continue;
            rl_export_text(&t, r->study);
            rl_export_text(&t, r->scene);
            rl_export_text(&t, r->parameters);
            for (int kind = 0; kind < RL_SPENT_HARNESS; kind++) {
                char name[RL_NAME_MAX];
                snprintf(name, sizeof name, "spent_%s", rl_spent_name((enum rl_spent_kind)kind));
                const struct rl_metric *m = rl_record_metric(r, name);
                rl_export_number(&t, m ? m->value : NAN);
            }
        }
    rl_export_end(&t);
}

static void export_origin(struct rl_export *t, const struct rl_provenance *p)
{
    const char *const text[] = {p->version, p->commit, p->dirty ? "1" : "0", p->code_hash, p->compiler,
                                p->cflags,  p->cpu,    p->backend,           p->renderer,  p->gl_version,
                                p->os};
    for (size_t i = 0; i < sizeof text / sizeof text[0]; i++)
        rl_export_text(t, text[i]);
    rl_export_number(t, p->threads);
}

static const char *hash_of(const struct rl_run *run, const char *scene)
{
    size_t i = 0;
    while (strcmp(run->record[i].scene, scene) != 0)
        i++;
    return run->record[i].scene_hash;
}

/* What measured each study's cases of each scene. */
static void export_provenance(struct rl_buffer *out, const struct rl_run *runs, size_t n_runs,
                              enum rl_export_format format)
{
    static const char *const column[] = {"study",      "scene",   "scene_hash", "grid",    "started",
                                         "measured",   "version", "commit",     "dirty",   "code_hash",
                                         "compiler",   "cflags",  "cpu",        "backend", "renderer",
                                         "gl_version", "os",      "threads"};
    struct rl_export t;
    rl_export_begin(&t, out, format, column, sizeof column / sizeof column[0]);
    for (size_t k = 0; k < n_runs; k++) {
        const char *scene;
        for (size_t i = 0; (scene = rl_run_scene(&runs[k], i)); i++) {
            size_t measured = 0;
            for (const struct rl_record *r = NULL; (r = rl_run_next(&runs[k], r, scene, ""));)
                measured++;
            rl_export_text(&t, runs[k].study);
            rl_export_text(&t, scene);
            rl_export_text(&t, hash_of(&runs[k], scene));
            rl_export_text(&t, runs[k].grid);
            rl_export_text(&t, runs[k].started);
            rl_export_number(&t, (double)measured);
            export_origin(&t, &runs[k].provenance);
        }
    }
    rl_export_end(&t);
}

int rl_report_export(const struct rl_report_data *data, const char *folder, enum rl_export_format format,
                     struct rl_error *error)
{
    struct rl_buffer text = {0};
    int status = rl_directory_create(folder, error);
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++) {
        const struct rl_study *s = rl_studies[i];
        if (rl_run_count(&data->run[i], RL_RECORD_OK) == 0) {
            remove_tables(s->tables, s->n_tables, folder, format);
            remove_tables(s->derived_tables, s->n_derived_tables, folder, format);
            continue;
        }
        status = write_tables(s->tables, s->n_tables, &data->run[i], folder, format, error);
        if (status == RL_OK)
            status = write_tables(s->derived_tables, s->n_derived_tables, &data->derived[i], folder, format,
                                  error);
    }
    if (status == RL_OK) {
        rl_export_samples(&text, data->run, rl_n_studies, format);
        status = write_table(&text, folder, "frame_times", format, error);
    }
    if (status == RL_OK) {
        export_spent(&text, data->run, rl_n_studies, format);
        status = write_table(&text, folder, "spent", format, error);
    }
    if (status == RL_OK) {
        export_provenance(&text, data->run, rl_n_studies, format);
        status = write_table(&text, folder, "provenance", format, error);
    }
    if (status == RL_OK) {
        rl_claims_export(&text, &data->claims, format);
        status = write_table(&text, folder, "claims", format, error);
    }
    return status;
}

int rl_report_export_raw(const struct rl_report_data *data, const char *folder, struct rl_error *error)
{
    struct rl_buffer text = {0};
    int status = RL_OK;
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++) {
        char name[RL_NAME_MAX + 8];
        if (data->run[i].n_records == 0)
            continue;
        snprintf(name, sizeof name, "%s_raw", rl_studies[i]->name);
        rl_export_samples(&text, &data->run[i], 1, RL_EXPORT_TSV);
        status = write_table(&text, folder, name, RL_EXPORT_TSV, error);
    }
    return status;
}
