/* Opens a context on the first backend that works and keeps why the others did not. */
#include "gpu/context.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* In the order in which `auto` tries them. */
static const struct rl_gpu_backend *const backends[] = {&rl_gpu_osmesa, &rl_gpu_egl_surfaceless,
                                                        &rl_gpu_egl_device};
enum { N_BACKENDS = sizeof backends / sizeof backends[0] };

const char *const rl_gpu_backends[] = {"osmesa", "egl-surfaceless", "egl-device"};
const size_t rl_n_gpu_backends = sizeof rl_gpu_backends / sizeof rl_gpu_backends[0];

rl_gl_function rl_gpu_symbol(void *library, const char *name)
{
    void *data = dlsym(library, name);
    rl_gl_function function = NULL;
    memcpy(&function, &data, sizeof function);
    return function;
}

/* "auto" and "egl" stand for several. */
static bool chosen(const struct rl_gpu_backend *backend, const char *name)
{
    return strcmp(name, backend->name) == 0 || strcmp(name, "auto") == 0 ||
           (strcmp(name, "egl") == 0 && strncmp(backend->name, "egl-", 4) == 0);
}

static void copy_string(char *to, size_t size, const struct rl_gl *gl, GLenum name)
{
    const GLubyte *text = gl->GetString(name);
    snprintf(to, size, "%s", text ? (const char *)text : "unknown");
}

static int open_backend(struct rl_gpu *gpu, const struct rl_gpu_backend *backend, struct rl_error *error)
{
    int status = backend->open(&gpu->state, error);
    if (status != RL_OK)
        return status;
    status = rl_gl_load(&gpu->gl, backend, gpu->state, error);
    if (status != RL_OK) {
        backend->close(gpu->state);
        return status;
    }
    gpu->backend = backend;
    gpu->info.backend = backend->name;
    copy_string(gpu->info.renderer, sizeof gpu->info.renderer, &gpu->gl, GL_RENDERER);
    copy_string(gpu->info.vendor, sizeof gpu->info.vendor, &gpu->gl, GL_VENDOR);
    copy_string(gpu->info.version, sizeof gpu->info.version, &gpu->gl, GL_VERSION);
    copy_string(gpu->info.glsl, sizeof gpu->info.glsl, &gpu->gl, GL_SHADING_LANGUAGE_VERSION);
    return RL_OK;
}

int rl_gpu_open(struct rl_gpu **out, const char *name, struct rl_error *error)
{
    *out = NULL;
    struct rl_gpu *gpu = calloc(1, sizeof *gpu);
    if (!gpu)
        return rl_fail_memory(error, "the OpenGL context");
    char reasons[sizeof error->message] = "";
    size_t used = 0;
    int tried = 0;
    int status = RL_OK;
    for (size_t i = 0; i < N_BACKENDS; i++) {
        if (!chosen(backends[i], name))
            continue;
        struct rl_error reason = {0};
        status = open_backend(gpu, backends[i], &reason);
        if (status == RL_OK) {
            *out = gpu;
            return RL_OK;
        }
        tried++;
        int n = snprintf(reasons + used, sizeof reasons - used, "%s%s: %s", used ? "; " : "",
                         backends[i]->name, reason.message);
        used += n > 0 && (size_t)n < sizeof reasons - used ? (size_t)n : 0;
    }
    free(gpu);
    if (tried == 0)
        return rl_fail(error, RL_ERR_INPUT,
                       "backend '%s': expected auto, osmesa, egl, egl-surfaceless or egl-device", name);
    return rl_fail(error, (enum rl_status)status, "no OpenGL 4.5: %.900s", reasons);
}

void rl_gpu_close(struct rl_gpu *gpu)
{
    if (!gpu)
        return;
    rl_kept_clear(&gpu->kept, &gpu->gl);
    gpu->backend->close(gpu->state);
    free(gpu);
}

const struct rl_gpu_info *rl_gpu_describe(const struct rl_gpu *gpu)
{
    return &gpu->info;
}
