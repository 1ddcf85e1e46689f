/* Baselines as text (see baseline.h for the columns). */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "results/baseline.h"
#include "results/buffer.h"

static const char *const columns[] = {
    "scene", "parameters", "metric",   "kind",           "best",       "unit",   "value",    "deviation",
    "n",     "tolerance",  "relevant", "tolerance_from", "scene_hash", "commit", "renderer",
};
enum { COLUMNS = sizeof columns / sizeof columns[0] };

static const char *const kinds[] = {[RL_METRIC_RANDOM] = "random", [RL_METRIC_FIXED] = "fixed"};
static const char *const bests[] = {
    [RL_BEST_LOWER] = "lower", [RL_BEST_ZERO] = "zero", [RL_BEST_SAME] = "same"};

/* Where reading is. */
struct place {
    const char *path;
    size_t line;
    int column;
    struct rl_error *error;
};

static int fail(const struct place *p, const char *found, const char *expected)
{
    return rl_fail(p->error, RL_ERR_INPUT, "%s:%zu: %s: found '%.60s', expected %s", p->path, p->line,
                   columns[p->column], found, expected);
}

static int take_text(char to[], size_t size, const char *text, const struct place *p)
{
    if (*text == '\0')
        return fail(p, text, "a word (- for none)");
    size_t length = strlen(text);
    if (length >= size)
        return fail(p, text, "a shorter text");
    memcpy(to, text, length + 1);
    return RL_OK;
}

static int take_word(int *value, const char *const words[], int n, const char *text, const char *expected,
                     const struct place *p)
{
    for (*value = 0; *value < n; ++*value)
        if (strcmp(text, words[*value]) == 0)
            return RL_OK;
    return fail(p, text, expected);
}

static int take_number(double *value, const char *text, double low, const char *expected,
                       const struct place *p)
{
    char *end = NULL;
    *value = strtod(text, &end);
    bool valid = end != text && *end == '\0' && isfinite(*value) && *value >= low;
    return valid ? RL_OK : fail(p, text, expected);
}

static int take_count(size_t *value, const char *text, const struct place *p)
{
    double x;
    int status = take_number(&x, text, 1.0, "a whole number from 1 to 1000000", p);
    if (status == RL_OK && (x != floor(x) || x > 1e6))
        status = fail(p, text, "a whole number from 1 to 1000000");
    if (status == RL_OK)
        *value = (size_t)x;
    return status;
}

static int take_field(struct rl_baseline_row *r, const char *text, const struct place *p)
{
    static const char *const not_negative = "a number >= 0";
    int word = 0, status = RL_OK;
    switch (p->column) {
    case 0:
        return take_text(r->scene, sizeof r->scene, text, p);
    case 1:
        return take_text(r->parameters, sizeof r->parameters, text, p);
    case 2:
        return take_text(r->metric, sizeof r->metric, text, p);
    case 3:
        status = take_word(&word, kinds, 2, text, "random or fixed", p);
        r->kind = (enum rl_metric_kind)word;
        return status;
    case 4:
        status = take_word(&word, bests, 3, text, "lower, zero or same", p);
        r->best = (enum rl_best)word;
        return status;
    case 5:
        return take_text(r->unit, sizeof r->unit, text, p);
    case 6:
        return take_number(&r->mean.value, text, -INFINITY, "a finite number", p);
    case 7:
        return take_number(&r->mean.deviation, text, 0.0, not_negative, p);
    case 8:
        return take_count(&r->mean.n, text, p);
    case 9:
        return take_number(&r->tolerance, text, 0.0, not_negative, p);
    case 10:
        return take_number(&r->relevant, text, 0.0, not_negative, p);
    case 11:
        return take_text(r->tolerance_from, sizeof r->tolerance_from, text, p);
    case 12:
        return take_text(r->scene_hash, sizeof r->scene_hash, text, p);
    case 13:
        return take_text(r->commit, sizeof r->commit, text, p);
    default:
        return take_text(r->renderer, sizeof r->renderer, text, p);
    }
}

/* What the columns must be to one another. */
static int check_row(const struct rl_baseline_row *r, struct place *p)
{
    char found[32];
    snprintf(found, sizeof found, "%zu", r->mean.n);
    p->column = 8;
    if (r->kind == RL_METRIC_RANDOM && r->mean.n < 2)
        return fail(p, found, "at least 2 values of a random metric");
    if (r->kind == RL_METRIC_FIXED && r->mean.n != 1)
        return fail(p, found, "1 of a fixed metric");
    p->column = 10;
    if (r->kind == RL_METRIC_RANDOM && !(r->relevant > 0.0))
        return fail(p, "0", "a number > 0 of a random metric");
    return RL_OK;
}

/* Splits at the tabs; the last field ends the line. */
static int take_row(struct rl_baseline *b, char *line, struct place *p)
{
    struct rl_baseline_row row = {0};
    char *rest = line;
    for (p->column = 0; p->column < COLUMNS; p->column++) {
        const char *field = strsep(&rest, "\t");
        if (!rest && p->column + 1 < COLUMNS)
            return rl_fail(p->error, RL_ERR_INPUT, "%s:%zu: found %d columns, expected %d", p->path, p->line,
                           p->column + 1, (int)COLUMNS);
        int status = take_field(&row, field, p);
        if (status != RL_OK)
            return status;
    }
    if (rest)
        return rl_fail(p->error, RL_ERR_INPUT, "%s:%zu: found more than %d columns", p->path, p->line,
                       (int)COLUMNS);
    int status = check_row(&row, p);
    if (status == RL_OK && rl_baseline_find(b, &row))
        return rl_fail(p->error, RL_ERR_INPUT,
                       "%s:%zu: found %s of '%s' of the scene %s again, expected it once", p->path, p->line,
                       row.metric, row.parameters, row.scene);
    return status == RL_OK ? rl_baseline_add(b, &row, p->error) : status;
}

static int check_header(char *line, struct place *p)
{
    char *rest = line;
    for (p->column = 0; p->column < COLUMNS; p->column++) {
        const char *name = strsep(&rest, "\t");
        if (!name || strcmp(name, columns[p->column]) != 0)
            return rl_fail(p->error, RL_ERR_INPUT, "%s:%zu: column %d: found '%.60s', expected '%s'", p->path,
                           p->line, p->column + 1, name ? name : "", columns[p->column]);
    }
    return rest ? rl_fail(p->error, RL_ERR_INPUT, "%s:%zu: found the column '%.60s' after the last, '%s'",
                          p->path, p->line, rest, columns[COLUMNS - 1])
                : RL_OK;
}

static int take_lines(struct rl_baseline *b, char *text, struct place *p)
{
    bool header = false;
    int status = RL_OK;
    for (char *rest = text, *line; status == RL_OK && (line = strsep(&rest, "\n"));) {
        p->line++;
        size_t length = strlen(line);
        if (length > 0 && line[length - 1] == '\r')
            line[length - 1] = '\0';
        if (*line == '\0' || *line == '#')
            continue;
        status = header ? take_row(b, line, p) : check_header(line, p);
        header = true;
    }
    if (status == RL_OK && b->n == 0)
        status = rl_fail(p->error, RL_ERR_INPUT, "%s: found no rows, expected a baseline", p->path);
    return status;
}

int rl_baseline_read(struct rl_baseline *baseline, const char *path, struct rl_error *error)
{
    char *text = NULL;
    size_t size = 0;
    int status = rl_file_read(&text, &size, path, error);
    if (status != RL_OK)
        return status;
    struct place place = {.path = path, .error = error};
    status = strlen(text) == size
                 ? take_lines(baseline, text, &place)
                 : rl_fail(error, RL_ERR_INPUT, "%s: found a zero byte, expected text", path);
    free(text);
    if (status != RL_OK)
        rl_baseline_clear(baseline);
    return status;
}

static void write_number(struct rl_buffer *text, double value)
{
    rl_buffer_number(text, value);
    rl_buffer_add(text, "\t");
}

static void write_row(struct rl_buffer *text, const struct rl_baseline_row *r)
{
    rl_buffer_printf(text, "%s\t%s\t%s\t%s\t%s\t%s\t", r->scene, r->parameters, r->metric, kinds[r->kind],
                     bests[r->best], r->unit);
    write_number(text, r->mean.value);
    write_number(text, r->mean.deviation);
    rl_buffer_printf(text, "%zu\t", r->mean.n);
    write_number(text, r->tolerance);
    write_number(text, r->relevant);
    rl_buffer_printf(text, "%s\t%s\t%s\t%s\n", r->tolerance_from, r->scene_hash, r->commit, r->renderer);
}

int rl_baseline_write(const struct rl_baseline *b, const char *path, const char *comment,
                      struct rl_error *error)
{
    for (size_t i = 0; i < b->n; i++)
        if (!isfinite(b->row[i].mean.value) || !isfinite(b->row[i].mean.deviation))
            return rl_fail(error, RL_ERR_CHECK, "%s of '%s' of the scene %s is not finite", b->row[i].metric,
                           b->row[i].parameters, b->row[i].scene);
    struct rl_buffer text = {0};
    for (const char *line = comment; line && *line;) {
        int length = (int)strcspn(line, "\n");
        rl_buffer_printf(&text, "# %.*s\n", length, line);
        line += length + (line[length] == '\n');
    }
    for (int i = 0; i < COLUMNS; i++)
        rl_buffer_printf(&text, "%s%c", columns[i], i + 1 < COLUMNS ? '\t' : '\n');
    for (size_t i = 0; i < b->n; i++)
        write_row(&text, &b->row[i]);
    int status = rl_buffer_write(&text, path, error);
    rl_buffer_clear(&text);
    return status;
}
