/* Measures the cases of the study `samples`: pictures of every seed against the reference, then frame times. */
#include <stdbool.h>

#include "studies/samples.h"
#include "studies/seeds.h"
#include "studies/timing_arms.h"

enum { ARMS_MAX = RL_TIMING_ARMS_MAX };

/* Draws a case and holds it against the references; its scene is handed on to be timed. */
static int measure_error(struct rl_record *r, struct rl_bench_scene **set, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error)
{
    struct rl_seeds s = {0};
    const struct rl_image *truth = NULL, *centre = NULL;
    int status = rl_bench_scene_make(set, bench, scene, r->parameters, 1, error);
    if (status == RL_OK)
        status = rl_seeds_draw(&s, bench, *set, rl_parameter_number(r->parameters, "seeds"), error);
    if (status == RL_OK)
        status = rl_bench_reference(&truth, bench, scene, r->parameters, RL_LIGHT_FROM_POINT, error);
    if (status == RL_OK)
        status = rl_bench_reference(&centre, bench, scene, r->parameters, RL_LIGHT_FROM_OBJECT, error);
    if (status == RL_OK)
        status = rl_seeds_add_error(r, &s, truth, centre, error);
    rl_seeds_clear(&s);
    return status;
}

static bool is_timed_only(const struct rl_record *r)
{
    return rl_parameters_match(r->parameters, "series=time");
}

/* The arms of a group against each other. */
static int measure_time(struct rl_record *records, struct rl_bench_scene **set, size_t n,
                        struct rl_bench *bench, struct rl_error *error)
{
    int rounds = (int)rl_parameter_number(records[0].parameters, "rounds");
    if (rounds < 1)
        return RL_OK;
    const struct rl_arms_options options = {.frames = rounds,
                                            .most_frames = 2 * rounds,
                                            .most_seconds = 0.05 * rounds,
                                            .baseline = "series=time method=none",
                                            .against = "series=methods method=random samples=4",
                                            .ratio = "time_to_random4"};
    struct rl_timing_arm arm[ARMS_MAX];
    for (size_t i = 0; i < n; i++)
        arm[i] = (struct rl_timing_arm){records[i].parameters, rl_arms_frame, set[i]};
    return rl_arms_time(records, arm, n, bench, &options, error);
}

int rl_samples_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                       const struct rl_scene *scene, struct rl_error *error)
{
    if (n > ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, at most %d are timed together", n,
                       ARMS_MAX);
    struct rl_bench_scene *set[ARMS_MAX] = {NULL};
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = is_timed_only(&records[i])
                     ? rl_bench_scene_make(&set[i], bench, scene, records[i].parameters, 1, error)
                     : measure_error(&records[i], &set[i], bench, scene, error);
    if (status == RL_OK)
        status = measure_time(records, set, n, bench, error);
    for (size_t i = 0; i < n; i++)
        rl_bench_scene_free(set[i]);
    return status;
}
