/* What `integrate` is asked for, apart from how it is said and printed.
 *
 *     struct rl_integrate_job job;
 *     status = rl_integrate_job_take(&job, &arguments, &error);
 *     if (status == RL_OK)
 *         status = rl_integrate_job_run(&estimate, &seconds, &job, &error);
 *     rl_integrate_job_clear(&job);
 */
#ifndef RL_CLI_INTEGRATE_JOB_H
#define RL_CLI_INTEGRATE_JOB_H

#include "cli/command.h"
#include "reference/integrators.h"

struct rl_integrate_job {
    const struct rl_integrator *integrator;
    struct rl_surface surface;
    double rr;
    size_t repeat; /* 0: left open */
    bool asked;    /* for a tolerance: only then is it a failure not to reach it */
    struct rl_integrate_options options;
    struct rl_light *light;
    size_t n_lights;
};

/* Options that some methods have no use for: given to one of those they are refused, lest somebody trusts in them. One without a name ends
 * the list. */
struct rl_method_option {
    const char *name;
    enum rl_integrator_uses use;
};
extern const struct rl_method_option rl_integrate_method_options[];

/* RL_ERR_INPUT names the option, what was found and what was expected. Clear the job, also after an error. */
int rl_integrate_job_take(struct rl_integrate_job *job, const struct rl_arguments *arguments,
                          struct rl_error *error);
/* *seconds: the median of the job's repetitions. */
int rl_integrate_job_run(struct rl_estimate *estimate, double *seconds, const struct rl_integrate_job *job,
                         struct rl_error *error);
void rl_integrate_job_clear(struct rl_integrate_job *job);

#endif
