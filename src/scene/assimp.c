/* Loads assimp at run time (see assimp.h). */
#include "scene/assimp.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <string.h>

/* The ABI of the headers that this is compiled with: assimp 5. */
#define LIBRARY "libassimp.so.5"

/* POSIX lets dlsym's pointer be a function's; ISO C has no cast for it, hence the copy. */
static bool find(void *function, void *library, const char *name)
{
    void *symbol = dlsym(library, name);
    memcpy(function, &symbol, sizeof symbol);
    return symbol != NULL;
}

int rl_assimp_load(struct rl_assimp *assimp, struct rl_error *error)
{
    void *library = dlopen(LIBRARY, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!library)
        return rl_fail(error, RL_ERR_UNAVAILABLE,
                       "mesh files cannot be read: %s; install assimp (Debian: libassimp-dev)", dlerror());
    bool complete = find(&assimp->create_properties, library, "aiCreatePropertyStore") &&
                    find(&assimp->release_properties, library, "aiReleasePropertyStore") &&
                    find(&assimp->set_integer, library, "aiSetImportPropertyInteger") &&
                    find(&assimp->import_file, library, "aiImportFileExWithProperties") &&
                    find(&assimp->release, library, "aiReleaseImport") &&
                    find(&assimp->error_string, library, "aiGetErrorString");
    return complete ? RL_OK : rl_fail(error, RL_ERR_UNAVAILABLE, "mesh files cannot be read: %s", dlerror());
}
