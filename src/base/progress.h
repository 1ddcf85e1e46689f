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
    void *user;
};

static inline void rl_progress_update(const struct rl_progress *progress, const char *what, size_t done,
                                      size_t total)
{
    if (progress && progress->update)
        progress->update(progress->user, what, done, total);
}

static inline bool rl_progress_cancelled(const struct rl_progress *progress)
{
    return progress && progress->cancelled && progress->cancelled(progress->user);
}

#endif
