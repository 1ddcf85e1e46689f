/* Rows of numbers for `probe`, as text (see probe_rows.h). */
#include "cli/probe_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"

/* The next word of a line, ended by a NUL, or NULL. */
static char *next_word(char **at)
{
    static const char blanks[] = " \t\r\n";
    char *word = *at + strspn(*at, blanks);
    if (*word == '\0')
        return NULL;
    *at = word + strcspn(word, blanks);
    if (**at != '\0')
        *(*at)++ = '\0';
    return word;
}

static bool is_header(const char *line, const struct rl_probe *probe)
{
    char *copy = strdup(line), *at = copy;
    bool same = copy != NULL;
    for (size_t i = 0; i <= probe->n_in && same; i++) {
        const char *word = next_word(&at);
        same = i < probe->n_in ? word && strcmp(word, probe->in[i].name) == 0 : !word;
    }
    free(copy);
    return same;
}

static int take_line(double *row, char *line, const struct rl_probe *probe, struct rl_error *error)
{
    char *word;
    size_t n = 0;
    for (; (word = next_word(&line)) != NULL; n++) {
        if (n < probe->n_in && probe->in[n].optional && strcmp(word, "-") == 0)
            row[n] = NAN;
        else if (n < probe->n_in && !rl_text_number(word, &row[n]))
            return rl_fail(error, RL_ERR_INPUT, "%s: found '%.64s', expected a finite number",
                           probe->in[n].name, word);
    }
    if (n != probe->n_in)
        return rl_fail(error, RL_ERR_INPUT, "found %zu columns, expected %zu", n, probe->n_in);
    return rl_probe_check_row(probe, row, error);
}

static int make_room(struct rl_probe_rows *rows, size_t n_in, struct rl_error *error)
{
    if (rows->n < rows->room)
        return RL_OK;
    size_t room = rows->room ? 2 * rows->room : 64;
    double *value = realloc(rows->value, (room * n_in + 1) * sizeof *value);
    if (!value)
        return rl_fail_memory(error, "rows");
    rows->room = room;
    rows->value = value;
    return RL_OK;
}

int rl_probe_rows_read(struct rl_probe_rows *rows, const struct rl_probe *probe, FILE *in, const char *name,
                       struct rl_error *error)
{
    *rows = (struct rl_probe_rows){0};
    char *line = NULL;
    size_t size = 0;
    int status = RL_OK;
    for (size_t number = 1; status == RL_OK && getline(&line, &size, in) >= 0; number++) {
        if (line[strspn(line, " \t\r\n")] == '\0' || (rows->n == 0 && is_header(line, probe)))
            continue;
        status = make_room(rows, probe->n_in, error);
        if (status == RL_OK)
            status = take_line(rows->value + rows->n * probe->n_in, line, probe, error);
        if (status == RL_OK)
            rows->n++;
        else
            rl_fail_prefix(error, "%s:%zu", name, number);
    }
    free(line);
    if (status == RL_OK && ferror(in))
        return rl_fail(error, RL_ERR_SYSTEM, "%s: cannot read", name);
    return status;
}

void rl_probe_rows_clear(struct rl_probe_rows *rows)
{
    free(rows->value);
    *rows = (struct rl_probe_rows){0};
}
