/* `integrate`: L_o at one point under polygon lights given on the command line, one row. */
#include <stdio.h>

#include "cli/command.h"
#include "cli/integrate_job.h"
#include "cli/output.h"

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

static int integrate(const struct rl_integrate_job *job, enum rl_output format, struct rl_error *error)
{
    struct rl_estimate estimate;
    double seconds;
    int status = rl_integrate_job_run(&estimate, &seconds, job, error);
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
        size_t n = 0;
        for (const struct rl_method_option *o = rl_integrate_method_options; o->name; o++)
            if (it->uses & o->use)
                printf("%s--%s", n++ ? ", " : "; takes ", o->name);
        printf("\n");
    }
}

static int run(const struct rl_arguments *a, struct rl_error *error)
{
    struct rl_integrate_job job = {0};
    enum rl_output format;
    int status = rl_argument_output(a, &format, error);
    if (status == RL_OK)
        status = rl_integrate_job_take(&job, a, error);
    if (status == RL_OK)
        status = integrate(&job, format, error);
    rl_integrate_job_clear(&job);
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
