/* Within studies: whether a study's cases take the values of an axis. */
#ifndef RL_STUDIES_AXIS_VALUES_H
#define RL_STUDIES_AXIS_VALUES_H

#include "studies/axis.h"

/* RL_ERR_INPUT if no case has the parameter, or if a value is not one of its kind; rounds the values of a range to whole numbers
 * where only these are taken. */
int rl_axis_check(struct rl_axis *axis, const struct rl_run *run, rl_parameters_check *check,
                  struct rl_error *error);

#endif
