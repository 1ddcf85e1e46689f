/* Progress lines and interruption (see console.h). */
#include "cli/console.h"

#include <math.h>
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

void rl_console_time(char *text, size_t size, double seconds)
{
    if (isnan(seconds))
        snprintf(text, size, "?");
    else if (seconds < 90.0)
        snprintf(text, size, "%.0f s", seconds);
    else if (seconds < 5400.0)
        snprintf(text, size, "%ld min %02ld s", (long)seconds / 60, (long)seconds % 60);
    else
        snprintf(text, size, "%ld h %02ld min", (long)seconds / 3600, (long)seconds / 60 % 60);
}

/* "; of all: 17 of 80, about 12 min 05 s left" */
static void print_overall(char *text, size_t size, const struct rl_console *c)
{
    char time[32];
    rl_console_time(time, sizeof time, c->left);
    text[0] = '\0';
    if (c->total > 0 && c->done < c->total)
        snprintf(text, size, "; of all: %zu of %zu, about %s left", c->done, c->total, time);
}

/* Where lines stay: one when a piece of work ends, and one each half minute. */
static void update_log(struct rl_console *c, const char *what, size_t done, size_t total, double now)
{
    static const double pause = 30.0;
    char overall[128];
    print_overall(overall, sizeof overall, c);
    if (done >= total)
        fprintf(stderr, "%s: %zu of %zu in %.1f s%s\n", what, done, total, now - c->started, overall);
    else if (now - c->shown >= pause)
        fprintf(stderr, "%s: %zu of %zu%s\n", what, done, total, overall);
    if (done >= total || now - c->shown >= pause)
        c->shown = now;
}

/* \r and erase to the end of the line, so that a shorter text leaves nothing of a longer one. */
static void update_line(struct rl_console *c, const char *what, size_t done, size_t total, double now)
{
    char time[32], overall[128];
    double elapsed = now - c->started;
    bool ended = done >= total;
    if (!ended && now - c->shown < 0.1)
        return;
    c->shown = now;
    print_overall(overall, sizeof overall, c);
    rl_console_time(time, sizeof time, done ? elapsed / (double)done * (double)(total - done) : NAN);
    if (ended)
        fprintf(stderr, "\r\033[K%s: %zu of %zu in %.1f s\n", what, done, total, elapsed);
    else if (overall[0]) /* its guess of what is left is the better one */
        fprintf(stderr, "\r\033[K%s: %zu of %zu%s", what, done, total, overall);
    else
        fprintf(stderr, "\r\033[K%s: %zu of %zu, %s left", what, done, total, time);
    c->line_open = !ended;
    fflush(stderr);
}

static void update(void *user, const char *what, size_t done, size_t total)
{
    struct rl_console *c = user;
    double now = rl_clock_seconds();
    if (strncmp(c->what, what, sizeof c->what - 1) != 0) {
        if (c->line_open)
            fputc('\n', stderr);
        c->line_open = false;
        snprintf(c->what, sizeof c->what, "%s", what);
        c->started = c->next_started;
        c->shown = c->terminal ? 0.0 : fmax(c->shown, c->started);
    }
    if (c->terminal)
        update_line(c, what, done, total, now);
    else
        update_log(c, what, done, total, now);
    if (done >= total)
        c->next_started = now;
}

/* Long work is announced; of short work, nothing stands on stderr before what went wrong. */
static const double announced = 60.0;

static void overall(void *user, size_t done, size_t total, double seconds_left)
{
    struct rl_console *c = user;
    char time[32];
    rl_console_time(time, sizeof time, seconds_left);
    if (done == 0 && seconds_left >= announced)
        fprintf(stderr, "%zu cases to measure, in about %s\n", total, time);
    c->done = done;
    c->total = total;
    c->left = seconds_left;
}

static void note(void *user, const char *text)
{
    rl_console_end(user); /* not into an open line */
    fprintf(stderr, "%s\n", text);
}

const struct rl_progress *rl_console_begin(struct rl_console *c)
{
    *c = (struct rl_console){.progress = {update, cancelled, overall, note, c},
                             .terminal = isatty(STDERR_FILENO) == 1,
                             .next_started = rl_clock_seconds()};
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
