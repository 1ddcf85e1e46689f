/* Text that grows: pages and tables are put together here and written to their file in one piece.
 *
 *     struct rl_buffer text = {0};
 *     rl_buffer_printf(&text, "%s\t", name);
 *     rl_buffer_number(&text, 0.1);                 0.1: the fewest digits that read back as the same number
 *     status = rl_buffer_write(&text, path, &error);
 *     rl_buffer_clear(&text);
 *
 * Running out of memory is remembered and reported once, by rl_buffer_write or rl_buffer_check.
 */
#ifndef RL_RESULTS_BUFFER_H
#define RL_RESULTS_BUFFER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

struct rl_buffer {
    char *data; /* with a final NUL, or NULL while empty */
    size_t length, capacity;
    bool failed;
};

void rl_buffer_add(struct rl_buffer *buffer, const char *text);
void rl_buffer_printf(struct rl_buffer *buffer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* NaN is "nan", infinities "inf" and "-inf". */
void rl_buffer_number(struct rl_buffer *buffer, double value);

/* The text as a string of JSON, with its quotes. */
void rl_buffer_json(struct rl_buffer *buffer, const char *text);

/* RL_ERR_SYSTEM if memory ran out on the way. */
int rl_buffer_check(const struct rl_buffer *buffer, struct rl_error *error);
/* Checks, then replaces the file at `path` whole (rl_file_write). */
int rl_buffer_write(const struct rl_buffer *buffer, const char *path, struct rl_error *error);

void rl_buffer_clear(struct rl_buffer *buffer);

#endif
