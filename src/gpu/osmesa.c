/* OpenGL on the processor without any window system: OSMesa, which draws with llvmpipe. */
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

#include <GL/osmesa.h>

#include "gpu/backend.h"

#define LIBRARY "libOSMesa.so.8"

typedef OSMesaContext (*create_function)(const int *attributes, OSMesaContext shared);
typedef GLboolean (*make_current_function)(OSMesaContext context, void *buffer, GLenum type, GLsizei width,
                                           GLsizei height);
typedef void (*destroy_function)(OSMesaContext context);
typedef OSMESAproc (*get_proc_function)(const char *name);

struct osmesa {
    void *library;
    OSMesaContext context;
    create_function create;
    make_current_function make_current;
    destroy_function destroy;
    get_proc_function get_proc;
    unsigned char pixel[4]; /* a default frame buffer is compulsory; all drawing goes to our own */
};

/* OSMesa ends the process by a segmentation fault where the variable names a driver that it was built
 * without. */
static int check_driver(struct rl_error *error)
{
    const char *driver = getenv("GALLIUM_DRIVER");
    if (!driver || !*driver || strcmp(driver, "llvmpipe") == 0 || strcmp(driver, "softpipe") == 0)
        return RL_OK;
    return rl_fail(error, RL_ERR_UNAVAILABLE, "GALLIUM_DRIVER=%s: expected llvmpipe, or the variable unset",
                   driver);
}

static void osmesa_close(void *state)
{
    struct osmesa *o = state;
    if (!o)
        return;
    if (o->context) {
        o->make_current(NULL, NULL, GL_UNSIGNED_BYTE, 0, 0);
        o->destroy(o->context);
    }
    if (o->library)
        dlclose(o->library);
    free(o);
}

static int load(struct osmesa *o, struct rl_error *error)
{
    /* NODELETE: Mesa and LLVM leave exit handlers and thread-local data behind that must not lose their code.
     */
    o->library = dlopen(LIBRARY, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!o->library)
        return rl_fail(error, RL_ERR_UNAVAILABLE, "%s", dlerror());
    o->create = (create_function)rl_gpu_symbol(o->library, "OSMesaCreateContextAttribs");
    o->make_current = (make_current_function)rl_gpu_symbol(o->library, "OSMesaMakeCurrent");
    o->destroy = (destroy_function)rl_gpu_symbol(o->library, "OSMesaDestroyContext");
    o->get_proc = (get_proc_function)rl_gpu_symbol(o->library, "OSMesaGetProcAddress");
    if (!o->create || !o->make_current || !o->destroy || !o->get_proc)
        return rl_fail(error, RL_ERR_UNAVAILABLE,
                       LIBRARY ": a function is missing (too old for core profiles?)");
    return RL_OK;
}

static int osmesa_open(void **state, struct rl_error *error)
{
    /* 4.6 would be refused, though Mesa has it. */
    static const int attributes[] = {OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     4,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     5,
                                     0};
    int status = check_driver(error);
    if (status != RL_OK)
        return status;
    struct osmesa *o = calloc(1, sizeof *o);
    if (!o)
        return rl_fail_memory(error, "the OSMesa context");
    status = load(o, error);
    if (status == RL_OK) {
        o->context = o->create(attributes, NULL);
        if (!o->context)
            status = rl_fail(error, RL_ERR_UNAVAILABLE, LIBRARY ": no OpenGL 4.5 core context%s",
                             getenv("GALLIUM_DRIVER") ? " with this GALLIUM_DRIVER" : "");
        else if (!o->make_current(o->context, o->pixel, GL_UNSIGNED_BYTE, 1, 1))
            status = rl_fail(error, RL_ERR_UNAVAILABLE, LIBRARY ": its context cannot be made current");
    }
    if (status != RL_OK) {
        osmesa_close(o);
        return status;
    }
    *state = o;
    return RL_OK;
}

static rl_gl_function osmesa_get_function(void *state, const char *name)
{
    const struct osmesa *o = state;
    return (rl_gl_function)o->get_proc(name);
}

const struct rl_gpu_backend rl_gpu_osmesa = {
    .name = "osmesa",
    .open = osmesa_open,
    .close = osmesa_close,
    .get_function = osmesa_get_function,
};
