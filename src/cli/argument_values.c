/* What options were given, and their values as numbers and vectors (see command.h). */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"

const char *rl_argument_nth(const struct rl_arguments *a, const char *name, size_t n)
{
    for (size_t i = 0; i < a->n_given; i++)
        if (strcmp(a->given[i].option->name, name) == 0 && n-- == 0)
            return a->given[i].value;
    return NULL;
}

const char *rl_argument(const struct rl_arguments *a, const char *name)
{
    const char *value = NULL;
    for (size_t i = 0; i < a->n_given; i++)
        if (strcmp(a->given[i].option->name, name) == 0)
            value = a->given[i].value;
    return value;
}

bool rl_argument_flag(const struct rl_arguments *a, const char *name)
{
    for (size_t i = 0; i < a->n_given; i++)
        if (strcmp(a->given[i].option->name, name) == 0)
            return true;
    return false;
}

bool rl_text_number(const char *text, double *value)
{
    char *end = NULL;
    if (*text == '\0' || isspace((unsigned char)*text))
        return false;
    double x = strtod(text, &end);
    if (*end != '\0' || !isfinite(x))
        return false;
    *value = x;
    return true;
}

int rl_argument_integer(const struct rl_arguments *a, const char *name, long long low, long long high,
                        long long *value, struct rl_error *error)
{
    const char *text = rl_argument(a, name);
    if (!text)
        return RL_OK;
    char *end = NULL;
    errno = 0;
    long long x = strtoll(text, &end, 10);
    if (end == text || *end != '\0' || errno != 0 || x < low || x > high)
        return rl_fail(error, RL_ERR_INPUT, "--%s: found '%s', expected a whole number from %lld to %lld",
                       name, text, low, high);
    *value = x;
    return RL_OK;
}

int rl_argument_number(const struct rl_arguments *a, const char *name, double low, double high, double *value,
                       struct rl_error *error)
{
    const char *text = rl_argument(a, name);
    if (!text)
        return RL_OK;
    double x;
    if (!rl_text_number(text, &x) || x < low || x > high)
        return rl_fail(error, RL_ERR_INPUT, "--%s: found '%s', expected a number from %g to %g", name, text,
                       low, high);
    *value = x;
    return RL_OK;
}

bool rl_text_vector(const char **text, rl_vec3 *v)
{
    double c[3];
    for (int i = 0; i < 3; i++) {
        char *end = NULL;
        c[i] = strtod(*text, &end);
        if (end == *text || !isfinite(c[i]) || (i < 2 && *end != ','))
            return false;
        *text = i < 2 ? end + 1 : end;
    }
    *v = v3(c[0], c[1], c[2]);
    return **text == '\0' || isspace((unsigned char)**text);
}

int rl_argument_vector(const struct rl_arguments *a, const char *name, bool direction, rl_vec3 *v,
                       struct rl_error *error)
{
    const char *text = rl_argument(a, name);
    if (!text)
        return RL_OK;
    const char *rest = text;
    if (!rl_text_vector(&rest, v) || *rest != '\0')
        return rl_fail(error, RL_ERR_INPUT, "--%s: found '%s', expected three finite numbers x,y,z", name,
                       text);
    if (!direction)
        return RL_OK;
    *v = v3_normalize(*v);
    if (!(v3_dot(*v, *v) > 0.0))
        return rl_fail(error, RL_ERR_INPUT, "--%s: found the zero vector '%s', expected a direction", name,
                       text);
    return RL_OK;
}
