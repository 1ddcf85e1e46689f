/* Whole files: read one, replace one so that a reader sees the old or the new content and never half of it. */
#ifndef RL_BASE_FILES_H
#define RL_BASE_FILES_H

#include <stddef.h>

#include "base/error.h"

/* Reads all of `path` into *data, with a NUL after the last byte that `size` does not count. Free with free().
 * Directories and files over 1 GiB are refused. */
int rl_file_read(char **data, size_t *size, const char *path, struct rl_error *error);

/* Writes to a temporary file beside `path`, flushes it to the disk and renames it over `path`. On any error the
 * temporary file is removed and `path` is as it was. Directories, devices and pipes are refused; a symbolic
 * link is replaced, not what it points to. */
int rl_file_write(const char *path, const void *data, size_t size, struct rl_error *error);

/* The same in two steps for writers that want a file name of their own (an image library): `begin` writes the
 * temporary name, ending in the extension of `path`, into `temporary`; `commit` flushes and renames,
 * `abandon` removes. What a writer of the same file on this machine left when it was killed is removed by
 * the next `begin`. */
int rl_file_begin(char temporary[], size_t size, const char *path, struct rl_error *error);
int rl_file_commit(const char *temporary, const char *path, struct rl_error *error);
void rl_file_abandon(const char *temporary);

/* Creates `path` and its missing parents. */
int rl_directory_create(const char *path, struct rl_error *error);

#endif
