/* The functions of assimp that are used, from a library that is loaded when the first mesh file is read: linked, it would take
 * half of the start-up time of every command.
 */
#ifndef RL_SCENE_ASSIMP_H
#define RL_SCENE_ASSIMP_H

#include <assimp/cimport.h>
#include <assimp/scene.h>

#include "base/error.h"

struct rl_assimp {
    struct aiPropertyStore *(*create_properties)(void);
    void (*release_properties)(struct aiPropertyStore *properties);
    void (*set_integer)(struct aiPropertyStore *properties, const char *name, int value);
    const struct aiScene *(*import_file)(const char *path, unsigned flags, struct aiFileIO *io,
                                         const struct aiPropertyStore *properties);
    void (*release)(const struct aiScene *scene);
    const char *(*error_string)(void);
};

/* Loads the library; RL_ERR_UNAVAILABLE says why it cannot be. It stays loaded until the process ends. */
int rl_assimp_load(struct rl_assimp *assimp, struct rl_error *error);

#endif
