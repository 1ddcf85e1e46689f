/* Rows on stdout as TSV or JSON (see output.h). */
#include "cli/output.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/files.h"

const struct rl_option rl_options_format[] = {
    {0, "format", "tsv|json", "how rows are printed (tsv)"},
    {0},
};

int rl_argument_output(const struct rl_arguments *arguments, enum rl_output *format, struct rl_error *error)
{
    const char *text = rl_argument(arguments, "format");
    *format = text && strcmp(text, "json") == 0 ? RL_OUTPUT_JSON : RL_OUTPUT_TSV;
    if (text && *format == RL_OUTPUT_TSV && strcmp(text, "tsv") != 0)
        return rl_fail(error, RL_ERR_INPUT, "--format: found '%s', expected tsv or json", text);
    return RL_OK;
}

void rl_rows_begin(struct rl_rows *rows, enum rl_output format, const char *const columns[])
{
    *rows = (struct rl_rows){.format = format, .column = columns};
    while (columns[rows->n_columns])
        rows->n_columns++;
    if (format == RL_OUTPUT_JSON)
        printf("[");
    for (size_t i = 0; format == RL_OUTPUT_TSV && i < rows->n_columns; i++)
        printf("%s%c", columns[i], i + 1 < rows->n_columns ? '\t' : '\n');
}

/* The row before stays open for what rl_rows_more adds. */
static void begin_row(struct rl_rows *rows)
{
    if (rows->n_rows > 0)
        rl_json_close(&rows->json, '}');
    printf("%s\n  ", rows->n_rows > 0 ? "," : "");
    rows->json = (struct rl_json){0};
    rl_json_open(&rows->json, NULL, '{');
}

/* What stands before a value; the key of JSON, whose values follow it. */
static const char *begin_value(struct rl_rows *rows)
{
    if (rows->format == RL_OUTPUT_TSV && rows->next > 0)
        putchar('\t');
    if (rows->format == RL_OUTPUT_JSON && rows->next == 0)
        begin_row(rows);
    return rows->column[rows->next];
}

static void end_value(struct rl_rows *rows)
{
    if (++rows->next < rows->n_columns)
        return;
    if (rows->format == RL_OUTPUT_TSV)
        putchar('\n');
    rows->next = 0;
    rows->n_rows++;
}

void rl_rows_number(struct rl_rows *rows, double value)
{
    const char *key = begin_value(rows);
    if (rows->format == RL_OUTPUT_JSON)
        rl_json_number(&rows->json, key, value);
    else if (isfinite(value))
        rl_print_number(value);
    else
        printf("%s", isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf");
    end_value(rows);
}

void rl_rows_integer(struct rl_rows *rows, long long value)
{
    const char *key = begin_value(rows);
    if (rows->format == RL_OUTPUT_JSON)
        rl_json_integer(&rows->json, key, value);
    else
        printf("%lld", value);
    end_value(rows);
}

void rl_rows_text(struct rl_rows *rows, const char *value)
{
    const char *key = begin_value(rows);
    if (rows->format == RL_OUTPUT_JSON)
        rl_json_text(&rows->json, key, value);
    else /* a tab or line end inside a value would shift the columns */
        for (; *value; value++)
            putchar(*value == '\t' || *value == '\n' || *value == '\r' ? ' ' : *value);
    end_value(rows);
}

struct rl_json *rl_rows_more(struct rl_rows *rows)
{
    return rows->format == RL_OUTPUT_JSON ? &rows->json : NULL;
}

void rl_rows_end(struct rl_rows *rows)
{
    if (rows->format != RL_OUTPUT_JSON)
        return;
    if (rows->n_rows > 0)
        rl_json_close(&rows->json, '}');
    printf("%s]\n", rows->n_rows ? "\n" : "");
}

int rl_output_file_check(const char *path, struct rl_error *error)
{
    char temporary[PATH_MAX];
    int status = rl_file_begin(temporary, sizeof temporary, path, error);
    if (status == RL_OK)
        rl_file_abandon(temporary);
    return status;
}

int rl_output_check(struct rl_error *error)
{
    if (fflush(stdout) != 0 || ferror(stdout))
        return rl_fail(error, RL_ERR_SYSTEM, "standard output: cannot write: %s", strerror(errno));
    return RL_OK;
}
