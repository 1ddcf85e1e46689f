/* Measures exhaustive's inner loop for the study `accuracy` (see accuracy.h): sums over the texels of one face, for shading points
 * that differ, on all threads at once. */
#include <math.h>
#include <stdlib.h>

#include "base/clock.h"
#include "measure/timing.h"
#include "model/random.h"
#include "reference/cube_map.h"
#include "reference/texel_sum.h"
#include "studies/accuracy.h"

enum { POINTS = 64 };

struct arm {
    rl_texel_sum *sum;
    const struct rl_texel_list *texels;
    const struct rl_texel_point *point; /* [POINTS] */
    int threads;
    size_t calls; /* of each thread in a round */
    double total; /* of all sums, so that they are not for nothing */
};

static int run_calls(void *user, double *seconds, struct rl_error *error)
{
    (void)error;
    struct arm *arm = user;
    double total = 0.0, start = rl_clock_seconds();
#pragma omp parallel num_threads(arm->threads) reduction(+ : total)
    for (size_t i = 0; i < arm->calls; i++)
        total += arm->sum(arm->texels, &arm->point[i % POINTS]);
    *seconds = rl_clock_seconds() - start;
    arm->total += total;
    return RL_OK;
}

/* As many calls as take a thread about `seconds`, found on one thread: starting others takes longer than many calls. */
static void choose_calls(struct arm *arm, double seconds)
{
    struct arm alone = *arm;
    double took = 0.0;
    alone.threads = 1;
    for (alone.calls = 1; took < 0.1 * seconds; alone.calls *= 2)
        run_calls(&alone, &took, NULL);
    arm->calls =
        (size_t)fmax(1.0, 0.5 * (double)alone.calls * seconds / took); /* doubled once after the last */
}

/* The texels of the face +z, which N faces, give or take. */
static int make_texels(struct rl_texel_list *list, float **memory, int size, struct rl_error *error)
{
    size_t n = (size_t)size * (size_t)size;
    *memory = malloc(4 * n * sizeof **memory);
    if (!*memory)
        return rl_fail_memory(error, "the texels of a face");
    float *x = *memory, *y = x + n, *z = y + n, *solid_angle = z + n;
    for (size_t i = 0; i < n; i++) {
        size_t column = i % (size_t)size, row = i / (size_t)size;
        double s = (2.0 * (double)column + 1.0) / size - 1.0, t = (2.0 * (double)row + 1.0) / size - 1.0;
        rl_vec3 L = v3_normalize(rl_cube_direction(4, s, t));
        x[i] = (float)L.x;
        y[i] = (float)L.y;
        z[i] = (float)L.z;
        solid_angle[i] = (float)rl_cube_solid_angle(s, t, 1.0 / size);
    }
    *list = (struct rl_texel_list){n, x, y, z, solid_angle};
    return RL_OK;
}

static void make_points(struct rl_texel_point point[POINTS])
{
    for (uint64_t i = 0; i < POINTS; i++) {
        double v_n = 0.05 + 0.95 * rl_random_uniform(1, 2 * i),
               round = 2.0 * RL_PI * rl_random_uniform(1, 2 * i + 1);
        double r = sqrt(1.0 - v_n * v_n);
        point[i] =
            (struct rl_texel_point){.axis = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}},
                                    .v = {(float)(r * cos(round)), (float)(r * sin(round)), (float)v_n},
                                    .rr = 30.0f,
                                    .u_least = 1e-3f,
                                    .attenuation = true};
    }
}

static int store(struct rl_record *r, const struct arm *arm, double *ms, size_t n, struct rl_error *error)
{
    double work = (double)arm->calls * (double)arm->threads * (double)arm->texels->n;
    for (size_t i = 0; i < n; i++)
        ms[i] = 1000.0 * work / ms[i];
    struct rl_interval rate = rl_interval_from_0(rl_median_interval(ms, n, 0.95));
    int status = rl_record_add(r, "texel_normals", rate, "1/s", error);
    return status == RL_OK ? rl_record_series_add(r, "texel_normals", ms, n, error) : status;
}

static int time_arms(struct rl_record *records, struct arm *arm, size_t n, struct rl_bench *bench,
                     struct rl_error *error)
{
    struct rl_timing_arm timed[RL_TIMING_ARMS_MAX];
    double seconds = rl_parameter_number(records[0].parameters, "seconds");
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_SETUP);
    for (size_t i = 0; i < n; i++) {
        choose_calls(&arm[i], seconds);
        timed[i] = (struct rl_timing_arm){records[i].parameters, run_calls, &arm[i]};
    }
    struct rl_timing_options options = RL_TIMING_DEFAULT;
    options.warm_up = 1;
    options.min_rounds = options.max_rounds = (int)rl_parameter_number(records[0].parameters, "rounds");
    struct rl_timing timing;
    rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    int status = rl_timing_run(&timing, timed, n, &options, &bench->quiet, error);
    rl_spent_on(&bench->spent, outer);
    if (status != RL_OK)
        return status;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = store(&records[i], &arm[i], timing.ms[i], timing.n_rounds, error);
    rl_timing_clear(&timing);
    return status;
}

int rl_accuracy_measure_kernel(struct rl_record *records, size_t n, struct rl_bench *bench,
                               struct rl_error *error)
{
    struct arm arm[RL_TIMING_ARMS_MAX];
    struct rl_texel_point point[POINTS];
    struct rl_texel_list texels;
    float *memory;
    if (n > RL_TIMING_ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, at most %d are timed together", n,
                       RL_TIMING_ARMS_MAX);
    int status =
        make_texels(&texels, &memory, (int)rl_parameter_number(records[0].parameters, "size"), error);
    if (status != RL_OK)
        return status;
    make_points(point);
    for (size_t i = 0; i < n; i++) {
        char pattern[RL_NAME_MAX];
        enum rl_simd simd = RL_SIMD_PLAIN;
        for (int k = 0; k <= (int)rl_simd_best(); k++) {
            snprintf(pattern, sizeof pattern, "simd=%s", rl_simd_name((enum rl_simd)k));
            if (rl_parameters_match(records[i].parameters, pattern))
                simd = (enum rl_simd)k;
        }
        arm[i] = (struct arm){.sum = rl_texel_sum_for(simd),
                              .texels = &texels,
                              .point = point,
                              .threads = (int)rl_parameter_number(records[i].parameters, "threads")};
    }
    status = time_arms(records, arm, n, bench, error);
    free(memory);
    return status;
}
