/* Text that grows (see buffer.h). */
#include "results/buffer.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"

/* Room for `more` bytes and the NUL. */
static bool reserve(struct rl_buffer *b, size_t more)
{
    if (b->failed)
        return false;
    if (b->capacity - b->length > more)
        return true;
    size_t capacity = b->capacity ? b->capacity : 1024;
    while (capacity - b->length <= more)
        capacity *= 2;
    char *data = realloc(b->data, capacity);
    if (!data) {
        b->failed = true;
        return false;
    }
    b->data = data;
    b->capacity = capacity;
    return true;
}

static void add_bytes(struct rl_buffer *b, const char *text, size_t n)
{
    if (!reserve(b, n))
        return;
    memcpy(b->data + b->length, text, n);
    b->length += n;
    b->data[b->length] = '\0';
}

void rl_buffer_add(struct rl_buffer *b, const char *text)
{
    add_bytes(b, text, strlen(text));
}

void rl_buffer_printf(struct rl_buffer *b, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    va_list again;
    va_copy(again, arguments);
    int n = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    if (n >= 0 && reserve(b, (size_t)n)) {
        vsnprintf(b->data + b->length, (size_t)n + 1, format, again);
        b->length += (size_t)n;
    }
    va_end(again);
}

void rl_buffer_number(struct rl_buffer *b, double value)
{
    char text[32];
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            break;
    }
    rl_buffer_add(b, isnan(value) ? "nan" : text);
}

void rl_buffer_json(struct rl_buffer *b, const char *text)
{
    rl_buffer_add(b, "\"");
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\')
            rl_buffer_printf(b, "\\%c", *c);
        else if (*c < 0x20)
            rl_buffer_printf(b, "\\u%04x", *c);
        else
            add_bytes(b, (const char *)c, 1);
    }
    rl_buffer_add(b, "\"");
}

int rl_buffer_check(const struct rl_buffer *b, struct rl_error *error)
{
    return b->failed ? rl_fail_memory(error, "a page or table") : RL_OK;
}

int rl_buffer_write(const struct rl_buffer *b, const char *path, struct rl_error *error)
{
    int status = rl_buffer_check(b, error);
    if (status != RL_OK)
        return status;
    return rl_file_write(path, b->data ? b->data : "", b->length, error);
}

void rl_buffer_clear(struct rl_buffer *b)
{
    free(b->data);
    *b = (struct rl_buffer){0};
}
