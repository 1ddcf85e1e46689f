/* The check's cases that are pictures, against the reference at the same size. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "measure/metrics.h"
#include "measure/sum.h"
#include "reference/renderer.h"
#include "studies/check_parts.h"

/* What a case keeps from one measurement to the next. */
struct picture {
    const struct rl_check_truth *truth;
    struct rl_bench_scene *set;
};

void rl_check_release_picture(void *kept)
{
    struct picture *p = kept;
    rl_bench_scene_free(p->set);
    free(p);
}

/* What the picture is to be like: the integral, its tangent frame orthonormal; for methods that are functions in double precision on the
 * CPU (plain), that function. */
static int make_truth(struct rl_check_truth *t, const struct rl_settings *settings,
                      struct rl_check_context *context, struct rl_error *error)
{
    struct rl_plan plan;
    int status = rl_plan_make(&plan, context->scene, settings, error);
    if (status != RL_OK)
        return status;
    status = rl_reference_render(&t->image, &t->stats, context->scene, &plan, context->bench->threads,
                                 &context->bench->quiet, error);
    rl_plan_clear(&plan);
    if (status == RL_OK && t->stats.unconverged > 0)
        status = rl_fail(error, RL_ERR_CHECK, "%zu pixels of the reference stayed above the tolerance",
                         t->stats.unconverged);
    return status;
}

/* Cases of one scene and R_r have one truth, since all are of one size. */
static int find_truth(const struct rl_check_truth **found, const struct rl_check_case *c,
                      struct rl_check_context *context, struct rl_error *error)
{
    struct rl_settings settings = RL_SETTINGS_DEFAULT, asked;
    int status = rl_bench_settings(&asked, c->parameters, error);
    if (status != RL_OK)
        return status;
    const struct rl_method *method = rl_method_find(asked.method);
    settings.method = method && method->shade ? method->name : "reference";
    settings.rr = asked.rr;
    settings.width = asked.width;
    settings.height = asked.height;
    struct rl_check_truths *truths = context->truths;
    for (size_t i = 0; i < truths->n; i++) {
        *found = &truths->truth[i];
        if ((*found)->scene == context->scene && (*found)->rr == settings.rr &&
            (*found)->method == settings.method)
            return RL_OK;
    }
    if (truths->n == RL_CHECK_TRUTHS_MAX)
        return rl_fail(error, RL_ERR_SYSTEM, "the check has more than %d references", RL_CHECK_TRUTHS_MAX);
    struct rl_check_truth *t = &truths->truth[truths->n];
    *t = (struct rl_check_truth){.scene = context->scene, .rr = settings.rr, .method = settings.method};
    status = make_truth(t, &settings, context, error);
    if (status != RL_OK) {
        rl_image_clear(&t->image);
        return status;
    }
    truths->n++;
    *found = t;
    return RL_OK;
}

/* The case's picture, made when it is first needed. */
static int find_picture(struct picture **found, const struct rl_check_case *c,
                        struct rl_check_context *context, struct rl_error *error)
{
    *found = *context->kept;
    if (*found)
        return RL_OK;
    struct picture *p = calloc(1, sizeof *p);
    if (!p)
        return rl_fail_memory(error, "a picture");
    int status = find_truth(&p->truth, c, context, error);
    if (status == RL_OK)
        status = rl_bench_scene_make(&p->set, context->bench, context->scene, c->parameters, 1, error);
    if (status != RL_OK) {
        rl_check_release_picture(p);
        return status;
    }
    *found = *context->kept = p;
    return RL_OK;
}

static int draw(struct rl_image *image, const struct picture *p, struct rl_error *error)
{
    double seconds;
    int status = rl_gpu_scene_frame(p->set->gpu_scene, &seconds, error);
    return status == RL_OK ? rl_gpu_scene_read(p->set->gpu_scene, image, error) : status;
}

/* ---- Random methods ---------------------------------------------------------------------------------------------- */

enum figure { RMSE, BIAS, NOISE, FLOOR2, ALIKE, FIGURES };

/* How much alike the noise of neighbouring pixels is: the correlation of a - b with itself one pixel to the right. 0 if each pixel has
 * normals of its own. */
static double likeness(const struct rl_image *a, const struct rl_image *b)
{
    double product = 0.0, square = 0.0;
    size_t n = (size_t)a->width * (size_t)a->height;
    for (size_t i = 0; i + 1 < n; i++)
        for (size_t c = 0; c < 3; c++) {
            double here = (double)a->data[4 * i + c] - b->data[4 * i + c];
            double right = (double)a->data[4 * i + 4 + c] - b->data[4 * i + 4 + c];
            product += here * right;
            square += here * here;
        }
    return product / square;
}

/* Of two seeds a and b against r: the mean of (a - b)^2/2 is the variance, that of (a - r)(b - r) the squared floor, without bias even from
 * two; so each pair gives one independent value of each. Where values are not finite all are NaN. */
static int measure_pair(double figure[FIGURES], struct rl_image image[2], const struct picture *p,
                        struct rl_error *error)
{
    struct rl_bias_variance split;
    struct rl_metrics metrics[2];
    const struct rl_image *const images[] = {&image[0], &image[1]};
    for (int k = 0; k < 2; k++) {
        int status = rl_metrics_compute(&metrics[k], &image[k], &p->truth->image, error);
        if (status != RL_OK)
            return status;
    }
    for (int i = 0; i < FIGURES; i++)
        figure[i] = NAN;
    if (metrics[0].nonfinite + metrics[1].nonfinite > 0)
        return RL_OK;
    int status = rl_bias_variance_compute(&split, images, 2, &p->truth->image, error);
    if (status != RL_OK)
        return status;
    figure[RMSE] = 0.5 * (metrics[0].rmse + metrics[1].rmse);
    figure[BIAS] = 0.5 * (metrics[0].bias + metrics[1].bias);
    figure[NOISE] = sqrt(split.variance);
    figure[FLOOR2] = split.bias2;
    figure[ALIKE] = likeness(&image[0], &image[1]);
    return RL_OK;
}

static int draw_pair(double figure[FIGURES], const struct picture *p, uint64_t seed, struct rl_error *error)
{
    struct rl_image image[2] = {{0}, {0}};
    int status = RL_OK;
    for (uint64_t k = 0; k < 2 && status == RL_OK; k++) {
        status = rl_gpu_scene_reseed(p->set->gpu_scene, seed + k, error);
        if (status == RL_OK)
            status = draw(&image[k], p, error);
    }
    if (status == RL_OK)
        status = measure_pair(figure, image, p, error);
    rl_image_clear(&image[0]);
    rl_image_clear(&image[1]);
    return status;
}

int rl_check_random_picture(struct rl_check_rows *rows, const struct rl_check_case *c,
                            struct rl_check_context *context)
{
    double value[FIGURES][RL_CHECK_SEEDS_MAX / 2];
    struct picture *p;
    int status = find_picture(&p, c, context, rows->error);
    size_t n = context->options->seeds / 2;
    for (size_t k = 0; k < n && status == RL_OK; k++) {
        double figure[FIGURES] = {0.0};
        if (rl_progress_cancelled(&context->bench->quiet))
            return rl_fail(rows->error, RL_ERR_CANCELLED, "interrupted");
        status = draw_pair(figure, p, context->first_seed + 2 * k, rows->error);
        for (int i = 0; i < FIGURES; i++)
            value[i][k] = figure[i];
    }
    if (status != RL_OK)
        return status;
    /* All of them are parts of the error, so what matters is a share of it. */
    double rmse = rl_mean_of(value[RMSE], n).value;
    rl_check_random(rows, "rmse", RL_BEST_LOWER, value[RMSE], n, 0.1 * rmse);
    rl_check_random(rows, "bias", RL_BEST_ZERO, value[BIAS], n, 0.05 * rmse);
    rl_check_random(rows, "noise", RL_BEST_LOWER, value[NOISE], n, 0.1 * rmse);
    rl_check_random(rows, "floor2", RL_BEST_LOWER, value[FLOOR2], n, 0.2 * rmse * rmse);
    rl_check_random(rows, "noise_alike", RL_BEST_ZERO, value[ALIKE], n, 0.25);
    return RL_OK;
}

/* ---- Fixed methods ----------------------------------------------------------------------------------------------- */

enum fixed_figure { FIXED_RMSE, FIXED_BIAS, FIXED_MEAN, FIXED_DRAWN, FIXED_FIGURES };

/* The mean of all colour values, background included. */
static double mean_of(const struct rl_image *image)
{
    struct rl_sum sum = {0};
    size_t n = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < n; i++)
        for (int c = 0; c < 3; c++)
            rl_sum_add(&sum, image->data[4 * i + (size_t)c]);
    return rl_sum_value(&sum) / (3.0 * (double)n);
}

static int measure_fixed(double figure[FIXED_FIGURES], const struct picture *p, struct rl_error *error)
{
    struct rl_image image = {0}, drawn = {0};
    struct rl_metrics metrics = {0};
    int status = draw(&image, p, error);
    if (status == RL_OK)
        status = rl_metrics_compute(&metrics, &image, &p->truth->image, error);
    if (status == RL_OK)
        status = rl_gpu_scene_read_drawn(p->set->gpu_scene, &drawn, error);
    if (status == RL_OK) {
        size_t n = (size_t)drawn.width * (size_t)drawn.height, count = 0;
        for (size_t i = 0; i < n; i++)
            count += drawn.data[i] > 0.5f;
        figure[FIXED_RMSE] = metrics.rmse;
        figure[FIXED_BIAS] = metrics.bias;
        figure[FIXED_MEAN] = mean_of(&image);
        figure[FIXED_DRAWN] = (double)count / (double)n;
    }
    rl_image_clear(&image);
    rl_image_clear(&drawn);
    return status;
}

/* Mesa's reciprocals are good to 2^-12 on some CPUs, and an error of the position or the direction to the eye of that size is a move of the
 * eye by as much of its distance. All pixels together move the same way then, which rounding would not do: the figures cannot change by more
 * than the largest change of six such moves. */
static int find_tolerances(double tolerance[FIXED_FIGURES], const double figure[FIXED_FIGURES],
                           const struct picture *p, const struct rl_scene *scene, struct rl_error *error)
{
    rl_vec3 *eye = &p->set->scene.camera.position, here = *eye;
    double step = ldexp(v3_length(v3_sub(here, scene->object[0].centre)), -12);
    int status = RL_OK;
    for (int move = 0; move < 6 && status == RL_OK; move++) {
        const rl_vec3 axis[] = {scene->camera.right, scene->camera.up, scene->camera.forward};
        double moved[FIXED_FIGURES];
        *eye = v3_madd(here, move % 2 ? step : -step, axis[move / 2]);
        status = measure_fixed(moved, p, error);
        for (int i = 0; i < FIXED_FIGURES && status == RL_OK; i++)
            tolerance[i] = fmax(tolerance[i], fabs(moved[i] - figure[i]));
    }
    *eye = here;
    return status;
}

int rl_check_fixed_picture(struct rl_check_rows *rows, const struct rl_check_case *c,
                           struct rl_check_context *context)
{
    static const char *const from = "the largest change when the eye moves by 2^-12 of its distance";
    struct picture *p;
    double figure[FIXED_FIGURES], tolerance[FIXED_FIGURES] = {0.0};
    int status = find_picture(&p, c, context, rows->error);
    if (status == RL_OK)
        status = measure_fixed(figure, p, rows->error);
    if (status == RL_OK && context->options->tolerances)
        status = find_tolerances(tolerance, figure, p, context->scene, rows->error);
    if (status != RL_OK)
        return status;
    rl_check_fixed(rows, "rmse", RL_BEST_LOWER, figure[FIXED_RMSE], tolerance[FIXED_RMSE], from, true);
    rl_check_fixed(rows, "bias", RL_BEST_ZERO, figure[FIXED_BIAS], tolerance[FIXED_BIAS], from, true);
    rl_check_fixed(rows, "mean", RL_BEST_SAME, figure[FIXED_MEAN], tolerance[FIXED_MEAN], from, true);
    if (!rl_parameters_match(c->parameters, "method=plain"))
        rl_check_fixed(rows, "drawn", RL_BEST_SAME, figure[FIXED_DRAWN], tolerance[FIXED_DRAWN], from, true);
    return RL_OK;
}

/* ---- The reference ----------------------------------------------------------------------------------------------- */

int rl_check_reference(struct rl_check_rows *rows, const struct rl_check_case *c,
                       struct rl_check_context *context)
{
    const struct rl_check_truth *truth;
    int status = find_truth(&truth, c, context, rows->error);
    if (status != RL_OK)
        return status;
    double mean = mean_of(&truth->image);
    rl_check_fixed(rows, "mean", RL_BEST_SAME, mean, 2.0 * truth->stats.mean_error + 2.0 * FLT_EPSILON * mean,
                   "twice the mean stated error, and rounding to float", false);
    return RL_OK;
}
