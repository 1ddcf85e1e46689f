/* What the sphere pass takes away, in frames of equal seeds and of the integral itself (see margin.h). */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "measure/statistics.h"
#include "measure/sum.h"
#include "reference/renderer.h"
#include "studies/margin.h"

enum { COLOURS = 3 };

/* The same base colour on both sides: the CPU's ray and the GPU's triangle found the same surface. */
static const double same_base = 1e-3;

/* The scene without highlights by the CPU renderer, to be taken from the reference. */
static int render_base(struct rl_image *base, struct rl_bench *bench, const struct rl_scene *scene,
                       const struct rl_settings *settings, struct rl_error *error)
{
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_REFERENCE);
    struct rl_scene bare = *scene;
    struct rl_plan plan = {0};
    struct rl_render_stats stats;
    bare.material = malloc(scene->n_materials * sizeof *bare.material);
    if (!bare.material)
        return rl_fail_memory(error, "a scene's materials");
    memcpy(bare.material, scene->material, scene->n_materials * sizeof *bare.material);
    for (size_t i = 0; i < scene->n_materials; i++)
        bare.material[i].method = NULL;
    int status = rl_plan_make(&plan, &bare, settings, error);
    if (status == RL_OK)
        status = rl_reference_render(base, &stats, &bare, &plan, bench->threads, &bench->quiet, error);
    rl_spent_on(&bench->spent, outer);
    rl_plan_clear(&plan);
    free(bare.material);
    return status;
}

/* highlight = reference - base, where base is what the GPU drew too. */
static int subtract_base(struct rl_image *highlight, const struct rl_image *reference,
                         const struct rl_image *base, const struct rl_image *none, struct rl_error *error)
{
    int status = rl_image_allocate(highlight, none->width, none->height, 4, error);
    size_t n = status == RL_OK ? (size_t)none->width * (size_t)none->height : 0;
    for (size_t i = 0; i < n; i++) {
        const float *r = &reference->data[4 * i], *b = &base->data[4 * i], *g = &none->data[4 * i];
        bool same = r[3] > 0.5f && g[3] > 0.5f;
        for (int c = 0; c < COLOURS; c++)
            same = same && fabs((double)b[c] - (double)g[c]) < same_base;
        for (int c = 0; c < COLOURS; c++)
            highlight->data[4 * i + (size_t)c] = same ? r[c] - b[c] : 0.0f;
        highlight->data[4 * i + 3] = same;
    }
    return status;
}

static int make_highlight(struct rl_margin_truth *truth, struct rl_bench *bench, const struct rl_scene *scene,
                          const char *parameters, struct rl_error *error)
{
    struct rl_settings settings;
    struct rl_image base = {0};
    const struct rl_image *reference = NULL;
    int status = rl_bench_settings(&settings, parameters, error);
    truth->tolerance = settings.tolerance;
    if (status == RL_OK)
        status = rl_bench_reference(&reference, bench, scene, parameters, RL_LIGHT_FROM_OBJECT, error);
    if (status == RL_OK)
        status = render_base(&base, bench, scene, &settings, error);
    if (status == RL_OK)
        status = subtract_base(&truth->highlight, reference, &base, &truth->none, error);
    rl_image_clear(&base);
    return status;
}

/* The case's parameters with another method or margin: the first of equal keys counts. */
static void with(char text[RL_PARAMETERS_MAX + 32], const char *first, const char *parameters)
{
    snprintf(text, RL_PARAMETERS_MAX + 32, "%s %s", first, parameters);
}

int rl_margin_truth_make(struct rl_margin_truth *truth, struct rl_bench *bench, const struct rl_scene *scene,
                         const char *parameters, struct rl_error *error)
{
    *truth = (struct rl_margin_truth){0};
    struct rl_bench_scene *set = NULL;
    char text[RL_PARAMETERS_MAX + 32];
    with(text, "margin=off", parameters);
    int status = rl_bench_scene_make(&set, bench, scene, text, 1, error);
    if (status == RL_OK)
        status = rl_seeds_draw(&truth->off, bench, set, rl_parameter_number(parameters, "seeds"), error);
    if (status == RL_OK)
        status = rl_gpu_scene_read_drawn(set->gpu_scene, &truth->drawn, error);
    truth->radiance = set ? (double)set->plan.radiance_scale : 0.0;
    rl_bench_scene_free(set);
    with(text, "method=none", parameters);
    if (status == RL_OK)
        status = rl_bench_picture(&truth->none, bench, scene, text, 1, error);
    if (status == RL_OK)
        status = make_highlight(truth, bench, scene, parameters, error);
    return status;
}

void rl_margin_truth_clear(struct rl_margin_truth *truth)
{
    rl_seeds_clear(&truth->off);
    rl_image_clear(&truth->none);
    rl_image_clear(&truth->drawn);
    rl_image_clear(&truth->highlight);
}

static int add(struct rl_record *r, const char *name, double value, double low, double high,
               struct rl_error *error)
{
    return rl_record_metric_add(r, name, value, low, high, "1", error);
}

/* One frame against that without the pass: the share of the highlight gone (NaN: there is none), and the most that a value lost. */
static double missed_share(const struct rl_margin_truth *truth, const struct rl_image *off,
                           const struct rl_image *on, double *worst)
{
    struct rl_sum lost = {0}, all = {0};
    size_t n = (size_t)off->width * (size_t)off->height;
    for (size_t i = 0; i < n; i++)
        for (size_t c = 4 * i; c < 4 * i + COLOURS; c++) {
            double l = (double)off->data[c] - (double)on->data[c];
            rl_sum_add(&lost, l);
            rl_sum_add(&all, (double)off->data[c] - (double)truth->none.data[c]);
            *worst = fmax(*worst, l / truth->radiance);
        }
    return rl_sum_value(&all) > 0.0 ? rl_sum_value(&lost) / rl_sum_value(&all) : NAN;
}

static int add_frames(struct rl_record *r, const struct rl_seeds *on, const struct rl_margin_truth *truth,
                      struct rl_error *error)
{
    double missed[RL_SEEDS_MAX], worst = 0.0;
    bool lit = true;
    for (size_t k = 0; k < on->n; k++) {
        missed[k] = missed_share(truth, &truth->off.image[k], &on->image[k], &worst);
        lit = lit && !isnan(missed[k]);
    }
    struct rl_interval m = on->n > 1 ? rl_mean_interval(missed, on->n, 0.95)
                                     : (struct rl_interval){missed[0], missed[0], missed[0]};
    int status = lit ? add(r, "missed", m.value, fmax(m.low, 0.0), m.high, error) : RL_OK;
    return status == RL_OK ? add(r, "worst", worst, worst, worst, error) : status;
}

/* The share of the highlight that is lost. Each value of both sums may be off by the tolerance. A highlight that the tolerance could
 * have made has no share. */
static int add_missed(struct rl_record *r, double lost, double kept, double lost_slack, double kept_slack,
                      struct rl_error *error)
{
    if (!(lost + kept > lost_slack + kept_slack))
        return RL_OK;
    double most = lost + lost_slack, least = fmax(lost - lost_slack, 0.0),
           rest = fmax(kept - kept_slack, 0.0);
    return add(r, "missed_exact", lost / (lost + kept), least / (least + kept + kept_slack),
               most / (most + rest), error);
}

/* The integral over the pixels that were skipped. */
static int add_exact(struct rl_record *r, const struct rl_image *drawn, const struct rl_margin_truth *truth,
                     struct rl_error *error)
{
    struct rl_sum lost = {0}, all = {0};
    size_t n = (size_t)drawn->width * (size_t)drawn->height, shiny = 0, skipped = 0, compared = 0, known = 0;
    double worst = 0.0;
    for (size_t i = 0; i < n; i++) {
        const float *h = truth->highlight.data + 4 * i;
        bool out = truth->drawn.data[i] > 0.5f && drawn->data[i] < 0.5f;
        shiny += truth->drawn.data[i] > 0.5f;
        skipped += out;
        known += h[3] > 0.5f;
        compared += out && h[3] > 0.5f;
        for (int c = 0; c < COLOURS; c++) {
            rl_sum_add(&all, (double)h[c]);
            rl_sum_add(&lost, out ? (double)h[c] : 0.0);
            worst = fmax(worst, out ? (double)h[c] / truth->radiance : 0.0);
        }
    }
    double share = shiny ? (double)skipped / (double)shiny : 0.0, total = rl_sum_value(&all);
    double slack = COLOURS * truth->tolerance;
    double loss = compared ? rl_sum_value(&lost) / (COLOURS * (double)compared) / truth->radiance : 0.0;
    double t = skipped ? truth->tolerance : 0.0;
    int status = add(r, "skipped", share, share, share, error);
    if (status == RL_OK)
        status = add_missed(r, rl_sum_value(&lost), total - rl_sum_value(&lost), slack * (double)compared,
                            slack * (double)(known - compared), error);
    if (status == RL_OK)
        status = add(r, "worst_exact", worst, fmax(0.0, worst - t), worst + t, error);
    return status == RL_OK ? add(r, "loss_exact", loss, fmax(0.0, loss - t), loss + t, error) : status;
}

int rl_margin_add_loss(struct rl_record *r, struct rl_bench *bench, struct rl_bench_scene *set,
                       const struct rl_margin_truth *truth, struct rl_error *error)
{
    struct rl_seeds on = {0};
    struct rl_image drawn = {0};
    int status = rl_seeds_draw(&on, bench, set, (double)truth->off.n, error);
    if (status == RL_OK)
        status = rl_gpu_scene_read_drawn(set->gpu_scene, &drawn, error);
    if (status == RL_OK)
        status = add_frames(r, &on, truth, error);
    if (status == RL_OK)
        status = add_exact(r, &drawn, truth, error);
    rl_seeds_clear(&on);
    rl_image_clear(&drawn);
    return status;
}
