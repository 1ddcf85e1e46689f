/* Measures the cases of the study `roughness`: one R_r, every method, and from them how many normals would be needed. */
#include <math.h>
#include <stdio.h>

#include "measure/statistics.h"
#include "reference/renderer.h"
#include "studies/judging.h"
#include "studies/roughness.h"
#include "studies/seeds.h"

/* Every texel of the map at every pixel, on the CPU: one picture without chance. */
static int draw_exhaustive(struct rl_seeds *s, struct rl_bench *bench, const struct rl_scene *scene,
                           const char *parameters, struct rl_error *error)
{
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    struct rl_settings settings;
    struct rl_plan plan = {0};
    struct rl_render_stats stats;
    int status = rl_bench_settings(&settings, parameters, error);
    if (status == RL_OK)
        status = rl_plan_make(&plan, scene, &settings, error);
    if (status == RL_OK)
        status =
            rl_reference_render(&s->image[0], &stats, scene, &plan, bench->threads, &bench->quiet, error);
    s->n = status == RL_OK;
    rl_plan_clear(&plan);
    rl_spent_on(&bench->spent, outer);
    return status;
}

static int draw(struct rl_seeds *s, struct rl_bench *bench, const struct rl_scene *scene,
                const char *parameters, struct rl_error *error)
{
    if (rl_parameters_match(parameters, "method=exhaustive"))
        return draw_exhaustive(s, bench, scene, parameters, error);
    return rl_seeds_draw_case(s, bench, scene, parameters, error);
}

static int measure_error(struct rl_record *r, struct rl_bench *bench, const struct rl_scene *scene,
                         struct rl_error *error)
{
    struct rl_seeds s = {0};
    const struct rl_image *truth = NULL, *centre = NULL;
    int status = draw(&s, bench, scene, r->parameters, error);
    if (status == RL_OK)
        status = rl_bench_reference(&truth, bench, scene, r->parameters, RL_LIGHT_FROM_POINT, error);
    if (status == RL_OK)
        status = rl_bench_reference(&centre, bench, scene, r->parameters, RL_LIGHT_FROM_OBJECT, error);
    if (status == RL_OK)
        status = rl_seeds_add_error(r, &s, truth, centre, error);
    rl_seeds_clear(&s);
    return status;
}

/* What the random cases of one setting say together. */
struct random_cases {
    struct rl_interval variance_1;
    struct rl_metric floor, floor_centre; /* at the largest N */
};

/* The cases share their seeds, and so their intervals are not independent: the mean's is the mean of theirs. */
static size_t gather(struct random_cases *all, const struct rl_record *records, size_t n, const char *setting)
{
    char pattern[RL_NAME_MAX + 64];
    snprintf(pattern, sizeof pattern, "series=methods method=random setting=%s", setting);
    double largest = 0.0;
    size_t found = 0;
    *all = (struct random_cases){0};
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *v = rl_record_metric(&records[i], "variance");
        if (!v || !rl_parameters_match(records[i].parameters, pattern))
            continue;
        double samples = rl_parameter_number(records[i].parameters, "samples");
        all->variance_1.value += samples * v->value;
        all->variance_1.low += samples * v->low;
        all->variance_1.high += samples * v->high;
        found++;
        if (samples > largest) {
            largest = samples;
            all->floor = *rl_record_metric(&records[i], "floor");
            all->floor_centre = *rl_record_metric(&records[i], "floor_centre");
        }
    }
    all->variance_1.value /= (double)found;
    all->variance_1.low /= (double)found;
    all->variance_1.high /= (double)found;
    return found;
}

/* The smallest whole N >= 1 with variance_1/N + floor^2 <= step^2. */
static double needed(double variance_1, double floor)
{
    double room = RL_STEP_OF_8_BITS * RL_STEP_OF_8_BITS - floor * floor;
    return room > 0.0 ? fmax(1.0, ceil(variance_1 / room)) : INFINITY;
}

static int add_needed(struct rl_record *r, const char *name, const struct rl_interval *variance_1,
                      const struct rl_metric *floor, struct rl_error *error)
{
    return rl_record_metric_add(r, name, needed(variance_1->value, floor->value),
                                needed(fmax(variance_1->low, 0.0), floor->low),
                                needed(variance_1->high, floor->high), "1", error);
}

static int summarise(struct rl_record *r, const struct rl_record *before, size_t n, struct rl_error *error)
{
    char setting[RL_NAME_MAX];
    struct random_cases all;
    rl_parameter(r->parameters, "setting", setting, sizeof setting);
    if (gather(&all, before, n, setting) == 0)
        return rl_fail(error, RL_ERR_INPUT, "setting=%s: none of its random cases came before", setting);
    const struct rl_interval *v = &all.variance_1;
    int status = rl_record_metric_add(r, "variance_1", v->value, v->low, v->high, "1", error);
    if (status == RL_OK)
        status = rl_record_metric_add(r, "floor", all.floor.value, all.floor.low, all.floor.high, "1", error);
    if (status == RL_OK)
        status = rl_record_metric_add(r, "floor_centre", all.floor_centre.value, all.floor_centre.low,
                                      all.floor_centre.high, "1", error);
    if (status == RL_OK)
        status = add_needed(r, "needed", v, &all.floor, error);
    if (status == RL_OK)
        status = add_needed(r, "needed_centre", v, &all.floor_centre, error);
    return status;
}

int rl_roughness_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        if (rl_parameters_match(records[i].parameters, "series=needed"))
            status = summarise(&records[i], records, i, error);
        else
            status = measure_error(&records[i], bench, scene, error);
    }
    return status;
}
