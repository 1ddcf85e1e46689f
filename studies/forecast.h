/* What a run would do, and how long it would take: nothing is measured, nothing is written.
 *
 *     struct rl_forecast forecast;
 *     rl_forecast_make(&forecast, study, &options, &bench.provenance, &error);
 *     forecast.entry[i] tells of forecast.planned->run.record[i]
 *     rl_forecast_clear(&forecast);
 *
 * A group's time is that of the same case in the database, whoever measured it, else that of the case that is most like it
 * (the same parameters, as few other values as possible), in proportion to the number of pixels; else what the study says that such a
 * group cost its makers (cost.h); else it is unknown.
 */
#ifndef RL_STUDIES_FORECAST_H
#define RL_STUDIES_FORECAST_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "studies/planner.h"

enum rl_forecast_source { RL_FORECAST_UNKNOWN, RL_FORECAST_FIRST, RL_FORECAST_SIMILAR, RL_FORECAST_SAME };

struct rl_forecast_entry {
    bool wanted;                 /* it is in the shard asked for */
    bool open;                   /* it would be measured */
    enum rl_record_status state; /* as the database has it */
    enum rl_forecast_source source;
    double group_seconds; /* NaN: unknown */
};

struct rl_forecast {
    struct rl_planned *planned;
    struct rl_forecast_entry *entry; /* one each record of planned->run */
    size_t n_wanted, n_open;         /* cases */
    size_t groups_open, groups_unknown,
        groups_first;     /* of the open ones: without an estimate, with a first one */
    double seconds;       /* of the open groups whose time is known or estimated, together */
    double seconds_first; /* the part of it that is a first estimate */
};

/* Of options->database; no file of that name: nothing is done and no time is known. */
int rl_forecast_make(struct rl_forecast *forecast, const struct rl_study *study,
                     const struct rl_run_options *options, const struct rl_provenance *provenance,
                     struct rl_error *error);
void rl_forecast_clear(struct rl_forecast *forecast);

/* The study's first estimate for the group that begins with record number `first`; NaN: the study has none. */
double rl_forecast_first(const struct rl_run *run, size_t first);

/* The seconds that the group of the case `r` may take, by the case in `times` (NULL: nothing is known) that is most like it; the latest
 * measurement stands first there. Returns in how many values the two differ, or -1 and NaN if none is like it. */
int rl_forecast_guess(double *seconds, const struct rl_record *r, const struct rl_run *times);

/* The same by one measured case; -1 if the two have not the same parameters. */
int rl_forecast_scale(double *seconds, const struct rl_record *r, const struct rl_record *measured);

/* "same case", "similar case", "first estimate", "unknown" */
const char *rl_forecast_source_name(enum rl_forecast_source source);

#endif
