/* `integrate`: L_o at one point under polygon lights given on the command line, one row. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "cli/command.h"
#include "cli/output.h"
#include "measure/statistics.h"
#include "reference/integrators.h"

static const struct rl_option options_integrate[] = {
    {0, "position", "x,y,z", "the shading point (0,0,0)"},
    {0, "normal", "x,y,z", "surface normal, any length (0,0,1)"},
    {0, "view", "x,y,z", "direction to the eye, any length; needed"},
    {0, "rr", "R", "R_r of the ellipsoid distribution, 1e-6 to 1e12; needed"},
    {0, "light", "\"x,y,z ...\"",
     "a planar polygon of 3 to 64 vertices, radiance 1, two-sided; may be repeated; needed"},
    {0, "attenuation", "on|off",
     "geometric attenuation G; off: G = 1 for every L, below the horizon too (on)"},
    {0, "frame", "NAME", "tangent frame: orthonormal, printed (orthonormal)"},
    {0, "method", "NAME", "one of the methods below (reference)"},
    {0, "tolerance", "T", "absolute error wanted, 1e-14 to 0.1 (the method's own, below)"},
    {0, "max-evaluations", "N", "stop there, whatever the error is (the method's own, below)"},
    {0, "seed", "S", "of the random numbers, 0 to 2^63 - 1 (1)"},
    {0, "confidence", "C", "level of the interval that `error` is the half width of, 0.5 to 0.999999 (0.99)"},
    {0, "env-size", "S", "texels along an edge of the environment map, 8 to 16384 (512)"},
    {0, "repeat", "K",
     "evaluate K times, 1 to 1000000, and print the median of their seconds (up to 9 within a millisecond)"},
    {0},
};

/* Options that some methods have no use for: given to one of those they are refused, lest somebody trusts in them. */
static const struct {
    const char *name;
    enum rl_integrator_uses use;
} method_options[] = {
    {"tolerance", RL_USES_TOLERANCE}, {"max-evaluations", RL_USES_MAX_EVALUATIONS},
    {"seed", RL_USES_SEED},           {"confidence", RL_USES_CONFIDENCE},
    {"env-size", RL_USES_ENV_SIZE},
};
enum { METHOD_OPTIONS = sizeof method_options / sizeof method_options[0], NAMES = 256 };

struct job {
    const struct rl_integrator *integrator;
    struct rl_surface surface;
    double rr;
    size_t repeat; /* 0: left open */
    bool asked;    /* for a tolerance: only then is it a failure not to reach it */
    struct rl_integrate_options options;
    struct rl_light *light;
    size_t n_lights;
};

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

static int take_lights(struct job *job, const struct rl_arguments *a, struct rl_error *error)
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

static int take_method(struct job *job, const struct rl_arguments *a, struct rl_error *error)
{
    const char *text = rl_argument(a, "method");
    char names[NAMES];
    job->integrator = rl_integrator_find(text ? text : "reference");
    list_methods(names, 0);
    if (!job->integrator)
        return rl_fail(error, RL_ERR_INPUT, "--method: found '%s', expected one of %s", text, names);
    for (size_t i = 0; i < METHOD_OPTIONS; i++) {
        if (!rl_argument(a, method_options[i].name) || (job->integrator->uses & method_options[i].use))
            continue;
        list_methods(names, method_options[i].use);
        return rl_fail(error, RL_ERR_INPUT, "--%s has no effect with --method %s; it is for %s",
                       method_options[i].name, job->integrator->name,
                       names[0] ? names : "methods that this build lacks");
    }
    return RL_OK;
}

static int take_choices(struct job *job, const struct rl_arguments *a, struct rl_error *error)
{
    const char *text = rl_argument(a, "attenuation");
    job->options.attenuation = !text || strcmp(text, "on") == 0;
    if (!job->options.attenuation && strcmp(text, "off") != 0)
        return rl_fail(error, RL_ERR_INPUT, "--attenuation: found '%s', expected on or off", text);
    text = rl_argument(a, "frame");
    return text ? rl_parse_frame(&job->options.frame, text, "--frame", error) : RL_OK;
}

static int take_numbers(struct job *job, const struct rl_arguments *a, struct rl_error *error)
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

static int take_job(struct job *job, const struct rl_arguments *a, struct rl_error *error)
{
    job->surface.N = v3(0.0, 0.0, 1.0);
    job->options.simd = rl_simd_best();
    static const char *const needed[] = {"view", "rr"};
    for (size_t i = 0; i < sizeof needed / sizeof needed[0]; i++)
        if (!rl_argument(a, needed[i]))
            return rl_fail(error, RL_ERR_INPUT,
                           "--%s is missing; 'roughlight integrate --help' shows an example", needed[i]);
    int status = rl_argument_vector(a, "position", false, &job->surface.P, error);
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
static int evaluate(struct rl_estimate *estimate, double *seconds, const struct job *job,
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

static int integrate(const struct job *job, enum rl_output format, struct rl_error *error)
{
    struct rl_light_set *set = NULL;
    int status = rl_light_set_make(&set, job->light, job->n_lights, error);
    if (status != RL_OK)
        return status;
    struct rl_estimate estimate;
    double seconds;
    status = evaluate(&estimate, &seconds, job, set, error);
    rl_light_set_free(set);
    if (status != RL_OK)
        return status;

    static const char *const columns[] = {"value", "error", "evaluations", "seconds", NULL};
    struct rl_rows rows;
    rl_rows_begin(&rows, format, columns);
    rl_rows_number(&rows, estimate.value[0]);
    rl_rows_number(&rows, estimate.error[0]);
    rl_rows_integer(&rows, (long long)estimate.evaluations);
    rl_rows_number(&rows, seconds);
    rl_rows_end(&rows);
    if (!estimate.converged && job->asked)
        return rl_fail(error, RL_ERR_CHECK, "stopped at an error of %g after %zu %s, the tolerance is %g",
                       estimate.error[0], estimate.evaluations, job->integrator->evaluation,
                       job->options.tolerance);
    return RL_OK;
}

static void print_methods(void)
{
    printf("\nmethods:\n");
    for (size_t i = 0; i < rl_n_integrators; i++) {
        const struct rl_integrator *it = rl_integrators[i];
        printf("  %-14s %s\n", it->name, it->summary);
        printf("  %-14s error: %s\n", "", it->error);
        printf("  %-14s evaluations: %s", "", it->evaluation);
        if (it->default_evaluations)
            printf(", at most %zu", it->default_evaluations);
        if (it->uses & RL_USES_TOLERANCE)
            printf("; tolerance %g", it->default_tolerance);
        for (size_t j = 0, n = 0; j < METHOD_OPTIONS; j++)
            if (it->uses & method_options[j].use)
                printf("%s--%s", n++ ? ", " : "; takes ", method_options[j].name);
        printf("\n");
    }
}

static int run(const struct rl_arguments *a, struct rl_error *error)
{
    struct job job = {0};
    enum rl_output format;
    int status = rl_argument_output(a, &format, error);
    if (status == RL_OK)
        status = take_job(&job, a, error);
    if (status == RL_OK)
        status = integrate(&job, format, error);
    for (size_t i = 0; i < job.n_lights && job.light; i++) {
        if (job.light[i].polygon)
            rl_polygon_clear(job.light[i].polygon);
        free(job.light[i].polygon);
    }
    free(job.light);
    return rl_exit_of(status);
}

const struct rl_command rl_command_integrate = {
    .name = "integrate",
    .arguments = "--view V --rr R --light \"...\" [options]",
    .summary = "the highlight at one point under polygon lights, with its error",
    .description =
        "Integrates D G L_e over all microfacet normals in double precision, and prints one row:\n"
        "value, error (of what kind depends on the method), evaluations, seconds.\n"
        "Exit 1: the tolerance asked for was not reached; the row says how far it got.\n"
        "`seconds` is what one evaluation takes: the median of --repeat K of them.\n\n"
        "A square light two units above the point, seen from 45 degrees; then by another method:\n\n"
        "  roughlight integrate --position 0,0,0 --normal 0,0,1 --view 1,0,1 --rr 30 \\\n"
        "      --light \"-3,-1,2 -1,-1,2 -1,1,2 -3,1,2\"\n"
        "  roughlight integrate --view 1,0,1 --rr 30 --light \"-3,-1,2 -1,-1,2 -1,1,2 -3,1,2\" \\\n"
        "      --method montecarlo --tolerance 1e-4 --seed 7",
    .options = (const struct rl_option *const[]){options_integrate, rl_options_format, NULL},
    .more_help = print_methods,
    .run = run,
};
