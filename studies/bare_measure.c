/* Times a plan against bare OpenGL, and judges (see bare.h). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "studies/bare.h"
#include "studies/bare_program.h"
#include "studies/judging.h"
#include "studies/timing_arms.h"

enum { ARMS_MAX = 8 };

/* ---- Measuring ---- */

/* One of a group's arms, ready to draw. */
struct arm {
    struct rl_bench_scene *set; /* of the plan, or NULL */
    struct rl_bare *bare;       /* of the others, or NULL */
};

static bool is_arm(const struct rl_record *r, const char *arm)
{
    char name[RL_NAME_MAX];
    rl_parameter(r->parameters, "arm", name, sizeof name);
    return strcmp(name, arm) == 0;
}

/* A view of the scene whose materials have nothing but diffuse and phong. free() its materials. */
static int strip(struct rl_scene *view, const struct rl_scene *scene, struct rl_error *error)
{
    *view = *scene;
    view->material = malloc(scene->n_materials * sizeof *scene->material);
    if (!view->material)
        return rl_fail_memory(error, "a scene's materials");
    memcpy(view->material, scene->material, scene->n_materials * sizeof *scene->material);
    for (size_t i = 0; i < view->n_materials; i++)
        for (size_t row = 0; row < rl_n_effects; row++)
            if (rl_effects[row] != rl_effect_find("diffuse") && rl_effects[row] != rl_effect_find("phong"))
                view->material[i].effect[row].given = false;
    return RL_OK;
}

int rl_bare_fits(const struct rl_scene *scene, struct rl_error *error)
{
    struct rl_scene view;
    int status = strip(&view, scene, error);
    if (status == RL_OK)
        status = rl_bare_check(&view, error);
    free(view.material);
    return status;
}

static int make(struct arm *arm, const struct rl_record *r, struct rl_bench *bench,
                const struct rl_scene *view, struct rl_error *error)
{
    if (is_arm(r, "plan"))
        return rl_bench_scene_make(&arm->set, bench, view, r->parameters, 1, error);
    int width = (int)rl_parameter_number(r->parameters, "width");
    int height = (int)rl_parameter_number(r->parameters, "height");
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_SETUP);
    int status = rl_bare_make(&arm->bare, bench->gpu, view, width, height,
                              is_arm(r, "literals") ? RL_BARE_LITERALS : RL_BARE_UNIFORMS, error);
    rl_spent_on(&bench->spent, outer);
    return status;
}

static int draw(struct rl_image *image, const struct arm *arm, struct rl_bench *bench, struct rl_error *error)
{
    double seconds;
    if (arm->set)
        return rl_bench_draw(image, bench, arm->set, error);
    int status = rl_bare_frame(arm->bare, &seconds, error);
    return status == RL_OK ? rl_bare_read(arm->bare, image, error) : status;
}

int rl_bare_add_work(struct rl_record *r, struct rl_gpu_scene *gs, struct rl_error *error)
{
    struct rl_gpu_counters before = rl_gpu_scene_counters(gs);
    double seconds;
    int depth_bits, stencil_bits;
    int status = rl_gpu_scene_frame(gs, &seconds, error);
    struct rl_gpu_counters after = rl_gpu_scene_counters(gs);
    rl_gpu_scene_depth(gs, &depth_bits, &stencil_bits);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "draws", (double)(after.draws - before.draws), "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "programs", (double)after.programs, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "textures", (double)after.textures, "1", error);
    return status == RL_OK ? rl_record_add_exact(r, "stencil", stencil_bits > 0, "1", error) : status;
}

/* The largest difference from the first arm's picture. */
static int add_pictures(struct rl_record *records, const struct arm *arm, size_t n, struct rl_bench *bench,
                        struct rl_error *error)
{
    struct rl_image first = {0}, image = {0};
    int status = draw(&first, &arm[0], bench, error);
    for (size_t i = 1; i < n && status == RL_OK; i++) {
        double worst = 0.0;
        status = draw(&image, &arm[i], bench, error);
        for (size_t k = 0; status == RL_OK && k < 4 * (size_t)image.width * (size_t)image.height; k++)
            worst = fmax(worst, fabs((double)image.data[k] - (double)first.data[k]));
        if (status == RL_OK)
            status = rl_record_add_exact(&records[i], "worst", worst, "1", error);
        rl_image_clear(&image);
    }
    rl_image_clear(&first);
    return status;
}

static int measure(struct rl_record *records, struct arm *arm, size_t n, struct rl_bench *bench,
                   const struct rl_scene *view, struct rl_error *error)
{
    int rounds = (int)rl_parameter_number(records[0].parameters, "rounds");
    const struct rl_arms_options options = {.frames = rounds,
                                            .most_frames = 2 * rounds,
                                            .most_seconds = 0.02 * rounds,
                                            .against = "arm=uniforms",
                                            .ratio = "time_to_uniforms",
                                            .against2 = "arm=literals",
                                            .ratio2 = "time_to_literals"};
    struct rl_timing_arm timed[ARMS_MAX];
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        status = make(&arm[i], &records[i], bench, view, error);
        timed[i] = arm[i].set ? (struct rl_timing_arm){records[i].parameters, rl_arms_frame, arm[i].set}
                              : (struct rl_timing_arm){records[i].parameters, rl_bare_frame, arm[i].bare};
    }
    if (status == RL_OK && arm[0].set)
        status = rl_bare_add_work(&records[0], arm[0].set->gpu_scene, error);
    if (status == RL_OK)
        status = add_pictures(records, arm, n, bench, error);
    return status == RL_OK ? rl_arms_time(records, timed, n, bench, &options, error) : status;
}

int rl_bare_measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                    struct rl_error *error)
{
    if (n < 1 || n > ARMS_MAX || !is_arm(&records[0], "plan"))
        return rl_fail(error, RL_ERR_INPUT, "a group of %zu cases, expected 1 to %d, the plan's first", n,
                       ARMS_MAX);
    struct arm arm[ARMS_MAX] = {{NULL, NULL}};
    struct rl_scene view;
    int status = strip(&view, scene, error);
    if (status == RL_OK)
        status = measure(records, arm, n, bench, &view, error);
    for (size_t i = 0; i < n; i++) {
        rl_bench_scene_free(arm[i].set);
        rl_bare_free(arm[i].bare);
    }
    free(view.material);
    return status;
}

/* ---- Claims ---- */

/* A pattern for one arm of the size that speaks: the widest. */
static const char *of(char text[64], const char *arm, double width)
{
    snprintf(text, 64, "arm=%.20s width=%g", arm, width);
    return text;
}

/* What two arms of the same work differ by. */
static double noise_at(const struct rl_judging *j, double width)
{
    char text[64];
    return rl_arms_noise(rl_judging_metric(j, of(text, "again", width), "time_to_uniforms"));
}

static int claim_bound(const struct rl_judging *j, double width)
{
    char text[64], words[160];
    snprintf(
        words, sizeof words,
        "ours: by its plan a scene of diffuse and phong takes at most %g times a bare OpenGL program for "
        "that scene",
        RL_BARE_BOUND);
    struct rl_claim *c = rl_judging_claim(j, words);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "ratio";
    const struct rl_metric *ratio = rl_judging_metric(j, of(text, "plan", width), "time_to_uniforms");
    double noise = noise_at(j, width);
    if (ratio)
        rl_claim_value(c, ratio->value, ratio->low, ratio->high, "times");
    c->verdict = rl_arms_at_most(ratio, noise, RL_BARE_BOUND);
    if (!isnan(noise))
        snprintf(c->note, sizeof c->note, "two arms of the same work differ by up to %.2g", noise);
    return RL_OK;
}

static int claim_work(const struct rl_judging *j, double width)
{
    static const char *const work[] = {"draws", "programs", "textures", "stencil"};
    char text[64];
    double value[4];
    struct rl_claim *c = rl_judging_claim(
        j, "ours: that plan draws once, with one program, no texture and no stencil buffer (cases of more)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "ratio";
    for (size_t i = 0; i < 4; i++) {
        const struct rl_metric *m = rl_judging_metric(j, of(text, "plan", width), work[i]);
        if (!m)
            return RL_OK;
        value[i] = m->value;
    }
    double more = (value[0] > 1.0) + (value[1] > 1.0) + (value[2] > 0.0) + (value[3] > 0.0);
    rl_claim_value(c, more, more, more, "cases");
    snprintf(c->note, sizeof c->note, "%g draws, %g programs, %g textures, %g stencil buffers", value[0],
             value[1], value[2], value[3]);
    c->verdict = rl_verdict_equals(c->low, c->high, 0.0, 0.0);
    return RL_OK;
}

static int claim_pictures(const struct rl_judging *j, double width)
{
    char text[64];
    struct rl_claim *c =
        rl_judging_claim(j, "ours: both draw the same picture (no component is off by more than 1e-4)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "ratio";
    const struct rl_metric *worst = rl_judging_metric(j, of(text, "uniforms", width), "worst");
    if (worst)
        rl_claim_value(c, worst->value, worst->low, worst->high, "of full scale");
    c->verdict = rl_verdict_at_most(c->low, c->high, 1e-4);
    return RL_OK;
}

static int claim_literals(const struct rl_judging *j, double width)
{
    char text[64];
    struct rl_claim *c = rl_judging_claim(
        j,
        "ours: to write the numbers of scene and material into the bare shader, in place of uniforms, saves "
        "at most a tenth of the frame");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "ratio";
    const struct rl_metric *ratio = rl_judging_metric(j, of(text, "literals", width), "time_to_uniforms");
    if (ratio)
        rl_claim_value(c, ratio->value, ratio->low, ratio->high, "times");
    double noise = noise_at(j, width);
    if (ratio && !isnan(noise))
        c->verdict = rl_verdict_at_least(ratio->low - noise, ratio->high + noise, 0.9);
    return RL_OK;
}

/* A plan's shaders are for any scene of these effects. What they would gain if they were for this one alone is what is above 1 here. */
static int claim_baked(const struct rl_judging *j, double width)
{
    char text[64], words[200];
    snprintf(
        words, sizeof words,
        "ours: what baking a scene's constants into the shader would gain is little: by its plan it takes "
        "at most %g times the bare program that has them as literals",
        RL_BARE_BOUND);
    struct rl_claim *c = rl_judging_claim(j, words);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "ratio";
    const struct rl_metric *ratio = rl_judging_metric(j, of(text, "plan", width), "time_to_literals");
    double noise = noise_at(j, width);
    c->verdict = rl_arms_at_most(ratio, noise, RL_BARE_BOUND);
    if (!ratio)
        return RL_OK;
    rl_claim_value(c, ratio->value, ratio->low, ratio->high, "times");
    snprintf(c->note, sizeof c->note, "a gain of %.2g %% of the frame, between %.2g and %.2g %%",
             100.0 * (1.0 - 1.0 / ratio->value), 100.0 * (1.0 - 1.0 / ratio->low),
             100.0 * (1.0 - 1.0 / ratio->high));
    return RL_OK;
}

static int judge(const struct rl_judging *j)
{
    double width[RL_AXIS_MAX];
    size_t n = rl_judging_axis(j, "arm=plan", "width", width);
    double widest = n ? width[n - 1] : 0.0;
    int status = claim_bound(j, widest);
    if (status == RL_OK)
        status = claim_work(j, widest);
    if (status == RL_OK)
        status = claim_pictures(j, widest);
    if (status == RL_OK)
        status = claim_baked(j, widest);
    return status == RL_OK ? claim_literals(j, widest) : status;
}

int rl_bare_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        const struct rl_judging j = {run, scene, claims, error};
        status = judge(&j);
    }
    return status;
}
