/* `integrate`: L_o at one point under polygon lights given on the command line, one row. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "cli/command.h"
#include "cli/output.h"
#include "reference/integrator.h"

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
    {0, "method", "NAME", "reference (reference)"},
    {0, "tolerance", "T", "absolute error wanted, 1e-14 to 0.1 (1e-9)"},
    {0},
};

struct job {
    struct rl_surface surface;
    double rr;
    struct rl_integrate_options options;
    struct rl_light *light;
    size_t n_lights;
};

/* "x,y,z" at *text, which moves behind it. */
static bool scan_vector(const char **text, rl_vec3 *v)
{
    double c[3];
    for (int i = 0; i < 3; i++) {
        char *end = NULL;
        c[i] = strtod(*text, &end);
        if (end == *text || !isfinite(c[i]) || (i < 2 && *end != ','))
            return false;
        *text = i < 2 ? end + 1 : end;
    }
    *v = v3(c[0], c[1], c[2]);
    return **text == '\0' || isspace((unsigned char)**text);
}

static int take_vector(const struct rl_arguments *a, const char *name, bool direction, rl_vec3 *v,
                       struct rl_error *error)
{
    const char *text = rl_argument(a, name);
    if (!text)
        return RL_OK;
    const char *rest = text;
    if (!scan_vector(&rest, v) || *rest != '\0')
        return rl_fail(error, RL_ERR_INPUT, "--%s: found '%s', expected three finite numbers x,y,z", name,
                       text);
    if (!direction)
        return RL_OK;
    *v = v3_normalize(*v);
    if (!(v3_dot(*v, *v) > 0.0))
        return rl_fail(error, RL_ERR_INPUT, "--%s: found the zero vector '%s', expected a direction", name,
                       text);
    return RL_OK;
}

static int take_light(struct rl_light *light, const char *text, size_t number, struct rl_error *error)
{
    rl_vec3 vertex[RL_POLYGON_VERTICES_MAX + 1];
    int n = 0;
    const char *rest = text + strspn(text, " \t\n");
    while (*rest != '\0' && n <= RL_POLYGON_VERTICES_MAX) {
        if (!scan_vector(&rest, &vertex[n]))
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

static int take_choices(struct job *job, const struct rl_arguments *a, struct rl_error *error)
{
    const char *text = rl_argument(a, "method");
    if (text && strcmp(text, "reference") != 0)
        return rl_fail(error, RL_ERR_INPUT, "--method: found '%s', expected reference", text);
    text = rl_argument(a, "attenuation");
    job->options.attenuation = !text || strcmp(text, "on") == 0;
    if (!job->options.attenuation && strcmp(text, "off") != 0)
        return rl_fail(error, RL_ERR_INPUT, "--attenuation: found '%s', expected on or off", text);
    text = rl_argument(a, "frame");
    return text ? rl_parse_frame(&job->options.frame, text, "--frame", error) : RL_OK;
}

static int take_job(struct job *job, const struct rl_arguments *a, struct rl_error *error)
{
    job->surface.N = v3(0.0, 0.0, 1.0);
    job->options.tolerance = 1e-9;
    job->options.simd = rl_simd_best();
    static const char *const needed[] = {"view", "rr"};
    for (size_t i = 0; i < sizeof needed / sizeof needed[0]; i++)
        if (!rl_argument(a, needed[i]))
            return rl_fail(error, RL_ERR_INPUT,
                           "--%s is missing; 'roughlight integrate --help' shows an example", needed[i]);
    int status = take_vector(a, "position", false, &job->surface.P, error);
    if (status == RL_OK)
        status = take_vector(a, "normal", true, &job->surface.N, error);
    if (status == RL_OK)
        status = take_vector(a, "view", true, &job->surface.V, error);
    if (status == RL_OK)
        status = rl_argument_number(a, "rr", RL_RR_MIN, RL_RR_MAX, &job->rr, error);
    if (status == RL_OK)
        status = rl_argument_number(a, "tolerance", 1e-14, 0.1, &job->options.tolerance, error);
    if (status == RL_OK)
        status = take_choices(job, a, error);
    return status == RL_OK ? take_lights(job, a, error) : status;
}

static int integrate(const struct job *job, enum rl_output format, struct rl_error *error)
{
    struct rl_light_set *set = NULL;
    int status = rl_light_set_make(&set, job->light, job->n_lights, error);
    if (status != RL_OK)
        return status;
    struct rl_ellipsoid e = rl_ellipsoid_make(job->rr);
    struct rl_estimate estimate;
    double start = rl_clock_seconds();
    rl_integrate_lines(&estimate, &job->surface, &e, set, &job->options);
    double seconds = rl_clock_seconds() - start;
    rl_light_set_free(set);

    static const char *const columns[] = {"value", "error", "evaluations", "seconds", NULL};
    struct rl_rows rows;
    rl_rows_begin(&rows, format, columns);
    rl_rows_number(&rows, estimate.value[0]);
    rl_rows_number(&rows, estimate.error[0]);
    rl_rows_integer(&rows, (long long)estimate.evaluations);
    rl_rows_number(&rows, seconds);
    rl_rows_end(&rows);
    if (!estimate.converged)
        return rl_fail(error, RL_ERR_CHECK, "stopped at an error of %g, the tolerance is %g",
                       estimate.error[0], job->options.tolerance);
    return RL_OK;
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
    .description = "Integrates D G L_e over all microfacet normals, along lines, in double precision, and "
                   "prints one row:\n"
                   "value, error (meant to bound the true error), evaluations (lines drawn), seconds.\n"
                   "Exit 1: the tolerance was not reached; the row says how far it got.\n\n"
                   "A square light two units above the point, seen from 45 degrees:\n\n"
                   "  roughlight integrate --position 0,0,0 --normal 0,0,1 --view 1,0,1 --rr 30 \\\n"
                   "      --light \"-3,-1,2 -1,-1,2 -1,1,2 -3,1,2\"",
    .options = (const struct rl_option *const[]){options_integrate, rl_options_format, NULL},
    .run = run,
};
