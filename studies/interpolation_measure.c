/* Measures the cases of the study `interpolation`: frame times here, errors and bands in the files beside (see interpolation.h). */
#include "studies/interpolation.h"
#include "studies/timing_arms.h"

enum { ARMS_MAX = RL_TIMING_ARMS_MAX };

static int measure_time(struct rl_record *records, size_t n, struct rl_bench *bench, struct rl_error *error)
{
    struct rl_bench_scene *set[ARMS_MAX] = {NULL};
    struct rl_timing_arm arm[ARMS_MAX];
    struct rl_scene scene;
    char object[RL_NAME_MAX];
    const char *p = records[0].parameters;
    rl_parameter(p, "object", object, sizeof object);
    if (n > ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, at most %d are timed together", n,
                       ARMS_MAX);
    int status = rl_interpolation_scene_make(&scene, object, (int)rl_parameter_number(p, "tessellation"),
                                             "side", rl_parameter_number(p, "exponent"), error);
    if (status != RL_OK)
        return status;
    double triangles = (double)scene.object[0].mesh.n_triangles;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        status = rl_bench_scene_make(&set[i], bench, &scene, records[i].parameters, 1, error);
        arm[i] = (struct rl_timing_arm){records[i].parameters, rl_arms_frame, set[i]};
        if (status == RL_OK)
            status = rl_record_add(&records[i], "triangles",
                                   (struct rl_interval){triangles, triangles, triangles}, "1", error);
    }
    int frames = (int)rl_parameter_number(p, "frames");
    const struct rl_arms_options options = {.frames = frames,
                                            .most_frames = 3 * frames,
                                            .most_seconds = rl_parameter_number(p, "seconds"),
                                            .against = "interpolation=phong arm=frame",
                                            .ratio = "time_to_phong"};
    if (status == RL_OK)
        status = rl_arms_time(records, arm, n, bench, &options, error);
    for (size_t i = 0; i < n; i++)
        rl_bench_scene_free(set[i]);
    rl_interpolation_scene_free(&scene);
    return status;
}

int rl_interpolation_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                             const struct rl_scene *scene, struct rl_error *error)
{
    (void)scene;
    if (rl_parameters_match(records[0].parameters, "series=error"))
        return rl_interpolation_measure_errors(records, n, bench, error);
    if (rl_parameters_match(records[0].parameters, "series=time"))
        return measure_time(records, n, bench, error);
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = rl_interpolation_measure_bands(&records[i], bench, error);
    return status;
}
