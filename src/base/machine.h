/* What this machine is, as results record it. */
#ifndef RL_BASE_MACHINE_H
#define RL_BASE_MACHINE_H

#include <stddef.h>

/* The CPU's model name, or "unknown". */
void rl_machine_cpu(char text[], size_t size);

/* Threads this process may run at once: its affinity mask, not the machine's whole count. */
int rl_machine_threads(void);

/* Seconds that all programs together, and a hypervisor's other guests, have kept the cores busy that this process may use, since the
 * machine started, in steps of 10 ms. Less this process's own over the same time: what others took. NaN where the
 * system does not say. */
double rl_machine_busy_seconds(void);

/* Operating system and kernel, e.g. "Debian GNU/Linux 12 (bookworm), Linux 6.1.0 x86_64". */
void rl_machine_system(char text[], size_t size);

#endif
