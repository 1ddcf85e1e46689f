/* Measures the cases of the study `environment` (see environment.h). */
#include <math.h>
#include <stdbool.h>

#include "measure/metrics.h"
#include "measure/statistics.h"
#include "studies/environment.h"
#include "studies/seeds.h"

static struct rl_interval root_of(struct rl_interval square)
{
    return (struct rl_interval){rl_root(square.value), rl_root(square.low), rl_root(square.high)};
}

/* Between pictures of the same seeds. A texel's border moves some normals from light to dark, which is noise of its own: floor_map
 * is without it. */
static int add_difference(struct rl_record *r, const struct rl_seeds *s, const struct rl_seeds *base,
                          struct rl_error *error)
{
    double mse[RL_SEEDS_MAX];
    struct rl_seeds difference = {0};
    struct rl_bias_variance split = {0};
    int status = rl_seeds_difference(&difference, s, base, error);
    for (size_t k = 0; k < s->n && status == RL_OK; k++) {
        struct rl_metrics m;
        status = rl_metrics_compute(&m, &s->image[k], &base->image[k], error);
        mse[k] = m.rmse * m.rmse;
    }
    if (status == RL_OK) /* counts what is not finite, too */
        status = rl_seeds_split(&split, &difference, NULL, error);
    rl_seeds_clear(&difference);
    if (status == RL_OK)
        status = rl_record_add(r, "rmse_map", root_of(rl_mean_interval(mse, s->n, 0.95)), "1", error);
    return status == RL_OK
               ? rl_record_add(r, "floor_map",
                               root_of((struct rl_interval){split.bias2, split.bias2_low, split.bias2_high}),
                               "1", error)
               : status;
}

static int add_floor(struct rl_record *r, const struct rl_seeds *s, const struct rl_image *centre,
                     struct rl_error *error)
{
    struct rl_bias_variance split;
    int status = rl_seeds_split(&split, s, centre, error);
    return status == RL_OK
               ? rl_record_add(r, "floor_centre",
                               root_of((struct rl_interval){split.bias2, split.bias2_low, split.bias2_high}),
                               "1", error)
               : status;
}

/* Whether there is any highlight in the pictures: without one all maps are right. Scenes' surfaces are the same for every seed. */
static int add_highlight(struct rl_record *r, const struct rl_seeds *base, struct rl_error *error)
{
    struct rl_bias_variance split;
    int status = rl_seeds_split(&split, base, NULL, error);
    struct rl_interval noise = {split.variance, split.variance_low, split.variance_high};
    return status == RL_OK ? rl_record_add(r, "highlight", root_of(noise), "1", error) : status;
}

/* Maps against the first record's; `with_floor`: against the reference too. */
static int measure_maps(struct rl_record *records, size_t n, struct rl_bench *bench,
                        const struct rl_scene *scene, bool with_floor, struct rl_error *error)
{
    struct rl_seeds base = {0};
    const struct rl_image *centre = NULL;
    int status = rl_seeds_draw_case(&base, bench, scene, records[0].parameters, error);
    if (status == RL_OK && with_floor)
        status =
            rl_bench_reference(&centre, bench, scene, records[0].parameters, RL_LIGHT_FROM_OBJECT, error);
    if (status == RL_OK && with_floor)
        status = add_floor(&records[0], &base, centre, error);
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = add_highlight(&records[i], &base, error);
    for (size_t i = 1; i < n && status == RL_OK; i++) {
        struct rl_seeds s = {0};
        status = rl_seeds_draw_case(&s, bench, scene, records[i].parameters, error);
        if (status == RL_OK)
            status = add_difference(&records[i], &s, &base, error);
        if (status == RL_OK && with_floor)
            status = add_floor(&records[i], &s, centre, error);
        rl_seeds_clear(&s);
    }
    rl_seeds_clear(&base);
    return status;
}

/* The first light alone, turned to a place of the cube. */
static int measure_seam(struct rl_record *records, size_t n, struct rl_bench *bench,
                        const struct rl_scene *scene, struct rl_error *error)
{
    const char *p = records[0].parameters;
    double many = rl_parameters_match(p, "place=corner") ? 1.0 : 0.0;
    double two = rl_parameters_match(p, "place=edge") ? 1.0 : many;
    struct rl_environment_move move = {1.0, v3_normalize(v3(1.0, two, many))};
    struct rl_scene copy;
    int status = rl_environment_scene_make(&copy, scene, &move, error);
    if (status != RL_OK)
        return status;
    status = measure_maps(records, n, bench, &copy, false, error);
    rl_environment_scene_free(&copy);
    return status;
}

/* Nothing but highlights is in the picture. What the tolerance could have made is none. */
static int add_highlight_of(struct rl_record *r, const struct rl_image *reference, double tolerance,
                            struct rl_error *error)
{
    struct rl_seeds one = {.n = 1, .image = {*reference}};
    struct rl_bias_variance split;
    int status = rl_seeds_split(&split, &one, NULL, error);
    double rms = rl_root(split.bias2);
    struct rl_interval strength = {rms > tolerance ? rms : 0.0, fmax(0.0, rms - tolerance), rms + tolerance};
    return status == RL_OK ? rl_record_add(r, "highlight", strength, "1", error) : status;
}

static int add_parallax(struct rl_record *r, struct rl_bench *bench, const struct rl_scene *scene,
                        struct rl_error *error)
{
    const struct rl_image *point = NULL, *centre = NULL;
    struct rl_metrics m = {0};
    int status = rl_bench_reference(&point, bench, scene, r->parameters, RL_LIGHT_FROM_POINT, error);
    if (status == RL_OK)
        status = rl_bench_reference(&centre, bench, scene, r->parameters, RL_LIGHT_FROM_OBJECT, error);
    if (status == RL_OK)
        status = rl_metrics_compute(&m, centre, point, error);
    if (status == RL_OK)
        status = add_highlight_of(r, point, rl_parameter_number(r->parameters, "tolerance"), error);
    /* Each of both may be off by the tolerance. */
    double t = 2.0 * rl_parameter_number(r->parameters, "tolerance");
    if (status == RL_OK)
        status = rl_record_add(r, "parallax", (struct rl_interval){m.rmse, fmax(0.0, m.rmse - t), m.rmse + t},
                               "1", error);
    const struct rl_object *object = &scene->object[rl_environment_object(scene)];
    double size = object->radius / v3_length(v3_sub(scene->light[0].centre, object->centre));
    return status == RL_OK ? rl_record_add_exact(r, "size", size, "1", error) : status;
}

static int measure_parallax(struct rl_record *records, size_t n, struct rl_bench *bench,
                            const struct rl_scene *scene, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        struct rl_environment_move move = {.away = rl_parameter_number(records[i].parameters, "away")};
        struct rl_scene copy;
        status = rl_environment_scene_make(&copy, scene, &move, error);
        if (status != RL_OK)
            return status;
        status = add_parallax(&records[i], bench, &copy, error);
        rl_environment_scene_free(&copy);
    }
    return status;
}

int rl_environment_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                           const struct rl_scene *scene, struct rl_error *error)
{
    const char *p = records[0].parameters;
    if (rl_parameters_match(p, "series=parallax"))
        return measure_parallax(records, n, bench, scene, error);
    if (rl_parameters_match(p, "series=seam"))
        return measure_seam(records, n, bench, scene, error);
    return measure_maps(records, n, bench, scene, rl_parameters_match(p, "series=size"), error);
}
