/* Where a result comes from: program, machine, renderer.
 *
 *     struct rl_provenance p;
 *     rl_provenance_fill(&p, threads, "osmesa", renderer, gl_version);
 *     rl_provenance_environment(&p, text);        the hash that a case's identity contains
 */
#ifndef RL_RESULTS_PROVENANCE_H
#define RL_RESULTS_PROVENANCE_H

#include <stdbool.h>

#include "base/hash.h"

struct rl_provenance {
    char version[32];
    char commit[32]; /* with `dirty`: shown to people, identifies nothing */
    bool dirty;
    char code_hash[RL_HASH_TEXT]; /* of the sources that the program was built from, and its shaders */
    char compiler[128], cflags[512];
    char cpu[128], os[256];
    int threads; /* that it may use */
    char backend[32], renderer[128], gl_version[128];
    char time[32]; /* UTC, ISO 8601 */
};

/* threads <= 0: as many as this process may run on. The shaders are those that rl_path_data finds, or none. */
void rl_provenance_fill(struct rl_provenance *p, int threads, const char *backend, const char *renderer,
                        const char *gl_version);

/* Hash of what the program was built from: version, code, compiler and its flags. Any commit with the same sources has the same; a
 * changed comment gives another, for its effect is not known. */
void rl_provenance_program(const struct rl_provenance *p, char text[RL_HASH_TEXT]);

/* Hash of everything but commit and time. */
void rl_provenance_environment(const struct rl_provenance *p, char text[RL_HASH_TEXT]);

/* Now, as "2026-01-31T12:00:00Z". */
void rl_provenance_now(char text[32]);

#endif
