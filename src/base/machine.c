/* Asks the system about itself (see machine.h). */
#include "base/machine.h"

#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>

/* The text behind `key` and `separator` on the first line of `path` that starts with `key`; false if there is none. */
static int find_line(char text[], size_t size, const char *path, const char *key, char separator)
{
    FILE *file = fopen(path, "r");
    if (!file)
        return 0;
    char line[512];
    int found = 0;
    while (!found && fgets(line, sizeof line, file)) {
        char *value = strchr(line, separator);
        if (!value || strncmp(line, key, strlen(key)) != 0)
            continue;
        value += 1 + strspn(value + 1, " \t\"");
        value[strcspn(value, "\"\n")] = '\0';
        snprintf(text, size, "%s", value);
        found = 1;
    }
    fclose(file);
    return found;
}

void rl_machine_cpu(char text[], size_t size)
{
    if (!find_line(text, size, "/proc/cpuinfo", "model name", ':'))
        snprintf(text, size, "unknown");
}

int rl_machine_threads(void)
{
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) != 0)
        return 1;
    int n = CPU_COUNT(&set);
    return n > 0 ? n : 1;
}

void rl_machine_system(char text[], size_t size)
{
    char name[128];
    struct utsname u;
    if (!find_line(name, sizeof name, "/etc/os-release", "PRETTY_NAME", '='))
        snprintf(name, sizeof name, "unknown system");
    if (uname(&u) == 0)
        snprintf(text, size, "%s, %s %s %s", name, u.sysname, u.release, u.machine);
    else
        snprintf(text, size, "%s", name);
}
