/* Skips, measures and stores (see runner.h). */
#include "studies/runner.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "results/database.h"
#include "studies/eta.h"

/* Studies at work. */
struct work {
    const struct rl_run_options *options;
    const struct rl_progress *progress;
    struct rl_bench bench;
    struct rl_database *database;
    struct rl_run_outcome *outcome;
    size_t n_planned;
    struct rl_planned **planned;
    struct rl_eta eta;
    /* Of all studies. Progress is told in cases, since that is what the summary counts. */
    size_t cases_done, cases_pending;
};

/* One group, for a study: a case that was not measured, or whose measurement is asked for anew, is open and so is its group. */
static int group_state(struct work *w, const struct rl_run *run, size_t first, enum rl_record_status *state,
                       struct rl_error *error)
{
    *state = w->options->again ? RL_RECORD_PLANNED : RL_RECORD_OK;
    int status = RL_OK;
    for (size_t i = first; i < rl_group_end(run, first) && *state != RL_RECORD_PLANNED && status == RL_OK;
         i++) {
        enum rl_record_status each;
        status = rl_database_state(w->database, run->record[i].identity, &each, error);
        if (each == RL_RECORD_FAILED && w->options->retry)
            each = RL_RECORD_PLANNED;
        if (each != RL_RECORD_OK)
            *state = each;
    }
    return status;
}

/* What a group took, kept with its first case. The harness's own work on it is still to come. */
static int add_spent(struct rl_record *r, const double before[RL_SPENT_KINDS], const struct rl_spent *after,
                     struct rl_error *error)
{
    int status = RL_OK;
    for (int k = 0; k < RL_SPENT_HARNESS && status == RL_OK; k++) {
        char name[RL_NAME_MAX];
        double seconds = after->seconds[k] - before[k];
        snprintf(name, sizeof name, "spent_%s", rl_spent_name((enum rl_spent_kind)k));
        status = rl_record_add_exact(r, name, seconds, "s", error);
    }
    return status;
}

/* The study's own measuring, on its clock. */
static int measure_on_clock(struct work *w, struct rl_planned *p, struct rl_record *r, size_t n,
                            struct rl_error *error)
{
    struct rl_spent *spent = &w->bench.spent;
    double before[RL_SPENT_KINDS];
    memcpy(before, spent->seconds, sizeof before);
    rl_spent_on(spent, RL_SPENT_EVALUATION);
    int status = p->study->measure(r, n, &w->bench, rl_planned_scene(p, r), error);
    /* Whatever an error left the clock on. */
    rl_spent_on(spent, RL_SPENT_HARNESS);
    return status == RL_OK ? add_spent(r, before, spent, error) : status;
}

static int measure_group(struct work *w, struct rl_planned *p, size_t first, struct rl_error *error)
{
    struct rl_record *r = &p->run.record[first];
    size_t n = rl_group_end(&p->run, first) - first;
    double start = rl_clock_seconds();
    struct rl_error why = {0};
    int status = measure_on_clock(w, p, r, n, &why);
    if (status == RL_ERR_CANCELLED) {
        if (error)
            *error = why;
        return status;
    }
    for (size_t i = 0; i < n; i++) {
        r[i].seconds = rl_clock_seconds() - start;
        r[i].status = status == RL_OK ? RL_RECORD_OK : RL_RECORD_FAILED;
        if (status != RL_OK) {
            rl_record_reset(&r[i]);
            snprintf(r[i].message, sizeof r[i].message, "%.*s", (int)sizeof r[i].message - 1, why.message);
        }
    }
    *(status == RL_OK ? &w->outcome->measured : &w->outcome->failed) += n;
    return rl_database_store(w->database, &p->run, first, n, error);
}

/* Notes which groups of a study are to be measured, and counts their cases; of the others the outcome is known. */
static int look_ahead(struct work *w, const struct rl_run *run, size_t *pending, struct rl_error *error)
{
    struct rl_run times = {0};
    int status = rl_database_load_times(w->database, run->study, &times, error);
    for (size_t first = 0, end; first < run->n_records && status == RL_OK; first = end) {
        enum rl_record_status state = RL_RECORD_PLANNED;
        end = rl_group_end(run, first);
        if (!rl_group_wanted(run, first, w->options))
            continue;
        status = group_state(w, run, first, &state, error);
        w->outcome->planned += end - first;
        if (state != RL_RECORD_PLANNED) {
            *(state == RL_RECORD_OK ? &w->outcome->skipped : &w->outcome->failed) += end - first;
        } else if (status == RL_OK) {
            status = rl_eta_add(&w->eta, run, first, &times, error);
            *pending += end - first;
            w->cases_pending += end - first;
        }
    }
    rl_run_clear(&times);
    return status;
}

/* Of a group that need not be measured after all; returns by how many cases fewer are pending. */
static size_t drop(struct work *w, const struct rl_run *run, size_t first)
{
    size_t groups = w->eta.total;
    rl_eta_dropped(&w->eta, &run->record[first]);
    size_t n = w->eta.total < groups ? rl_group_end(run, first) - first : 0;
    w->cases_pending -= n;
    return n;
}

static void tell(struct work *w, const struct rl_planned *p, size_t finished, size_t pending)
{
    char what[RL_NAME_MAX + 16];
    snprintf(what, sizeof what, "%s: cases", p->study->name);
    rl_progress_overall(w->progress, w->cases_done, w->cases_pending, rl_eta_seconds(&w->eta));
    rl_progress_update(w->progress, what, finished, pending);
}

/* Measures what is open. Each group is looked up once more, just before: another study may have the same case. */
static int measure(struct work *w, struct rl_planned *p, size_t pending, struct rl_error *error)
{
    size_t finished = 0;
    int status = rl_database_begin_run(w->database, &p->run, error);
    for (size_t first = 0, end; first < p->run.n_records && status == RL_OK; first = end) {
        enum rl_record_status state = RL_RECORD_PLANNED;
        end = rl_group_end(&p->run, first);
        if (!rl_group_wanted(&p->run, first, w->options))
            continue;
        status = group_state(w, &p->run, first, &state, error);
        if (state != RL_RECORD_PLANNED)
            pending -= drop(w, &p->run, first);
        if (status != RL_OK || state != RL_RECORD_PLANNED)
            continue;
        if (rl_progress_cancelled(w->progress))
            return rl_fail(error, RL_ERR_CANCELLED, "interrupted; what was finished is kept");
        status = measure_group(w, p, first, error);
        if (status == RL_OK) {
            rl_eta_measured(&w->eta, &p->run.record[first]);
            finished += end - first;
            w->cases_done += end - first;
            tell(w, p, finished, pending);
        }
    }
    return status;
}

/* All studies are looked at before the first is measured: only so is it known how far it is to the end of the last. */
static int measure_all(struct work *w, struct rl_error *error)
{
    size_t *pending = calloc(w->n_planned + 1, sizeof *pending);
    int status = pending ? RL_OK : rl_fail_memory(error, "the studies' groups");
    for (size_t i = 0; i < w->n_planned && status == RL_OK; i++)
        status = look_ahead(w, &w->planned[i]->run, &pending[i], error);
    if (status == RL_OK && w->eta.total > 0)
        rl_progress_overall(w->progress, 0, w->cases_pending, rl_eta_seconds(&w->eta));
    for (size_t i = 0; i < w->n_planned && status == RL_OK; i++)
        status = measure(w, w->planned[i], pending[i], error);
    free(pending);
    return status;
}

static int plan(struct work *w, const struct rl_study *const *studies, size_t n_studies,
                struct rl_error *error)
{
    int status = RL_OK;
    w->planned = calloc(n_studies + 1, sizeof(struct rl_planned *));
    if (!w->planned)
        return rl_fail_memory(error, "the studies' cases");
    for (; w->n_planned < n_studies && status == RL_OK; w->n_planned++)
        status = rl_planned_make(&w->planned[w->n_planned], studies[w->n_planned], w->options,
                                 &w->bench.provenance, error);
    return status;
}

/* A folder that is new may be a misspelt one: whoever looks on is told before hours go into it. */
static int open_database(struct work *w, struct rl_error *error)
{
    char folder[PATH_MAX], text[PATH_MAX + 32];
    rl_database_missing_folder(folder, w->options->database);
    int status = rl_database_open(&w->database, w->options->database, RL_DATABASE_WRITE, error);
    if (status == RL_OK && folder[0]) {
        snprintf(text, sizeof text, "created the folder %s", folder);
        rl_progress_note(w->progress, text);
    }
    return status;
}

int rl_studies_run(struct rl_run_outcome *outcome, const struct rl_study *const *studies, size_t n_studies,
                   const struct rl_run_options *options, const struct rl_progress *progress,
                   struct rl_error *error)
{
    *outcome = (struct rl_run_outcome){0};
    struct work w = {.options = options, .progress = progress, .outcome = outcome};
    int status = rl_bench_open(&w.bench, options->backend, options->threads, options->cache, progress, error);
    if (status == RL_OK)
        status = plan(&w, studies, n_studies, error);
    /* Not before: a request that cannot be carried out leaves no file behind. */
    if (status == RL_OK)
        status = open_database(&w, error);
    if (status == RL_OK)
        status = measure_all(&w, error);
    rl_eta_clear(&w.eta);
    for (size_t i = 0; i < w.n_planned; i++)
        rl_planned_free(w.planned[i]);
    free(w.planned);
    rl_database_close(w.database);
    rl_spent_on(&w.bench.spent, RL_SPENT_HARNESS);
    memcpy(outcome->seconds, w.bench.spent.seconds, sizeof outcome->seconds);
    rl_bench_close(&w.bench);
    return status;
}
