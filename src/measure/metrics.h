/* Error metrics of an image v against a reference r over the foreground, e = v - r, colour channels alike:
 *
 *     MAE = mean |e|    RMSE = sqrt(mean e^2)    bias = mean e    max = max |e|
 *     relMSE = mean(e^2 / (|r| + 0.01)^2)        PSNR = 20 log10(max(1, max r)/RMSE) dB
 *
 * Equal images have an infinite PSNR.
 *
 * The foreground is where the reference's alpha (A channel) is at least 1/2 and the image's too; a reference
 * without alpha is foreground everywhere. Pixels that only one of the two covers (silhouettes, where a
 * rasteriser and a ray tracer may decide otherwise) are counted as `mismatched` and left out. Non-finite
 * values are counted first: with any, the other figures are NaN and the comparison has failed.
 */
#ifndef RL_MEASURE_METRICS_H
#define RL_MEASURE_METRICS_H

#include <stddef.h>

#include "base/error.h"
#include "image/image.h"

struct rl_metrics {
    double rmse, mae, max, bias, relmse, psnr;
    size_t nonfinite;  /* values, in either image, over all pixels */
    size_t pixels;     /* foreground pixels compared */
    size_t mismatched; /* pixels covered in one image only */
};

/* RL_ERR_INPUT: sizes or colour channels differ, or there is no foreground. Non-finite values are not an
 * error here. */
int rl_metrics_compute(struct rl_metrics *metrics, const struct rl_image *image,
                       const struct rl_image *reference, struct rl_error *error);

/* Mean squared error of repeated seeds, split into what repetition averages out and what it does not. With K
 * images v_k of independent seeds against one reference: variance = mean over pixels of the unbiased sample
 * variance across k; bias^2 = mean over pixels of (mean_k v - r)^2 minus variance/K (unbiased, may come out
 * slightly negative); mse = bias^2 + variance, which is the mean over seeds of each one's own. The first two
 * have a 95 % interval by the jackknife over seeds: it says how far other seeds would move the figure for this
 * picture, however uneven the picture is and however its pixels depend on each other. Two seeds give infinite ones. Where values
 * differ in one seed and are the same in all others, the jackknife sees nothing: bias^2 has its interval widened by 3/K of
 * what these values add to the mean square, since what one draw in K shows may be up to 3/K likely. Where no seed differs anywhere
 * there is nothing to widen it by.
 *
 * The foreground is where the reference and all the images are covered. RL_ERR_INPUT: fewer than 2 images,
 * sizes or channels that differ, no foreground. RL_ERR_CHECK: values that are not finite. */
struct rl_bias_variance {
    double bias2, bias2_low, bias2_high;
    double variance, variance_low, variance_high;
    double mse;
};
int rl_bias_variance_compute(struct rl_bias_variance *split, const struct rl_image *const images[],
                             size_t n_images, const struct rl_image *reference, struct rl_error *error);

/* The error as a picture: signed mean e of the colour channels, per pixel, as a 1-channel image; 0 outside of
 * the foreground. Errors that are not finite are kept. `out` must be empty (zero or cleared) and stays so on
 * an error. */
int rl_error_image(struct rl_image *out, const struct rl_image *image, const struct rl_image *reference,
                   struct rl_error *error);

#endif
