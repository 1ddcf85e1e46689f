/* Rows on stdout as TSV or JSON (see output.h). */
#include "cli/output.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
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

static void json_text(const char *text)
{
    putchar('"');
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\')
            printf("\\%c", *c);
        else if (*c < 0x20)
            printf("\\u%04x", *c);
        else
            putchar(*c);
    }
    putchar('"');
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

/* What stands before a value. */
static void begin_value(const struct rl_rows *rows)
{
    if (rows->format == RL_OUTPUT_TSV) {
        if (rows->next > 0)
            putchar('\t');
        return;
    }
    if (rows->next == 0)
        printf("%s\n  {", rows->n_rows ? "," : "");
    else
        printf(", ");
    json_text(rows->column[rows->next]);
    printf(": ");
}

static void end_value(struct rl_rows *rows)
{
    if (++rows->next < rows->n_columns)
        return;
    printf(rows->format == RL_OUTPUT_TSV ? "\n" : "}");
    rows->next = 0;
    rows->n_rows++;
}

/* The fewest of 15, 16 or 17 digits that read back as the same number. */
static void print_number(double value)
{
    char text[32];
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            break;
    }
    fputs(text, stdout);
}

void rl_rows_number(struct rl_rows *rows, double value)
{
    begin_value(rows);
    if (isfinite(value))
        print_number(value);
    else if (rows->format == RL_OUTPUT_JSON)
        printf("null");
    else
        printf("%s", isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf");
    end_value(rows);
}

void rl_rows_integer(struct rl_rows *rows, long long value)
{
    begin_value(rows);
    printf("%lld", value);
    end_value(rows);
}

void rl_rows_text(struct rl_rows *rows, const char *value)
{
    begin_value(rows);
    if (rows->format == RL_OUTPUT_JSON)
        json_text(value);
    else /* a tab or line end inside a value would shift the columns */
        for (; *value; value++)
            putchar(*value == '\t' || *value == '\n' || *value == '\r' ? ' ' : *value);
    end_value(rows);
}

void rl_rows_end(struct rl_rows *rows)
{
    if (rows->format == RL_OUTPUT_JSON)
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
