/* Reads shader modules, joins them, and traces compiler messages back to them. */
#include "gpu/modules.h"

#include <ctype.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "base/paths.h"

/* The numbers of the texts that are in no file; module numbers are below. Text K's lines are numbered from
 * (K + 1) LINES_PER_TEXT + 1. */
enum { NUMBER_DEFINES = RL_PLAN_MODULES_MAX, NUMBER_GLUE, LINES_PER_TEXT = 10000 };

static void begin_text(FILE *out, size_t number)
{
    fprintf(out, "#line %zu\n", (number + 1) * LINES_PER_TEXT + 1);
}

static int append_module(FILE *out, const char *module, size_t number, struct rl_error *error)
{
    char relative[256];
    char path[PATH_MAX];
    char *text = NULL;
    size_t size = 0;
    snprintf(relative, sizeof relative, "shaders/%s.glsl", module);
    int status = rl_path_data(path, sizeof path, relative, error);
    if (status == RL_OK)
        status = rl_file_read(&text, &size, path, error);
    if (status != RL_OK)
        return status;
    begin_text(out, number);
    fprintf(out, "%s\n", text);
    free(text);
    return RL_OK;
}

int rl_modules_assemble(char **source, const struct rl_plan_program *program, size_t first, size_t end,
                        const char *defines, const char *glue, struct rl_error *error)
{
    size_t size = 0;
    *source = NULL;
    FILE *out = open_memstream(source, &size);
    if (!out)
        return rl_fail_memory(error, "a shader");
    fprintf(out, "#version 450 core\n");
    begin_text(out, NUMBER_DEFINES);
    fprintf(out, "%s", defines);
    int status = RL_OK;
    for (size_t i = first; i < end && status == RL_OK; i++) {
        if (glue && i + 1 == end) {
            begin_text(out, NUMBER_GLUE);
            fprintf(out, "%s", glue);
        }
        status = append_module(out, program->module[i], i, error);
    }
    if (fclose(out) != 0 && status == RL_OK)
        status = rl_fail_memory(error, "a shader");
    if (status != RL_OK) {
        free(*source);
        *source = NULL;
    }
    return status;
}

/* The first line of the log that is an error; warnings may come before it. */
static const char *first_error(const char *log)
{
    for (const char *line = log; *line;) {
        size_t length = strcspn(line, "\n");
        if (memmem(line, length, "error", 5))
            return line;
        line += length + (line[length] == '\n');
    }
    return log;
}

/* Steps over `text` where it comes next. */
static bool skip(const char **at, const char *text)
{
    size_t length = strlen(text);
    if (strncmp(*at, text, length) != 0)
        return false;
    *at += length;
    return true;
}

static bool skip_number(const char **at, unsigned long *number)
{
    char *end;
    if (!isdigit((unsigned char)**at))
        return false;
    *number = strtoul(*at, &end, 10);
    *at = end;
    return true;
}

/* Mesa writes "K:LINE(COLUMN): error: ...", others "K(LINE) : error ..." or "ERROR: K:LINE: ...". */
static bool parse_place(const char **message, unsigned long *line)
{
    unsigned long string, column;
    const char *at = *message;
    skip(&at, "ERROR: ");
    if (!skip_number(&at, &string))
        return false;
    if (skip(&at, "(")) {
        if (!skip_number(&at, line) || !skip(&at, ") : "))
            return false;
    } else {
        if (!skip(&at, ":") || !skip_number(&at, line))
            return false;
        if (skip(&at, "(") && !(skip_number(&at, &column) && skip(&at, ")")))
            return false;
        if (!skip(&at, ": "))
            return false;
    }
    *message = at;
    return true;
}

int rl_modules_fail(const struct rl_plan_program *program, const char *log, struct rl_error *error)
{
    const char *message = first_error(log);
    unsigned long line = 0;
    bool placed = parse_place(&message, &line) && line > LINES_PER_TEXT;
    unsigned long number = placed ? line / LINES_PER_TEXT - 1 : 0;
    line %= LINES_PER_TEXT;
    int length = (int)strcspn(message, "\n");
    if (placed && number < program->n_modules)
        return rl_fail(error, RL_ERR_INPUT, "shaders/%s.glsl:%lu: %.*s", program->module[number], line,
                       length, message);
    const char *where = "";
    if (placed && number == NUMBER_GLUE)
        where = " (generated glue)";
    else if (placed && number == NUMBER_DEFINES)
        where = " (generated constants)";
    return rl_fail(error, RL_ERR_INPUT, "the %s pass's shader%s: %.*s", program->pass, where, length,
                   message);
}
