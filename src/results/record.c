/* Records, runs and their parameters' text (see record.h). */
#include "results/record.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void rl_record_reset(struct rl_record *record)
{
    for (size_t i = 0; i < record->n_series; i++)
        free(record->series[i].value);
    free(record->series);
    free(record->metric);
    record->series = NULL;
    record->metric = NULL;
    record->n_series = record->n_metrics = 0;
}

void rl_run_clear(struct rl_run *run)
{
    for (size_t i = 0; i < run->n_records; i++)
        rl_record_reset(&run->record[i]);
    free(run->record);
    *run = (struct rl_run){0};
}

struct rl_record *rl_run_add(struct rl_run *run, const struct rl_place *place, int group,
                             struct rl_error *error, const char *format, ...)
{
    struct rl_record *grown = realloc(run->record, (run->n_records + 1) * sizeof *grown);
    if (!grown) {
        rl_error_set(error, RL_ERR_SYSTEM, "out of memory for a list of cases");
        return NULL;
    }
    run->record = grown;
    struct rl_record *r = &grown[run->n_records];
    *r = (struct rl_record){.group = group};
    snprintf(r->study, sizeof r->study, "%s", place->study);
    snprintf(r->scene, sizeof r->scene, "%s", place->scene);
    snprintf(r->scene_path, sizeof r->scene_path, "%s", place->scene_path);
    rl_hash_text(r->scene_hash, place->scene_hash);
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(r->parameters, sizeof r->parameters, format, arguments);
    va_end(arguments);
    if (n < 0 || (size_t)n >= sizeof r->parameters) {
        rl_error_set(error, RL_ERR_INPUT, "parameters of a case: %d bytes, at most %d fit", n,
                     RL_PARAMETERS_MAX - 1);
        return NULL;
    }
    run->n_records++;
    return r;
}

uint64_t rl_record_key(const struct rl_record *r)
{
    const char *part[] = {r->study, r->scene_hash, r->parameters};
    uint64_t hash = RL_HASH_START;
    /* Each with its NUL, so that the end of one part and the start of the next do not run together. */
    for (size_t k = 0; k < sizeof part / sizeof part[0]; k++)
        hash = rl_hash_bytes(hash, part[k], strlen(part[k]) + 1);
    return hash;
}

void rl_run_identify(struct rl_run *run, const char *environment)
{
    for (size_t i = 0; i < run->n_records; i++) {
        struct rl_record *r = &run->record[i];
        rl_hash_text(r->identity, rl_hash_bytes(rl_record_key(r), environment, strlen(environment) + 1));
    }
}

/* Where "key=" begins in `parameters`, at a word's start. */
static const char *find_word(const char *parameters, const char *word, size_t length)
{
    for (const char *at = parameters; *at;) {
        if (strncmp(at, word, length) == 0)
            return at;
        at += strcspn(at, " ");
        at += strspn(at, " ");
    }
    return NULL;
}

bool rl_parameter(const char *parameters, const char *key, char *value, size_t size)
{
    char word[RL_NAME_MAX + 1];
    int n = snprintf(word, sizeof word, "%s=", key);
    const char *at = n > 0 && (size_t)n < sizeof word ? find_word(parameters, word, (size_t)n) : NULL;
    if (size > 0)
        value[0] = '\0';
    if (!at)
        return false;
    snprintf(value, size, "%.*s", (int)strcspn(at + n, " "), at + n);
    return true;
}

double rl_parameter_number(const char *parameters, const char *key)
{
    char text[RL_NAME_MAX];
    if (!rl_parameter(parameters, key, text, sizeof text))
        return NAN;
    char *end;
    double value = strtod(text, &end);
    return end != text && *end == '\0' ? value : NAN;
}

bool rl_parameters_match(const char *parameters, const char *pattern)
{
    for (const char *at = pattern; *at;) {
        size_t length = strcspn(at, " ");
        const char *found = find_word(parameters, at, length);
        if (!found || (found[length] != '\0' && found[length] != ' '))
            return false;
        at += length;
        at += strspn(at, " ");
    }
    return true;
}

const struct rl_record *rl_run_next(const struct rl_run *run, const struct rl_record *after,
                                    const char *scene, const char *pattern)
{
    for (size_t i = after ? (size_t)(after - run->record) + 1 : 0; i < run->n_records; i++) {
        const struct rl_record *r = &run->record[i];
        if (r->status == RL_RECORD_OK && (!scene || strcmp(r->scene, scene) == 0) &&
            rl_parameters_match(r->parameters, pattern))
            return r;
    }
    return NULL;
}

const struct rl_record *rl_run_find(const struct rl_run *run, const char *scene, const char *pattern)
{
    return rl_run_next(run, NULL, scene, pattern);
}

size_t rl_run_count(const struct rl_run *run, enum rl_record_status status)
{
    size_t n = 0;
    for (size_t i = 0; i < run->n_records; i++)
        n += run->record[i].status == status;
    return n;
}

int rl_record_metric_add(struct rl_record *record, const char *name, double value, double low, double high,
                         const char *unit, struct rl_error *error)
{
    struct rl_metric *grown = realloc(record->metric, (record->n_metrics + 1) * sizeof *grown);
    if (!grown)
        return rl_fail_memory(error, "a case's metrics");
    record->metric = grown;
    struct rl_metric *m = &grown[record->n_metrics++];
    *m = (struct rl_metric){.value = value, .low = low, .high = high};
    snprintf(m->name, sizeof m->name, "%s", name);
    snprintf(m->unit, sizeof m->unit, "%s", unit);
    return RL_OK;
}

int rl_record_add(struct rl_record *record, const char *name, struct rl_interval x, const char *unit,
                  struct rl_error *error)
{
    return rl_record_metric_add(record, name, x.value, x.low, x.high, unit, error);
}

int rl_record_add_exact(struct rl_record *record, const char *name, double value, const char *unit,
                        struct rl_error *error)
{
    return rl_record_metric_add(record, name, value, value, value, unit, error);
}

int rl_record_series_add(struct rl_record *record, const char *name, const double *value, size_t n,
                         struct rl_error *error)
{
    struct rl_series *grown = realloc(record->series, (record->n_series + 1) * sizeof *grown);
    if (grown)
        record->series = grown;
    double *copy = malloc((n ? n : 1) * sizeof *copy);
    if (!grown || !copy) {
        free(copy);
        return rl_fail_memory(error, "a case's raw figures");
    }
    if (n)
        memcpy(copy, value, n * sizeof *copy);
    struct rl_series *s = &grown[record->n_series++];
    *s = (struct rl_series){.n = n, .value = copy};
    snprintf(s->name, sizeof s->name, "%s", name);
    return RL_OK;
}

bool rl_metric_timed(const struct rl_metric *m)
{
    static const char *const unit[] = {"ms", "s", "us", "ns", "1/s"};
    for (size_t i = 0; i < sizeof unit / sizeof unit[0]; i++)
        if (strcmp(m->unit, unit[i]) == 0)
            return true;
    return strncmp(m->name, "time_", 5) == 0 || strcmp(m->name, "frames") == 0;
}

static void note_read(const struct rl_record *record)
{
    if (record->mark)
        *record->mark |= RL_RECORD_READ;
}

const struct rl_metric *rl_record_metric(const struct rl_record *record, const char *name)
{
    note_read(record);
    for (size_t i = 0; i < record->n_metrics; i++)
        if (strcmp(record->metric[i].name, name) == 0)
            return &record->metric[i];
    return NULL;
}

const struct rl_series *rl_record_series(const struct rl_record *record, const char *name)
{
    note_read(record);
    for (size_t i = 0; i < record->n_series; i++)
        if (strcmp(record->series[i].name, name) == 0)
            return &record->series[i];
    return NULL;
}
