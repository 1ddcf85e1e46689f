/* Plans, looks up, and guesses times (see forecast.h). */
#include "studies/forecast.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "results/database.h"

const char *rl_forecast_source_name(enum rl_forecast_source source)
{
    static const char *const name[] = {[RL_FORECAST_UNKNOWN] = "unknown",
                                       [RL_FORECAST_FIRST] = "first estimate",
                                       [RL_FORECAST_SIMILAR] = "similar case",
                                       [RL_FORECAST_SAME] = "same case"};
    return name[source];
}

void rl_forecast_clear(struct rl_forecast *f)
{
    rl_planned_free(f->planned);
    free(f->entry);
    *f = (struct rl_forecast){0};
}

/* In how many values two cases differ, or -1 if they have not the same parameters in the same order. */
static int distance(const struct rl_record *a, const struct rl_record *b)
{
    int n = strcmp(a->scene_hash, b->scene_hash) != 0;
    const char *p = a->parameters, *q = b->parameters;
    while (*p && *q) {
        size_t name = strcspn(p, "= "), length_p = strcspn(p, " "), length_q = strcspn(q, " ");
        if (name != strcspn(q, "= ") || strncmp(p, q, name) != 0)
            return -1;
        n += length_p != length_q || strncmp(p, q, length_p) != 0;
        p += length_p + strspn(p + length_p, " ");
        q += length_q + strspn(q + length_q, " ");
    }
    return *p || *q ? -1 : n;
}

static double pixels(const struct rl_record *r)
{
    double n = rl_parameter_number(r->parameters, "width") * rl_parameter_number(r->parameters, "height");
    return n > 0.0 ? n : 1.0;
}

int rl_forecast_scale(double *seconds, const struct rl_record *r, const struct rl_record *measured)
{
    *seconds = measured->seconds * pixels(r) / pixels(measured);
    return distance(r, measured);
}

int rl_forecast_guess(double *seconds, const struct rl_record *r, const struct rl_run *times)
{
    int nearest = -1;
    *seconds = NAN;
    for (size_t i = 0; times && i < times->n_records && nearest != 0; i++) {
        double scaled;
        int d = rl_forecast_scale(&scaled, r, &times->record[i]);
        if (d < 0 || (nearest >= 0 && d >= nearest))
            continue;
        nearest = d;
        *seconds = scaled;
    }
    return nearest;
}

double rl_forecast_first(const struct rl_run *run, size_t first)
{
    const struct rl_study *study = rl_study_find(run->study);
    if (!study)
        return NAN;
    return rl_cost_seconds(study->costs, study->n_costs, &run->record[first],
                           rl_group_end(run, first) - first);
}

/* What is measured counts, before what the study says. */
static void estimate(struct rl_forecast_entry *entry, const struct rl_run *run, size_t first,
                     const struct rl_run *times)
{
    int nearest = rl_forecast_guess(&entry->group_seconds, &run->record[first], times);
    entry->source = nearest == 0 ? RL_FORECAST_SAME : RL_FORECAST_SIMILAR;
    if (nearest >= 0)
        return;
    entry->group_seconds = rl_forecast_first(run, first);
    entry->source = isnan(entry->group_seconds) ? RL_FORECAST_UNKNOWN : RL_FORECAST_FIRST;
}

static void count_group(struct rl_forecast *f, const struct rl_forecast_entry *entry, size_t n)
{
    f->n_wanted += entry->wanted ? n : 0;
    if (!entry->open)
        return;
    f->n_open += n;
    f->groups_open++;
    f->groups_unknown += entry->source == RL_FORECAST_UNKNOWN;
    if (entry->source == RL_FORECAST_UNKNOWN)
        return;
    f->seconds += entry->group_seconds;
    f->groups_first += entry->source == RL_FORECAST_FIRST;
    f->seconds_first += entry->source == RL_FORECAST_FIRST ? entry->group_seconds : 0.0;
}

/* As the runner decides it. */
static bool is_open(const struct rl_forecast_entry *entry, size_t n, const struct rl_run_options *options)
{
    bool failed = false, planned = options->again;
    for (size_t i = 0; i < n; i++) {
        failed = failed || entry[i].state == RL_RECORD_FAILED;
        planned = planned || entry[i].state == RL_RECORD_PLANNED;
    }
    return planned || (failed && options->retry);
}

static int look_up(struct rl_forecast *f, const struct rl_run_options *options, struct rl_database *db,
                   const struct rl_run *times, struct rl_error *error)
{
    const struct rl_run *run = &f->planned->run;
    int status = RL_OK;
    for (size_t first = 0, end; first < run->n_records && status == RL_OK; first = end) {
        struct rl_forecast_entry *entry = &f->entry[first];
        end = rl_group_end(run, first);
        for (size_t i = first; i < end && db && status == RL_OK; i++)
            status = rl_database_state(db, run->record[i].identity, &f->entry[i].state, error);
        entry->wanted = rl_group_wanted(run, first, options);
        entry->open = entry->wanted && is_open(entry, end - first, options);
        estimate(entry, run, first, times);
        for (size_t i = first + 1; i < end; i++) {
            enum rl_record_status state = f->entry[i].state;
            f->entry[i] = *entry;
            f->entry[i].state = state;
        }
        count_group(f, entry, end - first);
    }
    return status;
}

int rl_forecast_make(struct rl_forecast *f, const struct rl_study *study,
                     const struct rl_run_options *options, const struct rl_provenance *provenance,
                     struct rl_error *error)
{
    *f = (struct rl_forecast){0};
    struct rl_database *db = NULL;
    struct rl_run times = {0};
    int status = rl_planned_make(&f->planned, study, options, provenance, error);
    if (status == RL_OK && access(options->database, F_OK) == 0)
        status = rl_database_open(&db, options->database, RL_DATABASE_READ, error);
    if (status == RL_OK && db)
        status = rl_database_load_times(db, study->name, &times, error);
    if (status == RL_OK) {
        f->entry = calloc(f->planned->run.n_records + 1, sizeof *f->entry);
        status = f->entry ? look_up(f, options, db, &times, error) : rl_fail_memory(error, "a forecast");
    }
    rl_run_clear(&times);
    rl_database_close(db);
    if (status != RL_OK)
        rl_forecast_clear(f);
    return status;
}
