/* Takes what `integrate` shall do from its options, and does it (see integrate_job.h). */
#include "cli/integrate_job.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "measure/statistics.h"

const struct rl_method_option rl_integrate_method_options[] = {
    {"tolerance", RL_USES_TOLERANCE}, {"max-evaluations", RL_USES_MAX_EVALUATIONS},
    {"seed", RL_USES_SEED},           {"confidence", RL_USES_CONFIDENCE},
    {"env-size", RL_USES_ENV_SIZE},   {0},
};
enum { NAMES = 256 };

/* A coordinate beyond what a scene may have, or 0. */
static double too_large(rl_vec3 v)
{
    const double c[3] = {v.x, v.y, v.z};
    for (int i = 0; i < 3; i++)
        if (fabs(c[i]) > RL_LENGTH_MAX)
            return c[i];
    return 0.0;
}

static int take_light(struct rl_light *light, const char *text, size_t number, struct rl_error *error)
{
    rl_vec3 vertex[RL_POLYGON_VERTICES_MAX + 1];
    int n = 0;
    const char *rest = text + strspn(text, " \t\n");
    while (*rest != '\0' && n <= RL_POLYGON_VERTICES_MAX) {
        if (!rl_text_vector(&rest, &vertex[n]))
            return rl_fail(error, RL_ERR_INPUT,
                           "--light %zu: vertex %d in '%s', expected three finite numbers x,y,z", number,
                           n + 1, text);
        if (too_large(vertex[n]) != 0.0)
            return rl_fail(error, RL_ERR_INPUT,
                           "--light %zu: vertex %d: found %g, expected coordinates from %g to %g", number,
                           n + 1, too_large(vertex[n]), -RL_LENGTH_MAX, RL_LENGTH_MAX);
        n++;
        rest += strspn(rest, " \t\n");
    }
    light->polygon = calloc(1, sizeof *light->polygon);
    if (!light->polygon)
        return rl_fail_memory(error, "a light");
    light->n_polygons = 1;
    light->radiance[0] = light->radiance[1] = light->radiance[2] = 1.0;
    int status = rl_polygon_make(light->polygon, vertex, n, error);
    if (status != RL_OK)
        rl_fail_prefix(error, "--light %zu", number);
    return status;
}

static int take_lights(struct rl_integrate_job *job, const struct rl_arguments *a, struct rl_error *error)
{
    while (rl_argument_nth(a, "light", job->n_lights))
        job->n_lights++;
    if (job->n_lights == 0)
        return rl_fail(error, RL_ERR_INPUT,
                       "--light is missing, expected at least one polygon \"x,y,z x,y,z x,y,z\"");
    job->light = calloc(job->n_lights, sizeof *job->light);
    if (!job->light)
        return rl_fail_memory(error, "lights");
    int status = RL_OK;
    for (size_t i = 0; i < job->n_lights && status == RL_OK; i++)
        status = take_light(&job->light[i], rl_argument_nth(a, "light", i), i + 1, error);
    return status;
}

/* The methods that make use of these options (0: all of them), separated by commas. */
static void list_methods(char names[NAMES], unsigned uses)
{
    size_t used = 0;
    names[0] = '\0';
    for (size_t i = 0; i < rl_n_integrators && used < NAMES; i++)
        if ((rl_integrators[i]->uses & uses) == uses)
            used += (size_t)snprintf(names + used, NAMES - used, "%s%s", used ? ", " : "",
                                     rl_integrators[i]->name);
}

static int take_method(struct rl_integrate_job *job, const struct rl_arguments *a, struct rl_error *error)
{
    const char *text = rl_argument(a, "method");
    char names[NAMES];
    job->integrator = rl_integrator_find(text ? text : "reference");
    list_methods(names, 0);
    if (!job->integrator)
        return rl_fail(error, RL_ERR_INPUT, "--method: found '%s', expected one of %s", text, names);
    for (size_t i = 0; rl_integrate_method_options[i].name; i++) {
        const struct rl_method_option *o = &rl_integrate_method_options[i];
        if (!rl_argument(a, o->name) || (job->integrator->uses & o->use))
            continue;
        list_methods(names, o->use);
        return rl_fail(error, RL_ERR_INPUT, "--%s has no effect with --method %s; it is for %s", o->name,
                       job->integrator->name, names[0] ? names : "methods that this build lacks");
    }
    return RL_OK;
}

static int take_choices(struct rl_integrate_job *job, const struct rl_arguments *a, struct rl_error *error)
{
    const char *text = rl_argument(a, "attenuation");
    job->options.attenuation = !text || strcmp(text, "on") == 0;
    if (!job->options.attenuation && strcmp(text, "off") != 0)
        return rl_fail(error, RL_ERR_INPUT, "--attenuation: found '%s', expected on or off", text);
    text = rl_argument(a, "frame");
    return text ? rl_parse_frame(&job->options.frame, text, "--frame", error) : RL_OK;
}

static int take_numbers(struct rl_integrate_job *job, const struct rl_arguments *a, struct rl_error *error)
{
    long long most = 0, seed = 1, env_size = 0, repeat = 0;
    job->options.tolerance = job->integrator->default_tolerance;
    job->asked = rl_argument(a, "tolerance") != NULL;
    int status = rl_argument_number(a, "rr", RL_RR_MIN, RL_RR_MAX, &job->rr, error);
    if (status == RL_OK)
        status = rl_argument_number(a, "tolerance", 1e-14, 0.1, &job->options.tolerance, error);
    if (status == RL_OK)
        status = rl_argument_integer(a, "max-evaluations", 1, 1000000000000, &most, error);
    if (status == RL_OK)
        status = rl_argument_integer(a, "seed", 0, LLONG_MAX, &seed, error);
    if (status == RL_OK)
        status = rl_argument_number(a, "confidence", 0.5, 0.999999, &job->options.confidence, error);
    if (status == RL_OK)
        status = rl_argument_integer(a, "env-size", 8, 16384, &env_size, error);
    if (status == RL_OK)
        status = rl_argument_integer(a, "repeat", 1, 1000000, &repeat, error);
    job->options.max_evaluations = (size_t)most;
    job->options.seed = (uint64_t)seed;
    job->options.env_size = (int)env_size;
    job->repeat = (size_t)repeat;
    return status;
}

int rl_integrate_job_take(struct rl_integrate_job *job, const struct rl_arguments *a, struct rl_error *error)
{
    *job = (struct rl_integrate_job){0};
    job->surface.N = v3(0.0, 0.0, 1.0);
    job->options.simd = rl_simd_best();
    static const char *const needed[] = {"view", "rr"};
    for (size_t i = 0; i < sizeof needed / sizeof needed[0]; i++)
        if (!rl_argument(a, needed[i]))
            return rl_fail(error, RL_ERR_INPUT,
                           "--%s is missing; 'roughlight integrate --help' shows an example", needed[i]);
    int status = rl_argument_vector(a, "position", false, &job->surface.P, error);
    if (status == RL_OK && too_large(job->surface.P) != 0.0)
        status = rl_fail(error, RL_ERR_INPUT, "--position: found %g, expected coordinates from %g to %g",
                         too_large(job->surface.P), -RL_LENGTH_MAX, RL_LENGTH_MAX);
    if (status == RL_OK)
        status = rl_argument_vector(a, "normal", true, &job->surface.N, error);
    if (status == RL_OK)
        status = rl_argument_vector(a, "view", true, &job->surface.V, error);
    if (status == RL_OK)
        status = take_method(job, a, error);
    if (status == RL_OK)
        status = take_numbers(job, a, error);
    if (status == RL_OK)
        status = take_choices(job, a, error);
    return status == RL_OK ? take_lights(job, a, error) : status;
}

/* Evaluates as often as asked for, or, if that was left open, up to 9 times while that takes no longer than a millisecond, since the
 * first time costs what it takes to bring the program's pages in. *seconds is the median. */
static int evaluate(struct rl_estimate *estimate, double *seconds, const struct rl_integrate_job *job,
                    const struct rl_light_set *set, struct rl_error *error)
{
    enum { OPEN_REPEATS = 9 };
    struct rl_ellipsoid e = rl_ellipsoid_make(job->rr);
    size_t most = job->repeat ? job->repeat : OPEN_REPEATS, n = 0;
    double *each = calloc(most, sizeof *each), sum = 0.0;
    if (!each)
        return rl_fail_memory(error, "the times");
    int status = RL_OK;
    while (n < most && status == RL_OK && (n == 0 || job->repeat || sum < 1e-3)) {
        double start = rl_clock_seconds();
        status = job->integrator->integrate(estimate, &job->surface, &e, set, &job->options, error);
        each[n] = rl_clock_seconds() - start;
        sum += each[n++];
    }
    *seconds = rl_median_interval(each, n, 0.95).value;
    free(each);
    return status;
}

int rl_integrate_job_run(struct rl_estimate *estimate, double *seconds, const struct rl_integrate_job *job,
                         struct rl_error *error)
{
    struct rl_light_set *set = NULL;
    int status = rl_light_set_make(&set, job->light, job->n_lights, error);
    if (status == RL_OK)
        status = evaluate(estimate, seconds, job, set, error);
    rl_light_set_free(set);
    return status;
}

void rl_integrate_job_clear(struct rl_integrate_job *job)
{
    for (size_t i = 0; i < job->n_lights && job->light; i++) {
        if (job->light[i].polygon)
            rl_polygon_clear(job->light[i].polygon);
        free(job->light[i].polygon);
    }
    free(job->light);
    *job = (struct rl_integrate_job){0};
}
