/* An open context: the backend that made it and the functions of OpenGL in it. */
#ifndef RL_GPU_CONTEXT_H
#define RL_GPU_CONTEXT_H

#include "gpu/backend.h"
#include "gpu/gl.h"
#include "gpu/gpu.h"
#include "gpu/kept.h"

struct rl_gpu {
    const struct rl_gpu_backend *backend;
    void *state;
    struct rl_gl gl;
    struct rl_gpu_info info;
    struct rl_kept kept;
};

#endif
