/* Progress lines and interruption (see console.h). */
#include "cli/console.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/clock.h"

/* The one variable a signal handler may write. */
static volatile sig_atomic_t interrupted;

static void on_signal(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
}

static bool cancelled(void *user)
{
    (void)user;
    return interrupted != 0;
}

static void print_time(char *text, size_t size, double seconds)
{
    if (seconds < 90.0)
        snprintf(text, size, "%.0f s", seconds);
    else
        snprintf(text, size, "%.0f min %02.0f s", (seconds - (double)((long)seconds % 60)) / 60.0,
                 (double)((long)seconds % 60));
}

static void update(void *user, const char *what, size_t done, size_t total)
{
    struct rl_console *c = user;
    double now = rl_clock_seconds();
    bool ended = done >= total;
    if (strncmp(c->what, what, sizeof c->what - 1) != 0) {
        if (c->line_open)
            fputc('\n', stderr);
        c->line_open = false;
        snprintf(c->what, sizeof c->what, "%s", what);
        c->started = now;
        c->shown = 0.0;
    }
    char time[32];
    double elapsed = now - c->started;
    if (!c->terminal) {
        if (ended)
            fprintf(stderr, "%s: %zu of %zu in %.1f s\n", what, done, total, elapsed);
        return;
    }
    if (!ended && now - c->shown < 0.1)
        return;
    c->shown = now;
    print_time(time, sizeof time, done ? elapsed / (double)done * (double)(total - done) : 0.0);
    /* \r and erase to the end of the line, so that a shorter text leaves nothing of a longer one */
    if (ended)
        fprintf(stderr, "\r\033[K%s: %zu of %zu in %.1f s\n", what, done, total, elapsed);
    else
        fprintf(stderr, "\r\033[K%s: %zu of %zu, %s left", what, done, total, done ? time : "?");
    c->line_open = !ended;
    fflush(stderr);
}

const struct rl_progress *rl_console_begin(struct rl_console *c)
{
    *c = (struct rl_console){.progress = {update, cancelled, c}, .terminal = isatty(STDERR_FILENO) == 1};
    /* SA_RESETHAND: the second signal has its ordinary, deadly effect. */
    struct sigaction action = {.sa_handler = on_signal, .sa_flags = (int)SA_RESETHAND | SA_RESTART};
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
    return &c->progress;
}

void rl_console_end(struct rl_console *c)
{
    if (c->line_open)
        fputc('\n', stderr);
    c->line_open = false;
}
