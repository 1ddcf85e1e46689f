/* Formats error messages (see error.h). */
#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>

/* Names, values and libraries' words come from outside and are quoted as they are: none of them may break the line, or tell a terminal what
 * to do. Bytes above ASCII stay: they are somebody's letters. */
static void keep_to_one_line(char *text)
{
    for (; *text; text++)
        if ((unsigned char)*text < ' ' || *text == 0x7f)
            *text = '?';
}

void rl_error_set(struct rl_error *error, enum rl_status status, const char *format, ...)
{
    if (!error)
        return;
    va_list arguments;
    va_start(arguments, format);
    error->status = status;
    vsnprintf(error->message, sizeof error->message, format, arguments);
    va_end(arguments);
    keep_to_one_line(error->message);
}

int rl_fail_prefix(struct rl_error *error, const char *format, ...)
{
    if (!error)
        return RL_ERR_SYSTEM;
    char prefix[sizeof error->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(prefix, sizeof prefix, format, arguments);
    va_end(arguments);

    struct rl_error old = *error;
    /* A prefix that leaves no room for the message is cut: the message says more. */
    snprintf(error->message, sizeof error->message, "%.400s: %.600s", prefix, old.message);
    keep_to_one_line(error->message);
    return error->status;
}
