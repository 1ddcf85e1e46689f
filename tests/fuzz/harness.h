/* What the harnesses in this folder have in common. Each is one function, which a fuzzer calls with bytes of its own making; `make fuzz` links
 * it with libFuzzer, `make test` with replay.c. It must return 0, whatever the bytes are, and end the process (FUZZ_CHECK) where something
 * was promised that does not hold. */
#ifndef RL_TESTS_FUZZ_HARNESS_H
#define RL_TESTS_FUZZ_HARNESS_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "support/temporary.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define FUZZ_CHECK(condition)                                                                                \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition);                   \
            abort();                                                                                         \
        }                                                                                                    \
    } while (0)

/* An error is one line, whatever the input has in it; `error` was empty before. */
static inline void fuzz_check_error(int status, const struct rl_error *error)
{
    if (status == RL_OK)
        return;
    FUZZ_CHECK(status < 0 && error->message[0] != '\0');
    for (const char *c = error->message; *c; c++)
        if ((unsigned char)*c < ' ') {
            fprintf(stderr, "the message: %s\n", error->message);
            FUZZ_CHECK(!"a message is one line of text");
        }
}

static struct temporary fuzz_folder;

static inline void fuzz_remove_folder(void)
{
    temporary_remove(&fuzz_folder);
}

/* The path of a file in a folder of this process's own ($TMPDIR: in memory if need be), which goes with it. */
static inline const char *fuzz_path(char path[PATH_MAX], const char *name)
{
    if (!fuzz_folder.folder[0]) {
        temporary_make(&fuzz_folder);
        atexit(fuzz_remove_folder);
    }
    temporary_path(&fuzz_folder, path, name);
    return path;
}

static inline void fuzz_write(const char *path, const void *data, size_t size)
{
    FILE *file = fopen(path, "wb");
    FUZZ_CHECK(file && fwrite(data, 1, size, file) == size);
    FUZZ_CHECK(fclose(file) == 0);
}

/* The input as text, with a NUL behind it. */
static inline char *fuzz_text(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1);
    FUZZ_CHECK(text);
    memcpy(text, data, size);
    text[size] = '\0';
    return text;
}

#endif
