/* Ranges and spellings of the settings (see settings.h). */
#include "scene/settings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/method.h"
#include "model/ellipsoid.h"

static const char *const texel_format_names[RL_TEXEL_FORMATS] = {
    [RL_TEXEL_RGBA8] = "rgba8",   [RL_TEXEL_RGB10A2] = "rgb10a2", [RL_TEXEL_R11G11B10F] = "r11g11b10f",
    [RL_TEXEL_RGBA16] = "rgba16", [RL_TEXEL_RGBA16F] = "rgba16f", [RL_TEXEL_RGBA32F] = "rgba32f",
};

const char *rl_texel_format_name(enum rl_texel_format format)
{
    return (unsigned)format < RL_TEXEL_FORMATS ? texel_format_names[format] : "unknown";
}

static const char *const interpolation_names[RL_INTERPOLATIONS] = {
    [RL_INTERPOLATION_PHONG] = "phong",
    [RL_INTERPOLATION_GOURAUD] = "gouraud",
    [RL_INTERPOLATION_CONSTANT] = "constant",
};

const char *rl_interpolation_name(enum rl_interpolation interpolation)
{
    return (unsigned)interpolation < RL_INTERPOLATIONS ? interpolation_names[interpolation] : "unknown";
}

void rl_normal_bits_name(char text[16], int bits)
{
    if (bits == RL_NORMAL_BITS_HALF)
        snprintf(text, 16, "half");
    else if (bits == RL_NORMAL_BITS_FLOAT)
        snprintf(text, 16, "float");
    else
        snprintf(text, 16, "%d", bits);
}

static bool power_of_two(int n)
{
    return n > 0 && (n & (n - 1)) == 0;
}

static bool known_bits(int bits)
{
    return (bits >= 4 && bits <= 16) || bits == RL_NORMAL_BITS_HALF || bits == RL_NORMAL_BITS_FLOAT;
}

void rl_method_names(char text[], size_t size)
{
    size_t length = 0;
    text[0] = '\0';
    for (size_t i = 0; i < rl_n_methods && length < size; i++) {
        const char *separator = i == 0 ? "" : i + 1 == rl_n_methods ? " or " : ", ";
        length += (size_t)snprintf(text + length, size - length, "%s%s", separator, rl_methods[i]->name);
    }
}

static int check_method(const struct rl_settings *s, struct rl_error *error)
{
    if (!s->method || rl_method_find(s->method))
        return RL_OK;
    char names[256];
    rl_method_names(names, sizeof names);
    return rl_fail(error, RL_ERR_INPUT, "found '%s', expected %s", s->method, names);
}

static int check_size(int size, struct rl_error *error)
{
    if (size >= 0 && size <= RL_FILM_MAX)
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "found %d, expected 1 to %d pixels", size, RL_FILM_MAX);
}

int rl_settings_check_key(const struct rl_settings *s, const char **key, struct rl_error *error)
{
    *key = "method";
    if (check_method(s, error) != RL_OK)
        return RL_ERR_INPUT;
    *key = "interpolation";
    if (s->interpolation < RL_INTERPOLATION_OF_MATERIAL || s->interpolation >= RL_INTERPOLATIONS)
        return rl_fail(error, RL_ERR_INPUT, "found kind %d, expected phong, gouraud or constant",
                       s->interpolation);
    *key = "samples";
    if (s->samples < 0 || s->samples > RL_SAMPLES_MAX)
        return rl_fail(error, RL_ERR_INPUT, "found %d, expected 1 to %d", s->samples, RL_SAMPLES_MAX);
    *key = "rr";
    if (s->rr != 0.0 && !rl_ellipsoid_valid(s->rr))
        return rl_fail(error, RL_ERR_INPUT, "found %g, expected %g to %g", s->rr, RL_RR_MIN, RL_RR_MAX);
    *key = "normal-bits";
    if (!known_bits(s->normal_bits))
        return rl_fail(error, RL_ERR_INPUT, "found %d, expected 4 to 16, half or float", s->normal_bits);
    *key = "normal-size";
    if (!power_of_two(s->normal_size) || s->normal_size < 64 || s->normal_size > 2048)
        return rl_fail(error, RL_ERR_INPUT, "found %d, expected a power of two from 64 to 2048",
                       s->normal_size);
    *key = "env-size";
    if (s->env_size < 8 || s->env_size > 4096)
        return rl_fail(error, RL_ERR_INPUT, "found %d, expected 8 to 4096", s->env_size);
    *key = "env-format";
    if ((unsigned)s->env_format >= RL_TEXEL_FORMATS)
        return rl_fail(error, RL_ERR_INPUT, "found number %d, expected a texel format", (int)s->env_format);
    *key = "margin";
    if ((unsigned)s->margin_kind > RL_MARGIN_VALUE)
        return rl_fail(error, RL_ERR_INPUT, "found kind %d, expected off, auto or a number",
                       (int)s->margin_kind);
    if (s->margin_kind == RL_MARGIN_VALUE && !(s->margin >= 0.0 && s->margin <= RL_MARGIN_MAX))
        return rl_fail(error, RL_ERR_INPUT, "found %g, expected 0 to %g", s->margin, RL_MARGIN_MAX);
    if (s->margin_kind == RL_MARGIN_AUTO &&
        !(s->margin_bound >= RL_MARGIN_BOUND_MIN && s->margin_bound <= RL_MARGIN_BOUND_MAX))
        return rl_fail(error, RL_ERR_INPUT, "found the bound %g, expected %g to %g", s->margin_bound,
                       RL_MARGIN_BOUND_MIN, RL_MARGIN_BOUND_MAX);
    *key = "size";
    if (check_size(s->width, error) != RL_OK || check_size(s->height, error) != RL_OK)
        return RL_ERR_INPUT;
    *key = "frame";
    if ((unsigned)s->frame > RL_FRAME_PRINTED)
        return rl_fail(error, RL_ERR_INPUT, "found kind %d, expected orthonormal or printed", (int)s->frame);
    *key = "depth-bits";
    if (s->depth_bits != 16 && s->depth_bits != 24 && s->depth_bits != 32)
        return rl_fail(error, RL_ERR_INPUT, "found %d, expected 16, 24 or 32", s->depth_bits);
    *key = "tolerance";
    if (!(s->tolerance >= 1e-12 && s->tolerance <= 0.1))
        return rl_fail(error, RL_ERR_INPUT, "found %g, expected 1e-12 to 0.1", s->tolerance);
    *key = NULL;
    return RL_OK;
}

int rl_settings_check(const struct rl_settings *settings, struct rl_error *error)
{
    const char *key;
    if (rl_settings_check_key(settings, &key, error) == RL_OK)
        return RL_OK;
    rl_fail_prefix(error, "--%s", key);
    return RL_ERR_INPUT;
}

/* `what` is NULL where the caller names the place itself. */
static int fail_parse(struct rl_error *error, const char *what, const char *text, const char *expected)
{
    return rl_fail(error, RL_ERR_INPUT, "%s%sfound '%.40s', expected %s", what ? what : "", what ? ": " : "",
                   text, expected);
}

int rl_parse_texel_format(enum rl_texel_format *format, const char *text, const char *what,
                          struct rl_error *error)
{
    for (int i = 0; i < RL_TEXEL_FORMATS; i++)
        if (strcmp(text, texel_format_names[i]) == 0) {
            *format = (enum rl_texel_format)i;
            return RL_OK;
        }
    return fail_parse(error, what, text, "rgba8, rgb10a2, r11g11b10f, rgba16, rgba16f or rgba32f");
}

int rl_parse_normal_bits(int *bits, const char *text, const char *what, struct rl_error *error)
{
    char *end;
    long n = strtol(text, &end, 10);
    if (strcmp(text, "half") == 0)
        *bits = RL_NORMAL_BITS_HALF;
    else if (strcmp(text, "float") == 0)
        *bits = RL_NORMAL_BITS_FLOAT;
    else if (end != text && *end == '\0' && n >= 4 && n <= 16)
        *bits = (int)n;
    else
        return fail_parse(error, what, text, "4 to 16, half or float");
    return RL_OK;
}

/* A number of the range and nothing behind it. */
static bool parse_number(double *value, const char *text, double low, double high)
{
    char *end;
    double x = strtod(text, &end);
    if (end == text || *end != '\0' || !(x >= low && x <= high))
        return false;
    *value = x;
    return true;
}

int rl_parse_margin(struct rl_settings *settings, const char *text, const char *what, struct rl_error *error)
{
    static const char with_bound[] = "auto:";
    if (strcmp(text, "off") == 0) {
        settings->margin_kind = RL_MARGIN_OFF;
    } else if (strcmp(text, "auto") == 0) {
        settings->margin_kind = RL_MARGIN_AUTO;
        settings->margin_bound = RL_MARGIN_BOUND;
    } else if (strncmp(text, with_bound, strlen(with_bound)) == 0) {
        if (!parse_number(&settings->margin_bound, text + strlen(with_bound), RL_MARGIN_BOUND_MIN,
                          RL_MARGIN_BOUND_MAX))
            return fail_parse(error, what, text, "a bound from 1e-6 to 0.999 behind auto:");
        settings->margin_kind = RL_MARGIN_AUTO;
    } else if (parse_number(&settings->margin, text, 0.0, RL_MARGIN_MAX)) {
        settings->margin_kind = RL_MARGIN_VALUE;
    } else {
        return fail_parse(error, what, text, "off, auto, auto:BOUND or a number from 0 to 1e6");
    }
    return RL_OK;
}

void rl_margin_name(char text[32], const struct rl_settings *settings)
{
    if (settings->margin_kind == RL_MARGIN_OFF)
        snprintf(text, 32, "off");
    else if (settings->margin_kind == RL_MARGIN_AUTO)
        snprintf(text, 32, "auto:%g", settings->margin_bound);
    else
        snprintf(text, 32, "%g", settings->margin);
}

int rl_parse_frame(enum rl_frame_kind *frame, const char *text, const char *what, struct rl_error *error)
{
    static const enum rl_frame_kind kinds[] = {RL_FRAME_ORTHONORMAL, RL_FRAME_PRINTED};
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        if (strcmp(text, rl_frame_name(kinds[i])) == 0) {
            *frame = kinds[i];
            return RL_OK;
        }
    return fail_parse(error, what, text, "orthonormal or printed");
}

int rl_parse_interpolation(int *interpolation, const char *text, const char *what, struct rl_error *error)
{
    for (int i = 0; i < RL_INTERPOLATIONS; i++)
        if (strcmp(text, interpolation_names[i]) == 0) {
            *interpolation = i;
            return RL_OK;
        }
    return fail_parse(error, what, text, "phong, gouraud or constant");
}
