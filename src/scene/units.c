/* Numbers with a photometric unit (see units.h). */
#include "scene/units.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    enum rl_unit unit;
} units[] = {
    {"lm", RL_UNIT_LUMEN},        {"cd", RL_UNIT_CANDELA},       {"lx", RL_UNIT_LUX},
    {"cd/m2", RL_UNIT_LUMINANCE}, {"cd/m^2", RL_UNIT_LUMINANCE}, {"cd/m\xc2\xb2", RL_UNIT_LUMINANCE},
};
enum { N_UNITS = sizeof units / sizeof units[0] };

static const struct {
    char letter;
    double factor;
} prefixes[] = {{'m', 1e-3}, {'k', 1e3}, {'M', 1e6}};

const char *rl_unit_name(enum rl_unit unit)
{
    return units[unit].name;
}

static enum rl_unit find_unit(const char *text)
{
    for (size_t i = 0; i < N_UNITS; i++)
        if (strcmp(units[i].name, text) == 0)
            return units[i].unit;
    return RL_UNIT_UNKNOWN;
}

bool rl_measure_scan(double *value, enum rl_unit *unit, const char *text)
{
    /* strtod would take hexadecimal numbers, inf and nan as well; no unit begins with one of these characters. */
    char number[64], *end;
    size_t length = strspn(text, "+-.0123456789eE");
    if (length == 0 || length >= sizeof number)
        return false;
    memcpy(number, text, length);
    number[length] = '\0';
    errno = 0;
    *value = strtod(number, &end);
    if (*end != '\0' || !isfinite(*value) || errno != 0)
        return false;
    text += length + strspn(text + length, " \t");
    *unit = *text == '\0' ? RL_UNIT_NONE : find_unit(text);
    for (size_t i = 0; *unit == RL_UNIT_UNKNOWN && i < sizeof prefixes / sizeof prefixes[0]; i++)
        if (*text == prefixes[i].letter && (*unit = find_unit(text + 1)) != RL_UNIT_UNKNOWN)
            *value *= prefixes[i].factor;
    return true;
}
