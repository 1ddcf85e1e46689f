/* Asks the system about itself (see machine.h). */
#include "base/machine.h"

#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <unistd.h>

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

/* "cpuN user nice system idle iowait irq softirq steal ...", user with the guests' time in it: all but idle and iowait, in ticks. 0 for
 * another line and for another core than one of `set`. */
static double busy_ticks(const char *line, const cpu_set_t *set)
{
    enum { IDLE = 3, IOWAIT = 4, COLUMNS = 8 };
    char *at = NULL;
    if (strncmp(line, "cpu", 3) != 0 || line[3] < '0' || line[3] > '9')
        return 0.0;
    unsigned long core = strtoul(line + 3, &at, 10);
    if (core >= CPU_SETSIZE || !CPU_ISSET(core, set))
        return 0.0;
    double ticks = 0.0;
    for (int i = 0; i < COLUMNS; i++) {
        double column = strtod(at, &at);
        ticks += i == IDLE || i == IOWAIT ? 0.0 : column;
    }
    return ticks;
}

double rl_machine_busy_seconds(void)
{
    cpu_set_t set;
    char line[256];
    double ticks = 0.0;
    FILE *file = fopen("/proc/stat", "r");
    if (!file)
        return NAN;
    int known = sched_getaffinity(0, sizeof set, &set) == 0;
    while (known && fgets(line, sizeof line, file))
        ticks += busy_ticks(line, &set);
    fclose(file);
    return ticks > 0.0 ? ticks / (double)sysconf(_SC_CLK_TCK) : NAN;
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
