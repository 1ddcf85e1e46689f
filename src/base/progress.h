/* Progress of long work and the wish to stop it: the worker reports, the owner decides what to show.
 *
 * Every function here accepts NULL: work that nobody watches. rl_progress_cancelled is async-signal-clean: the
 * owner sets a sig_atomic_t from its handler and the worker asks between units of work.
 */
#ifndef RL_BASE_PROGRESS_H
#define RL_BASE_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

struct rl_progress {
    /* Called by one thread at a time; `done` of `total` units are finished. */
    void (*update)(void *user, const char *what, size_t done, size_t total);
    bool (*cancelled)(void *user);
    /* Of several pieces of work, each with updates of its own: how much of all is finished, and the seconds that the rest may take
     * (NaN: nobody knows). Called before the update that it goes with; may be NULL. */
    void (*overall)(void *user, size_t done, size_t total, double seconds_left);
    /* One line on what was done and nobody asked for by name, such as a folder created. May be NULL. */
    void (*note)(void *user, const char *text);
    void *user;
};

static inline void rl_progress_update(const struct rl_progress *progress, const char *what, size_t done,
                                      size_t total)
{
    if (progress && progress->update)
        progress->update(progress->user, what, done, total);
}

static inline void rl_progress_overall(const struct rl_progress *progress, size_t done, size_t total,
                                       double seconds_left)
{
    if (progress && progress->overall)
        progress->overall(progress->user, done, total, seconds_left);
}

static inline void rl_progress_note(const struct rl_progress *progress, const char *text)
{
    if (progress && progress->note)
        progress->note(progress->user, text);
}

static inline bool rl_progress_cancelled(const struct rl_progress *progress)
{
    return progress && progress->cancelled && progress->cancelled(progress->user);
}

#endif
