/* The command `integrate`: the input is its options, one a line, as --name=value. What it takes is evaluated, by whatever method, within a
 * small budget; what comes out must be finite and have a finite error. */
#include <math.h>

#include "cli/integrate_job.h"
#include "fuzz/harness.h"

extern const struct rl_command rl_command_integrate;

enum { WORDS_MAX = 64, EVALUATIONS_MAX = 400, ENV_SIZE_MAX = 16 };

static void limit(struct rl_integrate_job *job)
{
    struct rl_integrate_options *o = &job->options;
    job->repeat = 1;
    if (o->max_evaluations == 0 || o->max_evaluations > EVALUATIONS_MAX)
        o->max_evaluations = EVALUATIONS_MAX;
    if (o->env_size == 0 || o->env_size > ENV_SIZE_MAX)
        o->env_size = ENV_SIZE_MAX;
}

static bool bounds_error(const struct rl_integrate_job *job)
{
    return strcmp(job->integrator->name, "reference") == 0;
}

static void evaluate(const struct rl_integrate_job *job)
{
    struct rl_estimate estimate;
    struct rl_error error = {0};
    double seconds;
    int status = rl_integrate_job_run(&estimate, &seconds, job, &error);
    fuzz_check_error(status, &error);
    if (status != RL_OK)
        return;
    double value = estimate.value[0], half = estimate.error[0];
    FUZZ_CHECK(isfinite(value) && isfinite(half) && half >= 0.0);
    /* The reference bounds its error, and of radiance 1 there comes back from 0 to 1. */
    FUZZ_CHECK(!bounds_error(job) || (value + half >= 0.0 && value - half <= 1.0));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = fuzz_text(data, size), *rest = text, *word[WORDS_MAX];
    int n = 0;
    while (n < WORDS_MAX && (word[n] = strsep(&rest, "\n")) != NULL)
        n++;
    struct rl_arguments arguments;
    struct rl_error error = {0};
    int status = rl_arguments_parse(&arguments, &rl_command_integrate, n, word, &error);
    if (status == RL_OK) {
        struct rl_integrate_job job;
        status = rl_integrate_job_take(&job, &arguments, &error);
        limit(&job);
        if (status == RL_OK)
            evaluate(&job);
        rl_integrate_job_clear(&job);
    }
    fuzz_check_error(status, &error);
    free(text);
    return 0;
}
