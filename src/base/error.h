/* Errors as values: every function that can fail returns 0 or a negative rl_status and fills a message.
 *
 * The message is one line, without a newline: what was found, where (file:line, key or argument), and what was
 * expected. Control characters in it become '?', wherever they came from. Only src/cli prints it. `error` may be
 * NULL where the caller needs the code alone.
 *
 *     struct rl_error error;
 *     if (rl_scene_load(&scene, path, &error) != RL_OK)
 *         fprintf(stderr, "roughlight: %s\n", error.message);
 */
#ifndef RL_BASE_ERROR_H
#define RL_BASE_ERROR_H

enum rl_status {
    RL_OK = 0,
    RL_ERR_INPUT = -1,       /* the caller's data or arguments: a scene, an option, an image */
    RL_ERR_SYSTEM = -2,      /* the machine: no memory, unwritable file, full disk */
    RL_ERR_UNAVAILABLE = -3, /* a library, backend or format that this machine lacks */
    RL_ERR_CANCELLED = -4,   /* the user interrupted */
    RL_ERR_CHECK = -5        /* a comparison or check that was carried out and did not pass */
};

struct rl_error {
    enum rl_status status;
    char message[1024];
};

/* Fills `error` (if not NULL) like printf. */
void rl_error_set(struct rl_error *error, enum rl_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The same as an expression of value `status`, so that `return rl_fail(...)` reads well. A macro, not a function: static
 * analysers see the status itself, and that it is not RL_OK. */
#define rl_fail(error, status, ...) (rl_error_set(error, status, __VA_ARGS__), (int)(status))

/* Puts "prefix: " in front of the message already in `error`; returns its status. Where `error` may be NULL,
 * return the status that you have instead: NULL does not remember one, and RL_ERR_SYSTEM comes back. */
int rl_fail_prefix(struct rl_error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* RL_ERR_SYSTEM with "out of memory" and what for. */
#define rl_fail_memory(error, what) rl_fail(error, RL_ERR_SYSTEM, "out of memory for %s", what)

#endif
