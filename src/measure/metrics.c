/* Error metrics of images, and their split into bias and variance (see metrics.h). */
#include "measure/metrics.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "measure/statistics.h"
#include "measure/sum.h"

#define LEVEL 0.95
#define RELATIVE_OFFSET                                                                                      \
    0.01 /* on |reference|: keeps relMSE finite where that is black, or slightly negative as in HDR photographs */
#define RULE_OF_THREE 3.0 /* an event that K draws do not show has, at 95 %, a probability of at most 3/K */
#define SAME 1e-6 /* share of the squares that rounding of floats may leave where values are the same */

/* Where an image keeps what is compared. */
struct layout {
    int colours;   /* 3: R, G, B; 1: Y; 0: neither */
    int colour[3]; /* channels */
    int alpha;     /* channel, or -1 */
};

static struct layout find_layout(const struct rl_image *image)
{
    struct layout l = {
        .colours = 3,
        .colour = {rl_image_channel(image, "R"), rl_image_channel(image, "G"), rl_image_channel(image, "B")},
        .alpha = rl_image_channel(image, "A"),
    };
    if (l.colour[0] >= 0 && l.colour[1] >= 0 && l.colour[2] >= 0)
        return l;
    l.colour[0] = rl_image_channel(image, "Y");
    l.colours = l.colour[0] >= 0 ? 1 : 0;
    return l;
}

static const char *describe(const struct layout *l)
{
    return l->colours == 3 ? "R, G, B" : l->colours == 1 ? "Y" : "no colour";
}

static int check_pair(const struct rl_image *image, const struct rl_image *reference, struct rl_error *error)
{
    if (!image->data || !reference->data)
        return rl_fail(error, RL_ERR_INPUT, "an empty image cannot be compared");
    if (image->width != reference->width || image->height != reference->height)
        return rl_fail(error, RL_ERR_INPUT,
                       "sizes differ: the image has %d x %d pixels, the reference %d x %d", image->width,
                       image->height, reference->width, reference->height);
    struct layout a = find_layout(image);
    struct layout b = find_layout(reference);
    if (a.colours != b.colours || a.colours == 0)
        return rl_fail(error, RL_ERR_INPUT,
                       "channels differ: the image has %s, the reference %s; R, G, B or Y in both expected",
                       describe(&a), describe(&b));
    return RL_OK;
}

static size_t pixel_count(const struct rl_image *image)
{
    return (size_t)image->width * (size_t)image->height;
}

static const float *pixel_at(const struct rl_image *image, size_t i)
{
    return image->data + i * (size_t)image->channels;
}

static bool covered(const struct layout *l, const float *pixel)
{
    return l->alpha < 0 || pixel[l->alpha] >= 0.5F;
}

static size_t count_nonfinite(const struct rl_image *image)
{
    size_t values = pixel_count(image) * (size_t)image->channels;
    size_t count = 0;
    for (size_t i = 0; i < values; i++)
        count += !isfinite(image->data[i]);
    return count;
}

struct error_sums {
    struct rl_sum error, absolute, squared, relative;
    double max_error, max_reference;
};

static void add_pixel(struct error_sums *sums, const struct layout *image_layout, const float *image,
                      const struct layout *reference_layout, const float *reference)
{
    for (int c = 0; c < image_layout->colours; c++) {
        double r = reference[reference_layout->colour[c]];
        double e = image[image_layout->colour[c]] - r;
        double relative = e / (fabs(r) + RELATIVE_OFFSET);
        rl_sum_add(&sums->error, e);
        rl_sum_add(&sums->absolute, fabs(e));
        rl_sum_add(&sums->squared, e * e);
        rl_sum_add(&sums->relative, relative * relative);
        sums->max_error = fmax(sums->max_error, fabs(e));
        sums->max_reference = fmax(sums->max_reference, r);
    }
}

static int fail_no_foreground(const struct rl_metrics *m, struct rl_error *error)
{
    return rl_fail(error, RL_ERR_INPUT,
                   "nothing to compare: no pixel with alpha >= 1/2 in both images (%zu have it in one only)",
                   m->mismatched);
}

static void finish_metrics(struct rl_metrics *m, const struct error_sums *sums, int colours)
{
    double n = (double)m->pixels * colours;
    if (m->nonfinite > 0) {
        m->rmse = m->mae = m->max = m->bias = m->relmse = m->psnr = NAN;
        return;
    }
    m->rmse = sqrt(rl_sum_value(&sums->squared) / n);
    m->mae = rl_sum_value(&sums->absolute) / n;
    m->max = sums->max_error;
    m->bias = rl_sum_value(&sums->error) / n;
    m->relmse = rl_sum_value(&sums->relative) / n;
    m->psnr = m->rmse > 0.0 ? 20.0 * log10(fmax(1.0, sums->max_reference) / m->rmse) : INFINITY;
}

/* Where image and reference keep what is compared. Without alpha in the reference the image's counts for
 * nothing. */
static void find_layouts(struct layout *image_layout, struct layout *reference_layout,
                         const struct rl_image *image, const struct rl_image *reference)
{
    *image_layout = find_layout(image);
    *reference_layout = find_layout(reference);
    if (reference_layout->alpha < 0)
        image_layout->alpha = -1;
}

int rl_metrics_compute(struct rl_metrics *metrics, const struct rl_image *image,
                       const struct rl_image *reference, struct rl_error *error)
{
    int status = check_pair(image, reference, error);
    if (status != RL_OK)
        return status;
    struct layout image_layout;
    struct layout reference_layout;
    find_layouts(&image_layout, &reference_layout, image, reference);
    struct error_sums sums = {.max_reference = -INFINITY};
    struct rl_metrics m = {.nonfinite = count_nonfinite(image) + count_nonfinite(reference)};
    size_t n = pixel_count(reference);
    for (size_t i = 0; i < n; i++) {
        const float *v = pixel_at(image, i);
        const float *r = pixel_at(reference, i);
        bool in_reference = covered(&reference_layout, r);
        bool in_image = image_layout.alpha < 0 ? in_reference : covered(&image_layout, v);
        m.mismatched += in_reference != in_image;
        if (in_reference && in_image) {
            m.pixels++;
            add_pixel(&sums, &image_layout, v, &reference_layout, r);
        }
    }
    if (m.pixels == 0)
        return fail_no_foreground(&m, error);
    finish_metrics(&m, &sums, reference_layout.colours);
    *metrics = m;
    return RL_OK;
}

int rl_error_image(struct rl_image *out, const struct rl_image *image, const struct rl_image *reference,
                   struct rl_error *error)
{
    int status = check_pair(image, reference, error);
    if (status != RL_OK)
        return status;
    status = rl_image_allocate(out, reference->width, reference->height, 1, error);
    if (status != RL_OK)
        return status;
    struct layout image_layout;
    struct layout reference_layout;
    find_layouts(&image_layout, &reference_layout, image, reference);
    size_t n = pixel_count(reference);
    for (size_t i = 0; i < n; i++) {
        const float *v = pixel_at(image, i);
        const float *r = pixel_at(reference, i);
        if (!covered(&reference_layout, r) || !covered(&image_layout, v))
            continue;
        double sum = 0.0;
        for (int c = 0; c < image_layout.colours; c++)
            sum += (double)v[image_layout.colour[c]] - r[reference_layout.colour[c]];
        out->data[i] = (float)(sum / image_layout.colours);
    }
    return RL_OK;
}

/* ---- Bias and variance ---- */

/* Sums over the foreground's values, a value being one colour channel of one pixel: of the two estimates, and of what they
 * would be without seed j; and of what the jackknife cannot see of the squared bias (rl_bias_variance). */
struct estimate {
    struct rl_sum bias2, variance, unseen;
};

/* The images' layouts beside the images themselves. */
struct seeds {
    const struct rl_image *const *image;
    struct layout *layout;
    size_t n;
    const struct rl_image *reference;
    struct layout reference_layout;
};

/* (mean - r)^2 and the variance are biased and unbiased; taking variance/n off makes both unbiased. */
static void add_value(struct estimate *e, double deviation, double squares, double n)
{
    double variance = squares / (n - 1.0);
    rl_sum_add(&e->variance, variance);
    rl_sum_add(&e->bias2, deviation * deviation - variance / n);
}

/* All seeds but one have the same value, and that one is off by D. Other seeds would be off too, with a probability p of which
 * one event in K says little: the expected value is wrong by p D, (p D)^2 of bias^2, whose unbiased estimate from one event is zero,
 * as is each without one of the seeds. With p <= 3/K, and D^2/K for the mean of the squares p D^2: 3/K x D^2/K. Summed
 * over pixels the latter is unbiased however rare the events are. Of the seed's own deviation d and the squares: D = d K/(K - 1). */
static void add_unseen(struct estimate *e, double d, double squares, double K)
{
    double D = d * K / (K - 1.0);
    if (squares > 0.0 && squares - d * d * K / (K - 1.0) <= SAME * squares)
        rl_sum_add(&e->unseen, RULE_OF_THREE * D * D / (K * K));
}

/* One pixel. Without v_j the mean is mean - d_j/(K - 1), d_j = v_j - mean, and the squared deviations lose d_j^2 K/(K - 1). */
static void add_seeds(struct estimate *all, struct estimate *without, const struct seeds *s, size_t pixel)
{
    double K = (double)s->n;
    const float *reference = pixel_at(s->reference, pixel);
    for (int c = 0; c < s->reference_layout.colours; c++) {
        double r = reference[s->reference_layout.colour[c]];
        double mean = 0.0;
        double squares = 0.0;
        for (size_t k = 0; k < s->n; k++)
            mean += pixel_at(s->image[k], pixel)[s->layout[k].colour[c]] / K;
        for (size_t k = 0; k < s->n; k++) {
            double d = pixel_at(s->image[k], pixel)[s->layout[k].colour[c]] - mean;
            squares += d * d;
        }
        add_value(all, mean - r, squares, K);
        for (size_t k = 0; k < s->n && s->n > 2; k++) {
            double d = pixel_at(s->image[k], pixel)[s->layout[k].colour[c]] - mean;
            add_value(&without[k], mean - d / (K - 1.0) - r, squares - d * d * K / (K - 1.0), K - 1.0);
            add_unseen(all, d, squares, K);
        }
    }
}

static bool covered_by_all(const struct seeds *s, size_t pixel)
{
    bool all = covered(&s->reference_layout, pixel_at(s->reference, pixel));
    for (size_t k = 0; k < s->n && all; k++)
        all = covered(&s->layout[k], pixel_at(s->image[k], pixel));
    return all;
}

/* Half the interval's width, by the jackknife over seeds (Tukey 1958): the seeds are what is drawn at random, the picture is
 * not. Slightly too wide where the estimate is far from linear in the seeds (Efron and Stein 1981). Two seeds tell nothing. */
static double jackknife(const double *without, size_t n)
{
    double mean = 0.0;
    double squares = 0.0;
    if (n < 3)
        return INFINITY;
    for (size_t k = 0; k < n; k++)
        mean += without[k] / (double)n;
    for (size_t k = 0; k < n; k++)
        squares += (without[k] - mean) * (without[k] - mean);
    return rl_student_factor(LEVEL, (double)n - 1.0) * sqrt((double)(n - 1) / (double)n * squares);
}

static int check_seeds(const struct seeds *s, struct rl_error *error)
{
    size_t nonfinite = count_nonfinite(s->reference);
    for (size_t k = 0; k < s->n; k++) {
        int status = check_pair(s->image[k], s->reference, error);
        if (status != RL_OK)
            return status;
        nonfinite += count_nonfinite(s->image[k]);
    }
    if (nonfinite > 0)
        return rl_fail(error, RL_ERR_CHECK, "%zu values of the images are NaN or infinite", nonfinite);
    return RL_OK;
}

static int split(struct rl_bias_variance *out, const struct seeds *s, struct estimate *without,
                 double *values, struct rl_error *error)
{
    struct estimate all = {0};
    double n = 0.0;
    for (size_t i = 0; i < pixel_count(s->reference); i++) {
        if (!covered_by_all(s, i))
            continue;
        add_seeds(&all, without, s, i);
        n += s->reference_layout.colours;
    }
    if (n == 0.0)
        return rl_fail(error, RL_ERR_INPUT, "nothing to compare: no pixel with alpha >= 1/2 in all images");
    for (size_t k = 0; k < s->n; k++)
        values[k] = rl_sum_value(&without[k].bias2) / n;
    double bias2_half = jackknife(values, s->n) + rl_sum_value(&all.unseen) / n;
    for (size_t k = 0; k < s->n; k++)
        values[k] = rl_sum_value(&without[k].variance) / n;
    double variance_half = jackknife(values, s->n);
    double bias2 = rl_sum_value(&all.bias2) / n;
    double variance = rl_sum_value(&all.variance) / n;
    *out = (struct rl_bias_variance){
        .bias2 = bias2,
        .bias2_low = bias2 - bias2_half,
        .bias2_high = bias2 + bias2_half,
        .variance = variance,
        .variance_low = variance - variance_half,
        .variance_high = variance + variance_half,
        .mse = bias2 + variance, /* an identity: mean_k (v_k - r)^2 = (mean - r)^2 + (1 - 1/K) variance */
    };
    return RL_OK;
}

int rl_bias_variance_compute(struct rl_bias_variance *out, const struct rl_image *const images[],
                             size_t n_images, const struct rl_image *reference, struct rl_error *error)
{
    if (n_images < 2)
        return rl_fail(error, RL_ERR_INPUT,
                       "%zu image(s), at least 2 seeds expected to tell bias from variance", n_images);
    struct seeds s = {.image = images, .n = n_images, .reference = reference};
    int status = check_seeds(&s, error);
    if (status != RL_OK)
        return status;
    s.layout = calloc(n_images, sizeof *s.layout);
    struct estimate *without = calloc(n_images, sizeof *without);
    double *values = calloc(n_images, sizeof *values);
    if (s.layout && without && values) {
        for (size_t k = 0; k < n_images; k++)
            find_layouts(&s.layout[k], &s.reference_layout, s.image[k], s.reference);
        status = split(out, &s, without, values, error);
    } else {
        status = rl_fail_memory(error, "the split of the error");
    }
    free(values);
    free(without);
    free(s.layout);
    return status;
}
