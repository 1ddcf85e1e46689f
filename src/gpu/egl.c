/* OpenGL through EGL without a window: Mesa's surfaceless platform, or the devices that EGL enumerates (which
 * is how drivers of graphics cards are reached on a machine without a display). */
#include <dlfcn.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "gpu/backend.h"

#define LIBRARY "libEGL.so.1"
enum { DEVICES_MAX = 16 };

struct egl {
    void *library;
    EGLDisplay display;
    EGLContext context;
    bool initialized;
    PFNEGLGETPROCADDRESSPROC get_proc_address;
    PFNEGLQUERYSTRINGPROC query_string;
    PFNEGLGETERRORPROC get_error;
    PFNEGLGETPLATFORMDISPLAYPROC get_platform_display;
    PFNEGLINITIALIZEPROC initialize;
    PFNEGLTERMINATEPROC terminate;
    PFNEGLBINDAPIPROC bind_api;
    PFNEGLCREATECONTEXTPROC create_context;
    PFNEGLDESTROYCONTEXTPROC destroy_context;
    PFNEGLMAKECURRENTPROC make_current;
    PFNEGLRELEASETHREADPROC release_thread;
};

static bool has_word(const char *list, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = list; at && (at = strstr(at, word)) != NULL; at += length)
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}

static void leave_display(struct egl *e)
{
    if (!e->initialized)
        return;
    e->make_current(e->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (e->context != EGL_NO_CONTEXT)
        e->destroy_context(e->display, e->context);
    e->context = EGL_NO_CONTEXT;
    e->terminate(e->display);
    e->initialized = false;
}

static void egl_close(void *state)
{
    struct egl *e = state;
    if (!e)
        return;
    leave_display(e);
    if (e->release_thread)
        e->release_thread();
    if (e->library)
        dlclose(e->library);
    free(e);
}

static int load(struct egl *e, struct rl_error *error)
{
    /* NODELETE: see osmesa.c. */
    e->library = dlopen(LIBRARY, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!e->library)
        return rl_fail(error, RL_ERR_UNAVAILABLE, "%s", dlerror());
    e->get_proc_address = (PFNEGLGETPROCADDRESSPROC)rl_gpu_symbol(e->library, "eglGetProcAddress");
    e->query_string = (PFNEGLQUERYSTRINGPROC)rl_gpu_symbol(e->library, "eglQueryString");
    e->get_error = (PFNEGLGETERRORPROC)rl_gpu_symbol(e->library, "eglGetError");
    e->get_platform_display =
        (PFNEGLGETPLATFORMDISPLAYPROC)rl_gpu_symbol(e->library, "eglGetPlatformDisplay");
    e->initialize = (PFNEGLINITIALIZEPROC)rl_gpu_symbol(e->library, "eglInitialize");
    e->terminate = (PFNEGLTERMINATEPROC)rl_gpu_symbol(e->library, "eglTerminate");
    e->bind_api = (PFNEGLBINDAPIPROC)rl_gpu_symbol(e->library, "eglBindAPI");
    e->create_context = (PFNEGLCREATECONTEXTPROC)rl_gpu_symbol(e->library, "eglCreateContext");
    e->destroy_context = (PFNEGLDESTROYCONTEXTPROC)rl_gpu_symbol(e->library, "eglDestroyContext");
    e->make_current = (PFNEGLMAKECURRENTPROC)rl_gpu_symbol(e->library, "eglMakeCurrent");
    e->release_thread = (PFNEGLRELEASETHREADPROC)rl_gpu_symbol(e->library, "eglReleaseThread");
    if (!e->get_proc_address || !e->query_string || !e->get_error || !e->get_platform_display ||
        !e->initialize || !e->terminate || !e->bind_api || !e->create_context || !e->destroy_context ||
        !e->make_current)
        return rl_fail(error, RL_ERR_UNAVAILABLE, LIBRARY ": a function is missing (older than EGL 1.5?)");
    return RL_OK;
}

/* What went wrong at `step`, with the variable that most often is the cause. */
static int failed(const struct egl *e, const char *step, struct rl_error *error)
{
    const char *driver = getenv("GALLIUM_DRIVER");
    bool named = driver && *driver;
    return rl_fail(error, RL_ERR_UNAVAILABLE, "%s failed (EGL error 0x%04x)%s%s", step,
                   (unsigned)e->get_error(), named ? " with GALLIUM_DRIVER=" : "", named ? driver : "");
}

static int make_context(struct egl *e, struct rl_error *error)
{
    static const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                        4,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        5,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    if (e->display == EGL_NO_DISPLAY || !e->initialize(e->display, NULL, NULL))
        return failed(e, "eglInitialize", error);
    e->initialized = true;
    const char *extensions = e->query_string(e->display, EGL_EXTENSIONS);
    if (!has_word(extensions, "EGL_KHR_surfaceless_context") ||
        !has_word(extensions, "EGL_KHR_no_config_context"))
        return rl_fail(error, RL_ERR_UNAVAILABLE,
                       "no context without a surface (EGL_KHR_surfaceless_context)");
    if (!e->bind_api(EGL_OPENGL_API))
        return failed(e, "eglBindAPI for OpenGL", error);
    e->context = e->create_context(e->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (e->context == EGL_NO_CONTEXT)
        return failed(e, "eglCreateContext for OpenGL 4.5 core", error);
    if (!e->make_current(e->display, EGL_NO_SURFACE, EGL_NO_SURFACE, e->context))
        return failed(e, "eglMakeCurrent", error);
    return RL_OK;
}

static int open_surfaceless(struct egl *e, struct rl_error *error)
{
    if (!has_word(e->query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless"))
        return rl_fail(error, RL_ERR_UNAVAILABLE,
                       "no EGL_MESA_platform_surfaceless (is Mesa's EGL installed?)");
    e->display = e->get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    return make_context(e, error);
}

/* The first device that has what we need. */
static int open_device(struct egl *e, struct rl_error *error)
{
    const char *extensions = e->query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    PFNEGLQUERYDEVICESEXTPROC query_devices =
        (PFNEGLQUERYDEVICESEXTPROC)e->get_proc_address("eglQueryDevicesEXT");
    if (!has_word(extensions, "EGL_EXT_platform_device") || !query_devices)
        return rl_fail(error, RL_ERR_UNAVAILABLE, "no EGL_EXT_platform_device");
    EGLDeviceEXT device[DEVICES_MAX];
    EGLint n = 0;
    if (!query_devices(DEVICES_MAX, device, &n) || n < 1)
        return rl_fail(error, RL_ERR_UNAVAILABLE, "EGL lists no device");
    for (EGLint i = 0; i < n; i++) {
        e->display = e->get_platform_display(EGL_PLATFORM_DEVICE_EXT, device[i], NULL);
        int status = make_context(e, error);
        if (status == RL_OK)
            return status;
        leave_display(e);
    }
    return rl_fail_prefix(error, "%d devices tried, the last", (int)n);
}

static int egl_open(void **state, int (*open_display)(struct egl *, struct rl_error *),
                    struct rl_error *error)
{
    struct egl *e = calloc(1, sizeof *e);
    if (!e)
        return rl_fail_memory(error, "the EGL context");
    int status = load(e, error);
    if (status == RL_OK)
        status = open_display(e, error);
    if (status != RL_OK) {
        egl_close(e);
        return status;
    }
    *state = e;
    return RL_OK;
}

static int egl_open_surfaceless(void **state, struct rl_error *error)
{
    return egl_open(state, open_surfaceless, error);
}

static int egl_open_device(void **state, struct rl_error *error)
{
    return egl_open(state, open_device, error);
}

static rl_gl_function egl_get_function(void *state, const char *name)
{
    const struct egl *e = state;
    return (rl_gl_function)e->get_proc_address(name);
}

const struct rl_gpu_backend rl_gpu_egl_surfaceless = {
    .name = "egl-surfaceless",
    .open = egl_open_surfaceless,
    .close = egl_close,
    .get_function = egl_get_function,
};

const struct rl_gpu_backend rl_gpu_egl_device = {
    .name = "egl-device",
    .open = egl_open_device,
    .close = egl_close,
    .get_function = egl_get_function,
};
