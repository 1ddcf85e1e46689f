/* How long a run of studies has still to go, while it goes: each open group's time is guessed as a forecast does, from what is most
 * like it among what was measured before, or is the study's first estimate, and from the groups of this run as soon as they are
 * measured.
 *
 *     struct rl_eta eta = {0};
 *     rl_eta_add(&eta, run, first, &times, &error);             every group to be measured, and what is known of its study
 *     rl_eta_measured(&eta, &run->record[first]);               each when it is finished (its `seconds` filled), or
 *     rl_eta_dropped(&eta, &run->record[first]);                when it turns out that it need not be measured
 *     eta.done, eta.total; rl_eta_seconds(&eta)
 *     rl_eta_clear(&eta);
 *
 * A straight line through what is done would be no guess at all: groups differ by a factor of a thousand, and the dear ones come last.
 */
#ifndef RL_STUDIES_ETA_H
#define RL_STUDIES_ETA_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "results/record.h"

struct rl_eta_group {
    const struct rl_record *first; /* of its cases; stays where it is */
    bool open;
    int distance;   /* in how many values the case differs that its time is taken from; -1: there is none */
    double seconds; /* guessed; a first estimate where distance is -1; NaN: unknown */
};

struct rl_eta {
    size_t done, total; /* groups */
    struct rl_eta_group *group;
};

/* `times` as rl_database_load_times gives it, or NULL. */
int rl_eta_add(struct rl_eta *eta, const struct rl_run *run, size_t first, const struct rl_run *times,
               struct rl_error *error);
void rl_eta_measured(struct rl_eta *eta, const struct rl_record *first);
void rl_eta_dropped(struct rl_eta *eta, const struct rl_record *first);

/* Of all open groups together; one that is like none takes as long as the mean of those of its study of which something is known, or
 * else of all. NaN: nothing is known at all. */
double rl_eta_seconds(const struct rl_eta *eta);

void rl_eta_clear(struct rl_eta *eta);

#endif
