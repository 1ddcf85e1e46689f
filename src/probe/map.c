/* Reads maps of hard cases (see map.h). */
#include "probe/map.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"

/* Points in all, and along an axis. */
enum { POINTS_MAX = 65536 };

struct reader {
    struct rl_map *m;
    const struct rl_probe *p;
    double *argument[RL_PROBE_IN_MAX]; /* of `length` values each, along its axis */
    size_t length[RL_PROBE_IN_MAX], axis[RL_PROBE_IN_MAX];
    size_t next; /* point */
};

/* What an argument that stands still has as its axis. */
enum { EVERYWHERE = RL_MAP_AXES };

static int number(long double *to, const char *text, struct rl_error *error)
{
    char *end;
    *to = strtold(text, &end);
    return end != text && *end == '\0' && isfinite(*to)
               ? RL_OK
               : rl_fail(error, RL_ERR_INPUT, "found '%.64s', expected a finite number", text);
}

/* The rest of a line as numbers. */
static int numbers(double **to, size_t *n, char *line, struct rl_error *error)
{
    *n = 0;
    size_t room = 1;
    for (const char *at = line; at && *at; at++)
        room += *at == '\t';
    *to = malloc(room * sizeof **to);
    if (!*to)
        return rl_fail_memory(error, "an axis");
    while (line) {
        long double x;
        int status = number(&x, strsep(&line, "\t"), error);
        if (status != RL_OK)
            return status;
        (*to)[(*n)++] = (double)x;
    }
    return RL_OK;
}

static size_t find_argument(const struct rl_probe *p, const char *name)
{
    size_t i = 0;
    while (i < p->n_in && strcmp(p->in[i].name, name) != 0)
        i++;
    return i;
}

/* "across rr 1 2 3", "up shown 0 90", "all n_h 0.75" */
static int read_axis(struct reader *r, size_t axis, char *rest, struct rl_error *error)
{
    const char *name = rest ? strsep(&rest, "\t") : "";
    size_t i = find_argument(r->p, name), n, *length;
    double **to;
    bool shown = axis < RL_MAP_AXES && strcmp(name, "shown") == 0;
    if (!shown && i == r->p->n_in)
        return rl_fail(error, RL_ERR_INPUT, "found '%.64s', expected an argument of %s", name, r->p->name);
    to = shown ? &r->m->shown[axis] : &r->argument[i];
    if (*to)
        return rl_fail(error, RL_ERR_INPUT, "found %s twice", name);
    int status = numbers(to, &n, rest, error);
    if (status != RL_OK)
        return status;
    length = axis < RL_MAP_AXES ? &r->m->n[axis] : &(size_t){1};
    if (n == 0 || n > POINTS_MAX || (*length > 0 && n != *length))
        return rl_fail(error, RL_ERR_INPUT, "%s: found %zu values, expected %zu", name, n,
                       *length ? *length : 1);
    *length = n;
    if (!shown) {
        r->length[i] = n;
        r->axis[i] = axis;
    }
    return RL_OK;
}

/* Without a line of its own an axis shows its first argument. */
static int show_axes(struct reader *r, struct rl_error *error)
{
    for (size_t axis = 0; axis < RL_MAP_AXES; axis++) {
        size_t i = 0;
        while (i < r->p->n_in && !(r->argument[i] && r->axis[i] == axis))
            i++;
        if (i == r->p->n_in)
            return rl_fail(error, RL_ERR_INPUT, "found no argument %s, expected one",
                           axis == RL_MAP_UP ? "up" : "across");
        if (r->m->shown[axis])
            continue;
        r->m->shown[axis] = malloc(r->length[i] * sizeof *r->m->shown[axis]);
        if (!r->m->shown[axis])
            return rl_fail_memory(error, "an axis");
        memcpy(r->m->shown[axis], r->argument[i], r->length[i] * sizeof *r->m->shown[axis]);
    }
    return RL_OK;
}

static int fill_rows(struct reader *r, struct rl_error *error)
{
    struct rl_map *m = r->m;
    struct rl_catalogue *c = &m->catalogue;
    size_t n = m->n[RL_MAP_ACROSS] * m->n[RL_MAP_UP];
    if (n > POINTS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "found %zu points, expected at most %d", n, POINTS_MAX);
    c->n_rows = n;
    c->rows = malloc(n * r->p->n_in * sizeof *c->rows);
    c->answers = calloc(n * r->p->n_out, sizeof *c->answers);
    c->line = calloc(n, sizeof *c->line);
    if (!c->rows || !c->answers || !c->line)
        return rl_fail_memory(error, "a map");
    for (size_t point = 0; point < n; point++) {
        double *row = c->rows + point * r->p->n_in;
        const size_t at[] = {point % m->n[RL_MAP_ACROSS], point / m->n[RL_MAP_ACROSS], 0};
        for (size_t i = 0; i < r->p->n_in; i++)
            row[i] = r->argument[i] ? r->argument[i][at[r->axis[i]]] : NAN;
        int status = rl_probe_check_row(r->p, row, error);
        if (status != RL_OK) {
            rl_fail_prefix(error, "point %zu", point);
            return status;
        }
    }
    return RL_OK;
}

/* "delta cos_delta", behind "ulp" or "absolute" */
static int read_header(struct reader *r, bool absolute, char *rest, struct rl_error *error)
{
    struct rl_map *m = r->m;
    m->absolute = absolute;
    while (rest) {
        const char *name = strsep(&rest, "\t");
        size_t k = 0;
        while (k < r->p->n_out && strcmp(r->p->out[k], name) != 0)
            k++;
        if (k == r->p->n_out || m->n_judged == RL_PROBE_OUT_MAX)
            return rl_fail(error, RL_ERR_INPUT, "found '%.64s', expected a result of %s", name, r->p->name);
        m->judged[m->n_judged++] = k;
    }
    if (m->n_judged == 0)
        return rl_fail(error, RL_ERR_INPUT, "found no results, expected some of %s", r->p->name);
    int status = show_axes(r, error);
    return status == RL_OK ? fill_rows(r, error) : status;
}

/* What a bound is that no argument's rounding widens. Where errors are absolute, 8 units in the last place are those of 1. */
static double plain_bound(const struct rl_map *m, enum rl_catalogue_backend backend, long double exact)
{
    bool of_one = m->absolute && backend == RL_CATALOGUE_CPU;
    return rl_catalogue_plain_bound(backend, of_one ? 1.0 : (double)fabsl(exact));
}

static int read_point(struct reader *r, char *rest, size_t line, struct rl_error *error)
{
    struct rl_map *m = r->m;
    struct rl_catalogue *c = &m->catalogue;
    if (r->next == c->n_rows)
        return rl_fail(error, RL_ERR_INPUT, "found more points than %zu", c->n_rows);
    for (size_t j = 0; j < m->n_judged; j++) {
        /* The answer, then both bounds over the plain ones, or of 0 the bounds; in absolute terms they are the plain ones. */
        long double x[1 + RL_CATALOGUE_BACKENDS] = {0.0L, 1.0L, 1.0L};
        for (size_t k = 0; k < (m->absolute ? 1 : 3); k++) {
            int status = rest ? number(&x[k], strsep(&rest, "\t"), error)
                              : rl_fail(error, RL_ERR_INPUT, "found too few columns");
            if (status != RL_OK)
                return status;
        }
        for (int b = 0; b < RL_CATALOGUE_BACKENDS; b++)
            c->answers[r->next * r->p->n_out + m->judged[j]][b] = (struct rl_catalogue_answer){
                x[0], (double)x[1 + b] * (x[0] == 0.0L && !m->absolute
                                              ? 1.0
                                              : plain_bound(m, (enum rl_catalogue_backend)b, x[0]))};
    }
    if (rest)
        return rl_fail(error, RL_ERR_INPUT, "found '%.64s' after the last column", rest);
    c->line[r->next++] = line;
    return RL_OK;
}

static int read_line(struct reader *r, char *text, size_t line, struct rl_error *error)
{
    if (r->m->n_judged > 0)
        return read_point(r, text, line, error);
    char *rest = text;
    const char *word = strsep(&rest, "\t");
    static const char *const axis[] = {"across", "up", "all"};
    for (size_t i = 0; i < sizeof axis / sizeof axis[0]; i++)
        if (strcmp(word, axis[i]) == 0)
            return read_axis(r, i, rest, error);
    if (strcmp(word, "ulp") == 0 || strcmp(word, "absolute") == 0)
        return read_header(r, word[0] == 'a', rest, error);
    return rl_fail(error, RL_ERR_INPUT, "found '%.64s', expected across, up, all, ulp or absolute", word);
}

static int read_lines(struct reader *r, char *text, const char *path, struct rl_error *error)
{
    int status = RL_OK;
    size_t line = 1;
    for (char *rest = text, *at; rest && status == RL_OK; line++) {
        at = strsep(&rest, "\n");
        if (at[0] == '#' || at[0] == '\0')
            continue;
        status = read_line(r, at, line, error);
        if (status != RL_OK)
            rl_fail_prefix(error, "%s:%zu", path, line);
    }
    if (status == RL_OK && (r->m->n_judged == 0 || r->next < r->m->catalogue.n_rows))
        return rl_fail(error, RL_ERR_INPUT, "%s: found %zu points, expected %zu", path, r->next,
                       r->m->catalogue.n_rows);
    return status;
}

int rl_map_load(struct rl_map *m, const char *path, struct rl_error *error)
{
    *m = (struct rl_map){0};
    struct reader r = {.m = m, .p = &m->catalogue.probe};
    size_t size;
    for (size_t i = 0; i < RL_PROBE_IN_MAX; i++)
        r.axis[i] = EVERYWHERE;
    int status = rl_catalogue_find_probe(&m->catalogue.probe, path, error);
    if (status == RL_OK)
        status = rl_file_read(&m->catalogue.text, &size, path, error);
    if (status == RL_OK)
        status = read_lines(&r, m->catalogue.text, path, error);
    for (size_t i = 0; i < RL_PROBE_IN_MAX; i++)
        free(r.argument[i]);
    if (status != RL_OK)
        rl_map_free(m);
    return status;
}

void rl_map_free(struct rl_map *m)
{
    rl_catalogue_free(&m->catalogue);
    for (size_t axis = 0; axis < RL_MAP_AXES; axis++)
        free(m->shown[axis]);
    *m = (struct rl_map){0};
}

int rl_map_folder(char path[], size_t size, struct rl_error *error)
{
    int status = rl_catalogue_folder(path, size, error);
    size_t used = status == RL_OK ? strlen(path) : 0;
    if (status == RL_OK && (size_t)snprintf(path + used, size - used, "/maps") >= size - used)
        return rl_fail(error, RL_ERR_SYSTEM, "the path of the maps of hard cases is too long");
    return status;
}

struct rl_map_point rl_map_point_of(const struct rl_map *m, enum rl_catalogue_backend backend,
                                    const double *results, size_t point)
{
    struct rl_map_point worst = {0};
    double one = backend == RL_CATALOGUE_CPU ? DBL_EPSILON : (double)FLT_EPSILON;
    for (size_t j = 0; j < m->n_judged; j++) {
        size_t k = m->judged[j];
        struct rl_catalogue_error e = rl_catalogue_error_of(&m->catalogue, backend, point, k,
                                                            results[point * m->catalogue.probe.n_out + k]);
        worst.ulp = fmax(worst.ulp, m->absolute ? e.error / one : e.ulp);
        worst.share = fmax(worst.share, e.share);
        long double exact = m->catalogue.answers[point * m->catalogue.probe.n_out + k][backend].exact;
        worst.widened = worst.widened || (e.share <= 1.0 && e.error > plain_bound(m, backend, exact));
    }
    return worst;
}
