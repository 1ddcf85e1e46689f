/* Finds the data folder and the plug-ins from the running program's own place (see paths.h). */
#include "base/paths.h"

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool exists(const char *path)
{
    return access(path, R_OK) == 0;
}

static bool program_folder(char folder[], size_t size)
{
    ssize_t n = readlink("/proc/self/exe", folder, size - 1);
    if (n <= 0)
        return false;
    folder[n] = '\0';
    char *slash = strrchr(folder, '/');
    if (slash)
        *slash = '\0';
    return slash != NULL;
}

/* Tries FOLDER/SUBFOLDER/NAME for FOLDER and each of its parents; test programs lie deeper than the tool. */
static bool search_upwards(char path[], size_t size, const char *subfolder, const char *name)
{
    char folder[PATH_MAX];
    if (!program_folder(folder, sizeof folder))
        return false;
    for (;;) {
        int n = snprintf(path, size, "%s/%s%s", folder, subfolder, name);
        if (n > 0 && (size_t)n < size && exists(path))
            return true;
        char *slash = strrchr(folder, '/');
        if (!slash)
            return false;
        *slash = '\0';
    }
}

int rl_path_data(char path[], size_t size, const char *relative, struct rl_error *error)
{
    const char *chosen = getenv("ROUGHLIGHT_DATA");
    if (chosen && *chosen) {
        int n = snprintf(path, size, "%s/%s", chosen, relative);
        if (n > 0 && (size_t)n < size && exists(path))
            return RL_OK;
        return rl_fail(error, RL_ERR_UNAVAILABLE, "ROUGHLIGHT_DATA=%s: no %s there", chosen, relative);
    }
    if (search_upwards(path, size, "share/roughlight/", relative) || search_upwards(path, size, "", relative))
        return RL_OK;
    return rl_fail(error, RL_ERR_UNAVAILABLE,
                   "%s: not found in the program's folder or share/roughlight or any folder above; "
                   "set ROUGHLIGHT_DATA to the folder that holds it",
                   relative);
}

int rl_path_plugin(char path[], size_t size, const char *name, struct rl_error *error)
{
    if (search_upwards(path, size, "lib/roughlight/", name) || search_upwards(path, size, "", name))
        return RL_OK;
    return rl_fail(error, RL_ERR_UNAVAILABLE, "%s: not found beside the program or in lib/roughlight", name);
}
