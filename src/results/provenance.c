/* Asks the machine and the build who they are (see provenance.h). */
#include "results/provenance.h"

#include <dirent.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/files.h"
#include "base/machine.h"
#include "base/paths.h"
#include "base/version.h"

static uint64_t hash_file(uint64_t hash, const char *path)
{
    char *data = NULL;
    size_t size = 0;
    if (rl_file_read(&data, &size, path, NULL) != RL_OK)
        return hash;
    hash = rl_hash_bytes(hash, data, size);
    free(data);
    return hash;
}

static int not_hidden(const struct dirent *entry)
{
    return entry->d_name[0] != '.';
}

/* Names and contents of all files below `folder`, in the order of their names. */
static uint64_t hash_tree(uint64_t hash, const char *folder)
{
    struct dirent **entry = NULL;
    int n = scandir(folder, &entry, not_hidden, alphasort);
    for (int i = 0; i < n; i++) {
        char path[PATH_MAX];
        int length = snprintf(path, sizeof path, "%s/%s", folder, entry[i]->d_name);
        if (length > 0 && (size_t)length < sizeof path) {
            hash = rl_hash_bytes(hash, entry[i]->d_name, strlen(entry[i]->d_name));
            hash = entry[i]->d_type == DT_DIR ? hash_tree(hash, path) : hash_file(hash, path);
        }
        free(entry[i]);
    }
    free(entry);
    return hash;
}

/* Not the program file: it holds the commit, and what else a linker puts there. */
static uint64_t hash_code(void)
{
    uint64_t hash = rl_hash_bytes(RL_HASH_START, rl_version.code, strlen(rl_version.code));
    char shaders[PATH_MAX];
    if (rl_path_data(shaders, sizeof shaders, "shaders", NULL) == RL_OK)
        hash = hash_tree(hash, shaders);
    return hash;
}

void rl_provenance_now(char text[32])
{
    time_t now = time(NULL);
    struct tm utc;
    if (!gmtime_r(&now, &utc) || strftime(text, 32, "%Y-%m-%dT%H:%M:%SZ", &utc) == 0)
        snprintf(text, 32, "unknown");
}

void rl_provenance_fill(struct rl_provenance *p, int threads, const char *backend, const char *renderer,
                        const char *gl_version)
{
    *p = (struct rl_provenance){.dirty = rl_version.dirty,
                                .threads = threads > 0 ? threads : rl_machine_threads()};
    snprintf(p->version, sizeof p->version, "%s", rl_version.version);
    snprintf(p->commit, sizeof p->commit, "%s", rl_version.commit);
    snprintf(p->compiler, sizeof p->compiler, "%s", rl_version.compiler);
    snprintf(p->cflags, sizeof p->cflags, "%s", rl_version.cflags);
    snprintf(p->backend, sizeof p->backend, "%s", backend);
    snprintf(p->renderer, sizeof p->renderer, "%s", renderer);
    snprintf(p->gl_version, sizeof p->gl_version, "%s", gl_version);
    rl_hash_text(p->code_hash, hash_code());
    rl_machine_cpu(p->cpu, sizeof p->cpu);
    rl_machine_system(p->os, sizeof p->os);
    rl_provenance_now(p->time);
}

static uint64_t hash_texts(uint64_t hash, const char *const *text, size_t n)
{
    for (size_t i = 0; i < n; i++)
        hash = rl_hash_bytes(hash, text[i], strlen(text[i]) + 1);
    return hash;
}

void rl_provenance_program(const struct rl_provenance *p, char text[RL_HASH_TEXT])
{
    const char *const part[] = {p->version, p->code_hash, p->compiler, p->cflags};
    rl_hash_text(text, hash_texts(RL_HASH_START, part, sizeof part / sizeof part[0]));
}

void rl_provenance_environment(const struct rl_provenance *p, char text[RL_HASH_TEXT])
{
    char threads[32], program[RL_HASH_TEXT];
    snprintf(threads, sizeof threads, "%d", p->threads);
    rl_provenance_program(p, program);
    const char *const part[] = {program, p->cpu, p->os, p->backend, p->renderer, p->gl_version, threads};
    rl_hash_text(text, hash_texts(RL_HASH_START, part, sizeof part / sizeof part[0]));
}
