/* Measures the cases of the study `margin`: arms set up, their losses, their clocks (see margin.h). */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "scene/margin.h"
#include "studies/margin.h"
#include "studies/timing_arms.h"

enum { ARMS_MAX = 24, TEXT_MAX = RL_PARAMETERS_MAX + 64 };

/* The largest margin that any material of the plan would need with this R_r; infinite if one can have no sphere. */
static double needed_margin(const struct rl_scene *scene, const struct rl_plan *plan, double rr)
{
    double largest = 0.0;
    for (size_t i = 0; i < plan->n_materials; i++) {
        struct rl_plan_material m = plan->material[i];
        if (m.highlight_program < 0)
            continue;
        m.rr = rr;
        largest = fmax(largest, rl_margin_auto(scene, &m, &plan->settings, plan->settings.margin_bound));
    }
    return largest;
}

/* The R_r from which on every material of the plan has a sphere: the margin falls as R_r grows. */
static double first_rr(const struct rl_scene *scene, const struct rl_plan *plan)
{
    double low = 0.0, high = log(1e9);
    if (!isfinite(needed_margin(scene, plan, exp(high))))
        return INFINITY;
    for (int i = 0; i < 50; i++) {
        double middle = 0.5 * (low + high);
        *(isfinite(needed_margin(scene, plan, exp(middle))) ? &high : &low) = middle;
    }
    return exp(high);
}

static int make_set(struct rl_bench_scene **set, struct rl_bench *bench, const struct rl_scene *scene,
                    const char *head, const struct rl_record *r, struct rl_error *error)
{
    char text[TEXT_MAX];
    snprintf(text, sizeof text, "%s%s", head, r->parameters);
    return rl_bench_scene_make(set, bench, scene, text, 1, error);
}

/* The case at its own size; a loss is the bound of `margin auto`. */
static int make_case(struct rl_bench_scene **set, struct rl_bench *bench, const struct rl_scene *scene,
                     const struct rl_record *r, struct rl_error *error)
{
    char loss[RL_NAME_MAX], head[RL_NAME_MAX + 16] = "";
    if (rl_parameter(r->parameters, "loss", loss, sizeof loss))
        snprintf(head, sizeof head, "margin=auto:%s ", loss);
    return make_set(set, bench, scene, head, r, error);
}

/* What the plan decided. */
static int add_plan(struct rl_record *r, const struct rl_scene *scene, const struct rl_plan *plan,
                    struct rl_error *error)
{
    double margin = -1.0;
    for (size_t i = 0; i < plan->n_materials; i++)
        if (plan->material[i].sphere_program >= 0)
            margin = fmax(margin, plan->material[i].margin);
    int status = rl_record_add_exact(r, "spheres", margin >= 0.0, "1", error);
    if (status == RL_OK && margin >= 0.0)
        status = rl_record_add_exact(r, "margin", margin, "1", error);
    if (status == RL_OK && plan->settings.margin_kind == RL_MARGIN_AUTO)
        status = rl_record_add_exact(r, "bound", plan->settings.margin_bound, "1", error);
    double rr = rl_parameters_match(r->parameters, "arm=auto") ? first_rr(scene, plan) : NAN;
    return status == RL_OK && isfinite(rr) ? rl_record_add_exact(r, "from_rr", rr, "1", error) : status;
}

static bool is_baseline(const struct rl_record *r)
{
    return rl_parameters_match(r->parameters, "margin=off");
}

static int measure_losses(struct rl_record *records, size_t n, struct rl_bench *bench,
                          const struct rl_scene *scene, struct rl_error *error)
{
    struct rl_margin_truth truth;
    int status = rl_margin_truth_make(&truth, bench, scene, records[0].parameters, error);
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        struct rl_bench_scene *set = NULL;
        if (is_baseline(&records[i]))
            continue;
        status = make_case(&set, bench, scene, &records[i], error);
        if (status == RL_OK)
            status = add_plan(&records[i], scene, &set->plan, error);
        if (status == RL_OK)
            status = rl_margin_add_loss(&records[i], bench, set, &truth, error);
        rl_bench_scene_free(set);
    }
    rl_margin_truth_clear(&truth);
    return status;
}

/* Frames larger than those whose loss is measured, for which a reference would take long. */
static int measure_times(struct rl_record *records, size_t n, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error)
{
    const char *p = records[0].parameters;
    int rounds = (int)rl_parameter_number(p, "rounds");
    struct rl_bench_scene *set[ARMS_MAX] = {NULL};
    struct rl_timing_arm arm[ARMS_MAX];
    const struct rl_arms_options options = {.frames = rounds,
                                            .most_frames = 2 * rounds,
                                            .most_seconds = 0.04 * rounds,
                                            .baseline = "arm=none",
                                            .against = "arm=off",
                                            .ratio = "time_to_off",
                                            .difference = "above_off_ms"};
    char head[64];
    snprintf(head, sizeof head, "width=%g height=%g ", rl_parameter_number(p, "timed_width"),
             rl_parameter_number(p, "timed_height"));
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        status = make_set(&set[i], bench, scene, head, &records[i], error);
        arm[i] = (struct rl_timing_arm){records[i].parameters, rl_arms_frame, set[i]};
    }
    if (status == RL_OK)
        status = rl_arms_time(records, arm, n, bench, &options, error);
    for (size_t i = 0; i < n; i++)
        rl_bench_scene_free(set[i]);
    return status;
}

static int measure_filled(struct rl_record *records, size_t n, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        double loss = rl_parameter_number(records[i].parameters, "loss");
        struct rl_margin_filled f = rl_margin_filled(rl_parameter_number(records[i].parameters, "rr"), loss);
        bool spheres = isfinite(f.lost) || isfinite(f.due);
        status = rl_record_add_exact(&records[i], "bound", loss, "1", error);
        if (status == RL_OK && spheres)
            status = rl_record_add_exact(&records[i], "filled", isfinite(f.lost) ? f.lost : 0.0, "1", error);
        if (status == RL_OK && spheres)
            status = rl_record_add_exact(&records[i], "due", isfinite(f.due) ? f.due : 0.0, "1", error);
    }
    return status;
}

int rl_margin_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                      const struct rl_scene *scene, struct rl_error *error)
{
    if (rl_parameters_match(records[0].parameters, "series=filled"))
        return measure_filled(records, n, error);
    if (n > ARMS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, at most %d are measured together", n,
                       ARMS_MAX);
    int status = measure_losses(records, n, bench, scene, error);
    if (status == RL_OK && rl_parameter_number(records[0].parameters, "rounds") >= 1.0)
        status = measure_times(records, n, bench, scene, error);
    return status;
}
