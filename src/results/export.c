/* Rows of TSV, CSV and JSON, and how records become rows (see export.h). */
#include "results/export.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char rl_identity_column[] = "identity";

const char *rl_export_ending(enum rl_export_format format)
{
    static const char *const ending[] = {
        [RL_EXPORT_TSV] = ".tsv", [RL_EXPORT_JSON] = ".json", [RL_EXPORT_CSV] = ".csv"};
    return ending[format];
}

/* What ends a row of a table that is no JSON. */
static const char *row_end(enum rl_export_format format)
{
    return format == RL_EXPORT_CSV ? "\r\n" : "\n";
}

void rl_export_begin(struct rl_export *t, struct rl_buffer *out, enum rl_export_format format,
                     const char *const column[], size_t n_columns)
{
    *t = (struct rl_export){.out = out, .format = format, .column = column, .n_columns = n_columns};
    if (format == RL_EXPORT_JSON)
        rl_buffer_add(out, "[");
    for (size_t i = 0; format != RL_EXPORT_JSON && i < n_columns; i++)
        rl_buffer_printf(out, "%s%s", i == 0 ? "" : format == RL_EXPORT_CSV ? "," : "\t", column[i]);
    if (format != RL_EXPORT_JSON)
        rl_buffer_add(out, row_end(format));
}

static void begin_value(const struct rl_export *t)
{
    if (t->format != RL_EXPORT_JSON) {
        if (t->next > 0)
            rl_buffer_add(t->out, t->format == RL_EXPORT_CSV ? "," : "\t");
        return;
    }
    if (t->next == 0)
        rl_buffer_printf(t->out, "%s\n  {", t->n_rows ? "," : "");
    else
        rl_buffer_add(t->out, ", ");
    rl_buffer_json(t->out, t->column[t->next]);
    rl_buffer_add(t->out, ": ");
}

static void end_value(struct rl_export *t)
{
    if (++t->next < t->n_columns)
        return;
    rl_buffer_add(t->out, t->format == RL_EXPORT_JSON ? "}" : row_end(t->format));
    t->next = 0;
    t->n_rows++;
}

static void csv_text(struct rl_buffer *out, const char *value)
{
    if (!strpbrk(value, ",\"\r\n")) {
        rl_buffer_add(out, value);
        return;
    }
    rl_buffer_add(out, "\"");
    for (; *value; value++)
        rl_buffer_printf(out, "%s%c", *value == '"' ? "\"" : "", *value);
    rl_buffer_add(out, "\"");
}

static void tsv_text(struct rl_buffer *out, const char *value)
{
    for (; *value; value++)
        rl_buffer_printf(out, "%c", *value == '\t' || *value == '\n' || *value == '\r' ? ' ' : *value);
}

void rl_export_text(struct rl_export *t, const char *value)
{
    begin_value(t);
    if (t->format == RL_EXPORT_JSON)
        rl_buffer_json(t->out, value);
    else if (t->format == RL_EXPORT_CSV)
        csv_text(t->out, value);
    else
        tsv_text(t->out, value);
    end_value(t);
}

void rl_export_number(struct rl_export *t, double value)
{
    begin_value(t);
    if (t->format == RL_EXPORT_JSON && !isfinite(value))
        rl_buffer_add(t->out, "null");
    else
        rl_buffer_number(t->out, value);
    end_value(t);
}

void rl_export_end(struct rl_export *t)
{
    if (t->format == RL_EXPORT_JSON)
        rl_buffer_printf(t->out, "%s]\n", t->n_rows ? "\n" : "");
}

static double column_number(const struct rl_column *c, const struct rl_record *r)
{
    if (c->source == RL_COLUMN_NUMBER)
        return rl_parameter_number(r->parameters, c->key);
    const struct rl_metric *m = rl_record_metric(r, c->key);
    if (!m)
        return NAN;
    return c->source == RL_COLUMN_VALUE ? m->value : c->source == RL_COLUMN_LOW ? m->low : m->high;
}

static void export_column(struct rl_export *t, const struct rl_column *c, const struct rl_record *r)
{
    char text[RL_NAME_MAX];
    switch (c->source) {
    case RL_COLUMN_SCENE:
        rl_export_text(t, r->scene);
        break;
    case RL_COLUMN_SCENE_HASH:
        rl_export_text(t, r->scene_hash);
        break;
    case RL_COLUMN_TEXT:
        rl_parameter(r->parameters, c->key, text, sizeof text);
        rl_export_text(t, text);
        break;
    case RL_COLUMN_REMARK:
        rl_export_text(t, r->message);
        break;
    default:
        rl_export_number(t, column_number(c, r));
    }
}

void rl_column_text(char text[], size_t size, const struct rl_column *c, const struct rl_record *r)
{
    if (c->source == RL_COLUMN_SCENE)
        snprintf(text, size, "%s", r->scene);
    else if (c->source == RL_COLUMN_SCENE_HASH)
        snprintf(text, size, "%s", r->scene_hash);
    else if (c->source == RL_COLUMN_TEXT)
        rl_parameter(r->parameters, c->key, text, size);
    else if (c->source == RL_COLUMN_REMARK)
        snprintf(text, size, "%s", r->message);
    else
        snprintf(text, size, "%.4g", column_number(c, r));
}

void rl_export_run(struct rl_buffer *out, const struct rl_table *table, const struct rl_run *run,
                   enum rl_export_format format)
{
    const char *name[RL_TABLE_COLUMNS_MAX + 1];
    for (size_t i = 0; i < table->n_columns; i++)
        name[i] = table->column[i].name;
    name[table->n_columns] = rl_identity_column;
    struct rl_export t;
    rl_export_begin(&t, out, format, name, table->n_columns + 1);
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, NULL, table->pattern));) {
        for (size_t i = 0; i < table->n_columns; i++)
            export_column(&t, &table->column[i], r);
        rl_export_text(&t, r->identity);
    }
    rl_export_end(&t);
}

void rl_export_samples(struct rl_buffer *out, const struct rl_run *runs, size_t n_runs,
                       enum rl_export_format format)
{
    static const char *const column[] = {"study", "scene", "parameters",      "series",
                                         "index", "value", rl_identity_column};
    struct rl_export t;
    rl_export_begin(&t, out, format, column, sizeof column / sizeof column[0]);
    for (size_t k = 0; k < n_runs; k++)
        for (const struct rl_record *r = NULL; (r = rl_run_next(&runs[k], r, NULL, ""));)
            for (size_t s = 0; s < r->n_series; s++)
                for (size_t i = 0; i < r->series[s].n; i++) {
                    rl_export_text(&t, r->study);
                    rl_export_text(&t, r->scene);
                    rl_export_text(&t, r->parameters);
                    rl_export_text(&t, r->series[s].name);
                    rl_export_number(&t, (double)i);
                    rl_export_number(&t, r->series[s].value[i]);
                    rl_export_text(&t, r->identity);
                }
    rl_export_end(&t);
}
