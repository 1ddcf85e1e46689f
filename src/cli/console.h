/* Progress on stderr and Ctrl-C, for commands with long work.
 *
 *     struct rl_console console;
 *     const struct rl_progress *progress = rl_console_begin(&console);
 *     ... work(progress) ...
 *     rl_console_end(&console);
 *
 * On a terminal: one line rewritten in place with done/total and the time left. Elsewhere: one line when a piece of work ends.
 * The first Ctrl-C (or SIGTERM, SIGHUP) asks the work to stop, the second ends the process at once.
 */
#ifndef RL_CLI_CONSOLE_H
#define RL_CLI_CONSOLE_H

#include <stdbool.h>

#include "base/progress.h"

struct rl_console {
    struct rl_progress progress;
    bool terminal, line_open;
    char what[128];
    double started, shown; /* seconds */
};

const struct rl_progress *rl_console_begin(struct rl_console *console);
void rl_console_end(struct rl_console *console);

#endif
