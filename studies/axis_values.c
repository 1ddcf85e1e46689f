/* What values a parameter takes, found out from its consumer, the bench, and from what the study itself plans (see axis_values.h). */
#include "studies/axis_values.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "studies/bench.h"

/* A parameter as the study's own cases have it. */
struct planned {
    size_t n;
    bool numbers, whole, has_zero, has_negative;
    bool
        settings; /* all of its cases are ones that the bench takes: then those with a new value have to be too */
};

/* Whether the bench refuses this text as the value of the parameter. */
static bool refused(const char *name, const char *value)
{
    char parameters[RL_NAME_MAX + 16];
    struct rl_settings settings;
    snprintf(parameters, sizeof parameters, "%s=%s", name, value);
    return rl_bench_settings(&settings, parameters, NULL) != RL_OK;
}

static struct planned look(const struct rl_run *run, const char *name)
{
    struct planned p = {.numbers = true, .whole = true, .settings = true};
    char text[RL_NAME_MAX];
    struct rl_settings settings;
    for (size_t i = 0; i < run->n_records; i++) {
        const char *parameters = run->record[i].parameters;
        if (!rl_parameter(parameters, name, text, sizeof text))
            continue;
        double x = rl_parameter_number(parameters, name);
        p.n++;
        p.numbers = p.numbers && isfinite(x);
        p.whole = p.whole && x == floor(x);
        p.has_zero = p.has_zero || x == 0.0;
        p.has_negative = p.has_negative || x < 0.0;
        p.settings = p.settings && rl_bench_settings(&settings, parameters, NULL) == RL_OK;
    }
    return p;
}

/* "method, rr, samples": what could have been asked for, in the order of their first case. */
static int fail_name(const struct rl_axis *axis, const struct rl_run *run, struct rl_error *error)
{
    char names[512] = "";
    size_t used = 0;
    for (size_t i = 0; i < run->n_records; i++)
        for (const char *at = run->record[i].parameters; *at;) {
            /* With what stands around it, so that "size" is not found in "env_size". */
            char word[RL_NAME_MAX + 4];
            snprintf(word, sizeof word, " %.*s,", (int)strcspn(at, "= "), at);
            if (!strstr(names, word) && used + strlen(word) < sizeof names)
                used += (size_t)snprintf(names + used, sizeof names - used, "%s", word);
            at += strcspn(at, " ");
            at += strspn(at, " ");
        }
    if (used > 0)
        names[used - 1] = '\0';
    return rl_fail(error, RL_ERR_INPUT,
                   "--axis %s: no case of the study %s has that parameter, expected one of%s", axis->name,
                   run->study, used ? names : " none: it has no cases");
}

/* Numbers like the study's own: whole if these are, above 0 if these are, not below 0 if these are not. */
static int check_number(const struct rl_axis *axis, const char *value, bool whole, const struct planned *p,
                        struct rl_error *error)
{
    char *end;
    double x = strtod(value, &end);
    bool number = end != value && *end == '\0' && isfinite(x);
    bool low = p->has_negative ? false : p->has_zero ? x < 0.0 : x <= 0.0;
    if (number && !low && (!whole || x == floor(x)))
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "--axis %s: found '%s', expected a %snumber%s", axis->name, value,
                   whole ? "whole " : "",
                   p->has_negative ? ""
                   : p->has_zero   ? " from 0 on"
                                   : " above 0");
}

/* One of the words that the study itself uses: they name what it knows how to measure. */
static int check_word(const struct rl_axis *axis, const char *value, const struct rl_run *run,
                      struct rl_error *error)
{
    char words[256] = "", word[RL_NAME_MAX + 4], text[RL_NAME_MAX];
    size_t used = 0;
    for (size_t i = 0; i < run->n_records; i++) {
        if (!rl_parameter(run->record[i].parameters, axis->name, text, sizeof text))
            continue;
        if (strcmp(text, value) == 0)
            return RL_OK;
        snprintf(word, sizeof word, " %s,", text);
        if (!strstr(words, word) && used + strlen(word) < sizeof words)
            used += (size_t)snprintf(words + used, sizeof words - used, "%s", word);
    }
    words[used - 1] = '\0';
    return rl_fail(error, RL_ERR_INPUT, "--axis %s: found '%s', expected one of%s", axis->name, value, words);
}

/* Every case with the new value is one that the study takes and, if its cases are of that kind, the bench. */
static int check_cases(const struct rl_axis *axis, const char *value, const struct rl_run *run, bool settings,
                       rl_parameters_check *check, struct rl_error *error)
{
    char parameters[RL_PARAMETERS_MAX], text[RL_NAME_MAX];
    struct rl_settings made;
    for (size_t i = 0; i < run->n_records; i++) {
        if (!rl_parameter(run->record[i].parameters, axis->name, text, sizeof text))
            continue;
        int status = rl_parameters_replace(parameters, run->record[i].parameters, axis->name, value, error);
        if (status == RL_OK && settings)
            status = rl_bench_settings(&made, parameters, error);
        if (status == RL_OK && check)
            status = check(parameters, error);
        if (status != RL_OK) {
            rl_fail_prefix(error, "--axis %s=%s", axis->name, value);
            return status;
        }
    }
    return RL_OK;
}

int rl_axis_check(struct rl_axis *axis, const struct rl_run *run, rl_parameters_check *check,
                  struct rl_error *error)
{
    struct planned p = look(run, axis->name);
    if (p.n == 0)
        return fail_name(axis, run, error);
    /* The bench tells what it knows by what it refuses; a parameter it does not know it lets pass, whatever the value. */
    bool bench_word = refused(axis->name, "?");
    bool bench_knows = bench_word || refused(axis->name, "-1e30");
    bool whole = p.numbers && p.whole && (!bench_knows || refused(axis->name, "1.5"));
    int status = RL_OK;
    for (size_t v = 0; v < axis->n && status == RL_OK; v++) {
        char *value = axis->value[v];
        if (whole && axis->range)
            snprintf(value, RL_AXIS_VALUE_LENGTH, "%.0f", round(strtod(value, NULL)));
        if (!bench_word)
            status =
                p.numbers ? check_number(axis, value, whole, &p, error) : check_word(axis, value, run, error);
        if (status == RL_OK)
            status = check_cases(axis, value, run, p.settings, check, error);
    }
    return status;
}
