/* See json.h. */
#include "cli/json.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void string(const char *text)
{
    putchar('"');
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\')
            printf("\\%c", *c);
        else if (*c < 0x20)
            printf("\\u%04x", *c);
        else
            putchar(*c);
    }
    putchar('"');
}

static void begin_value(struct rl_json *json, const char *key)
{
    if (json->filled)
        fputs(", ", stdout);
    if (key) {
        string(key);
        fputs(": ", stdout);
    }
    json->filled = true;
}

void rl_json_open(struct rl_json *json, const char *key, char bracket)
{
    if (!json)
        return;
    begin_value(json, key);
    putchar(bracket);
    json->filled = false;
}

void rl_json_close(struct rl_json *json, char bracket)
{
    if (!json)
        return;
    putchar(bracket);
    json->filled = true;
}

void rl_json_text(struct rl_json *json, const char *key, const char *value)
{
    if (!json)
        return;
    begin_value(json, key);
    if (value)
        string(value);
    else
        fputs("null", stdout);
}

void rl_print_number(double value)
{
    char text[32];
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            break;
    }
    fputs(text, stdout);
}

void rl_json_number(struct rl_json *json, const char *key, double value)
{
    if (!json)
        return;
    begin_value(json, key);
    if (isfinite(value))
        rl_print_number(value);
    else
        fputs("null", stdout);
}

void rl_json_integer(struct rl_json *json, const char *key, long long value)
{
    if (!json)
        return;
    begin_value(json, key);
    printf("%lld", value);
}

void rl_json_boolean(struct rl_json *json, const char *key, bool value)
{
    if (!json)
        return;
    begin_value(json, key);
    fputs(value ? "true" : "false", stdout);
}
