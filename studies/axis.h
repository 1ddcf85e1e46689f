/* Axes: one parameter of a study's cases with other values than the study's own, without a line changed in the study.
 *
 *     struct rl_axis axis;
 *     rl_axis_parse(&axis, "rr=1:100:log9", &error);       or "rr=1,2,4", "rr=0:1:lin5"
 *     rl_axes_apply(&run, &axis, 1, &sweeps, NULL, &error); after the study's plan, before identities
 *
 * Every case whose parameter the study lets one sweep (sweep.h) gets each of the values; several axes give every combination. Cases
 * that become the same are one, and so are those that differ in being timed only: the timed one stays. A group of cases becomes one group
 * for each value, since what is measured together has to differ only as the study meant; or, where the study meant several values side by
 * side, one with all of them.
 */
#ifndef RL_STUDIES_AXIS_H
#define RL_STUDIES_AXIS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "results/record.h"
#include "studies/sweep.h"

/* Whether a study can measure a case of these parameters: RL_OK, or RL_ERR_INPUT with what was found and expected. */
typedef int rl_parameters_check(const char *parameters, struct rl_error *error);

enum { RL_AXES_MAX = 16, RL_AXIS_VALUES_MAX = 256, RL_AXIS_VALUE_LENGTH = 32, RL_AXES_CASES_MAX = 50000 };

struct rl_axis {
    char name[RL_NAME_MAX];
    const char *text; /* as given: "rr=1:100:log9"; the caller's */
    bool range;       /* made by a range: such values may be rounded where whole ones are needed */
    size_t n;
    char value[RL_AXIS_VALUES_MAX][RL_AXIS_VALUE_LENGTH]; /* as a case's parameters have them */
};

/* Numbers are written as studies write them ("4", not "4.0"), so that a case of the study's own grid is recognised. Values of a range
 * have 6 digits: the same text, and so the same case, on every machine. `text` must outlive the axis. */
int rl_axis_parse(struct rl_axis *axis, const char *text, struct rl_error *error);

/* A study's table. */
struct rl_sweeps {
    const struct rl_sweep *sweep;
    size_t n;
};

/* RL_ERR_INPUT: the table does not have that parameter (the message lists those it has); a value is not one that the table allows, or
 * makes a case that rl_bench_settings or the study's `check` (NULL: none) refuses. `run` may then be half changed. */
int rl_axes_apply(struct rl_run *run, const struct rl_axis *axes, size_t n_axes,
                  const struct rl_sweeps *sweeps, rl_parameters_check *check, struct rl_error *error);

/* Writes `parameters` with the value of `key` replaced; RL_ERR_INPUT if that does not fit. */
int rl_parameters_replace(char out[RL_PARAMETERS_MAX], const char *parameters, const char *key,
                          const char *value, struct rl_error *error);

#endif
