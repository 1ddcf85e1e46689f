/* Reads axes and puts their values into planned cases (see axis.h). What values a parameter takes is in sweep.c. */
#include "studies/axis.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "studies/axis_merge.h"
#include "studies/bench.h"

static int fail_form(struct rl_error *error, const char *text)
{
    return rl_fail(
        error, RL_ERR_INPUT,
        "--axis: found '%.100s', expected NAME=VALUE,VALUE,... or NAME=FROM:TO:logN or NAME=FROM:TO:linN",
        text);
}

/* The fewest digits that read back as the same number, but at least the 6 of printf's %g: as studies write them. */
static void write_number(char text[RL_AXIS_VALUE_LENGTH], double value)
{
    for (int digits = 6; digits <= 17; digits++) {
        snprintf(text, RL_AXIS_VALUE_LENGTH, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            return;
    }
}

static bool is_number(const char *text, double *value)
{
    char *end;
    *value = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*value);
}

static int parse_list(struct rl_axis *axis, const char *list, struct rl_error *error)
{
    for (const char *at = list;;) {
        size_t length = strcspn(at, ",");
        if (length == 0 || length >= RL_AXIS_VALUE_LENGTH || strcspn(at, "=") < length)
            return fail_form(error, axis->text);
        if (axis->n == RL_AXIS_VALUES_MAX)
            return rl_fail(error, RL_ERR_INPUT, "--axis %s: more than %d values", axis->name,
                           RL_AXIS_VALUES_MAX);
        char *value = axis->value[axis->n++];
        snprintf(value, RL_AXIS_VALUE_LENGTH, "%.*s", (int)length, at);
        double number;
        if (is_number(value, &number))
            write_number(value, number);
        at += length;
        if (*at++ == '\0')
            return RL_OK;
    }
}

/* A number at *text, which moves behind it and the character that has to follow; false if that is not what is there. */
static bool take_number(const char **text, char follows, double *value)
{
    char *end;
    *value = strtod(*text, &end);
    if (end == *text || *end != follows || !isfinite(*value))
        return false;
    *text = end + (follows != '\0');
    return true;
}

/* Values from `from` to `to`, both included. */
static void fill_range(struct rl_axis *axis, double from, double to, size_t n, bool logarithmic)
{
    axis->range = true;
    axis->n = n;
    for (size_t i = 0; i < n; i++) {
        double t = (double)i / (double)(n - 1);
        double value = logarithmic ? from * pow(to / from, t) : from + t * (to - from);
        snprintf(axis->value[i], RL_AXIS_VALUE_LENGTH, "%.6g", i == 0 ? from : i == n - 1 ? to : value);
    }
}

/* FROM:TO:logN */
static int parse_range(struct rl_axis *axis, const char *range, struct rl_error *error)
{
    double from, to, n;
    const char *at = range;
    if (!take_number(&at, ':', &from) || !take_number(&at, ':', &to))
        return fail_form(error, axis->text);
    bool logarithmic = strncmp(at, "log", 3) == 0;
    if (!logarithmic && strncmp(at, "lin", 3) != 0)
        return fail_form(error, axis->text);
    at += 3;
    if (!take_number(&at, '\0', &n) || n != floor(n))
        return fail_form(error, axis->text);
    if (n < 2.0 || n > RL_AXIS_VALUES_MAX)
        return rl_fail(error, RL_ERR_INPUT, "--axis %s: found %.0f values, expected 2 to %d", axis->name, n,
                       RL_AXIS_VALUES_MAX);
    if (logarithmic && !(from > 0.0 && to > 0.0))
        return rl_fail(error, RL_ERR_INPUT, "--axis %s: found '%.60s', expected ends above 0 for log",
                       axis->name, range);
    fill_range(axis, from, to, (size_t)n, logarithmic);
    return RL_OK;
}

int rl_axis_parse(struct rl_axis *axis, const char *text, struct rl_error *error)
{
    *axis = (struct rl_axis){.text = text};
    size_t length = strcspn(text, "=");
    /* Nothing that would have to be quoted where a case's parameters or a command are written. */
    bool plain =
        text[strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._,:=+-")] == '\0';
    if (!plain || length == 0 || length >= sizeof axis->name || text[length] != '=')
        return fail_form(error, text);
    snprintf(axis->name, sizeof axis->name, "%.*s", (int)length, text);
    const char *values = text + length + 1;
    return strchr(values, ':') ? parse_range(axis, values, error) : parse_list(axis, values, error);
}

int rl_parameters_replace(char out[RL_PARAMETERS_MAX], const char *parameters, const char *key,
                          const char *value, struct rl_error *error)
{
    size_t used = 0, n_key = strlen(key);
    out[0] = '\0';
    for (const char *at = parameters; *at && used < RL_PARAMETERS_MAX;) {
        size_t length = strcspn(at, " ");
        bool found = strncmp(at, key, n_key) == 0 && at[n_key] == '=';
        used += (size_t)(found ? snprintf(out + used, RL_PARAMETERS_MAX - used, "%s%s=%s", used ? " " : "",
                                          key, value)
                               : snprintf(out + used, RL_PARAMETERS_MAX - used, "%s%.*s", used ? " " : "",
                                          (int)length, at));
        at += length;
        at += strspn(at, " ");
    }
    if (used >= RL_PARAMETERS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "%s=%s: a case's parameters are longer than %d bytes", key, value,
                       RL_PARAMETERS_MAX - 1);
    return RL_OK;
}

/* Adds the case with other parameters, in another group. */
static int add_case(struct rl_run *run, const struct rl_record *r, const char *parameters, int group,
                    struct rl_error *error)
{
    if (run->n_records == RL_AXES_CASES_MAX)
        return rl_fail(error, RL_ERR_INPUT, "--axis: more than %d cases", RL_AXES_CASES_MAX);
    struct rl_place place = {r->study, r->scene, r->scene_path, strtoull(r->scene_hash, NULL, 16)};
    return rl_run_add(run, &place, group, error, "%s", parameters) ? RL_OK : RL_ERR_SYSTEM;
}

/* The case with value `v` of the axis, or as it is where it is none that the axis is about. */
static int add_value(struct rl_run *out, const struct rl_record *r, const struct rl_axis *axis, size_t v,
                     const struct rl_sweep *sweep, int group, struct rl_error *error)
{
    char renamed[RL_PARAMETERS_MAX], parameters[RL_PARAMETERS_MAX];
    snprintf(parameters, sizeof parameters, "%s", r->parameters);
    int status = RL_OK;
    if (sweep)
        status = rl_parameters_replace(parameters, r->parameters, axis->name, axis->value[v], error);
    if (sweep && sweep->named_by && status == RL_OK) {
        status = rl_parameters_replace(renamed, parameters, sweep->named_by, axis->value[v], error);
        memcpy(parameters, renamed, sizeof parameters);
    }
    return status == RL_OK ? add_case(out, r, parameters, group, error) : status;
}

/* The group of records from `first` on, once for each value; where these stay together, once with all of them; without the
 * parameter, as it is. */
static int expand_group(struct rl_run *out, const struct rl_run *run, size_t first, size_t end,
                        const struct rl_axis *axis, const struct rl_sweeps *sweeps, struct rl_error *error)
{
    size_t n_groups = 1;
    for (size_t i = first; i < end; i++) {
        const struct rl_sweep *s =
            rl_sweep_find(sweeps->sweep, sweeps->n, axis->name, run->record[i].parameters);
        n_groups = s && !s->together ? axis->n : n_groups;
    }
    int status = RL_OK;
    for (size_t g = 0; g < n_groups && status == RL_OK; g++) {
        int group = out->n_records ? out->record[out->n_records - 1].group + 1 : 0;
        for (size_t i = first; i < end && status == RL_OK; i++) {
            const struct rl_record *r = &run->record[i];
            const struct rl_sweep *s = rl_sweep_find(sweeps->sweep, sweeps->n, axis->name, r->parameters);
            if (!s || !s->together)
                status = add_value(out, r, axis, g, s, group, error);
            for (size_t v = 0; s && s->together && v < axis->n && status == RL_OK; v++)
                status = add_value(out, r, axis, v, s, group, error);
        }
    }
    return status;
}

static int apply(struct rl_run *run, const struct rl_axis *axis, const struct rl_sweeps *sweeps,
                 struct rl_error *error)
{
    struct rl_run out = {0};
    int status = RL_OK;
    for (size_t first = 0, end; first < run->n_records && status == RL_OK; first = end) {
        for (end = first + 1; end < run->n_records && run->record[end].group == run->record[first].group;)
            end++;
        status = expand_group(&out, run, first, end, axis, sweeps, error);
    }
    if (status == RL_OK)
        status = rl_axis_merge(&out, error);
    if (status != RL_OK) {
        rl_run_clear(&out);
        return status;
    }
    free(run->record);
    run->record = out.record;
    run->n_records = out.n_records;
    return RL_OK;
}

/* The names that there are, or what is wrong with one that there is. */
static int fail_name(const struct rl_axis *axis, const struct rl_run *run, const struct rl_sweeps *sweeps,
                     struct rl_error *error)
{
    char names[256], text[RL_NAME_MAX];
    bool has = false;
    rl_sweep_names(names, sizeof names, sweeps->sweep, sweeps->n);
    for (size_t i = 0; i < run->n_records; i++)
        has = has || rl_parameter(run->record[i].parameters, axis->name, text, sizeof text);
    return rl_fail(error, RL_ERR_INPUT, "--axis %s: %s the study %s%s, expected one of %s", axis->name,
                   has ? "belongs to what cases are told apart by in" : "no parameter of", run->study,
                   has ? " and is not replaced" : "", names[0] ? names : "none");
}

/* Before anything is changed: every value is one that each of the cases takes. Values of a range become whole where whole ones are
 * taken. */
static int check_axis(struct rl_axis *axis, const struct rl_run *run, const struct rl_sweeps *sweeps,
                      struct rl_error *error)
{
    const struct rl_sweep *last = NULL;
    for (size_t i = 0; i < run->n_records; i++) {
        const struct rl_sweep *s =
            rl_sweep_find(sweeps->sweep, sweeps->n, axis->name, run->record[i].parameters);
        if (!s || s == last)
            continue;
        last = s;
        if (s->together && axis->n > (size_t)s->together)
            return rl_fail(error, RL_ERR_INPUT, "--axis %s: found %zu values, expected at most %d",
                           axis->name, axis->n, s->together);
        for (size_t v = 0; v < axis->n; v++) {
            if (s->kind == RL_SWEEP_WHOLE && axis->range)
                snprintf(axis->value[v], RL_AXIS_VALUE_LENGTH, "%.0f", round(strtod(axis->value[v], NULL)));
            int status = rl_sweep_check(s, axis->value[v], error);
            if (status != RL_OK)
                return status;
        }
    }
    return last ? RL_OK : fail_name(axis, run, sweeps, error);
}

/* What the settings' own rules and the study's say of the cases as they have become. What names no method is not drawn by the bench, and
 * its `samples` may be another thing. */
static int check_cases(const struct rl_run *run, rl_parameters_check *check, struct rl_error *error)
{
    for (size_t i = 0; i < run->n_records; i++) {
        struct rl_settings settings;
        const char *parameters = run->record[i].parameters;
        char method[RL_NAME_MAX];
        int status = rl_parameter(parameters, "method", method, sizeof method)
                         ? rl_bench_settings(&settings, parameters, error)
                         : RL_OK;
        if (status == RL_OK && check)
            status = check(parameters, error);
        if (status != RL_OK) {
            rl_fail_prefix(error, "--axis: %s", parameters);
            return status;
        }
    }
    return RL_OK;
}

static bool swept(const struct rl_axis *axes, size_t n, const char *name)
{
    bool found = false;
    for (size_t i = 0; i < n; i++)
        found = found || strcmp(axes[i].name, name) == 0;
    return found;
}

static int apply_all(struct rl_run *run, const struct rl_axis *axes, size_t n_axes, struct rl_axis *axis,
                     const struct rl_sweeps *sweeps, struct rl_error *error)
{
    for (size_t i = 0; i < n_axes; i++) {
        if (swept(axes, i, axes[i].name))
            return rl_fail(error, RL_ERR_INPUT, "--axis %s: given twice", axes[i].name);
        *axis = axes[i];
        int status = check_axis(axis, run, sweeps, error);
        if (status == RL_OK)
            status = apply(run, axis, sweeps, error);
        if (status != RL_OK)
            return status;
    }
    return RL_OK;
}

int rl_axes_apply(struct rl_run *run, const struct rl_axis *axes, size_t n_axes,
                  const struct rl_sweeps *sweeps, rl_parameters_check *check, struct rl_error *error)
{
    if (n_axes == 0)
        return RL_OK;
    struct rl_axis *axis = malloc(sizeof *axis);
    if (!axis)
        return rl_fail_memory(error, "an axis");
    int status = apply_all(run, axes, n_axes, axis, sweeps, error);
    free(axis);
    for (size_t k = 0; rl_axis_extras[k] && status == RL_OK; k++)
        if (!swept(axes, n_axes, rl_axis_extras[k])) /* who asks for several gets them */
            rl_axis_drop_less(run, rl_axis_extras[k]);
    return status == RL_OK ? check_cases(run, check, error) : status;
}
