/* Progress on stderr and Ctrl-C, for commands with long work.
 *
 *     struct rl_console console;
 *     const struct rl_progress *progress = rl_console_begin(&console);
 *     ... work(progress) ...
 *     rl_console_end(&console);
 *
 * On a terminal: one line rewritten in place with done/total and the time left. Elsewhere: one line when a piece of work ends, and
 * one every half minute. Of several pieces of work, how far it is to the end of the last.
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
    double started, next_started,
        shown;          /* seconds: of this piece of work and of the one after it; of the last line */
    size_t done, total; /* of all pieces of work together; total = 0: nobody said */
    double left;        /* seconds that the rest may take; NaN: unknown */
};

const struct rl_progress *rl_console_begin(struct rl_console *console);
void rl_console_end(struct rl_console *console);

/* "45 s", "12 min 05 s", "2 h 40 min"; "?" for NaN. */
void rl_console_time(char *text, size_t size, double seconds);

#endif
