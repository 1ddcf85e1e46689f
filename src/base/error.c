/* Formats error messages (see error.h). */
#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>

void rl_error_set(struct rl_error *error, enum rl_status status, const char *format, ...)
{
    if (!error)
        return;
    va_list arguments;
    va_start(arguments, format);
    error->status = status;
    vsnprintf(error->message, sizeof error->message, format, arguments);
    va_end(arguments);
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
    return error->status;
}
