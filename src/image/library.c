/* Loads the OpenImageIO plug-in when it is first needed (see oiio.h): it pulls in some 260 shared libraries.
 */
#include <dlfcn.h>
#include <limits.h>
#include <pthread.h>
#include <stddef.h>

#include "base/paths.h"
#include "image/oiio.h"

#define ADVICE "install OpenImageIO (Debian: libopenimageio-dev) and run make"

static pthread_once_t once = PTHREAD_ONCE_INIT;
static const struct rl_oiio *loaded;
static struct rl_error reason;

static void load(void)
{
    char path[PATH_MAX];
    if (rl_path_plugin(path, sizeof path, RL_OIIO_PLUGIN, &reason) != RL_OK) {
        struct rl_error why = reason;
        rl_error_set(&reason, RL_ERR_UNAVAILABLE, "images cannot be read or written: %.600s; " ADVICE,
                     why.message);
        return;
    }
    /* Never closed: the library's own threads and tables would outlive it. */
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    const struct rl_oiio *found = library ? dlsym(library, RL_OIIO_SYMBOL) : NULL;
    if (!found)
        rl_error_set(&reason, RL_ERR_UNAVAILABLE, "images cannot be read or written: %s; " ADVICE, dlerror());
    else if (found->interface != RL_OIIO_INTERFACE)
        rl_error_set(
            &reason, RL_ERR_UNAVAILABLE,
            "images cannot be read or written: %s has interface %d, this program expects %d; run make", path,
            found->interface, RL_OIIO_INTERFACE);
    else
        loaded = found;
}

int rl_oiio_load(const struct rl_oiio **oiio, struct rl_error *error)
{
    pthread_once(&once, load);
    *oiio = loaded;
    return loaded ? RL_OK : rl_fail(error, RL_ERR_UNAVAILABLE, "%s", reason.message);
}

int rl_image_library(char version[64], struct rl_error *error)
{
    const struct rl_oiio *oiio = NULL;
    int status = rl_oiio_load(&oiio, error);
    if (oiio)
        oiio->version(version);
    return status;
}
