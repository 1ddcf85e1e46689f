/* What a way of making an OpenGL context must offer; one const table entry each (osmesa.c, egl.c). Knows no
 * GL types, because the headers of the window systems and of core OpenGL do not go together.
 */
#ifndef RL_GPU_BACKEND_H
#define RL_GPU_BACKEND_H

#include "base/error.h"

typedef void (*rl_gl_function)(void);

struct rl_gpu_backend {
    const char *name;
    /* Loads the library and makes an OpenGL 4.5 core context that is current in this thread. On any error
     * nothing stays open; RL_ERR_UNAVAILABLE with the reason if this machine has no such context. */
    int (*open)(void **state, struct rl_error *error);
    void (*close)(void *state);
    /* May return something for functions that do not exist: the caller checks the version of OpenGL first. */
    rl_gl_function (*get_function)(void *state, const char *name);
};

extern const struct rl_gpu_backend rl_gpu_osmesa, rl_gpu_egl_surfaceless, rl_gpu_egl_device;

/* dlsym for functions: ISO C has no conversion from a pointer to data. */
rl_gl_function rl_gpu_symbol(void *library, const char *name);

#endif
