/* What values a swept parameter takes, and in words (see sweep.h). */
#include "studies/sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "results/record.h"

const char *const rl_sweep_normal_bits[] = {"4",  "5",  "6",  "7",  "8",  "9",    "10",    "11",
                                            "12", "13", "14", "15", "16", "half", "float", NULL};
const char *const rl_sweep_env_formats[] = {"rgba8",   "rgb10a2", "r11g11b10f", "rgba16",
                                            "rgba16f", "rgba32f", NULL};

bool rl_sweep_applies(const struct rl_sweep *sweep, const char *parameters)
{
    char value[RL_NAME_MAX], name[RL_NAME_MAX], *end;
    if (!rl_parameter(parameters, sweep->name, value, sizeof value))
        return false;
    if (sweep->of && !rl_parameters_match(parameters, sweep->of))
        return false;
    if (!sweep->named_by)
        return true;
    (void)strtod(value, &end);
    return end != value && *end == '\0' && rl_parameter(parameters, sweep->named_by, name, sizeof name) &&
           strcmp(name, value) == 0;
}

const struct rl_sweep *rl_sweep_find(const struct rl_sweep *sweeps, size_t n, const char *name,
                                     const char *parameters)
{
    for (size_t i = 0; i < n; i++)
        if (strcmp(sweeps[i].name, name) == 0 && rl_sweep_applies(&sweeps[i], parameters))
            return &sweeps[i];
    return NULL;
}

static void append(char text[], size_t size, const char *word, const char *between)
{
    size_t used = strlen(text);
    snprintf(text + used, size - used, "%s%s", used ? between : "", word);
}

void rl_sweep_values(char text[], size_t size, const struct rl_sweep *sweep)
{
    static const char *const kind[] = {[RL_SWEEP_WHOLE] = "a whole number",
                                       [RL_SWEEP_REAL] = "a number",
                                       [RL_SWEEP_POWER_OF_TWO] = "a power of two"};
    text[0] = '\0';
    if (sweep->kind == RL_SWEEP_WORD)
        for (const char *const *word = sweep->words; word && *word; word++)
            append(text, size, *word, word[1] ? ", " : " or ");
    else
        snprintf(text, size, "%s from %g to %g", kind[sweep->kind], sweep->low, sweep->high);
}

void rl_sweep_names(char text[], size_t size, const struct rl_sweep *sweeps, size_t n)
{
    text[0] = '\0';
    for (size_t i = 0; i < n; i++) {
        bool again = false;
        for (size_t k = 0; k < i; k++)
            again = again || strcmp(sweeps[k].name, sweeps[i].name) == 0;
        if (!again)
            append(text, size, sweeps[i].name, ", ");
    }
}

int rl_sweep_check(const struct rl_sweep *sweep, const char *value, struct rl_error *error)
{
    char expected[256], *end;
    double x = strtod(value, &end);
    bool number = end != value && *end == '\0' && x >= sweep->low && x <= sweep->high;
    bool whole = number && x == floor(x);
    if (sweep->kind == RL_SWEEP_REAL ? number : sweep->kind == RL_SWEEP_WHOLE && whole)
        return RL_OK;
    if (sweep->kind == RL_SWEEP_POWER_OF_TWO && whole && ((long)x & ((long)x - 1)) == 0)
        return RL_OK;
    for (const char *const *word = sweep->words; word && *word; word++)
        if (strcmp(*word, value) == 0)
            return RL_OK;
    rl_sweep_values(expected, sizeof expected, sweep);
    return rl_fail(error, RL_ERR_INPUT, "--axis %s: found '%s', expected %s%s", sweep->name, value,
                   sweep->kind == RL_SWEEP_WORD ? "one of " : "", expected);
}
